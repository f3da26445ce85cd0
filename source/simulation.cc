#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/simulation/imperfect_lattice.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/output/console.h>
#include <auxfem/output/figure_files.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Values of parameters by their path. */
    using ValuesByPath = std::map<std::string, std::string>;

    void add_values(const ParameterSubsection &subsection,
                    const std::string         &path,
                    ValuesByPath              &values)
    {
      for (const ParameterEntry &entry : subsection.entries)
        values[path + entry.name] = entry.value;
      for (const ParameterSubsection &inner : subsection.subsections)
        add_values(inner, path + inner.name + '/', values);
    }

    ValuesByPath values_of(const Scene &scene)
    {
      ValuesByPath values;
      add_values(parse_parameter_text(scene.all_parameters, scene.file),
                 "",
                 values);
      return values;
    }

    /** Parameters that a resumed run may change beside those of the output: how
     * far the run goes. */
    std::vector<std::string> ends_of(const Scene &scene)
    {
      if (scene.analysis == Analysis::static_path)
        return {"Path/Largest load factor",
                "Path/Largest displacement",
                "Path/Points",
                "Path/Graphics interval"};
      return {"Time/End time"};
    }

    /** Whether the results so far do not depend on the changed value. */
    bool may_change(const std::string &path, const Scene &scene)
    {
      const std::vector<std::string> ends = ends_of(scene);
      const auto is_in = [&path](const std::string &subsection) {
        return path.compare(0, subsection.size() + 1, subsection + '/') == 0;
      };
      return std::find(ends.begin(), ends.end(), path) != ends.end() ||
        is_in(evaluation_schema().name) || is_in(crush_curve_schema().name) ||
        is_in(transmission_schema().name) ||
        (is_in(output_schema().name) && path != "Output/Directory" &&
         path != "Output/Graphics" && path != "Output/Effective strains");
    }

    std::string value_at(const std::string &path, const ValuesByPath &values)
    {
      const auto found = values.find(path);
      return found == values.end() ? "not given" : '"' + found->second + '"';
    }

    void refuse_changes(const Scene &before, const Scene &now)
    {
      const ValuesByPath values     = values_of(before),
                         new_values = values_of(now);
      ValuesByPath all              = new_values;
      all.insert(values.begin(), values.end());
      std::string changes;
      for (const auto &[path, value] : all)
        if (const std::string then = value_at(path, values),
            wanted                 = value_at(path, new_values);
            then != wanted && !may_change(path, now))
          changes +=
            "\n  " + path + ": it was " + then + ", now it is " + wanted;
      std::string ends;
      for (const std::string &end : ends_of(now))
        ends += end + ", ";
      if (!changes.empty())
        throw InputError(
          "A run that goes on keeps its parameters; what it has computed until "
          "now depends on them:" +
          changes + "\nOnly " + ends +
          "the parameters of Output but Directory, Graphics and Effective "
          "strains, and those of the evaluation may change. Leave the others as they were, or start anew.");
    }

    void refuse_end_of_path_before(const CheckpointData &reached,
                                   const Scene          &scene)
    {
      const double       load_factor = load_factor_of_saved_state(reached);
      const auto         n_points    = step_of_saved_state(reached);
      std::ostringstream message;
      if (std::abs(load_factor) >= scene.path.largest_load_factor)
        message << "load factor " << load_factor
                << ", and Path/Largest load factor is "
                << scene.path.largest_load_factor;
      else if (n_points >= scene.path.max_points)
        message << n_points << " points, and Path/Points is "
                << scene.path.max_points;
      else
        return;
      throw InputError("The path has got to " + message.str() +
                       ". Give a larger one, e.g. --set \"Path/Largest load "
                       "factor=...\".");
    }

    void refuse_end_before(const CheckpointData &records, const Scene &scene)
    {
      if (scene.analysis == Analysis::static_path)
        return refuse_end_of_path_before(records, scene);
      const double reached = time_of_saved_state(records);
      if (scene.time.end_time > reached)
        return;
      std::ostringstream message;
      message << "The run has got to t = " << reached
              << " s, and its end time is " << scene.time.end_time
              << " s. Give a later one: --set \"Time/End time=...\".";
      throw InputError(message.str());
    }
  } // namespace

  Scene scene_to_resume(const RestartedRun             &run,
                        const std::vector<std::string> &overrides)
  {
    if (const std::string file = changed_input_file(run); !file.empty())
      throw InputError("The run has read " + file +
                       ", which has changed since, or is gone. Put it back, or "
                       "start from t = 0.");
    const auto with = [&run](const std::vector<std::string> &overrides) {
      std::vector<std::string> all = {"Output/Directory=" + run.folder};
      all.insert(all.end(), overrides.begin(), overrides.end());
      return read_scene_from_text(run.parameters, run.scene_file, all);
    };
    const Scene scene = with(overrides);
    refuse_changes(with({}), scene);
    refuse_end_before(run.records, scene);
    return scene;
  }

  namespace
  {
    /** Reports the memory of a large scene before the run allocates it. */
    void report_size(const Scene &scene, const MPI_Comm communicator)
    {
      const std::string text = size_text(scene);
      if (!text.empty() &&
          dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        std::cout << indented(text) << '\n' << std::endl;
    }

    /** Those of @p all that are not among @p own. */
    std::vector<std::string> others_of(const std::vector<std::string> &all,
                                       const std::vector<std::string> &own)
    {
      std::vector<std::string> others;
      for (const std::string &file : all)
        if (std::find(own.begin(), own.end(), file) == own.end())
          others.push_back(file);
      return others;
    }

    /** Files of other analyses than @p entry, and of evaluations that @p scene
     * does not ask for. */
    std::vector<std::string> files_of_others(const AnalysisEntry &entry,
                                             const Scene         &scene)
    {
      std::vector<std::string> files =
        others_of(all_figure_files(), figure_files(scene));
      for (const AnalysisEntry &other : analysis_registry())
        for (const std::string &file : others_of(other.files, entry.files))
          files.push_back(file);
      return files;
    }
  } // namespace

  RunResult run(const Scene         &scene,
                const MPI_Comm       communicator,
                const FolderOptions &options)
  {
    report_size(scene, communicator);
    const AnalysisEntry &analysis            = analysis_of(scene);
    FolderOptions        with_others         = options;
    with_others.rules.results_of_other_kinds = files_of_others(analysis, scene);
    return analysis.run(scene, communicator, with_others);
  }

  RunResult
  run(const Scene &scene, const MPI_Comm communicator, Recorder &recorder)
  {
    const AnalysisEntry &analysis = analysis_of(scene);
    if (analysis.observe == nullptr)
      throw InputError("Analysis = " + analysis.name +
                       ": has no rows to record, it writes files only");
    return analysis.observe(scene, communicator, recorder);
  }

  void check(const Scene &scene, const MPI_Comm communicator)
  {
    report_size(scene, communicator);
    analysis_of(scene).check(scene, communicator);
  }
} // namespace auxfem
