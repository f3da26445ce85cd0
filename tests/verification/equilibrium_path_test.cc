#include <support/followed_path.h>
#include <support/scene_text.h>
#include <verification/deep_arch.h>
#include <verification/result_table.h>

#include <algorithm>
#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Singular points of published problems, found by Analysis = static path
// without a guess. References: closed forms, and the exact rod equation by
// shooting.

namespace
{
  using Singular = FollowedPath::Singular;

  /** A straight-sided frame with shear flexibility that leaves some 1e-7. */
  constexpr double shear_rigid = 1000;

  SceneText
  frame_under(SceneText scene, const std::string &joint, const double force)
  {
    return scene.load("weight", joint, {"0", text(-force) + " * t", "0"})
      .time(1, 1);
  }

  /** Lee, Manuel & Rossow 1968, as in lee_frame_test.cc. */
  SceneText lee_path(const bool follows)
  {
    constexpr double axial = 7.2e6 * 6;
    SceneText        scene =
      static_frame("0 0; 0 120; 24 120; 120 120", "0 1; 1 2; 2 3");
    scene.section({axial, shear_rigid * axial, 7.2e6 * 2})
      .support("hinges", "0, 3", "pin")
      .mesh(4, 3);
    scene = frame_under(scene, "2", 40000);
    if (follows)
      scene.set("Loads/weight/Direction", "follows the joint");
    return scene;
  }

  void compare_lee(const bool follows, const double upper, const double lower)
  {
    const FollowedPath path(lee_path(follows).str());
    const auto         limits = path.limits();
    ASSERT_EQ(limits.size(), 2u);
    ComparisonTable table(
      std::string("Lee's frame, limit loads of a ") +
      (follows ? "load that turns with the frame" : "dead load") +
      ", rod equation by shooting");
    table.relative("upper", 40000 * limits[0].load_factor, upper, 1e-6);
    // The tolerance is the effect of shear.
    table.relative("lower", 40000 * limits[1].load_factor, lower, 4e-6);
  }

  TEST(EquilibriumPath, LeesFrame)
  {
    compare_lee(false, 18556.7275, -9414.4316);
  }

  TEST(EquilibriumPath, LeesFrameWithAFollowerLoad)
  {
    compare_lee(true, 35437.9945, -13908.4117);
  }

  TEST(EquilibriumPath, WilliamsToggle)
  {
    constexpr double E = 10.3e6, height = 0.243, area = 0.753 * height;
    SceneText scene = static_frame("-12.943 0; 0 0.386; 12.943 0", "0 1; 1 2");
    scene
      .section(
        {E * area, shear_rigid * E * area, E * area * height * height / 12})
      .support("feet", "0, 2", "clamp")
      .mesh(4, 3);
    const FollowedPath path(frame_under(scene, "1", 80).str());
    const auto         limits = path.limits();
    ASSERT_EQ(limits.size(), 2u);
    ComparisonTable table(
      "Williams' toggle frame, limit loads, rod equation by "
      "shooting");
    table.relative("upper", 80 * limits[0].load_factor, 33.8703852, 1e-6);
    table.relative("lower", 80 * limits[1].load_factor, 31.2817745, 1e-6);
    table.relative("upper: v", -limits[0].motions[1][1], 0.2321568, 1e-5);
    table.relative("lower: v", -limits[1].motions[1][1], 0.3915942, 1e-5);
  }

  TEST(EquilibriumPath, DeepArch)
  {
    const SceneText    scene = (static_scene() + deep_arch()).mesh(4, 3);
    const FollowedPath path(frame_under(scene, "1", 1000).str());
    const auto         limits = path.limits();
    ASSERT_EQ(limits.size(), 2u);
    ComparisonTable table("Deep circular arch, limit loads, rod equation by "
                          "shooting");
    table.relative("upper, extensible with shear",
                   1000 * limits[0].load_factor,
                   897.289134,
                   2e-7);
    // The reference is inextensible and without shear: 2e-5 in the upper one.
    table.relative("lower", 1000 * limits[1].load_factor, -73.055131, 2e-4);
  }

