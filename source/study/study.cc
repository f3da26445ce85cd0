#include <auxfem/analysis/analysis.h>
#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/overview.h>
#include <auxfem/parameters/registry.h>
#include <auxfem/state/interruption.h>
#include <auxfem/study/study.h>
#include <auxfem/study/study_report.h>

#include <chrono>
#include <iostream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  const std::vector<StudyKind> &study_registry()
  {
    static const std::vector<StudyKind> registry = {convergence_study(),
                                                    work_precision_study(),
                                                    effects_study()};
    return registry;
  }

  namespace
  {
    const StudyKind &kind_of(const Scene &scene)
    {
      return *find_by_name(study_registry(), scene.study.kind);
    }

    StudyTask task_of(const Scene &scene, const MPI_Comm communicator)
    {
      return {scene,
              compared_quantities(scene, history_columns(scene, communicator))};
    }

    StudyReport report_of(const StudyTask               &task,
                          const std::vector<PlannedRun> &plan,
                          const MPI_Comm                 communicator,
                          const std::string             &folder,
                          const StudyRuns::Listener     &listener)
    {
      StudyRuns runs(communicator,
                     folder,
                     selection_for(task.quantities, task.scene.time.end_time),
                     listener);
      return kind_of(task.scene).report(task, runs.compute(plan), runs);
    }

    std::string plural(const std::size_t n, const std::string &word)
    {
      return std::to_string(n) + " " + word + (n == 1 ? "" : "s");
    }

    /** Lines printed before the first simulation. */
    std::string overview(const StudyTask               &task,
                         const std::vector<PlannedRun> &plan)
    {
      std::string text = heading_text(task.scene) +
        "\n\n  Study: " + task.scene.study.kind + ", " +
        plural(plan.size(), "simulation") + "\n  Compared by:";
      for (const QuantityDefinition &quantity : task.quantities)
        text +=
          (&quantity == task.quantities.data() ? " " : ", ") + quantity.name;
      return text + '\n';
    }

    /** Console output and log of a study. */
    class StudyLines
    {
    public:
      StudyLines(const unsigned int n_processes, std::ostream &log)
        : console(std::cout, terminal_width(n_processes), log)
        , start(Clock::now())
      {}

      void print(const std::string &text)
      {
        console.print(text);
      }

      void show(const StudyProgress &progress)
      {
        std::ostringstream line;
        if (progress.result)
          {
            const MeasuredRun &run = *progress.result;
            line << "  " << progress.number << '/' << progress.total << "  "
                 << progress.name << ": "
                 << (!run.completed() ? "failed" : name_of(run.verdict)) << ", "
                 << seconds_text(run.cpu_seconds) << " CPU s"
                 << (progress.is_reused ? ", from an earlier study here" : "");
            if (progress.fraction < 1 && !progress.is_reused)
              line << ", left " << time_left(progress.fraction);
            console.print(line.str());
          }
        else
          {
            line << "  " << progress.number + 1 << '/' << progress.total << "  "
                 << progress.name << ", whole study "
                 << static_cast<int>(100 * progress.fraction) << " %, left "
                 << time_left(progress.fraction);
            console.show(line.str());
          }
      }

    private:
      using Clock = std::chrono::steady_clock;

      std::string time_left(const double fraction) const
      {
        const double elapsed =
          std::chrono::duration<double>(Clock::now() - start).count();
        return format_duration(elapsed * (1 - fraction) / fraction);
      }

      Console                 console;
      const Clock::time_point start;
    };

    /**
     * Draws all pictures and reports failures; returns Markdown with the
     * pictures.
     */
    std::string draw_pictures(const StudyReport &report,
                              const std::string &folder,
                              StudyLines        &lines)
    {
      std::string text;
      for (const LogPicture &picture : report.pictures)
        if (draw_picture(picture, folder))
          text += "![" + picture.title + "](" + picture.name + ".svg)\n\n";
        else
          lines.print("  Not drawn, because gnuplot is missing or failed: " +
                      picture.name + ".gnuplot");
      return text;
    }

    void write(const StudyReport &report,
               const StudyTask   &task,
               const std::string &folder,
               StudyLines        &lines)
    {
      CsvTable table(folder + "/study.csv", report.columns);
      for (const std::vector<std::string> &row : report.rows)
        table.append_text(row);
      write_column_reference(folder + "/study.units.csv", report.columns);
      const std::string heading = "# " +
        (task.scene.title.empty() ? task.scene.file : task.scene.title) + ": " +
        task.scene.study.kind + "\n\n";
      replace_file(folder + "/study.md",
                   heading + report.text + '\n' +
                     draw_pictures(report, folder, lines));
      lines.print('\n' + report.text);
      lines.print(verdict_text(report.findings));
      lines.print("Tables and pictures are in " + folder +
                  "/study.md, all numbers in study.csv");
    }

    const std::string runs_folder = "/runs";
  } // namespace

  std::vector<std::string> study_files()
  {
    std::vector<std::string> files = {"study.md",
                                      "study.csv",
                                      "study.units.csv"};
    for (const StudyKind &kind : study_registry())
      for (const std::string &picture : kind.pictures)
        for (const std::string &file : picture_files(picture))
          files.push_back(file);
    return files;
  }

  StudyReport compute_study(const Scene               &scene,
                            const MPI_Comm             communicator,
                            const std::string         &folder,
                            const StudyRuns::Listener &listener)
  {
    const StudyTask task = task_of(scene, communicator);
    return report_of(task,
                     kind_of(task.scene).plan(task),
                     communicator,
                     folder,
                     listener);
  }

  RunResult run_study(const Scene         &scene,
                      const MPI_Comm       communicator,
                      const FolderOptions &options)
  {
    // Errors of the scene must not destroy the results of an earlier run.
    const StudyTask               task = task_of(scene, communicator);
    const std::vector<PlannedRun> plan = kind_of(task.scene).plan(task);

    const std::string        &folder = scene.output.directory;
    const DeferredSignals     signals;
    std::optional<RunFolder>  files;
    std::optional<StudyLines> lines;
    on_first_rank(communicator, [&]() {
      files.emplace(scene, options.rules, FolderContents{study_files(), {}});
      lines.emplace(dealii::Utilities::MPI::n_mpi_processes(communicator),
                    files->log());
      lines->print(overview(task, plan));
    });
    StudyReport report;
    try
      {
        report = report_of(task,
                           plan,
                           communicator,
                           folder + runs_folder,
                           [&lines](const StudyProgress &progress) {
                             lines->show(progress);
                           });
      }
    catch (const Interrupted &)
      {
        if (lines)
          lines->print("Interrupted. Completed simulations are stored in " +
                       folder + runs_folder +
                       ". Run the same study again to continue.");
        throw;
      }
    on_first_rank(communicator, [&]() { write(report, task, folder, *lines); });
    RunResult result;
    result.exit_state = "completed";
    result.time       = scene.time.end_time;
    result.findings   = report.findings;
    return result;
  }

  void check_study(const Scene &scene, const MPI_Comm communicator)
  {
    const Scene simulated = scene_with(scene, {});
    analysis_of(simulated).check(simulated, communicator);
    const StudyTask               task = task_of(scene, communicator);
    const std::vector<PlannedRun> plan = kind_of(task.scene).plan(task);
    on_first_rank(communicator, [&]() {
      std::cout << '\n' << overview(task, plan);
      for (const PlannedRun &run : plan)
        std::cout << "    " << run.name << '\n';
      std::cout << std::flush;
    });
  }

  AnalysisEntry study_entry()
  {
    return {"study",
            "Many simulations of a scene: what accuracy costs, which steps and "
            "meshes are good enough, which effects matter.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::study;
            },
            run_study,
            nullptr,
            check_study,
            study_files()};
  }
} // namespace auxfem
