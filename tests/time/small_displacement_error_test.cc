#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/recorder.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/time/small_displacement_error.h>

#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>
#include <random>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  struct SmallOutcome
  {
    SmallDisplacementError estimate;
    std::vector<double>    displacement; ///< of joints, x and y in turn (m)
  };

  /** Outcome of a scene by small displacements or exact kinematics. */
  SmallOutcome small_outcome_of(const std::string &text,
                                const bool         is_exact,
                                const MPI_Comm     communicator = MPI_COMM_SELF)
  {
    const Scene scene =
      read_scene_from_text(text,
                           "test.prm",
                           {std::string("Effects/Large rotation=") +
                            (is_exact ? "on" : "off")});
    LatticeRun     run(scene, communicator);
    MemoryRecorder recorder(scene, communicator);
    run.run(recorder);
    SmallOutcome outcome{
      SmallDisplacementEstimate(run.equations).at(run.solution.state),
      {}};
    for (unsigned int joint = 0; joint < run.lattice.joints.size(); ++joint)
      for (unsigned int c = 0; c < 2; ++c)
        if (const int unknown = run.model.numbering.joint_unknown(joint, c);
            unknown >= 0)
          outcome.displacement.push_back(
            run.solution.state.displacement[unknown]);
    return outcome;
  }

  /** Difference of the displacements of all joints. */
  double relative_difference(const SmallOutcome &one, const SmallOutcome &other)
  {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < one.displacement.size(); ++i)
      {
        difference += std::pow(one.displacement[i] - other.displacement[i], 2);
        size += std::pow(one.displacement[i], 2);
      }
    return std::sqrt(difference / size);
  }

  /** A clamped column of four struts, EI = 1 N m2, 1 m. */
  SceneText chain(const std::string &along, const std::string &across)
  {
    return SceneText()
      .frame("0 0; 0.25 0; 0.5 0; 0.75 0; 1 0", "0 1; 1 2; 2 3; 3 4")
      .section({1e5, 1e5, 1})
      .support("foot", "0", "clamp")
      .load("end", "4", {along, across, "0"})
      .mesh(3)
      .time(1, 0.125, "static");
  }
} // namespace

TEST(SmallDisplacementEstimate, HasTheAxialForcesOfTheStruts)
{
  // Straight struts are judged by their chords, arcs by their forces.
  for (const unsigned int dimension : {2u, 3u})
    for (const bool is_arc : {false, true})
      for (const unsigned int order : {1u, 3u})
        {
          SCOPED_TRACE(std::to_string(dimension) + " " +
                       std::to_string(is_arc) + " " + std::to_string(order));
          const std::string struts =
            is_arc ? "0 1 0.1; 1 2 0.1; 0 2 0.1" : "0 1; 1 2; 0 2";
          SceneText text;
          if (dimension == 2)
            text.frame("0 0; 1 0; 1.2 0.8", struts);
          else
            text.dimension(3).frame("0 0 0; 1 0 0; 1.2 0.8 0.3", struts);
          text.circle("rod", 0.01, {70e9, 2700, 0.3})
            .mesh(order)
            .set("Effects/Large rotation", "off");
          const Scene      scene = read_scene_from_text(text, "test.prm");
          const LatticeRun run(scene, MPI_COMM_SELF);
          State            state = run.equations.initial_state();
          std::mt19937     generator(5);
          for (double &value : state.displacement)
            value = std::uniform_real_distribution<double>(-1, 1)(generator);
          const SmallDisplacementEstimate estimate(run.equations);
          const auto        compressions = estimate.at(state).compressions;
          const StrutGroup &group = run.equations.reporting().struts.at(0);
          ASSERT_EQ(compressions.size(), 3u);
          for (unsigned int e = group.forces->elements().begin;
               e < group.forces->elements().end;
               ++e)
            {
              const unsigned int strut =
                run.model.numbering.elements()[e].interval.strut;
              const Section &section = run.model.sections.at(0);
              const double   length =
                run.lattice.length(run.lattice.struts[strut]);
              const double expected =
                std::max(0.,
                         -group.forces->axial_force(state, e) * length *
                           length / (pi * pi * section.bending_stiffness_3()));
              EXPECT_NEAR(compressions[strut], expected, 1e-9 * (1 + expected));
            }
        }
}

TEST(SmallDisplacementEstimate, KnowsTheSlopeOfACantilever)
{
  // F = 0.2 N: slope F L^2 / 2 EI at the end.
  const SmallDisplacementError error =
    small_outcome_of(chain("0", "0.2 * t"), /*is_exact=*/false).estimate;
  EXPECT_NEAR(error.rotation, 0.1, 1e-6);
  EXPECT_NEAR(error.second_order, 0, 1e-8);
  EXPECT_NEAR(error.strain, 0, 1e-8);
  EXPECT_EQ(error.location, "strut 3");
}

