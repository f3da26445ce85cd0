#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>
#include <support/followed_path.h>
#include <support/scene_text.h>

#include <algorithm>
#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double bar_stiffness = 1e6, half_span = 10, rise = 1;

  /** Two bars that meet at joint 1: a von Mises truss. */
  SceneText truss()
  {
    return static_frame(text(-half_span) + " 0; 0 " + text(rise) + "; " +
                          text(half_span) + " 0",
                        "0 1; 1 2")
      .section({bar_stiffness, 1e5, 1e6})
      .hinge("apex", "1")
      .support("left", "0", "pin")
      .support("right", "2", "pin")
      .mesh(1, 0)
      .time(1, 0.1);
  }

  SceneText pressed_truss(const double force = 600)
  {
    return truss().load("weight", "1", {"0", text(-force) + " * t", "0"});
  }

  /** Force on the apex after a downward displacement @p v. */
  double truss_force(const double v)
  {
    return 2 * bar_stiffness * (rise - v) *
      (1 / std::hypot(half_span, rise - v) - 1 / std::hypot(half_span, rise));
  }

  double truss_limit()
  {
    return 2 * bar_stiffness *
      std::pow(1 - std::pow(half_span / std::hypot(half_span, rise), 2. / 3),
               1.5);
  }

  double deflection(const FollowedPath::Point &point)
  {
    return -point.motions[1][1];
  }
} // namespace

TEST(StaticPath, PassesTheLimitPointsOfATruss)
{
  const double       force = 600;
  const FollowedPath path(pressed_truss(force).str());
  EXPECT_EQ(path.result.exit_state, "completed");
  for (const FollowedPath::Point &point : path.points)
    {
      const double v = deflection(point);
      EXPECT_NEAR(force * point.load_factor, truss_force(v), 1e-8 * force);
      // Stable before the first and after the last limit point.
      const double unstable_from = 0.4236074652,
                   until         = 2 * rise - unstable_from;
      EXPECT_EQ(point.n_negative, v > unstable_from && v < until ? 1 : 0) << v;
    }
  EXPECT_EQ(path.points.back().load_factor, 1.);
  ASSERT_EQ(path.singular_points.size(), 2u);
  const auto limits = path.limits();
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(force * limits[0].load_factor, truss_limit(), 1e-9 * force);
  EXPECT_NEAR(force * limits[1].load_factor, -truss_limit(), 1e-9 * force);
  EXPECT_NEAR(deflection(limits[0]), 0.4236074652, 1e-6);
  EXPECT_EQ(limits[0].singular.after.n_negative, 1u);
  EXPECT_EQ(limits[1].singular.after.n_negative, 0u);
}

TEST(StaticPath, EnergyBalanceHoldsAlongPath)
{
  const auto error = [](const double resolution) {
    const FollowedPath path(pressed_truss().str(),
                            {"Path/Resolution=" + text(resolution),
                             "Path/First load increment=" + text(resolution)});
    double             largest = 0, energy = 0;
    for (const FollowedPath::Point &point : path.points)
      {
        largest = std::max(largest, std::abs(point.energies.balance(0)));
        energy  = std::max(energy, point.energies.total());
      }
    EXPECT_GT(energy, 100);
    return largest / energy;
  };
  // Steps are proportional to the square root of the resolution, their error at
  // least to the square of their length.
  const double coarse = error(0.02), fine = error(0.002);
  EXPECT_LE(coarse, 2e-3);
  EXPECT_LE(fine, 0.1 * coarse);
}

TEST(StaticPath, ReversedLoadsReverseThePath)
{
  const FollowedPath path(pressed_truss().str(), {"Path/Reversed loads=true"});
  EXPECT_EQ(path.points.back().load_factor, -1.);
  EXPECT_TRUE(path.singular_points.empty());
  EXPECT_LT(deflection(path.points.back()), 0);
}

