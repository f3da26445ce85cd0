#include <auxfem/analysis/simulation/kinematics_choice.h>
#include <auxfem/contact/effects/contact.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/time/small_displacement_limit.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /**
     * Whether small displacements simplify the scene and their error can be
     * estimated.
     */
    bool has_choice(const Equations &exact)
    {
      const RunPlan &plan  = exact.model().plan;
      const auto    &loads = plan.joint_loads();
      return plan.effects.large_rotation == Switch::automatic &&
        exact.unknowns().n_free() > 0 && !exact.is_linear() &&
        exact.reporting().constraints.empty() &&
        exact.reporting().plates == nullptr && plan.scene.pressures.empty() &&
        !plan.time.implicit_scheme().uses_discrete_gradient() &&
        std::none_of(loads.begin(),
                     loads.end(),
                     [](const JointLoadDefinition &load) {
                       return load.follows_joint;
                     });
    }

    /** The same effects with small displacements, without contact and, unless
     * the user asks for it, plasticity. */
    SimulatedEffects with_small_displacements(const RunPlan &plan)
    {
      SimulatedEffects simulated = plan.simulated;
      if (plan.effects.plasticity == Switch::automatic)
        simulated.plasticity = false;
      simulated.large_rotation = simulated.contact = false;
      simulated.small_displacements_are_limited    = true;
      return simulated;
    }

    /**
     * A run by small displacements, with the exact one as reference, and its
     * limit.
     */
    struct SmallRun
    {
      explicit SmallRun(const LatticeRun &exact)
        : run(exact, with_small_displacements(exact.model.plan))
        , limit(run.equations, exact.equations)
      {}

      EffectDecision decide()
      {
        const double             tolerance = run.model.plan.effects.tolerance;
        const LargeRotationError error     = limit.check_static_answer();
        const std::string        reason    = error.reason(tolerance);
        const std::string        response =
          std::string(run.model.plan.simulated.inertia ? "twice " : "") +
          "the static answer to the loads";
        return {large_rotation_effect().name,
                !reason.empty(),
                reason.empty() ? part_text(error.relative) + " of " + response +
                    ", below " + part_text(tolerance) +
                    ": small displacements, checked in the run"
                               : response + ": " + reason,
                EffectMeasure{std::min(error.relative, 1.), response}};
      }

      LatticeRun             run;
      SmallDisplacementLimit limit;
    };

    /**
     * Lists the decision for small displacements in @p model, and its
     * consequences for contact and plasticity.
     */
    void explain_small_displacements(const EffectDecision &decision,
                                     LatticeModel         &model)
    {
      model.explain(decision);
      const std::string contact = contact_effect().name;
      if (model.plan.simulated.decision(contact).on)
        model.explain({contact, false, struts_hardly_move});
      const std::string plasticity = plasticity_effect().name;
      if (model.plan.simulated.decision(plasticity).on &&
          !model.plan.simulated.plasticity)
        model.explain(
          {plasticity,
           false,
           "no fibre reaches the yield stress, checked in the run"});
    }

    /** Empty if @p exact must run; it then has the reason. */
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
      catch (const SmallDisplacementLimitExceeded &reason)
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
