#include <deal.II/base/tensor.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

using namespace auxfem::testing_support;

namespace
{
  // Linear systems of a few dozen unknowns, EA some 1e4 times 12 EI/L^2.
  constexpr double round_off = 1e-9;

  const Stiffnesses strut = {2e4, 500, 3};

  /** A cantilever of @p length at @p angle, linear. */
  SceneText
  cantilever(const double length, const double angle, const unsigned int order)
  {
    SceneText scene = static_frame("0 0; " + text(length * std::cos(angle)) +
                                     " " + text(length * std::sin(angle)),
                                   "0 1");
    scene.section(strut).support("clamp", "0", "clamp").mesh(order, 1).linear();
    return scene;
  }

  struct InStrutAxes
  {
    double along, across;
  };

  InStrutAxes tip(const SceneRun &run, const double angle)
  {
    const double u = run.motion(1, 0), v = run.motion(1, 1);
    return {u * std::cos(angle) + v * std::sin(angle),
            v * std::cos(angle) - u * std::sin(angle)};
  }

  // Timoshenko: N L/EA along, P L^3/(3 EI) + P L/kGA across, P L^2/(2 EI)
  // rotation; nodes are exact for p >= 2 in any direction of the strut.
  TEST(TimoshenkoCantilever, TipForce)
  {
    const double L = 1.5, N = 7, P = -0.3;
    for (const unsigned int order : {2, 3, 4, 5, 6})
      for (const double angle : {0., 0.6, 2.1, -1.7})
        {
          const double c = std::cos(angle), s = std::sin(angle);
          SceneRun     run(
            cantilever(L, angle, order)
              .load("tip", "1", {text(N * c - P * s), text(N * s + P * c), "0"})
              .str());
          run.run();
          const InStrutAxes u = tip(run, angle);
          EXPECT_NEAR(u.along, N * L / strut.axial, round_off);
          EXPECT_NEAR(u.across,
                      P * L * L * L / (3 * strut.bending) + P * L / strut.shear,
                      round_off);
          EXPECT_NEAR(run.motion(1, auxfem::rotation_z),
                      P * L * L / (2 * strut.bending),
                      round_off);
          EXPECT_NEAR(run.reaction("clamp", auxfem::rotation_z),
                      -P * L,
                      100 * round_off);
        }
  }

  // Linear elements bend in n pieces of constant curvature, that at their
  // middle: P L^3/(3 EI) (1 - 1/(4 n^2)).
  TEST(TimoshenkoCantilever, TipForceOnLinearElements)
  {
    for (const unsigned int refinements : {0, 1, 4})
      {
        const double n = 1 << refinements;
        SceneRun     run(static_frame("0 0; 1 0", "0 1")
                       .section(strut)
                       .support("clamp", "0", "clamp")
                       .load("tip", "1", {"0", "1", "0"})
                       .mesh(1, refinements)
                       .linear()
                       .str());
        run.run();
        EXPECT_NEAR(run.motion(1, 1),
                    (1 - 1 / (4 * n * n)) / (3 * strut.bending) +
                      1 / strut.shear,
                    round_off);
      }
  }

  TEST(TimoshenkoCantilever, ShearFlexibilityOffIsEulerBernoulli)
  {
    ComparisonTable table("Cantilever, tip deflection with and without shear");
    for (const std::string shear : {"on", "off"})
      {
        SceneRun run(cantilever(1, 0, 3)
                       .load("tip", "1", {"0", "1", "0"})
                       .set("Effects/Shear flexibility", shear)
                       .str());
        run.run();
        const double bending = 1 / (3 * strut.bending);
        table.relative("shear flexibility " + shear,
                       run.motion(1, 1),
                       bending + (shear == "on" ? 1 / strut.shear : 0.),
                       1e-9);
      }
  }