TEST(StaticPath, SupportMotionDrivesPath)
{
  // A soft bar pushes the apex; its upper end retreats while the truss snaps
  // through.
  const double    stiffness = 300, travel = 5;
  const SceneText scene =
    static_frame(text(-half_span) + " 0; 0 " + text(rise) + "; " +
                   text(half_span) + " 0; 0 " + text(rise + 10),
                 "0 1; 1 2; 1 3")
      .section({bar_stiffness, 1e5, 1e6}, "0, 1")
      .section({10 * stiffness, 1e5, 1e6}, "2")
      .hinge("apex", "1")
      .support("left", "0", "pin")
      .support("right", "2", "pin")
      .prescribe("pusher", "3", {"0", text(-travel) + " * t", "free"})
      .mesh(1, 0)
      .time(1, 0.1);
  const FollowedPath path(scene.str());
  EXPECT_EQ(path.result.exit_state, "completed");
  for (const FollowedPath::Point &point : path.points)
    {
      const double v = deflection(point);
      EXPECT_NEAR(travel * point.load_factor,
                  v + truss_force(v) / stiffness,
                  1e-8);
      EXPECT_NEAR(-point.motions[3][1], travel * point.load_factor, 1e-12);
    }
  EXPECT_EQ(path.limits().size(), 2u);
  for (const FollowedPath::Singular &limit : path.limits())
    {
      // dP/dv = -stiffness
      const double v = deflection(limit), step = 1e-4;
      EXPECT_NEAR((truss_force(v + step) - truss_force(v - step)) / (2 * step),
                  -stiffness,
                  1e-3 * stiffness);
    }
}

TEST(StaticPath, KeepsDeadLoadsOfStaticStart)
{
  const double    dead  = 200;
  const SceneText scene = truss()
                            .load("weight", "1", {"0", text(-dead), "0"})
                            .load("push", "1", {"0", "-100 * t", "0"})
                            .set("Time/Start from", "static equilibrium");
  const FollowedPath path(scene.str(), {"Path/Largest load factor=6"});
  const auto         limits = path.limits();
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(dead + 100 * limits[0].load_factor, truss_limit(), 1e-6);
  EXPECT_NEAR(dead + 100 * path.points[3].load_factor,
              truss_force(deflection(path.points[3])),
              1e-5);
}

TEST(StaticPath, EndsAtRequestedLimit)
{
  const FollowedPath by_motion(pressed_truss().str(),
                               {"Path/Largest displacement=0.5"});
  EXPECT_GE(deflection(by_motion.points.back()), 0.5);
  EXPECT_LT(deflection(by_motion.points[by_motion.points.size() - 2]), 0.5);
  const FollowedPath by_points(pressed_truss().str(), {"Path/Points=7"});
  EXPECT_EQ(by_points.points.size(), 8u);
  ASSERT_EQ(by_points.result.findings.size(), 1u);
  EXPECT_NE(by_points.result.findings[0].text.find("Path/Points = 7"),
            std::string::npos);
}

TEST(StaticPath, PointSpacingFollowsResolution)
{
  const auto n = [](const double resolution) {
    return FollowedPath(pressed_truss().str(),
                        {"Path/Resolution=" + text(resolution)})
      .points.size();
  };
  // Deviations are proportional to the square of the distance.
  EXPECT_NEAR(double(n(0.001)) / n(0.016), 4, 1.2);
}

TEST(StaticPath, UnsupportedScenesAreRejected)
{
  expect_parts(input_error_of([] { FollowedPath(truss().str()); }),
               {"no load and no prescribed motion", "Path/Time of the loads"});
  expect_parts(input_error_of([] {
                 FollowedPath(pressed_truss().str(),
                              {"Effects/Large rotation=off"});
               }),
               {"Effects/Large rotation = off", "static path"});
  expect_parts(input_error_of([] {
                 FollowedPath(pressed_truss().str(),
                              {"Discretization/Order=auto"});
               }),
               {"Discretization/Order = auto", "static path"});
  expect_parts(input_error_of([] {
                 FollowedPath(pressed_truss().str(), {"Solver/Type=gmres"});
               }),
               {"Solver/Type = gmres", "static path", "mumps"});
}

