#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/parameters/errors.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Temperature and pretension of struts, against closed forms.

namespace
{
  constexpr double modulus = 2e11, expansion = 1.2e-5, bar_side = 0.02,
                   area = bar_side * bar_side,
                   second_moment =
                     bar_side * bar_side * bar_side * bar_side / 12;

  SceneText heated(const std::string &more = "")
  {
    return SceneText()
      .add("Materials/steel",
           "Young's modulus = " + text(modulus) +
             " | Poisson's ratio = 0.3 | Thermal expansion = " +
             text(expansion))
      .add("Materials/steel", more)
      .add("Sections/bar",
           "Material = steel | Shape = rectangle | Width = " + text(bar_side) +
             " | Height = " + text(bar_side));
  }

  SceneText one_strut(const unsigned int dimension,
                      const std::string &more = "")
  {
    return heated(more).dimension(dimension).frame(dimension == 2
                                                     ? "0 0; 1 0"
                                                     : "0 0 0; 1 0 0",
                                                   "0 1");
  }

  SceneText &warm(SceneText &scene, const std::string &history)
  {
    return scene.add("Loads/heat",
                     "Type = temperature | Struts = all | Temperature = " +
                       history);
  }

  double axial_force(const SceneRun &run, const unsigned int element = 0)
  {
    return run.equations.reporting().struts.front().forces->axial_force(
      run.state,
      element);
  }

  /** Lowest angular frequency (1/s) about the static equilibrium of a scene. */
  double lowest_frequency_in_equilibrium(SceneText text)
  {
    const Scene scene =
      read_scene_from_text(text.set("Analysis", "modes")
                             .set("Modes/About", "static equilibrium")
                             .time(1, 0.1, "newmark")
                             .str(),
                           "test.prm");
    LatticeRun run(plan_of_modes(scene), MPI_COMM_SELF);
    run.prepare();
    run.start();
    return natural_modes(run.solver(), run.solution.state, 1)
      .modes.front()
      .angular_frequency();
  }
} // namespace

TEST(InitialStrains, HeldAndFreeBars)
{
  for (const unsigned int dimension : {2u, 3u})
    {
      SceneText held = one_strut(dimension)
                         .support("ends", "0, 1", "clamp")
                         .time(1, 0.5, "static");
      SceneRun hot(warm(held, "40 * t"));
      hot.run();
      EXPECT_NEAR(axial_force(hot) / (-modulus * area * expansion * 40),
                  1,
                  1e-12);
      EXPECT_LT(std::abs(hot.balance()), 1e-12 * hot.state.largest_energy);

      SceneText free = one_strut(dimension)
                         .support("end", "0", "clamp")
                         .time(1, 0.5, "static");
      SceneRun long_bar(warm(free, "40 * t"));
      long_bar.run();
      EXPECT_NEAR(long_bar.motion(1, 0), expansion * 40, 1e-15);
      EXPECT_NEAR(axial_force(long_bar), 0, 1e-6);
      EXPECT_NEAR(long_bar.state.energies.sum(EnergyKind::stored), 0, 1e-12);
    }
}

// A free strut with a warm side is a circle, without forces.
TEST(InitialStrains, GradientsBendFreeStruts)
{
  const double gradient = 5e4, curvature = expansion * gradient;
  for (const unsigned int dimension : {2u, 3u})
    for (const unsigned int axis : {2u, 3u})
      {
        if (axis == 3 && dimension == 2)
          continue;
        SCOPED_TRACE(std::to_string(dimension) + "D, axis " +
                     std::to_string(axis));
        SceneRun run(one_strut(dimension)
                       .support("end", "0", "clamp")
                       .add("Loads/sun",
                            "Type = temperature | Struts = 0 | "
                            "Temperature gradient " +
                              std::to_string(axis) + " = " + text(gradient) +
                              " * t")
                       .set("Effects/Large rotation", "on")
                       .mesh(4, 2)
                       .time(1, 0.25, "static"));
        run.run();
        // In space the default axis 3 is along z, axis 2 along y: the warm
        // side is outside.
        EXPECT_NEAR(1 + run.motion(1, 0),
                    std::sin(curvature) / curvature,
                    1e-7);
        EXPECT_NEAR(run.motion(1, axis - 1),
                    -(1 - std::cos(curvature)) / curvature,
                    1e-7);
        EXPECT_LT(std::abs(run.balance()), 1e-6);
      }
}

