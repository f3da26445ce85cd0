#include <auxfem/analysis/inverse_iteration.h>
#include <auxfem/analysis/small_motions/mode_space.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/model/unknown_names.h>
#include <auxfem/scene/time_function_notes.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string stability_record = "watch: stability";

    /**
     * Tangents that are factorized beside the run: neither its factorization
     * nor the name of its linear solver is touched.
     */
    class TangentAside
    {
    public:
      TangentAside(const Scene &scene, const Equations &equations, Work &work)
        : equations(equations)
        , parameters(scene.solver)
        , work(work)
      {}

      /** Of what the next tangents are. */
      void evaluate(const Evaluation &evaluation)
      {
        if (!solver)
          {
            solver.emplace(equations, parameters, work);
            results = equations.make_results();
          }
        solver->residual(evaluation, results);
      }

      /** Of the tangent with @p factors, if they can be told. */
      std::optional<NegativeModes> negative_modes(const Evaluation &evaluation,
                                                  const TangentFactors &factors)
      {
        const std::string of_run = work.linear_solver;
        solver->assemble(evaluation, results, factors);
        const bool is_done = solver->factorize();
        work.linear_solver = of_run;
        return is_done ? solver->new_negative_modes() : std::nullopt;
      }

      /** One at least, if the determinant of that tangent tells it. */
      NegativeModes negative_modes_by_determinant()
      {
        const std::optional<int> sign = ModeSpace(*solver).determinant_sign();
        return {sign && *sign < 0 ? 1ul : 0ul, /*is_least=*/true};
      }

      /** Joint and component that move most in the softest mode of the tangent
       * with @p factors; empty if there is none to be found. */
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
        constexpr unsigned int n_iterations = 4;
        const std::string      of_run       = work.linear_solver;
        solver->assemble(evaluation, results, factors);
        const auto growth  = inverse_iteration(*solver,
                                              weight,
                                              is_translation,
                                              n_iterations,
                                              mode);
        work.linear_solver = of_run;
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

    /** When, where and under which loads stability was lost first, if it was.
     */
    class FirstLoss
    {
    public:
      explicit FirstLoss(const Scene &scene) : scene(scene)
      {}

      explicit operator bool() const
      {
        return is_lost;
      }

      void note(const double at, const std::string &in)
      {
        is_lost  = true;
        time     = at;
        location = in;
      }

      /** Begins the sentence of a finding. */
      void write(std::ostream &text) const
      {
        const std::string loads = load_values_text(scene, time);
        text << "Stability is lost at about t = " << time << " s"
             << (loads.empty() ? "" : " (" + loads + ")")
             << (location.empty() ? "" : ", most at the " + location) << ": ";
      }

      Finding finding(const std::string &text) const
      {
        return {Verdict::doubtful, text, time, location};
      }

      void save(Records &records) const
      {
        records.keep(stability_record + ": first loss",
                     {is_lost ? 1. : 0., time});
        records.keep_text(stability_record + ": location", location);
      }

      void resume(const Records &records)
      {
        const std::vector<double> values =
          records.values(stability_record + ": first loss", 2);
        is_lost  = values[0] != 0;
        time     = values[1];
        location = records.text(stability_record + ": location");
      }

    private:
      const Scene &scene;
      bool         is_lost = false;
      double       time    = 0; ///< s
      std::string  location;
    };

    /**
     * Of equilibria: no mode of their stiffness is negative while they are
     * stable. Newton's factorization is of a state on the way to the
     * equilibrium; where it tells nothing new or nothing good, the stiffness of
     * the equilibrium itself is factorized.
     */
    class EquilibriumWatch : public Watch
    {
    public:
      EquilibriumWatch(const Scene     &scene,
                       const Equations &equations,
                       Work            &work)
        : aside(scene, equations, work)
        , first(scene)
      {}

      bool changes_stability(const Evaluation &step,
                             TangentSolver    &newtons) override
      {
        const std::optional<NegativeModes> on_the_way =
          newtons.new_negative_modes();
        now =
          on_the_way && on_the_way->n == 0 ? NegativeModes() : look_at(step);
        return now.n != last;
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*newtons*/) override
      {
        last     = now.n;
        most     = std::max(most, last);
        is_least = is_least || now.is_least;
        if (last > 0 && !first)
          note_loss(step);
      }

      std::vector<Finding> findings() const override
      {
        if (!first)
          return {};
        std::ostringstream text;
        first.write(text);
        text << "from there on " << (is_least ? "at least " : "up to ") << most
             << (most == 1 ? " mode of the stiffness is negative"
                           : " modes of the stiffness are negative")
             << (last == 0 ? ", though not in the end" : "")
             << ". A real structure leaves such equilibria. Give a small "
                "disturbance (a lateral load, an uneven shape) or compute with "
                "inertia.";
        return {first.finding(text.str())};
      }

      void save(Records &records) const override
      {
        first.save(records);
        records.keep(stability_record,
                     {double(most), double(last), is_least ? 1. : 0.});
      }

      void resume(const Records &records) override
      {
        first.resume(records);
        const std::vector<double> values = records.values(stability_record, 3);
        most                             = values[0];
        last                             = values[1];
        is_least                         = values[2] != 0;
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
        aside.evaluate(again);
        return check(again);
      }

      /** Negative modes at step.to. */
      NegativeModes look_at(const Evaluation &step)
      {
        const auto modes = at_end(step, [this](const Evaluation &end) {
          return aside.negative_modes(end, stiffness);
        });
        // At an equilibrium the stiffness is not symmetric only where loads do
        // not keep their direction.
        return modes ? *modes : aside.negative_modes_by_determinant();
      }

      void note_loss(const Evaluation &step)
      {
        first.note(step.to.time, at_end(step, [this](const Evaluation &end) {
                     return aside.location_of_softest_mode(end, stiffness);
                   }));
      }

      TangentAside  aside;
      FirstLoss     first;
      NegativeModes now; ///< of the step last solved
      unsigned long most = 0, last = 0;
      bool          is_least = false; ///< as NegativeModes
    };

    /**
     * Of motions, now and then: whether K + s^2 M at rest in the positions of
     * the moment has more negative eigenvalues than constraints. Then a
     * disturbance grows at least as exp(s t) for the time being.
     */
    class MotionWatch : public Watch
    {
    public:
      MotionWatch(const Scene &scene, const Equations &equations, Work &work)
        : aside(scene, equations, work)
        , end_time(scene.time.end_time)
        , work(work)
        , first(scene)
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        const bool is_last = step.to.time >= end_time;
        if (work.iterations < next_look &&
            step.to.time < last_look + end_time / n_looks && !is_last)
          return;
        const double rate = growth_rate(step);
        exponent += std::min(rate, last_rate) * (step.to.time - last_look);
        last_look = step.to.time;
        last_rate = rate;
        next_look = work.iterations +
          (rate > 0 ? iterations_while_unstable : iterations_while_stable);
      }

      std::vector<Finding> findings() const override
      {
        if (!first || exponent < doubtful_exponent)
          return {};
        std::ostringstream text;
        text.precision(3);
        first.write(text);
        text << "from there on a small disturbance grows, until the end by a "
                "factor of e^"
             << exponent
             << " at least. What the lattice does then depends on disturbances "
                "that the scene does not give: try a small one (a lateral "
                "load, an uneven shape), and compare.";
        return {first.finding(text.str())};
      }

      void save(Records &records) const override
      {
        first.save(records);
        records.keep(stability_record,
                     {exponent, last_rate, last_look, double(next_look)});
      }

      void resume(const Records &records) override
      {
        first.resume(records);
        const std::vector<double> values = records.values(stability_record, 4);
        exponent                         = values[0];
        last_rate                        = values[1];
        last_look                        = values[2];
        next_look                        = values[3];
      }

    private:
      /** A disturbance of a 1e-5th part becomes as large as the motion. */
      static constexpr double doubtful_exponent = 11.5;
      /** In a run at least: growth between two looks is not seen in full. */
      static constexpr unsigned int n_looks = 20;
      /** Newton's iterations between two looks, at most: a look costs as much
       * as about nine. */
      static constexpr unsigned long iterations_while_stable   = 600,
                                     iterations_while_unstable = 50;

      /** Largest of the rates looked at (1/s) at which a disturbance grows at
       * step.to; 0: none. */
      double growth_rate(const Evaluation &step)
      {
        State at_rest = step.to;
        for (Vector *rates : {&*at_rest.velocity, &*at_rest.acceleration})
          rates->assign(rates->size(), 0.);
        const State      before  = at_rest;
        const Evaluation instant = Evaluation::step(before, at_rest, step.dt);
        aside.evaluate(instant);
        const auto shifted = [](const double rate) {
          return TangentFactors{1., 0., rate * rate};
        };
        // Slower ones do not get far in the whole run.
        double                 rate = doubtful_exponent / end_time, found = 0;
        constexpr double       factor  = 2;
        constexpr unsigned int n_rates = 24;
        for (unsigned int i = 0;
             i < n_rates && is_unstable(instant, shifted(rate));
             ++i, rate *= factor)
          found = rate;
        if (found > 0 && !first)
          first.note(at_rest.time,
                     aside.location_of_softest_mode(instant, shifted(found)));
        return found;
      }

      bool is_unstable(const Evaluation &instant, const TangentFactors &factors)
      {
        const auto modes = aside.negative_modes(instant, factors);
        return modes && modes->n > 0;
      }

      TangentAside  aside;
      const double  end_time; ///< s
      const Work   &work;
      unsigned long next_look = iterations_while_stable;
      double        last_rate = 0; ///< 1/s
      double        last_look = 0; ///< s
      double        exponent  = 0;
      FirstLoss     first;
    };
  } // namespace

  std::unique_ptr<Watch> make_stability_watch(const Scene     &scene,
                                              const Equations &equations,
                                              Work            &work)
  {
    if (equations.model().simulated.inertia)
      return std::make_unique<MotionWatch>(scene, equations, work);
    return std::make_unique<EquilibriumWatch>(scene, equations, work);
  }
} // namespace auxfem
