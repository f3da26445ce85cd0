#include <auxfem/analysis/analysis.h>
#include <auxfem/output/console.h>
#include <auxfem/output/overview.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>
#include <auxfem/study/measured_run.h>
#include <auxfem/study/sweep_table.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

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
    std::vector<SweepCase> cases;
    for (const std::vector<std::string> &values : cases_of(scene.sweep))
      {
        std::ostringstream folder;
        folder << scene.output.directory << cases_folder << '/';
        folder.width(4);
        folder.fill('0');
        folder << cases.size() + 1;
        std::vector<std::string> overrides = {"Output/Directory=" +
                                              folder.str()};
        for (std::size_t i = 0; i < values.size(); ++i)
          overrides.push_back(scene.sweep.parameters[i].path + "=" + values[i]);
        try
          {
            scene_of_case(scene, overrides);
          }
        catch (const InputError &error)
          {
            throw InputError("The sweep contains a case that is no valid "
                             "scene, with " +
                             case_text(scene.sweep, values) + ":\n" +
                             error.what());
          }
        cases.push_back({values, folder.str(), overrides});
      }
    return cases;
  }

  namespace
  {
    std::string key_file(const SweepCase &one)
    {
      return one.folder + ".key";
    }

    /** Whether an earlier sweep has completed the case. */
    bool is_done(const SweepCase &one, const Scene &scene)
    {
      return contents(key_file(one)) == key_of(scene, 1) &&
        !summary_in(one.folder).is_null();
    }

    /** Keeps the screen for the lines of the sweep. */
    class Silence
    {
    public:
      Silence() : screen(std::cout.rdbuf(nullptr))
      {}

      ~Silence()
      {
        std::cout.rdbuf(screen);
        std::cout.clear();
      }

      Silence(const Silence &)            = delete;
      Silence &operator=(const Silence &) = delete;

    private:
      std::streambuf *const screen;
    };

    /** Computes a case; returns the reason of a failure, or nothing. */
    std::string compute(const SweepCase &one,
                        const Scene     &scene,
                        const MPI_Comm   communicator,
                        const FileRules &rules)
    {
      const Silence silence;
      try
        {
          analysis_of(scene).run(scene, communicator, {rules, {}, {}});
          on_first_rank(communicator, [&]() {
            replace_file(key_file(one), key_of(scene, 1));
          });
          return "";
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      catch (const ComputationError &error)
        {
          return error.what();
        }
    }

    /** Runs the cases; returns the failures by case. */
    std::vector<std::string> compute_all(const Scene                  &scene,
                                         const std::vector<SweepCase> &cases,
                                         const MPI_Comm   communicator,
                                         const FileRules &rules,
                                         Console         *console)
    {
      const unsigned int n_ranks     = mpi::n_mpi_processes(communicator),
                         rank        = mpi::this_mpi_process(communicator);
      const bool     is_side_by_side = n_ranks > 1 && cases.size() >= n_ranks;
      const MPI_Comm case_communicator =
        is_side_by_side ? MPI_COMM_SELF : communicator;
      std::vector<std::string> failures(cases.size());
      int                      signal = 0;
      for (std::size_t c = 0; c < cases.size() && signal == 0; ++c)
        {
          if (is_side_by_side && c % n_ranks != rank)
            continue;
          const SweepCase &one          = cases[c];
          const Scene      scene_of_one = scene_of_case(scene, one.overrides);
          bool             reused       = false;
          try
            {
              on_first_rank(case_communicator,
                            [&]() { reused = is_done(one, scene_of_one); });
              reused = mpi::max(int(reused), case_communicator);
              if (!reused)
                failures[c] =
                  compute(one, scene_of_one, case_communicator, rules);
            }
          catch (const Interrupted &interruption)
            {
              signal = interruption.signal();
            }
          if (console != nullptr)
            console->print("  " + std::to_string(c + 1) + '/' +
                           std::to_string(cases.size()) + "  " +
                           case_text(scene.sweep, one.values) +
                           (signal != 0             ? ": interrupted"
                              : reused              ? ": from an earlier sweep"
                              : failures[c].empty() ? ""
                                                    : ": failed, " +
                                failures[c].substr(0, failures[c].find('\n'))));
        }
      signal = mpi::max(signal, communicator);
      if (signal != 0)
        throw Interrupted(signal);
      if (is_side_by_side)
        for (std::size_t c = 0; c < cases.size(); ++c)
          failures[c] = broadcast_text(c % n_ranks, failures[c], communicator);
      return failures;
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
                      terminal_width(mpi::n_mpi_processes(communicator)),
                      files->log());
      console->print(overview(scene, cases.size()));
      make_output_subfolder(scene.output.directory + cases_folder);
    });
    std::vector<std::string> failures;
    try
      {
        failures = compute_all(scene,
                               cases,
                               communicator,
                               options.rules,
                               console ? &*console : nullptr);
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
        table.add(cases[c], failures[c]);
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
              const Scene first = scene_of_case(scene, cases.front().overrides);
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