TEST(SmallDisplacementEstimate, KnowsHowAxialForcesChangeTheStiffness)
{
  // All struts together buckle at pi^2 EI / 4 L^2, a single one at 64 times
  // that. A fifth of it, in compression and in tension.
  const double load = 0.2 * pi * pi / 4;
  for (const double sign : {-1., 1.})
    {
      const SceneText pressed  = chain(text(sign * load) + " * t", "1e-3 * t");
      const SmallOutcome small = small_outcome_of(pressed, false),
                         exact = small_outcome_of(pressed, true);
      EXPECT_NEAR(small.estimate.second_order, 0.2, 0.01);
      // The exact error is 1 / (1 -+ 0.2) - 1.
      EXPECT_NEAR(relative_difference(small, exact),
                  1 / (1 / 0.2 + sign),
                  0.01);
    }
}

TEST(SmallDisplacementEstimate, BoundsTheErrorOfABendingLattice)
{
  const auto star = [](const double load) {
    return SceneText()
      .cells("star", 2, 2)
      .add("Lattice", "Strut length = 10 mm | Opening angle = 60 deg")
      .rectangle("s", "0.4 mm", "0.4 mm", {"70 GPa"})
      .support("foundation", "bottom", "clamp")
      .load("pressure", "top", {"0", text(load) + " * t", "0"})
      .mesh(3)
      .time(1, 0.25, "static");
  };
  // To first order in small loads.
  const auto ratio = [&star](const double load) {
    const SmallOutcome small = small_outcome_of(star(load), false),
                       exact = small_outcome_of(star(load), true);
    return small.estimate.total() / relative_difference(exact, small);
  };
  for (const double load : {-0.1, 0.1})
    {
      EXPECT_GT(ratio(load), 1);
      EXPECT_LT(ratio(load), 2);
    }
  // At an error of about a tenth.
  for (const double load : {-1., 1.})
    {
      EXPECT_GT(ratio(load), 0.4);
      EXPECT_LT(ratio(load), 2);
    }
}

TEST(SmallDisplacementEstimate, SeesRigidPartsAndConnectors)
{
  // A lever of 0.1 m rotates by 0.05 rad, a spring by 5 mm over its length.
  const auto with_spring = [](const std::string &length) {
    return small_outcome_of(
             SceneText()
               .frame("0 0; 0.1 0", "0 1")
               .rigid_part("lever", "all", 1)
               .support("held", "0", "pin")
               .connector("spring",
                          "spring",
                          "Between = ground: 1 | Spring stiffness = 1 | "
                          "Ground offset = " +
                            length + ", 0, 0")
               .prescribe("lift", "1", {"free", "0.005 * t^4", "free"})
               .time(1, 0.01, "newmark"),
             false)
      .estimate;
  };
  const SmallDisplacementError lever_error  = with_spring("0.2"),
                               spring_error = with_spring("0.05");
  EXPECT_NEAR(lever_error.rotation, 0.05, 1e-12);
  EXPECT_EQ(lever_error.location, "rigid part 0");
  EXPECT_NEAR(spring_error.rotation, 0.1, 1e-12);
  EXPECT_EQ(spring_error.location, "connector spring of joint 1");
}
TEST(SmallDisplacementWatch, ReportsLargeDisplacements)
{
  const auto with = [](const double load) {
    return findings_of(
      chain("0", text(load) + " * t").set("Effects/Large rotation", "off"));
  };
  EXPECT_TRUE(with(0.15).empty());
  const auto doubtful = with(0.25);
  ASSERT_EQ(doubtful.size(), 1u) << verdict_text(doubtful);
  EXPECT_EQ(doubtful[0].verdict, Verdict::doubtful);
  EXPECT_EQ(doubtful[0].time, 1);
  EXPECT_EQ(doubtful[0].location, "strut 3");
  EXPECT_EQ(verdict_of(with(1.5)), Verdict::not_to_be_used);
}

TEST(SmallDisplacementWatchOnRanks, FindsTheSame)
{
  const SceneText text =
    chain("-0.6 * t", "0.1 * t").set("Effects/Large rotation", "off");
  const auto alone    = findings_of(text),
             together = findings_of(text, {}, MPI_COMM_WORLD);
  ASSERT_EQ(alone.size(), 1u);
  ASSERT_EQ(together.size(), 1u);
  EXPECT_EQ(together[0].text, alone[0].text);
}

