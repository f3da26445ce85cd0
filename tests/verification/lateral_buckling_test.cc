#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/singular_tangent.h>
#include <verification/space_run.h>

#include <cmath>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Right-angle frames of Argyris et al. (1979) that buckle out of their plane,
// mm and N: legs of 240, section 30 in the plane by 0.6, E = 71240, nu = 0.31.
namespace
{
  constexpr double length = 240;

  const double full_torsion      = 58732.21; ///< J = h t^3 / 3
  const double corrected_torsion = 57992.19; ///< times 1 - 0.63 t / h

  Beam3D::Stiffness thin_section(const double torsion)
  {
    const double axial = 71240 * 30 * 0.6, shear = axial / 2.62 * 5 / 6;
    return {axial, shear, shear, torsion, 38469.6, 9.6174e7};
  }

  /** Clamp, leg along x, leg down, force @p load along @p direction at its end.
   */
  SceneText cantilever_frame(const double       torsion,
                             const SpaceVector &direction,
                             const double       load)
  {
    SceneText scene = static_space_frame("0 0; 240 0; 240 -240", "0 1; 1 2");
    scene.space_section(thin_section(torsion))
      .load("end", "2", times(load * direction, "t"), {{"0", "0", "0"}})
      .support("clamp", "0", "clamp")
      .mesh(4, 3);
    return scene;
  }
} // namespace

TEST(LateralBuckling, CantileverFrame)
{
  struct Row
  {
    std::string name;
    SpaceVector direction;
    double      full, corrected;
  };
  const std::vector<Row> rows = {
    {"+x", SpaceVector({1., 0., 0.}), 1.08751784, 1.08408896},
    {"-x", SpaceVector({-1., 0., 0.}), 0.68042736, 0.67892892},
    {"+y", SpaceVector({0., 1., 0.}), 0.65076516, 0.64555841},
    {"-y", SpaceVector({0., -1., 0.}), 3.97948388, 3.95738915}};
  ComparisonTable table("Cantilever frame, force at which it buckles, rod "
                        "equation by shooting");
  for (const Row &row : rows)
    for (const bool corrected : {false, true})
      {
        const double reference = corrected ? row.corrected : row.full;
        const double found     = singular_load(
          [&](const double load) {
            return cantilever_frame(corrected ? corrected_torsion
                                              : full_torsion,
                                    row.direction,
                                    load)
              .time(1, 1)
              .str();
          },
          0.97 * reference,
          0.98 * reference);
        // Mesh and round-off: forces of 1e-16 of the stiffness against shear,
        // 1e5 N/mm, act on an eigenvalue of 1e-3 N/mm.
        table.relative(row.name + (corrected ? ", J corrected" : ""),
                       found,
                       reference,
                       3e-7);
      }
}

TEST(LateralBuckling, HingedFrame)
{
  // Ends that turn about z only, one of them free to move along x; symmetric
  // mode.
  const double half_span = length / std::sqrt(2.);
  const auto   frame     = [&](const double torsion, const double moment) {
    SceneText scene =
      static_space_frame(text(-half_span) + " 0; 0 " + text(half_span) + "; " +
                           text(half_span) + " 0",
                         "0 1; 1 2");
    scene.space_section(thin_section(torsion))
      .load("left", "0", {{"0", "0", "0"}}, {{"0", "0", text(moment) + " * t"}})
      .load("right",
            "2",
            {{"0", "0", "0"}},
            {{"0", "0", text(-moment) + " * t"}})
      .prescribe("hinge", "0", {{"0", "0", "0"}}, {{"0", "0", "free"}})
      .prescribe("slide", "2", {{"free", "0", "0"}}, {{"0", "0", "free"}})
      .mesh(4, 3)
      .time(1, 1);
    return scene.str();
  };
  ComparisonTable table("Hinged frame, moment at which it buckles, rod "
                        "equation by shooting");
  for (const double sign : {1., -1.})
    {
      const auto found = [&](const double torsion, const double start) {
        return singular_load(
          [&](const double moment) { return frame(torsion, sign * moment); },
          0.99 * start,
          0.995 * start);
      };
      const std::string name = sign > 0 ? "M" : "-M";
      // Shear, which the reference leaves out, moves -M by 3e-7.
      table.relative(name, found(full_torsion, 622.22), 622.2216637, 5e-7);
      table.relative(name + ", J corrected",
                     found(corrected_torsion, 618.29),
                     618.2883671,
                     5e-7);
    }
}

namespace
{
  /** Lateral displacement (mm) of the frame's end under a force. */
  struct Deflection
  {
    double force, lateral;
  };

  /**
   * Deflections of the frame pulled along +x, with a lateral force of
   * @p imperfection times the force, up to the force @p end.
   */
  std::vector<Deflection>
  pulled(const double imperfection, const double end, const double step)
  {
    SceneText scene =
      cantilever_frame(full_torsion, SpaceVector({1., 0., imperfection}), 1);
    SpaceRun                run(scene.time(end, step).str());
    std::vector<Deflection> path;
    run.run([&] { path.push_back({run.state.time, run.displacement(2)[2]}); });
    return path;
  }
} // namespace

TEST(LateralBuckling, SmallImperfectionGrowsWithoutBounds)
{
  // As long as the deflection is small, force over deflection goes smoothly
  // through zero at the critical force: the zero of the parabola through the
  // last three points, by Newton's method.
  const double                  step = 0.01;
  const std::vector<Deflection> path = pulled(1e-6, 1.08, step);
  ASSERT_LT(path.back().lateral, 0.01);
  double ratio[3];
  for (unsigned int i = 0; i < 3; ++i)
    {
      const Deflection &point = path[path.size() - 3 + i];
      ratio[i]                = point.force / point.lateral;
    }
  const double slope = ratio[2] - ratio[1], bend = slope - ratio[1] + ratio[0];
  double       x = 0;
  for (unsigned int i = 0; i < 10; ++i)
    x -= (ratio[2] + slope * x + bend * x * (x + 1) / 2) /
      (slope + bend * (x + 0.5));
  ComparisonTable table("Cantilever frame, force at which deflections grow "
                        "without bounds");
  // Error of the parabola, from that of the line (1e-3) in the same points
  table.relative("+x", path.back().force + x * step, 1.08751784, 5e-5);
}

TEST(LateralBuckling, PathBeyondTheCriticalForce)
{
  // Argyris et al. find that the frame gives way at 1.088. Bounds: a tenth of
  // the lateral displacement a percent beyond that force a few percent before
  // it.
  const std::vector<Deflection> path = pulled(1e-3, 1.2, 0.02);
  ResultTable                   table(
    "Cantilever frame pulled along +x, lateral force of 1e-3 of the force",
    {"force (N)", "lateral displacement (mm)"});
  for (const Deflection &point : path)
    if (point.force > 0.9)
      {
        table.row(
          {formatted("%g", point.force), formatted("%g", point.lateral)});
        if (point.force < 1.05)
          {
            EXPECT_LT(point.lateral, 1.5) << "at " << point.force;
          }
        else if (point.force > 1.095)
          {
            EXPECT_GT(point.lateral, 15) << "at " << point.force;
          }
      }
}
