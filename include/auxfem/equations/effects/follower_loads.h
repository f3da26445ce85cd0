#ifndef auxfem_equations_effects_follower_loads_h
#define auxfem_equations_effects_follower_loads_h

#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/motion_components.h>

namespace auxfem
{
  /**
   * Forces and moments that turn with the rotation P of their joint: P f(t),
   * P m(t). They have no potential, and their tangent is not symmetric.
   */
  class FollowerLoads : public Effect
  {
  public:
    /** @param raised_from_zero as for AppliedLoads. */
    FollowerLoads(const Lattice      &lattice,
                  const DofNumbering &numbering,
                  bool                raised_from_zero);

    /**
     * Starts a new load: force and moment of @p components (N, N m), whose work
     * is kept under @p work. Returns its number.
     */
    unsigned int
    add_load(const std::array<TimeFunction, n_motion_components> &components,
             const EnergyEntry                                   &work);

    /** Lets load @p load act on a joint that has a rotation and is kept on this rank. */
    void add_joint(unsigned int load, unsigned int joint);

    /** Whether no load was added. */
    bool empty() const;

    bool is_linear() const override;
    void register_blocks(TangentPattern &pattern) override;
    void register_in(StateLayout &layout) override;
    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectResults    *results) const override;
    void add_tangent(const Evaluation     &evaluation,
                     const EffectResults  *results,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void add_load_derivative(const Evaluation &evaluation,
                             double           *derivative) const override;
    void account_step(const Evaluation    &step,
                      const EffectResults *results,
                      EnergyAccount       &account) const override;
    void account_stage(const Evaluation    &stage,
                       const EffectResults *results,
                       EnergyAccount       &account) const override;

  private:
    /** Force and moment in the axes that turn with the joint (N, N m). */
    struct Values
    {
      SpaceVector force, moment;
    };
    /** Local unknowns by component of motion; -1: not there. */
    using Joint = std::array<int, n_motion_components>;
    struct Load
    {
      std::array<TimeFunction, n_motion_components> components;
      EnergyEntry                                   work;
      std::vector<Joint>                            joints;
      unsigned int work_entry = 0; ///< of the ledger
    };

    /** @p value of a component at the time in question. */
    template <class Value>
    static Values values(const Load &load, const Value &value);
    /** At the end of the step, or at the instant. */
    static Values values_now(const Load &load, const Evaluation &evaluation);
    /** When the step begins. */
    Values values_before(const Load &load, const Evaluation &step) const;
    /** At start and end of a step. To be asked on all ranks alike: functions of
     * time may have no value there. */
    struct Ends
    {
      Values before, now;
    };
    Ends values_at_ends(const Load &load, const Evaluation &step) const;
    /** Means over the step of what acts on a joint, in the global frame; the
     * moment is. */
    Values mean_values(const Ends       &ends,
                       const Joint      &joint,
                       const Evaluation &step) const;
    /** Of a step between two states: such that moments too do their work. */
    void add_mean_loads(const Evaluation &step, double *residual) const;
    /** Subtracts force and moment of all loads; @p value as for values(). */
    template <class Value>
    void subtract(const Value &value, const State &state, double *forces) const;
    Quaternion rotation(const Joint &joint, const State &state) const;

    const bool          is_planar;
    const DofNumbering &numbering;
    const NodeRotations rotations;
    const bool          raised_from_zero;
    std::vector<Load>   loads;
    std::size_t         first_block = 0;
  };
} // namespace auxfem

#endif
