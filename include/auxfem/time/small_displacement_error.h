#ifndef auxfem_time_small_displacement_error_h
#define auxfem_time_small_displacement_error_h

#include <auxfem/equations/equations.h>
#include <auxfem/struts/effects/struts.h>

#include <array>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Growth of a motion or of its estimated error after which the error is
   * computed again.
   * @tuned judgement: a check costs a factorization
   */
  inline constexpr double growth_between_checks = 1.25;

  /**
   * Largest effects that small displacements neglect, relative to the
   * response, to first order (doc/theory/effects.md, Small displacements).
   */
  struct SmallDisplacementError
  {
    /**
     * Largest rotation of an end or chord of an element, a rigid part or a
     * connector (rad).
     */
    double rotation = 0;
    /**
     * Effect of axial forces on the stiffness: their work on rotated struts
     * over the bending energy. Beyond buckling, the compressive force of a
     * strut over its Euler load with hinged ends.
     */
    double second_order = 0;
    /** Axial strain of a strut. */
    double strain = 0;
    /**
     * Part with the largest effect, for instance `strut 3`; empty without
     * motion.
     */
    std::string location;
    /**
     * Largest compressive force of a strut over its Euler load with hinged
     * ends; not part of total().
     */
    double compression = 0;
    /** The same for each of SmallDisplacementEstimate::struts(). */
    std::vector<double> compressions;

    /**
     * Estimated error of displacements and forces. Half the rotation is the
     * difference between motion on a circle and on its tangent.
     */
    double total() const
    {
      return total(rotation, second_order, strain);
    }

    static double
    total(const double rotation, const double second_order, const double strain)
    {
      return rotation / 2 + second_order + strain;
    }
  };

  /**
   * Estimates the error of a state by small displacements (`Large rotation =
   * off`), whose geometry and equilibrium are those at rest. Uses ends of
   * elements, mean axial forces, rigid parts, and connectors along their line.
   */
  class SmallDisplacementEstimate
  {
  public:
    /** @param equations must outlive the object. */
    explicit SmallDisplacementEstimate(const Equations &equations);

    /**
     * Estimate for @p state, which has its energies. Equal on all ranks except
     * for SmallDisplacementError::compressions. Collective.
     */
    SmallDisplacementError at(const State &state) const;

    /** Forces of axial forces on rotated chords (N), by local unknown. */
    Vector forces_by_turning(const State &state) const;

    /** Struts counted by this rank, sorted. */
    const std::vector<unsigned int> &struts() const
    {
      return counted;
    }

  private:
    /** Motion of a line, to first order. */
    struct SmallMotion
    {
      double rotation, ///< rad, not negative
        strain;
    };
    /** A line between two nodes. */
    struct Line
    {
      SmallMotion motion(const Vector &displacement) const;
      /** Displacement of the second end against the first (m). */
      dealii::Tensor<1, 3>
      relative_displacement(const Vector &displacement) const;

      std::array<int, 6>   unknowns; ///< x, y, z of both; -1: none
      dealii::Tensor<1, 3> direction;
      double               length; ///< m
    };
    /** An element of a strut. */
    struct Chord
    {
      Line               line;
      const StrutForces *struts;  ///< nullptr: its axial strain is the chord's
      unsigned int       element; ///< of the numbering
      unsigned int       strut;
      std::size_t        index;           ///< of the strut in struts()
      double             buckling_force;  ///< pi^2 EI / L^2 (N)
      double             axial_stiffness; ///< EA (N)
      bool               is_counted;      ///< by this rank, once over all ranks
    };
    /** A connector along its line, counted by this rank. */
    struct Connector
    {
      Line         line;
      unsigned int group, joint;
    };
    /** The part with the largest error. */
    struct LargestError;

    /** Mean axial force of an element (N), positive in tension. */
    double axial_force(const Chord &chord, const State &state) const;
    void   add_chords(const StrutGroup &group);
    void   count_struts();
    void   add_connectors(unsigned int group);
    /** Larger one of the rotations at both ends of an element (rad). */
    double node_rotation(const Chord &chord, const Vector &displacement) const;
    /** Work of axial forces over the bending energy of all struts. */
    double      overall_second_order(double       own_work,
                                     double       own_axial_energy,
                                     const State &state) const;
    std::string location_of(const LargestError &largest) const;

    const Scene              &scene;
    const Equations          &equations;
    std::vector<Chord>        chords;
    std::vector<unsigned int> counted;
    std::vector<Connector>    connectors;
  };
} // namespace auxfem

#endif
