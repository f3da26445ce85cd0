#include <auxfem/mesh/cells/gmsh_reader.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/output/history.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>

#include <support/text_file.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <vector>

#include <sys/resource.h>

#include "mutator.h"

namespace
{
  using namespace auxfem;
  using testing_support::read_text;
  namespace fs = std::filesystem;
  using Clock  = std::chrono::steady_clock;

  /** Seconds of computing after which reading a scene is taken to hang. */
  constexpr unsigned int longest = 20;

  /** A file to be damaged, and the scene that reads it. */
  struct Seed
  {
    enum class Kind
    {
      scene,
      table,
      mesh
    };
    Kind        kind;
    std::string name; ///< of the scene's file, which relative names start from
    std::string text;
    std::string ending; ///< of a table or mesh
  };

  std::vector<Seed> corpus()
  {
    std::vector<fs::path> files;
    for (const char *folder :
         {AUXFEM_PRM_DIRECTORY, AUXFEM_TEST_DATA_DIRECTORY})
      for (const fs::directory_entry &entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".prm")
          files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Seed> seeds;
    for (const fs::path &file : files)
      seeds.push_back({Seed::Kind::scene, file.string(), read_text(file), ""});
    for (unsigned int i = 0; i < 3; ++i)
      {
        seeds.push_back({Seed::Kind::table,
                         AUXFEM_TEST_DATA_DIRECTORY "/star.prm",
                         read_text(AUXFEM_TEST_DATA_DIRECTORY "/force.csv"),
                         ".csv"});
        for (const char *ending : {".msh", ".geo"})
          seeds.push_back(
            {Seed::Kind::mesh,
             AUXFEM_PRM_DIRECTORY "/portal.prm",
             read_text(AUXFEM_MESH_DIRECTORY "/portal" + std::string(ending)),
             ending});
        for (const std::string file :
             {"portal-binary-2.msh", "portal-binary-4.msh", "portal.inp"})
          seeds.push_back({Seed::Kind::mesh,
                           AUXFEM_PRM_DIRECTORY "/portal.prm",
                           read_text(AUXFEM_TEST_DATA_DIRECTORY "/" + file),
                           file.substr(file.rfind('.'))});
      }
    return seeds;
  }

  /** Reads the scene and builds its lattice, unless it is a large one. */
  void read(const std::string              &text,
            const std::string              &name,
            const std::vector<std::string> &overrides)
  {
    const Scene      scene   = read_scene_from_text(text, name, overrides);
    constexpr double many    = 1000;
    double           n_cells = 1;
    for (const unsigned int n : scene.lattice.n_cells)
      n_cells *= n;
    if (scene.context.model == Model::lattice && n_cells <= many)
      require_existing_columns(scene, build_lattice(scene));
  }

  /** The defect of a message to the user; empty if there is none. */
  std::string fault_of(const std::string &message)
  {
    const std::string shown = with_short_lines(message);
    if (shown.empty())
      return "empty message";
    if (shown.size() > 12000)
      return "message of " + std::to_string(shown.size()) + " bytes";
    return "";
  }

  /** `accepted`, `refused`, or what must not be. */
  std::string outcome_of(const std::string              &text,
                         const std::string              &name,
                         const std::vector<std::string> &overrides)
  {
    const rlimit seconds = {longest, longest};
    setrlimit(RLIMIT_CPU, &seconds);
    try
      {
        read(text, name, overrides);
        return "accepted";
      }
    catch (const InputError &error)
      {
        const std::string fault = fault_of(error.what());
        return fault.empty() ? "refused" : fault;
      }
    catch (const ComputationError &error)
      {
        return "refused";
      }
    catch (const std::exception &error)
      {
        return "internal error: " + std::string(error.what());
      }
  }

  class Fuzzer
  {
  public:
    explicit Fuzzer(const unsigned int seed)
      : seeds(corpus())
      , mutator(seed)
      , prefix("fuzz_" + std::to_string(seed))
    {}

    /** Runs one damaged input; returns whether the program reacts correctly. */
    bool run_one()
    {
      const Seed       &seed  = seeds[mutator.below(seeds.size())];
      const std::string text  = mutator.mutated(seed.text);
      const auto        begin = Clock::now();
      std::string       outcome;
      try
        {
          outcome = run_in_separate_process([&]() { return read(seed, text); });
        }
      catch (const CrashedProcess &crash)
        {
          outcome = "crash: " + crash.reason;
        }
      const double took =
        std::chrono::duration<double>(Clock::now() - begin).count();
      if (took > 3 * longest)
        outcome = "hang: " + std::to_string(took) + " s, then " + outcome;
      ++counts[outcome.substr(0, outcome.find(':'))];
      if (outcome == "accepted" || outcome == "refused")
        return true;
      keep(seed, text, outcome);
      return false;
    }

    /** How many inputs ended how. */
    void print() const
    {
      for (const auto &[outcome, number] : counts)
        std::cout << outcome << ": " << number << '\n';
    }

  private:
    std::string read(const Seed &seed, const std::string &text) const
    {
      if (seed.kind == Seed::Kind::scene)
        return outcome_of(text, seed.name, {});
      const std::string file = fs::absolute(prefix + seed.ending).string();
      std::ofstream(file, std::ios::binary) << text;
      const std::vector<std::string> overrides = seed.kind == Seed::Kind::table
        ? std::vector<std::string>{"Loads/hit/Force y=table: " + file}
        : std::vector<std::string>{"Lattice/File=" + file,
                                   "Lattice/Run gmsh script=true"};
      return outcome_of(read_text(seed.name), seed.name, overrides);
    }

    void
    keep(const Seed &seed, const std::string &text, const std::string &outcome)
    {
      const std::string file = prefix + "_" + std::to_string(++n_kept) +
        (seed.ending.empty() ? ".prm" : seed.ending);
      std::ofstream(file, std::ios::binary) << text;
      std::cout << outcome << "\n  from " << seed.name << ", kept in "
                << fs::absolute(file).string() << std::endl;
    }

    const std::vector<Seed>             seeds;
    Mutator                             mutator;
    const std::string                   prefix;
    std::map<std::string, unsigned int> counts;
    unsigned int                        n_kept = 0;
  };
} // namespace

/** Damages inputs for some seconds; exit code 1 if one is not taken well. */
int main(const int argc, const char *const argv[])
{
  if (argc != 3)
    {
      std::cerr << "Usage: auxfem_fuzz SECONDS SEED\n";
      return 2;
    }
  const auto end = Clock::now() +
    std::chrono::duration_cast<Clock::duration>(
                     std::chrono::duration<double>(std::stod(argv[1])));
  Fuzzer fuzzer(std::stoul(argv[2]));
  bool   all_well = true;
  while (Clock::now() < end)
    all_well = fuzzer.run_one() && all_well;
  fuzzer.print();
  return all_well ? 0 : 1;
}
