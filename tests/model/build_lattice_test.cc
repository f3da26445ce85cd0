#include <auxfem/model/build_lattice.h>
#include <auxfem/model/joint_releases.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <mesh/ladder.h>

using namespace auxfem;
using namespace auxfem::testing_support;

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

TEST(BuildLattice, PatternsMayHaveRigidPartsAndHinges)
{
  // Rigid triangles, each with an arm hinged at a corner that reaches the next.
  const Scene scene = read_scene_from_text(
    SceneText()
      .cells("pattern", 3, 1)
      .add("Lattice",
           "Joints = 0 0; 0.5 0; 0 0.5; 1 0 | Struts = 0 1; 1 2; 2 0; 1 3 | "
           "Strut sets = plate: 0 1 2; arm: 3 | Joint sets = pin: 1 | "
           "Vector x = 1 0")
      .rectangle("bar", 0.01, 0.01, {1, 1})
      .set("Rigid parts/plate/Struts", "plate")
      .hinge("pins", "pin", "arm")
      .str(),
    "test.prm");
  const Lattice lattice = build_lattice(scene);
  EXPECT_EQ(lattice.struts.size(), 3 * 4u);
  ASSERT_EQ(lattice.rigid_parts.size(), 3u);
  for (const RigidPart &part : lattice.rigid_parts)
    EXPECT_EQ(part.joints.size(), 3u);
  const auto releases = joint_releases(scene, lattice);
  ASSERT_EQ(releases.size(), 1u);
  unsigned int n_released = 0;
  for (const JointRelease::AtJoint &at : releases[0].joints)
    n_released += at.ends.size();
  EXPECT_EQ(n_released, 3u);
}
