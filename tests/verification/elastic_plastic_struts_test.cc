#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Struts that yield, against closed forms and collapse loads. References with
// hardening: doc/verification/problems.md.

namespace
{
  constexpr double steel_modulus = 1e6, yield_stress = 1000;

  /** Perfectly plastic, or with the @p hardening steel_modulus (Pa). */
  SceneText yielding_material(const double hardening, const std::string &more)
  {
    SceneText scene;
    scene.add(
      "Materials/steel",
      "Law = elastic-plastic | Young's modulus = " + text(steel_modulus) +
        " | Poisson's ratio = 0.3 | Yield stress = " + text(yield_stress));
    if (hardening > 0)
      scene.add("Materials/steel",
                "Plastic strains = 10 | Flow stresses = " +
                  text(yield_stress + 10 * hardening));
    return scene.add("Materials/steel", more);
  }

  SceneText steel_strip(const double height)
  {
    return SceneText().add("Sections/strip",
                           "Material = steel | Shape = rectangle | Width = 1 | "
                           "Height = " +
                             text(height));
  }

  double elastic_moment(const double height)
  {
    return yield_stress * height * height / 6;
  }

  double plastic_moment(const double height)
  {
    return yield_stress * height * height / 4;
  }

  double strip_bending(const double height)
  {
    return steel_modulus * height * height * height / 12;
  }

  /** Runs to the end; value of @p result where @p time is first reached. */
  template <class Result>
  std::vector<double> values_at_times(SceneRun                  &run,
                                      const std::vector<double> &times,
                                      const Result              &result)
  {
    std::vector<double> values;
    run.run([&] {
      if (values.size() < times.size() &&
          run.state.time >= times[values.size()] - 1e-9)
        values.push_back(result());
    });
    return values;
  }

  /** The ledger of a static run by small displacements is exact. */
  void expect_plastic_balance(const SceneRun &run, const double tolerance)
  {
    EXPECT_LT(std::abs(run.balance()), tolerance * run.state.largest_energy);
    EXPECT_GT(run.state.energies.sum(EnergyKind::dissipated), 0);
  }
} // namespace

// Prager & Hodge (1951): tip of a perfectly plastic cantilever over that of the
// elastic limit P_e, (5 - (3 + m) sqrt(3 - 2 m)) / m^2 at P = m P_e.
TEST(ElasticPlasticStruts, CantileverUnderATipLoad)
{
  const double h = 0.1, length = 2, limit = elastic_moment(h) / length;
  const double tip      = limit * std::pow(length, 3) / (3 * strip_bending(h)),
               by_shear = limit * length / (5. / 6 * h * steel_modulus / 2.6);
  SceneRun                  run(yielding_material(0, "Layers = 64")
                 .add(steel_strip(h))
                 .frame("0 0; 2 0", "0 1")
                 .support("clamp", "0", "clamp")
                 .add("Loads/tip",
                      "Joints = 1 | Force y = " + text(-limit) +
                        " * if(t <= 1.4, t, max(0, 2.8 - t))")
                 .set("Effects/Large rotation", "off")
                 .mesh(4, 2)
                 .time(2.8, 0.05, "static"));
  const std::vector<double> found =
    values_at_times(run, {1.2, 1.3, 1.4, 2.8}, [&] {
      const double load = std::min(run.state.time, 2.8 - run.state.time);
      return (-run.motion(1, 1) - load * by_shear) / tip;
    });
  ComparisonTable table(
    "Tip of a perfectly plastic cantilever over that at the elastic limit");
  for (int i = 0; i < 3; ++i)
    {
      const double m = 1.2 + 0.1 * i;
      table.relative("load " + text(m),
                     found[i],
                     (5 - (3 + m) * std::sqrt(3 - 2 * m)) / (m * m),
                     2e-4);
    }
  table.row("unloaded", found[3], 0.147072, 2e-4);
  expect_plastic_balance(run, 1e-9);
}