TEST(StaticPath, UnsymmetricTangentNeedsDirectSolver)
{
  // The load follows the tip, and CHOLMOD uses the symmetric part only.
  SceneText scene = static_frame("0 0; 0 1", "0 1");
  scene.section({1e4, 1e4, 1})
    .support("clamp", "0", "clamp")
    .mesh(2, 2)
    .load("turning", "1", {"0", "-5 * t", "0"})
    .set("Loads/turning/Direction", "follows the joint")
    .set("Solver/Type", "cholmod")
    .time(1, 1);
  try
    {
      FollowedPath path(scene.str());
      ADD_FAILURE() << "The path was followed.";
    }
  catch (const ComputationError &error)
    {
      expect_parts(error.what(), {"becomes unsymmetric", "Solver/Type", "klu"});
    }
}

TEST(StaticPath, ViscousProcessesAreRelaxed)
{
  // A standard linear solid holds the apex by its long-time spring alone.
  const double    force = 600, stiffness = 150;
  const SceneText scene = pressed_truss(force).connector(
    "damper",
    "standard-linear-solid",
    "Between = ground: 1 | Geometry = direction | Direction = 0 1 | "
    "Long-time stiffness = " +
      text(stiffness) +
      " | Spring stiffness = 1000 | Damping coefficient = 10");
  const FollowedPath path(scene.str());
  for (const FollowedPath::Point &point : path.points)
    EXPECT_NEAR(force * point.load_factor,
                truss_force(deflection(point)) + stiffness * deflection(point),
                1e-7 * force);
  EXPECT_LE(std::abs(path.points.back().energies.dissipated()), 1e-12);
}

TEST(StaticPath, SwitchesToEitherSideOfBranch)
{
  const SceneText scene = static_frame("0 0; 0 1", "0 1")
                            .section({1e5, 1e5, 1})
                            .support("clamp", "0", "clamp")
                            .load("weight", "1", {"0", "-5 * t", "0"})
                            .mesh(4, 2)
                            .time(1, 1);
  const auto sway = [&](const char *branch, const char *opposite) {
    const FollowedPath path(scene.str(),
                            {std::string("Path/Branch=") + branch,
                             std::string("Path/Reverse branch=") + opposite});
    EXPECT_EQ(path.points.back().load_factor, 1.);
    EXPECT_EQ(path.points.back().n_negative, branch[0] == '0' ? 1u : 0u);
    return path.points.back().motions[1][0];
  };
  EXPECT_NEAR(sway("0", "false"), 0, 1e-6);
  const double to_one = sway("stable", "false"), to_other = sway("1", "true");
  EXPECT_GT(std::abs(to_one), 0.5);
  EXPECT_NEAR(to_one, -to_other, 1e-6);
}

