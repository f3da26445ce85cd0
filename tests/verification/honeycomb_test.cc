#include <support/scene_text.h>
#include <verification/effective_constants.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem::testing_support;

namespace
{
  // Hexagonal honeycomb: slanted walls of length 1 at an angle theta to x,
  // below 0 re-entrant, and vertical walls of length h.
  struct Hexagon
  {
    double h, theta;

    double width() const ///< of the part of the lattice that has one joint
    {
      return std::cos(theta * pi / 180);
    }

    double height() const
    {
      return h + std::sin(theta * pi / 180);
    }
  };

  /**
   * One joint with the halves of its three walls, whose middles are centres of
   * symmetry of the lattice.
   */
  LatticePart
  joint_of(const Hexagon &cell, const double thickness, const bool has_shear)
  {
    const std::string x = text(cell.width() / 2);
    const std::string y = text((cell.height() - cell.h) / 2);
    SceneText scene = static_frame("0 0; " + x + " " + y + "; -" + x + " " + y +
                                     "; 0 " + text(-cell.h / 2),
                                   "0 1; 0 2; 0 3");
    scene.rectangle("wall", 1, thickness, {1, "", 0.3})
      .set("Effects/Shear flexibility", has_shear ? "on" : "off")
      .mesh(3, 0)
      .linear();
    return {scene, {1, 2, 3}, cell.width() * cell.height()};
  }

  void compare(const Hexagon            &cell,
               const double              thickness,
               const bool                has_shear,
               const EffectiveConstants &reference,
               ComparisonTable          &table)
  {
    const EffectiveConstants found =
      effective_constants(joint_of(cell, thickness, has_shear));
    const std::string at = "h/l = " + text(cell.h) + ", " + text(cell.theta) +
      " deg, t/l = " + text(thickness) + (has_shear ? ", shear: " : ": ");
    // Nodes are exact in the linear theory, the reference has ten digits.
    const double allowed = 1e-9;
    table.relative(at + "E1/E", found.E1, reference.E1, allowed);
    table.relative(at + "E2/E", found.E2, reference.E2, allowed);
    table.relative(at + "nu12", found.nu12, reference.nu12, allowed);
    table.relative(at + "nu21", found.nu21, reference.nu21, allowed);
    table.relative(at + "G12/E", found.G12, reference.G12, allowed);
  }

  // Gibson & Ashby with bending, stretching and shear of the walls (Masters &
  // Evans 1996): closed form.
  TEST(HexagonalHoneycomb, EffectiveConstants)
  {
    ComparisonTable table(
      "Hexagonal honeycombs, closed form of Masters & Evans");
    compare({2, -30},
            0.02,
            false,
            {1.845306494e-5,
             1.843342618e-5,
             -0.9984019177,
             -0.9973393641,
             6.928203230e-7},
            table);
    compare({2, -30},
            0.1,
            false,
            {2.242136968e-3,
             2.185553069e-3,
             -0.9611650485,
             -0.9369085174,
             8.660254038e-5},
            table);
    compare({2, -30},
            0.1,
            true,
            {2.176216620e-3,
             2.122871440e-3,
             -0.9623068225,
             -0.9387179801,
             8.553506279e-5},
            table);
    compare({1, 30},
            0.02,
            false,
            {1.845306494e-5,
             1.845306494e-5,
             0.9984019177,
             0.9984019177,
             4.616955371e-6},
            table);
    compare({1.5, -20},
            0.05,
            false,
            {8.510831784e-4,
             1.729170600e-4,
             -2.182792230,
             -0.4434842853,
             1.711395144e-5},
            table);
    compare({1.5, -20},
            0.05,
            true,
            {8.446171878e-4,
             1.715903629e-4,
             -2.183147534,
             -0.4435229155,
             1.703644142e-5},
            table);
  }

  // At finite strain, uniaxial load along x or y, joints do not turn: every
  // vertical wall lies on a mirror line. The piece between two of them is half
  // a vertical wall, a slanted wall and half a vertical wall; its second end
  // takes the force W along the load, EI = l = 1.
  struct FiniteStrain
  {
    double force, eps1, eps2;
  };

  // With EA = kGA rotations are those of inextensible walls, and walls stretch
  // by W l/EA and W h/EA along the load more.
  constexpr double wall_axial_stiffness = 1e4;

