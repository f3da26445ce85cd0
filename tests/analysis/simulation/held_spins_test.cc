#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/verdict.h>

#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Bars between ball hinges, which are free to spin about their axes.
namespace
{
  constexpr double E = 210e9, radius = 12.6157e-3;
  constexpr double EA = E * pi * radius * radius,
                   EI = E * pi / 4 * radius * radius * radius * radius;

  const std::string feet = "2 0 0; -1 1.7320508 0; -1 -1.7320508 0";

  /** Three bars from the ground to joint 3 at a height of 3 m. */
  SceneText tripod()
  {
    return static_space_frame(feet + "; 0 0 3", "0 3; 1 3; 2 3")
      .circle("bar", radius, {E, 1})
      .hinge("pins", "all")
      .support("ground", "0, 1, 2", "pin")
      .time(1, 1);
  }

  /** Stiffness of the top: K = sum of EA / L n n^T, which is diagonal (N/m). */
  struct TripodStiffness
  {
    double length    = std::sqrt(13.);
    double along_bar = EA / length;
    double across    = along_bar * 3. / 2 * 4 / 13;
    double up        = along_bar * 3 * 9. / 13;
  };

  /** Loaded by forces along x and z (N). */
  SceneText loaded(SceneText scene, const double size = 1)
  {
    return scene.load("P",
                      "3",
                      {text(1e4 * size) + " * t",
                       "0",
                       text(-2e4 * size) + " * t"},
                      {"0", "0", "0"});
  }

  unsigned int n_free_spins(const SceneText &scene_text)
  {
    const Scene   scene   = read_scene_from_text(scene_text.str(), "test.prm");
    const Lattice lattice = build_lattice(scene);
    return LatticeModel(scene, lattice, MPI_COMM_SELF).free_spins.size();
  }

  /** A bar of 1 m along x from the ground, of @p n struts in line. */
  SceneText straight_bar(const unsigned int n)
  {
    std::string joints = "0 0 0", struts;
    for (unsigned int i = 1; i <= n; ++i)
      {
        joints += "; " + text(double(i) / n) + " 0 0";
        struts +=
          (i > 1 ? "; " : "") + std::to_string(i - 1) + " " + std::to_string(i);
      }
    return static_space_frame(joints, struts)
      .circle("bar", 0.01, {1e9, 1e3})
      .hinge("pins", "0, " + std::to_string(n))
      .support("ground", "0", "pin");
  }
} // namespace

TEST(HeldSpins, TrussOfBallHingesMovesAsItsBarsStretch)
{
  const TripodStiffness K;
  for (const std::string rotation : {"on", "off", "auto"})
    {
      SCOPED_TRACE(rotation);
      SceneRun run(loaded(tripod()).set("Effects/Large rotation", rotation));
      run.run();
      // Rotations differ by the strain, 2e-4.
      const double error = rotation == "off" ? 1e-9 : 1e-3;
      EXPECT_NEAR(run.motion(3, 0), 1e4 / K.across, error * 1e4 / K.across);
      EXPECT_NEAR(run.motion(3, 1), 0, 1e-12);
      EXPECT_NEAR(run.motion(3, 2), -2e4 / K.up, error * 2e4 / K.up);
    }
  // Feet with free rotations need no hinges.
  SceneRun run(loaded(tripod()).hinge("pins", "3").linear());
  run.run();
  EXPECT_NEAR(run.motion(3, 0), 1e4 / K.across, 1e-9 * 1e4 / K.across);
}

TEST(HeldSpins, AreReportedOnce)
{
  const Scene scene = read_scene_from_text(loaded(tripod()).str(), "t.prm");
  const LatticeRun run(scene, MPI_COMM_SELF);
  unsigned int     n = 0;
  for (const std::string &note : notes_on(run.equations))
    if (note.find(
          "strut 0, strut 1, strut 2 could turn about their own axes") !=
        std::string::npos)
      ++n;
  EXPECT_EQ(n, 1u);
  EXPECT_TRUE(findings_of(loaded(tripod(), 0.1)).empty());
}

TEST(HeldSpins, BarBearsItsStretchAtLargeRotations)
{
  // An end rotates by 3 rad while the bar is stretched by 10 %: EA 0.1.
  for (const unsigned int n : {1u, 2u})
    {
      SceneRun run(straight_bar(n)
                     .add("Supports/moved",
                          "Joints = " + std::to_string(n) +
                            " | Type = prescribed | "
                            "Displacement x = (1 + 0.1*t)*cos(3*t) - 1 | "
                            "Displacement y = (1 + 0.1*t)*sin(3*t)*0.8 | "
                            "Displacement z = (1 + 0.1*t)*sin(3*t)*0.6")
                     .time(1, 0.05));
      run.run();
      const double force = 1e9 * pi * 1e-4 * 0.1;
      EXPECT_NEAR(run.reaction("moved", 0), force * std::cos(3.), 1e-6 * force);
      EXPECT_NEAR(run.reaction("moved", 1),
                  force * std::sin(3.) * 0.8,
                  1e-6 * force);
      EXPECT_NEAR(run.reaction("moved", 2),
                  force * std::sin(3.) * 0.6,
                  1e-6 * force);
    }
}

