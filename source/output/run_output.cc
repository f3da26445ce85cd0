#include <auxfem/output/console.h>
#include <auxfem/output/figure_files.h>
#include <auxfem/output/history.h>
#include <auxfem/output/member_forces.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/run_checkpoints.h>
#include <auxfem/output/run_files.h>
#include <auxfem/output/run_output.h>
#include <auxfem/output/singular_point_files.h>
#include <auxfem/output/verdict.h>
#include <auxfem/output/vtu_writer.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/state/interruption.h>
#include <auxfem/state/step_report.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

namespace auxfem
{
  namespace
  {
    const std::string length_record = "output: length of history.csv";

    Progress progress_of(const TimeParameters &time,
                         const State          &state,
                         const StepReport     &report)
    {
      Progress progress;
      progress.step              = state.step;
      progress.n_steps           = time.n_steps();
      progress.time              = state.time;
      progress.end_time          = time.end_time;
      progress.dt                = report.dt;
      progress.iterations        = report.iterations;
      progress.retries           = report.retries;
      progress.relative_residual = report.relative_residual;
      progress.path              = state.path;
      return progress;
    }

    /** The smaller one of the times that are given. */
    std::optional<double> earlier(const std::optional<double> one,
                                  const std::optional<double> other)
    {
      return one && other ? std::min(*one, *other) : one ? one : other;
    }

    /** Recorder of make_run_output(). */
    class RunOutput : public Recorder
    {
    public:
      RunOutput(const Scene         &scene,
                const MPI_Comm       communicator,
                const FolderOptions &options)
        : folder(scene.output.directory)
        , restored_checkpoint(options.checkpoint)
        , scene(scene)
        , communicator(communicator)
        , start_times(options.start)
        , rules(options.rules)
        , construction_time(Clock::now())
        , first_step(construction_time)
        , row_times(scene.output.row_interval, step_end_tolerance(scene.time))
        , graphics_times(frame_interval(scene), step_end_tolerance(scene.time))
      {}

      void search_step(const RunPlan    &search,
                       const State      &state,
                       const StepReport &report) override
      {
        const unsigned int n_processes =
          dealii::Utilities::MPI::n_mpi_processes(communicator);
        if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
          return;
        if (state.step == 1)
          {
            search_console.emplace(std::cout,
                                   terminal_width(n_processes),
                                   null_stream);
            search_console->print("Search for the elements of the struts:");
            first_search_step = Clock::now();
          }
        Progress progress = progress_of(search.time, state, report);
        progress.seconds  = since(first_search_step);
        search_console->progress(progress);
      }

      void begin(const Equations &equations) override
      {
        const Stopwatch watch(seconds);
        search_console.reset();
        // A mistyped probe must not destroy the results of an earlier run.
        require_existing_columns(scene, equations.model().lattice);
        history.emplace(scene, equations, communicator);
        require_columns(scene.figures, names_of(history->columns()));
        require_quantities(scene, names_of(history->columns()));

        on_first_rank(communicator, [&]() {
          if (console) // A repeated run continues the same log.
            return console->end_progress();
          files.emplace(scene,
                        rules,
                        further_contents(scene),
                        restored_checkpoint ? FormerResults::continued
                                            : FormerResults::removed);
          console.emplace(std::cout,
                          terminal_width(
                            dealii::Utilities::MPI::n_mpi_processes(
                              communicator)),
                          files->log());
        });
        signals.emplace();
        const Counts counts = count(equations);
        if (console)
          {
            notes = notes_on(equations);
            console->print(
              overview_text(scene,
                            counts,
                            equations.model().plan.simulated.decisions,
                            notes) +
              '\n');
          }
        this->equations = &equations;
        last_row.reset();
        last_graphics.reset();
        open_files();
      }

      void start(const Solution &solution) override
      {
        const Stopwatch watch(seconds);
        first_step = Clock::now();
        write_row(solution);
        write_graphics(solution);
      }

      /** Removes rows and files later than a restored checkpoint. */
      void serialize(const Solution    &solution,
                     CheckpointArchive &archive) override
      {
        const Stopwatch watch(seconds);
        if (!archive.is_saving())
          resume(solution.state);
        history->serialize(solution.state, archive);
        double length = table ? table->length() : 0;
        archive.values("output: times of the last row and graphics",
                       last_row,
                       last_graphics);
        archive.values(length_record, length);
        if (singular_points)
          singular_points->serialize(archive);
        if (members)
          members->serialize(archive);
        if (graphics)
          graphics->serialize(archive);
        // A repetition of a resumed run begins at the start.
        if (!archive.is_saving())
          restored_checkpoint.reset();
      }

      const CheckpointData *restart_checkpoint() const override
      {
        return restored_checkpoint ? &*restored_checkpoint : nullptr;
      }

      void store_checkpoint(CheckpointData checkpoint) override
      {
        if (!checkpoints)
          return;
        const Stopwatch watch(checkpoint_seconds);
        last_checkpoint = std::move(checkpoint);
        if (checkpoints->is_due())
          write_checkpoint();
      }

