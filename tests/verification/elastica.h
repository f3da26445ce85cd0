#ifndef auxfem_tests_verification_elastica_h
#define auxfem_tests_verification_elastica_h

#include <deal.II/lac/full_matrix.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** A piece of an inextensible rod in the plane with EI = 1, under a dead
     * line load along y. */
    struct Elastica
    {
      /** Position x, y, direction of the tangent, moment. */
      using Point = std::array<double, 4>;

      double length;
      double force_x, force_y; ///< section force at the start
      double load      = 0;    ///< per length along y
      double curvature = 0;    ///< at rest

      /** The end of the piece that starts at @p point, by the fourth-order
       * Runge-Kutta method for x' = cos, y' = sin, M' = Nx sin - Ny cos, Ny' =
       * -load. */
      Point end(Point point) const
      {
        constexpr unsigned int n = 500;
        const double           h = length / n;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double s = i * h;
            const Point  a = slope(s, point),
                        b  = slope(s + h / 2, moved(point, h / 2, a)),
                        c  = slope(s + h / 2, moved(point, h / 2, b)),
                        d  = slope(s + h, moved(point, h, c));
            for (unsigned int k = 0; k < 4; ++k)
              point[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
          }
        return point;
      }

    private:
      Point slope(const double s, const Point &p) const
      {
        const double cosine = std::cos(p[2]), sine = std::sin(p[2]);
        return {{cosine,
                 sine,
                 curvature + p[3],
                 force_x * sine - (force_y - load * s) * cosine}};
      }

      static Point moved(Point p, const double h, const Point &slope)
      {
        for (unsigned int k = 0; k < 4; ++k)
          p[k] += h * slope[k];
        return p;
      }
    };

    /**
     * Solves @p misses = 0 from a guess by Newton's method with differences, for
     * as many equations as unknowns.
     */
    inline std::vector<double>
    shoot(const std::function<std::vector<double>(const std::vector<double> &)>
                             &misses,
          std::vector<double> unknowns)
    {
      constexpr double   difference = 1e-6, tolerance = 1e-11;
      const unsigned int n    = unknowns.size();
      double             miss = 0;
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const std::vector<double> at = misses(unknowns);
          miss                         = 0;
          for (const double value : at)
            miss = std::max(miss, std::abs(value));
          if (miss < tolerance)
            break;
          dealii::FullMatrix<double> slopes(n, n);
          for (unsigned int j = 0; j < n; ++j)
            {
              std::vector<double> after = unknowns, before = unknowns;
              after[j] += difference;
              before[j] -= difference;
              const std::vector<double> plus  = misses(after),
                                        minus = misses(before);
              for (unsigned int i = 0; i < n; ++i)
                slopes(i, j) = (plus[i] - minus[i]) / (2 * difference);
            }
          slopes.gauss_jordan();
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              unknowns[i] -= slopes(i, j) * at[j];
        }
      EXPECT_LT(miss, tolerance) << "the reference is not solved";
      return unknowns;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
