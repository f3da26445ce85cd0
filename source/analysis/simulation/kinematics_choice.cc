#include <auxfem/analysis/simulation/kinematics_choice.h>
#include <auxfem/contact/effects/contact.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/time/small_displacement_limit.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Whether small displacements of the scene are simpler than what it asks
     * for, and their error can be estimated. */
    bool has_choice(const Equations &exact)
    {
      const RunPlan &plan  = exact.model().plan;
      const auto    &loads = plan.joint_loads();
      return plan.effects.large_rotation == Switch::automatic &&
        exact.unknowns().n_free() > 0 && !exact.is_linear() &&
        exact.reporting().constraints.empty() &&
        exact.reporting().plates == nullptr &&
        !plan.time.implicit_scheme().balances_means() &&
        std::none_of(loads.begin(),
                     loads.end(),
                     [](const JointLoadDefinition &load) {
                       return load.follows_joint;
                     });
    }

    /** The same effects but for those of kinematics. */
    SimulatedEffects with_small_displacements(SimulatedEffects simulated)
    {
      simulated.large_rotation = simulated.contact = false;
      simulated.small_displacements_are_limited    = true;
      return simulated;
    }

    /** A run by small displacements beside the exact one, and its limit. */
    struct SmallRun
    {
      explicit SmallRun(const LatticeRun &exact)
        : run(exact, with_small_displacements(exact.model.plan.simulated))
        , limit(run.equations, exact.equations)
      {}

      EffectDecision decide()
      {
        const double             tolerance = run.model.plan.effects.tolerance;
        const LargeRotationError error     = limit.check_static_answer();
        const std::string        why       = error.reason(tolerance);
        const std::string        of =
          std::string(run.model.plan.simulated.inertia ? "twice " : "") +
          "the static answer to the loads";
        return {large_rotation_effect().name,
                !why.empty(),
                why.empty() ? part_text(error.relative) + " of " + of +
                    ", below " + part_text(tolerance) +
                    ": small displacements, checked in the run"
                            : of + ": " + why,
                EffectMeasure{std::min(error.relative, 1.), of}};
      }

      LatticeRun             run;
      SmallDisplacementLimit limit;
    };

    /** Lists a decision for small displacements in @p model, and what follows
     * from it for contact. */
    void explain_small_displacements(const EffectDecision &decision,
                                     LatticeModel         &model)
    {
      model.explain(decision);
      const std::string contact = contact_effect().name;
      if (model.plan.simulated.decision(contact).on)
        model.explain({contact, false, struts_hardly_move});
    }

    /** Nothing if @p exact is to run, which has the reason then. */
    std::optional<RunResult> run_by_small_displacements(LatticeRun &exact,
                                                        Recorder   &recorder)
    {
      SmallRun             small(exact);
      const auto          &former_choice = exact.model.plan.kinematics;
      const EffectDecision decision =
        former_choice ? *former_choice : small.decide();
      if (decision.on)
        {
          exact.model.explain(decision);
          exact.add_effort(small.limit.effort());
          return {};
        }
      explain_small_displacements(decision, small.run.model);
      small.run.set_limit(small.limit);
      try
        {
          return small.run.run(recorder);
        }
      catch (const BeyondSmallDisplacements &reason)
        {
          exact.add_effort(small.run.work_of_all());
          exact.model.explain(
            {decision.name,
             true,
             reason.what() + std::string("; run again from the start"),
             decision.measure});
        }
      return {};
    }
  } // namespace

  void explain_kinematics(LatticeRun &exact)
  {
    if (!has_choice(exact.equations))
      return;
    const EffectDecision decision = SmallRun(exact).decide();
    if (decision.on)
      exact.model.explain(decision);
    else
      explain_small_displacements(decision, exact.model);
  }

  RunResult run_with_chosen_kinematics(const RunPlan &plan,
                                       const MPI_Comm communicator,
                                       Recorder      &recorder)
  {
    LatticeRun exact(plan, communicator);
    if (has_choice(exact.equations))
      if (const auto result = run_by_small_displacements(exact, recorder))
        return *result;
    return exact.run(recorder);
  }
} // namespace auxfem
