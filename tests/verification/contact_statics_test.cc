#include <auxfem/contact/effects/contact.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Struts that are pressed on rigid bodies, or lifted off them.

namespace
{
  dealii::Tensor<1, 3> pressure_on(const SceneRun    &run,
                                   const unsigned int plate)
  {
    return run.equations.reporting()
      .plates
      ->reports(run.equations.plate_results(run.results), run.state)[plate]
      .force;
  }

  /** The quarter of a ring R = EI = 1, 0.01 thick, below a plate that comes
   * down as t. */
  SceneText quarter_ring_under_plate()
  {
    constexpr double thickness = 0.01;
    // b t^3 / 12 = 1 with E = 1e9.
    const double width = 12. / (1e9 * thickness * thickness * thickness);
    return static_frame("1 0; 0 1", "0 1 " + text(std::sqrt(0.5) - 1))
      .rectangle("ring", width, thickness, {1e9})
      .set("Effects/Shear flexibility", "off")
      .prescribe("side", "0", {"free", "0", "0"})
      .prescribe("top", "1", {"0", "free", "0"})
      .add("Plates/press",
           "Shape = plane | Normal = 0 -1 | Displacement y = -t | Position = "
           "0 " +
             text(1 + thickness / 2))
      .mesh(3, 4)
      .set("Newton/Tolerance", 1e-9);
  }
} // namespace

TEST(ContactStatics, RingBetweenPlatesFlattens)
{
  // Inextensible. Until the curvature at the plate is gone the ring is that
  // between two point loads (small ones: P R^3 / EI = 1 / (pi / 8 - 1 / pi) for
  // one half of the diameter). From then on the free part begins with neither
  // curvature nor slope: with P on the whole ring curvature^2 = (P / EI) sin of
  // the angle, so that half the height is sqrt(EI / P) times the integral of
  // sqrt(sin), and flattening begins where the quarter is as long as the
  // integral of 1 / sqrt(sin).
  const double height_constant = 1.1981402347, length_constant = 2.6220575543;
  SceneRun     run(quarter_ring_under_plate().time(0.6, 0.02));
  const double flat = std::pow(length_constant / (std::acos(0.)), 2);
  std::vector<std::pair<double, double>> path;
  run.run(
    [&] { path.emplace_back(run.state.time, 2 * pressure_on(run, 0)[1]); });
  ComparisonTable table("Ring between two rigid plates: load P R^2 / EI, "
                        "inextensible elastica with a flat part");
  const double    flat_at = 1 - height_constant / std::sqrt(flat);
  bool            is_flat = false;
  for (const auto &[down, load] : path)
    if (down > flat_at && std::fmod(down + 1e-9, 0.1) < 1e-8)
      {
        is_flat = true;
        // Contact points are 0.01 apart, and the ring is extensible by
        // (t / R)^2 / 12.
        table.relative(label("half approach / R", down),
                       load,
                       std::pow(height_constant / (1 - down), 2),
                       2e-3);
      }
  EXPECT_TRUE(is_flat);
}

TEST(ContactStatics, RingBetweenPlatesIsThatBetweenTwoForcesAtFirst)
{
  // Before it flattens, P R^2 / EI = 2.79: half the change of the diameter, as
  // in the test of rings, inextensible rod equation by shooting.
  ComparisonTable table(
    "Ring between two rigid plates before it flattens: load "
    "P R^2 / EI, inextensible rod equation by shooting");
  for (const auto &[down, load] :
       std::vector<std::pair<double, double>>{{0.03939950, 0.5},
                                              {0.08347189, 1},
                                              {0.18676464, 2}})
    {
      SceneRun run(quarter_ring_under_plate().time(down, down / 8));
      run.run();
      // Half the axial compliance is of the order of (t / R)^2 / 12 = 8e-6, and
      // the face goes in by a few um.
      table.relative(label("half approach / R", down),
                     2 * pressure_on(run, 0)[1],
                     load,
                     1e-3);
    }
}

TEST(ContactStatics, HeavyBeamIsLiftedOffATable)
{
  // EI y'''' = -w with neither deflection, slope nor moment where it lifts off,
  // and no moment at the tip: tip w l^4 / (24 EI), force w l / 2.
  const double EI = 1e8 * 0.02 * 1e-6 / 12, weight = 4, thickness = 0.01;
  SceneRun     run(
    static_frame("0 0; 2 0", "0 1")
      .rectangle("beam", 0.02, thickness, {1e8})
      .set("Effects/Shear flexibility", "off")
      .set("Effects/Large rotation", "off")
      .support("end", "0", "clamp")
      .prescribe("lift", "1", {"free", "if(t < 1, 0, 0.02 * (t - 1))", "free"})
      .add("Loads/weight",
           "Type = line | Struts = all | Force per length y = -4 * min(t, 1)")
      .add("Plates/table",
           "Shape = plane | Normal = 0 1 | Position = 0 " +
             text(-thickness / 2))
      .set("Contact/Stiffness", 10)
      .mesh(3, 6)
      .set("Newton/Tolerance", 1e-9)
      .time(2, 0.05));
  ComparisonTable table("Heavy beam on a table, lifted at its end");
  run.run([&] {
    const double lift = run.motion(1, 1);
    if (run.state.time < 1.2 || std::fmod(run.state.time + 1e-9, 0.25) > 1e-8)
      return;
    const double length = std::pow(24 * EI * lift / weight, 0.25);
    // Contact points are 8 mm apart at most, and the table gives way a little.
    table.relative(label("lift (m)", lift) + ": force w l / 2",
                   run.reaction("lift", 1),
                   weight * length / 2,
                   2e-3);
    // Next to the clamp, which does not sink in, the table carries less.
    table.relative(label("lift (m)", lift) + ": load on table and clamp",
                   run.reaction("end", 1) - pressure_on(run, 0)[1],
                   weight * (2 - length / 2),
                   2e-3);
  });
}

TEST(ContactStatics, RoundBodiesPressTheMiddleOfABeam)
{
  // F = 192 EI u / L^3 of a beam with two clamped ends, L = 1 m.
  const double    EI = 1e10 * 3.14159265358979 / 4 * std::pow(0.005, 4);
  ComparisonTable table("Round bodies pressed on the middle of a clamped beam "
                        "in space, 192 EI / L^3");
  for (const auto &[name, shape] :
       std::vector<std::pair<std::string, std::string>>{
         {"sphere", "Shape = sphere | Radius = 0.1"},
         {"cylinder", "Shape = cylinder | Radius = 0.1 | Axis = 0 0.6 0.8"}})
    {
      // Along the normal of the cylinder.
      SceneRun run(static_space_frame("0 0 0; 0.5 0 0; 1 0 0", "0 1; 1 2")
                     .circle("beam", 0.005, {1e10})
                     .set("Effects/Large rotation", "off")
                     .set("Effects/Shear flexibility", "off")
                     .support("ends", "0, 2", "clamp")
                     .add("Plates/body",
                          shape +
                            " | Position = 0.5 0.084 -0.063 | Displacement y = "
                            "-0.0008 * t | Displacement z = 0.0006 * t")
                     .mesh(3)
                     .time(1, 0.25));
      run.run();
      const auto   force = pressure_on(run, 0);
      const double u     = std::hypot(run.motion(1, 1), run.motion(1, 2));
      EXPECT_GT(u, 0.9e-3);
      // Round-off of Newton's method; the force acts at one point.
      table.relative(name, force.norm(), 192 * EI * u, 1e-7);
      EXPECT_NEAR(force[1] * 0.6 + force[2] * 0.8, 0, 1e-9 * force.norm());
    }
}
