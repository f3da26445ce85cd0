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
   * What small displacements leave out, where it is most. Relative to what is
   * computed, to first order (doc/theory.md).
   */
  struct SmallDisplacementError
  {
    /** Of an end or chord of an element, a rigid part or a connector (rad). */
    double rotation = 0;
    /**
     * Effect of axial forces on the stiffness: the work of all of them on the
     * turned struts over the energy of bending, or the compressive force of a
     * strut over its buckling load with hinged ends, if it is beyond that.
     */
    double second_order = 0;
    /** Axial strain of a strut. */
    double strain = 0;
    /** `strut 3`, say; empty: nothing moves. */
    std::string location;
    /** No error of its own: largest compressive force of a strut over its
     * buckling load with hinged ends. */
    double compression = 0;
    /** The same of each of SmallDisplacementEstimate::struts(). */
    std::vector<double> compressions;

    /** Of displacements and forces; half the rotation is the part of a strut's
     * motion that turning on a circle and not on its tangent makes. */
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
   * Tells from a state what is wrong with it if small displacements have led
   * there (`Large rotation = off`), where geometry and equilibrium are those at
   * rest. By ends of elements, mean axial forces, rigid parts, and connectors
   * along their line.
   */
  class SmallDisplacementEstimate
  {
  public:
    /** @param equations must outlive the object. */
    explicit SmallDisplacementEstimate(const Equations &equations);

    /** Of @p state, which has its energies; the same on all ranks, but for
     * SmallDisplacementError::compressions. Collective. */
    SmallDisplacementError at(const State &state) const;

    /** Forces of axial forces on turned chords (N), by local unknown. */
    Vector forces_by_turning(const State &state) const;

    /** Those that this rank counts, sorted. */
    const std::vector<unsigned int> &struts() const
    {
      return counted;
    }

  private:
    /** Of a line, to first order. */
    struct SmallMotion
    {
      double rotation, ///< rad, no less than zero
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
      const StrutForces *struts;  ///< none: its axial strain is the chord's
      unsigned int       element; ///< of the numbering
      unsigned int       strut;
      std::size_t        index;           ///< of the strut in struts()
      double             buckling_force;  ///< pi^2 EI / L^2 (N)
      double             axial_stiffness; ///< EA (N)
      bool               is_counted;      ///< by this rank
    };
    /** A connector along its line, counted by this rank. */
    struct Connector
    {
      Line         line;
      unsigned int group, joint;
    };
    /** The part with the largest error. */
    struct Worst;

    /** Mean along an element (N), positive in tension. */
    double axial_force(const Chord &chord, const State &state) const;
    void   add_chords(const StrutGroup &group);
    void   count_struts();
    void   add_connectors(unsigned int group);
    /** The largest of both ends of an element (rad). */
    double node_rotation(const Chord &chord, const Vector &displacement) const;
    /** Work of axial forces over the energy of bending, in all struts. */
    double      overall_second_order(double       own_work,
                                     double       own_axial_energy,
                                     const State &state) const;
    std::string location_of(const Worst &worst) const;

    const Scene              &scene;
    const Equations          &equations;
    std::vector<Chord>        chords;
    std::vector<unsigned int> counted;
    std::vector<Connector>    connectors;
  };
} // namespace auxfem

#endif
