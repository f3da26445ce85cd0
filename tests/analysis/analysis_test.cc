#include <auxfem/analysis/analysis.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  Scene shipped_scene(const std::filesystem::path    &file,
                      const std::vector<std::string> &overrides = {})
  {
    return read_scene_from_text(read_text(file), file, overrides);
  }

  /** Names of the analyses that serve a scene. */
  std::vector<std::string> analyses_for(const Scene &scene)
  {
    std::vector<std::string> names;
    for (const AnalysisEntry &entry : analysis_registry())
      if (entry.serves(scene))
        names.push_back(entry.name);
    return names;
  }
} // namespace

TEST(AnalysisRegistry, EntriesAreComplete)
{
  std::set<std::string> names;
  for (const AnalysisEntry &entry : analysis_registry())
    {
      EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " twice";
      EXPECT_FALSE(entry.description.empty()) << entry.name;
      EXPECT_NE(entry.run, nullptr) << entry.name;
      EXPECT_NE(entry.check, nullptr) << entry.name;
      for (const std::string &file : entry.files)
        EXPECT_FALSE(file.empty()) << entry.name;
    }
}

TEST(AnalysisRegistry, EveryShippedSceneIsServedByExactlyOne)
{
  std::set<std::string> served;
  for (const auto &file :
       std::filesystem::directory_iterator(AUXFEM_PRM_DIRECTORY))
    if (file.path().extension() == ".prm")
      {
        const Scene              scene = shipped_scene(file.path());
        std::vector<std::string> names = analyses_for(scene);
        // Sweeps and optimizations come first; their runs have an analysis too.
        if (scene.sweep.is_given() || scene.optimization.is_given())
          {
            ASSERT_EQ(names.size(), 2u) << file.path();
            names.resize(1);
          }
        ASSERT_EQ(names.size(), 1u) << file.path();
        EXPECT_EQ(analysis_of(scene).name, names[0]) << file.path();
        served.insert(names[0]);
      }
  // No analysis is without an example.
  EXPECT_EQ(served.size(), analysis_registry().size());
}

TEST(AnalysisRegistry, AnalysisAndModelDecide)
{
  const std::filesystem::path folder = AUXFEM_PRM_DIRECTORY;
  const auto name_of = [&](const char *file, const std::string &override) {
    return analysis_of(shipped_scene(folder / file, {override})).name;
  };
  EXPECT_EQ(name_of("star-10x10.prm", "Time/Scheme=static"), "simulation");
  EXPECT_EQ(name_of("star-10x10.prm", "Analysis=static path"), "static path");
  EXPECT_EQ(name_of("star-10x10.prm", "Analysis=modes"), "modes");
  EXPECT_EQ(name_of("cell-case-1.prm", "Time/Scheme=newmark"), "reduced cell");
  EXPECT_EQ(name_of("cell-case-1.prm", "Time/Scheme=arkode"), "reduced cell");
}
