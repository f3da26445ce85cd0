#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <cmath>

#include <verification/momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Masses on struts that yield and break: orders in time, energies.

namespace
{
  /** A mass of 1 kg on a strut of 1 N/m that yields, thrown along it. */
  SceneText mass_on_yielding_strut(const std::string &more)
  {
    return SceneText()
      .add("Materials/steel",
           "Law = elastic-plastic | Young's modulus = 1 | Density = 0 | "
           "Poisson's ratio = 0 | Yield stress = 1e-3 | "
           "Plastic strains = 1 | Flow stresses = 0.051 | "
           "Kinematic hardening modulus = 0.1 | Layers = 2")
      .add("Materials/steel", more)
      .frame("0 0; 1 0", "0 1")
      .add("Sections/bar",
           "Material = steel | Shape = rectangle | Width = 1 | Height = 1")
      .support("clamp", "0", "clamp")
      .add("Supports/guide",
           "Joints = 1 | Type = prescribed | Displacement y = 0 | "
           "Rotation z = 0")
      .mass("body", "1", 1)
      .add("Initial velocities/push", "Joints = 1 | Velocity x = 3e-3")
      .set("Effects/Large rotation", "off")
      .set("Newton/Tolerance", 1e-13)
      .mesh(1);
  }

  double mass_position(const std::string &scheme, const double dt)
  {
    SceneRun run(mass_on_yielding_strut("").time(5, dt, scheme));
    run.run();
    EXPECT_LT(std::abs(run.balance()), 1e-12 * run.state.largest_energy)
      << scheme << ' ' << dt;
    return run.motion(1, 0);
  }
} // namespace

// Forces have kinks in time, so that the order is two on the average only.
TEST(YieldingMotion, OrderOfTimeSchemes)
{
  ComparisonTable table("Order of the motion of a mass on a yielding strut");
  const double    exact = mass_position("newmark", 5. / 40000);
  for (const char *scheme : {"newmark", "generalized-alpha", "energy-momentum"})
    {
      const double coarse = std::abs(mass_position(scheme, 5. / 25) - exact),
                   fine   = std::abs(mass_position(scheme, 5. / 800) - exact);
      table.row(scheme, std::log2(coarse / fine) / 5, 2, 0.35);
    }
}

// Rates raise the yield stress while the mass is stopped.
TEST(YieldingMotion, RatesStiffenAnImpact)
{
  const auto stopped = [](const std::string &more) {
    SceneRun run(mass_on_yielding_strut(more).time(5, 0.01, "newmark"));
    double   largest = 0;
    run.run([&] { largest = std::max(largest, run.motion(1, 0)); });
    EXPECT_LT(std::abs(run.balance()), 1e-12 * run.state.largest_energy);
    EXPECT_GE(run.state.energies.sum(EnergyKind::dissipated), 0);
    return largest;
  };
  const double slow    = stopped(""),
               fast    = stopped("Reference strain rate = 1e-2"),
               elastic = stopped("Reference strain rate = 1e-12");
  EXPECT_LT(fast, 0.95 * slow);
  // A mass on a spring of 1 N/m.
  EXPECT_NEAR(elastic, 3e-3, 1e-5);
}

namespace
{
  /** A mass between two struts, the second of which breaks at a plastic strain
   * of 1e-3. */
  SceneText breaking_struts(const std::string &scheme)
  {
    return mass_on_yielding_strut("Failure strain = 1e-3 | Failure time = 0.2")
      .frame("0 0; 1 0; 2 0", "0 1; 1 2")
      .add("Materials/strong",
           "Law = elastic | Young's modulus = 1 | Density = 0 | "
           "Poisson's ratio = 0")
      .add("Sections/strong",
           "Struts = 0 | Material = strong | Shape = rectangle | Width = 1 | "
           "Height = 1")
      .support("clamp", "0, 2", "clamp")
      .set("Newton/Tolerance", 1e-13)
      .time(12, 0.02, scheme);
  }
} // namespace

// Nothing but the elastic strut holds the mass after the failure: it swings
// with the energy that was not lost.
TEST(YieldingMotion, BrokenStrutsLoseTheirForces)
{
  for (const char *scheme : {"newmark", "energy-momentum"})
    {
      SCOPED_TRACE(scheme);
      SceneRun run(breaking_struts(scheme));
      double   broken = 0, lost = 0, largest = 0;
      run.run([&] {
        const double now = run.state.energies.sum(EnergyKind::dissipated);
        EXPECT_GE(now, lost - 1e-20);
        lost = now;
        std::vector<BrokenStrut> struts;
        for (const StrutGroup &group : run.equations.reporting().struts)
          group.forces->add_broken_struts(run.state, struts);
        if (!struts.empty())
          {
            EXPECT_EQ(struts.front().strut, 1u);
            broken = struts.front().time;
          }
        if (broken > 0 && run.state.time > broken + 1)
          largest = std::max(largest, std::abs(run.motion(1, 0)));
      });
      EXPECT_GT(broken, 0);
      EXPECT_LT(std::abs(run.balance()), 1e-12 * run.state.largest_energy);
      const double energy =
        0.5 * 9e-6 - lost - run.state.energies.sum(EnergyKind::numerical);
      // The elastic strut has 1 N/m; the broken one keeps a millionth.
      EXPECT_NEAR(largest, std::sqrt(2 * energy), 1e-4 * largest);
    }
}

