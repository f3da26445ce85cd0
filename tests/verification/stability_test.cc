#include <gtest/gtest.h>
#include <support/sampled_motion.h>
#include <verification/hard_case.h>
#include <verification/star_scene.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// The catalogue of hard cases: star lattices with one thing that is extreme.

namespace
{
  /** 2 x 2 stars for 20 ms under @p load (N) a joint. */
  HardCase star_case(const std::string              &title,
                     const double                    load,
                     const std::vector<std::string> &overrides = {})
  {
    // Without contact the lattice collapses through itself, a harder case.
    return {title,
            star_scene(),
            star_size(2, load) + overrides +
              std::vector<std::string>{"Effects/Contact=off"}};
  }

  /** A foot that moves to the side and back by @p displacement. */
  std::vector<std::string> moved_foot(const std::string &displacement)
  {
    return {"Supports/foundation/Type=prescribed",
            "Supports/foundation/Displacement x=" + displacement,
            "Supports/foundation/Displacement y=0",
            "Supports/foundation/Rotation z=0"};
  }

  /** Ground that shakes (m), from rest. */
  double shaken_ground(const double t)
  {
    double displacement = 0;
    for (const double frequency : {113., 311., 701.})
      displacement +=
        0.03 / frequency * std::pow(std::sin(pi * frequency * t), 3);
    return displacement;
  }

  std::vector<std::string> law(const std::string &parameter, const double value)
  {
    return {"Connectors/damper/" + parameter + "=" + text(value)};
  }
} // namespace

TEST(Stability, TenTimesTheLoad)
{
  go_through(star_case("Ten times the load", 10));
}

TEST(Stability, CollapseWithImperfections)
{
  go_through(star_case("Twice the buckling load, imperfections of 10 um",
                       2.6,
                       {"Imperfections/rough/Type=random",
                        "Imperfections/rough/Standard deviation=10 um",
                        "Time/End time=40 ms"}));
}

TEST(Stability, TwentyTimesTheStep)
{
  go_through(star_case("Twenty times the step", 1, {"Time/Time step=400 us"}));
}

TEST(Stability, LoadsThatJumpAndStrike)
{
  go_through(star_case("A load that jumps",
                       0.5,
                       {"Loads/pressure/Force y=-F0 + 0 * t0"}));
  go_through(star_case("A blow of three steps",
                       0,
                       {"Loads/pressure/Force y=-2 * sin(pi * t / 60e-6) * "
                        "(t < 60e-6)"}));
  go_through(star_case("A strike: the top at 3 m/s",
                       0,
                       {"Initial velocities/strike/Joints=top",
                        "Initial velocities/strike/Velocity y=-3"}));
}

TEST(Stability, MotionsWithKinksAndTables)
{
  go_through(
    star_case("A foot that moves to and fro with kinks",
              0,
              moved_foot("1e-3 * abs(t / 5e-3 - 2 * floor(t / 10e-3 + 0.5))")));
  const SampledMotion ground(shaken_ground, 0.1e-3, 20e-3);
  go_through(star_case("Ground that shakes by a table",
                       0,
                       moved_foot("smooth table: " + ground.name())));
}

TEST(Stability, ConnectorsOfAnyStiffness)
{
  for (const double factor : {1e-6, 1e6})
    {
      go_through(star_case(factor < 1 ? "Springs of a millionth"
                                      : "Springs a million times as stiff",
                           1,
                           law("Spring stiffness", 200 * factor)));
      go_through(star_case(factor < 1 ? "Dashpots of a millionth"
                                      : "Dashpots a million times as strong",
                           1,
                           law("Damping coefficient", 0.05 * factor)));
    }
}

TEST(Stability, MaxwellElementsOfAnyRelaxationTime)
{
  for (const double relaxation_time : {20., 20e-12})
    go_through(
      star_case(relaxation_time > 1 ? "Maxwell elements, dt / tau = 1e-6"
                                    : "Maxwell elements, dt / tau = 1e6",
                1,
                std::vector<std::string>{"Connectors/damper/Law=maxwell"} +
                  law("Damping coefficient", 200 * relaxation_time)));
}

TEST(Stability, SlenderStruts)
{
  go_through(
    {"Slenderness 1e5",
     star_scene(),
     star_size(2, 1) +
       std::vector<std::string>{"Constants=F0 = 4e-15, t0 = 40",
                                "Sections/aluminium/Width=0.1 um",
                                "Sections/aluminium/Height=0.1 um",
                                "Connectors/damper/Spring stiffness=8e-13",
                                "Connectors/damper/Damping coefficient=8e-13",
                                "Time/Time step=80 ms",
                                "Time/End time=80 s"}});
}

TEST(Stability, StrutsOfUnequalStiffness)
{
  for (const char *soft : {"stubs", "edges"})
    go_through(star_case(std::string("Stiffness ratio 1e8, soft ") + soft,
                         1e-7,
                         {"Sections/soft/Struts=" + std::string(soft),
                          "Sections/soft/Shape=rectangle",
                          "Sections/soft/Width=0.4 mm",
                          "Sections/soft/Height=0.4 mm",
                          "Sections/soft/Young's modulus=700",
                          "Sections/soft/Density=2700",
                          "Connectors/damper/Spring stiffness=2e-6",
                          "Connectors/damper/Damping coefficient=5e-6"}));
}

TEST(Stability, OpeningAnglesAtTheirEnds)
{
  for (const char *angle : {"45.5 deg", "89.5 deg"})
    go_through(star_case(std::string("Opening angle ") + angle,
                         0.5,
                         {std::string("Lattice/Opening angle=") + angle}));
}

TEST(Stability, JointsWithoutMass)
{
  go_through(star_case("Masses on the top alone",
                       0.5,
                       {"Sections/aluminium/Density=0",
                        "Connectors/damper/Law=maxwell",
                        "Masses/top/Joints=top",
                        "Masses/top/Mass=1e-4"}));
}

// Nothing but connectors and inertia keeps it from folding.
TEST(Stability, EveryJointAHinge)
{
  go_through(
    star_case("Every joint a hinge",
              0.1,
              {"Joints/hinges/Joints=all", "Joints/hinges/Struts=all"}));
}
