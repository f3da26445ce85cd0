#ifndef auxfem_equations_effects_applied_loads_h
#define auxfem_equations_effects_applied_loads_h

#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/time_function.h>

namespace auxfem
{
  class PathWork;

  /**
   * Dead loads: a fixed distribution over the unknowns times a function of
   * time. Joint forces, line loads and gravity all take this form.
   */
  class AppliedLoads : public Effect
  {
  public:
    /**
     * @param raised_from_zero the first step raises the loads from nothing, even if
     *   they have a value at t = 0 (statics from rest); else they act from the
     * start.
     */
    AppliedLoads(const DofNumbering &numbering, bool raised_from_zero);

    /**
     * Starts a new load that follows @p time_history.
     * @param name of the energy entry that keeps its work; loads may share it.
     */
    unsigned int add_load(const TimeFunction &time_history,
                          const EnergyEntry  &work);

    /** Lets load @p load act on a local unknown with @p weight. */
    void add_weight(unsigned int load, int unknown, double weight);

    /** Whether no load was added. */
    bool empty() const;

    bool is_linear() const override;
    void register_in(StateLayout &layout) override;
    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectResults    *results) const override;
    void add_load_derivative(const Evaluation &evaluation,
                             double           *derivative) const override;
    void account_step(const Evaluation    &step,
                      const EffectResults *results,
                      EnergyAccount       &account) const override;
    void account_stage(const Evaluation    &stage,
                       const EffectResults *results,
                       EnergyAccount       &account) const override;

  private:
    struct Weight
    {
      int    unknown;
      double weight;
    };
    struct Load
    {
      TimeFunction        time_history;
      EnergyEntry         work;
      std::vector<Weight> weights;
      unsigned int        work_entry = 0; ///< of the ledger
    };
    /** Value when the step begins. */
    double value_before(const Load &load, const Evaluation &step) const;
    /** By a curved path, of all but moments on large rotations in space (J). */
    double work_of_path(const Load       &load,
                        const Evaluation &step,
                        const PathWork   &path) const;
    /** Mean over the step. */
    double mean_value(const Load &load, const Evaluation &step) const;
    /** Of a step between two states: such that moments too do their work. */
    void add_mean_loads(const Evaluation &step, double *residual) const;
    /** How far an unknown moved in the step, rotations in the global frame. */
    double motion(const Evaluation &step, int unknown) const;

    const DofNumbering &numbering;
    const NodeRotations rotations;
    const bool          raised_from_zero;
    std::vector<Load>   loads;
  };
} // namespace auxfem

#endif
