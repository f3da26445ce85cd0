#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/order_choice.h>
#include <auxfem/elements/strut_order.h>
#include <auxfem/output/history.h>
#include <auxfem/output/summary.h>
#include <auxfem/output/verdict_limits.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    /**
     * Steps of a search run over those of the run: it finds which instants
     * ask for the highest orders.
     * @tuned judgement
     */
    constexpr double longer_steps = 4;

    /** Search runs with elements of their own. */
    constexpr unsigned int most_searches = 6;

    /** Tells a recorder how far a search run has come. */
    class SearchProgress : public Recorder
    {
    public:
      SearchProgress(const RunPlan &search, Recorder &told)
        : search(search)
        , told(told)
      {}

      void step(const Solution &solution, const StepReport &report) override
      {
        told.search_step(search, solution.state, report);
      }

    private:
      const RunPlan &search;
      Recorder      &told;
    };

    /** The run with fewer steps. */
    RunPlan search_plan(const RunPlan &plan)
    {
      RunPlan search        = plan;
      search.division.order = lowest_chosen_order;
      TimeParameters &time  = search.time;
      if (time.relative_tolerance)
        time.relative_tolerance =
          std::max(*time.relative_tolerance, noticeable_part);
      else
        time.step =
          std::min(longer_steps * time.step,
                   std::max(time.step,
                            time.end_time / n_instants_of_mesh_error));
      return search;
    }

    /** By what the number of elements that all struts have may be multiplied.
     */
    constexpr unsigned int multiples[] =
      {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

    /** Numbers of elements that may gain nothing, one after the other. */
    constexpr unsigned int most_in_vain = 2;

    /** Elements of a strut: the fewest nodes with which its error is allowed,
     * else the smallest error. */
    struct BestElements
    {
      StrutDivision division{lowest_chosen_order, 1};
      double        error = std::numeric_limits<double>::infinity(); ///< J
      bool          is_good_enough = false;
      unsigned int  n_in_vain      = 0;
    };

    /** Tries elements for struts in the motion in which each needs them most.
     */
    class ElementSearch
    {
    public:
      /** @param allowed error (J) of one strut */
      ElementSearch(const LatticeModel &model,
                    const MeshError    &seen,
                    const double        allowed)
        : model(model)
        , seen(seen)
        , allowed(allowed)
        , best(seen.struts().size())
      {}

      /** By MeshError::struts(). */
      const std::vector<BestElements> &find()
      {
        for (const unsigned int multiple : multiples)
          {
            const std::vector<BestElements> before = best;
            for (unsigned int order = lowest_chosen_order;
                 order <= highest_strut_order(model.lattice.dimension);
                 ++order)
              try_division({order, multiple * model.plan.division.n_elements});
            for (std::size_t i = 0; i < best.size(); ++i)
              best[i].n_in_vain =
                best[i].error < before[i].error ? 0 : best[i].n_in_vain + 1;
          }
        return best;
      }

    private:
      void try_division(const StrutDivision &division)
      {
        std::vector<unsigned int> tried;
        for (unsigned int i = 0; i < best.size(); ++i)
          if (best[i].is_good_enough
                ? division.n_inner_nodes() < best[i].division.n_inner_nodes()
                : best[i].n_in_vain < most_in_vain)
            tried.push_back(i);
        const std::vector<double> errors =
          errors_of_division(model, seen, tried, division);
        for (std::size_t k = 0; k < tried.size(); ++k)
          {
            BestElements &best_of_strut = best[tried[k]];
            const bool    is_good       = errors[k] <= allowed;
            // Half the error is no gain: it may be of round-off.
            if (is_good || errors[k] <= best_of_strut.error / 4)
              best_of_strut = {division,
                               errors[k],
                               is_good,
                               best_of_strut.n_in_vain};
          }
      }

      const LatticeModel       &model;
      const MeshError          &seen;
      const double              allowed;
      std::vector<BestElements> best;
    };

    /** Takes the elements that the motion found in @p run asks for, of which
     * each strut has an equal share in the error. */
    void take_divisions(const LatticeRun &run,
                        const MeshError  &error,
                        ChosenElements   &chosen)
    {
      const MPI_Comm communicator = run.model.numbering.layout().communicator();
      const double   n_struts =
                     mpi::sum(double(error.struts().size()), communicator),
                   wanted = std::pow(part_of_tolerance_for_elements *
                                       chosen.report.tolerance,
                                     2) *
        error.largest_energy();
      ElementSearch find(run.model, error, wanted / n_struts);
      const std::vector<BestElements> &found = find.find();
      // Each is counted by one rank, the others have none.
      std::vector<unsigned int> numbers(2 * chosen.divisions.size(), 0);
      double                    sum = 0;
      for (std::size_t i = 0; i < found.size(); ++i)
        {
          const unsigned int strut = error.struts()[i];
          numbers[2 * strut]       = found[i].division.order;
          numbers[2 * strut + 1]   = found[i].division.n_elements;
          sum += found[i].error;
        }
      mpi::max(numbers, communicator, numbers);
      for (unsigned int s = 0; s < chosen.divisions.size(); ++s)
        if (numbers[2 * s] > 0)
          chosen.divisions[s] = {numbers[2 * s], numbers[2 * s + 1]};
      chosen.report.predicted_error =
        std::sqrt(mpi::sum(sum, communicator) / error.largest_energy());
    }

    /**
     * A search run and the elements that it asks for. Returns whether its own
     * are good enough for that.
     */
    bool search_elements(RunPlan         search,
                         const MPI_Comm  communicator,
                         Recorder       &told,
                         ChosenElements &chosen)
    {
      search.elements = chosen;
      LatticeRun run(search, communicator);
      // What ends the run at its begin may not cost a search.
      refuse_columns_of_nothing(search.scene, run.lattice);
      SearchProgress progress(search, told);
      try
        {
          run.run(progress);
        }
      catch (const ComputationError &)
        {
          // What it has seen until then has to do; the run itself will tell.
        }
      const MeshError *const error = run.mesh_error();
      chosen.divisions.assign(run.lattice.struts.size(),
                              {lowest_chosen_order,
                               search.division.n_elements});
      // Nothing moves, or nothing that could be judged.
      if (error != nullptr && error->largest_energy() > 0)
        take_divisions(run, *error, chosen);
      OrderReport &report = chosen.report;
      report.unknowns     = run.model.numbering.layout().n_global();
      report.steps += run.work().steps;
      report.iterations += run.work().iterations;
      report.reached = run.solution.state.time;
      return error == nullptr || error->relative() <= unusable_error;
    }
  } // namespace

  ChosenElements choose_elements(const RunPlan &plan,
                                 const MPI_Comm communicator,
                                 Recorder      &recorder)
  {
    const double   cpu_before = cpu_seconds();
    const RunPlan  search     = search_plan(plan);
    ChosenElements chosen;
    chosen.report.tolerance = *plan.scene.discretization.tolerance;
    for (unsigned int i = 0; i < most_searches; ++i)
      {
        // A motion with large errors asks for the right struts at least.
        const std::vector<StrutDivision> former = chosen.divisions;
        if (search_elements(search, communicator, recorder, chosen) ||
            chosen.divisions == former)
          break;
      }
    chosen.report.cpu_seconds =
      mpi::sum(cpu_seconds() - cpu_before, communicator);
    return chosen;
  }
} // namespace auxfem
