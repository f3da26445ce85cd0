#include <auxfem/output/probes.h>

#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_run.h>

#include <cmath>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const SpaceTexts no_components = {{"0", "0", "0"}};

  /** A strut of length 1 along @p axis, clamped at joint 0, EI = 2. */
  SceneText clamped_strut(const SpaceVector &axis)
  {
    SceneText scene = static_space_frame("0 0 0; " + text(axis), "0 1");
    scene.space_section({100, 100, 100, 1.5, 2, 2})
      .support("clamp", "0", "clamp")
      .mesh(4, 4);
    return scene;
  }

  /**
   * Turns the strut along @p axis by two turns about @p normal to it, and
   * compares its tip and the rotation there with the arc of a circle.
   */
  void roll_up(const std::string &name,
               const SpaceVector &axis,
               const SpaceVector &normal,
               const double       step,
               ComparisonTable   &table)
  {
    SceneText scene = clamped_strut(axis);
    scene.load("tip", "1", no_components, times(8 * pi * normal, "t"))
      .time(1, step);
    SpaceRun        run(scene.str());
    RotationVectors rotations(run.model);
    rotations.choose(run.model.numbering.joint_unknown(1, first_rotation));
    double worst_position = 0, worst_rotation = 0, angle = 0;
    run.run([&] {
      angle = 4 * pi * run.state.time;
      rotations.follow(run.state);
      const SpaceVector position = std::sin(angle) / angle * axis +
        (1 - std::cos(angle)) / angle * cross_product_3d(normal, axis);
      worst_position =
        std::max(worst_position, (run.position(1) - position).norm());
      SpaceVector rotation;
      for (unsigned int c = 0; c < 3; ++c)
        rotation[c] =
          rotations[run.model.numbering.joint_unknown(1, first_rotation + c)];
      worst_rotation =
        std::max(worst_rotation, (rotation - angle * normal).norm());
    });
    const std::string steps = std::to_string(run.scene.time.n_steps());
    // Four points integrate the arc of pi/4 of an element to 1e-12; the rest is
    // what Newton's tolerance of 1e-11 leaves.
    table.row(name + ", steps: " + steps + ", position",
              worst_position,
              0,
              1e-9);
    table.row(name + ", steps: " + steps + ", rotation",
              worst_rotation,
              0,
              1e-9);
  }

  SpaceVector unit(const unsigned int axis)
  {
    SpaceVector vector;
    vector[axis] = 1;
    return vector;
  }
} // namespace

TEST(RollUp3d, TwoTurnsAboutEveryAxis)
{
  ComparisonTable table("Cantilever rolled up by two turns, largest distance "
                        "from the circle");
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int n = 0; n < 3; ++n)
      if (a != n)
        roll_up(std::string("along ") + "xyz"[a] + ", moment about " + "xyz"[n],
                unit(a),
                unit(n),
                0.1,
                table);
  const SpaceVector turn({0.4, -0.9, 0.7});
  const Quaternion  frame = exponential(turn);
  roll_up("skew", rotated(frame, unit(0)), rotated(frame, unit(2)), 0.1, table);
  // Newton's method may not turn a section by more than half a turn at once;
  // the step is divided where it would.
  roll_up("skew", rotated(frame, unit(0)), rotated(frame, unit(2)), 1, table);
}

TEST(RollUp3d, TwoTurnsOfTwist)
{
  // A moment about the strut's own axis twists it, M L / (G J), and no more.
  const SpaceVector axis =
    rotated(exponential(SpaceVector({0.4, -0.9, 0.7})), unit(0));
  SceneText scene = clamped_strut(axis);
  scene.load("tip", "1", no_components, times(6 * pi * axis, "t")).time(1, 0.2);
  SpaceRun        run(scene.str());
  RotationVectors rotations(run.model);
  rotations.choose(run.model.numbering.joint_unknown(1, first_rotation));
  run.run([&] { rotations.follow(run.state); });
  EXPECT_LT(run.displacement(1).norm(), 1e-10);
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(
      rotations[run.model.numbering.joint_unknown(1, first_rotation + c)],
      4 * pi * axis[c],
      1e-9);
}

namespace
{
  /** The strut under torsion and two transverse forces, by factors of each. */
  SceneText twisted_and_bent(const std::string &torsion,
                             const std::string &force_y,
                             const std::string &force_z)
  {
    SceneText scene = clamped_strut(unit(0));
    scene.load("tip",
               "1",
               {{"0", "3 * (" + force_y + ")", "2 * (" + force_z + ")"}},
               {{"2 * (" + torsion + ")", "0", "0"}});
    return scene;
  }
} // namespace

TEST(RollUp3d, AClosedPathOfLoadsEndsWhereItBegan)
{
  SceneText scene = twisted_and_bent(through({1, 1, 1, 0, 0, 0}),
                                     through({0, 1, 1, 1, 0, 0}),
                                     through({0, 0, 1, 1, 1, 0}));
  SpaceRun  run(scene.time(6, 0.2).str());
  SpaceRun  at_once(twisted_and_bent("t", "t", "t").time(1, 0.1).str());
  at_once.run();
  run.run([&] {
    if (std::abs(run.state.time - 3) < 1e-9)
      {
        EXPECT_GT(run.displacement(1).norm(), 0.5) << "hardly bent";
        EXPECT_GT(rotation_vector(run.rotation(1)).norm(), 1) << "or turned";
        // Equilibrium does not depend on the order of loads.
        EXPECT_LT((run.position(1) - at_once.position(1)).norm(), 1e-9);
        EXPECT_LT(rotation_vector(conjugate(run.rotation(1)) *
                                  at_once.rotation(1))
                    .norm(),
                  1e-9);
      }
  });
  const double displacement = run.displacement(1).norm(),
               rotation     = rotation_vector(run.rotation(1)).norm();
  EXPECT_LT(displacement, 1e-9);
  EXPECT_LT(rotation, 1e-9);
  std::cout << "left after the closed path: " << displacement << " m, "
            << rotation << " rad\n";
}
