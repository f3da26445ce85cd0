#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // A steel bar 1 m long.
  constexpr double E = 210e9, G = E / 2.6, rho = 7850, a = 0.1, k = 5. / 6;
  constexpr double A = a * a, I = a * a * a * a / 12;

  SceneText bar(const unsigned int dimension = 2)
  {
    return SceneText()
      .dimension(dimension)
      .frame(dimension == 2 ? "0 0; 1 0" : "0 0 0; 1 0 0", "0 1")
      .rectangle("steel", a, a, {E, rho, 0.3})
      .set("Sections/steel/Shear correction", "5/6")
      .mesh(4, 3)
      .time(1, 0.1, "newmark");
  }

  NaturalModes modes_of(const SceneText   &scene_text,
                        const unsigned int n,
                        const MPI_Comm     communicator = MPI_COMM_SELF)
  {
    const Scene scene = read_scene_from_text(scene_text.str(), "test.prm", {});
    LatticeRun  run(scene, communicator);
    run.prepare();
    if (scene.time.static_start)
      run.start();
    return natural_modes(run.solver(), run.solution.state, n);
  }

  SceneText about_equilibrium(SceneText scene)
  {
    return scene.set("Time/Start from", "static equilibrium");
  }

  /**
   * Eigenvalue of the pinned Timoshenko beam with n half waves: the smaller
   * root x of (rho^2 I / kG) x^2 - (rho A + rho (I + EI / kG) q^2) x + EI q^4
   * = 0 with q = n pi / L (Timoshenko 1921, Phil. Mag. 41, 744).
   */
  double pinned_beam(const unsigned int n)
  {
    const double q = n * M_PI, c0 = E * I * std::pow(q, 4),
                 c1 = rho * A + rho * I * (1 + E / (k * G)) * q * q,
                 c2 = rho * rho * I / (k * G);
    // This form avoids a difference of nearly equal numbers.
    return 2 * c0 / (c1 + std::sqrt(c1 * c1 - 4 * c2 * c0));
  }

  SceneText star_lattice()
  {
    SceneText star;
    star.cells("star", 3, 3)
      .rectangle("s", "0.4 mm", "0.4 mm", {"70 GPa", "2700 kg/m3", 0.33})
      .mesh(2)
      .support("foot", "bottom", "clamp")
      .time(1, 0.1, "newmark");
    return star;
  }
} // namespace

namespace
{
  /** Rigid edges hinged to soft struts, with many free motions. */
  SceneText hinged_edges(const unsigned int n_cells, const unsigned int order)
  {
    SceneText cells;
    cells.cells("star", n_cells, n_cells)
      .set("Lattice/Opening angle", "80 deg")
      .rectangle("s", "5 mm", "0.4 mm", {"20 MPa", 1100, 0.3})
      .rigid_part("edge", "edges", "1 g")
      .set("Rigid parts/edge/Parts", "single struts")
      .support("foot", "bottom", "pin")
      .mesh(order)
      .time("50 ms", "5 ms");
    return cells;
  }
} // namespace

TEST(NaturalModes, FindsManyFreeMotions)
{
  const NaturalModes found = modes_of(hinged_edges(3, 2), 12);
  EXPECT_TRUE(found.is_counted);
  ASSERT_EQ(found.modes.size(), 12u);
  for (const NaturalMode &mode : found.modes)
    EXPECT_EQ(mode.eigenvalue, 0);
}

TEST(NaturalModes, FindsAnyNumberOfMechanismModes)
{
  const SceneText    cell = hinged_edges(1, 1);
  const NaturalModes few = modes_of(cell, 12), all = modes_of(cell, 20);
  EXPECT_TRUE(few.is_counted);
  EXPECT_TRUE(all.is_counted);
  EXPECT_FALSE(all.count_differs);
  ASSERT_GE(all.modes.size(), 14u);
  for (unsigned int i = 0; i < 12; ++i)
    EXPECT_NEAR(all.modes[i].angular_frequency(),
                few.modes[i].angular_frequency(),
                1e-5 * few.modes[11].angular_frequency())
      << i;
  for (unsigned int i = 0; i < 14; ++i)
    EXPECT_LT(all.modes[i].residual, 1e-4) << i;
}

