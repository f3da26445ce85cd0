#include <support/scene_text.h>
#include <verification/effective_constants.h>

#include <cmath>

using namespace auxfem::testing_support;

namespace
{
  // Four-point stars whose ligaments end in the middle of the cell's sides,
  // centres of symmetry of the lattice. Closed form for bending, stretching and
  // shear of walls and ligaments.

  /** E1 = E2, nu12 = nu21 and G12 of a star, E = 1. */
  struct StarConstants
  {
    double E1, nu12, G12;
  };

  constexpr bool with_shear = true, without_shear = false;

  void finish_plane_cell(SceneText   &scene,
                         const double thickness,
                         const bool   has_shear)
  {
    scene.rectangle("wall", 1, thickness, {1, "", 0.3})
      .set("Effects/Shear flexibility", has_shear ? "on" : "off")
      .mesh(3, 0)
      .linear();
  }

  void compare(const std::string   &name,
               const LatticePart   &part,
               const StarConstants &reference,
               ComparisonTable     &table)
  {
    const EffectiveConstants found = effective_constants(part);
    // Nodes are exact in the linear theory and the reference has ten digits.
    const double allowed = 1e-9;
    table.relative(name + ": E1/E", found.E1, reference.E1, allowed);
    table.relative(name + ": E2/E", found.E2, reference.E1, allowed);
    table.row(name + ": nu12", found.nu12, reference.nu12, allowed);
    table.row(name + ": nu21", found.nu21, reference.nu12, allowed);
    table.relative(name + ": G12/E", found.G12, reference.G12, allowed);
  }

  /** Joints at (+-p, 0), (0, +-p), vertices at (+-q, +-q), q > p, side a. */
  SceneText star(const double p, const double q, const double a)
  {
    SceneText scene = static_scene();
    scene.set("Lattice/Cell", "general star")
      .set("Lattice/Half width", q)
      .set("Lattice/Half height", q)
      .set("Lattice/Side notch depth", q - p)
      .set("Lattice/Top notch depth", q - p)
      .set("Lattice/Horizontal stub length", a / 2 - p)
      .set("Lattice/Vertical stub length", a / 2 - p);
    return scene;
  }

  /** Stub ends of a star cell, in the order right, top, left, bottom. */
  const std::vector<unsigned int> stub_ends = {8, 9, 10, 11};

  TEST(StarHoneycomb, ConstantsOfGeneralStars)
  {
    ComparisonTable table("Four-point star cells, closed form");
    const auto      compare_star = [&](const double         p,
                                  const double         q,
                                  const double         a,
                                  const double         t,
                                  const bool           has_shear,
                                  const StarConstants &reference) {
      LatticePart part{star(p, q, a), stub_ends, a * a};
      finish_plane_cell(part.scene, t, has_shear);
      compare("p = " + text(p) + ", q = " + text(q) + ", a = " + text(a) +
                ", t = " + text(t) + (has_shear ? ", shear" : ""),
              part,
              reference,
              table);
    };
    compare_star(0.4,
                 1,
                 3,
                 0.02,
                 without_shear,
                 {4.284372935e-6, -0.5993469104, 2.685827745e-7});
    compare_star(0.4,
                 1,
                 3,
                 0.1,
                 without_shear,
                 {5.264358972e-4, -0.5839505186, 3.356987795e-5});
    compare_star(0.4,
                 1,
                 3,
                 0.1,
                 with_shear,
                 {5.165418258e-4, -0.5895588270, 3.326362466e-5});
    compare_star(0.5,
                 1,
                 3,
                 0.05,
                 without_shear,
                 {6.850815428e-5, -0.3817467139, 5.504347518e-6});
    compare_star(0.3,
                 1,
                 2.6,
                 0.05,
                 without_shear,
                 {6.276307373e-5, -0.7738747111, 5.270945177e-6});
  }

  // The classic star, tied at its points (q < p / 2), is no star of ours: a
  // frame.
  TEST(StarHoneycomb, ConstantsOfTheStarTiedAtItsPoints)
  {
    LatticePart part{
      static_frame("1 0; 0 1; -1 0; 0 -1; 0.2 0.2; -0.2 0.2; -0.2 -0.2; "
                   "0.2 -0.2; 1.2 0; 0 1.2; -1.2 0; 0 -1.2",
                   "0 4; 4 1; 1 5; 5 2; 2 6; 6 3; 3 7; 7 0; 0 8; 1 9; 2 10; "
                   "3 11"),
      stub_ends,
      2.4 * 2.4};
    finish_plane_cell(part.scene, 0.02, without_shear);
    ComparisonTable table("Star tied at its points, closed form");
    compare("p = 1, q = 0.2, a = 2.4, t = 0.02",
            part,
            {4.448982651e-6, 0.8345486326, 1.410829217e-6},
            table);
  }

  /** n x n cells of 12 struts of length 1. */
  SceneText star_array(const double opening_angle, const unsigned int n)
  {
    SceneText scene = static_scene();
    return scene.set("Lattice/Cell", "star")
      .set("Lattice/Cells x", n)
      .set("Lattice/Cells y", n)
      .set("Lattice/Strut length", 1)
      .set("Lattice/Opening angle", text(opening_angle) + " deg");
  }

  double period(const double opening_angle)
  {
    const double angle = opening_angle * std::acos(-1) / 180;
    return 2 * (1 + std::sin(angle) - std::cos(angle));
  }

