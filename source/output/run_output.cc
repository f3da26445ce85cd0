#include <auxfem/output/console.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/history.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/output/run_output.h>
#include <auxfem/output/vtu_writer.h>
#include <auxfem/time/stopwatch.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>

namespace auxfem
{
  class RunOutput::Implementation
  {
  public:
    Implementation(const Scene      &scene,
                   MPI_Comm          communicator,
                   const StartTimes &start_times);

    void begin(const System &system);
    void write_start(const State &state);
    void write_step(const State &state, const StepReport &report);
    void finish(const System      &system,
                const State       &state,
                const RunTotals   &totals,
                const std::string &exit_state);

    const std::string folder;
    double            seconds = 0;

  private:
    using Clock = std::chrono::steady_clock;

    static double since(const Clock::time_point start)
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }

    void write_row(const State &state);
    void write_graphics(const State &state);
    void show_progress(const State &state, const StepReport &report);

    const Scene     &scene;
    const MPI_Comm   communicator;
    const StartTimes start_times;

    const Clock::time_point start;
    Clock::time_point       first_step;

    std::ofstream            log;
    std::optional<Console>   console; ///< on rank 0
    std::optional<History>   history;
    std::optional<VtuWriter> graphics;
    GraphicsSchedule         schedule;

    /** Times last written (s); none before write_start(). */
    std::optional<double> last_row, last_graphics;
  };

  RunOutput::Implementation::Implementation(const Scene      &scene,
                                            const MPI_Comm    communicator,
                                            const StartTimes &start_times)
    : folder(scene.output.directory)
    , scene(scene)
    , communicator(communicator)
    , start_times(start_times)
    , start(Clock::now())
    , first_step(start)
    , schedule(scene.output.graphics_interval)
  {}

  void RunOutput::Implementation::begin(const System &system)
  {
    // A mistyped probe must not cost the results of an earlier run.
    refuse_columns_of_nothing(scene, system.lattice());

    on_first_rank(communicator, [&]() {
      log = open_run_folder(scene, folder);
      // The pseudo-terminals of mpirun often end in a file.
      const bool is_alone =
        dealii::Utilities::MPI::n_mpi_processes(communicator) == 1;
      console.emplace(std::cout, is_alone ? terminal_width() : 0, log);
    });
    const Counts counts = count(system);
    if (console)
      console->print(overview_text(scene, counts, system.decisions()) + '\n');
    history.emplace(scene, system, folder, communicator);
    if (scene.output.graphics)
      graphics.emplace(scene, system, folder, communicator);
  }

  void RunOutput::Implementation::write_row(const State &state)
  {
    history->write(state);
    last_row = state.time;
  }

  void RunOutput::Implementation::write_graphics(const State &state)
  {
    if (!graphics)
      return;
    graphics->write_struts(state);
    graphics->write_rigid_parts(state);
    graphics->write_connectors(state);
    last_graphics = state.time;
  }

  void RunOutput::Implementation::write_start(const State &state)
  {
    first_step = Clock::now();
    write_row(state);
    write_graphics(state);
  }

  void RunOutput::Implementation::write_step(const State      &state,
                                             const StepReport &report)
  {
    if (state.step % scene.output.history_interval == 0)
      write_row(state);
    else
      history->note(state);
    if (schedule.is_due(state.time))
      write_graphics(state);
    if (console)
      show_progress(state, report);
  }

  void RunOutput::Implementation::show_progress(const State      &state,
                                                const StepReport &report)
  {
    Progress progress;
    progress.step              = state.step;
    progress.time              = state.time;
    progress.end_time          = scene.time.end_time;
    progress.dt                = report.dt;
    progress.iterations        = report.iterations;
    progress.retries           = report.retries;
    progress.relative_residual = report.relative_residual;
    progress.seconds           = since(first_step);
    progress.n_steps           = scene.time.n_steps();

    const EnergyRecord &energies = history->energies();
    if (energies.largest_energy > 0)
      progress.relative_balance = energies.relative(energies.balance);
    console->progress(progress);
  }

  void RunOutput::Implementation::finish(const System      &system,
                                         const State       &state,
                                         const RunTotals   &totals,
                                         const std::string &exit_state)
  {
    if (console)
      console->end_progress();

    const bool completed = exit_state == "completed";
    {
      const Stopwatch watch(seconds);
      if (last_row && last_row != state.time)
        write_row(state);
      if (last_graphics && last_graphics != state.time)
        write_graphics(state);
    }

    Summary summary;
    summary.counts             = count(system);
    summary.totals             = totals;
    summary.totals.wall.output = seconds;
    summary.resources          = gather_resources(start_times,
                                         since(start),
                                         summary.totals.wall,
                                         communicator);
    summary.energies           = history->energies();
    summary.strain             = history->largest_strain();
    summary.largest_rotation =
      dealii::Utilities::MPI::max(history->largest_rotation(), communicator);
    summary.time       = state.time;
    summary.exit_state = exit_state;

    on_first_rank(communicator, [&]() {
      replace_file(folder + "/summary.json", summary_json(scene, summary));
      console->print(closing_text(summary, folder));
      if (!completed)
        console->print_to_log("Reason: " + exit_state);
    });
  }

  RunOutput::RunOutput(const Scene      &scene,
                       const MPI_Comm    communicator,
                       const StartTimes &start)
    : implementation(
        std::make_unique<Implementation>(scene, communicator, start))
  {}

  RunOutput::~RunOutput() = default;

  void RunOutput::begin(const System &system)
  {
    const Stopwatch watch(implementation->seconds);
    implementation->begin(system);
  }

  void RunOutput::write_start(const State &state)
  {
    const Stopwatch watch(implementation->seconds);
    implementation->write_start(state);
  }

  void RunOutput::write_step(const State &state, const StepReport &report)
  {
    const Stopwatch watch(implementation->seconds);
    implementation->write_step(state, report);
  }

  void RunOutput::finish(const System      &system,
                         const State       &state,
                         const RunTotals   &totals,
                         const std::string &exit_state)
  {
    implementation->finish(system, state, totals, exit_state);
  }

  const std::string &RunOutput::folder() const
  {
    return implementation->folder;
  }

  double RunOutput::seconds() const
  {
    return implementation->seconds;
  }

  void print_overview(const Scene &scene, const System &system)
  {
    const Counts counts = count(system);
    if (system.numbering().rank() == 0)
      std::cout << overview_text(scene, counts, system.decisions())
                << std::endl;
  }
} // namespace auxfem
