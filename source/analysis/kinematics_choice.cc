#include <auxfem/analysis/kinematic_correction.h>
#include <auxfem/analysis/kinematics_choice.h>
#include <auxfem/analysis/touch_watch.h>
#include <auxfem/equations/effects/contact.h>
#include <auxfem/model/effect_definition.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Name of the effect in the list of what is simulated. */
    const std::string large_rotation = "large rotation";

    /**
     * Static answers may be larger than the motion, that of a short impact say.
     * Above this many tolerances small displacements are not tried.
     */
    constexpr double worth_trying = 10;

    /** Times the error is looked at in a run. */
    constexpr unsigned int n_error_looks = 10;

    /** Whether small displacements of the scene are simpler than what it asks
     * for, and known how to be judged. */
    bool has_choice(const Scene &scene, const Equations &exact)
    {
      return scene.effects.large_rotation == Switch::automatic &&
        exact.unknowns().n_free() > 0 && !exact.is_linear() &&
        exact.reporting().constraints.empty() &&
        exact.reporting().plates == nullptr &&
        !scene.time.implicit_scheme().balances_means();
    }

    /** Only the kinematics may differ where errors of it are looked for: struts
     * are damped as in the exact model, also where small displacements alone
     * could do without. */
    Scene with_small_displacements(const LatticeRun &exact)
    {
      Scene small                                  = exact.scene;
      small.effects.large_rotation                 = Switch::off;
      small.effects.small_displacements_are_judged = true;
      small.effects.strut_damping =
        exact.model.simulated.strut_damping ? Switch::on : Switch::off;
      return small;
    }

    const std::string decision_record = "decision on large rotation",
                      reason_record   = decision_record + ", reason",
                      measure_record  = decision_record + ", measure of",
                      look_work_record =
                        "work of looks at the error of small displacements";

    void save_decision(const EffectDecision &decision, Records &records)
    {
      const auto &measure = decision.measure;
      records.keep(decision_record,
                   {decision.on ? 1. : 0.,
                    measure ? 1. : 0.,
                    measure ? measure->change : 0.});
      records.keep_text(reason_record, decision.reason);
      records.keep_text(measure_record, measure ? measure->of : "");
    }

    EffectDecision saved_decision(const Records &records)
    {
      const std::vector<double> values = records.values(decision_record, 3);
      EffectDecision            decision{large_rotation,
                              values[0] != 0,
                              records.text(reason_record)};
      if (values[1] != 0)
        decision.measure =
          EffectMeasure{values[2], records.text(measure_record)};
      return decision;
    }

    /** Keeps what was decided on the kinematics with every checkpoint. */
    class DecisionRecorder : public ForwardingRecorder
    {
    public:
      DecisionRecorder(const LatticeRun &exact, Recorder &recorder)
        : ForwardingRecorder(recorder)
        , exact(exact)
      {}

      void save(Records &records) const override
      {
        save_decision(exact.model.decision(large_rotation), records);
        ForwardingRecorder::save(records);
      }

    private:
      const LatticeRun &exact;
    };

    /** Told of struts that touch in @p small, which knows no contact; nothing
     * where they cannot. @p exact must outlive it. */
    const TouchWatch *watch_touches(LatticeRun &small, const LatticeRun &exact)
    {
      const StrutContact *const contact =
        exact.equations.reporting().strut_contact;
      if (contact == nullptr)
        return nullptr;
      auto watch = std::make_unique<TouchWatch>(contact->lookout());
      const TouchWatch *watching = watch.get();
      small.watches().add(std::move(watch));
      return watching;
    }

    /** Ends a run of small displacements as soon as they are no longer good
     * enough. */
    class SmallDisplacementRecorder : public DecisionRecorder
    {
    public:
      /** @param touches in the run of small displacements; may be none */
      SmallDisplacementRecorder(LatticeRun          &exact,
                                KinematicCorrection &error,
                                const TouchWatch    *touches,
                                Recorder            &recorder)
        : DecisionRecorder(exact, recorder)
        , scene(exact.scene)
        , exact(exact)
        , error(error)
        , distance(
            std::max<unsigned long>(scene.time.n_steps() / n_error_looks, 1))
        , touches(touches)
      {}

      /** Why the run has to be done again; empty: it has not. */
      const std::string &reason() const
      {
        return why;
      }

      void begin(const Equations &equations) override
      {
        error.begin(equations);
        ForwardingRecorder::begin(equations);
      }

      void step(const Solution &solution, const StepReport &report) override
      {
        if (touches != nullptr && touches->first_touch())
          why = touch_text(*touches->first_touch());
        else if (error.asks_for_look(solution.state) ||
                 solution.state.step % distance == 0)
          look(solution.state);
        if (why.empty())
          ForwardingRecorder::step(solution, report);
      }

      void save(Records &records) const override
      {
        error.save(records);
        const Work &work = exact.work();
        records.keep(look_work_record,
                     {double(work.iterations),
                      double(work.factorizations),
                      double(work.linear_solutions),
                      double(work.linear_iterations)});
        DecisionRecorder::save(records);
      }

      void resume(const Solution &solution, const Records &records) override
      {
        error.resume(records);
        const std::vector<double> values = records.values(look_work_record, 4);
        Work                      before;
        before.iterations        = values[0];
        before.factorizations    = values[1];
        before.linear_solutions  = values[2];
        before.linear_iterations = values[3];
        exact.add_effort(before);
        DecisionRecorder::resume(solution, records);
      }

      bool ends_run() const override
      {
        return !why.empty() || ForwardingRecorder::ends_run();
      }

      void finish(const Solution &last, const RunResult &result) override
      {
        RunResult with_estimate = result;
        with_estimate.work.add_effort(exact.work());
        with_estimate.small_displacement_error = error.relative();
        ForwardingRecorder::finish(last, with_estimate);
      }

    private:
      void look(const State &state)
      {
        error.look_at(state);
        why = error.why_exact(scene.effects.tolerance);
        if (!why.empty())
          why += time_text(state.time);
      }

      /** Struts that move far without turning may touch all the same. */
      static std::string touch_text(const FirstTouch &touch)
      {
        return "struts " + std::to_string(touch.struts[0]) + " and " +
          std::to_string(touch.struts[1]) + " touch" + time_text(touch.time);
      }

      static std::string time_text(const double time)
      {
        std::ostringstream text;
        text << " (t = " << time << " s)";
        return text.str();
      }

      const Scene            &scene;
      LatticeRun             &exact;
      KinematicCorrection    &error;
      const unsigned long     distance; ///< of looks, steps
      const TouchWatch *const touches;
      std::string             why;
    };

    /** What users are told if small displacements are tried. */
    std::string reason_for_trial(const double error, const double tolerance)
    {
      return part_text(error) + " of the static answer to the loads, " +
        (error <= tolerance
           ? "below " + part_text(tolerance)
           : "above " + part_text(tolerance) + ", but motions may be smaller") +
        ": small displacements, watched";
    }

    /** Decides whether small displacements are worth a trial. */
    EffectDecision decision_by_loads(KinematicCorrection &correction,
                                     const double         tolerance)
    {
      correction.look_at_loads();
      const double      error = correction.relative();
      const std::string why   = correction.why_exact(worth_trying * tolerance);
      return {large_rotation,
              !why.empty(),
              why.empty() ? reason_for_trial(error, tolerance)
                          : "static answer to the loads: " + why,
              EffectMeasure{std::min(error, 1.),
                            "the static answer to the loads"}};
    }

    /** Tells what was decided, and what follows for contact of struts. */
    void explain(LatticeRun &exact, const EffectDecision &kinematics)
    {
      exact.model.explain(kinematics);
      if (kinematics.on)
        return;
      const EffectDefinition contact = contact_effect();
      const EffectCause cause = contact.cause(with_small_displacements(exact));
      exact.model.explain({contact.name, cause.given, cause.reason});
    }

    /** Decides, and tries; nothing if @p exact is to run. */
    std::optional<RunResult> run_with_small_displacements(LatticeRun &exact,
                                                          Recorder   &recorder)
    {
      const Scene         &scene      = exact.scene;
      const Records *const checkpoint = recorder.goes_on_from();
      const EffectDecision contact =
        exact.model.decision(contact_effect().name);
      KinematicCorrection correction(scene, exact.solver());
      explain(exact,
              checkpoint != nullptr
                ? saved_decision(*checkpoint)
                : decision_by_loads(correction, scene.effects.tolerance));
      if (exact.model.decision(large_rotation).on)
        return {};

      const Scene small_scene = with_small_displacements(exact);
      LatticeRun  small(small_scene, exact);
      for (const EffectDecision &decision : exact.model.simulated.decisions)
        small.model.explain(decision);
      SmallDisplacementRecorder watching(exact,
                                         correction,
                                         watch_touches(small, exact),
                                         recorder);
      const RunResult           result = small.run(watching);
      if (watching.reason().empty())
        return result;
      exact.add_effort(small.work());
      exact.model.explain(contact);
      exact.model.explain({large_rotation,
                           true,
                           watching.reason() + "; run again from the start",
                           exact.model.decision(large_rotation).measure});
      return {};
    }
  } // namespace

  void explain_kinematics(LatticeRun &exact)
  {
    if (!has_choice(exact.scene, exact.equations))
      return;
    KinematicCorrection correction(exact.scene, exact.solver());
    explain(exact,
            decision_by_loads(correction, exact.scene.effects.tolerance));
  }

  RunResult run_with_chosen_kinematics(const Scene   &scene,
                                       const MPI_Comm communicator,
                                       Recorder      &recorder)
  {
    LatticeRun exact(scene, communicator);
    if (!has_choice(scene, exact.equations))
      return exact.run(recorder);
    if (const auto result = run_with_small_displacements(exact, recorder))
      return *result;
    DecisionRecorder deciding(exact, recorder);
    return exact.run(deciding);
  }
} // namespace auxfem
