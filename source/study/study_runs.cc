#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/state/interruption.h>
#include <auxfem/study/measured_run.h>
#include <auxfem/study/study_runs.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    /** Outcome of the runs of one rank. */
    struct Outcome
    {
      std::string wrong_input; ///< empty: none
      int         signal = 0;  ///< 0: not interrupted
    };

    void throw_if_any(const std::vector<std::string> &inputs,
                      const std::vector<int>         &signals)
    {
      for (const std::string &message : inputs)
        if (!message.empty())
          throw InputError(message);
      for (const int signal : signals)
        if (signal != 0)
          throw Interrupted(signal);
    }

    std::string text_of(const Json &json)
    {
      return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
  } // namespace

  double PlannedRun::price() const
  {
    // Each step has a fixed cost and a cost per node.
    const double nodes =
      std::ldexp(scene.discretization.order, scene.discretization.refinements);
    return repetitions * scene.time.n_steps() * (0.3 + nodes);
  }

  struct StudyRuns::Task
  {
    const PlannedRun          *planned;
    std::string                key;
    std::optional<MeasuredRun> result;

    unsigned int n_done() const
    {
      return result ? result->repetitions : 0;
    }

    bool is_done() const
    {
      return n_done() >= planned->repetitions;
    }

    double price_left() const
    {
      return is_done()
        ? 0
        : planned->price() * (1 - double(n_done()) / planned->repetitions);
    }
  };

  StudyRuns::StudyRuns(const MPI_Comm     communicator,
                       const std::string &folder,
                       Selection          selection,
                       Listener           listener)
    : communicator(communicator)
    , folder(folder)
    , selection(std::move(selection))
    , listener(std::move(listener))
  {}

  std::vector<MeasuredRun>
  StudyRuns::compute(const std::vector<PlannedRun> &plan)
  {
    const unsigned int n_ranks  = mpi::n_mpi_processes(communicator);
    const bool         by_ranks = n_ranks > 1 && plan.size() >= n_ranks &&
      std::all_of(plan.begin(), plan.end(), [](const PlannedRun &planned) {
                            return planned.repetitions == 1;
                          });

    std::vector<Task> tasks;
    progress       = {};
    progress.total = plan.size();
    price_done = price_in_all = 0;
    for (const PlannedRun &planned : plan)
      {
        tasks.push_back(
          {&planned, key_of(planned.scene, by_ranks ? 1 : n_ranks), {}});
      }
    load_stored_runs(tasks);
    for (const Task &task : tasks)
      price_in_all += task.price_left();
    if (by_ranks)
      compute_side_by_side(tasks);
    else
      compute_in_turn(tasks);

    std::vector<MeasuredRun> results;
    results.reserve(tasks.size());
    for (Task &task : tasks)
      results.push_back(std::move(*task.result));
    return results;
  }

  void StudyRuns::load_stored_runs(std::vector<Task> &tasks) const
  {
    if (folder.empty())
      return;
    Json stored = Json::array();
    on_first_rank(communicator, [&]() {
      for (const Task &task : tasks)
        {
          const auto run = load_run(folder, task.key);
          stored.push_back(run && run->has(selection) ? json_of(*run) : Json());
        }
    });
    stored = Json::parse(broadcast_text(0, text_of(stored), communicator));
    for (std::size_t i = 0; i < tasks.size(); ++i)
      if (!stored[i].is_null())
        tasks[i].result = measured_run_of(stored[i]);
  }

  void StudyRuns::compute_in_turn(std::vector<Task> &tasks)
  {
    unsigned int max_repetitions = 0;
    for (const Task &task : tasks)
      {
        max_repetitions = std::max(max_repetitions, task.planned->repetitions);
        if (task.is_done())
          report(task, /*is_reused=*/true);
      }
    // Rounds spread a temporary slowdown of the machine over all runs.
    for (unsigned int round = 0; round < max_repetitions; ++round)
      for (Task &task : tasks)
        if (!task.is_done() && task.n_done() <= round)
          {
            measure(task, communicator);
            if (task.is_done())
              report(task, /*is_reused=*/false);
          }
  }

  void StudyRuns::compute_side_by_side(std::vector<Task> &tasks)
  {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tasks.size(); ++i)
      if (!tasks[i].result)
        open.push_back(i);
      else
        report(tasks[i], /*is_reused=*/true);
    // The most expensive runs go first, each to the rank with the least load.
    std::stable_sort(open.begin(),
                     open.end(),
                     [&tasks](const std::size_t one, const std::size_t other) {
                       return tasks[one].planned->price() >
                         tasks[other].planned->price();
                     });
    const unsigned int  rank = mpi::this_mpi_process(communicator);
    std::vector<double> load(mpi::n_mpi_processes(communicator), 0);
    std::map<std::size_t, unsigned int> rank_of;
    for (const std::size_t i : open)
      {
        const auto least = std::min_element(load.begin(), load.end());
        *least += tasks[i].planned->price();
        rank_of[i] = least - load.begin();
      }
    price_in_all = load[rank];

    Outcome outcome;
    Json    local_results = Json::object();
    for (const std::size_t i : open)
      {
        if (rank_of[i] != rank || outcome.signal != 0)
          continue;
        try
          {
            measure(tasks[i], MPI_COMM_SELF);
            report(tasks[i], /*is_reused=*/false);
            local_results[std::to_string(i)] = json_of(*tasks[i].result);
          }
        catch (const Interrupted &interruption)
          {
            outcome.signal = interruption.signal();
          }
        catch (const InputError &error)
          {
            outcome.wrong_input = error.what();
          }
      }
    throw_if_any(gather_texts(outcome.wrong_input, communicator),
                 gather_over_ranks<int>({outcome.signal}, communicator));
    for (const std::string &text :
         gather_texts(text_of(local_results), communicator))
      {
        const Json rank_results = Json::parse(text);
        for (const auto &[number, run] : rank_results.items())
          tasks[std::stoul(number)].result = measured_run_of(run);
      }
    for (const auto &[i, by_rank] : rank_of)
      if (by_rank != rank)
        report(tasks[i], /*is_reused=*/false);
  }

  void StudyRuns::measure(Task &task, const MPI_Comm on_ranks)
  {
    const bool is_first_rank = mpi::this_mpi_process(communicator) == 0;
    progress.name            = task.planned->name;
    progress.result.reset();
    const double      before = task.price_left();
    const double      price = task.planned->price() / task.planned->repetitions;
    const MeasuredRun run =
      measure_run(task.planned->scene,
                  on_ranks,
                  selection,
                  [&](const double fraction) {
                    progress.fraction =
                      (price_done + fraction * price) / price_in_all;
                    if (is_first_rank)
                      listener(progress);
                  });
    if (task.result)
      task.result->add_repetition(run);
    else
      task.result = run;
    price_done += before - task.price_left();
    if (!folder.empty() && mpi::this_mpi_process(on_ranks) == 0)
      store_run(folder, task.key, *task.result);
  }

  void StudyRuns::report(const Task &task, const bool is_reused)
  {
    ++progress.number;
    progress.name = task.planned->name;
    progress.fraction =
      price_in_all > 0 ? std::min(1., price_done / price_in_all) : 1;
    progress.result    = task.result;
    progress.is_reused = is_reused;
    if (mpi::this_mpi_process(communicator) == 0)
      listener(progress);
  }
} // namespace auxfem