  TEST(StarHoneycomb, ConstantsOfTheSymmetricStar)
  {
    ComparisonTable table("Star cells of 12 equal struts, closed form");
    const auto      compare_cell = [&](const double         angle,
                                  const double         t,
                                  const bool           has_shear,
                                  const StarConstants &reference) {
      LatticePart part{star_array(angle, 1),
                       stub_ends,
                       std::pow(period(angle), 2)};
      finish_plane_cell(part.scene, t, has_shear);
      compare(text(angle) + " deg, t = " + text(t) +
                (has_shear ? ", shear" : ""),
              part,
              reference,
              table);
    };
    compare_cell(50,
                 0.05,
                 without_shear,
                 {1.213252557e-4, -0.931348340, 5.664677712e-6});
    compare_cell(60,
                 0.05,
                 without_shear,
                 {1.034372706e-4, -0.548547248, 5.644802795e-6});
    compare_cell(60,
                 0.05,
                 with_shear,
                 {1.027739178e-4, -0.550583264, 5.629470907e-6});
    compare_cell(60,
                 0.1,
                 without_shear,
                 {8.123728319e-4, -0.533244171, 4.515432455e-5});
    compare_cell(70,
                 0.05,
                 without_shear,
                 {8.099429449e-5, -0.068269803, 5.584600292e-6});
    compare_cell(80,
                 0.05,
                 without_shear,
                 {6.267329841e-5, 0.323797681, 5.449826806e-6});
  }

  // Any number of cells has the constants of one: cut at all outer stub ends,
  // or between plates at left and right with free upper and lower sides.
  TEST(StarHoneycomb, ArrayHasTheConstantsOfOneCell)
  {
    const unsigned int n     = 3;
    const double       side  = n * period(60);
    SceneText          scene = star_array(60, n);
    finish_plane_cell(scene, 0.05, with_shear);
    const auto lattice =
      auxfem::build_lattice(auxfem::read_scene_from_text(scene.str(), "", {}));
    LatticePart part{scene, {}, side * side};
    for (const std::string edge : {"left", "right", "bottom", "top"})
      for (const unsigned int joint : lattice.joint_sets.at(edge))
        part.cuts.push_back(joint);
    ASSERT_EQ(part.cuts.size(), 4 * n);
    const StarConstants reference = {1.027739178e-4,
                                     -0.550583264,
                                     5.629470907e-6};
    ComparisonTable     table("3 x 3 star cells at 60 deg, closed form");
    compare("cut", part, reference, table);

    const double stretch = 0.01;
    SceneRun     run(
      scene.prescribe("left plate", "left", {"0", "free", "0"})
        .prescribe("right plate", "right", {text(stretch), "free", "0"})
        .support("mirror", "bottom", "roller x")
        .str());
    run.run();
    table.relative("plates: E1/E",
                   run.reaction("right plate", 0) / stretch,
                   reference.E1,
                   1e-9);
    for (const unsigned int joint : lattice.joint_sets.at("top"))
      table.row("plates: nu12 at joint " + std::to_string(joint),
                -run.motion(joint, 1) / stretch,
                reference.nu12,
                1e-9);
  }

  // Finite strain, uniaxial along x, p = 0.4, q = 1, a = 3, EI = 1: each wall
  // carries X along x, a ligament 2 X. With EA = kGA the rotations are those of
  // inextensible struts and the cell gets longer by 2 (2 l X + 2 g X)/EA more.
  TEST(StarHoneycomb, FiniteStrain)
  {
    const double p = 0.4, q = 1, a = 3, axial_stiffness = 1e4;
    const double wall = std::hypot(q - p, q), ligament = a / 2 - p;
    struct Row
    {
      double X, eps1, eps2;
    };
    const std::vector<Row> reference = {{0.1, 0.01051183, 0.00613116},
                                        {0.5, 0.05547915, 0.02872236},
                                        {1, 0.11774509, 0.05182889},
                                        {2, 0.25323395, 0.07774405},
                                        {-0.1, -0.01022190, -0.00630532},
                                        {-0.5, -0.04835623, -0.03312334},
                                        {-1, -0.09079372, -0.06996251},
                                        {-2, -0.16834672, -0.15613134}};

    ComparisonTable table("Star cell under finite strain, inextensible rod "
                          "equation by shooting");
    for (const std::string sign : {"", "-"})
      {
        SceneRun run(star(p, q, a)
                       .section({axial_stiffness, axial_stiffness, 1})
                       .support("horizontal mirror", "8, 10", "roller x")
                       .support("vertical mirror", "9, 11", "roller y")
                       .load("right", "8", {sign + "2 * t", "0", "0"})
                       .load("left", "10", {"-(" + sign + "2 * t)", "0", "0"})
                       .mesh(4, 3)
                       .time(2, 0.1)
                       .str());
        run.run([&] {
          const double X = sign == "" ? run.state.time : -run.state.time;
          for (const Row &row : reference)
            if (std::abs(row.X - X) < 1e-6)
              {
                const double stretch =
                  2 * X * (wall + ligament) / axial_stiffness;
                const std::string at = "X = " + text(row.X) + ": ";
                // The reference has eight decimals.
                table.row(at + "eps1",
                          2 / a * (run.motion(8, 0) - stretch),
                          row.eps1,
                          1e-8);
                table.row(at + "eps2",
                          2 / a * run.motion(9, 1),
                          row.eps2,
                          1e-8);
              }
        });
      }
  }
} // namespace
