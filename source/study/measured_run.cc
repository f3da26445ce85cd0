#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/reduced_cell/cell_run.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/summary.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/parameters/registry.h>
#include <auxfem/state/interruption.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/study/measured_run.h>
#include <auxfem/study/settings.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>

#include <malloc.h>
#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    using Clock = std::chrono::steady_clock;

    const std::string time_column = "time";

    /** Of lattices and of the reduced cell: keeps some columns of the history
     * and some fields, and counts unknowns. */
    class SelectionRecorder : public Recorder
    {
    public:
      SelectionRecorder(const Scene        &scene,
                        const MPI_Comm      communicator,
                        const Selection    &wanted,
                        const FractionDone &progress,
                        MeasuredRun        &run)
        : scene(scene)
        , communicator(communicator)
        , wanted(wanted)
        , progress(progress)
        , run(run)
      {}

      void begin(const Equations &of_run) override
      {
        equations = &of_run;
        if (!wanted.field_times.empty() && of_run.reporting().struts.empty())
          throw InputError(
            "Quantities: energy norms are of elastic struts, which the scene "
            "does not have. Compare columns of history.csv");
        run.unknowns = count(of_run).free_unknowns;
        history.emplace(scene, of_run, communicator);
        choose(history->columns());
      }

      void start(const Solution &solution) override
      {
        keep(history->values(solution));
        keep_fields(solution);
      }

      std::optional<double> next_time(const double time) const override
      {
        const auto next = wanted.field_times.upper_bound(time);
        return next == wanted.field_times.end() ? std::nullopt
                                                : std::optional<double>(*next);
      }

      void between(const Solution &solution) override
      {
        keep_fields(solution);
      }

      void step(const Solution &solution,
                const StepReport & /*report*/) override
      {
        keep(history->values(solution));
      }

      void begin_rows(const std::vector<Column> &columns,
                      const unsigned int         n_unknowns) override
      {
        run.unknowns = n_unknowns;
        choose(columns);
      }

      void row(const std::vector<double> &values) override
      {
        keep(values);
      }

      /** Of which it has been told. */
      unsigned long n_steps() const
      {
        return kept.empty() || kept.front().second->empty()
          ? 0
          : kept.front().second->size() - 1;
      }

    private:
      void choose(const std::vector<Column> &columns)
      {
        const std::vector<std::string> names = names_of(columns);
        for (std::size_t i = 0; i < names.size(); ++i)
          if (names[i] == time_column || wanted.columns.count(names[i]) > 0)
            kept.emplace_back(i, &run.columns[names[i]]);
      }

      void keep(const std::vector<double> &row)
      {
        for (const auto &[column, values] : kept)
          values->push_back(row[column]);
        progress(row.front() / scene.time.end_time);
      }

      void keep_fields(const Solution &solution)
      {
        // Times of steps are products, those that are wanted were read.
        const double round_off = 1e-9 * scene.time.end_time;
        for (const double time : wanted.field_times)
          if (std::abs(solution.state.time - time) <= round_off)
            run.fields[time] = field_of(*equations, solution, communicator);
      }

      const Scene        &scene;
      const MPI_Comm      communicator;
      const Selection    &wanted;
      const FractionDone &progress;
      MeasuredRun        &run;
      const Equations    *equations = nullptr; ///< from begin() on

      std::optional<History>                                     history;
      std::vector<std::pair<std::size_t, std::vector<double> *>> kept;
    };

    /** So that the peak is that of what follows, where the system can do so. */
    void forget_peak_memory()
    {
      malloc_trim(0);
      std::ofstream("/proc/self/clear_refs") << "5";
    }

    /** nlohmann writes what is not finite as null. */
    std::vector<double> numbers_of(const Json &json)
    {
      std::vector<double> numbers;
      numbers.reserve(json.size());
      for (const Json &number : json)
        numbers.push_back(number.is_null()
                            ? std::numeric_limits<double>::quiet_NaN()
                            : number.get<double>());
      return numbers;
    }
  } // namespace



  void MeasuredRun::add_repetition(const MeasuredRun &again)
  {
    cpu_seconds      = std::min(cpu_seconds, again.cpu_seconds);
    wall_seconds     = std::min(wall_seconds, again.wall_seconds);
    most_cpu_seconds = std::max(most_cpu_seconds, again.cpu_seconds);
    ++repetitions;
  }



  std::optional<double> MeasuredRun::spread() const
  {
    if (repetitions == 1 || cpu_seconds <= 0)
      return {};
    return most_cpu_seconds / cpu_seconds - 1;
  }



  bool MeasuredRun::has(const Selection &selection) const
  {
    const auto is_in = [](const auto &kept) {
      return [&kept](const auto &name) { return kept.count(name) > 0; };
    };
    return std::all_of(selection.columns.begin(),
                       selection.columns.end(),
                       is_in(columns)) &&
      std::all_of(selection.field_times.begin(),
                  selection.field_times.end(),
                  is_in(fields));
  }



  RecordedHistory MeasuredRun::history(const std::string &column) const
  {
    return {columns.at(time_column), columns.at(column)};
  }



  Json json_of(const MeasuredRun &run)
  {
    Json json = {{"exit", run.exit_state},
                 {"verdict", static_cast<int>(run.verdict)},
                 {"unknowns", run.unknowns},
                 {"steps", run.steps},
                 {"iterations", run.iterations},
                 {"factorizations", run.factorizations},
                 {"cpu_seconds", run.cpu_seconds},
                 {"wall_seconds", run.wall_seconds},
                 {"most_cpu_seconds", run.most_cpu_seconds},
                 {"repetitions", run.repetitions},
                 {"memory_bytes", run.memory}};
    for (const auto &[name, values] : run.columns)
      json["columns"][name] = values;
    for (const auto &[time, field] : run.fields)
      json["fields"].push_back({{"time_s", time}, {"values", json_of(field)}});
    return json;
  }



  MeasuredRun measured_run_of(const Json &json)
  {
    MeasuredRun run;
    run.exit_state       = json.at("exit");
    run.verdict          = static_cast<Verdict>(json.at("verdict").get<int>());
    run.unknowns         = json.at("unknowns");
    run.steps            = json.at("steps");
    run.iterations       = json.at("iterations");
    run.factorizations   = json.at("factorizations");
    run.cpu_seconds      = json.at("cpu_seconds");
    run.wall_seconds     = json.at("wall_seconds");
    run.most_cpu_seconds = json.at("most_cpu_seconds");
    run.repetitions      = json.at("repetitions");
    run.memory           = json.at("memory_bytes");
    if (json.contains("columns"))
      for (const auto &[name, values] : json.at("columns").items())
        run.columns[name] = numbers_of(values);
    if (json.contains("fields"))
      for (const Json &field : json.at("fields"))
        run.fields[field.at("time_s")] = recorded_field_of(field.at("values"));
    return run;
  }



  namespace
  {
    /** A decision that changes from run to run would be an error of its own. */
    Scene without_decisions_on_the_way(const Scene &scene)
    {
      return scene.context.model == Model::lattice &&
          scene.effects.large_rotation == Switch::automatic
        ? scene_with(scene, {"Effects/Large rotation=on"})
        : scene;
    }
  } // namespace

  MeasuredRun measure_run(const Scene        &planned,
                          const MPI_Comm      communicator,
                          const Selection    &selection,
                          const FractionDone &progress)
  {
    const Scene       scene = without_decisions_on_the_way(planned);
    MeasuredRun       run;
    SelectionRecorder recorder(scene, communicator, selection, progress, run);
    forget_peak_memory();
    const double cpu_before = cpu_seconds();
    const auto   start      = Clock::now();
    try
      {
        const RunResult result =
          analysis_of(scene).observe(scene, communicator, recorder);
        run.exit_state     = result.exit_state;
        run.verdict        = verdict_of(result.findings);
        run.steps          = result.work.steps;
        run.iterations     = result.work.iterations;
        run.factorizations = result.work.factorizations;
      }
    catch (const Interrupted &)
      {
        throw;
      }
    catch (const ComputationError &failure)
      {
        run.exit_state = failure.what();
        run.verdict    = Verdict::not_to_be_used;
      }
    if (!run.completed())
      run.steps = recorder.n_steps();
    run.cpu_seconds = mpi::sum(cpu_seconds() - cpu_before, communicator);
    run.wall_seconds =
      mpi::max(std::chrono::duration<double>(Clock::now() - start).count(),
               communicator);
    run.most_cpu_seconds = run.cpu_seconds;
    run.memory           = mpi::sum(peak_memory(), communicator);
    return run;
  }



  std::vector<std::string> history_columns(const Scene   &scene,
                                           const MPI_Comm communicator)
  {
    if (scene.context.model == Model::reduced_cell)
      return names_of(cell_columns());
    LatticeRun run(scene, communicator);
    run.prepare();
    return names_of(History(scene, run.equations, communicator).columns());
  }

  namespace
  {
    namespace fs = std::filesystem;

    const std::array<std::string, 3> without_influence = {"Output",
                                                          "Study",
                                                          "Quantities"};

    /** Without what does not change a run. */
    std::string influential_values(ParameterSubsection root)
    {
      root.subsections.erase(
        std::remove_if(root.subsections.begin(),
                       root.subsections.end(),
                       [](const ParameterSubsection &subsection) {
                         return std::find(without_influence.begin(),
                                          without_influence.end(),
                                          subsection.name) !=
                           without_influence.end();
                       }),
        root.subsections.end());
      return values_text(root, "");
    }

    std::string hash_of(const std::string &text)
    {
      constexpr unsigned int hexadecimal = 16;
      std::string            digits;
      for (std::size_t rest = std::hash<std::string>()(text); rest > 0;
           rest /= hexadecimal)
        digits += "0123456789abcdef"[rest % hexadecimal];
      return digits;
    }

    std::string contents(const std::string &file)
    {
      std::ifstream stream(file);
      return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::string file_of(const std::string &folder, const std::string &key)
    {
      return folder + "/" + hash_of(key) + ".json";
    }
  } // namespace



  std::string key_of(const Scene &scene, const unsigned int n_ranks)
  {
    std::string text = "auxfem " + version_text() + " on " +
      std::to_string(n_ranks) + " ranks\n";
    text += influential_values(
      parse_parameter_text(scene.all_parameters, scene.file));
    for (const std::string &file : scene.input_files)
      if (file != scene.file)
        text += file + " " + hash_of(contents(file)) + '\n';
    return text;
  }



  std::optional<MeasuredRun> kept_run(const std::string &folder,
                                      const std::string &key)
  {
    std::ifstream stream(file_of(folder, key));
    try
      {
        const Json json = Json::parse(stream);
        // Another run may have the same hash.
        if (json.at("key") == key)
          return measured_run_of(json.at("run"));
      }
    catch (const Json::exception &)
      {
        // There is none, or its file is damaged.
      }
    return {};
  }



  void keep_run(const std::string &folder,
                const std::string &key,
                const MeasuredRun &run)
  {
    if (const std::error_code error = make_output_subfolder(folder))
      throw ComputationError("Cannot make the folder " + folder + ": " +
                             output_error_text(error.value()) + ".");
    replace_file(file_of(folder, key),
                 Json{{"key", key}, {"run", json_of(run)}}
                   .dump(-1, ' ', false, Json::error_handler_t::replace));
  }
} // namespace auxfem
