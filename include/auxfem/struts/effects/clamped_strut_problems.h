#ifndef auxfem_struts_effects_clamped_strut_problems_h
#define auxfem_struts_effects_clamped_strut_problems_h

#include <auxfem/algebra/strut_condensation.h>
#include <auxfem/equations/make_effects.h>
#include <auxfem/struts/effects/strut_motion.h>
#include <auxfem/struts/effects/struts.h>

namespace auxfem
{
  /**
   * Struts that a rank counts, each for itself with its ends held: they share
   * no joint, so each may be in a state of its own, of any instant. Its
   * inside is in equilibrium, or not, with its line loads and weight, and with
   * the inertia of accelerations that stay as they are. No communication.
   */
  class ClampedStrutProblems
  {
  public:
    /**
     * @param model must outlive the object. The elements of the model
     *   have at least two orders, so that all of a strut's are counted by one
     *   rank.
     * @param divisions of the struts here, by their numbers in the lattice
     * @param struts which, of those that owned_struts() of the model tells
     */
    ClampedStrutProblems(const LatticeModel        &model,
                         std::vector<StrutDivision> divisions,
                         std::vector<unsigned int>  struts);

    ClampedStrutProblems(const ClampedStrutProblems &)            = delete;
    ClampedStrutProblems &operator=(const ClampedStrutProblems &) = delete;

    /** The struts, by their numbers in the lattice. */
    const std::vector<unsigned int> &struts() const
    {
      return counted;
    }

    /** Brings a strut into @p motion, interpolated to its nodes. */
    void move(unsigned int strut, const StrutMotion &motion);

    /** What the nodes of a strut do. */
    StrutMotion motion(unsigned int strut) const;

    /**
     * Brings the inside of all struts into equilibrium. Returns whether there
     * is one: not where the inside of a strut is singular or a force not
     * finite.
     */
    bool settle();

    /**
     * How far a strut is from its equilibrium still: the work (J) of the last
     * correction, 0 if that was negligible.
     */
    double out_of_balance(unsigned int strut) const;

    /**
     * By how much the forces that hold the ends of a strut, which both have
     * settled, differ from those of @p other: the strain energy, times two, of a
     * strut that these differences alone load (J). So it is the square of their
     * norm by the flexibility of the strut.
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
    /** A step of Newton's method; the work (J) of what was out of balance, or
     * nothing if there is none. */
    std::optional<double> correct();
    /** Calls @p act(local unknown, component) for all of a strut but those of
     * its first end. */
    template <class Act>
    void   for_each_unknown(unsigned int strut, const Act &act) const;
    double work_on(unsigned int               strut,
                   const std::vector<double> &increment) const;
    /** Goes along an increment, in a strut whose residual does more work on it
     * there than at its start only a part of the way. */
    void advance(std::vector<double> &increment);
    /** Of every strut to what it may be corrected by at once. */
    void               shorten(std::vector<double> &increment) const;
    void               apply(const std::vector<double> &increment);
    EndForces          second_end(unsigned int strut) const;
    const StrutForces &forces_of(unsigned int element) const;

    unsigned int n_elements(const unsigned int strut) const
    {
      return numbering.divisions()[strut].n_elements;
    }

    const bool                      large_rotation;
    const std::vector<unsigned int> counted;
    /** Joints apart; struts of others are none of this mesh. */
    const Lattice                             lattice;
    const DofNumbering                        numbering;
    std::vector<std::unique_ptr<StrutForces>> forces;
    std::vector<std::unique_ptr<Effect>>      inertia, loads;
    std::vector<std::unique_ptr<EffectCache>> results; ///< of forces
    TangentPattern                            pattern;
    std::unique_ptr<TangentMatrix>            tangent;
    std::unique_ptr<StrutCondensation>        condensation;
    std::unique_ptr<State>                    state;
    std::vector<double>                       residual; ///< by local unknown
    /** By strut of the lattice: its first element, the instant it is at. */
    ///@{
    std::vector<unsigned int> first_element;
    std::vector<double>       instants;  ///< StrutMotion::time
    std::vector<double>       last_work; ///< of the last correction (J)
    ///@}
  };

  /** The struts that a rank counts, by their numbers in the lattice, in the
   * order of their elements. */
  std::vector<unsigned int> owned_struts(const DofNumbering &numbering);
} // namespace auxfem

#endif