TEST(SmallDisplacementWatch, AcceptsFramesOfStretchedBars)
{
  // Exact kinematics differ by 2e-5. Axial forces near the buckling loads
  // change the slight bending at stiff joints, but not the forces.
  const auto tripod = [](const SpaceTexts &force) {
    return SceneText()
      .dimension(3)
      .frame("2 0 0; -1 1.7320508 0; -1 -1.7320508 0; 0 0 3", "0 3; 1 3; 2 3")
      .circle("bar", 12.6157e-3, {210e9})
      .support("ground", "0, 1, 2", "pin")
      .load("P", "3", force, {"0", "0", "0"})
      .time(1, 1, "static");
  };
  for (const SpaceTexts &force : {SpaceTexts{"1e3*t", "0", "-2e3*t"},
                                  // One bar above its Euler load with hinged
                                  // ends.
                                  SpaceTexts{"2e3*t", "0", "-4e3*t"},
                                  SpaceTexts{"0", "0", "2e3*t"},
                                  SpaceTexts{"1e3*t", "0", "4e3*t"}})
    {
      const SceneText text  = tripod(force);
      const auto      small = small_outcome_of(text, false),
                 exact      = small_outcome_of(text, true);
      EXPECT_LT(relative_difference(small, exact), 1e-4);
      const auto found =
        findings_of(text.str(), {"Effects/Large rotation=off"});
      EXPECT_TRUE(found.empty()) << verdict_text(found);
    }
  // The structure buckles.
  EXPECT_EQ(verdict_of(findings_of(tripod({"6e3*t", "0", "-12e3*t"}).str(),
                                   {"Effects/Large rotation=off"})),
            Verdict::doubtful);
}

TEST(SmallDisplacementWatchOnRanks, ReportsATrussBeyondItsCriticalLoad)
{
  // The scene asks for linear statics: bars at 6.32 times their Euler load do
  // not change its results.
  const SceneText truss =
    SceneText()
      .dimension(3)
      .frame("2 0 0; -1 1.7320508 0; -1 -1.7320508 0; 0 0 3", "0 3; 1 3; 2 3")
      .circle("bar", 12.6157e-3, {210e9})
      .hinge("pins", "all")
      .support("ground", "0, 1, 2", "pin")
      .load("P", "3", {"1e4*t", "0", "-2e4*t"}, {"0", "0", "0"})
      .time(1, 1, "static");
  const auto found =
    findings_of(truss.str(), {"Effects/Large rotation=off"}, MPI_COMM_WORLD);
  ASSERT_EQ(found.size(), 1u) << verdict_text(found);
  EXPECT_EQ(found[0].verdict, Verdict::doubtful);
  EXPECT_EQ(found[0].location, "strut 0");
  expect_parts(found[0].text,
               {"beyond its critical load",
                "strut 0 bears 6.32 times its Euler load",
                "only if buckling is excluded"});
  const auto below = findings_of(truss.str(),
                                 {"Effects/Large rotation=off",
                                  "Loads/P/Force x=1e3*t",
                                  "Loads/P/Force z=-2e3*t"});
  EXPECT_TRUE(below.empty()) << verdict_text(below);
}

TEST(SmallDisplacementWatch, RefusesBendingBeyondTheCriticalLoad)
{
  // A column bent laterally under 1.2 times its critical load: linear
  // deflections match no equilibrium nearby.
  const auto found =
    findings_of(chain(text(-1.2 * pi * pi / 4) + " * t", "1e-3 * t")
                  .set("Effects/Large rotation", "off"));
  ASSERT_EQ(found.size(), 2u) << verdict_text(found);
  EXPECT_EQ(verdict_of(found), Verdict::not_to_be_used);
  EXPECT_TRUE(contains(found[1].text, "beyond its critical load"));
}

TEST(SmallDisplacementWatch, ReportsAxialForcesThatCarryTransverseLoads)
{
  // A slender strut of four elements in tension, which halves its deflection.
  const SceneText pulled =
    SceneText()
      .frame("0 0; 0.25 0; 0.5 0; 0.75 0; 1 0", "0 1; 1 2; 2 3; 3 4")
      .section({1e6, 1e6, 1})
      .support("foot", "0", "pin")
      .support("end", "4", "roller x")
      .load("pull", "4", {"9.87*t", "0", "0"})
      .load("push", "2", {"0", "1e-2*t", "0"})
      .mesh(3)
      .time(1, 0.5, "static");
  const double error = relative_difference(small_outcome_of(pulled, false),
                                           small_outcome_of(pulled, true));
  EXPECT_GT(error, 0.3);
  EXPECT_EQ(verdict_of(
              findings_of(pulled.str(), {"Effects/Large rotation=off"})),
            Verdict::not_to_be_used);
}
