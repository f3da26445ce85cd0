#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double elastic_modulus = 200, length = 50;

  /** A cantilever along x, small displacements, without shear. Axes 2 and 3 as
   * drawn are y and z. */
  SceneText cantilever(const SceneText &scene, const std::string &section)
  {
    SceneText text = scene;
    text.add("Sections/bar", section + " | Young's modulus = 200");
    return text.support("clamp", "0", "clamp")
      .set("Effects/Shear flexibility", "off")
      .mesh(3)
      .linear();
  }

  /** Moments of rectangles about their common centroid: of y^2, z^2, yz. */
  struct RectangleMoments
  {
    struct Rectangle
    {
      double y, z, height, width; ///< lower corner and sides
    };

    explicit RectangleMoments(const std::vector<Rectangle> &parts)
    {
      double area = 0, y = 0, z = 0;
      for (const Rectangle &part : parts)
        {
          const double a = part.height * part.width;
          area += a;
          y += a * (part.y + part.height / 2);
          z += a * (part.z + part.width / 2);
        }
      for (const Rectangle &part : parts)
        {
          const double a  = part.height * part.width,
                       dy = part.y + part.height / 2 - y / area,
                       dz = part.z + part.width / 2 - z / area;
          yy += a * (dy * dy + part.height * part.height / 12);
          zz += a * (dz * dz + part.width * part.width / 12);
          yz += a * dy * dz;
        }
    }

    double yy = 0, zz = 0, yz = 0;
  };
} // namespace

TEST(UnsymmetricSections, AnAngleBendsObliquely)
{
  // Legs 6 along y and 3 along z. With the moments about the drawn axes, the
  // energy is E/2 (v'' v'' yy + 2 v'' w'' yz + w'' w'' zz), so
  // the deflection under a tip force is L^3 / (3 elastic_modulus) times the
  // inverse of that matrix.
  const RectangleMoments m({{0, 0, 6, 0.5}, {0, 0.5, 0.5, 2.5}});
  const double           determinant = m.yy * m.zz - m.yz * m.yz,
               factor =
                 std::pow(length, 3) / (3 * elastic_modulus) / determinant;
  for (const std::array<double, 2> force :
       {std::array<double, 2>{{1e-3, 0}}, std::array<double, 2>{{3e-4, -7e-4}}})
    {
      SceneText scene = cantilever(static_space_frame("0 0 0; 50 0 0", "0 1"),
                                   "Shape = L | Height = 6 | Width = 3 | "
                                   "Thickness = 0.5");
      scene.load("tip",
                 "1",
                 {{"0", text(force[0]), text(force[1])}},
                 {{"0", "0", "0"}});
      SceneRun run(scene.str());
      run.run();
      const double v = factor * (m.zz * force[0] - m.yz * force[1]),
                   w = factor * (m.yy * force[1] - m.yz * force[0]);
      EXPECT_NEAR(run.motion(1, 1), v, 1e-8 * std::abs(v));
      EXPECT_NEAR(run.motion(1, 2), w, 1e-8 * std::abs(w));
    }
}

TEST(UnsymmetricSections, StrainsAreThoseOfTheOuterFibresOnBothSides)
{
  // T: foot at -3.25, top at 1.75 from the centroid; the tip force bends the
  // top into tension, to which an axial force adds.
  const double area = 8, moment = 2 * (4 / 1. * 1.25 * 1.25) + (64 + 4) / 12.;
  const double top = 1.75, foot = 3.25;
  for (const double axial : {0., 0.1})
    {
      SceneText scene = cantilever(static_frame("0 0; 50 0", "0 1"),
                                   "Shape = T | Height = 5 | Width = 4 | "
                                   "Web thickness = 1 | Flange thickness = 1");
      scene.load("tip", "1", {{text(axial), "-1e-3", "0"}});
      SceneRun run(scene.str());
      run.run();
      const auto  &group = run.equations.reporting().struts.at(0);
      const double strain =
        group.forces
          ->largest_strain(run.state,
                           *run.results.effect_caches[group.effect],
                           {{1, run.model.sections[0].outer_fibres}},
                           0.)
          .ratio;
      const double curvature = 1e-3 * length / (elastic_modulus * moment),
                   stretch   = axial / (elastic_modulus * area);
      EXPECT_NEAR(strain,
                  std::max(stretch + curvature * top,
                           std::abs(stretch - curvature * foot)),
                  1e-8 * strain);
    }
}
