#ifndef auxfem_tests_verification_random_structure_h
#define auxfem_tests_verification_random_structure_h

#include <deal.II/base/point.h>

#include <support/scene_text.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * Writes the parts of a scene that all analyses share: a frame of 2 to 7
     * struts in the plane or in space, their section, joints, rigid parts,
     * connectors and masses. Generators of scenes derive from it and call the
     * functions in their order, which decides what a seed gives. Equal seeds
     * give equal scenes on all platforms.
     */
    class RandomStructure
    {
    protected:
      using Point  = dealii::Point<3>;
      using Vector = dealii::Tensor<1, 3>;

      /** Draws the dimension. */
      explicit RandomStructure(unsigned int seed);

      /** A number in [low, high); the standard's distributions differ among
       * libraries. */
      double number(double low, double high);

      bool chance(double probability);

      template <class Value>
      Value one_of(const std::vector<Value> &values)
      {
        return values[static_cast<std::size_t>(number(0, values.size()))];
      }

      /** The number of one of the joints. */
      std::string any_joint();

      /** As a parameter has them: two or three numbers. */
      std::string coordinates(const Vector &point) const;

      /** Adds to the features. */
      void note(const std::string &feature);

      /** A chain of joints that climbs, so that no struts cross, with
       * braces. */
      void add_frame();

      /** A rectangle or a circle for all struts, with or without damping. */
      void add_section();

      /** A hinge, a rotational spring or, in space, a revolute joint. */
      void add_joint();

      /** One strut becomes rigid, if there are two.
       * @param is_held elastic struts are always clamped to it */
      void add_rigid_part(bool is_held);

      /**
       * A connector between next but one joints, if there are three.
       * @param laws one is drawn
       * @param relaxation_time of its damper and spring, times 0.1 to 3 (s)
       */
      void add_connector(const std::vector<std::string> &laws,
                         double                          relaxation_time);

      /**
       * A connector from the first to the last joint, if there are three, by a
       * law that is not linear; after all else.
       * @param rubs whether it may rub or break
       */
      void add_nonlinear_connector(bool rubs);

      /** On the last joint. */
      void add_mass();

      SceneText   scene_text;
      std::string features; ///< for messages

      unsigned int                             dimension;
      const double                             length = 0.1; ///< of struts (m)
      std::vector<Point>                       points;       ///< joints (m)
      std::vector<std::array<unsigned int, 2>> ends;
      double                                   thickness; ///< m
      double                                   area;      ///< m2
      double                                   density;   ///< kg/m3
      double                                   modulus;   ///< Young's (Pa)
      bool                                     has_damped_struts = false;
      double                                   bending; ///< stiffness EI (N m2)
      double period;      ///< first one of a clamped strut (s)
      double force_scale; ///< that bends a strut by about its length (N)
      bool   has_rigid_part = false, has_mass = false, has_releases = false;

    private:
      std::mt19937 generator;
    };

    /** Expects the message of an error to be an engineer's. */
    void expect_message(const std::string &message);
  } // namespace testing_support
} // namespace auxfem

#endif