TEST(StaticPath, PassesDoubleBifurcation)
{
  // Two equal columns in the plane, and one of square section in space, which
  // buckles to all sides alike, under 1.2 of pi^2 EI / (4 L^2).
  const double EI = 210e9 * std::pow(0.01, 4) / 12, P = M_PI * M_PI * EI / 4;
  for (const unsigned int dimension : {2, 3})
    {
      SCOPED_TRACE(dimension);
      SceneText scene = static_scene().dimension(dimension);
      if (dimension == 2)
        scene.frame("0 0; 0 1; 3 0; 3 1", "0 1; 2 3")
          .support("feet", "0, 2", "clamp")
          .load("weight", "1, 3", {"0", text(-P) + " * t", "0"});
      else
        scene.frame("0 0 0; 0 1 0", "0 1")
          .support("foot", "0", "clamp")
          .load("weight", "1", {"0", text(-P) + " * t", "0"}, {"0", "0", "0"});
      scene.rectangle("steel", 0.01, 0.01, {210e9, "", 0.3})
        .mesh(4, 1)
        .set("Path/Branch", "stable")
        .set("Path/Largest load factor", 1.2)
        .set("Path/Points", 200)
        .time(1, 1);
      const FollowedPath path(scene);
      EXPECT_TRUE(path.result.findings.empty())
        << verdict_text(path.result.findings);
      ASSERT_EQ(path.singular_points.size(), 1u);
      EXPECT_NEAR(path.singular_points[0].load_factor, 1, 1e-3);
      EXPECT_EQ(path.singular_points[0].singular.multiplicity(), 2u);
      // The elastica of a cantilever: 1 - (2 E(k) / K(k) - 1) with K^2 = 1.2
      // pi^2 / 4 (Timoshenko & Gere 1961, sec. 2.7).
      const auto &last = path.points.back();
      EXPECT_NEAR(last.load_factor, 1.2, 1e-6);
      // In space the sign of the zero eigenvalue is round-off.
      if (dimension == 2)
        {
          EXPECT_EQ(last.n_negative, 0u);
        }
      for (unsigned int joint = 1; joint < last.motions.size(); joint += 2)
        EXPECT_NEAR(-last.motions[joint][1], 0.3261, 0.003);
    }
}

TEST(StaticPathOnRanks, IsTheSame)
{
  const SceneText scene = static_scene()
                            .cells("star", 3, 2)
                            .set("Lattice/Strut length", 0.01)
                            .set("Lattice/Opening angle", "60 deg")
                            .rectangle("all", 4e-4, 4e-4, {70e9})
                            .support("foot", "bottom", "clamp")
                            .load("weight", "top", {"0", "-3 * t", "0"})
                            .time(1, 1);
  const std::vector<std::string> settings = {"Path/Branch=1", "Path/Points=12"};
  const FollowedPath             alone(scene.str(), settings),
    together(scene.str(), settings, MPI_COMM_WORLD);
  ASSERT_EQ(alone.points.size(), together.points.size());
  for (unsigned int i = 0; i < alone.points.size(); ++i)
    {
      EXPECT_NEAR(alone.points[i].load_factor,
                  together.points[i].load_factor,
                  1e-7);
      EXPECT_EQ(alone.points[i].n_negative, together.points[i].n_negative);
    }
  ASSERT_GE(alone.bifurcations().size(), 1u);
  EXPECT_NEAR(alone.bifurcations()[0].load_factor,
              together.bifurcations().at(0).load_factor,
              1e-8);
}

TEST(StaticPath, DeterminantSignMatchesNegativeCount)
{
  const SceneText column = static_frame("0 0; 0 1; 0 1.4", "0 1; 1 2")
                             .section({1e5, 1e5, 1})
                             .rigid_part("bar", "1", 1)
                             .set("Rigid parts/bar/Elastic struts", "clamped")
                             .support("clamp", "0", "clamp")
                             .load("weight", "2", {"0", "-40 * t", "0"})
                             .mesh(4, 2)
                             .time(1, 1);
  for (const SceneText &scene : {pressed_truss(), column})
    for (const char *solver : {"auto", "klu", "mumps"})
      {
        unsigned int       n_unstable = 0;
        const FollowedPath path(scene.str(),
                                {std::string("Solver/Type=") + solver});
        for (const FollowedPath::Point &point : path.points)
          {
            ASSERT_TRUE(point.n_negative);
            EXPECT_EQ(point.determinant_sign,
                      *point.n_negative % 2 == 0 ? 1 : -1);
            n_unstable += *point.n_negative % 2;
          }
        EXPECT_GE(n_unstable, 2u);
      }
}