// Displacement of a mass on a rod that is warmed steadily from rest:
// alpha T' L (t - sin(omega t) / omega).
TEST(InitialStrains, WarmedRodShakesItsMass)
{
  const double mass = 1e6, omega = std::sqrt(modulus * area / mass), rate = 100;
  ComparisonTable table("Mass on a rod that is warmed steadily");
  for (const char *scheme :
       {"newmark", "generalized-alpha", "energy-momentum", "esdirk"})
    {
      const auto error = [&](const double dt) {
        SceneText scene = one_strut(2, "Density = 0");
        warm(scene, text(rate) + " * t")
          .support("wall", "0", "clamp")
          .add("Supports/guide",
               "Joints = 1 | Type = prescribed | Displacement y = 0 | "
               "Rotation z = 0")
          .mass("body", "1", mass)
          .set("Effects/Large rotation", "off")
          .mesh(1)
          .time(0.5, dt, scheme);
        SceneRun run(scene);
        run.run();
        // Stages integrate the power of the load.
        const bool has_stages = std::string(scheme) == "esdirk";
        EXPECT_LT(std::abs(run.balance()),
                  (has_stages ? 1e-5 : 1e-9) * run.state.largest_energy)
          << scheme;
        return std::abs(run.motion(1, 0) -
                        expansion * rate *
                          (0.5 - std::sin(omega * 0.5) / omega));
      };
      const double order = std::log2(error(0.02) / error(0.01));
      if (std::string(scheme) == "esdirk")
        EXPECT_GT(order, 2.7);
      else
        table.row(scheme, order, 2, 0.1);
    }
}

// Bars of equal stiffness in a row, one of them too short by 1 %.
TEST(InitialStrains, TightenedBarStretchesItsNeighbour)
{
  const double force = modulus * area * 1e-4;
  SceneRun     run(
    heated()
      .frame("0 0; 1 0; 2 0", "0 1; 1 2")
      .support("ends", "0, 2", "clamp")
      .add("Loads/turnbuckle",
           "Type = pretension | Struts = 1 | Pretension = " + text(force))
      .set("Effects/Large rotation", "off")
      .time(1, 1, "static"));
  run.run();
  EXPECT_NEAR(axial_force(run, 0) / force, 0.5, 1e-10);
  EXPECT_NEAR(axial_force(run, 1) / force, 0.5, 1e-10);
  EXPECT_NEAR(run.motion(1, 0), 0.5e-4, 1e-12);
  EXPECT_LT(std::abs(run.balance()), 1e-12 * run.state.largest_energy);
}

// omega^2 = (pi / L)^4 EI / rho A + (pi / L)^2 T / rho A.
TEST(InitialStrains, PretensionTunesAString)
{
  const double density = 7800, thickness = 1e-3, wire = thickness * thickness,
               tension = 50;
  const double found   = lowest_frequency_in_equilibrium(
    SceneText()
      .add("Materials/steel",
           "Young's modulus = " + text(modulus) +
             " | Poisson's ratio = 0.3 | Density = " + text(density))
      .add("Sections/wire",
           "Material = steel | Shape = rectangle | Width = " + text(thickness) +
             " | Height = " + text(thickness))
      .frame("0 0; 1 0", "0 1")
      .support("ends", "0, 1", "pin")
      .add("Loads/peg",
           "Type = pretension | Struts = all | Pretension = " + text(tension))
      .mesh(4, 3));
  const double EI = modulus * wire * wire / 12;
  EXPECT_NEAR(found /
                std::sqrt((std::pow(pi, 4) * EI + pi * pi * tension) /
                          (density * wire)),
              1,
              1e-5);
}

