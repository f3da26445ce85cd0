#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_run.h>

#include <cmath>
#include <iomanip>
#include <iostream>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Bathe & Bolourchi (1979): an arc of 45 degrees, radius 100, clamped at the
// origin with its tangent along y, bending towards x; unit square section,
// dead load P along z at the tip.
namespace
{
  constexpr double radius = 100, opening = pi / 4, youngs_modulus = 1e7;

  Beam3D::Stiffness square_section(const double torsion_constant,
                                   const double shear_stiffness)
  {
    const double bending = youngs_modulus / 12;
    return {youngs_modulus,
            shear_stiffness,
            shear_stiffness,
            youngs_modulus / 2 * torsion_constant,
            bending,
            bending};
  }

  std::string joint_on_arc(const double angle)
  {
    return text(radius * (1 - std::cos(angle))) + " " +
      text(radius * std::sin(angle));
  }

  /** The arc as one strut. */
  SceneText arc()
  {
    return static_space_frame(joint_on_arc(0) + "; " + joint_on_arc(opening),
                              "0 1 " +
                                text(radius * (1 - std::cos(opening / 2))));
  }

  /** Chords of @p n equal parts of the arc. */
  SceneText polygon(const unsigned int n)
  {
    std::string joints = joint_on_arc(0), struts;
    for (unsigned int i = 1; i <= n; ++i)
      {
        joints += "; " + joint_on_arc(opening * i / n);
        struts +=
          (i > 1 ? "; " : "") + std::to_string(i - 1) + " " + std::to_string(i);
      }
    return static_space_frame(joints, struts);
  }

  /** The clamped strut or struts with P = t at joint @p tip. */
  SceneText loaded(SceneText                scene,
                   const Beam3D::Stiffness &section,
                   const unsigned int       tip)
  {
    scene.space_section(section)
      .load("tip", std::to_string(tip), {{"0", "0", "t"}}, {{"0", "0", "0"}})
      .support("clamp", "0", "clamp")
      .time(600, 75);
    return scene;
  }

  struct ReferenceTips
  {
    std::string                name;
    Beam3D::Stiffness          section;
    std::array<SpaceVector, 3> tips; ///< at loads 300, 450, 600
  };

  /** Compares the last joint's position. */
  void compare(const ReferenceTips &model,
               const std::string   &prm_text,
               const double         allowed)
  {
    ComparisonTable    table("45-degree bend, " + model.name);
    SpaceRun           run(prm_text);
    const unsigned int tip = run.lattice.joints.size() - 1;
    run.run([&] {
      for (unsigned int i = 0; i < 3; ++i)
        if (const double load = 300 + 150 * i; run.state.time == load)
          for (unsigned int c = 0; c < 3; ++c)
            table.row(label("P", load) + ", " + "xyz"[c],
                      run.position(tip)[c],
                      model.tips[i][c],
                      allowed);
    });
  }

  constexpr double polar = 1. / 6, shear = 5e6;
} // namespace

TEST(Bend45, TipAgainstTheRodEquation)
{
  const double saint_venant = 0.140577, corrected_shear = shear * 5 / 6;
  // At EA = kGA = 1e12 extension and shear move the tip by 1e-7 at most (the
  // rows show 6e-3 at 1e7).
  Beam3D::Stiffness stiff      = square_section(polar, 1e12);
  stiff.axial                  = 1e12;
  const ReferenceTips models[] = {
    {"polar J, kGA = 5e6",
     square_section(polar, shear),
     {SpaceVector({22.244781, 58.779122, 40.191892}),
      SpaceVector({18.508179, 52.238558, 48.502927}),
      SpaceVector({15.684801, 47.150439, 53.474859})}},
    {"polar J, kGA = 4.16667e6",
     square_section(polar, corrected_shear),
     {SpaceVector({22.244679, 58.778897, 40.192392}),
      SpaceVector({18.508065, 52.238262, 48.503492}),
      SpaceVector({15.684689, 47.150096, 53.475478})}},
    {"Saint-Venant's J, kGA = 4.16667e6",
     square_section(saint_venant, corrected_shear),
     {SpaceVector({22.112514, 58.535709, 40.480757}),
      SpaceVector({18.369163, 51.969425, 48.705349}),
      SpaceVector({15.557676, 46.891586, 53.607986})}},
    {"polar J, inextensible without shear",
     stiff,
     {SpaceVector({22.245035, 58.779685, 40.188284}),
      SpaceVector({18.508464, 52.239298, 48.497983}),
      SpaceVector({15.685078, 47.151294, 53.468598})}}};
  // The reference has six decimals; eight elements of order 4 are much nearer
  // to the rod than that (last test).
  for (const ReferenceTips &model : models)
    {
      SceneText scene = loaded(arc(), model.section, 1);
      compare(model, scene.mesh(4, 3).str(), 1e-6);
    }
}

TEST(Bend45, EightStraightLinearElements)
{
  // From another code with one-point elements, given with four decimals.
  const ReferenceTips model = {"eight straight linear elements",
                               square_section(polar, shear),
                               {SpaceVector({22.2958, 58.8609, 40.0770}),
                                SpaceVector({18.5665, 52.3391, 48.3968}),
                                SpaceVector({15.7424, 47.2600, 53.3742})}};
  SceneText           scene = loaded(polygon(8), model.section, 8);
  compare(model, scene.mesh(1, 0).str(), 1e-4);
}

namespace
{
  SpaceVector tip_at_600(const unsigned int order,
                         const unsigned int refinements)
  {
    SceneText scene = loaded(arc(), square_section(polar, shear), 1);
    SpaceRun  run(scene.mesh(order, refinements).str());
    run.run();
    return run.position(1);
  }

  /** Prints errors of the tip on four meshes; returns the last rate. */
  double observed_rate(const unsigned int order,
                       const unsigned int coarsest,
                       const SpaceVector &exact,
                       ResultTable       &table)
  {
    double before = 0, rate = 0;
    for (unsigned int n = coarsest; n < coarsest + 4; ++n)
      {
        const double error = (tip_at_600(order, n) - exact).norm();
        rate               = std::log2(before / error);
        table.row({std::to_string(order),
                   std::to_string(1 << n),
                   formatted("%.2e", error),
                   n > coarsest ? formatted("%.2f", rate) : ""});
        before = error;
      }
    return rate;
  }
} // namespace

TEST(Bend45, OrderOfConvergence)
{
  // Agrees with the rod equation to its six decimals (first test).
  const SpaceVector exact = tip_at_600(4, 4);
  ResultTable       table("Tip of the 45-degree bend at P = 600",
                    {"order", "elements", "error (m)", "rate"});
  // Nodes converge with the order of p-point Gauss quadrature.
  EXPECT_NEAR(observed_rate(1, 2, exact, table), 2, 0.1);
  EXPECT_NEAR(observed_rate(2, 1, exact, table), 4, 0.2);
  EXPECT_NEAR(observed_rate(3, 0, exact, table), 6, 0.4);
}
