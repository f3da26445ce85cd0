#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/analysis/small_motions/motion_pencil.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

#include <analysis/small_motions/held_rod.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Number = std::complex<double>;

  /**
   * An axially vibrating rod of 1 m with sqrt(EA / m) = 1 m/s, fixed at its
   * left end, with damping @p beta.
   */
  SceneText unit_rod(const double beta)
  {
    return held_rod(1, 1, beta, 2);
  }

  /** A run that is prepared for a mode analysis. */
  struct PreparedRun
  {
    explicit PreparedRun(const SceneText &text,
                         const MPI_Comm   communicator = MPI_COMM_WORLD)
      : scene(read_scene_from_text(text.str(), "test.prm"))
      , run(plan_of_modes(scene), communicator)
    {
      run.prepare();
      if (run.model.plan.time.static_start)
        run.start();
    }

    MotionPencil pencil(const Damping damping)
    {
      return {run.solver(), run.solution.state, damping};
    }

    const Scene scene;
    LatticeRun  run;
  };

  /** A column under a follower force of 21 N, which causes flutter. */
  SceneText pressed_column()
  {
    SceneText scene;
    scene.set("Analysis", "modes")
      .frame("0 0; 0 1; 0 0.5", "0 2; 2 1")
      .section({1e6, 1e6, 1})
      .set("Sections/section 0/Density", 1e-6)
      .load("turning", "1", {"0", "-21", "0"})
      .set("Loads/turning/Direction", "follows the joint")
      .support("clamp", "0", "clamp")
      .mesh(4, 0)
      .set("Modes/About", "static equilibrium")
      .set("Effects/Rotary inertia", "off");
    return scene.time(1, 0.1, "newmark");
  }

  /** Bending is much faster than the axial motions of these tests. */
  double omega_of(const unsigned int i)
  {
    return (i + 0.5) * pi;
  }

  Relaxations slowest_relaxations(const SceneText &scene, const unsigned int n)
  {
    PreparedRun prepared(scene);
    return relaxations(prepared.run.solver(), prepared.run.solution.state, n);
  }
} // namespace

TEST(ComplexModes, OmitOverdampedModes)
{
  // The third mode has 1.2 times the critical damping.
  PreparedRun prepared(unit_rod(2.4 / omega_of(2)));
  auto        pencil = prepared.pencil(Damping::all);
  const auto  found  = pencil.nearest(0.1, {swings, 100, 9.});
  EXPECT_TRUE(found.is_complete);
  EXPECT_EQ(found.roots.size(), 2u);
}

TEST(ComplexModes, MatchDampedRod)
{
  PreparedRun prepared(unit_rod(0.05));
  auto        pencil = prepared.pencil(Damping::all);
  const auto  found  = pencil.nearest(0.1, {swings, 100, 9.}).roots;
  ASSERT_EQ(found.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(found[i].s.real(),
                  -0.025 * omega_of(i) * omega_of(i),
                  1e-5 * omega_of(i));
      EXPECT_NEAR(std::abs(found[i].s), omega_of(i), 1e-5 * omega_of(i));
      EXPECT_LT(found[i].residual, 1e-7);
    }
}

// Two equal rods side by side have each root twice, with two shapes.
TEST(ComplexModes, FindsAllEqualRoots)
{
  SceneText scene = unit_rod(0.05);
  scene.frame("0 0; 1 0; 0 1; 1 1", "0 1; 2 3")
    .support("wall", "0, 2", "clamp")
    .support("guide", "1, 3", "roller x");
  PreparedRun prepared(scene);
  auto        pencil = prepared.pencil(Damping::all);
  EXPECT_EQ(pencil.nearest(0.1, {swings, 100, 6.}).roots.size(), 4u);
}

TEST(ComplexModes, AreTheSameOnAllRanks)
{
  std::vector<ComplexModes> found;
  for (const MPI_Comm communicator : {MPI_COMM_SELF, MPI_COMM_WORLD})
    {
      PreparedRun prepared(pressed_column(), communicator);
      EXPECT_FALSE(
        has_natural_modes(prepared.run.solver(), prepared.run.solution.state));
      found.push_back(complex_modes(prepared.run.solver(),
                                    prepared.run.solution.state,
                                    2,
                                    Damping::none));
    }
  ASSERT_EQ(found[0].modes.size(), 2u);
  ASSERT_EQ(found[1].modes.size(), 2u);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_LT(std::abs(found[0].modes[i].s - found[1].modes[i].s), 1e-5);
  EXPECT_TRUE(found[1].modes[0].grows() || found[1].modes[1].grows());
}

TEST(ComplexModes, FollowerLoadsVanishAtRest)
{
  PreparedRun prepared(pressed_column().set("Modes/About", "rest"));
  EXPECT_TRUE(
    has_natural_modes(prepared.run.solver(), prepared.run.solution.state));
}

// At the rate x, the force k x tau / (1 - x tau) of the elements at the end
// balances that of the rod, EA x coth x (L = 1 m, wave speed 1 m/s).
TEST(Relaxations, MatchMaxwellElementsAtRod)
{
  const double k[] = {3, 2}, tau[] = {0.9, 0.1};
  SceneText    scene = unit_rod(0);
  scene.connector("damper",
                  "generalized-maxwell",
                  "Between = ground: 1 | Geometry = direction | Direction = 1 "
                  "0 | Long-time stiffness = 0 | Stiffnesses = 3, 2 | "
                  "Relaxation times = 0.9, 0.1");
  const Relaxations found = slowest_relaxations(scene, 2);
  ASSERT_EQ(found.size(), 2u);
  for (const Relaxation &relaxation : found)
    {
      const double x   = relaxation.rate;
      double       sum = -x / std::tanh(x);
      for (unsigned int i = 0; i < 2; ++i)
        sum += k[i] * x * tau[i] / (1 - x * tau[i]);
      EXPECT_NEAR(sum, 0, 1e-5 * x);
      EXPECT_LT(relaxation.residual, 1e-6);
    }
  EXPECT_GT(found[0].time(), found[1].time());
}

// With a dashpot above the impedance of the rod, s = -atanh(1 / c) does not
// oscillate.
TEST(Relaxations, MatchStrongDashpot)
{
  SceneText scene = unit_rod(0);
  scene.connector("damper",
                  "dashpot",
                  "Between = ground: 1 | Geometry = direction | Direction = 1 "
                  "0 | Damping coefficient = 2");
  const Relaxations found = slowest_relaxations(scene, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].rate, std::atanh(0.5), 1e-6);
}

// Equal elements on equal rods have each relaxation twice.
TEST(Relaxations, FindsAllEqualRoots)
{
  SceneText scene = unit_rod(0);
  scene.frame("0 0; 1 0; 0 1; 1 1", "0 1; 2 3")
    .support("wall", "0, 2", "clamp")
    .support("guide", "1, 3", "roller x")
    .connector("damper",
               "maxwell",
               "Between = ground: 1, 3 | Geometry = direction | "
               "Direction = 1 0 | Spring stiffness = 3 | Damping coefficient "
               "= 6");
  const Relaxations found = slowest_relaxations(scene, 2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].rate, found[1].rate, 1e-6);
}

// Stiffness-proportional damping clusters very many relaxations at beta. These
// are omitted, slower ones are not.
TEST(Relaxations, OmitsClusters)
{
  SceneText scene = unit_rod(0.01);
  scene.connector("damper",
                  "maxwell",
                  "Between = ground: 1 | Geometry = direction | Direction = 1 "
                  "0 | Spring stiffness = 3 | Damping coefficient = 6");
  const Relaxations found = slowest_relaxations(scene, 3);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].time(), 2);
}
