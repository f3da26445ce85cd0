#include <auxfem/analysis/inverse_iteration.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/model/unknown_words.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string record_name = "watch: stability";

    /** Joint and component that move most in the softest mode of the matrix of
     * @p solver, which is factorized again. */
    std::string place_of_softest_mode(TangentSolver &solver)
    {
      const DofNumbering &numbering = solver.model().numbering;
      const auto         &kinds     = numbering.unknowns().kinds;
      Vector              weight(kinds.size(), 0.), mode;
      const auto          is_translation = [&kinds](const unsigned int i) {
        return kinds[i] == UnknownKind::translation;
      };
      for (unsigned int i = 0; i < weight.size(); ++i)
        weight[i] = is_translation(i) ? 1. : 0.;
      constexpr unsigned int n_iterations = 4;
      if (!inverse_iteration(solver,
                             weight,
                             is_translation,
                             n_iterations,
                             mode))
        return "";
      for (unsigned int i = 0; i < mode.size(); ++i)
        mode[i] = std::abs(mode[i]);
      return describe_largest(numbering, mode);
    }

    /** For its life what is solved leaves no mark as the run's linear solver.
     */
    class Aside
    {
    public:
      explicit Aside(Work &work) : work(work), of_run(work.linear_solver)
      {}

      ~Aside()
      {
        work.linear_solver = of_run;
      }

      Aside(const Aside &)            = delete;
      Aside &operator=(const Aside &) = delete;

    private:
      Work             &work;
      const std::string of_run;
    };

    /** Where and when stability was lost first. */
    struct Loss
    {
      double      time; ///< s
      std::string place;
    };

    /**
     * Of equilibria: the negative eigenvalues of their stiffness are those of
     * conditions while they are stable. Newton's factorization is of a state on
     * the way to the equilibrium; where it tells nothing new or nothing good,
     * the stiffness of the equilibrium itself is factorized.
     */
    class EquilibriumWatch : public Watch
    {
    public:
      EquilibriumWatch(const Scene     &scene,
                       const Equations &equations,
                       Work            &work)
        : equations(equations)
        , solver_parameters(scene.solver)
        , work(work)
      {}

      void step(const Evaluation &step, TangentSolver &newtons) override
      {
        const std::optional<Inertia> on_the_way = newtons.new_inertia();
        last = on_the_way && more_than_conditions(*on_the_way) == 0
          ? 0
          : look_at(step);
        most = std::max(most, last);
      }

      std::vector<Finding> findings() const override
      {
        if (!first)
          return {};
        std::ostringstream text;
        text << "Stability is lost at about t = " << first->time << " s"
             << (first->place.empty() ? "" : ", most at the " + first->place)
             << ": from there on up to " << most
             << " modes of the stiffness are negative"
             << (last == 0 ? ", though not in the end" : "")
             << ". A real structure leaves such equilibria. Give a small "
                "disturbance (a lateral load, an uneven shape) or compute with "
                "inertia.";
        return {{Verdict::doubtful, text.str(), first->time, first->place}};
      }

      void save(Records &records) const override
      {
        records.keep(record_name,
                     {first ? 1. : 0.,
                      first ? first->time : 0.,
                      double(most),
                      double(last)});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(record_name, 4);
        if (values[0] != 0)
          first = {values[1], ""};
        most = values[2];
        last = values[3];
      }

    private:
      unsigned long more_than_conditions(const Inertia &inertia) const
      {
        const unsigned long n_conditions =
          equations.model().numbering.constraints().n_multipliers();
        return inertia.negative > n_conditions ? inertia.negative - n_conditions
                                               : 0;
      }

      /** Negative modes at step.to; 0 if that cannot be told. */
      unsigned long look_at(const Evaluation &step)
      {
        const Aside aside(work);
        if (!solver)
          {
            solver.emplace(equations, solver_parameters, work);
            results = equations.make_results();
          }
        State            end = step.to;
        const Evaluation again =
          Evaluation::static_step(step.from, end, step.dt);
        solver->residual(again, results);
        solver->assemble(again, results, {1., 0., 0.});
        if (!solver->factorize())
          return 0;
        const std::optional<Inertia> inertia = solver->new_inertia();
        const unsigned long more = inertia ? more_than_conditions(*inertia) : 0;
        if (more > 0 && !first)
          first = {step.to.time, place_of_softest_mode(*solver)};
        return more;
      }

      const Equations             &equations;
      const SolverParameters       solver_parameters;
      Work                        &work;
      std::optional<TangentSolver> solver;
      EvaluationResults            results;
      std::optional<Loss>          first;
      unsigned long                most = 0, last = 0;
    };

    /**
     * Of motions, now and then: whether K + s^2 M at rest in the place of the
     * moment has more negative eigenvalues than conditions. Then a disturbance
     * grows at least as exp(s t) for the time being.
     */
    class MotionWatch : public Watch
    {
    public:
      MotionWatch(const Scene &scene, const Equations &equations, Work &work)
        : equations(equations)
        , solver_parameters(scene.solver)
        , end_time(scene.time.end_time)
        , work(work)
      {}

      void step(const Evaluation &step, TangentSolver & /*solver*/) override
      {
        iterations_now     = work.iterations;
        const bool is_last = step.to.time >= end_time;
        if (iterations_now < next_look && !is_last)
          return;
        const double rate = growth_rate(step);
        exponent += std::min(rate, last_rate) * (step.to.time - last_look);
        last_look = step.to.time;
        last_rate = rate;
        next_look = iterations_now +
          (rate > 0 ? iterations_while_unstable : iterations_while_stable);
      }

      std::vector<Finding> findings() const override
      {
        if (!first || exponent < doubtful_exponent)
          return {};
        std::ostringstream text;
        text.precision(3);
        text << "Stability is lost at about t = " << first->time << " s"
             << (first->place.empty() ? "" : ", most at the " + first->place)
             << ": from there on a small disturbance grows, until the end by a "
                "factor of e^"
             << exponent
             << " at least. What the lattice does then depends on disturbances "
                "that the scene does not give: try a small one (a lateral "
                "load, an uneven shape), and compare.";
        return {{Verdict::doubtful, text.str(), first->time, first->place}};
      }

      void save(Records &records) const override
      {
        records.keep(record_name,
                     {first ? 1. : 0.,
                      first ? first->time : 0.,
                      exponent,
                      last_rate,
                      last_look,
                      double(next_look)});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(record_name, 6);
        if (values[0] != 0)
          first = {values[1], ""};
        exponent  = values[2];
        last_rate = values[3];
        last_look = values[4];
        next_look = values[5];
      }

    private:
      /** A disturbance of a 1e-5th part becomes as large as the motion. */
      static constexpr double doubtful_exponent = 11.5;
      /** Newton's iterations between two looks: a look costs as much as about
       * five. */
      static constexpr unsigned long iterations_while_stable   = 400,
                                     iterations_while_unstable = 50;

      /** Largest of the rates looked at (1/s) at which a disturbance grows at
       * step.to; 0: none. */
      double growth_rate(const Evaluation &step)
      {
        const Aside aside(work);
        if (!solver)
          {
            solver.emplace(equations, solver_parameters, work);
            results = equations.make_results();
          }
        // Slower ones do not get far in the whole run.
        double rate = doubtful_exponent / end_time, found = 0;
        State  at_rest = step.to;
        for (Vector *rates : {&*at_rest.velocity, &*at_rest.acceleration})
          rates->assign(rates->size(), 0.);
        State            before  = at_rest;
        const Evaluation instant = Evaluation::step(before, at_rest, step.dt);
        solver->residual(instant, results);
        constexpr double       factor  = 2;
        constexpr unsigned int n_rates = 24;
        for (unsigned int i = 0; i < n_rates && is_negative(instant, rate);
             ++i, rate *= factor)
          found = rate;
        if (found > 0 && !first)
          {
            solver->assemble(instant, results, {1., 0., found * found});
            first = {step.to.time, place_of_softest_mode(*solver)};
          }
        return found;
      }

      bool is_negative(const Evaluation &instant, const double rate)
      {
        solver->assemble(instant, results, {1., 0., rate * rate});
        if (!solver->factorize())
          return false;
        const std::optional<Inertia> inertia = solver->new_inertia();
        return inertia &&
          inertia->negative >
          equations.model().numbering.constraints().n_multipliers();
      }

      const Equations             &equations;
      const SolverParameters       solver_parameters;
      const double                 end_time; ///< s
      Work                        &work;
      std::optional<TangentSolver> solver;
      EvaluationResults            results;
      unsigned long                iterations_now = 0;
      unsigned long                next_look      = iterations_while_stable;
      double                       last_rate      = 0; ///< 1/s
      double                       last_look      = 0; ///< s
      double                       exponent       = 0;
      std::optional<Loss>          first;
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
