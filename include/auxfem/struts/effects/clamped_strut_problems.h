#ifndef auxfem_struts_effects_clamped_strut_problems_h
#define auxfem_struts_effects_clamped_strut_problems_h

#include <auxfem/algebra/strut_condensation.h>
#include <auxfem/equations/make_effects.h>
#include <auxfem/struts/effects/strut_motion.h>
#include <auxfem/struts/effects/struts.h>

namespace auxfem
{
  /**
   * Independent problems of single struts with clamped ends, each at its own
   * state and time. The interior is in equilibrium with line loads, weight and
   * the inertia of given accelerations. The choice of elements uses it to
   * compare meshes. No communication.
   */
  class ClampedStrutProblems
  {
  public:
    /**
     * @param model must outlive the object; its elements have order 2 or more,
     *   so that one rank owns all elements of a strut
     * @param divisions of the struts here, by lattice strut number
     * @param struts subset of owned_struts() of the model
     */
    ClampedStrutProblems(const LatticeModel        &model,
                         std::vector<StrutDivision> divisions,
                         std::vector<unsigned int>  struts);

    ClampedStrutProblems(const ClampedStrutProblems &)            = delete;
    ClampedStrutProblems &operator=(const ClampedStrutProblems &) = delete;

    /** Lattice numbers of the struts. */
    const std::vector<unsigned int> &struts() const
    {
      return strut_numbers;
    }

    /** Sets the motion of a strut, interpolated to its nodes. */
    void move(unsigned int strut, const StrutMotion &motion);

    /** Motion of the nodes of a strut. */
    StrutMotion motion(unsigned int strut) const;

    /** Solves for the equilibrium of all interiors. Returns false if a strut
     * tangent is singular or a force is not finite. */
    bool solve_equilibrium();

    /** Work of the last Newton correction of a strut (J), 0 if negligible: its
     * remaining distance from equilibrium. */
    double last_correction_work(unsigned int strut) const;

    /**
     * Squared norm of the difference of the end forces of a strut from those of
     * @p other, weighted by the strut flexibility (J). It is twice the strain
     * energy of a strut loaded by this difference. Both must be in equilibrium.
     */
    double difference(unsigned int                strut,
                      const ClampedStrutProblems &other) const;

    /** Strain energy (J) of all struts. */
    double strain_energy() const;

  private:
    /** Force (N) and moment (N m) on the second end of a strut. */
    struct EndForces
    {
      SpaceVector force, moment;
    };

    void find_residual();
    void add_loads();
    /** One Newton iteration. Returns the work of the residual (J), or nothing
     * if the tangent is singular. */
    std::optional<double> newton_iteration();
    /** Calls @p act(local unknown, component) for all unknowns of a strut
     * except those of its first end. */
    template <class Act>
    void   for_each_unknown(unsigned int strut, const Act &act) const;
    double work_on(unsigned int               strut,
                   const std::vector<double> &increment) const;
    /** Applies an increment with a line search: halves it in struts whose
     * residual does more work than at the start. */
    void apply_with_line_search(std::vector<double> &increment);
    /** Limits the increment of each strut. */
    void               limit_increment(std::vector<double> &increment) const;
    void               apply(const std::vector<double> &increment);
    EndForces          second_end_forces(unsigned int strut) const;
    const StrutForces &forces_of(unsigned int element) const;

    unsigned int n_elements(const unsigned int strut) const
    {
      return numbering.divisions()[strut].n_elements;
    }

    const bool                      large_rotation;
    const std::vector<unsigned int> strut_numbers;
    /** Lattice in which every strut has joints of its own; rigid parts hold the
     * other struts. */
    const Lattice                             lattice;
    const DofNumbering                        numbering;
    std::vector<std::unique_ptr<StrutForces>> forces;
    std::vector<std::unique_ptr<Effect>>      inertia, loads;
    std::vector<std::unique_ptr<EffectCache>> results; ///< one per group
    TangentPattern                            pattern;
    std::unique_ptr<TangentMatrix>            tangent;
    std::unique_ptr<StrutCondensation>        condensation;
    std::unique_ptr<State>                    state;
    std::vector<double>                       residual; ///< by local unknown
    /** @name Data by lattice strut: first element, time, last correction. */
    ///@{
    std::vector<unsigned int> first_element;
    std::vector<double>       instants;  ///< StrutMotion::time
    std::vector<double>       last_work; ///< work of the last correction (J)
    ///@}
  };

  /** Lattice numbers of the struts that this rank owns, in the order of their
   * elements. */
  std::vector<unsigned int> owned_struts(const DofNumbering &numbering);
} // namespace auxfem

#endif
