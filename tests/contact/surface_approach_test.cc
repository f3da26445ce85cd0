#include <auxfem/contact/rigid_surface.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

namespace
{
  using Vector3 = AxisCurve::Vector;

  /** A wave of one metre. */
  AxisCurve wave(const Vector3 &at)
  {
    AxisCurve curve;
    curve.degree       = 4;
    curve.coefficients = {{at,
                           Vector3({1, 0.8, 0}),
                           Vector3({0, -2, 0.1}),
                           Vector3({0, 0.3, 0}),
                           Vector3({0, 0.9, 0})}};
    return curve;
  }

  /** Smallest distance over many points and instants. */
  double sampled_distance(const RigidSurface &surface,
                          const AxisCurve    &from,
                          const AxisCurve    &to)
  {
    constexpr unsigned int n     = 100;
    double                 least = 1e9;
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j <= n; ++j)
        {
          const double s = double(i) / n, t = double(j) / n;
          least =
            std::min(least,
                     surface.distance((1 - t) * from.at(s) + t * to.at(s)));
        }
    return least;
  }
} // namespace

TEST(SurfaceApproach, FindsTheClosestApproachOnThePath)
{
  const Vector3 axis({0.6, 0, 0.8});
  for (const auto &surface : {make_plane_surface(Vector3({0, 1, 0})),
                              make_sphere_surface(0.05),
                              make_cylinder_surface(axis, 0.05)})
    for (const Vector3 &start : {Vector3({-0.4, 0.4, 0.02}),
                                 Vector3({-1.5, -0.1, 0.2}),
                                 Vector3({-0.9, 1.3, 0})})
      {
        const AxisCurve from = wave(start),
                        to   = wave(Vector3({-0.2, 0.1, 0.3}));
        const ControlPolygon first(from, 4), last(to, 4);
        const double         least = sampled_distance(*surface, from, to);
        // Sampled positions are up to 2 cm apart.
        constexpr double spacing = 0.02;
        EXPECT_FALSE(find_passage(*surface, first, last, least - spacing));
        const auto found = find_passage(*surface, first, last, least + spacing);
        ASSERT_TRUE(found);
        const Vector3 place =
          (1 - found->path_fraction) * from.at(found->parameter) +
          found->path_fraction * to.at(found->parameter);
        EXPECT_LT(surface->distance(place), least + spacing);
      }
}

TEST(SurfaceApproach, FindsASmallBodyThatALongAxisPasses)
{
  // A line of 1 m moves through a ball of 0.1 mm.
  AxisCurve from;
  from.coefficients     = {{Vector3({-0.7123, 0.3, 0}), Vector3({1, 0, 0})}};
  AxisCurve to          = from;
  to.coefficients[0][1] = -0.8;
  const auto ball       = make_sphere_surface(1e-4);
  EXPECT_TRUE(
    find_passage(*ball, ControlPolygon(from, 1), ControlPolygon(to, 1), 0));
  from.coefficients[0][2] = to.coefficients[0][2] = 1.01e-4;
  EXPECT_FALSE(
    find_passage(*ball, ControlPolygon(from, 1), ControlPolygon(to, 1), 0));
}

TEST(SurfaceApproach, PartsLieBetweenTheRootsOfLevels)
{
  // A line at half the radius from the centre of a ball.
  AxisCurve line;
  line.coefficients       = {{Vector3({-1, 0.5, 0}), Vector3({3, 0, 0})}};
  const double half       = std::sqrt(1 - 0.25) / 3;
  const auto   parameters = parameters_between_levels(*make_sphere_surface(0.9),
                                                    {ControlPolygon(line, 3)},
                                                    {0.1});
  ASSERT_EQ(parameters.size(), 4u);
  EXPECT_NEAR(parameters[1], 1. / 3 - half, 1e-12);
  EXPECT_NEAR(parameters[2], 1. / 3 + half, 1e-12);
  // A level behind the centre does not exist.
  EXPECT_EQ(parameters_between_levels(*make_sphere_surface(0.9),
                                      {ControlPolygon(line, 3)},
                                      {-2})
              .size(),
            2u);
}
