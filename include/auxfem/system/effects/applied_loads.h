#ifndef auxfem_system_effects_applied_loads_h
#define auxfem_system_effects_applied_loads_h

#include <auxfem/loads/time_function.h>
#include <auxfem/system/node_rotations.h>

namespace auxfem
{
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

    /** Starts a new load that follows @p course in time; returns its number. */
    unsigned int add_load(const TimeFunction &course);

    /** Lets load @p load act on a local unknown with @p weight. */
    void add_weight(unsigned int load, int unknown, double weight);

    /** Whether no load was added. */
    bool empty() const;

    bool is_linear() const override;
    void begin_step(const Step &step) override;
    void add_residual(const Step &step, double *residual) override;
    void accept(const Step &step) override;

  private:
    struct Weight
    {
      int    unknown;
      double weight;
    };
    struct Load
    {
      TimeFunction        course;
      std::vector<Weight> weights;
      double              before = 0; ///< value at the start of the step
      double              now    = 0; ///< value at its end
    };
    /** How far an unknown moved in the step, rotations in the global frame. */
    double motion(const Step &step, int unknown) const;

    const DofNumbering &numbering;
    const NodeRotations rotations;
    const bool          raised_from_zero;
    std::vector<Load>   loads;
  };
} // namespace auxfem

#endif
