#include <auxfem/analysis/kinematics_choice.h>
#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/mesh_error.h>
#include <auxfem/analysis/mesh_error_recorder.h>
#include <auxfem/analysis/order_choice.h>
#include <auxfem/elements/strut_order.h>
#include <auxfem/output/history.h>
#include <auxfem/output/summary.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace auxfem
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    /**
     * Which instants ask for the highest orders is seen well enough with errors
     * of elements, steps and iterations that a result must not have.
     */
    constexpr double       longer_steps = 4, fewest_steps = 64;
    constexpr double       loose_tolerance      = 1e-2; ///< of steps
    constexpr double       loose_residual       = 1e-4; ///< of Newton's method
    constexpr unsigned int first_search_order   = 2;
    constexpr double       largest_search_error = 0.2; ///< of elements

    /** What is aimed at of the tolerance, as the run will differ from the
     * search. */
    constexpr double aim = 0.5;

    /** Tells a recorder how far a search run has come. */
    class SearchProgress : public Recorder
    {
    public:
      SearchProgress(const Scene &search, Recorder &told)
        : search(search)
        , told(told)
      {}

      void step(const Solution &solution, const StepReport &report) override
      {
        told.search_step(search, solution.state, report);
      }

    private:
      const Scene &search;
      Recorder    &told;
    };

    Scene search_scene(const Scene &scene, const unsigned int order)
    {
      Scene search                = with_orders(scene, {});
      search.discretization.order = order;
      search.newton.tolerance =
        std::max(scene.newton.tolerance, loose_residual);
      TimeParameters &time = search.time;
      if (time.relative_tolerance)
        time.relative_tolerance =
          std::max(*time.relative_tolerance, loose_tolerance);
      else
        time.step = std::min(longer_steps * time.step,
                             std::max(time.step, time.end_time / fewest_steps));
      return search;
    }

    /** Errors (J) of this rank's struts, by order and strut. */
    using ErrorTable = std::map<unsigned int, std::vector<double>>;

    /** The lowest order of strut @p i with no more error than @p allowed, else
     * that with the smallest. */
    unsigned int lowest_order(const ErrorTable  &table,
                              const unsigned int i,
                              const double       allowed)
    {
      unsigned int best = table.begin()->first;
      for (const auto &[order, errors] : table)
        {
          if (errors[i] <= allowed)
            return order;
          // Also where no order has an error that can be found.
          if (errors[i] <= table.at(best)[i])
            best = order;
        }
      return best;
    }

    /** Sum of the errors (J) of all ranks' struts, none allowed more than @p allowed. */
    double sum_of_errors(const ErrorTable  &table,
                         const unsigned int n_struts,
                         const double       allowed,
                         const MPI_Comm     communicator)
    {
      double sum = 0;
      for (unsigned int i = 0; i < n_struts; ++i)
        sum += table.at(lowest_order(table, i, allowed))[i];
      return mpi::sum(sum, communicator);
    }

    /**
     * The largest error (J) that one strut may have if all add up to @p wanted:
     * equal shares cost least where a higher order reduces errors alike. Found
     * to a hundredth only: struts whose errors differ by rounding get equal
     * orders, so that symmetric lattices stay so.
     */
    double allowed_error(const ErrorTable  &table,
                         const unsigned int n_struts,
                         const double       wanted,
                         const MPI_Comm     communicator)
    {
      double low = std::log(wanted) - 50, high = std::log(wanted);
      if (sum_of_errors(table, n_struts, wanted, communicator) <= wanted)
        return wanted;
      for (unsigned int i = 0; i < 12; ++i)
        {
          const double middle = (low + high) / 2;
          (sum_of_errors(table, n_struts, std::exp(middle), communicator) <=
               wanted
             ? low
             : high)          = middle;
        }
      return std::exp(low);
    }

    ErrorTable table_of(const Scene      &scene,
                        const LatticeRun &run,
                        const MeshError  &error,
                        const double      wanted)
    {
      ErrorTable table;
      for (unsigned int order = lowest_chosen_order;
           order <= highest_strut_order(run.lattice.dimension);
           ++order)
        {
          const std::vector<double> &of_order = table[order] =
            errors_of_order(scene, run.model, error.most_demanding(), order);
          double sum = 0;
          for (const double of_strut : of_order)
            sum += of_strut;
          // No strut needs more if none has more than its share.
          if (mpi::sum(sum, run.model.numbering.layout().communicator()) <=
              wanted / 100)
            break;
        }
      return table;
    }

    /** Takes the orders that the motion found in @p run asks for. */
    void take_orders(const Scene      &search,
                     const LatticeRun &run,
                     const MeshError  &error,
                     ChosenOrders     &chosen)
    {
      const MPI_Comm communicator = run.model.numbering.layout().communicator();
      const std::vector<unsigned int> &struts = error.struts();
      const double                     wanted =
        std::pow(aim * chosen.report.tolerance, 2) * error.largest_energy();
      const ErrorTable table = table_of(search, run, error, wanted);
      const double     allowed =
        allowed_error(table, struts.size(), wanted, communicator);
      chosen.orders.assign(run.lattice.struts.size(), 0);
      for (unsigned int i = 0; i < struts.size(); ++i)
        chosen.orders[struts[i]] = lowest_order(table, i, allowed);
      mpi::max(chosen.orders, communicator, chosen.orders);
      for (unsigned int &order : chosen.orders)
        order = std::max(order, lowest_chosen_order);
      chosen.report.predicted_error =
        std::sqrt(sum_of_errors(table, struts.size(), allowed, communicator) /
                  error.largest_energy());
    }

    /**
     * A search run and the orders that it asks for. Returns whether its own
     * elements are good enough for that.
     */
    bool search_orders(const Scene   &search,
                       const MPI_Comm communicator,
                       Recorder      &told,
                       ChosenOrders  &chosen)
    {
      LatticeRun run(search, communicator);
      // What ends the run at its begin may not cost a search.
      refuse_columns_of_nothing(search, run.lattice);
      SearchProgress    progress(search, told);
      MeshErrorRecorder recorder(search, progress);
      try
        {
          run.run(recorder);
        }
      catch (const ComputationError &)
        {
          // What it has seen until then has to do; the run itself will tell.
        }
      const MeshError *const error = recorder.error();
      chosen.orders.assign(run.lattice.struts.size(), lowest_chosen_order);
      // Nothing moves, or nothing that could be judged.
      if (error != nullptr && error->largest_energy() > 0)
        take_orders(search, run, *error, chosen);
      OrderReport &report = chosen.report;
      report.unknowns     = run.model.numbering.layout().n_global();
      report.steps += run.work().steps;
      report.iterations += run.work().iterations;
      report.reached = run.solution.state.time;
      return error == nullptr || error->relative() <= largest_search_error;
    }
    const std::string order_record  = "orders of the struts",
                      report_record = "search of the orders of the struts";

    /** Keeps what was chosen with every checkpoint. */
    class OrderRecorder : public ForwardingRecorder
    {
    public:
      OrderRecorder(const ChosenOrders &chosen, Recorder &recorder)
        : ForwardingRecorder(recorder)
        , chosen(chosen)
      {}

      void save(Records &records) const override
      {
        const OrderReport &report = chosen.report;
        records.keep(order_record,
                     {chosen.orders.begin(), chosen.orders.end()});
        records.keep(report_record,
                     {report.tolerance,
                      report.predicted_error,
                      double(report.unknowns),
                      double(report.steps),
                      double(report.iterations),
                      report.cpu_seconds,
                      report.reached});
        ForwardingRecorder::save(records);
      }

    private:
      const ChosenOrders &chosen;
    };

    ChosenOrders saved_orders(const Records &records)
    {
      const std::vector<double> orders =
        records.values(order_record, records.values_per_item(order_record));
      const std::vector<double> values = records.values(report_record, 7);
      ChosenOrders              chosen;
      chosen.orders.assign(orders.begin(), orders.end());
      OrderReport &report    = chosen.report;
      report.tolerance       = values[0];
      report.predicted_error = values[1];
      report.unknowns        = values[2];
      report.steps           = values[3];
      report.iterations      = values[4];
      report.cpu_seconds     = values[5];
      report.reached         = values[6];
      return chosen;
    }
  } // namespace

  Scene with_orders(const Scene &scene, const std::vector<unsigned int> &orders)
  {
    Scene result                    = scene;
    result.discretization.tolerance = std::nullopt;
    result.discretization.orders    = orders;
    return result;
  }

  ChosenOrders choose_orders(const Scene   &scene,
                             const MPI_Comm communicator,
                             Recorder      &recorder)
  {
    const double cpu_before = cpu_seconds();
    ChosenOrders chosen;
    chosen.report.tolerance = *scene.discretization.tolerance;
    for (unsigned int order = first_search_order;; ++order)
      if (search_orders(search_scene(scene, order),
                        communicator,
                        recorder,
                        chosen) ||
          order == highest_strut_order(scene.context.dimension))
        break;
    chosen.report.cpu_seconds =
      mpi::sum(cpu_seconds() - cpu_before, communicator);
    return chosen;
  }

  RunResult run_with_chosen_orders(const Scene   &scene,
                                   const MPI_Comm communicator,
                                   Recorder      &recorder)
  {
    const Records *const checkpoint = recorder.goes_on_from();
    const ChosenOrders   found      = checkpoint
             ? saved_orders(*checkpoint)
             : choose_orders(scene, communicator, recorder);
    const Scene          chosen     = with_orders(scene, found.orders);
    OrderRecorder        keeping(found, recorder);
    MeshErrorRecorder    watching(chosen, keeping, found.report);
    return watching.completed(
      run_with_chosen_kinematics(chosen, communicator, watching));
  }
} // namespace auxfem
