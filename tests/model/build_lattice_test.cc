#include <auxfem/model/build_lattice.h>

#include <gtest/gtest.h>

#include <mesh/ladder.h>

using namespace auxfem;

namespace
{
  using Indices = std::vector<unsigned int>;

  Scene ladder_scene()
  {
    Scene scene;
    scene.lattice.cell = ladder();
    SectionDefinition section;
    section.name   = "tube";
    section.struts = "all";
    section.path   = "Sections/tube";
    scene.sections = {section};
    return scene;
  }
} // namespace

TEST(BuildLattice, LaterSetsMayUseEarlierOnes)
{
  Scene scene        = ladder_scene();
  scene.sets         = {{"ends", "joints: left + right", "Sets/ends"},
                        {"rim", "joints: ends + top", "Sets/rim"},
                        {"posts", "struts: abs(y - 0.5) < 0.1", "Sets/posts"}};
  const auto lattice = build_lattice(scene);
  EXPECT_EQ(lattice.joint_sets.at("rim"), (Indices{0, 2, 3, 4, 5}));
  EXPECT_EQ(lattice.strut_sets.at("posts"), (Indices{4, 5, 6}));
}

TEST(BuildLattice, InSpaceAStrutWithoutSectionIsShownWithItsZ)
{
  Scene scene             = ladder_scene();
  scene.context.dimension = 3;
  scene.context.dimension = 3;
  scene.lattice.cell      = cell_from_text("frame",
                                      "set Joints = 0 0 0; 0 0 1\n"
                                           "set Struts = 0 1",
                                      ".",
                                      3);
  scene.sections.clear();
  EXPECT_TRUE(contains(input_error_of([&]() { build_lattice(scene); }),
                       "middle at (0, 0, 0.5) m"));
}

TEST(BuildLattice, RejectsUsedAndInvalidNames)
{
  const auto refusal = [](const SetDefinition &definition) {
    Scene scene = ladder_scene();
    scene.sets  = {definition};
    return input_error_of([&]() { build_lattice(scene); });
  };
  EXPECT_TRUE(contains(refusal({"top", "joints: 1", "Sets/top"}),
                       "joints named \"top\" already"));
  EXPECT_TRUE(
    contains(refusal({"a+b", "joints: 1", "Sets/a+b"}), "cannot name a set"));
  EXPECT_TRUE(contains(refusal({"one", "1", "Sets/one"}), "\"joints:\""));
  EXPECT_TRUE(
    contains(refusal({"one", "joint: 1", "Sets/one"}), "\"joints:\""));
}

TEST(BuildLattice, LaterSectionsWin)
{
  Scene scene   = ladder_scene();
  auto  second  = scene.sections[0];
  second.struts = "4, 5";
  scene.sections.push_back(second);
  const auto   lattice = build_lattice(scene);
  unsigned int number  = 0;
  for (const auto &strut : lattice.struts)
    {
      EXPECT_EQ(strut.section, number == 4 || number == 5 ? 1u : 0u);
      ++number;
    }
}

TEST(BuildLattice, NamesAStrutWithoutSection)
{
  Scene scene              = ladder_scene();
  scene.sections[0].struts = "0, 1, 2, 3, 5";
  const auto message       = input_error_of([&]() { build_lattice(scene); });
  EXPECT_TRUE(contains(message, "Strut 4 (joints 0 and 3")) << message;
  EXPECT_TRUE(contains(message, "and 1 more have no section")) << message;
}