namespace
{
  /** A column under forces, some of which follow the joints of its top. */
  SceneText stars_under_follower_loads()
  {
    return static_scene()
      .cells("star", 1, 2)
      .set("Lattice/Strut length", 0.01)
      .set("Lattice/Opening angle", "60 deg")
      .rectangle("all", 4e-4, 4e-4, {70e9})
      .support("foot", "bottom", "clamp")
      .load("weight", "top", {"0", "-2 * t", "0"})
      .load("wind", "top", {"0", "-0.5 * t", "0"})
      .set("Loads/wind/Direction", "follows the joint")
      .time(1, 1);
  }

  /** Points at which the determinant of the stiffness is negative. */
  unsigned int n_beyond_divergence(const FollowedPath &path)
  {
    return std::count_if(path.points.begin(),
                         path.points.end(),
                         [](const auto &point) {
                           return point.determinant_sign == -1;
                         });
  }
} // namespace

TEST(StaticPathOnRanks, FindsDivergence)
{
  const SceneText scene = stars_under_follower_loads();
  for (const char *solver : {"auto", "mumps"})
    for (const char *branch : {"stable", "0"})
      {
        const std::vector<std::string> settings = {std::string("Solver/Type=") +
                                                     solver,
                                                   std::string("Path/Branch=") +
                                                     branch,
                                                   "Path/Points=12"};
        const FollowedPath             alone(scene.str(), settings),
          together(scene.str(), settings, MPI_COMM_WORLD);
        // Sums of ranks differ by round-off, and the steps beyond the
        // bifurcation are as long as iterations allow.
        EXPECT_NEAR(alone.points.size(), together.points.size(), 2);
        EXPECT_NEAR(n_beyond_divergence(alone),
                    n_beyond_divergence(together),
                    2);
        ASSERT_EQ(alone.bifurcations().size(), together.bifurcations().size());
        ASSERT_GE(alone.bifurcations().size(), 1u);
        const FollowedPath::Singular found = alone.bifurcations()[0];
        EXPECT_NEAR(found.load_factor,
                    together.bifurcations().at(0).load_factor,
                    1e-7);
        // Only the sign of the determinant detects it.
        EXPECT_FALSE(alone.points.back().n_negative);
        EXPECT_EQ(found.singular.before.determinant_sign, 1);
        EXPECT_EQ(found.singular.after.determinant_sign, -1);
        // The path may switch to a stable branch or not.
        const bool leaves = branch[0] == 's';
        EXPECT_EQ(n_beyond_divergence(together) == 0, leaves);
        EXPECT_EQ(alone.points.back().determinant_sign, leaves ? 1 : -1);
      }
}

TEST(StaticPath, LoadProjectionSeparatesLimitPoints)
{
  const SceneText shallow =
    static_frame("-12.943 0; 0 0.386; 12.943 0", "0 1; 1 2")
      .section({1.88e6, 1.88e6, 9300})
      .support("feet", "0, 2", "clamp")
      .load("weight", "1", {"0", "-80 * t", "0"})
      .mesh(3)
      .time(1, 1);
  SceneText following = shallow;
  following.set("Loads/weight/Direction", "follows the joint");
  unsigned int n_found[2] = {};
  for (const std::string &scene : {pressed_truss().str(),
                                   shallow.str(),
                                   following.str(),
                                   stars_under_follower_loads().str()})
    for (const FollowedPath::Singular &point :
         FollowedPath(scene).singular_points)
      {
        ASSERT_TRUE(point.singular.load_projection);
        if (point.kind == SingularPoint::Kind::limit)
          {
            EXPECT_GT(*point.singular.load_projection, 0.1);
          }
        else
          {
            EXPECT_LT(*point.singular.load_projection, 1e-4);
          }
        ++n_found[point.kind == SingularPoint::Kind::limit ? 0 : 1];
      }
  EXPECT_GE(n_found[0], 6u);
  EXPECT_GE(n_found[1], 1u);
}
