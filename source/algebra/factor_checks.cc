#include <auxfem/algebra/factor_checks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

namespace auxfem
{
  namespace
  {
    double length(const std::vector<double> &x)
    {
      return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.));
    }
  } // namespace

  bool has_finite_entries(const SparseMatrix &matrix)
  {
    // Zero times a number that is not finite is none; one branch at the end
    // lets the compiler vectorize.
    double sum = 0;
    for (const double entry : matrix.entries)
      sum += 0. * entry;
    return sum == 0.;
  }

  FactorizationOutcome agree(const FactorizationOutcome mine,
                             const MPI_Comm             communicator)
  {
    return static_cast<FactorizationOutcome>(
      dealii::Utilities::MPI::max(static_cast<int>(mine), communicator));
  }

  FactorizationOutcome
  guard_memory(const std::function<FactorizationOutcome()> &action)
  {
    try
      {
        return action();
      }
    catch (const std::bad_alloc &)
      {
        return FactorizationOutcome::out_of_memory;
      }
  }

  std::vector<double> equilibration(const SparseMatrix &matrix)
  {
    const std::size_t n = matrix.layout->n_owned();
    // Zero: not found yet, because of a zero diagonal and no neighbours before.
    std::vector<double> scale(n, 0.);
    for (std::size_t row = 0; row < n; ++row)
      {
        double largest = 0;
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          {
            const std::size_t column = matrix.columns[i];
            const double      size   = std::abs(matrix.entries[i]);
            if (column == row)
              largest = std::max(largest, std::sqrt(size));
            else if (column < row)
              largest = std::max(largest, size * scale[column]);
          }
        if (largest > 0)
          scale[row] = 1 / largest;
      }
    for (std::size_t row = 0; row < n; ++row)
      if (scale[row] == 0)
        {
          double largest = 0;
          for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1];
               ++i)
            largest =
              std::max(largest,
                       std::abs(matrix.entries[i]) * scale[matrix.columns[i]]);
          scale[row] = largest > 0 ? 1 / largest : 1;
        }
    return scale;
  }

  double estimate_norm(const std::size_t                                 n,
                       const std::function<void(std::vector<double> &)> &apply)
  {
    // No pattern that a structure's modes could be orthogonal to.
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
      x[i] = (i * 2654435761u & 0x10000u) != 0 ? 1. : -1.;
    double norm = 0;
    for (unsigned int iteration = 0; iteration < 2; ++iteration)
      {
        const double size = length(x);
        for (double &value : x)
          value /= size;
        apply(x);
        norm = length(x);
      }
    return norm;
  }
} // namespace auxfem