namespace
{
  /** Square of the lowest angular frequency (1/s2) of a clamped strut, heated
   * to
   * @p ratio times the strain 4 pi^2 I / (A L^2). */
  double square_of_heated_strut(const double ratio)
  {
    SceneText text = one_strut(2, "Density = 7800");
    warm(text,
         testing_support::text(ratio * 4 * pi * pi * second_moment /
                               (area * expansion)));
    return std::pow(lowest_frequency_in_equilibrium(
                      text.support("ends", "0, 1", "clamp").mesh(4, 2)),
                    2);
  }
} // namespace

// A clamped strut buckles where its lowest frequency falls to zero: 1 without
// shear flexibility, with it as an independent integration gives.
TEST(InitialStrains, HeatBucklesAClampedStrut)
{
  constexpr double one = 0.99, other = 0.995;
  const double     square = square_of_heated_strut(one),
               lower      = square_of_heated_strut(other);
  ComparisonTable table("Strain that buckles a heated clamped strut, over "
                        "Euler's");
  table.row("with shear flexibility",
            one + (other - one) * square / (square - lower),
            0.99593,
            1e-5);
}

// A held strut of a material that relaxes: P (1 - r + r exp(-t / tau)).
TEST(InitialStrains, PretensionRelaxes)
{
  SceneRun run(
    SceneText()
      .add("Materials/polymer",
           "Law = viscoelastic | Young's modulus = 1e6 | Poisson's ratio = 0 | "
           "Relaxing parts = 0.6 | Relaxation times = 1 | "
           "State at start = instantaneous")
      .add("Sections/bar",
           "Material = polymer | Shape = rectangle | Width = 0.1 | "
           "Height = 0.1")
      .frame("0 0; 1 0", "0 1")
      .support("ends", "0, 1", "clamp")
      .add("Loads/pull", "Type = pretension | Struts = all | Pretension = 10")
      .set("Time/Start from", "static equilibrium")
      .time(1, 0.01, "static"));
  EXPECT_NEAR(axial_force(run), 10, 1e-9);
  run.run();
  EXPECT_NEAR(axial_force(run) / (10 * (0.4 + 0.6 * std::exp(-1.))), 1, 1e-4);
  EXPECT_LT(std::abs(run.balance()), 1e-10 * run.state.largest_energy);
}

// Heated beyond yielding while held, a bar is under tension after cooling.
TEST(InitialStrains, CoolingLeavesTensionInYieldedBars)
{
  SceneText scene =
    one_strut(2,
              "Law = elastic-plastic | Yield stress = 200 MPa | Layers = 4 | "
              "Plastic strains = 1 | Flow stresses = 220 MPa");
  warm(scene, "150 * sin(pi * t)")
    .support("ends", "0, 1", "clamp")
    .time(1, 0.05, "static");
  SceneRun run(scene);
  double   least = 0;
  run.run([&] { least = std::min(least, axial_force(run)); });
  const double yield = 2e8 * area;
  // Hardening by a ten thousandth of Young's modulus.
  EXPECT_NEAR(least / -yield, 1, 1e-3);
  EXPECT_NEAR(axial_force(run) / (modulus * area * expansion * 150 - yield),
              1,
              2e-3);
  EXPECT_LT(std::abs(run.balance()), 1e-9 * run.state.largest_energy);
}

TEST(InitialStrains, RefuseMaterialsThatDoNotKnowThem)
{
  const auto refusal = [](const SceneText &scene) {
    try
      {
        SceneRun run(scene);
      }
    catch (const InputError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  SceneText no_expansion =
    one_strut(2).set("Materials/steel/Thermal expansion", "none");
  warm(no_expansion, "t").support("ends", "0, 1", "clamp").time(1, 1, "static");
  expect_parts(refusal(no_expansion),
               {"Loads/heat", "Materials/steel/Thermal expansion"});
  SceneText buckling = one_strut(2).set("Analysis", "buckling");
  warm(buckling, "t").support("ends", "0, 1", "clamp").time(1, 1, "static");
  expect_parts(refusal(buckling), {"Loads/heat", "buckling"});
  SceneText damped =
    one_strut(2, "Stiffness-proportional damping = 1e-5 | Density = 7800");
  warm(damped, "t").support("ends", "0, 1", "clamp").time(1, 1, "newmark");
  expect_parts(refusal(damped),
               {"Stiffness-proportional damping", "Mass-proportional"});
}
