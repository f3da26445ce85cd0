#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/build_lattice.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>
#include <set>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText stars()
  {
    return static_scene()
      .cells("star", 8, 8)
      .rectangle("all", 4e-4, 4e-4, {70e9})
      .support("foot", "y < ymin + 1e-9", "clamp")
      .time(1, 1);
  }

  SceneText with(const std::string &type, const std::string &entries)
  {
    SceneText scene = stars();
    scene.set("Imperfections/one/Type", type);
    return scene.add("Imperfections/one", entries);
  }

  Scene read(const SceneText &scene)
  {
    return read_scene_from_text(scene.str(), "test.prm");
  }

  Lattice lattice_of(const SceneText &scene)
  {
    return build_lattice(read(scene));
  }
} // namespace

TEST(Imperfections, RandomOnesHaveTheirStandardDeviation)
{
  const Lattice lattice =
    lattice_of(with("random", "Standard deviation = 0.1 mm | Seed = 3"));
  const unsigned int n   = lattice.joints.size();
  double             sum = 0, squares = 0;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < 2; ++c)
      {
        const double offset =
          lattice.joints[i][c] - lattice.as_designed->joints[i][c];
        sum += offset;
        squares += offset * offset;
      }
  ASSERT_GT(n, 400u);
  EXPECT_NEAR(std::sqrt(squares / (2 * n)), 1e-4, 1e-5);
  EXPECT_LT(std::abs(sum / (2 * n)), 1e-5);
  for (const Strut &strut : lattice.struts)
    EXPECT_EQ(strut.sagitta, 0.);
}

TEST(Imperfections, TheSeedDeterminesTheLattice)
{
  const auto first_joint = [](const unsigned int seed) {
    return lattice_of(with("random",
                           "Standard deviation = 0.1 mm | Seed = " +
                             std::to_string(seed)))
      .joints[0];
  };
  EXPECT_EQ(first_joint(1), first_joint(1));
  EXPECT_NE(first_joint(1), first_joint(2));
}

TEST(Imperfections, SetsMeanTheDesignedLattice)
{
  const SceneText scene =
    with("random", "Standard deviation = 0.5 mm | Joints = notches");
  const Lattice designed = lattice_of(stars()), disturbed = lattice_of(scene);
  const SceneContext context = read(scene).context;
  const std::string  foot = "y < ymin + 1e-9", struts = "x < 0.01";
  EXPECT_EQ(select_joints(designed, foot, context, ""),
            select_joints(disturbed, foot, context, ""));
  EXPECT_EQ(select_struts(designed, struts, context, ""),
            select_struts(disturbed, struts, context, ""));
  for (const unsigned int joint : select_joints(designed, "tips", context, ""))
    EXPECT_EQ(designed.joints[joint], disturbed.joints[joint]);
}

TEST(Imperfections, AddUp)
{
  SceneText scene =
    with("expression", "Displacement x = 1e-4 * sin(pi * y / ymax)");
  scene.set("Imperfections/two/Type", "expression");
  scene.add("Imperfections/two",
            "Displacement x = 1e-5 | Displacement y = 2e-5");
  const Lattice lattice = lattice_of(scene);
  const double  height  = bounding_box(*lattice.as_designed)[1][1];
  for (unsigned int i = 0; i < lattice.joints.size(); ++i)
    {
      const dealii::Point<3> &designed = lattice.as_designed->joints[i];
      EXPECT_NEAR(lattice.joints[i][0] - designed[0],
                  1e-4 * std::sin(M_PI * designed[1] / height) + 1e-5,
                  1e-16);
      EXPECT_NEAR(lattice.joints[i][1] - designed[1], 2e-5, 1e-16);
    }
}

TEST(Imperfections, ExpressionsScatterJointByJoint)
{
  const Lattice lattice =
    lattice_of(with("expression",
                    "Displacement x = 1e-5 * y / ymax * normal(1) | "
                    "Displacement y = 1e-5 * random(2)"));
  std::set<double> different;
  for (unsigned int i = 0; i < lattice.joints.size(); ++i)
    {
      const dealii::Tensor<1, 3> moved =
        lattice.joints[i] - lattice.as_designed->joints[i];
      different.insert(moved[1]);
      EXPECT_GE(moved[1], 0);
      EXPECT_LE(moved[1], 1e-5);
      if (lattice.as_designed->joints[i][1] == 0)
        {
          EXPECT_EQ(moved[0], 0);
        }
    }
  EXPECT_EQ(different.size(), lattice.joints.size());
  for (const Strut &strut : lattice.struts)
    EXPECT_NEAR(strut.sagitta, 0, 1e-15);
}

TEST(Imperfections, InvalidInputIsRejected)
{
  expect_parts(input_error_of([] {
                 lattice_of(with("expression", "Displacement x = 2 * tt"));
               }),
               {"Imperfections/one/Displacement x", "tt", "xmin"});
  expect_parts(input_error_of(
                 [] { lattice_of(with("expression", "Displacement z = x")); }),
               {"Displacement z", "Dimension"});
  expect_parts(input_error_of([] {
                 lattice_of(
                   with("random", "Standard deviation = 1 | Joints = nobody"));
               }),
               {"Imperfections/one/Joints", "nobody"});
}