TEST(NaturalModes, MatchPinnedTimoshenkoBeam)
{
  const NaturalModes found = modes_of(bar()
                                        .mesh(6, 4)
                                        .support("left", "0", "pin")
                                        .support("right", "1", "roller x"),
                                      5);
  EXPECT_TRUE(found.is_counted);
  EXPECT_EQ(found.n_further_negative, 0u);
  std::vector<double> bending;
  for (const NaturalMode &mode : found.modes)
    {
      EXPECT_LT(mode.residual, 1e-5);
      // Axially the bar vibrates like a rod.
      if (std::abs(mode.participation[0]) < 1e-6)
        bending.push_back(mode.eigenvalue);
    }
  ASSERT_GE(bending.size(), 4u);
  for (unsigned int n = 1; n <= 4; ++n)
    EXPECT_NEAR(bending[n - 1] / pinned_beam(n), 1, 1e-8) << n;
}

TEST(NaturalModes, PairInSpace)
{
  // Bending along y and z alike: equal frequencies, counted.
  const NaturalModes found = modes_of(bar(3).support("left", "0", "clamp"), 4);
  EXPECT_TRUE(found.is_counted);
  EXPECT_NEAR(found.modes[1].eigenvalue / found.modes[0].eigenvalue, 1, 1e-9);
  EXPECT_NEAR(found.modes[3].eigenvalue / found.modes[2].eigenvalue, 1, 1e-9);
  EXPECT_GT(found.modes[2].eigenvalue, 2 * found.modes[0].eigenvalue);
}

TEST(NaturalModes, FreeBarHasThreeRigidBodyModes)
{
  const NaturalModes found = modes_of(bar(), 5);
  ASSERT_EQ(found.modes.size(), 5u);
  EXPECT_TRUE(found.is_counted);
  double along = 0, across = 0;
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(found.modes[i].eigenvalue, 0);
      along += std::pow(found.modes[i].participation[0], 2);
      across += std::pow(found.modes[i].participation[1], 2);
    }
  EXPECT_NEAR(along, rho * A, 1e-6 * rho * A);
  EXPECT_NEAR(across, rho * A, 1e-6 * rho * A);
  // A slender bar has (4.7300)^4 EI / rho A, reduced by some percent by shear.
  EXPECT_NEAR(found.modes[3].eigenvalue /
                (std::pow(4.73004, 4) * E * I / (rho * A)),
              0.93,
              0.05);
}

TEST(NaturalModes, EffectiveMassesSumUpToTheMass)
{
  // All modes of a coarse mesh; the mass next to the clamp counts, too.
  const NaturalModes found =
    modes_of(bar().mesh(2, 1).support("left", "0", "clamp"), 1000);
  EXPECT_EQ(found.modes.size(), 12u);
  EXPECT_TRUE(found.is_counted);
  double along = 0;
  for (const NaturalMode &mode : found.modes)
    along += std::pow(mode.participation[0], 2);
  EXPECT_GT(along, 0.9 * rho * A);
  EXPECT_LT(along, rho * A);
}

TEST(NaturalModes, StretchedBarVibratesAsString)
{
  // A thin wire: q^2 (T + EI q^2) / rho A.
  const double    d = 1e-3, T = 1000;
  const double    area = M_PI * d * d / 4, inertia = M_PI * std::pow(d, 4) / 64;
  const SceneText wire = SceneText()
                           .frame("0 0; 1 0", "0 1")
                           .circle("wire", d / 2, {E, rho, 0.3})
                           .mesh(4, 3)
                           .support("left", "0", "pin")
                           .support("right", "1", "roller x")
                           .set("Loads/pull/Joints", "1")
                           .set("Loads/pull/Force x", T)
                           .time(1, 0.1, "newmark");
  const NaturalModes found   = modes_of(about_equilibrium(wire), 3);
  const double       stretch = 1 + T / (E * area);
  for (unsigned int n = 1; n <= 3; ++n)
    {
      // The stretched wire has the same mass.
      const double q = n * M_PI / stretch,
                   exact =
                     q * q * (T + E * inertia * q * q) / (rho * area / stretch);
      EXPECT_NEAR(found.modes[n - 1].eigenvalue / exact, 1, 1e-4) << n;
    }
}

