#ifndef auxfem_connectors_effects_law_group_h
#define auxfem_connectors_effects_law_group_h

#include <auxfem/connectors/connector_definition.h>
#include <auxfem/equations/energy_account.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/state/state.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * The law of a group of equal connectors or rotational springs with its
   * internal variables, failures and energies; used by their effects, which
   * provide the motion. For rotational springs extensions are relative
   * rotations (rad), forces moments (N m).
   */
  class LawGroup
  {
  public:
    /**
     * @param numbers of the members on this rank among all of the group
     * @param owned those of them whose energies this rank accounts
     */
    LawGroup(const std::string                  &name,
             std::shared_ptr<const ConnectorLaw> law,
             const ConnectorLimits              &limits,
             const std::vector<unsigned int>    &numbers,
             const std::vector<unsigned int>    &owned);

    /** Requests state variables and enters energies. @p stored is the entry of
     * the energy in the springs. */
    void register_in(StateLayout &layout, const EnergyEntry &stored);

    /** Computes forces and internal variables for @p motion. */
    void evaluate(const Evaluation                   &evaluation,
                  const std::vector<ConnectorMotion> &motion,
                  std::vector<ConnectorResponse>     &response) const;

    /** Effect::account(). */
    void account(const Evaluation                   &evaluation,
                 const std::vector<ConnectorMotion> &motion,
                 EnergyAccount                      &account) const;

    /** Breaks members whose force or extension in @p motion, at the end of a
     * solved step, exceeds its limit. */
    void update_history(const Evaluation                   &solved,
                        const std::vector<ConnectorMotion> &motion) const;

    /**
     * Effect::account_step().
     * @param rate_before rate of a member at step.from (m/s), only called for
     *   viscous laws
     */
    void account_step(const Evaluation                          &step,
                      const std::vector<ConnectorMotion>        &motion,
                      const std::vector<ConnectorResponse>      &response,
                      const std::function<double(unsigned int)> &rate_before,
                      EnergyAccount                             &account) const;

    /** StageTerms::account_stage(). */
    void account_stage(const Evaluation                   &stage,
                       const std::vector<ConnectorMotion> &motion,
                       EnergyAccount                      &account) const;

    /** StageTerms::find_internal_rates(). */
    void find_internal_rates(const State                        &state,
                             const std::vector<ConnectorMotion> &motion,
                             double                             *rates) const;

    /** Whether member @p i has no force in steps from @p state. */
    bool is_broken(const State &state, const unsigned int i) const
    {
      return may_break() && state.history[first_broken + i] != intact;
    }

    bool may_break() const
    {
      return limits.force || limits.extension;
    }

    /** Energy (J) that member @p i has lost since the start. */
    double dissipated(const State &state, const unsigned int i) const
    {
      return law->dissipates() ? state.history[first_dissipated + i] : 0.;
    }

    /** Whether forces are linear in the motion. */
    bool is_linear() const
    {
      return law->is_linear() && !may_break();
    }

    const std::string                         name;
    const std::shared_ptr<const ConnectorLaw> law;

  private:
    /** Values of State::history from first_broken on. */
    static constexpr double intact = 0, broken = 1, breaks_now = 2;

    /** Whether member @p i broke in the step that ended at @p state. */
    bool breaks(const State &state, const unsigned int i) const
    {
      return may_break() && state.history[first_broken + i] == breaks_now;
    }

    /** The law of member @p i in continuous form at @p state. */
    ContinuousResponse continuous(unsigned int           i,
                                  const State           &state,
                                  const ConnectorMotion &motion,
                                  double                *internal_rates) const;

    /** Energies of member @p i at the end of a step. */
    ConnectorEnergy energy_at_end(unsigned int           i,
                                  const Evaluation      &step,
                                  const ConnectorMotion &motion) const;

    /**
     * Numerical work (J): trapezoidal work of the forces of member @p i at both
     * ends of the step, minus stored and dissipated energy of @p energy. A
     * member that has just broken loses its force within the step.
     * @param rate_before at the start (m/s)
     */
    double numerical_work(unsigned int             i,
                          const Evaluation        &step,
                          const ConnectorMotion   &motion,
                          const ConnectorResponse &response,
                          double                   rate_before,
                          const ConnectorEnergy   &energy) const;

    const ConnectorLimits           limits;
    const std::vector<unsigned int> numbers, owned;
    std::vector<bool>               is_owned;
    /** Positions in State::history. */
    std::size_t  first_history = 0, first_dissipated = 0, first_broken = 0;
    unsigned int stored_entry = 0, dissipated_entry = 0, fracture_entry = 0,
                 numerical_entry = 0;
  };
} // namespace auxfem

#endif
