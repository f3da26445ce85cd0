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

    /**
     * Stores the selected columns and fields of a run of a lattice or a reduced
     * cell, and counts unknowns.
     */
    class SelectionRecorder : public Recorder
    {
    public:
      SelectionRecorder(const Scene        &scene,
                        const MPI_Comm      communicator,
                        const Selection    &selection,
                        const FractionDone &progress,
                        MeasuredRun        &run)
        : scene(scene)
        , communicator(communicator)
        , selection(selection)
        , progress(progress)
        , run(run)
      {}

      void begin(const Equations &run_equations) override
      {
        equations = &run_equations;
        if (!selection.field_times.empty() &&
            run_equations.reporting().struts.empty())
          throw InputError(
            "Quantities: energy norms need elastic struts, which the scene "
            "does not have. Compare columns of history.csv");
        run.unknowns = count(run_equations).free_unknowns;
        history.emplace(scene, run_equations, communicator);
        choose_columns(history->columns());
      }

      void start(const Solution &solution) override
      {
        record_row(history->values(solution));
        record_fields(solution);
      }

      std::optional<double> next_time(const double time) const override
      {
        const auto next = selection.field_times.upper_bound(time);
        return next == selection.field_times.end()
          ? std::nullopt
          : std::optional<double>(*next);
      }

      void row(const Solution &solution) override
      {
        record_fields(solution);
      }

      void step(const Solution &solution,
                const StepReport & /*report*/) override
      {
        record_row(history->values(solution));
      }

      void begin_rows(const std::vector<Column> &columns,
                      const unsigned int         n_unknowns) override
      {
        run.unknowns = n_unknowns;
        choose_columns(columns);
      }

      void row(const std::vector<double> &values) override
      {
        record_row(values);
      }

      /** Number of recorded steps. */
      unsigned long n_steps() const
      {
        return recorded.empty() || recorded.front().second->empty()
          ? 0
          : recorded.front().second->size() - 1;
      }

    private:
      void choose_columns(const std::vector<Column> &columns)
      {
        const std::vector<std::string> names = names_of(columns);
        for (std::size_t i = 0; i < names.size(); ++i)
          if (names[i] == time_column || selection.columns.count(names[i]) > 0)
            recorded.emplace_back(i, &run.columns[names[i]]);
      }

      void record_row(const std::vector<double> &row)
      {
        for (const auto &[column, values] : recorded)
          values->push_back(row[column]);
        progress(row.front() / scene.time.end_time);
      }

      void record_fields(const Solution &solution)
      {
        // Step times are products and differ from requested times by round-off.
        const double round_off = 1e-9 * scene.time.end_time;
        for (const double time : selection.field_times)
          if (std::abs(solution.state.time - time) <= round_off)
            run.fields[time] = field_of(*equations, solution, communicator);
      }

      const Scene        &scene;
      const MPI_Comm      communicator;
      const Selection    &selection;
      const FractionDone &progress;
      MeasuredRun        &run;
      const Equations    *equations = nullptr; ///< from begin() on

      std::optional<History>                                     history;
      std::vector<std::pair<std::size_t, std::vector<double> *>> recorded;
    };

    /** Resets the peak memory, if the system permits. */
    void reset_peak_memory()
    {
      malloc_trim(0);
      std::ofstream("/proc/self/clear_refs") << "5";
    }

    /** Numbers of a JSON array; nlohmann writes non-finite ones as null. */
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

  void MeasuredRun::add_repetition(const MeasuredRun &repetition)
  {
    cpu_seconds     = std::min(cpu_seconds, repetition.cpu_seconds);
    wall_seconds    = std::min(wall_seconds, repetition.wall_seconds);
    max_cpu_seconds = std::max(max_cpu_seconds, repetition.cpu_seconds);
    ++repetitions;
  }

  std::optional<double> MeasuredRun::spread() const
  {
    if (repetitions == 1 || cpu_seconds <= 0)
      return {};
    return max_cpu_seconds / cpu_seconds - 1;
  }

  bool MeasuredRun::has(const Selection &selection) const
  {
    const auto is_in = [](const auto &recorded) {
      return [&recorded](const auto &name) { return recorded.count(name) > 0; };
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
                 {"most_cpu_seconds", run.max_cpu_seconds},
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
    run.exit_state      = json.at("exit");
    run.verdict         = static_cast<Verdict>(json.at("verdict").get<int>());
    run.unknowns        = json.at("unknowns");
    run.steps           = json.at("steps");
    run.iterations      = json.at("iterations");
    run.factorizations  = json.at("factorizations");
    run.cpu_seconds     = json.at("cpu_seconds");
    run.wall_seconds    = json.at("wall_seconds");
    run.max_cpu_seconds = json.at("most_cpu_seconds");
    run.repetitions     = json.at("repetitions");
    run.memory          = json.at("memory_bytes");
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
    /**
     * Fixes decisions that could differ between runs and would cause errors.
     */
    Scene with_fixed_decisions(const Scene &scene)
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
    const Scene       scene = with_fixed_decisions(planned);
    MeasuredRun       run;
    SelectionRecorder recorder(scene, communicator, selection, progress, run);
    reset_peak_memory();
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
    run.max_cpu_seconds = run.cpu_seconds;
    run.memory          = mpi::sum(peak_memory(), communicator);
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

    const std::array<std::string, 3> irrelevant_subsections = {"Output",
                                                               "Study",
                                                               "Quantities"};

    /** Values of all parameters that influence the results of a run. */
    std::string influential_values(ParameterSubsection root)
    {
      root.subsections.erase(
        std::remove_if(root.subsections.begin(),
                       root.subsections.end(),
                       [](const ParameterSubsection &subsection) {
                         return std::find(irrelevant_subsections.begin(),
                                          irrelevant_subsections.end(),
                                          subsection.name) !=
                           irrelevant_subsections.end();
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

    std::string file_of(const std::string &folder, const std::string &key)
    {
      return folder + "/" + hash_of(key) + ".json";
    }
  } // namespace

  std::string contents(const std::string &file)
  {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

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

  std::optional<MeasuredRun> load_run(const std::string &folder,
                                      const std::string &key)
  {
    std::ifstream stream(file_of(folder, key));
    try
      {
        const Json json = Json::parse(stream);
        // Different runs may have equal hashes.
        if (json.at("key") == key)
          return measured_run_of(json.at("run"));
      }
    catch (const Json::exception &)
      {
        // The file is missing or damaged.
      }
    return {};
  }

  void store_run(const std::string &folder,
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
