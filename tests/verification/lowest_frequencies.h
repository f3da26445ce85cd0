#ifndef auxfem_tests_verification_lowest_frequencies_h
#define auxfem_tests_verification_lowest_frequencies_h

#include <deal.II/lac/lapack_full_matrix.h>

#include <support/scene_run.h>

#include <cmath>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** The tangent with @p factors at rest, in the rows and columns @p unknowns. */
    inline dealii::LAPACKFullMatrix<double>
    matrix_at_rest(SceneRun               &run,
                   const TangentFactors   &factors,
                   const std::vector<int> &unknowns)
    {
      const State      before = run.state;
      const Evaluation step   = Evaluation::step(before, run.state, 1);
      run.residual(step);
      const auto tangent = run.make_tangent();
      run.tangent(step, factors, *tangent);

      Vector unit(run.model.numbering.layout().n_local()), column(unit);
      dealii::LAPACKFullMatrix<double> matrix(unknowns.size(), unknowns.size());
      for (unsigned int j = 0; j < unknowns.size(); ++j)
        {
          unit[unknowns[j]] = 1;
          tangent->multiply(unit.data(), column.data());
          unit[unknowns[j]] = 0;
          for (unsigned int i = 0; i < unknowns.size(); ++i)
            {
              // LAPACK reads one triangle: the mean of both is nearer to the
              // matrix without round-off.
              matrix(i, j) += column[unknowns[i]] / 2;
              matrix(j, i) += column[unknowns[i]] / 2;
            }
        }
      return matrix;
    }

    /**
     * The lowest @p n_modes frequencies (Hz) above zero at rest, rising, of the
     * motions of @p unknowns.
     */
    inline std::vector<double>
    lowest_frequencies(SceneRun               &run,
                       const std::vector<int> &unknowns,
                       const unsigned int      n_modes)
    {
      // M x = mu (K + s M) x: positive definite on the right even if the
      // lattice is free or has no rotary inertia; the lowest frequencies have
      // the largest mu, which come out best.
      const double shift   = std::pow(2 * std::acos(-1.) * 500, 2);
      auto         mass    = matrix_at_rest(run, {0, 0, 1}, unknowns);
      auto         shifted = matrix_at_rest(run, {1, 0, shift}, unknowns);
      std::vector<dealii::Vector<double>> modes(0);
      mass.compute_generalized_eigenvalues_symmetric(shifted, modes);

      std::vector<double> result;
      const unsigned int  n         = unknowns.size();
      const double        threshold = std::pow(2 * std::acos(-1.), 2);
      for (unsigned int i = 0; i < n && result.size() < n_modes; ++i)
        {
          const double mu      = mass.eigenvalue(n - 1 - i).real();
          const double squared = 1 / mu - shift;
          if (squared > threshold)
            result.push_back(std::sqrt(squared) / (2 * std::acos(-1.)));
        }
      return result;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