  /** Argyris et al. 1979: legs of 240 mm, section 30 x 0.6, J = h t^3 / 3. */
  TEST(EquilibriumPath, LateralBucklingOfARightAngleFrame)
  {
    struct Case
    {
      const char *name, *force_x, *force_y;
      double      force;
    };
    ComparisonTable table("Right-angle cantilever frame, force at which it "
                          "leaves its plane, rod equation by shooting");
    const double    axial = 71240 * 30 * 0.6, shear = axial / 2.62 * 5 / 6;
    for (const Case &one : std::vector<Case>{{"+x", "2 * t", "0", 1.08751784},
                                             {"-x", "-2 * t", "0", 0.68042736},
                                             {"+y", "0", "2 * t", 0.65076516}})
      {
        SceneText scene =
          static_space_frame("0 0; 240 0; 240 -240", "0 1; 1 2");
        scene.space_section({axial, shear, shear, 58732.21, 38469.6, 9.6174e7})
          .load("end", "2", {one.force_x, one.force_y, "0"})
          .support("clamp", "0", "clamp")
          .mesh(4, 3)
          .time(1, 1);
        const FollowedPath path(scene.str(), {"Path/Largest load factor=0.6"});
        const auto         found = path.bifurcations();
        ASSERT_FALSE(found.empty());
        table.relative(one.name, 2 * found[0].load_factor, one.force, 1e-6);
      }
  }

  // Greenhill 1883 for ends that are clamped but for a turn about the axis and
  // a motion along it: tan(M L / 2 EI) = M L / 2 EI. Two directions at once.
  TEST(EquilibriumPath, ShaftUnderATorque)
  {
    SceneText scene = static_space_frame("0 0; 1 0", "0 1");
    scene.space_section({1e6, 1e6, 1e6, 1, 1, 1})
      .support("clamp", "0", "clamp")
      .prescribe("bearing", "1", {"free", "0", "0"}, {"free", "0", "0"})
      .load("torque", "1", {"0", "0", "0"}, {"10 * t", "0", "0"})
      .mesh(4, 3)
      .time(1, 1);
    const FollowedPath path(scene.str());
    ASSERT_EQ(path.bifurcations().size(), 1u);
    EXPECT_EQ(path.bifurcations()[0].singular.multiplicity(), 2u);
    ComparisonTable table("Shaft under a torque, ends clamped but for the turn "
                          "about its axis: M L / EI, closed form");
    table.relative("M L / EI",
                   10 * path.bifurcations()[0].load_factor,
                   2 * 4.493409457909064,
                   1e-5);
  }

  // Greenhill's shaft with ends that turn about all axes, under a moment that
  // keeps its direction, which has no potential: at 2 pi EI/L two directions
  // are lost at once. No sign tells of it, but what a push bends has a pole
  // there.
  TEST(EquilibriumPath, ShaftUnderATorqueWithoutPotential)
  {
    SceneText scene = static_space_frame("0 0; 0.5 0; 1 0", "0 1; 1 2");
    scene.space_section({1e6, 1e6, 1e6, 1, 1, 1})
      .prescribe("foot", "0", {"0", "0", "0"}, {"0", "free", "free"})
      .prescribe("bearing", "2", {"free", "0", "0"}, {"free", "free", "free"})
      .load("torque", "2", {"0", "0", "0"}, {"10 * t", "0", "0"})
      .load("push", "1", {"0", "1e-6 * t", "0"}, {"0", "0", "0"})
      .mesh(4, 2)
      .time(1, 1);
    const FollowedPath path(scene.str());
    EXPECT_TRUE(path.singular_points.empty());
    double pole = 0, before = 0;
    for (const FollowedPath::Point &point : path.points)
      {
        EXPECT_EQ(point.determinant_sign, 1);
        const double load = point.load_factor;
        if (load == 0)
          continue;
        const double stiffness = load / point.motions[1][1];
        if (stiffness < 0 && pole == 0)
          {
            const FollowedPath::Point &last = *(&point - 1);
            pole                            = last.load_factor +
              (load - last.load_factor) * before / (before - stiffness);
          }
        before = stiffness;
      }
    ComparisonTable table("Shaft under a torque without potential, ends free "
                          "to turn: M L / EI at the pole, closed form");
    // Interpolated between loads 2 % apart.
    table.relative("M L / EI", 10 * pole, 2 * pi, 2e-4);
  }

