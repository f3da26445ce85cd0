#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_run.h>

#include <cmath>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Elastic constants of periodic lattices of cubic symmetry whose cells meet at
// the ends of stubs along the axes. These ends lie in planes of symmetry of the
// lattice, normal to the stub and through its axis: under strains along the
// axes they do not turn, and move along the stub only.
namespace
{
  /** A cell without supports; its stub ends come in pairs -x, x, -y, y, ... */
  struct CubicCell
  {
    SceneText    scene = static_scene().dimension(3);
    unsigned int first_stub_end;
    double       side;
  };

  struct CubicConstants
  {
    double E1, nu12;
    double bulk; ///< C11 + 2 C12
  };

  /** E1 and so on of the cell stretched along x between fixed sides. */
  CubicConstants effective_constants(const CubicCell &cell)
  {
    SceneText scene = cell.scene;
    for (unsigned int i = 0; i < 6; ++i)
      {
        SpaceTexts displacement = {{"0", "0", "0"}};
        if (i < 2)
          displacement[0] = text((i == 0 ? -1 : 1) * cell.side / 2);
        scene.prescribe("side " + std::to_string(i),
                        std::to_string(cell.first_stub_end + i),
                        displacement,
                        {{"0", "0", "0"}});
      }
    SpaceRun run(scene.str());
    run.run();
    const double area = cell.side * cell.side;
    const double C11  = run.force("side 1")[0] / area,
                 C12  = run.force("side 3")[1] / area;
    // The cell is as stiff along z as along y.
    EXPECT_NEAR(run.force("side 5")[2] / area, C12, 1e-9 * C11);
    return {(C11 - C12) * (C11 + 2 * C12) / (C11 + C12),
            C12 / (C11 + C12),
            C11 + 2 * C12};
  }

  constexpr bool has_shear = true, has_no_shear = false;

  void finish(SceneText &scene, const double diameter, const bool has_shear)
  {
    scene.set("Sections/all/Shape", "circle");
    scene.set("Sections/all/Radius", diameter / 2);
    scene.set("Sections/all/Young's modulus", "1");
    scene.set("Sections/all/Poisson's ratio", "0.3");
    scene.set("Effects/Shear flexibility", has_shear ? "on" : "off");
    scene.mesh(3, 0).linear();
  }

  /** Nodes are exact in the linear theory and the references have ten digits.
   */
  constexpr double allowed = 1e-9;

  /**
   * Three orthogonal plane stars that share the joints at distance p on the
   * axes; vertices at distances q, q, 0; ligaments to distance a / 2.
   */
  SceneText three_stars(const double p, const double q, const double a)
  {
    std::string joints, struts;
    const auto  along_axes = [&](const double distance) {
      for (unsigned int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1., 1.})
          {
            SpaceVector position;
            position[axis] = sign * distance;
            joints += (joints.empty() ? "" : "; ") + text(position);
          }
    };
    along_axes(p);
    along_axes(a / 2);
    for (unsigned int i = 0; i < 6; ++i)
      struts +=
        (i > 0 ? "; " : "") + std::to_string(i) + " " + std::to_string(6 + i);
    unsigned int vertex = 12;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = i - i % 2 + 2; j < 6; ++j, ++vertex)
        {
          SpaceVector position;
          position[i / 2] = i % 2 == 0 ? -q : q;
          position[j / 2] = j % 2 == 0 ? -q : q;
          joints += "; " + text(position);
          for (const unsigned int end : {i, j})
            struts += "; " + std::to_string(end) + " " + std::to_string(vertex);
        }
    return static_space_frame(joints, struts);
  }
} // namespace

TEST(SpaceCell, ThreeOrthogonalStars)
{
  ComparisonTable table("Three orthogonal plane stars, closed form");
  const auto      compare = [&](const double          diameter,
                           const bool            has_shear,
                           const CubicConstants &reference) {
    CubicCell cell{three_stars(0.4, 1, 3), 6, 3};
    finish(cell.scene, diameter, has_shear);
    const CubicConstants found = effective_constants(cell);
    const std::string    name  = label("d", diameter) + ": ";
    table.relative(name + "E1", found.E1, reference.E1, allowed);
    table.row(name + "nu12", found.nu12, reference.nu12, allowed);
  };
  compare(0.05, has_no_shear, {1.515974301e-6, -0.4246282401, 0});
  compare(0.1, has_shear, {2.348356435e-5, -0.4170507714, 0});
}

TEST(SpaceCell, StarInSpace)
{
  ComparisonTable table("Star in space, d = 0.05, periodic frame analysis");
  const auto      compare = [&](const double          angle,
                           const bool            has_shear,
                           const CubicConstants &reference) {
    const double radians = angle * std::acos(-1) / 180;
    CubicCell    cell{
      static_scene().dimension(3),
      14,
      2 * (1 + std::sin(radians) / std::sqrt(2.) - std::cos(radians))};
    cell.scene.set("Lattice/Cell", "space star");
    cell.scene.set("Lattice/Strut length", "1");
    cell.scene.set("Lattice/Opening angle", text(angle) + " deg");
    finish(cell.scene, 0.05, has_shear);
    const CubicConstants found = effective_constants(cell);
    const std::string    name =
      label("theta0", angle) + (has_shear ? ", shear: " : ": ");
    table.relative(name + "E1", found.E1, reference.E1, allowed);
    table.row(name + "nu12", found.nu12, reference.nu12, allowed);
    table.relative(name + "C11 + 2 C12", found.bulk, reference.bulk, allowed);
  };
  compare(56, has_no_shear, {6.986050474e-6, -0.968246286, 2.379045853e-6});
  compare(60, has_no_shear, {6.069952978e-6, -0.870835681, 2.213960820e-6});
  compare(60, has_shear, {6.039596774e-6, -0.871331090, 2.202092850e-6});
  compare(70, has_no_shear, {3.376023623e-6, -0.351144782, 1.983225236e-6});
  compare(80, has_no_shear, {1.927228913e-6, 0.007868980, 1.958044539e-6});
}
