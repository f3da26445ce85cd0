#ifndef auxfem_tests_verification_cell_reference_h
#define auxfem_tests_verification_cell_reference_h

#include <boost/numeric/odeint.hpp>
#include <support/cell_scene.h>

#include <array>
#include <cmath>
#include <functional>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * The rigid cell by another integrator (Fehlberg's 7(8) of Boost.Odeint)
     * from equations written down again: nothing of auxfem is used. Unknowns
     * theta, Y2, their rates and the stretch Y3 of the Maxwell element's
     * spring.
     */
    class CellReference
    {
    public:
      CellReference(const CellCase &c, const std::function<double(double)> &f1)
        : c(c)
        , f1(f1)
      {}

      struct Row
      {
        double theta, Y2, f2;
      };

      /** At the ends of the steps of the case, the first at t = 0. */
      std::vector<Row> rows() const
      {
        namespace odeint = boost::numeric::odeint;
        using Stepper    = odeint::runge_kutta_fehlberg78<State>;
        std::vector<double> times;
        for (unsigned int i = 0; i <= c.n_steps; ++i)
          times.push_back(c.end / c.n_steps * i);
        State            x = {theta0(), 0, 0, 0, 0};
        std::vector<Row> result;
        odeint::integrate_times(
          odeint::make_controlled<Stepper>(1e-16, 1e-13),
          [this](const State &x, State &dx, const double t) {
            differentiate(x, dx, t);
          },
          x,
          times.begin(),
          times.end(),
          times[1] / 100,
          [&](const State &x, const double) {
            result.push_back({x[0], x[1], -force(x)});
          });
        return result;
      }

    private:
      using State = std::vector<double>;

      double theta0() const
      {
        return c.angle * M_PI / 180;
      }

      double rate(const State &x) const
      {
        return x[3] + 2 * c.bar_length * std::cos(x[0]) * x[2];
      }

      double force(const State &x) const
      {
        const double Y1 =
          x[1] + 2 * c.bar_length * (std::sin(x[0]) - std::sin(theta0()));
        return c.law == "maxwell" ? c.stiffness * x[4]
                                  : c.stiffness * Y1 + c.damping * rate(x);
      }

      void differentiate(const State &x, State &dx, const double t) const
      {
        const double L = c.bar_length, m1 = c.bar_mass, m2 = c.part_mass;
        const double cs = std::cos(x[0]), s = std::sin(x[0]), w = x[2];
        const double M11 =
          L * L * ((4 * m2 + 5 * m1) * cs * cs + m1 * s * s + m1 / 3);
        const double M12 = 2 * L * cs * (m2 + 2 * m1);
        const double M22 = 2 * m2 + 4 * m1;
        const double R   = -(f1(t) + force(x));
        const double r1 =
          2 * L * cs * R + 4 * L * L * (m1 + m2) * s * cs * w * w;
        const double r2  = R + 2 * L * s * (m2 + 2 * m1) * w * w;
        const double det = M11 * M22 - M12 * M12;
        dx               = {w,
                            x[3],
                            (M22 * r1 - M12 * r2) / det,
                            (M11 * r2 - M12 * r1) / det,
                            rate(x) - c.stiffness / c.damping * x[4]};
      }

      const CellCase                      c;
      const std::function<double(double)> f1;
    };

    /** Largest difference of theta and f2, each of its largest value. */
    inline std::array<double, 2>
    differences(const std::vector<CellSample>         &samples,
                const std::vector<CellReference::Row> &reference)
    {
      double theta = 0, f2 = 0, theta_scale = 0, f2_scale = 0;
      for (std::size_t i = 0; i < reference.size(); ++i)
        {
          const CellReference::Row &row = reference[i];
          theta       = std::max(theta, std::abs(samples[i].angle - row.theta));
          f2          = std::max(f2, std::abs(samples[i].transmitted - row.f2));
          theta_scale = std::max(theta_scale, std::abs(row.theta));
          f2_scale    = std::max(f2_scale, std::abs(row.f2));
        }
      return {{theta / theta_scale, f2 / f2_scale}};
    }
  } // namespace testing_support
} // namespace auxfem

#endif