// Where yielding begins along a strut, its curvature has a kink: whatever the
// order of the elements, errors fall by the square of their length.
TEST(ElasticPlasticStruts, OrderInTheMesh)
{
  const double h = 0.1, load = 1.5 * elastic_moment(h) / 2;
  const auto   tip = [&](const unsigned int order,
                       const unsigned int refinements) {
    SceneRun run(
      yielding_material(steel_modulus / 10, "Layers = 64")
        .add(steel_strip(h))
        .frame("0 0; 2 0", "0 1")
        .support("clamp", "0", "clamp")
        .add("Loads/tip", "Joints = 1 | Force y = " + text(-load) + " * t")
        .set("Effects/Large rotation", "off")
        .set("Newton/Tolerance", 1e-12)
        .mesh(order, refinements)
        .time(1, 0.05, "static"));
    run.run();
    return run.motion(1, 1);
  };
  const double    exact = tip(4, 9);
  ComparisonTable table("Order in the mesh of a yielding cantilever");
  for (const unsigned int order : {1u, 2u})
    {
      const unsigned int coarse = order == 1 ? 2 : 0, fine = 6;
      table.row("order " + std::to_string(order),
                std::log2(std::abs((tip(order, coarse) - exact) /
                                   (tip(order, fine) - exact))) /
                  (fine - coarse),
                2,
                0.4);
    }
}

// Curvature of a rectangle over that of the elastic limit: 1 / sqrt(3 - 2 m).
TEST(ElasticPlasticStruts, CantileverRolledUpByAMoment)
{
  const double h = 0.1, length = 20, limit = 4 * elastic_moment(h);
  SceneRun     run(yielding_material(0, "Layers = 64 | Yield stress = 4000")
                 .add(steel_strip(h))
                 .frame("0 0; 20 0", "0 1")
                 .support("clamp", "0", "clamp")
                 .add("Loads/tip",
                      "Joints = 1 | Moment z = " + text(limit) +
                        " * if(t <= 1.2, t, max(0, 2.4 - t))")
                 .set("Effects/Large rotation", "on")
                 .mesh(4, 3)
                 .time(2.4, 0.03, "static"));
  const std::vector<double> found = values_at_times(run, {1.2, 2.4}, [&] {
    return run.motion(1, rotation_z) / length * strip_bending(h) / limit;
  });
  ComparisonTable           table(
    "Curvature under 1.2 times the moment at the elastic limit");
  table.row("loaded", found[0], 1 / std::sqrt(0.6), 2e-4);
  table.row("unloaded", found[1], 1 / std::sqrt(0.6) - 1.2, 2e-4);
  expect_plastic_balance(run, 1e-9);
}

namespace
{
  /** A structure crushed by the support `press`. */
  struct Crush
  {
    std::string         name;
    SceneText           scene;
    double              force; ///< by which loads are divided (N)
    unsigned int        component;
    std::vector<double> times, loads; ///< references
    double              tolerance;
  };

  std::string ring_struts(const double rise)
  {
    std::string struts;
    for (int i = 0; i < 4; ++i)
      struts += std::to_string(i) + " " + std::to_string((i + 1) % 4) + " " +
        text(rise) + "; ";
    return struts.substr(0, struts.size() - 2);
  }