TEST(YieldingMotion, BrittleStrutsBreakAtTheirTensileStress)
{
  const auto largest_force = [](const double sign) {
    SceneRun run(
      mass_on_yielding_strut(
        "Yield stress = 1 | Kinematic hardening modulus = 0 | "
        "Failure stress = 2e-3 | Failure time = 0.01")
        .remove("Materials/steel/Plastic strains")
        .remove("Materials/steel/Flow stresses")
        .remove("Initial velocities")
        .prescribe("guide", "1", {text(sign) + " * 4e-3 * t", "0", "0"})
        .time(1, 0.005, "static"));
    double largest = 0;
    run.run(
      [&] { largest = std::max(largest, std::abs(run.reaction("guide", 0))); });
    EXPECT_LT(std::abs(run.balance()), 1e-10 * run.state.largest_energy);
    return largest;
  };
  EXPECT_NEAR(largest_force(1), 2e-3, 5e-5);
  EXPECT_NEAR(largest_force(-1), 4e-3, 1e-6);
}

namespace
{
  /** Two bodies of 1 kg that fly apart, 40 g of steel between them. */
  SceneText torn_strut(const std::string &scheme)
  {
    return SceneText()
      .add("Materials/steel",
           "Law = elastic-plastic | Young's modulus = 200 GPa | "
           "Density = 7800 | Poisson's ratio = 0.3 | Yield stress = 250 MPa | "
           "Plastic strains = 0.1 | Flow stresses = 400 MPa | "
           "Failure strain = 0.02 | Failure time = 2e-5")
      .add("Sections/bar",
           "Material = steel | Shape = rectangle | Width = 5 mm | "
           "Height = 5 mm")
      .mass("bodies", "0, 1", 1)
      .set("Effects/Large rotation", "on")
      .mesh(4, 2)
      .time(6e-4, 2e-6, scheme);
  }

  /** Runs @p scene; the strut breaks and its remains stay between the
   * bodies. */
  void expect_torn(SceneRun &run)
  {
    double lost = 0;
    run.run([&] {
      const double now = run.state.energies.sum(EnergyKind::dissipated);
      EXPECT_GE(now, lost - 1e-12 * run.state.largest_energy);
      lost = now;
    });
    const StrutForces &strut = *run.equations.reporting().struts[0].forces;
    std::vector<BrokenStrut> broken;
    strut.add_broken_struts(run.state, broken);
    ASSERT_EQ(broken.size(), 1u);
    EXPECT_LT(broken.front().time, 4e-4);
    EXPECT_LT(std::abs(run.balance()), 1e-9 * run.state.largest_energy);
    // No force slows the bodies any more but that which drags 40 g along.
    const double separation = run.velocity(1, 0) - run.velocity(0, 0);
    for (unsigned int e = 0; e < 2; ++e)
      for (const StrutPoint &point : strut.sample(run.state, e, 9))
        {
          EXPECT_EQ(std::round(1e6 * point.intactness), 0);
          const double at = point.position[0] / 0.2;
          EXPECT_NEAR(point.velocity[0],
                      run.velocity(0, 0) + at * separation,
                      0.02 * separation);
        }
  }
} // namespace

TEST(YieldingMotion, StrutsWithMassBreak)
{
  for (const char *scheme : {"newmark", "generalized-alpha", "energy-momentum"})
    {
      SCOPED_TRACE(scheme);
      SceneRun run(
        torn_strut(scheme)
          .frame("0 0; 0.2 0", "0 1")
          .add("Initial velocities/left",
               "Joints = 0 | Velocity x = -10 | Velocity y = 1")
          .add("Initial velocities/right", "Joints = 1 | Velocity x = 10"));
      MomentumMeter meter(run);
      const Momenta before = meter();
      expect_torn(run);
      const Momenta after = meter();
      EXPECT_NEAR(after.x, before.x, 1e-9);
      EXPECT_NEAR(after.y, before.y, 1e-9);
    }
}

TEST(YieldingMotion, StrutsWithMassBreakInSpace)
{
  for (const char *scheme : {"newmark", "energy-momentum"})
    {
      SCOPED_TRACE(scheme);
      SceneRun run(
        torn_strut(scheme)
          .dimension(3)
          .frame("0 0 0; 0.2 0 0", "0 1")
          .add("Initial velocities/left",
               "Joints = 0 | Velocity x = -10 | Velocity y = 1 | "
               "Velocity z = -1")
          .add("Initial velocities/right", "Joints = 1 | Velocity x = 10"));
      expect_torn(run);
    }
}
