#include <auxfem/analysis/analysis.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>
#include <auxfem/study/measured_run.h>
#include <auxfem/study/scene_cases.h>

#include <deal.II/base/mpi.h>

#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  std::string numbered_folder(const std::string &parent, const std::size_t n)
  {
    std::ostringstream folder;
    folder << parent << '/';
    folder.width(4);
    folder.fill('0');
    folder << n;
    return folder.str();
  }

  SceneCase scene_case(const std::string              &folder,
                       const std::vector<std::string> &paths,
                       const std::vector<std::string> &values)
  {
    SceneCase one{folder, {"Output/Directory=" + folder}};
    for (std::size_t i = 0; i < paths.size(); ++i)
      one.overrides.push_back(paths[i] + "=" + values[i]);
    return one;
  }

  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    std::string key_file(const SceneCase &one)
    {
      return one.folder + ".key";
    }

    /** Whether an earlier run has completed the case. */
    bool is_done(const SceneCase &one, const Scene &scene)
    {
      return contents(key_file(one)) == key_of(scene, 1) &&
        !summary_in(one.folder).is_null();
    }

    /** Keeps the screen for the lines of many runs. */
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

    /** Computes a case. Throws InputError, ComputationError, Interrupted. */
    void compute(const SceneCase &one,
                 const Scene     &scene,
                 const MPI_Comm   communicator,
                 const FileRules &rules)
    {
      const Silence silence;
      analysis_of(scene).run(scene, communicator, {rules, {}, {}});
      on_first_rank(communicator,
                    [&]() { replace_file(key_file(one), key_of(scene, 1)); });
    }

    CaseEnd run_case(const Scene     &scene,
                     const SceneCase &one,
                     const MPI_Comm   communicator,
                     const FileRules &rules)
    {
      end_if_interrupted(communicator);
      CaseEnd end;
      try
        {
          const Scene varied = scene_of_case(scene, one.overrides);
          on_first_rank(communicator,
                        [&]() { end.is_reused = is_done(one, varied); });
          end.is_reused = mpi::max(int(end.is_reused), communicator) > 0;
          if (!end.is_reused)
            compute(one, varied, communicator, rules);
        }
      catch (const InputError &error)
        {
          end.failure    = error.what();
          end.is_mistake = true;
        }
      catch (const Interrupted &)
        {
          throw;
        }
      catch (const ComputationError &error)
        {
          end.failure = error.what();
        }
      return end;
    }
  } // namespace

  std::vector<CaseEnd> run_cases(const Scene                  &scene,
                                 const std::vector<SceneCase> &cases,
                                 const MPI_Comm                communicator,
                                 const FileRules              &rules,
                                 const CaseListener           &listener)
  {
    const unsigned int n_ranks     = mpi::n_mpi_processes(communicator),
                       rank        = mpi::this_mpi_process(communicator);
    const bool     is_side_by_side = n_ranks > 1 && cases.size() >= n_ranks;
    const MPI_Comm case_communicator =
      is_side_by_side ? MPI_COMM_SELF : communicator;
    std::vector<CaseEnd> ends(cases.size());
    int                  signal = 0;
    for (std::size_t c = 0; c < cases.size() && signal == 0; ++c)
      {
        if (is_side_by_side && c % n_ranks != rank)
          continue;
        try
          {
            ends[c] = run_case(scene, cases[c], case_communicator, rules);
          }
        catch (const Interrupted &interruption)
          {
            signal = interruption.signal();
          }
        if (rank == 0)
          listener(c, ends[c], signal);
      }
    signal = mpi::max(signal, communicator);
    if (signal != 0)
      throw Interrupted(signal);
    if (is_side_by_side)
      for (std::size_t c = 0; c < cases.size(); ++c)
        ends[c].failure =
          broadcast_text(c % n_ranks, ends[c].failure, communicator);
    return ends;
  }

  namespace
  {
    /** Members of summary.json that are no results of the analysis. */
    bool is_bookkeeping(const std::string &name)
    {
      static const std::set<std::string> names = {"counts",
                                                  "cpu_seconds",
                                                  "cpu_seconds_of_start",
                                                  "effects",
                                                  "end_time",
                                                  "peak_memory_bytes",
                                                  "quantities",
                                                  "size_metre",
                                                  "struts_of_section",
                                                  "time_reached",
                                                  "wall_seconds",
                                                  "warnings",
                                                  "work"};
      return names.count(name) > 0;
    }

    void add_numbers(const Json        &json,
                     const std::string &path,
                     NamedResults      &results)
    {
      if (json.is_number())
        results.emplace_back(path, json.get<double>());
      else if (json.is_object())
        for (const auto &member : json.items())
          add_numbers(member.value(), path + "." + member.key(), results);
      else if (json.is_array())
        for (std::size_t i = 0; i < json.size(); ++i)
          add_numbers(json[i], path + "." + std::to_string(i + 1), results);
    }
  } // namespace

  NamedResults results_in(const Json &summary)
  {
    NamedResults results;
    for (const auto &member : summary.items())
      if (!is_bookkeeping(member.key()))
        add_numbers(member.value(), member.key(), results);
    return results;
  }

  Json summary_in(const std::string &folder)
  {
    std::ifstream stream(folder + "/summary.json");
    const Json    summary = Json::parse(stream, nullptr, false);
    return summary.is_discarded() ? Json() : summary;
  }

  void add_quantities(const NamedResults &quantities, NamedResults &results)
  {
    for (const auto &quantity : quantities)
      {
        results.erase(std::remove_if(results.begin(),
                                     results.end(),
                                     [&quantity](const auto &result) {
                                       return result.first == quantity.first;
                                     }),
                      results.end());
        results.push_back(quantity);
      }
  }

  CaseResults
  results_of(const Scene &scene, const SceneCase &one, const CaseEnd &end)
  {
    CaseResults found;
    found.exit_state   = end.failure.substr(0, end.failure.find('\n'));
    const Json summary = summary_in(one.folder);
    if (!end.failure.empty() || summary.is_null())
      return found;
    found.verdict    = summary.value("verdict", "");
    found.exit_state = summary.value("exit_state", "");
    found.results    = results_in(summary);
    if (!scene.study.quantities.empty())
      add_quantities(quantities_in(scene,
                                   read_table(one.folder + "/history.csv")),
                     found.results);
    return found;
  }

  std::vector<std::string> short_names(const std::vector<std::string> &paths)
  {
    std::map<std::string, unsigned int> numbers;
    const auto last_part = [](const std::string &path) {
      return path.substr(path.rfind('.') + 1);
    };
    const auto is_index = [](const std::string &part) {
      return part.find_first_not_of("0123456789") == std::string::npos;
    };
    for (const std::string &path : paths)
      ++numbers[last_part(path)];
    std::vector<std::string> names;
    for (const std::string &path : paths)
      {
        const std::string part = last_part(path);
        names.push_back(is_index(part) || numbers[part] > 1 ? path : part);
      }
    return names;
  }

  std::map<std::string, std::size_t>
  names_of_results(const std::vector<std::string> &paths)
  {
    std::map<std::string, std::size_t> positions;
    std::set<std::string>              shared;
    for (std::size_t i = 0; i < paths.size(); ++i)
      for (std::size_t point = paths[i].find('.'); point != std::string::npos;
           point             = paths[i].find('.', point + 1))
        {
                      const std::string end = paths[i].substr(point + 1);
                      if (!positions.emplace(end, i).second)
            shared.insert(end);
        }
    for (const std::string &end : shared)
      positions.erase(end);
    // A whole path takes precedence over the end of another one.
    for (std::size_t i = 0; i < paths.size(); ++i)
      positions[paths[i]] = i;
    return positions;
  }
} // namespace auxfem