  std::vector<Crush> steel_crushes()
  {
    const double h = 0.05,
                 deflection =
                   8 * elastic_moment(h) / 2 * 8 / (192 * strip_bending(h));
    const SceneText strips =
      yielding_material(steel_modulus / 100, "").add(steel_strip(h));
    const double moment = plastic_moment(h);
    SceneText    beam   = strips;
    beam.frame("0 0; 1 0; 2 0", "0 1; 1 2")
      .support("walls", "0, 2", "clamp")
      .prescribe("press",
                 "1",
                 {"free", text(-20 * deflection) + " * t", "free"})
      .set("Effects/Large rotation", "off")
      .mesh(4, 1)
      .time(1, 0.0125, "static");
    SceneText portal = strips;
    portal.frame("0 0; 0 1; 1 1; 2 1; 2 0", "0 1; 1 2; 2 3; 3 4")
      .support("walls", "0, 4", "clamp")
      .prescribe("press", "1", {"0.2 * max(0, t - 0.2)", "free", "free"})
      .add("Loads/weight",
           "Joints = 2 | Force y = " + text(-2.5 * moment) +
             " * min(1, t / 0.2)")
      .set("Effects/Large rotation", "off")
      .mesh(4, 2)
      .time(1.2, 0.0125, "static");
    SceneText ring =
      yielding_material(steel_modulus / 100, "").add(steel_strip(0.02));
    ring.frame("0 -1; 1 0; 0 1; -1 0", ring_struts(std::sqrt(0.5) - 1))
      .support("table", "0", "clamp")
      .prescribe("press", "2", {"0", "-0.6 * t", "0"})
      .set("Effects/Contact", "off")
      .mesh(4, 2)
      .time(1, 0.01, "static");
    SceneText wall = strips;
    wall.frame("0 0; 0.86602540378444 0.5", "0 1")
      .support("wall", "0", "clamp")
      .prescribe("press", "1", {"-0.2 * t", "free", "0"})
      .mesh(4, 2)
      .time(1, 0.01, "static");
    SceneText star =
      yielding_material(steel_modulus / 100, "Layers = 12").add(steel_strip(h));
    star.cells("star", 1, 1)
      .add("Lattice", "Strut length = 1 | Opening angle = 60 deg")
      .support("table", "bottom", "clamp")
      .prescribe("press", "top", {"0", "-0.6 * t", "0"})
      .set("Effects/Contact", "off")
      .mesh(4, 1)
      .time(1, 1. / 120, "static");
    return {{"star cell, pressed by 0.2 and 0.6 L",
             star,
             -moment,
             1,
             {1. / 3, 1},
             {6.21, 9.845},
             5e-3},
            {"clamped beam, 4 and 20 yield deflections",
             beam,
             -4 * moment,
             1,
             {0.2, 1},
             {1.0966, 1.3412},
             2e-3},
            {"portal, sway 0.05 and 0.2",
             portal,
             3.5 * moment,
             0,
             {0.45, 1.2},
             {1.1589, 1.4711},
             2e-3},
            {"ring, flattened by 0.2 and 0.6 R",
             ring,
             -4 * plastic_moment(0.02),
             1,
             {1. / 3, 1},
             {0.9695, 0.9662},
             4e-3},
            {"wall of a honeycomb, shortened by 0.05 and 0.2 l",
             wall,
             -2 * moment / 0.5,
             0,
             {0.25, 1},
             {1.0833, 1.0510},
             2e-3}};
  }
} // namespace

// Loads over those of perfectly plastic hinges, with hardening of E / 100.
TEST(ElasticPlasticStruts, CollapseLoads)
{
  ComparisonTable table("Loads over those of perfectly plastic hinges");
  for (const Crush &crush : steel_crushes())
    {
      SceneRun                  run(crush.scene);
      const std::vector<double> found = values_at_times(run, crush.times, [&] {
        return run.reaction("press", crush.component) / crush.force;
      });
      for (std::size_t i = 0; i < crush.loads.size(); ++i)
        table.relative(crush.name + (i == 0 ? ": first" : ": last"),
                       found.at(i),
                       crush.loads[i],
                       crush.tolerance);
      // Large rotations: of second order in the step.
      expect_plastic_balance(run, 1e-4);
    }
}

namespace
{
  /** Curvature of a perfectly plastic circle of unit radius whose fibre at the
   * surface begins to yield at curvature 1, under @p moment over pi / 4. */
  double curvature_of_circle(const double moment)
  {
    const auto moment_at = [](const double curvature) {
      const int n   = 4000;
      double    sum = 0;
      for (int i = 0; i < n; ++i)
        {
          const double y = (i + 0.5) / n;
          sum +=
            4. / n * std::min(1., curvature * y) * y * std::sqrt(1 - y * y);
        }
      return sum / (pi / 4);
    };
    double low = 0, high = 100;
    for (int i = 0; i < 60; ++i)
      (moment_at((low + high) / 2) < moment ? low : high) = (low + high) / 2;
    return low;
  }
} // namespace