  // Euler's column, clamped below: the branch that leans to a side.
  TEST(EquilibriumPath, ElasticaAfterBuckling)
  {
    const double critical = pi * pi / 4, axial = 1e6;
    SceneText    scene = static_frame("0 0; 0 1", "0 1");
    scene.section({axial, axial, 1}).support("clamp", "0", "clamp").mesh(4, 3);
    scene = frame_under(scene, "1", 4 * critical);
    const FollowedPath path(scene.str(),
                            {"Path/Branch=stable",
                             "Path/Resolution=1e-3",
                             "Path/Largest load factor=0.8"});
    ASSERT_FALSE(path.bifurcations().empty());
    ComparisonTable table("Euler's column after buckling, elastica");
    table.relative("P / Pcr at the bifurcation",
                   4 * path.bifurcations()[0].load_factor,
                   1,
                   1e-5);
    struct Row
    {
      double degrees, force, x, y;
    };
    for (const Row &row :
         std::vector<Row>{{20, 1.015396866, 0.9697309074, 0.2194130424},
                          {60, 1.151719620, 0.7410196061, 0.5932076462},
                          {90, 1.393203930, 0.4569465810, 0.7627597635},
                          {120, 1.884800869, 0.1231599724, 0.8031709900},
                          {150, 3.105361984, -0.2222683829, 0.6979073638}})
      {
        // Between two points, by a cubic in the tip's angle.
        const double angle = row.degrees / 180 * pi;
        const auto   value = [&](const auto &point_value) {
          std::vector<FollowedPath::Point> near = path.points;
          std::sort(near.begin(),
                    near.end(),
                    [&](const auto &a, const auto &b) {
                      return std::abs(std::abs(a.motions[1][5]) - angle) <
                        std::abs(std::abs(b.motions[1][5]) - angle);
                    });
          double sum = 0;
          for (unsigned int i = 0; i < 4; ++i)
            {
              double weight = point_value(near[i]);
              for (unsigned int j = 0; j < 4; ++j)
                if (j != i)
                  weight *= (angle - std::abs(near[j].motions[1][5])) /
                    (std::abs(near[i].motions[1][5]) -
                     std::abs(near[j].motions[1][5]));
              sum += weight;
            }
          return sum;
        };
        const std::string at = text(row.degrees) + " degrees: ";
        table.relative(at + "P / Pcr",
                       value([](const auto &p) { return 4 * p.load_factor; }),
                       row.force,
                       2e-5);
        table.row(at + "x / L",
                  value([](const auto &p) { return 1 + p.motions[1][1]; }),
                  row.x,
                  2e-5);
        table.row(at + "y / L",
                  value(
                    [](const auto &p) { return std::abs(p.motions[1][0]); }),
                  row.y,
                  2e-5);
      }
  }

  // A 5 x 4 star lattice that buckles, with imperfections in its first mode. By
  // Southwell (1932) the sway w over the load P is a straight line over w, the
  // slope of which is 1 / (the load of the perfect lattice), wherever motions
  // are small: the more so the smaller the imperfection.
  TEST(EquilibriumPath, StarLatticeWithImperfections)
  {
    SceneText star = static_scene();
    star.cells("star", 5, 4)
      .set("Lattice/Strut length", 0.01)
      .set("Lattice/Opening angle", "60 deg")
      .rectangle("all", 4e-4, 4e-4, {70e9, "", 0.33})
      .support("foot", "bottom", "clamp")
      .connector("springs",
                 "spring",
                 "Between = in-cell | Spring stiffness = 200")
      .load("weight", "top", {"0", "-2 * t", "0"})
      .mesh(3)
      .time(1, 1);
    const std::vector<std::string> settings = {
      "Path/Branch=stable",
      "Path/Resolution=0.002",
      "Path/Largest displacement=0.02"};
    const FollowedPath perfect(star.str(), settings);
    ASSERT_EQ(perfect.bifurcations().size(), 1u);
    const double buckling = 2 * perfect.bifurcations()[0].load_factor;
    EXPECT_NEAR(buckling, 1.28385, 1e-4);
    // Mean over the joints: what is alike on both sides has no part in it.
    const auto sway_of = [](const FollowedPath::Point &point) {
      double sum = 0;
      for (const auto &motion : point.motions)
        sum += motion[0];
      return std::abs(sum) / point.motions.size();
    };
    const auto load_at = [&](const FollowedPath &path, const double sway) {
      for (unsigned int i = 1; i < path.points.size(); ++i)
        if (const double now = sway_of(path.points[i]); now >= sway)
          {
            const double before = sway_of(path.points[i - 1]),
                         part   = (sway - before) / (now - before);
            return 2 *
              ((1 - part) * path.points[i - 1].load_factor +
               part * path.points[i].load_factor);
          }
      return 0.;
    };
    ComparisonTable table(
      "Star lattice, buckling load from Southwell's plots of "
      "imperfect ones, that of the perfect one");
    for (const double amplitude : {4e-6, 2e-5, 1e-4})
      {
        SceneText imperfect = star;
        imperfect.set("Imperfections/lean/Type", "buckling mode")
          .set("Imperfections/lean/Amplitude", amplitude);
        const FollowedPath path(imperfect.str(), settings);
        EXPECT_TRUE(path.singular_points.empty());
        const double less = 1e-4, more = 4e-4;
        table.relative(text(1e3 * amplitude) + " mm",
                       (more - less) /
                         (more / load_at(path, more) -
                          less / load_at(path, less)),
                       buckling,
                       1e-3);
      }
  }
} // namespace