      void keep_checkpoint() override
      {
        const Stopwatch watch(checkpoint_seconds);
        if (last_checkpoint)
          write_checkpoint();
        is_resumable = has_checkpoint;
      }

      std::optional<double> next_time(const double time) const override
      {
        const std::optional<double> next =
          earlier(row_times.after(time), graphics_times.after(time));
        return members ? earlier(next, members->after(time)) : next;
      }

      void row(const Solution &solution) override
      {
        const Stopwatch watch(seconds);
        if (row_times.has(solution.state.time))
          write_row(solution);
        if (graphics_times.has(solution.state.time))
          write_frame(solution);
        if (members && members->has(solution.state.time))
          members->write(consistent_solution(solution).state);
      }

      void step(const Solution &solution, const StepReport &report) override
      {
        const Stopwatch watch(seconds);
        const State    &state = solution.state;
        if (!scene.output.row_interval &&
            state.step % scene.output.history_interval == 0)
          write_row(solution);
        else
          history->note(state);
        if (state.path && state.step % scene.path.graphics_interval == 0)
          write_graphics(solution);
        if (console)
          show_progress(state, report);
      }

      void singular_point(const Solution      &solution,
                          const SingularPoint &point) override
      {
        const Stopwatch watch(seconds);
        write_row(solution);
        singular_points->write(solution.state, point);
        if (console)
          console->print(
            text_of(solution.state, point, singular_points->number()));
      }

      void finish(const Solution &last, const RunResult &result) override
      {
        if (console)
          console->end_progress();
        {
          const Stopwatch watch(seconds);
          if (last_row && last_row != last.state.time)
            write_row(last);
          if (last_graphics && last_graphics != last.state.time)
            write_graphics(last);
          if (members && members->includes_end())
            members->write(last.state);
        }

        Summary summary;
        summary.counts                  = count(*equations);
        summary.totals                  = result.work;
        summary.totals.wall.output      = seconds;
        summary.totals.wall.checkpoints = checkpoint_seconds;
        summary.resources               = gather_resources(start_times,
                                             since(construction_time),
                                             summary.totals.wall,
                                             communicator);
        summary.energies                = history->energies();
        summary.strain                  = history->largest_strain();
        summary.largest_rotation =
          dealii::Utilities::MPI::max(history->largest_rotation(),
                                      communicator);
        summary.broken              = broken_struts(*equations, last.state);
        summary.broken_connectors   = broken_connectors(*equations, last);
        summary.largest_penetration = result.largest_penetration;
        summary.time                = result.time;
        summary.path                = last.state.path;
        summary.time_error          = result.time_error;
        summary.small_displacement_error = result.small_displacement_error;
        summary.orders                   = result.orders;
        summary.exit_state               = result.exit_state;
        summary.findings                 = result.findings;
        summary.notes                    = notes;
        summary.decisions = equations->model().plan.simulated.decisions;

        CrushGeometry geometry;
        if (scene.figures.crush)
          geometry = crush_geometry(*equations);

        on_first_rank(communicator, [&]() {
          const RecordedTable table = read_table(folder + "/history.csv");
          summary.figures           = figures_of_history(table, geometry);
          summary.quantities        = quantities_in(scene, table);
          summary.quantities_text =
            text_of_quantities(summary.quantities, scene, history->columns());
          replace_file(folder + "/summary.json", summary_json(scene, summary));
          if (equations->model().struts_may_fail())
            replace_file(folder + "/" + broken_struts_table,
                         broken_struts_csv(equations->model().lattice,
                                           summary.broken));
          console->print(closing_text(summary, folder));
          if (!result.completed())
            {
              console->print_to_log("Reason: " + result.exit_state);
              if (is_resumable)
                console->print("To continue: auxfem --resume " + folder);
            }
        });
      }

    private:
      using Clock = std::chrono::steady_clock;

      /** Figures from the rows in the folder, with their files. */
      RunFigures figures_of_history(const RecordedTable &table,
                                    const CrushGeometry &geometry) const
      {
        FiguresDefinition definition = scene.figures;
        definition.options.in_time   = !is_static(scene);
        const RunFigures figures =
          figures_of_run(definition, names_of_bodies(scene), geometry, table);
        write_figures(figures, scene, folder);
        return figures;
      }

      /** Continues the folder of a run at @p state. */
      void resume(const State &state)
      {
        first_step = Clock::now();
        begin_time = state.time;
        if (!console)
          return;
        std::ostringstream text;
        if (state.path)
          text << "Goes on from load factor " << state.path->load_factor
               << ", arc length " << begin_time << " m\n";
        else
          text << "Goes on from t = " << begin_time << " s\n";
        console->print(text.str());
      }

      void write_checkpoint()
      {
        std::vector<std::string> files_before = {folder + "/history.csv"};
        if (graphics)
          for (const std::string &name : graphics->series())
            // The series of contacts may not exist yet.
            if (const std::string record = folder + "/" + name + ".pvd";
                std::filesystem::exists(record))
              files_before.push_back(record);
        if (singular_points)
          for (const std::string &name : singular_points->files())
            files_before.push_back(folder + "/" + name);
        checkpoints->write(std::move(*last_checkpoint), files_before);
        last_checkpoint.reset();
        has_checkpoint = true;
      }

