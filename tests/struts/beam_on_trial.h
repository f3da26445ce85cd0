#ifndef auxfem_tests_elements_beam_on_trial_h
#define auxfem_tests_elements_beam_on_trial_h

#include <auxfem/struts/beam_2d_tangent.h>
#include <auxfem/struts/beam_dispatch.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** One beam element of any order, straight or a circular arc, with section
     * stiffnesses of equal size, so that no term hides behind a larger one. */
    template <int p>
    class BeamOnTrial
    {
    public:
      static constexpr int order          = p;
      static constexpr int n              = 3 * (p + 1);
      using Vector                        = std::array<double, n>;
      using Matrix                        = std::array<double, n * n>;
      using Position                      = std::array<double, 2>;
      const Beam2D::Stiffness     section = {3, 2, 0.7, 0.4};
      const double                jacobian;
      const BeamShape<p>          shape;
      std::array<Position, p + 1> nodes;

      /** An arc of @p length that starts at (0, 0) in the direction @p angle
       * and has @p curvature (0: straight). */
      BeamOnTrial(const double length,
                  const double angle,
                  const double curvature,
                  const bool   makes_up_for_shear = false)
        : jacobian(length / 2)
        , shape(makes_up_for_shear ? BeamShape<p>::max_compensated_shear : 0.)
      {
        for (int a = 0; a <= p; ++a)
          nodes[a] = axis(jacobian * (1 + shape.node[a]), angle, curvature);
        for (int g = 0; g < p; ++g)
          {
            const double turned =
              angle + curvature * jacobian * (1 + shape.point[g]);
            Position slope = {{0, 0}};
            for (int a = 0; a <= p; ++a)
              for (int d = 0; d < 2; ++d)
                slope[d] += shape.derivative[g][a] / jacobian * nodes[a][d];
            const double c = std::cos(turned), s = std::sin(turned);
            frames[g] = {c,
                         s,
                         c * slope[0] + s * slope[1],
                         c * slope[1] - s * slope[0]};
          }
      }

      const Beam2D::Frame *gauss_frames() const
      {
        return frames.data();
      }

      template <bool large_rotation, bool damped>
      Beam2D::EnergyRate
      force(const Vector &u, const Vector &v, Vector &result) const
      {
        return Beam2D::internal_force<p, large_rotation, damped>(
          shape,
          frames.data(),
          jacobian,
          Beam2D::ElasticSection{section},
          u.data(),
          v.data(),
          result.data());
      }

      template <bool large_rotation, bool damped>
      Matrix tangent(const Vector &u,
                     const Vector &v,
                     const double  stiffness_factor,
                     const double  damping_factor) const
      {
        Matrix matrix;
        Beam2D::tangent<p, large_rotation, damped>(shape,
                                                   frames.data(),
                                                   jacobian,
                                                   Beam2D::ElasticSection{
                                                     section},
                                                   u.data(),
                                                   v.data(),
                                                   stiffness_factor,
                                                   damping_factor,
                                                   matrix.data());
        return matrix;
      }

      /** Rotates displacements @p u by @p angle about (0, 0), then translates
       * them. */
      Vector
      moved(const Vector &u, const double angle, const Position &shift) const
      {
        Vector result;
        for (int a = 0; a <= p; ++a)
          {
            const double x = nodes[a][0] + u[3 * a],
                         y = nodes[a][1] + u[3 * a + 1];
            const double c = std::cos(angle), s = std::sin(angle);
            result[3 * a]     = c * x - s * y + shift[0] - nodes[a][0];
            result[3 * a + 1] = s * x + c * y + shift[1] - nodes[a][1];
            result[3 * a + 2] = u[3 * a + 2] + angle;
          }
        return result;
      }

    private:
      static Position
      axis(const double s, const double angle, const double curvature)
      {
        if (curvature == 0)
          return {{s * std::cos(angle), s * std::sin(angle)}};
        return {
          {(std::sin(angle + curvature * s) - std::sin(angle)) / curvature,
           (std::cos(angle) - std::cos(angle + curvature * s)) / curvature}};
      }

      std::array<Beam2D::Frame, p> frames;
    };

    /** Reproducible numbers in [-size, size]. */
    template <class Vector>
    Vector irregular(const double size, const unsigned int seed)
    {
      std::mt19937 generator(seed);
      Vector       result;
      for (double &value : result)
        value = size * (2. * generator() / generator.max() - 1);
      return result;
    }

    template <class Vector>
    double largest(const Vector &vector)
    {
      double result = 0;
      for (const double value : vector)
        result = std::max(result, std::abs(value));
      return result;
    }

    /** Calls @p check with straight and curved elements of every order, with
     * and without shear flexibility. */
    template <class Check>
    void for_each_beam(const Check &check)
    {
      for (unsigned int order = 1; order <= 6; ++order)
        for (const double curvature : {0., 0.8})
          for (const bool makes_up_for_shear : {false, true})
            {
              SCOPED_TRACE("order " + std::to_string(order) + ", curvature " +
                           std::to_string(curvature) +
                           (makes_up_for_shear ? ", without shear" : ""));
              dispatch_order(order, [&](auto p) {
                check(BeamOnTrial<p>(1.6, 0.4, curvature, makes_up_for_shear));
              });
            }
    }
  } // namespace testing_support
} // namespace auxfem

#endif
