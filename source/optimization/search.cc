#include <auxfem/optimization/direct_derivatives.h>
#include <auxfem/optimization/search.h>
#include <auxfem/state/interruption.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <exception>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    /**
     * Difference step of runs for methods that use derivatives, as a part of
     * the ranges.
     * @tuned balances truncation and errors of Newton's iteration
     */
    constexpr double gradient_step = 1e-4;

    /** The problem of a search as functions for NLopt. */
    class SearchProblem
    {
    public:
      SearchProblem(const Scene      &scene,
                    const SearchTask &task,
                    DesignRuns       &runs)
        : optimization(scene.optimization)
        , task(task)
        , runs(runs)
        , best(runs.at(task.start))
      {}

      bool has_constraints() const
      {
        return !optimization.limits.empty() || task.other_merit;
      }

      /** Searches with @p method; returns whether it was cut short. */
      bool search(const SearchMethod &method)
      {
        nlopt::opt optimizer =
          make_optimizer(method,
                         task.start.size(),
                         {optimization.first_step, optimization.tolerance},
                         has_constraints());
        optimizer.set_maxeval(optimization.n_evaluations);
        n_tried = 0;
        optimizer.set_min_objective(objective, this);
        std::vector<Constraint> constraints;
        constraints.reserve(optimization.limits.size());
        for (unsigned int i = 0; i < optimization.limits.size(); ++i)
          {
            constraints.push_back({this, i});
            optimizer.add_inequality_constraint(
              limit,
              &constraints.back(),
              optimization.constraint_tolerance());
          }
        if (task.other_merit)
          optimizer.add_inequality_constraint(other_objective,
                                              this,
                                              optimization.tolerance);
        nlopt::srand(optimization.seed);
        return optimize(optimizer);
      }

    private:
      struct Constraint
      {
        SearchProblem *problem;
        unsigned int   i;
      };

      bool optimize(nlopt::opt &optimizer)
      {
        DesignPoint point(best.point);
        double      merit = 0;
        try
          {
            return optimizer.optimize(point, merit) == nlopt::MAXEVAL_REACHED;
          }
        catch (const nlopt::forced_stop &)
          {
            if (failure)
              std::rethrow_exception(failure);
            return true;
          }
        catch (const nlopt::roundoff_limited &)
          {
            return false; // nothing better within round-off
          }
        catch (const std::exception &)
          {
            // A method may fail near a corner; its best design remains.
            return false;
          }
      }

      /** Value of @p function at the design of @p point, with its gradient if
       * @p gradient is not empty. */
      template <class Function>
      double evaluate(const DesignPoint   &point,
                      std::vector<double> &gradient,
                      const Function      &function)
      {
        try
          {
            const Design &design = runs.at(point);
            if (!design.is_usable())
              {
                std::fill(gradient.begin(), gradient.end(), 0.);
                return worst + 1;
              }
            const double value = function(*design.goals);
            if (is_better(design,
                          best,
                          runs.goals(),
                          optimization.constraint_tolerance(),
                          task.objective) &&
                meets_other_merit(design))
              best = design;
            if (!gradient.empty())
              differentiate(point, *design.goals, gradient, function);
            return value;
          }
        catch (...)
          {
            // NLopt would replace the exception by one of its own.
            failure = std::current_exception();
            throw nlopt::forced_stop();
          }
      }

      bool meets_other_merit(const Design &design)
      {
        return !task.other_merit ||
          runs.goals().merit(*design.goals, 1 - task.objective) <=
          *task.other_merit + optimization.tolerance;
      }

      /** Chain rule: functions are linear in the values. */
      template <class Function>
      void differentiate(const DesignPoint   &point,
                         const GoalValues    &values,
                         std::vector<double> &gradient,
                         const Function      &function)
      {
        // Objective and constraints ask for them one after the other.
        if (differentiated_point != point)
          {
            derivatives          = derivatives_at(runs, point, gradient_step);
            differentiated_point = point;
          }
        for (std::size_t v = 0; v < gradient.size(); ++v)
          {
            gradient[v] = 0;
            if (!derivatives[v])
              continue;
            GoalValues moved(values);
            const auto move = [](std::vector<double>       &list,
                                 const std::vector<double> &change) {
              for (std::size_t i = 0; i < list.size(); ++i)
                list[i] += change[i];
            };
            move(moved.objectives, derivatives[v]->objectives);
            move(moved.limited, derivatives[v]->limited);
            move(moved.limits, derivatives[v]->limits);
            gradient[v] = function(moved) - function(values);
          }
      }

      static double objective(const std::vector<double> &point,
                              std::vector<double>       &gradient,
                              void                      *data)
      {
        auto &problem = *static_cast<SearchProblem *>(data);
        // NLopt does not count what methods within others try.
        if (++problem.n_tried > problem.optimization.n_evaluations)
          throw nlopt::forced_stop();
        const double value =
          problem
            .evaluate(point, gradient, [&problem](const GoalValues &values) {
              return problem.runs.goals().merit(values, problem.task.objective);
            });
        problem.worst = std::max(problem.worst, value);
        return value;
      }

      static double limit(const std::vector<double> &point,
                          std::vector<double>       &gradient,
                          void                      *data)
      {
        const auto &constraint = *static_cast<Constraint *>(data);
        auto       &problem    = *constraint.problem;
        return problem.evaluate(
          point,
          gradient,
          [&problem, &constraint](const GoalValues &values) {
            return problem.runs.goals().excess(values, constraint.i);
          });
      }

      static double other_objective(const std::vector<double> &point,
                                    std::vector<double>       &gradient,
                                    void                      *data)
      {
        auto &problem = *static_cast<SearchProblem *>(data);
        return problem
          .evaluate(point, gradient, [&problem](const GoalValues &values) {
            return problem.runs.goals().merit(values,
                                              1 - problem.task.objective) -
              *problem.task.other_merit;
          });
      }

      const OptimizationDefinition &optimization;
      const SearchTask             &task;
      DesignRuns                   &runs;
      Design                        best;
      /** Derivatives at the last point where they were needed. */
      Derivatives derivatives;
      DesignPoint differentiated_point;
      /** Number of designs that the method has tried. */
      unsigned int n_tried = 0;
      /** Largest merit so far. */
      double             worst   = 1;
      std::exception_ptr failure = nullptr;
    };
  } // namespace

  SearchResult run_search(const Scene               &scene,
                          const SearchTask          &task,
                          Goals                     &goals,
                          const MPI_Comm             communicator,
                          const FileRules           &rules,
                          const std::vector<Design> &known,
                          const DesignListener      &listener)
  {
    DesignRuns
      runs(scene, goals, communicator, rules, task.folder, known, listener);
    SearchProblem problem(scene, task, runs);
    SearchResult  result;
    for (const SearchMethod &method :
         chosen_methods(scene.optimization, problem.has_constraints()))
      // A global method goes on until it is cut short.
      result.is_cut_short = problem.search(method) && !method.is_global;
    result.designs = runs.designs();
    return result;
  }

  namespace
  {
    Json json_of(const SearchResult &result)
    {
      Json json = {{"is_cut_short", result.is_cut_short},
                   {"designs", Json::array()}};
      for (const Design &design : result.designs)
        json["designs"].push_back(json_of(design));
      return json;
    }

    SearchResult search_result_of(const Json &json)
    {
      SearchResult result;
      result.is_cut_short = json.at("is_cut_short");
      for (const Json &design : json.at("designs"))
        result.designs.push_back(design_of(design));
      return result;
    }
  } // namespace

  std::vector<SearchResult> run_searches(const Scene                   &scene,
                                         const std::vector<SearchTask> &tasks,
                                         Goals                         &goals,
                                         const MPI_Comm   communicator,
                                         const FileRules &rules,
                                         const std::vector<Design> &known,
                                         const DesignListener      &listener)
  {
    const unsigned int n_ranks = mpi::n_mpi_processes(communicator),
                       rank    = mpi::this_mpi_process(communicator);
    const bool is_side_by_side = n_ranks > 1 && tasks.size() >= n_ranks;
    std::vector<SearchResult> results(tasks.size());
    int                       signal = 0;
    for (std::size_t t = 0; t < tasks.size() && signal == 0; ++t)
      if (!is_side_by_side || t % n_ranks == rank)
        try
          {
            results[t] = run_search(
              scene,
              tasks[t],
              goals,
              is_side_by_side ? MPI_COMM_SELF : communicator,
              rules,
              known,
              rank == 0 ? listener : [](const Design &) {});
          }
        catch (const Interrupted &interruption)
          {
            signal = interruption.signal();
          }
    signal = mpi::max(signal, communicator);
    if (signal != 0)
      throw Interrupted(signal);
    if (is_side_by_side)
      for (std::size_t t = 0; t < tasks.size(); ++t)
        results[t] = search_result_of(Json::parse(
          broadcast_text(t % n_ranks,
                         t % n_ranks == rank ? json_of(results[t]).dump() : "",
                         communicator)));
    return results;
  }
} // namespace auxfem