      static double since(const Clock::time_point start)
      {
        return std::chrono::duration<double>(Clock::now() - start).count();
      }

      void write_row(const Solution &solution)
      {
        const std::vector<double> &row = history->values(solution);
        // A row that cannot be written is not retried at the end of the run.
        last_row = solution.state.time;
        on_first_rank(communicator, [&]() { table->append(row); });
      }

      /** @p solution, or if its forces are not those of its motion the nearest
       * end of the step. */
      static const Solution &consistent_solution(const Solution &solution)
      {
        const auto &within = solution.forces_within;
        return !within         ? solution
          : within->part < 0.5 ? *within->from
                               : *within->to;
      }

      void write_frame(const Solution &solution)
      {
        const Solution &consistent = consistent_solution(solution);
        if (last_graphics != consistent.state.time)
          write_graphics(consistent);
      }

      void write_graphics(const Solution &solution)
      {
        if (!graphics)
          return;
        last_graphics = solution.state.time;
        graphics->write_struts(solution.state);
        graphics->write_rigid_parts(solution.state);
        graphics->write_connectors(solution);
        graphics->write_contacts(solution);
      }

      void show_progress(const State &state, const StepReport &report)
      {
        Progress progress   = progress_of(scene.time, state, report);
        progress.seconds    = since(first_step);
        progress.begin_time = begin_time;

        const EnergyRecord &energies = history->energies();
        if (energies.largest_energy > 0)
          progress.relative_balance = energies.relative(energies.balance);
        console->progress(progress);
      }

      void open_files()
      {
        on_first_rank(communicator, [&]() {
          const std::string name = folder + "/history.csv";
          if (restored_checkpoint)
            table.emplace(name,
                          history->columns(),
                          restored_checkpoint->values(length_record, 1)[0]);
          else
            table.emplace(name, history->columns());
          write_column_reference(folder + "/history.units.csv",
                                 history->columns());
        });
        if (scene.output.checkpoints > 0)
          checkpoints.emplace(scene, communicator);
        if (scene.analysis == Analysis::static_path)
          singular_points.emplace(scene,
                                  *equations,
                                  communicator,
                                  restored_checkpoint ? &*restored_checkpoint
                                                      : nullptr);
        if (scene.figures.member_forces)
          members.emplace(scene,
                          *equations,
                          communicator,
                          restored_checkpoint ? &*restored_checkpoint
                                              : nullptr);
        if (scene.output.graphics)
          open_graphics();
      }

      void open_graphics()
      {
        graphics.emplace(scene, *equations, folder, communicator);
        on_first_rank(communicator, [&]() {
          for (const std::string &name : graphics->series())
            files->claim_series(name);
          if (singular_points)
            for (const std::string &name : singular_points->series())
              files->claim_series(name);
        });
      }

      const std::string folder;
      /** Time spent on output, and on checkpoints (s). */
      double seconds = 0, checkpoint_seconds = 0;
      /** Checkpoint from which the run continues, until it is restored. */
      std::optional<CheckpointData> restored_checkpoint;

      const Scene     &scene;
      const MPI_Comm   communicator;
      const StartTimes start_times;
      const FileRules  rules;

      /** Console of a search run on rank 0, without log. */
      ///@{
      std::ostream           null_stream{nullptr};
      std::optional<Console> search_console;
      Clock::time_point      first_search_step;
      ///@}

      const Clock::time_point construction_time;
      Clock::time_point       first_step;
      double                  begin_time = 0; ///< of the first step (s)

      const Equations         *equations = nullptr; ///< from begin() on
      std::vector<std::string> notes;               ///< on rank 0
      /** Delays signals so that open files are completed. */
      std::optional<DeferredSignals> signals;
      std::optional<RunFolder>       files;   ///< on rank 0
      std::optional<Console>         console; ///< on rank 0
      std::optional<History>         history;
      std::optional<CsvTable>        table; ///< on rank 0
      std::optional<VtuWriter>       graphics;
      std::optional<MemberForces>    members;
      std::optional<RunCheckpoints>  checkpoints;
      /** Files of singular points; only on a path of equilibria. */
      std::optional<SingularPointFiles> singular_points;
      /** Latest checkpoint, if it is not written yet. */
      std::optional<CheckpointData> last_checkpoint;
      /**
       * Whether the folder has a checkpoint, and whether a run that ended early
       * can continue from it.
       */
      bool              has_checkpoint = false, is_resumable = false;
      const OutputTimes row_times, graphics_times;

      /** Times of the last row and graphics (s); empty before start(). */
      std::optional<double> last_row, last_graphics;
    };
  } // namespace

  std::unique_ptr<Recorder> make_run_output(const Scene         &scene,
                                            const MPI_Comm       communicator,
                                            const FolderOptions &options)
  {
    return std::make_unique<RunOutput>(scene, communicator, options);
  }
} // namespace auxfem
