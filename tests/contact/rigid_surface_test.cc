#include <auxfem/contact/rigid_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace auxfem;

namespace
{
  using Vector3 = dealii::Tensor<1, 3>;
  using Surface = std::shared_ptr<const RigidSurface>;

  const Vector3 some_axis = Vector3({2. / 3, -1. / 3, 2. / 3});

  struct NamedSurface
  {
    std::string name;
    Surface     surface;
  };

  std::vector<NamedSurface> all_surfaces()
  {
    return {{"plane", make_plane_surface(some_axis)},
            {"sphere", make_sphere_surface(0.7)},
            {"cylinder", make_cylinder_surface(some_axis, 0.7)}};
  }

  // No point on an axis or centre, where the normal is undefined.
  const std::vector<Vector3> points = {Vector3({0.3, 0.5, -0.2}),
                                       Vector3({1.2, -0.4, 0.9}),
                                       Vector3({-0.1, 2.5, 0.4}),
                                       Vector3({0.6, 0.2, 0.1})};

  Vector3 along(const unsigned int component, const double length)
  {
    Vector3 result;
    result[component] = length;
    return result;
  }
} // namespace

TEST(RigidSurface, DistancesAreThoseOfGeometry)
{
  const Vector3 point({1, 2, 2});
  EXPECT_DOUBLE_EQ(make_plane_surface(Vector3({0, 0.6, 0.8}))->distance(point),
                   2.8);
  EXPECT_DOUBLE_EQ(make_sphere_surface(0.5)->distance(point), 2.5);
  EXPECT_DOUBLE_EQ(
    make_cylinder_surface(Vector3({1, 0, 0}), 0.5)->distance(point),
    std::sqrt(8.) - 0.5);
  // Inside.
  EXPECT_DOUBLE_EQ(make_sphere_surface(4)->distance(point), -1);
}

TEST(RigidSurface, NormalAndCurvatureAreDerivatives)
{
  const double h = 1e-5;
  for (const auto &[name, surface] : all_surfaces())
    for (const Vector3 &point : points)
      {
        SCOPED_TRACE(name);
        const SurfaceDistance now = surface->at(point);
        EXPECT_DOUBLE_EQ(now.distance, surface->distance(point));
        EXPECT_NEAR(now.normal.norm(), 1, 1e-15);
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto plus  = surface->at(point + along(c, h)),
                       minus = surface->at(point - along(c, h));
            // Third derivatives here are at most some hundred.
            EXPECT_NEAR((plus.distance - minus.distance) / (2 * h),
                        now.normal[c],
                        1e-8);
            for (unsigned int i = 0; i < 3; ++i)
              EXPECT_NEAR((plus.normal[i] - minus.normal[i]) / (2 * h),
                          now.curvature[i][c],
                          1e-8);
          }
      }
}

TEST(RigidSurface, MeanDirectionTimesTheWayIsTheChangeOfDistance)
{
  for (const auto &[name, surface] : all_surfaces())
    for (const Vector3 &from : points)
      for (const Vector3 &to : points)
        {
          SCOPED_TRACE(name);
          const MeanDistance mean = surface->between(from, to);
          EXPECT_NEAR(mean.direction * (to - from),
                      surface->distance(to) - surface->distance(from),
                      1e-15);
          const double h = 1e-5;
          for (unsigned int c = 0; c < 3; ++c)
            {
              const Vector3 difference =
                surface->between(from, to + along(c, h)).direction -
                surface->between(from, to - along(c, h)).direction;
              for (unsigned int i = 0; i < 3; ++i)
                EXPECT_NEAR(difference[i] / (2 * h), mean.change[i][c], 1e-8);
            }
        }
  for (const auto &[name, surface] : all_surfaces())
    EXPECT_LT((surface->between(points[0], points[0]).direction -
               surface->at(points[0]).normal)
                .norm(),
              1e-15)
      << name;
}

TEST(RigidSurface, OutlinesLieOnTheSurface)
{
  for (const auto &[name, surface] : all_surfaces())
    {
      const auto lines = surface->outline(3, 3);
      ASSERT_FALSE(lines.empty()) << name;
      for (const auto &line : lines)
        {
          EXPECT_GE(line.size(), 2u);
          for (const Vector3 &point : line)
            EXPECT_NEAR(surface->distance(point), 0, 1e-14) << name;
        }
    }
  // In planar models outlines lie in the plane.
  for (const Surface &surface :
       {make_plane_surface(Vector3({0.6, 0.8, 0})), make_sphere_surface(0.7)})
    for (const auto &line : surface->outline(3, 2))
      for (const Vector3 &point : line)
        EXPECT_EQ(point[2], 0);
}
