#include <auxfem/analysis/analysis.h>
#include <auxfem/output/console.h>
#include <auxfem/output/overview.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>
#include <auxfem/study/sweep_table.h>

#include <deal.II/base/mpi.h>

#include <iostream>

namespace auxfem
{
  namespace
  {
    const std::string cases_folder = "/cases";

    std::string case_text(const SweepDefinition          &sweep,
                          const std::vector<std::string> &values)
    {
      std::string text;
      for (std::size_t i = 0; i < values.size(); ++i)
        text +=
          (i > 0 ? ", " : "") + sweep.parameters[i].name() + " = " + values[i];
      return text;
    }
  } // namespace

  std::vector<SweepCase> sweep_cases(const Scene &scene)
  {
    std::vector<std::string> paths;
    for (const SweptParameter &swept : scene.sweep.parameters)
      paths.push_back(swept.path);
    std::vector<SweepCase> cases;
    for (const std::vector<std::string> &values : cases_of(scene.sweep))
      {
        const SceneCase one =
          scene_case(numbered_folder(scene.output.directory + cases_folder,
                                     cases.size() + 1),
                     paths,
                     values);
        try
          {
            scene_of_case(scene, one.overrides);
          }
        catch (const InputError &error)
          {
            throw InputError("The sweep contains a case that is no valid "
                             "scene, with " +
                             case_text(scene.sweep, values) + ":\n" +
                             error.what());
          }
        cases.push_back({values, one});
      }
    return cases;
  }

  namespace
  {
    /** Line on a case that has ended. */
    std::string line_of(const CaseEnd &end, const int signal)
    {
      if (signal != 0)
        return ": interrupted";
      if (end.is_reused)
        return ": from an earlier sweep";
      return end.failure.empty()
        ? ""
        : ": failed, " + end.failure.substr(0, end.failure.find('\n'));
    }

    std::vector<SceneCase> scene_cases(const std::vector<SweepCase> &cases)
    {
      std::vector<SceneCase> list;
      for (const SweepCase &one : cases)
        list.push_back(one.scene_case);
      return list;
    }

    std::string overview(const Scene &scene, const std::size_t n_cases)
    {
      std::string text = heading_text(scene) + "\n\n  Sweep over";
      for (const SweptParameter &swept : scene.sweep.parameters)
        text +=
          (&swept == scene.sweep.parameters.data() ? " " : ", ") + swept.path;
      return text + ": " + std::to_string(n_cases) +
        " cases of Analysis = " + name_of(scene.analysis) + '\n';
    }
  } // namespace

  RunResult run_sweep(const Scene         &scene,
                      const MPI_Comm       communicator,
                      const FolderOptions &options)
  {
    // Errors of the scene must not destroy the results of an earlier run.
    const std::vector<SweepCase> cases = sweep_cases(scene);
    const DeferredSignals        signals;
    std::optional<RunFolder>     files;
    std::optional<Console>       console;
    on_first_rank(communicator, [&]() {
      files.emplace(scene,
                    options.rules,
                    FolderContents{SweepTable::files(), {}});
      console.emplace(std::cout,
                      terminal_width(
                        dealii::Utilities::MPI::n_mpi_processes(communicator)),
                      files->log());
      console->print(overview(scene, cases.size()));
      make_output_subfolder(scene.output.directory + cases_folder);
    });
    std::vector<CaseEnd> ends;
    try
      {
        ends = run_cases(
          scene,
          scene_cases(cases),
          communicator,
          options.rules,
          [&](const std::size_t c, const CaseEnd &end, const int signal) {
            console->print("  " + std::to_string(c + 1) + '/' +
                           std::to_string(cases.size()) + "  " +
                           case_text(scene.sweep, cases[c].values) +
                           line_of(end, signal));
          });
      }
    catch (const Interrupted &)
      {
        if (console)
          console->print("Interrupted. Completed cases are stored in " +
                         scene.output.directory + cases_folder +
                         ". Run the same sweep again to continue.");
        throw;
      }
    RunResult result;
    result.exit_state = "completed";
    SweepTable table(scene);
    on_first_rank(communicator, [&]() {
      for (std::size_t c = 0; c < cases.size(); ++c)
        table.add(results_of(scene, cases[c].scene_case, ends[c]));
      table.write(cases);
      console->print(verdict_text(table.findings()));
      console->print("The table of all cases is " + scene.output.directory +
                     "/sweep.csv");
    });
    result.findings = table.findings();
    return result;
  }

  AnalysisEntry sweep_entry()
  {
    return {"sweep",
            "Any analysis for many values of its parameters, with a row of "
            "results for each case.",
            [](const Scene &scene) { return scene.sweep.is_given(); },
            run_sweep,
            nullptr,
            [](const Scene &scene, const MPI_Comm communicator) {
              const std::vector<SweepCase> cases = sweep_cases(scene);
              const Scene                  first =
                scene_of_case(scene, cases.front().scene_case.overrides);
              analysis_of(first).check(first, communicator);
              on_first_rank(communicator, [&]() {
                std::cout << '\n' << overview(scene, cases.size());
                for (const SweepCase &one : cases)
                  std::cout << "    " << case_text(scene.sweep, one.values)
                            << '\n';
                std::cout << std::flush;
              });
            },
            SweepTable::files()};
  }
} // namespace auxfem
