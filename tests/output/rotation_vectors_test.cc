#include <auxfem/equations/equations.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/output/probes.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;

namespace
{
  const SceneText strut_text =
    SceneText()
      .frame("0 0; 1 0", "0 1")
      .circle("band", "5 mm", {"70 GPa", "2700 kg/m3"});

  /** A free strut in space whose nodes the test rotates. */
  class RotationVectorsTest : public testing::Test
  {
  protected:
    explicit RotationVectorsTest(
      const SceneText &more = SceneText().dimension(3))
      : scene(read_scene_from_text(strut_text + more, "test.prm"))
      , lattice(build_lattice(scene))
      , model(scene, lattice, MPI_COMM_WORLD)
      , equations(model)
      , rotations(model.numbering)
      , state(equations.initial_state())
      , vectors(model)
    {
      if (scene.context.dimension == 3)
        for (const unsigned int joint : {1, 0})
          vectors.choose(model.numbering.joint_unknown(joint, first_rotation));
    }

    /** Rotates all nodes from their current rotation to @p rotation. */
    void turn_to(const Quaternion &rotation)
    {
      turn_by(rotation_vector(conjugate(state.rotations[0]) * rotation));
    }

    /** Rotates all nodes by a material rotation vector (rad). */
    void turn_by(const SpaceVector &turn)
    {
      const State      before = state;
      const Evaluation step   = Evaluation::step(before, state, 1);
      for (unsigned int i = 0; i < state.rotations.size(); ++i)
        rotations.set_material_increment(step, i, turn);
      rotations.follow(step);
      vectors.follow(state);
    }

    /** The rotation vector of joint @p joint. */
    SpaceVector vector_of(const unsigned int joint) const
    {
      SpaceVector vector;
      for (unsigned int c = 0; c < 3; ++c)
        vector[c] =
          vectors[model.numbering.joint_unknown(joint, first_rotation + c)];
      return vector;
    }

    const Scene         scene;
    const Lattice       lattice;
    const LatticeModel  model;
    const Equations     equations;
    const NodeRotations rotations;
    State               state;
    RotationVectors     vectors;
  };

  class SmallRotationVectorsTest : public RotationVectorsTest
  {
  protected:
    SmallRotationVectorsTest()
      : RotationVectorsTest(
          SceneText().dimension(3).set("Effects/Large rotation", "off"))
    {}
  };

  class PlanarRotationVectorsTest : public RotationVectorsTest
  {
  protected:
    PlanarRotationVectorsTest() : RotationVectorsTest(SceneText())
    {}
  };
} // namespace

TEST_F(RotationVectorsTest, CountTurnsAboutFixedAxisInLongSteps)
{
  const SpaceVector axis({2. / 3, -1. / 3, 2. / 3});
  for (unsigned int i = 0; i < 5; ++i)
    turn_by(4. * axis);
  for (unsigned int joint = 0; joint < 2; ++joint)
    EXPECT_NEAR((vector_of(joint) - 20. * axis).norm(), 0, 1e-13);
  EXPECT_NEAR(vectors.largest(), 20, 1e-13);
}

TEST_F(RotationVectorsTest, StaySmallForCirclingAxis)
{
  // Each round adds 2 pi (1 - cos 0.5) = 0.77 about z to the sum of rotations.
  const unsigned int n_rounds = 20, n_steps = 64;
  const auto         vector = [](const double phase) {
    return SpaceVector({0.5 * std::cos(phase), 0.5 * std::sin(phase), 0});
  };
  for (unsigned int i = 0; i <= n_rounds * n_steps; ++i)
    turn_to(exponential(vector(2 * M_PI * i / n_steps)));
  EXPECT_GT(rotations.values(state.displacement, 0).norm(), 2 * M_PI)
    << "the sum of turns alone would do";
  // Round-off of the quaternion adds up over 1280 steps.
  EXPECT_NEAR((vector_of(1) - vector(0)).norm(), 0, 1e-12);
}

TEST_F(RotationVectorsTest, CountTurnsAboutATiltedAxis)
{
  // Tilted by 0.1 rad and spun by 700 rad: near whole turns the only rotation
  // vectors are about the axis of the tilt.
  turn_by(SpaceVector({0.1, 0, 0}));
  for (unsigned int i = 0; i < 14000; ++i)
    turn_by(SpaceVector({0, 0, 0.05}));
  // The axis of the count is only known up to the tilt, 0.1^2 / 2.
  EXPECT_NEAR(vector_of(1)[2], 700, 3.5);
  EXPECT_NEAR(vectors.largest(), 700, 1);
}

TEST_F(SmallRotationVectorsTest, AreTheEntriesOfTheDisplacement)
{
  ASSERT_TRUE(state.rotations.empty());
  const SpaceVector entries({7, -8, 9});
  for (unsigned int i = 0; i < model.numbering.rotations().size(); ++i)
    rotations.set_values(entries, i, state.displacement);
  vectors.follow(state);
  EXPECT_EQ(vector_of(0), entries);
  EXPECT_EQ(vectors.largest(), entries.norm());
}

TEST_F(PlanarRotationVectorsTest, AreNone)
{
  vectors.follow(state);
  EXPECT_EQ(vectors.largest(), 0);
}