  SceneText piece_of(const Hexagon     &cell,
                     const unsigned int direction,
                     const bool         is_pulled)
  {
    const double      s = cell.height() - cell.h, half = cell.h / 2;
    const std::string x = text(cell.width()), t = is_pulled ? "t" : "-t";
    SceneText scene = static_frame("0 " + text(-half) + "; 0 0; " + x + " " +
                                     text(s) + "; " + x + " " + text(s + half),
                                   "0 1; 1 2; 2 3");
    scene.section({wall_axial_stiffness, wall_axial_stiffness, 1})
      .support("foot", "0", "clamp")
      .prescribe("left mirror", "1", {"0", "free", "0"})
      .prescribe("right mirror", "2, 3", {"free", "free", "0"})
      .load("pull",
            direction == 0 ? "2" : "3",
            {direction == 0 ? t : "0", direction == 1 ? t : "0", "0"})
      .mesh(4, 3);
    return scene;
  }

  void compare_finite(const Hexagon                   &cell,
                      const unsigned int               direction,
                      const bool                       is_pulled,
                      const std::vector<FiniteStrain> &reference)
  {
    SceneRun        run(piece_of(cell, direction, is_pulled)
                   .time(std::abs(reference.back().force), 0.25)
                   .str());
    ComparisonTable table("Honeycomb h = " + text(cell.h) + " l at " +
                          text(cell.theta) + " deg under finite strain along " +
                          (direction == 0 ? "x" : "y") +
                          ", inextensible rod equation by shooting");
    run.run([&] {
      const double W = is_pulled ? run.state.time : -run.state.time;
      // The slanted wall stretches by W/EA along the load, in y the two half
      // vertical walls by W h/EA together.
      double u = run.motion(3, 0), v = run.motion(3, 1);
      (direction == 0 ? u : v) -=
        W / wall_axial_stiffness * (direction == 0 ? 1 : 1 + cell.h);
      for (const FiniteStrain &row : reference)
        if (std::abs(row.force - W) < 1e-6)
          {
            const std::string at = "W l^2/EI = " + text(row.force) + ": ";
            // The reference has eight decimals.
            table.row(at + "eps1", u / cell.width(), row.eps1, 1e-8);
            table.row(at + "eps2", v / cell.height(), row.eps2, 1e-8);
          }
    });
  }

  TEST(HexagonalHoneycomb, FiniteStrainAlongX)
  {
    compare_finite({2, -30},
                   0,
                   true,
                   {{0.5, 0.01128565, 0.01160412},
                    {1, 0.02122982, 0.02240108},
                    {2, 0.03782861, 0.04181862},
                    {4, 0.06160542, 0.07351288},
                    {10, 0.09654581, 0.13350062}});
    compare_finite({2, -30},
                   0,
                   false,
                   {{-0.5, -0.01285121, -0.01247175},
                    {-1, -0.02752862, -0.02586620},
                    {-2, -0.06359394, -0.05557527},
                    {-4, -0.17248212, -0.12578642},
                    {-6, -0.34175769, -0.19891241}});
  }

  TEST(HexagonalHoneycomb, FiniteStrainAlongY)
  {
    compare_finite({2, -30},
                   1,
                   true,
                   {{0.5, 0.02051702, 0.02161087},
                    {1, 0.04016664, 0.04474322},
                    {2, 0.07538622, 0.09512264},
                    {4, 0.12058983, 0.20586312},
                    {10, 0.06287594, 0.47924349}});
    compare_finite({2, -30},
                   1,
                   false,
                   {{-0.5, -0.02104133, -0.02005251},
                    {-1, -0.04230456, -0.03855923},
                    {-2, -0.08452958, -0.07116250},
                    {-4, -0.16355951, -0.12127460},
                    {-6, -0.23211143, -0.15641661}});
  }

  // The honeycomb h = l at +30 deg is the mirror image: same eps1, eps2 turns.
  TEST(HexagonalHoneycomb, FiniteStrainOfTheOrdinaryCell)
  {
    compare_finite({1, 30},
                   0,
                   true,
                   {{1, 0.02122982, -0.02240108},
                    {10, 0.09654581, -0.13350062}});
  }
} // namespace
