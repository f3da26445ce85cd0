#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace auxfem
{
  SparseMatrix::SparseMatrix(const UnknownLayout &layout)
    : layout(&layout)
    , first(layout.n_owned() + 1, 0)
  {}

  void SparseMatrix::multiply(const double *x, double *y) const
  {
    for (unsigned int row = 0; row < layout->n_owned(); ++row)
      {
        double sum = 0;
        for (std::size_t i = first[row]; i < first[row + 1]; ++i)
          sum += entries[i] * x[columns[i]];
        y[row] = sum;
      }
  }

  class SparseAssembly::BlockRows
  {
  public:
    struct BlockRow
    {
      std::size_t  block;
      unsigned int row;
    };

    BlockRows(const UnknownLayout            &layout,
              const std::vector<std::size_t> &first,
              const std::vector<int>         &unknowns)
      : first(first)
      , unknowns(unknowns)
      , begins(layout.n_owned() + 1, 0)
    {
      for (const int unknown : unknowns)
        if (layout.is_owned(unknown))
          ++begins[unknown + 1];
      std::partial_sum(begins.begin(), begins.end(), begins.begin());
      rows.resize(begins.back());
      std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
      for (std::size_t b = 0; b + 1 < first.size(); ++b)
        for (std::size_t i = first[b]; i < first[b + 1]; ++i)
          if (layout.is_owned(unknowns[i]))
            rows[next[unknowns[i]]++] = {b,
                                         static_cast<unsigned int>(i -
                                                                   first[b])};
    }

    /**
     * Calls action(block, row of the block) for all rows that contribute to @p
     * owned.
     */
    template <class Action>
    void for_each(const unsigned int owned, const Action &action) const
    {
      for (std::size_t i = begins[owned]; i < begins[owned + 1]; ++i)
        action(rows[i].block, rows[i].row);
    }

    /** Begin and end of the unknowns of a block. */
    ///@{
    const int *begin(const std::size_t block) const
    {
      return unknowns.data() + first[block];
    }

    const int *end(const std::size_t block) const
    {
      return unknowns.data() + first[block + 1];
    }
    ///@}

  private:
    const std::vector<std::size_t> &first;
    const std::vector<int>         &unknowns;
    std::vector<std::size_t>        begins;
    std::vector<BlockRow>           rows;
  };

  SparseAssembly::SparseAssembly(const UnknownLayout            &layout,
                                 const std::vector<std::size_t> &first,
                                 const std::vector<int>         &unknowns)
    : sum(layout)
    , begins(1, 0)
  {
    for (std::size_t b = 0; b + 1 < first.size(); ++b)
      {
        sizes.push_back(first[b + 1] - first[b]);
        begins.push_back(begins.back() +
                         std::size_t(sizes.back()) * sizes.back());
      }
    const BlockRows rows(layout, first, unknowns);
    make_pattern(rows);
    find_positions(rows);
  }

  void SparseAssembly::make_pattern(const BlockRows &rows)
  {
    const UnknownLayout &layout  = *sum.layout;
    const unsigned int   n_owned = layout.n_owned();
    std::vector<int>     last_row(layout.n_local(), -1);
    const auto for_each_column = [&](const int row, const auto &action) {
      last_row[row] = row;
      action(row);
      rows.for_each(row, [&](const std::size_t block, unsigned int) {
        for (const int *i = rows.begin(block); i != rows.end(block); ++i)
          if (*i >= 0 && last_row[*i] != row)
            {
              last_row[*i] = row;
              action(*i);
            }
      });
    };
    for (unsigned int row = 0; row < n_owned; ++row)
      {
        sum.first[row + 1] = sum.first[row];
        for_each_column(row, [&](int) { ++sum.first[row + 1]; });
      }
    const double n_largest = layout.largest(sum.first.back());
    if (n_largest > std::numeric_limits<int>::max())
      throw InputError(
        "The matrix of this lattice would have " +
        std::to_string(static_cast<long long>(n_largest)) +
        " entries on one MPI rank; at most " +
        std::to_string(std::numeric_limits<int>::max()) +
        " can be stored. Start auxfem on more ranks (mpirun -n ...), or take "
        "fewer cells.");

    sum.columns.reserve(sum.first.back());
    std::fill(last_row.begin(), last_row.end(), -1);
    for (unsigned int row = 0; row < n_owned; ++row)
      {
        for_each_column(row, [&](const int column) {
          sum.columns.push_back(column);
        });
        std::sort(sum.columns.begin() + sum.first[row], sum.columns.end());
      }
    sum.entries.assign(sum.first.back(), 0.);
  }

  void SparseAssembly::find_positions(const BlockRows &rows)
  {
    positions.assign(begins.back(), -1);
    std::vector<int> in_row(sum.layout->n_local(), -1);
    for (unsigned int row = 0; row < sum.layout->n_owned(); ++row)
      {
        for (std::size_t i = sum.first[row]; i < sum.first[row + 1]; ++i)
          in_row[sum.columns[i]] = i;
        diagonal_positions.push_back(in_row[row]);
        rows.for_each(row,
                      [&](const std::size_t  block,
                          const unsigned int row_of_block) {
                        int *position =
                          &positions[begins[block] +
                                     std::size_t(row_of_block) * sizes[block]];
                        for (const int *i = rows.begin(block);
                             i != rows.end(block);
                             ++i, ++position)
                          if (*i >= 0)
                            *position = in_row[*i];
                      });
      }
  }

  void SparseAssembly::reset(const Symmetry symmetry)
  {
    std::fill(sum.entries.begin(), sum.entries.end(), 0.);
    sum.is_symmetric  = symmetry != Symmetry::none;
    enforces_symmetry = symmetry == Symmetry::enforced;
  }

  void SparseAssembly::add(const std::size_t block, const double *values)
  {
    const int *const  position = positions.data() + begins[block];
    const std::size_t n        = sizes[block];
    if (!enforces_symmetry)
      {
        for (std::size_t i = 0; i < n * n; ++i)
          if (position[i] >= 0)
            sum.entries[position[i]] += values[i];
        return;
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (position[i * n + j] >= 0)
          sum.entries[position[i * n + j]] +=
            (values[i * n + j] + values[j * n + i]) / 2;
  }

  void SparseAssembly::add_to_diagonal(const unsigned int owned,
                                       const double       value)
  {
    sum.entries[diagonal_positions[owned]] += value;
  }

  double sum_of_squares(const double *values, const std::vector<int> &rows)
  {
    double sum = 0;
    for (const int row : rows)
      sum += values[row] * values[row];
    return sum;
  }

  double largest_size(const double *values, const std::vector<int> &rows)
  {
    double largest = 0;
    for (const int row : rows)
      largest = std::max(largest, std::abs(values[row]));
    return largest;
  }

  namespace
  {
    std::vector<bool> is_free(const Unknowns &unknowns)
    {
      std::vector<bool> free;
      for (const UnknownKind kind : unknowns.kinds)
        free.push_back(kind != UnknownKind::prescribed);
      return free;
    }

    SparseAssembly make_assembly(const TangentPattern   &pattern,
                                 const UnknownSelection &free)
    {
      std::vector<std::size_t> first(1, 0);
      std::vector<int>         unknowns;
      for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
        {
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            unknowns.push_back(*i < 0 ? -1 : free.number[*i]);
          first.push_back(unknowns.size());
        }
      return SparseAssembly(free.layout, first, unknowns);
    }
  } // namespace

  FreeBlock::FreeBlock(const TangentMatrix &matrix)
    : free(matrix.pattern().unknowns().layout,
           is_free(matrix.pattern().unknowns()))
    , assembly(make_assembly(matrix.pattern(), free))
    , version(matrix.version())
  {
    assemble(matrix);
  }

  void FreeBlock::assemble(const TangentMatrix &matrix)
  {
    Assert(matrix.version() == version,
           dealii::ExcMessage("The pattern of the matrix has changed."));
    assembly.reset(Symmetry::none);
    for (std::size_t b = 0; b < matrix.pattern().n_blocks(); ++b)
      assembly.add(b, matrix.values(b));
    if (!matrix.added_diagonal().empty())
      for (unsigned int i = 0; i < free.layout.n_owned(); ++i)
        assembly.add_to_diagonal(i, matrix.added_diagonal()[free.unknowns[i]]);
  }
} // namespace auxfem
