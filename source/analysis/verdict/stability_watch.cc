#include <auxfem/equations/mode_space.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Tangents factorized separately from the run, whose own factorization and
     * linear solver's name stay unchanged.
     */
    class ScratchTangent
    {
    public:
      ScratchTangent(const Equations &equations, Work &work)
        : equations(equations)
        , parameters(equations.model().plan.solver)
        , work(work)
      {}

      /** Evaluates the state of the next tangents. */
      void evaluate(const Evaluation &evaluation)
      {
        if (!solver)
          {
            solver.emplace(equations, parameters, work);
            results = equations.make_results();
          }
        solver->residual(evaluation, results);
      }

      /** Drops earlier factorizations. */
      void forget()
      {
        solver.reset();
      }

      /** Negative modes of the tangent with @p factors; empty if unknown. */
      std::optional<NegativeModes> negative_modes(const Evaluation &evaluation,
                                                  const TangentFactors &factors)
      {
        const std::string chosen_solver = work.linear_solver;
        solver->assemble(evaluation, results, factors);
        const bool is_factorized = solver->factorize();
        work.linear_solver       = chosen_solver;
        return is_factorized ? solver->new_negative_modes() : std::nullopt;
      }

      /**
       * At least one negative mode if the determinant of that tangent is
       * negative.
       */
      NegativeModes negative_modes_by_determinant()
      {
        const std::optional<int> sign = ModeSpace(*solver).determinant_sign();
        return {sign && *sign < 0 ? 1ul : 0ul, /*is_lower_bound=*/true};
      }

      /**
       * Joint and component with the largest motion in the softest mode of the
       * tangent with @p factors; empty if no mode is growing_rate.
       */
      std::string location_of_softest_mode(const Evaluation     &evaluation,
                                           const TangentFactors &factors)
      {
        const DofNumbering &numbering = equations.model().numbering;
        const auto         &kinds     = equations.unknowns().kinds;
        Vector              weight(kinds.size(), 0.), mode;
        const auto          is_translation = [&kinds](const unsigned int i) {
          return kinds[i] == UnknownKind::translation;
        };
        for (unsigned int i = 0; i < weight.size(); ++i)
          weight[i] = is_translation(i) ? 1. : 0.;
        constexpr unsigned int n_iterations  = 4;
        const std::string      chosen_solver = work.linear_solver;
        solver->assemble(evaluation, results, factors);
        const auto growth  = inverse_iteration(*solver,
                                              weight,
                                              is_translation,
                                              n_iterations,
                                              mode);
        work.linear_solver = chosen_solver;
        if (!growth)
          return "";
        for (double &entry : mode)
          entry = std::abs(entry);
        return describe_largest(numbering, mode);
      }

    private:
      const Equations             &equations;
      const SolverParameters       parameters;
      Work                        &work;
      std::optional<TangentSolver> solver;
      EvaluationResults            results;
    };

    /** Time, place and loads of the first loss of stability. */
    class FirstLoss
    {
    public:
      FirstLoss(const RunPlan &plan, RunStatistics &statistics)
        : plan(plan)
        , is_lost(statistics.number("stability: is lost"))
        , time(statistics.number("stability: time of first loss (s)"))
        , location(statistics.text("stability: location"))
      {}

      explicit operator bool() const
      {
        return is_lost != 0;
      }

      void note(const double at, const std::string &in)
      {
        is_lost  = 1;
        time     = at;
        location = in;
      }

      /** Writes the first part of a finding. */
      void write(std::ostream &text) const
      {
        const std::string loads = load_values_text(plan, time);
        text << "Stability is lost at about t = " << time << " s"
             << (loads.empty() ? "" : " (" + loads + ")")
             << (location.empty() ? "" : ", most at the " + location) << ": ";
      }

      Finding finding(const std::string &text) const
      {
        return {Verdict::doubtful, text, time, location};
      }

    private:
      const RunPlan &plan;
      double        &is_lost, &time; ///< 0 or 1; s
      std::string   &location;
    };

    /**
     * Checks equilibria: in a stable one no mode of the stiffness is negative.
     * Newton's factorization belongs to a state before convergence. Unless it
     * shows a positive stiffness, that of the equilibrium is factorized.
     */
    class EquilibriumWatch : public Watch
    {
    public:
      explicit EquilibriumWatch(const WatchContext &run)
        : scratch(run.equations, run.work)
        , first(run.plan, run.statistics)
        , most(run.statistics.number("stability: most negative modes"))
        , last(run.statistics.number("stability: last negative modes"))
        , is_lower_bound(run.statistics.number("stability: there may be more"))
      {}

      void forget_steps() override
      {
        scratch.forget();
      }

      bool changes_stability(const Evaluation &step,
                             TangentSolver    &newtons) override
      {
        const std::optional<NegativeModes> newton_modes =
          newtons.new_negative_modes();
        now = newton_modes && newton_modes->n == 0 ? NegativeModes()
                                                   : modes_at(step);
        return now.n != last;
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*newtons*/) override
      {
        last           = now.n;
        most           = std::max(most, last);
        is_lower_bound = is_lower_bound != 0 || now.is_lower_bound;
        if (last > 0 && !first)
          note_loss(step);
      }

      std::vector<Finding> findings() const override
      {
        if (!first)
          return {};
        std::ostringstream text;
        first.write(text);
        text << "from there on "
             << (is_lower_bound != 0 ? "at least " : "up to ") << most
             << (most == 1 ? " mode of the stiffness is negative"
                           : " modes of the stiffness are negative")
             << (last == 0 ? ", though not in the end" : "")
             << ". A real structure leaves such equilibria. Add a small "
                "disturbance (a lateral load, an imperfect shape) or compute "
                "with inertia.";
        return {first.finding(text.str())};
      }

    private:
      static constexpr TangentFactors stiffness = {1., 0., 0.};

      /** Calls @p check with the evaluation of the equilibrium at step.to. */
      template <class Check>
      auto at_end(const Evaluation &step, const Check &check)
      {
        State            end = step.to;
        const Evaluation again =
          Evaluation::static_step(step.from, end, step.dt);
        scratch.evaluate(again);
        return check(again);
      }

      /** Negative modes at step.to. */
      NegativeModes modes_at(const Evaluation &step)
      {
        const auto modes = at_end(step, [this](const Evaluation &end) {
          return scratch.negative_modes(end, stiffness);
        });
        // At an equilibrium the stiffness is unsymmetric only with follower
        // loads.
        return modes ? *modes : scratch.negative_modes_by_determinant();
      }

      void note_loss(const Evaluation &step)
      {
        first.note(step.to.time, at_end(step, [this](const Evaluation &end) {
                     return scratch.location_of_softest_mode(end, stiffness);
                   }));
      }

      ScratchTangent scratch;
      FirstLoss      first;
      NegativeModes  now; ///< of the last solved step
      double        &most, &last;
      double        &is_lower_bound; ///< 0 or 1, as NegativeModes
    };

    /**
     * Checks motions at intervals: if K + s^2 M, at rest in the current
     * position, has more negative eigenvalues than constraints, a disturbance
     * currently grows at least as exp(s t).
     */
    class MotionWatch : public Watch
    {
    public:
      explicit MotionWatch(const WatchContext &run)
        : scratch(run.equations, run.work)
        , end_time(run.plan.time.end_time)
        , first(run.plan, run.statistics)
        , exponent(run.statistics.number("stability: exponent"))
        , last_rate(run.statistics.number("stability: last rate (1/s)"))
        , last_time(run.statistics.number("stability: time of last rate (s)"))
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        const double interval = end_time /
          (last_rate > 0 ? n_while_unstable
                         : double(SamplingSchedule::min_samples));
        if (step.to.time < last_time + interval && step.to.time < end_time)
          return;
        const double rate = growth_rate(step);
        exponent += std::min(rate, last_rate) * (step.to.time - last_time);
        last_time = step.to.time;
        last_rate = rate;
      }

      void forget_steps() override
      {
        scratch.forget();
      }

      std::vector<Finding> findings() const override
      {
        if (!first || exponent < doubtful_exponent)
          return {};
        std::ostringstream text;
        text.precision(3);
        first.write(text);
        text << "from there on a small disturbance grows, until the end by a "
                "factor of at least e^"
             << exponent
             << ". The motion then depends on disturbances that the scene does "
                "not define. Add a small one (a lateral load, an imperfect "
                "shape), and compare.";
        return {first.finding(text.str())};
      }

    private:
      /**
       * Natural logarithm of the growth of disturbances above which a motion
       * is doubtful.
       * @tuned judgement: a relative disturbance of 1e-5 becomes as large as
       *   the motion
       */
      static constexpr double doubtful_exponent = 11.5;

      /**
       * Number of checks in a run while the motion is unstable; growth between
       * two checks is underestimated.
       * @tuned judgement: a check costs nine iterations of Newton's method
       */
      static constexpr double n_while_unstable = 240;

      /**
       * Largest tested rate (1/s) at which a disturbance grows at step.to; 0:
       * none.
       */
      double growth_rate(const Evaluation &step)
      {
        State at_rest = step.to;
        for (Vector *rates : {&*at_rest.velocity, &*at_rest.acceleration})
          rates->assign(rates->size(), 0.);
        const State      before  = at_rest;
        const Evaluation instant = Evaluation::step(before, at_rest, step.dt);
        scratch.evaluate(instant);
        const auto shifted = [](const double rate) {
          return TangentFactors{1., 0., rate * rate};
        };
        // Slower disturbances do not become notable within the run.
        double           rate = doubtful_exponent / end_time, growing_rate = 0;
        constexpr double factor        = 2;
        constexpr unsigned int n_rates = 24;
        for (unsigned int i = 0;
             i < n_rates && is_unstable(instant, shifted(rate));
             ++i, rate *= factor)
          growing_rate = rate;
        if (growing_rate > 0 && !first)
          first.note(at_rest.time,
                     scratch.location_of_softest_mode(instant,
                                                      shifted(growing_rate)));
        return growing_rate;
      }

      bool is_unstable(const Evaluation &instant, const TangentFactors &factors)
      {
        const auto modes = scratch.negative_modes(instant, factors);
        return modes && modes->n > 0;
      }

      ScratchTangent scratch;
      const double   end_time; ///< s
      FirstLoss      first;
      double        &exponent, &last_rate, &last_time; ///< -, 1/s, s
    };
  } // namespace

  std::unique_ptr<Watch> make_stability_watch(const WatchContext &run)
  {
    if (run.equations.model().plan.simulated.inertia)
      return std::make_unique<MotionWatch>(run);
    return std::make_unique<EquilibriumWatch>(run);
  }
} // namespace auxfem