TEST(HeldSpins, ModesAreThoseOfAMassOnBars)
{
  const TripodStiffness K;
  constexpr double      mass  = 1000;
  const Scene           scene = read_scene_from_text(tripod()
                                             .set("Analysis", "modes")
                                             .mass("top", "3", mass)
                                             .time(1, 1, "newmark")
                                             .str(),
                                           "test.prm");
  LatticeRun            run(scene, MPI_COMM_SELF);
  run.prepare();
  const NaturalModes found = natural_modes(run.solver(), run.solution.state, 3);
  ASSERT_EQ(found.modes.size(), 3u);
  for (const unsigned int i : {0u, 1u})
    EXPECT_NEAR(found.modes[i].angular_frequency(),
                std::sqrt(K.across / mass),
                1e-5 * std::sqrt(K.across / mass));
  EXPECT_NEAR(found.modes[2].angular_frequency(),
              std::sqrt(K.up / mass),
              1e-5 * std::sqrt(K.up / mass));
}

TEST(HeldSpins, BarsBuckleAsEulersDo)
{
  // Each bears 2e4 N / 3 times 13^1/2 / 3.
  const TripodStiffness K;
  const Scene           scene = read_scene_from_text(
    tripod()
      .load("P", "3", {"0", "0", "-2e4*t"}, {"0", "0", "0"})
      .mesh(4, 1)
      .str(),
    "test.prm");
  LatticeRun run(scene, MPI_COMM_SELF);
  run.prepare();
  const BucklingModes found =
    buckling_modes(run.solver(), run.solution.state, {1., false}, 3);
  const double euler = pi * pi * EI / (K.length * K.length),
               force = 2e4 / 3 * K.length / 3;
  ASSERT_EQ(found.modes.size(), 3u);
  for (const BucklingMode &mode : found.modes)
    EXPECT_NEAR(mode.factor, euler / force, 1e-3 * euler / force);
}

TEST(HeldSpins, MotionBeginsFromStaticEquilibrium)
{
  // The load is constant, and so is the position of the truss.
  const TripodStiffness K;
  SceneRun              run(tripod()
                 .load("P", "3", {"1e4", "0", "-2e4"}, {"0", "0", "0"})
                 .mass("top", "3", 1000)
                 .set("Time/Start from", "static equilibrium")
                 .time(0.01, 0.001, "newmark"));
  run.run();
  EXPECT_NEAR(run.motion(3, 0), 1e4 / K.across, 1e-3 * 1e4 / K.across);
  EXPECT_NEAR(run.motion(3, 2), -2e4 / K.up, 2e-3 * 2e4 / K.up);
}

TEST(HeldSpins, AreThoseOfStraightBarsThatNothingTurns)
{
  EXPECT_EQ(n_free_spins(tripod()), 3u);
  EXPECT_EQ(n_free_spins(straight_bar(1)), 1u);
  EXPECT_EQ(n_free_spins(straight_bar(3)), 1u);
  // A moment spins it, a clamp or an arm restrains it; a curved bar swings.
  EXPECT_EQ(
    n_free_spins(
      straight_bar(2).load("turn", "1", {"0", "0", "0"}, {"1", "0", "0"})),
    0u);
  EXPECT_EQ(n_free_spins(straight_bar(2).support("held", "1", "clamp")), 0u);
  EXPECT_EQ(n_free_spins(
              straight_bar(2)
                .set("Effects/Large rotation", "off")
                .add("Constraints/lever",
                     "Type = linear relation | Relation = rotation x of 1")),
            0u);
  EXPECT_EQ(n_free_spins(
              straight_bar(2)
                .set("Lattice/Joints", "0 0 0; 0.5 0 0; 1 0 0; 0.5 1 0")
                .set("Lattice/Struts", "0 1; 1 2; 1 3")),
            0u);
  EXPECT_EQ(n_free_spins(
              straight_bar(2).set("Lattice/Joints", "0 0 0; 0.5 0.1 0; 1 0 0")),
            0u);
  // One end is released, the other rotates in its support.
  const SceneText on_pin =
    straight_bar(1).hinge("pins", "0").support("end", "1", "pin");
  EXPECT_EQ(n_free_spins(on_pin), 1u);
  EXPECT_EQ(n_free_spins(SceneText(on_pin).support("end", "1", "clamp")), 0u);
  EXPECT_EQ(
    n_free_spins(
      SceneText(on_pin).load("turn", "1", {"0", "0", "0"}, {"1", "0", "0"})),
    0u);
}