TEST(NaturalModes, LowestFrequencyVanishesAtBuckling)
{
  const auto pressed = [](const double part) {
    const double euler = M_PI * M_PI * E * I;
    return modes_of(about_equilibrium(
                      bar()
                        .support("left", "0", "pin")
                        .support("right", "1", "roller x")
                        .set("Loads/press/Joints", "1")
                        .set("Loads/press/Force x", -part * euler)),
                    2);
  };
  const NaturalModes below = pressed(0.5), above = pressed(1.1);
  EXPECT_GT(below.modes[0].eigenvalue, 0);
  EXPECT_LT(above.modes[0].eigenvalue, 0);
  EXPECT_GT(above.modes[0].growth_rate(), 0);
  EXPECT_EQ(above.modes[0].angular_frequency(), 0);
  EXPECT_GT(above.modes[1].eigenvalue, 0);
}

TEST(NaturalModes, MatchRigidRodOnSpring)
{
  // Rotation about its end: omega^2 = k L^2 / (m L^2 / 3).
  SceneText rod;
  rod.frame("0 0; 0 -2; 1 -2", "0 1")
    .rigid_part("rod", "0", "3 kg")
    .connector("spring", "spring", "Between = 1 2 | Spring stiffness = 70")
    .support("hinge", "0", "pin")
    .support("wall", "2", "pin")
    .time(1, 0.1, "newmark");
  const NaturalModes found = modes_of(rod, 5);
  ASSERT_EQ(found.modes.size(), 1u);
  EXPECT_TRUE(found.is_counted);
  EXPECT_NEAR(found.modes[0].eigenvalue / 70., 1, 1e-10);
}

TEST(NaturalModesOnRanks, AreTheSame)
{
  const SceneText    star     = star_lattice();
  const NaturalModes alone    = modes_of(star, 6),
                     together = modes_of(star, 6, MPI_COMM_WORLD);
  ASSERT_EQ(alone.modes.size(), 6u);
  ASSERT_EQ(together.modes.size(), 6u);
  EXPECT_TRUE(alone.is_counted && together.is_counted);
  for (unsigned int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(together.modes[i].eigenvalue / alone.modes[i].eigenvalue,
                  1,
                  1e-9);
      for (unsigned int d = 0; d < 2; ++d)
        // The sign depends on the numbering of unknowns.
        EXPECT_NEAR(std::abs(together.modes[i].participation[d]),
                    std::abs(alone.modes[i].participation[d]),
                    1e-6);
    }
}

TEST(NaturalModes, IterativeSolversGiveNoCount)
{
  const NaturalModes direct = modes_of(star_lattice(), 4),
                     iterative =
                       modes_of(star_lattice().set("Solver/Type", "gmres"), 4);
  EXPECT_TRUE(direct.is_counted);
  EXPECT_FALSE(iterative.is_counted);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(iterative.modes[i].eigenvalue / direct.modes[i].eigenvalue,
                1,
                1e-7);
}

// The blocks of bent struts in space are not symmetric; their sum is.
TEST(NaturalModes, LoadedFrameInSpaceMatchesPlane)
{
  const auto frequencies = [](const unsigned int dimension) {
    SceneText scene;
    scene.dimension(dimension)
      .frame("0 0; 0 1; 1 1", "0 1; 1 2")
      .circle("all", 0.01, {1e9, 1000, 0.3})
      .support("foot", "0", "clamp")
      .mesh(3, 1)
      .time(1, 0.1, "newmark")
      .set("Time/Start from", "static equilibrium");
    if (dimension == 2)
      scene.load("weight", "2", {"0", "-1", "0"});
    else
      scene.load("weight", "2", {"0", "-1", "0"}, {{"0", "0", "0"}});
    std::vector<double> found;
    for (const NaturalMode &mode : modes_of(scene, 6).modes)
      found.push_back(mode.angular_frequency());
    return found;
  };
  const std::vector<double> in_plane = frequencies(2),
                            in_space = frequencies(3);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_TRUE(std::any_of(in_space.begin(),
                            in_space.end(),
                            [&](const double frequency) {
                              return std::abs(frequency - in_plane[i]) <
                                1e-6 * in_plane[i];
                            }))
      << in_plane[i];
}

TEST(NaturalModes, FollowerLoadsAreRejected)
{
  const SceneText followed =
    bar()
      .support("left", "0", "clamp")
      .set("Loads/push/Joints", "1")
      .set("Loads/push/Force x", -1e6)
      .set("Loads/push/Direction", "follows the joint");
  const std::string refusal =
    input_error_of([&] { modes_of(about_equilibrium(followed), 2); });
  EXPECT_NE(refusal.find("not symmetric"), std::string::npos) << refusal;
}
