#include <auxfem/contact/effects/contact.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>


using namespace auxfem;
using namespace auxfem::testing_support;

// Struts and round bodies that are small beside their elements.

namespace
{
  double pressure_of_body(const SceneRun &run, const unsigned int plate)
  {
    return run.equations.reporting()
      .plates
      ->reports(run.equations.plate_results(run.results), run.state)[plate]
      .force.norm();
  }

  /** A strip of 200 x 20 x 2 mm, clamped at one end, above whose middle a disc
   * comes down by 80 mm. */
  double force_of_pressed_disc(const unsigned int order,
                               const unsigned int refinements)
  {
    SceneRun run(SceneText()
                   .frame("0 0; 0.2 0", "0 1")
                   .rectangle("strip", 0.02, 0.002, {2e9, 0, 0.3})
                   .support("root", "0", "clamp")
                   .add("Plates/disc",
                        "Shape = sphere | Radius = 0.05 | Position = 0.1 "
                        "0.051 | Displacement y = -0.08 * t")
                   .set("Contact/Stiffness", "1000")
                   .mesh(order, refinements)
                   .time(1, 0.02, "static")
                   .str());
    run.run();
    return pressure_of_body(run, 0);
  }

  /** A cantilever of 1 m x 20 mm x 10 mm, EI = 116.7 N m2. */
  SceneText beam_for_bodies(const unsigned int dimension,
                            const unsigned int refinements)
  {
    SceneText scene;
    scene.frame(dimension == 2 ? "0 0; 1 0" : "0 0 0; 1 0 0", "0 1")
      .rectangle("bar", 0.02, 0.01, {7e10, 2700, 0.3})
      .support("root", "0", "clamp")
      .mesh(3, refinements);
    if (dimension == 3)
      scene.dimension(3);
    return scene;
  }
} // namespace

namespace
{
  /** Force (N) of a body that presses on that beam at the middle, for small
   * slopes: 3 EI d / a^3 where it touches, which for large bodies is nearer to
   * the clamp. */
  double force_at_middle(const double radius, const double down)
  {
    const double r = radius + 0.005;
    double       a = 0.5, d = down;
    for (unsigned int i = 0; i < 50; ++i)
      {
        const double slope = 3 * d / (2 * a);
        a                  = 0.5 - r * slope;
        d                  = down - r * slope * slope / 2;
      }
    return 3 * 7e10 * 0.02 * std::pow(0.01, 3) / 12 * d / std::pow(a, 3);
  }
} // namespace

TEST(ContactBodies, ADiscOnAStripConvergesWithTheOrderOfElements)
{
  // By shooting: Reissner's beam with one point of contact, where the axis is
  // tangent to the circle of the radius of the disc and half the thickness.
  constexpr double exact = 10.4001;
  EXPECT_NEAR(force_of_pressed_disc(4, 4), exact, 1e-3 * exact);
  // The error falls with the order, and with the length of elements.
  const auto expect_falling =
    [&](const std::vector<std::array<unsigned int, 2>> &meshes) {
      double last = 1;
      for (const auto &[order, refinements] : meshes)
        {
          const double error =
            std::abs(force_of_pressed_disc(order, refinements) / exact - 1);
          EXPECT_LT(error, 0.5 * last)
            << "order " << order << ", refinements " << refinements;
          last = error;
        }
    };
  expect_falling({{{2, 1}}, {{3, 1}}, {{6, 1}}});
  expect_falling({{{3, 0}}, {{3, 1}}, {{3, 2}}, {{3, 3}}});
}

TEST(ContactBodies, SmallBodiesPressAtTheirPlaceWhateverTheElements)
{
  constexpr double down = 0.002;
  for (const unsigned int dimension : {2, 3})
    for (const double radius : {1e-4, 8e-3, 2.5e-2, 2.})
      for (const unsigned int refinements : {1, 3})
        {
          SceneText scene = beam_for_bodies(dimension, refinements);
          scene.time(1, 0.25, "static")
            .set("Contact/Stiffness", "100")
            .add("Plates/body",
                 std::string(dimension == 2
                               ? "Shape = sphere"
                               : "Shape = cylinder | Axis = 0 0 1") +
                   " | Radius = " + text(radius) + " | Position = 0.5 " +
                   text(0.005 + radius) + (dimension == 2 ? "" : " 0") +
                   " | Displacement y = -t * " + text(down));
          SceneRun run(scene.str());
          run.run();
          const double exact = force_at_middle(radius, down);
          EXPECT_NEAR(pressure_of_body(run, 0), exact, 3e-3 * exact)
            << scene.str();
        }
}

TEST(ContactBodies, ABallThatFallsFastHitsBetweenPointsOfElements)
{
  // The gap of 40 mm takes 0.8 ms, less than a fifth of a step.
  for (const char *const scheme :
       {"newmark", "generalized-alpha", "energy-momentum", "esdirk"})
    {
      SCOPED_TRACE(scheme);
      SceneText scene = beam_for_bodies(2, 1);
      scene.time(0.015, 0.005, scheme)
        .add("Plates/ball",
             "Shape = sphere | Radius = 5 mm | Position = 0.9 0.05 | "
             "Displacement y = free | Displacement x = 0 | Mass = 0.01 | "
             "Initial velocity y = -50");
      SceneRun           run(scene.str());
      const unsigned int ball        = run.lattice.joint_of_plate(0);
      double             first_force = 0;
      run.run([&] {
        if (first_force == 0 && run.velocity(ball, 1) > -49)
          first_force = run.state.time;
      });
      EXPECT_GT(first_force, 0.0008);
      EXPECT_LE(first_force, 0.005);
      EXPECT_GT(run.velocity(ball, 1), -45);
    }
}

TEST(ContactBodies, BodiesInStrutsAreRefusedWhereverTheyAre)
{
  for (const double at : {0.1, 0.2345, 0.5, 0.77})
    for (const double radius : {1e-4, 5e-3})
      {
        SceneText scene = beam_for_bodies(2, 0);
        scene.time(1, 1, "static")
          .add("Plates/body",
               "Shape = sphere | Radius = " + text(radius) +
                 " | Position = " + text(at) + ' ' + text(0.0049 + radius));
        EXPECT_THROW(SceneRun(scene.str()), InputError);
        EXPECT_NO_THROW(SceneRun(scene.str(),
                                 {"Plates/body/Position=" + text(at) + " " +
                                  text(0.0051 + radius)}));
      }
}
