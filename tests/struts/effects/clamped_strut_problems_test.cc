#include <auxfem/struts/effects/clamped_strut_problems.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two struts of 1 m at a right angle, EA = 100 N, kGA = 50 N, EI = 1 N m2.
   */
  SceneText corner()
  {
    return static_frame("0 0; 1 0; 1 1", "0 1; 1 2")
      .section({100, 50, 1})
      .support("foot", "0", "clamp");
  }

  /** Order of the prescribed strut motions. */
  constexpr unsigned int motion_order = 2;

  /** Motion of a strut along x whose second end moves by @p v and rotates. */
  StrutMotion moved_end(const double v, const double rotation)
  {
    StrutMotion motion;
    motion.order        = motion_order;
    motion.n_elements   = 1;
    motion.displacement = {0, 0, 0, 0, v / 2, rotation / 2, 0, v, rotation};
    return motion;
  }

  struct ClampedCorner
  {
    ClampedCorner(const SceneText   &text,
                  const unsigned int order,
                  const unsigned int n_elements = 1)
      : setup(SceneText(text).mesh(motion_order).str(), {}, MPI_COMM_SELF)
      , struts(setup.model,
               std::vector<StrutDivision>(2, {order, n_elements}),
               owned_struts(setup.model.numbering))
    {}

    EquationsOnRanks     setup;
    ClampedStrutProblems struts;
  };
} // namespace

TEST(StrutMotion, InterpolationReproducesPolynomials)
{
  // u_x = s, u_y = s^2, rotation = 1 - s on two elements of order 2.
  StrutMotion motion;
  motion.order      = 2;
  motion.n_elements = 2;
  for (const double s : {0., 0.25, 0.5, 0.75, 1.})
    for (const double value : {s, s * s, 1 - s})
      motion.displacement.push_back(value);
  const StrutMotion finer = interpolated(motion, {4, 4});
  ASSERT_EQ(finer.n_nodes(), 17u);
  ASSERT_EQ(finer.displacement.size(), 3 * 17u);
  EXPECT_TRUE(finer.velocity.empty());
  for (unsigned int node = 0; node < 17; ++node)
    {
      const double s = finer.displacement[3 * node];
      EXPECT_NEAR(finer.displacement[3 * node + 1], s * s, 1e-14);
      EXPECT_NEAR(finer.displacement[3 * node + 2], 1 - s, 1e-14);
    }
  // Element ends keep their positions, up to the last node.
  EXPECT_NEAR(finer.displacement[3 * 4], 0.25, 1e-14);
  EXPECT_NEAR(finer.displacement[3 * 16], 1, 1e-14);
}

TEST(ClampedStrutProblems, EquilibriumHasTheEnergyOfABeamWithMovedEnds)
{
  // Clamped at one end, the other moved by v without rotation: F = 12 EI v /
  // (L^3 (1 + 12 EI / (kGA L^2))), exact for cubics.
  const double v = 1e-3, stiffness = 12 / (1 + 12. / 50);
  for (const unsigned int order : {3u, 5u})
    {
      ClampedCorner clamped(corner().linear(), order);
      clamped.struts.move(0, moved_end(v, 0));
      ASSERT_TRUE(clamped.struts.solve_equilibrium());
      EXPECT_NEAR(clamped.struts.strain_energy(),
                  stiffness * v * v / 2,
                  1e-12 * stiffness * v * v);
    }
}

TEST(ClampedStrutProblems, DifferenceIsThatOfTheForcesOnTheEnds)
{
  // A sheared element of order 1 has F = kGA v / L and the end moment F L / 2;
  // the exact beam has F = stiffness * v. The difference d loads the strut by F
  // = d, M = d L / 2 at its end: d^2 (1 / kGA + 1 / (12 EI)), with L = 1.
  const SceneText text = corner().linear();
  const double    v = 1e-3, stiffness = 12 / (1 + 12. / 50);
  ClampedCorner   linear(text, 1), cubic(text, 3);
  linear.struts.move(0, moved_end(v, 0));
  cubic.struts.move(0, moved_end(v, 0));
  ASSERT_TRUE(linear.struts.solve_equilibrium());
  ASSERT_TRUE(cubic.struts.solve_equilibrium());
  const double d = (50 - stiffness) * v, exact = d * d * (1. / 50 + 1. / 12);
  EXPECT_NEAR(cubic.struts.difference(0, linear.struts), exact, 1e-10 * exact);
  EXPECT_NEAR(linear.struts.difference(0, cubic.struts), exact, 1e-10 * exact);
  // The other strut is at rest in both.
  EXPECT_NEAR(cubic.struts.difference(1, linear.struts), 0, 1e-20);
}

TEST(ClampedStrutProblems, RigidMotionsNeedNoForces)
{
  // The first strut rotates by a right angle about its first joint.
  const double pi = std::acos(-1.);
  StrutMotion  motion;
  motion.order      = motion_order;
  motion.n_elements = 1;
  for (const double s : {0., 0.5, 1.})
    for (const double value : {-s, s, pi / 2})
      motion.displacement.push_back(value);
  ClampedCorner coarse(corner(), 2), fine(corner(), 4, 2);
  for (ClampedCorner *clamped : {&coarse, &fine})
    {
      clamped->struts.move(0, motion);
      ASSERT_TRUE(clamped->struts.solve_equilibrium());
      EXPECT_NEAR(clamped->struts.strain_energy(), 0, 1e-25);
    }
  EXPECT_NEAR(fine.struts.difference(0, coarse.struts), 0, 1e-25);
}

TEST(ClampedStrutProblems, ConvergeFromAMotionOfLowOrderFarFromEquilibrium)
{
  // Slender struts, the first one bent to an arc of 150 degrees. A parabola
  // through three of its points has axial and shear strains of tens of per
  // cent.
  const double angle = 5 * std::acos(-1.) / 6;
  StrutMotion  motion;
  motion.order      = motion_order;
  motion.n_elements = 1;
  for (const double s : {0., 0.5, 1.})
    for (const double value : {std::sin(angle * s) / angle - s,
                               (1 - std::cos(angle * s)) / angle,
                               angle * s})
      motion.displacement.push_back(value);
  for (const unsigned int order : {4u, 5u, 6u})
    {
      ClampedCorner clamped(corner().section({1e5, 4e4, 1}), order, 2);
      clamped.struts.move(0, motion);
      ASSERT_TRUE(clamped.struts.solve_equilibrium());
      EXPECT_EQ(clamped.struts.last_correction_work(0), 0) << order;
      EXPECT_NEAR(clamped.struts.strain_energy(),
                  angle * angle / 2,
                  1e-3 * angle * angle)
        << order;
    }
}