  // Tip force 1 and moment 1: the deflections L^3/(3 EI), L^2/(2 EI) and the
  // moment 1 at the clamp.
  TEST(TimoshenkoCantilever, WithoutShearEveryOrderAndMeshIsEulerBernoulli)
  {
    ComparisonTable table("Cantilever without shear, elements of order p");
    for (unsigned int order = 1; order <= 6; ++order)
      for (const unsigned int refinements : {0, 2})
        for (const bool is_force : {true, false})
          {
            SceneRun run(
              cantilever(1, 0, order)
                .mesh(order, refinements)
                .load("tip",
                      "1",
                      {"0", is_force ? "1" : "0", is_force ? "0" : "1"})
                .set("Effects/Shear flexibility", "off")
                .str());
            run.run();
            table.relative("order " + std::to_string(order) + ", " +
                             std::to_string(1 << refinements) + " elements, " +
                             (is_force ? "force" : "moment"),
                           run.motion(1, 1),
                           is_force ? 1 / (3 * strut.bending)
                                    : 1 / (2 * strut.bending),
                           1e-9);
            // Linear elements have the mean moment of their length.
            if (order > 1)
              {
                EXPECT_NEAR(run.equations.reporting()
                              .struts.front()
                              .forces->sample(run.state, 0, 2)
                              .front()
                              .moment[2],
                            1,
                            1e-9);
              }
          }
  }

  // Force per length q: q L^4/(8 EI) + q L^2/(2 kGA) across, q L^2/(2 EA)
  // along, rotation q L^3/(6 EI); weight is such a force.
  TEST(TimoshenkoCantilever, LineLoadAndWeight)
  {
    const double L = 1.2, along = 40, across = -0.8;
    for (const unsigned int order : {3, 4})
      for (const double angle : {0., 0.9, -2.5})
        for (const bool is_weight : {false, true})
          {
            const double      c = std::cos(angle), s = std::sin(angle);
            const std::string x     = text(along * c - across * s);
            const std::string y     = text(along * s + across * c);
            SceneText         scene = cantilever(L, angle, order);
            if (is_weight)
              scene.set("Gravity/Acceleration x", x)
                .set("Gravity/Acceleration y", y)
                .set("Sections/section 0/Density", 1 / strut.axial);
            else
              scene.set("Loads/line/Type", "line")
                .set("Loads/line/Struts", "all")
                .set("Loads/line/Force per length x", x)
                .set("Loads/line/Force per length y", y);
            SceneRun run(scene.str());
            run.run();
            const InStrutAxes u = tip(run, angle);
            EXPECT_NEAR(u.along, along * L * L / (2 * strut.axial), round_off);
            EXPECT_NEAR(u.across,
                        across * std::pow(L, 4) / (8 * strut.bending) +
                          across * L * L / (2 * strut.shear),
                        round_off);
            EXPECT_NEAR(run.motion(1, auxfem::rotation_z),
                        across * std::pow(L, 3) / (6 * strut.bending),
                        round_off);
            EXPECT_NEAR(run.reaction("clamp", auxfem::rotation_z),
                        -across * L * L / 2,
                        100 * round_off);
          }
  }

  // Fixed portal of height h, span l, side force H at the top,
  // k = (I_beam/I_column)(h/l): sway H h^3/(12 EI) (3k + 2)/(6k + 1), column
  // moments H h/2 (3k + 1)/(6k + 1) at the foot and H h/2 3k/(6k + 1) at the
  // top.
  TEST(PortalFrame, SideForce)
  {
    const double h = 2, l = 3, H = 0.7, EI = 5, EI_beam = 8;
    const double k = EI_beam / EI * h / l;
    SceneRun     run(static_frame("0 0; 0 2; 3 2; 3 0", "0 1; 1 2; 2 3")
                   .section({1e8, 1, EI})
                   .section({1e8, 1, EI_beam}, "1")
                   .set("Effects/Shear flexibility", "off")
                   .support("left foot", "0", "clamp")
                   .support("right foot", "3", "clamp")
                   .load("side", "1", {text(H), "0", "0"})
                   .mesh(3, 0)
                   .linear()
                   .str());
    run.run();

    // Stretching and shear left in: 12 EI/(EA L^2) = 2e-7, twice 1e-6
    const double    allowed = 3e-6;
    ComparisonTable table("Portal frame under a side force, closed form");
    table.relative("sway",
                   run.motion(1, 0),
                   H * h * h * h / (12 * EI) * (3 * k + 2) / (6 * k + 1),
                   allowed);
    const double foot = H * h / 2 * (3 * k + 1) / (6 * k + 1);
    for (const std::string side : {"left foot", "right foot"})
      {
        table.relative(side + ": moment",
                       run.reaction(side, auxfem::rotation_z),
                       foot,
                       allowed);
        table.relative(side + ": thrust",
                       run.reaction(side, 0),
                       -H / 2,
                       allowed);
        table.relative(side + ": vertical",
                       run.reaction(side, 1),
                       (side == "left foot" ? -1 : 1) * (H * h - 2 * foot) / l,
                       allowed);
      }
  }

