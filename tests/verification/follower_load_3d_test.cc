#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/singular_tangent.h>
#include <verification/space_run.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const SpaceTexts no_force = {{"0", "0", "0"}};

  // A strut of unit length along x, clamped at x = 0, with EI the same about
  // both axes, but GJ another. A moment at its tip is the same vector m in all
  // sections, and in their own axes it turns about axis 1 with the rate
  //   a = m_1 (1/GJ - 1/EI).
  // So R(s) = exp(s m/EI) exp(s a e_1), and the axis is a helix about m:
  //   r(1) = integral of exp(s m/EI) e_1.
  // A dead moment is m; of one that follows, M at rest, it is R(1) M, which is
  // solved by m = exp(a e_1) M, with m_1 = M_1.
  constexpr double torsion = 0.8, bending = 2;

  SpaceVector end_of_helix(const SpaceVector &moment)
  {
    // The integral of Rodrigues' formula.
    const SpaceVector curvature = moment / bending, e1({1., 0., 0.});
    const double      angle     = curvature.norm();
    const SpaceVector n = curvature / angle, across = cross_product_3d(n, e1);
    return e1 + (1 - std::cos(angle)) / angle * across +
      (1 - std::sin(angle) / angle) * cross_product_3d(n, across);
  }
} // namespace

TEST(FollowerLoad3d, MomentAboutASkewAxisDeadAndFollower)
{
  const SpaceVector moment({1.5, 2., -1.});
  const double      rate       = moment[0] * (1 / torsion - 1 / bending);
  const Quaternion  precession = exponential(SpaceVector({rate, 0., 0.}));
  ComparisonTable   table("Tip of a cantilever under a skew moment, closed "
                          "form");
  for (const bool follows : {false, true})
    {
      SceneText scene = static_space_frame("0 0 0; 1 0 0", "0 1");
      scene.space_section({100, 100, 100, torsion, bending, bending})
        .load("tip", "1", no_force, times(moment, "t"))
        .support("clamp", "0", "clamp")
        .mesh(4, 3)
        .time(1, 0.1)
        .set("Loads/tip/Direction", follows ? "follows the joint" : "fixed");
      SpaceRun run(scene.str());
      run.run();

      const SpaceVector m = follows ? rotated(precession, moment) : moment;
      const SpaceVector position = end_of_helix(m);
      const Quaternion  rotation = exponential(m / bending) * precession;
      const std::string name     = follows ? "following" : "dead";
      // Four points integrate the arc of 0.15 rad of an element to round-off;
      // the rest is what Newton's tolerance of 1e-11 leaves.
      for (unsigned int c = 0; c < 3; ++c)
        table.row(name + ": " + "xyz"[c],
                  run.position(1)[c],
                  position[c],
                  1e-11);
      table.row(name + ": rotation from the closed form",
                rotation_vector(conjugate(rotation) * run.rotation(1)).norm(),
                0,
                1e-11);
      for (unsigned int c = 0; c < 3; ++c)
        table.row(name + ": moment of the clamp about " + "xyz"[c],
                  run.moment("clamp")[c],
                  -m[c],
                  1e-11);
    }
}

TEST(FollowerLoad3d, ForceTurnsWithTheTip)
{
  // The clamp's force and moment balance the force where the tip has taken it.
  const SpaceVector force({-1., 4., 3.});
  SceneText         scene = static_space_frame("0 0 0; 1 0 0", "0 1");
  scene.space_section({100, 100, 100, torsion, bending, bending})
    .load("tip", "1", times(force, "t"), no_force)
    .support("clamp", "0", "clamp")
    .mesh(3, 2)
    .time(1, 0.1)
    .set("Loads/tip/Direction", "follows the joint");
  SpaceRun run(scene.str());
  run.run();
  EXPECT_GT(rotation_vector(run.rotation(1)).norm(), 0.5) << "hardly turned";
  const SpaceVector at_tip = rotated(run.rotation(1), force);
  EXPECT_LT((run.force("clamp") + at_tip).norm(), 1e-9);
  EXPECT_LT(
    (run.moment("clamp") + cross_product_3d(run.position(1), at_tip)).norm(),
    1e-9);
}

TEST(FollowerLoad3d, LeesFrameInTheYZPlane)
{
  // Lee's frame with the load turning with its section: the limit load by
  // shooting, shear-rigid. Out of its plane the frame is made stiff.
  const double axial = 7.2e6 * 6, bending_stiffness = 7.2e6 * 2, stiff = 1e9;
  const auto   eigenvalue = [&](const double load) {
    SceneText scene = static_space_frame("0 0 0; 0 0 120; 0 24 120; 0 120 120",
                                         "0 1; 1 2; 2 3");
    // Struts bend in the plane about axis 3.
    scene
      .space_section(
        {axial, 1000 * axial, 1000 * axial, stiff, stiff, bending_stiffness})
      .set("Sections/all/Reference vector", "1 0 0");
    scene.prescribe("hinges", "0, 3", no_force, {{"free", "0", "0"}})
      .load("force", "2", times(SpaceVector({0., 0., -load}), "t"), no_force)
      .mesh(4, 3)
      .time(1, 0.05)
      .set("Loads/force/Direction", "follows the joint");
    SpaceRun run(scene.str());
    run.run();
    return smallest_eigenvalue(run);
  };
  // At a limit load the eigenvalue e becomes zero as the root of what is left
  // to it: P = P_limit + a e^2 + b e^3, through three points.
  const double reference = 35437.9945;
  SpaceVector  load;
  SpaceTensor  powers;
  for (unsigned int i = 0; i < 3; ++i)
    {
      load[i]        = reference * (1 - 1e-5 * (i + 1) * (i + 1));
      const double e = eigenvalue(load[i]);
      powers[i][0]   = 1;
      powers[i][1]   = e * e;
      powers[i][2]   = e * e * e;
    }
  ComparisonTable table("Lee's frame in the plane of y and z, following load, "
                        "rod equation by shooting");
  table.relative("limit load", (invert(powers) * load)[0], reference, 1e-6);
}
