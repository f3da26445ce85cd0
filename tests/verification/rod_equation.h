#ifndef auxfem_tests_verification_rod_equation_h
#define auxfem_tests_verification_rod_equation_h

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <array>
#include <cmath>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** A clamped rod of unit length, along x at the clamp. */
    struct ClampedRod
    {
      Stiffnesses stiffnesses;
      double      curvature;                ///< at rest
      double      force_x, force_y, moment; ///< dead loads at the tip
    };

    /**
     * Solves the equilibrium of Reissner's planar rod (1972) as an initial
     * value problem from the clamp,
     *
     *     r' = (1 + N/EA) t + (Q/kGA) n,   phi' = curvature + M/EI,
     *     M' = -r' x F,   N = F.t, Q = F.n,
     *
     * with the fourth-order Runge-Kutta method; the moment at the clamp is
     * found by secants so that M at the tip is the load's. Independent of the
     * finite elements.
     */
    class RodEquation
    {
    public:
      /** Position x, y, direction phi of the section, and moment M. */
      using Point = std::array<double, 4>;

      RodEquation(const ClampedRod &rod, const unsigned int n_steps)
        : rod(rod)
        , n_steps(n_steps)
      {
        double    moment   = 0;
        const int n_levels = 20;
        for (int level = 1; level <= n_levels; ++level)
          {
            factor = double(level) / n_levels;
            moment = find_moment(moment);
          }
        integrate(moment);
      }

      /** At the end of step @p i. */
      const Point &operator[](const unsigned int i) const
      {
        return points.at(i);
      }

    private:
      Point slope(const Point &p) const
      {
        const double c = std::cos(p[2]), s = std::sin(p[2]);
        const double X = factor * rod.force_x, Y = factor * rod.force_y;
        const double along  = 1 + (X * c + Y * s) / rod.stiffnesses.axial;
        const double across = (Y * c - X * s) / rod.stiffnesses.shear;
        const double dx = along * c - across * s, dy = along * s + across * c;
        return {{dx,
                 dy,
                 rod.curvature + p[3] / rod.stiffnesses.bending,
                 X * dy - Y * dx}};
      }

      static Point move(const Point &p, const double h, const Point &slope)
      {
        Point moved;
        for (unsigned int i = 0; i < 4; ++i)
          moved[i] = p[i] + h * slope[i];
        return moved;
      }

      /** Returns the excess of the tip's moment over the load's. */
      double integrate(const double moment_at_clamp)
      {
        const double h = 1. / n_steps;
        points.assign(1, {{0, 0, 0, moment_at_clamp}});
        for (unsigned int i = 0; i < n_steps; ++i)
          {
            const Point &p = points.back();
            const Point  a = slope(p), b = slope(move(p, h / 2, a));
            const Point  c = slope(move(p, h / 2, b)), d = slope(move(p, h, c));
            Point        mean;
            for (unsigned int k = 0; k < 4; ++k)
              mean[k] = (a[k] + 2 * b[k] + 2 * c[k] + d[k]) / 6;
            points.push_back(move(p, h, mean));
          }
        return points.back()[3] - factor * rod.moment;
      }

      double find_moment(const double guess)
      {
        double before = guess, moment = guess + 1e-3;
        double excess_before = integrate(before), excess = integrate(moment);
        for (int i = 0; i < 50 && std::abs(excess) > 1e-13; ++i)
          {
            const double next =
              moment - excess * (moment - before) / (excess - excess_before);
            before        = moment;
            excess_before = excess;
            moment        = next;
            excess        = integrate(moment);
          }
        EXPECT_LE(std::abs(excess), 1e-12) << "the reference is not solved";
        return moment;
      }

      const ClampedRod   rod;
      const unsigned int n_steps;
      double             factor = 1; ///< of the loads
      std::vector<Point> points;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
