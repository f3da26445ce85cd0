#include <auxfem/algebra/factor_checks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace
  {
    double length(const UnknownLayout &layout, const std::vector<double> &x)
    {
      return std::sqrt(
        layout.sum(std::inner_product(x.begin(), x.end(), x.begin(), 0.)));
    }

    /** Of |a_ij| s_j. */
    double largest_in_row(const SparseMatrix        &matrix,
                          const std::size_t          row,
                          const std::vector<double> &scale)
    {
      double largest = 0;
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        largest =
          std::max(largest,
                   std::abs(matrix.entries[i]) * scale[matrix.columns[i]]);
      return largest;
    }

    /** 1/sqrt(a_ii), and what fits to it where the diagonal is zero. */
    void scale_by_diagonal(const SparseMatrix  &matrix,
                           std::vector<double> &scale)
    {
      const UnknownLayout &layout = *matrix.layout;
      scale.assign(layout.n_local(), 0.);
      for (unsigned int row = 0; row < layout.n_owned(); ++row)
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          if (matrix.columns[i] == static_cast<int>(row) &&
              matrix.entries[i] != 0)
            scale[row] = 1 / std::sqrt(std::abs(matrix.entries[i]));
      layout.update_ghosts(scale.data());
      for (unsigned int row = 0; row < layout.n_owned(); ++row)
        if (scale[row] == 0)
          {
            const double largest = largest_in_row(matrix, row, scale);
            scale[row]           = largest > 0 ? 1 / largest : 1;
          }
      layout.update_ghosts(scale.data());
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

  void equilibrate(const SparseMatrix  &matrix,
                   std::vector<double> &scale,
                   std::vector<double> &room)
  {
    const UnknownLayout &layout = *matrix.layout;
    std::vector<double> &sizes  = room;
    sizes.resize(layout.n_owned());
    scale_by_diagonal(matrix, scale);
    // A step takes the square root of every excess.
    for (unsigned int step = 0; step < 10; ++step)
      {
        double largest = 0;
        for (std::size_t row = 0; row < sizes.size(); ++row)
          {
            sizes[row] = scale[row] * largest_in_row(matrix, row, scale);
            largest    = std::max(largest, sizes[row]);
          }
        if (layout.largest(largest) <= 2)
          break;
        for (std::size_t row = 0; row < sizes.size(); ++row)
          if (sizes[row] > 0)
            scale[row] /= std::sqrt(sizes[row]);
        layout.update_ghosts(scale.data());
      }
  }

  double estimate_norm(const UnknownLayout                              &layout,
                       std::vector<double>                              &x,
                       const double                                      enough,
                       const std::function<void(std::vector<double> &)> &apply)
  {
    // No pattern that a structure's modes could be orthogonal to.
    x.resize(layout.n_owned());
    for (unsigned int i = 0; i < x.size(); ++i)
      x[i] = (layout.global(i) * 2654435761u & 0x10000u) != 0 ? 1. : -1.;
    double norm = 0;
    for (unsigned int iteration = 0; iteration < 2; ++iteration)
      {
        const double size = length(layout, x);
        for (double &value : x)
          value /= size;
        apply(x);
        norm = length(layout, x);
        if (norm < enough)
          break;
      }
    return norm;
  }
} // namespace auxfem
