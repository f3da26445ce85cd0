#ifndef auxfem_tests_verification_linear_ode_h
#define auxfem_tests_verification_linear_ode_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** x(@p time) of x' = A x from x(0) = @p start: Taylor series, scaled and squared. */
    inline dealii::Vector<double>
    solve_linear_ode(const dealii::FullMatrix<double> &A,
                     const dealii::Vector<double>     &start,
                     const double                      time)
    {
      const unsigned int n = A.m();
      const int          n_squarings =
        std::max(0, int(std::ceil(std::log2(A.frobenius_norm() * time))) + 1);
      dealii::FullMatrix<double> small(A), power{dealii::IdentityMatrix(n)},
        exponential(power), product(n, n);
      small *= time / std::pow(2., n_squarings);
      // Norm at most 1/2: the 18th term is below 1e-21.
      for (unsigned int i = 1; i <= 18; ++i)
        {
          power.mmult(product, small);
          power = product;
          power *= 1. / i;
          exponential.add(1., power);
        }
      for (int i = 0; i < n_squarings; ++i)
        {
          exponential.mmult(product, exponential);
          exponential = product;
        }
      dealii::Vector<double> result(n);
      exponential.vmult(result, start);
      return result;
    }

    /**
     * A mass on a connector, as linear equations of first order: spring k,
     * dashpot c and Maxwell elements (k_i, tau_i) side by side. The state is
     * displacement, velocity, forces of the Maxwell elements.
     */
    struct OneMass
    {
      double                                 mass, stiffness, damping;
      std::vector<std::pair<double, double>> elements;

      /** State at @p time; the Maxwell elements start as springs stretched by @p u0. */
      dealii::Vector<double>
      at(const double time, const double u0, const double v0) const
      {
        const unsigned int         n = 2 + elements.size();
        dealii::FullMatrix<double> A(n, n);
        dealii::Vector<double>     start(n);
        A(0, 1)  = 1;
        A(1, 0)  = -stiffness / mass;
        A(1, 1)  = -damping / mass;
        start(0) = u0;
        start(1) = v0;
        for (unsigned int i = 0; i < elements.size(); ++i)
          {
            const auto &[k, tau] = elements[i];
            A(1, 2 + i)          = -1 / mass;
            A(2 + i, 1)          = k;
            A(2 + i, 2 + i)      = -1 / tau;
            start(2 + i)         = k * u0;
          }
        return solve_linear_ode(A, start, time);
      }

      double acceleration(const dealii::Vector<double> &x) const
      {
        double force = stiffness * x(0) + damping * x(1);
        for (unsigned int i = 0; i < elements.size(); ++i)
          force += x(2 + i);
        return -force / mass;
      }
    };
  } // namespace testing_support
} // namespace auxfem

#endif
