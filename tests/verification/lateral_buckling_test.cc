#include <verification/comparison_table.h>
#include <verification/singular_tangent.h>
#include <verification/space_scene.h>

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
  SpaceScene cantilever_frame(const double       torsion,
                              const SpaceVector &direction,
                              const double       load)
  {
    SpaceScene scene("0 0; 240 0; 240 -240", "0 1; 1 2");
    scene.section(thin_section(torsion))
      .load("end", "2", times(load * direction, "t"), {{"0", "0", "0"}})
      .support("clamp", "0", "clamp")
      .mesh(4, 2)
      .time(1, 1);
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
              .str();
          },
          0.97 * reference,
          0.98 * reference);
        table.relative(row.name + (corrected ? ", J corrected" : ""),
                       found,
                       reference,
                       1e-6);
      }
}

TEST(LateralBuckling, HingedFrame)
{
  // Ends that turn about z only, one of them free to move along x; symmetric
  // mode.
  const double half_span = length / std::sqrt(2.);
  const auto   frame     = [&](const double torsion, const double moment) {
    SpaceScene scene(text(-half_span) + " 0; 0 " + text(half_span) + "; " +
                       text(half_span) + " 0",
                     "0 1; 1 2");
    scene.section(thin_section(torsion))
      .load("left", "0", {{"0", "0", "0"}}, {{"0", "0", text(moment) + " * t"}})
      .load("right",
            "2",
            {{"0", "0", "0"}},
            {{"0", "0", text(-moment) + " * t"}})
      .prescribe("hinge", "0", {{"0", "0", "0"}}, {{"0", "0", "free"}})
      .prescribe("slide", "2", {{"free", "0", "0"}}, {{"0", "0", "free"}})
      .mesh(4, 2)
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
      table.relative(name, found(full_torsion, 622.22), 622.2216637, 1e-6);
      table.relative(name + ", J corrected",
                     found(corrected_torsion, 618.29),
                     618.2883671,
                     1e-6);
    }
}

TEST(LateralBuckling, CantileverFrameBeyondTheCriticalForce)
{
  // A lateral force of 1e-6 of the load starts the buckling: the end's lateral
  // displacement w grows as load / (critical - load), so that load / w falls
  // linearly to zero at the critical load, as far as w is small.
  const double imperfection = 1e-6, step = 0.02;
  SpaceScene   scene =
    cantilever_frame(full_torsion, SpaceVector({1., 0., imperfection}), 1);
  SpaceRun            run(scene.time(1.2, step).str());
  std::vector<double> load, lateral;
  run.run([&] {
    load.push_back(run.state.time);
    lateral.push_back(run.displacement(2)[2]);
  });
  ComparisonTable table("Cantilever frame pulled along +x, lateral force of "
                        "1e-6 of the load");
  std::cout << "| load | lateral displacement |\n|---|---|\n";
  for (unsigned int i = 44; i < load.size(); ++i)
    std::cout << "| " << load[i] << " | " << lateral[i] << " |\n";
  const auto zero_of_line = [&](const unsigned int i, const unsigned int j) {
    const double at_i = load[i] / lateral[i], at_j = load[j] / lateral[j];
    return load[j] - at_j * (load[j] - load[i]) / (at_j - at_i);
  };
  table.relative("critical load", zero_of_line(50, 53), 1.08751784, 1e-3);
}