TEST(ElasticPlasticStruts, RoundCantileverBentAboutTwoAxes)
{
  const double r = 0.05, length = 2,
               stiffness = steel_modulus * pi / 4 * std::pow(r, 4);
  const double limit     = yield_stress * pi / 4 * std::pow(r, 3) / length,
               load      = 1.5 * limit;
  // Double integration of the curvature by the midpoint rule.
  double    tip = 0;
  const int n   = 200;
  for (int i = 0; i < n; ++i)
    {
      const double x = (i + 0.5) / n;
      tip += curvature_of_circle(1.5 * x) * x / n * length * length *
        yield_stress / (steel_modulus * r);
    }
  const auto scene = [&](const std::string &y, const std::string &z) {
    return yielding_material(0, "Rings = 6 | Angles = 24")
      .add("Sections/rod", "Material = steel | Shape = circle | Radius = 0.05")
      .dimension(3)
      .frame("0 0 0; 2 0 0", "0 1")
      .support("clamp", "0", "clamp")
      .add("Loads/tip",
           "Joints = 1 | Force y = " + y + " * t | Force z = " + z + " * t")
      .set("Effects/Large rotation", "off")
      .mesh(4, 2)
      .time(1, 0.05, "static");
  };
  ComparisonTable table(
    "Tip of a round cantilever at 1.5 times the load of first yield");
  const double by_shear =
    load * length / (0.9 * pi * r * r * steel_modulus / 2.6);
  for (const double angle : {0., 30., 45.})
    {
      const double c = std::cos(angle * pi / 180),
                   s = std::sin(angle * pi / 180);
      SceneRun run(scene(text(c * load), text(s * load)));
      run.run();
      const double along  = c * run.motion(1, 1) + s * run.motion(1, 2),
                   across = c * run.motion(1, 2) - s * run.motion(1, 1);
      table.relative("load at " + text(angle) + " degrees",
                     along - by_shear,
                     tip,
                     5e-3);
      EXPECT_LT(std::abs(across), 2e-3 * along);
      expect_plastic_balance(run, 1e-9);
    }
  EXPECT_GT(tip, 1.05 * load * std::pow(length, 3) / (3 * stiffness));
}

// The same portal along other axes and numbers of elements, in both dimensions.
TEST(ElasticPlasticStruts, DoNotDependOnTheFrame)
{
  const auto sway = [](const std::string &joints,
                       const std::string &motion_x,
                       const std::string &motion_y,
                       const double       x,
                       const double       y) {
    SceneRun run(yielding_material(steel_modulus / 100, "Layers = 8")
                   .add(steel_strip(0.05))
                   .frame(joints, "0 1; 1 2; 2 3")
                   .support("walls", "0, 3", "clamp")
                   .prescribe("press", "1", {motion_x, motion_y, "free"})
                   .set("Effects/Large rotation", "on")
                   .mesh(4, 1)
                   .set("Newton/Tolerance", 1e-11)
                   .time(1, 0.0025, "static"));
    run.run();
    // Steps that round-off cuts in one frame only would yield differently.
    EXPECT_EQ(run.work().retries, 0u);
    return x * run.reaction("press", 0) + y * run.reaction("press", 1);
  };
  EXPECT_NEAR(sway("0 0; 0 1; 1 1; 1 0", "0.2 * t", "-0.02 * t", 1, 0) /
                sway("0 0; -0.6 0.8; 0.2 1.4; 0.8 0.6",
                     "(0.8 * 0.2 + 0.6 * 0.02) * t",
                     "(0.6 * 0.2 - 0.8 * 0.02) * t",
                     0.8,
                     0.6),
              1,
              1e-7);
}

// Parkes (1955): a cantilever whose tip mass M is struck, rigid and perfectly
// plastic, beta = rho A L / 2 M = 0.05. The energy is 20 times the elastic one
// of a plastic moment, M_p^2 L / 2 EI.
TEST(ElasticPlasticStruts, StruckCantilever)
{
  const double h = 0.02, moment = plastic_moment(h);
  const double energy = 20 * moment * moment / (2 * strip_bending(h)),
               mass = h / (2 * 0.05), speed = std::sqrt(2 * energy / mass);
  SceneRun run(yielding_material(0, "Density = 1")
                 .add(steel_strip(h))
                 .frame("0 0; 1 0", "0 1")
                 .support("clamp", "0", "clamp")
                 .mass("striker", "1", mass)
                 .add("Initial velocities/blow",
                      "Joints = 1 | Velocity y = " + text(speed))
                 .set("Effects/Large rotation", "off")
                 .mesh(3, 3)
                 .time(12, 0.001, "newmark"));
  double   lowest = 1e9, highest = 0;
  run.run([&] {
    // It swings about its permanent deflection.
    if (run.state.time < 8)
      return;
    lowest  = std::min(lowest, run.motion(1, 1));
    highest = std::max(highest, run.motion(1, 1));
  });
  ComparisonTable("Permanent deflection of a struck cantilever over its length")
    .relative("mean of the swing", (lowest + highest) / 2, 1.45199, 2e-2);
  EXPECT_LT(highest - lowest, 0.15);
  EXPECT_LT(std::abs(run.balance()), 1e-8 * run.state.largest_energy);
}