  // Bars of stiffness EA/L along unit vectors e: K = sum EA/L e e^T.
  TEST(TwoBarTruss, SkewLoadOnUnequalBars)
  {
    SceneRun run(static_frame("0 0; 1 2; 4 0.5", "0 1; 1 2")
                   .section({1e3, 1e3, 1})
                   .section({4e3, 1e3, 1}, "1")
                   .hinge("apex", "1")
                   .support("feet", "0, 2", "pin")
                   .load("skew", "1", {"3", "-5", "0"})
                   .mesh(2, 0)
                   .linear()
                   .str());
    run.run();

    dealii::Tensor<2, 2> stiffness;
    const auto add = [&](const double EA, const double dx, const double dy) {
      const double         length = std::hypot(dx, dy);
      dealii::Tensor<1, 2> e;
      e[0] = dx / length;
      e[1] = dy / length;
      stiffness += EA / length * outer_product(e, e);
    };
    add(1e3, 1, 2);
    add(4e3, -3, 1.5);
    dealii::Tensor<1, 2> force;
    force[0]                     = 3;
    force[1]                     = -5;
    const dealii::Tensor<1, 2> u = invert(stiffness) * force;
    EXPECT_NEAR(run.motion(1, 0), u[0], round_off);
    EXPECT_NEAR(run.motion(1, 1), u[1], round_off);
  }

  // A rotational spring at the distance b from the tip adds (P b) b / K'.
  TEST(RotationalSpring, InACantilever)
  {
    const double a = 0.7, b = 0.5, L = a + b, spring = 4, P = 0.2;
    SceneRun     run(static_frame("0 0; 0.7 0; 1.2 0", "0 1; 1 2")
                   .section(strut)
                   .set("Joints/spring/Joints", "1")
                   .set("Joints/spring/Struts", "1")
                   .set("Joints/spring/Type", "rotational spring")
                   .set("Joints/spring/Stiffness", spring)
                   .support("clamp", "0", "clamp")
                   .load("tip", "2", {"0", text(P), "0"})
                   .mesh(2, 0)
                   .linear()
                   .str());
    run.run();
    EXPECT_NEAR(run.motion(2, 1),
                P * L * L * L / (3 * strut.bending) + P * L / strut.shear +
                  P * b * b / spring,
                round_off);
    EXPECT_NEAR(run.motion(2, auxfem::rotation_z) -
                  P * L * L / (2 * strut.bending),
                P * b / spring,
                round_off);
    EXPECT_NEAR(run.motion(1, auxfem::rotation_z),
                P * (L * L - b * b) / (2 * strut.bending),
                round_off);
  }

  // A stiff link on a rotational spring under a dead force P across it at rest:
  // K' theta = P L cos(theta).
  TEST(RotationalSpring, TurnsFarUnderALink)
  {
    const double spring = 2, angle = 1.2, stiff = 1e7;
    SceneRun     run(
      static_frame("-1 0; 0 0; 1 0", "0 1; 1 2")
        .section({stiff, stiff, stiff})
        .set("Joints/spring/Joints", "1")
        .set("Joints/spring/Struts", "1")
        .set("Joints/spring/Type", "rotational spring")
        .set("Joints/spring/Stiffness", spring)
        .support("fixed strut", "0, 1", "clamp")
        .load("tip",
              "2",
              {"0", text(spring * angle / std::cos(angle)) + " * t", "0"})
        .mesh(2, 0)
        .time(1, 0.1)
        .str());
    run.run();
    // The link itself bends by P / EI = 7e-7.
    EXPECT_NEAR(run.motion(2, 0), std::cos(angle) - 1, 2e-6);
    EXPECT_NEAR(run.motion(2, 1), std::sin(angle), 2e-6);
    EXPECT_NEAR(run.motion(2, auxfem::rotation_z), angle, 2e-6);
    EXPECT_NEAR(run.state.energies.strain(), spring / 2 * angle * angle, 1e-5);
  }
} // namespace
