#include <auxfem/algebra/direct_solver.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>

#include <cholmod.h>

namespace auxfem
{
  namespace
  {
    /** Life of CHOLMOD's settings. */
    struct Session
    {
      Session()
      {
        cholmod_start(&common);
        common.print = 0;
      }
      ~Session()
      {
        cholmod_finish(&common);
      }
      Session(const Session &)            = delete;
      Session &operator=(const Session &) = delete;

      cholmod_common common;
    };
  } // namespace

  bool fits_narrow_offsets(const SparseMatrix &matrix)
  {
    return matrix.columns.size() <=
      static_cast<std::size_t>(std::numeric_limits<int>::max());
  }

  std::vector<int> narrow_offsets(const SparseMatrix &matrix)
  {
    return std::vector<int>(matrix.first.begin(), matrix.first.end());
  }

  std::vector<int> elimination_order(const SparseMatrix    &matrix,
                                     const EliminationOrder kind)
  {
    std::vector<int> offsets = narrow_offsets(matrix);
    std::vector<int> columns = matrix.columns;
    std::vector<int> order(matrix.layout->n_owned());
    if (order.empty())
      return order;

    cholmod_sparse pattern = {};
    pattern.nrow = pattern.ncol = order.size();
    pattern.nzmax               = columns.size();
    pattern.p                   = offsets.data();
    pattern.i                   = columns.data();
    pattern.stype               = 1;
    pattern.itype               = CHOLMOD_INT;
    pattern.xtype               = CHOLMOD_PATTERN;
    pattern.dtype               = CHOLMOD_DOUBLE;
    pattern.sorted              = 1;
    pattern.packed              = 1;

    Session    session;
    const bool is_done = kind == EliminationOrder::nested_dissection
      ? cholmod_metis(&pattern, nullptr, 0, 1, order.data(), &session.common)
      : cholmod_amd(&pattern, nullptr, 0, order.data(), &session.common);
    if (!is_done)
      throw std::bad_alloc();
    return order;
  }

  namespace
  {
    /**
     * Largest |x| of motions or multipliers over all ranks, in the unit of each
     * local unknown.
     */
    std::vector<double> largest_by_unit(const Unknowns            &unknowns,
                                        const std::vector<double> &x)
    {
      const auto is_multiplier = [&unknowns](const unsigned int i) {
        return unknowns.kinds[i] == UnknownKind::multiplier;
      };
      double motion = 0, force = 0;
      for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
        if (is_multiplier(i))
          force = std::max(force, std::abs(x[i]));
        else
          motion = std::max(motion, std::abs(x[i]) / unknowns.unit(i));
      motion = unknowns.layout.largest(motion);
      force  = unknowns.layout.largest(force);
      std::vector<double> result(unknowns.layout.n_local());
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] = is_multiplier(i) ? force : motion * unknowns.unit(i);
      return result;
    }
  } // namespace

  double backward_error(const TangentMatrix       &matrix,
                        const std::vector<double> &x,
                        const std::vector<double> &b,
                        const Symmetry             symmetry)
  {
    const TangentPattern     &pattern = matrix.pattern();
    const UnknownLayout      &layout  = pattern.unknowns().layout;
    std::vector<double>       image(layout.n_owned()), sizes(layout.n_owned());
    const std::vector<double> largest_x =
      largest_by_unit(pattern.unknowns(), x);
    matrix.multiply(x.data(), image.data(), symmetry);
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      {
        const int *const    block_unknowns = pattern.begin(block);
        const unsigned int  n              = pattern.size(block);
        const double *const values         = matrix.values(block);
        for (unsigned int i = 0; i < n; ++i)
          if (layout.is_owned(block_unknowns[i]))
            for (unsigned int j = 0; j < n; ++j)
              if (block_unknowns[j] >= 0)
                sizes[block_unknowns[i]] +=
                  std::abs(values[i * n + j]) * largest_x[block_unknowns[j]];
      }
    double largest = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      {
        double size = sizes[i] + std::abs(b[i]);
        if (pattern.unknowns().kinds[i] == UnknownKind::prescribed)
          size = std::abs(x[i]) + std::abs(b[i]);
        else if (!matrix.added_diagonal().empty())
          size += std::abs(matrix.added_diagonal()[i]) * largest_x[i];
        const double difference = std::abs(image[i] - b[i]);
        if (difference == 0)
          continue;
        const double error = difference / (size + smallest_full_precision);
        if (!std::isfinite(error))
          largest = std::numeric_limits<double>::infinity();
        largest = std::max(largest, error);
      }
    return layout.largest(largest);
  }

  namespace
  {
    double length(const UnknownLayout &layout, const std::vector<double> &x)
    {
      return std::sqrt(
        layout.sum(std::inner_product(x.begin(), x.end(), x.begin(), 0.)));
    }

    /** Largest |a_ij| s_j of a row. */
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

    /**
     * Scales by 1/sqrt(a_ii), or for a zero diagonal by the largest scaled
     * entry of the row.
     */
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
    // Zero times a non-finite number is NaN; one branch at the end lets the
    // compiler vectorize.
    double sum = 0;
    for (const double entry : matrix.entries)
      sum += 0. * entry;
    return sum == 0.;
  }

  FactorizationOutcome gravest_outcome(const FactorizationOutcome mine,
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
    // Each step replaces the excess by its square root.
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

  double estimate_norm(const UnknownLayout &layout,
                       std::vector<double> &x,
                       const double         threshold,
                       const std::function<void(std::vector<double> &)> &apply)
  {
    // The irregular signs are not orthogonal to a structure's modes.
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
        if (norm < threshold)
          break;
      }
    return norm;
  }
} // namespace auxfem
