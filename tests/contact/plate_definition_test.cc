#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  Scene scene_with_plate(const std::string &entries,
                         const unsigned int dimension = 2)
  {
    SceneText text;
    text.frame("0 0; 1 0", "0 1")
      .circle("round", 0.01, {1e6, 1000})
      .support("wall", "0", "clamp")
      .time(1, 0.1, "newmark")
      .add("Plates/table", entries);
    if (dimension == 3)
      text.dimension(3).set("Lattice/Joints", "0 0 0; 1 0 0");
    return read_scene_from_text(text, "test.prm");
  }
} // namespace

TEST(PlateDefinition, ReadsSupportMassAndVelocityOfItsJoint)
{
  const Scene scene = scene_with_plate(
    "Shape = plane | Position = 3 -1 | Normal = 0 5 | Displacement x = 2 * t | "
    "Displacement y = free | Mass = 4 | Initial velocity y = -6");
  ASSERT_EQ(scene.plates.size(), 1u);
  const PlateDefinition &plate = scene.plates[0];
  EXPECT_EQ(plate.position, dealii::Point<3>(3, -1, 0));
  EXPECT_DOUBLE_EQ(plate.surface->distance(dealii::Tensor<1, 3>({7, 2, 0})), 2);
  ASSERT_TRUE(plate.support);
  EXPECT_TRUE(plate.support->fixed[0]);
  EXPECT_FALSE(plate.support->fixed[1]);
  EXPECT_DOUBLE_EQ(plate.support->motion[0].value(0.5), 1);
  // Support, mass and velocity are those of its joint.
  ASSERT_EQ(scene.supports.size(), 2u);
  EXPECT_EQ(scene.supports[1].joints, "table");
  ASSERT_EQ(scene.masses.size(), 1u);
  EXPECT_DOUBLE_EQ(scene.masses[0].mass, 4);
  ASSERT_EQ(scene.initial_velocities.size(), 1u);
  EXPECT_DOUBLE_EQ(scene.initial_velocities[0].velocity[1], -6);
}

TEST(PlateDefinition, IsFixedByDefault)
{
  const Scene scene =
    scene_with_plate("Shape = sphere | Position = 0 3 0 | Radius = 0.5", 3);
  ASSERT_TRUE(scene.plates[0].support);
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_TRUE(scene.plates[0].support->fixed[c]);
  EXPECT_TRUE(scene.masses.empty());
  EXPECT_TRUE(scene.initial_velocities.empty());
}
