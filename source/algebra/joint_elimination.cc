#include <auxfem/algebra/dense_block.h>
#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace auxfem
{
  namespace
  {
    /**
     * Largest number of neighbours of eliminated joints. In the plane, 10
     * instead of 4 halves the rows at equal entries; in space, more than 4 cost
     * iterations.
     */
    unsigned int max_neighbours(const Unknowns &unknowns)
    {
      return unknowns.components.size() == 3 ? 10 : 4;
    }
  } // namespace

  JointElimination::JointElimination(const SparseMatrix &matrix,
                                     const Unknowns     &unknowns)
    : unknowns(unknowns)
    , groups(unknowns)
    , order(matrix, groups, unknowns, max_neighbours(unknowns))
    , joint_rows(make_rows())
    , reduced(joint_rows.layout())
    , first_exchange(1, 0)
  {
    for (unsigned int i = 0; i < unknowns.layout.n_local(); ++i)
      scale.push_back(unknowns.unit(i));
    for (const Pivot &pivot : order.pivots())
      first_exchange.push_back(first_exchange.back() + size(pivot.group));
    exchanges.resize(first_exchange.back());
    make_pattern(matrix);
  }

  unsigned int JointElimination::size(const unsigned int group) const
  {
    return groups.rows[group].size();
  }

  bool JointElimination::factorize(const SparseMatrix &matrix)
  {
    stiffness             = find_largest_stiffness(matrix);
    const bool has_failed = !eliminate(matrix);
    if (unknowns.layout.largest(has_failed ? 1. : 0.) > 0)
      return false;
    fill_matrix(matrix);
    return true;
  }

  double
  JointElimination::find_largest_stiffness(const SparseMatrix &matrix) const
  {
    const auto is_free = [this](const int i) {
      return unknowns.kinds[i] != UnknownKind::prescribed;
    };
    double largest = 0;
    for (unsigned int row = 0; row < unknowns.layout.n_owned(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        if (const int column = matrix.columns[i];
            is_free(row) && is_free(column))
          largest =
            std::max(largest,
                     std::abs(matrix.entries[i]) * scale[row] * scale[column]);
    return unknowns.layout.largest(largest);
  }

  bool JointElimination::eliminate(const SparseMatrix &matrix)
  {
    fill_blocks(matrix);
    negative = 0;
    is_definite.assign(order.pivots().size(), false);
    for (std::size_t p = 0; p < order.pivots().size(); ++p)
      {
        if (!factorize_pivot(p, matrix.is_symmetric))
          return false;
        update_neighbours(p);
      }
    return true;
  }

  void JointElimination::fill_blocks(const SparseMatrix &matrix)
  {
    blocks.assign(order.n_entries(), 0.);
    largest_in_row.assign(unknowns.layout.n_owned(), 0.);
    for (unsigned int row = 0; row < unknowns.layout.n_owned(); ++row)
      if (groups.group[row])
        fill_row(matrix, row);
  }

  void JointElimination::fill_row(const SparseMatrix &matrix,
                                  const unsigned int  row)
  {
    const unsigned int group = *groups.group[row];
    // Columns of a group are usually adjacent: its block is looked up once.
    std::optional<unsigned int> last;
    double                     *row_block = nullptr;
    for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
      {
        const int column = matrix.columns[i];
        if (!unknowns.layout.is_owned(column) || !groups.group[column])
          continue;
        if (const unsigned int other = *groups.group[column]; other != last)
          {
            last      = other;
            row_block = &blocks[order.initial_block(group, other)] +
              groups.number[row] * size(other);
          }
        const double entry = matrix.entries[i] * scale[row] * scale[column];
        row_block[groups.number[column]] = entry;
        largest_in_row[row] = std::max(largest_in_row[row], std::abs(entry));
      }
  }

  bool JointElimination::factorize_pivot(const std::size_t number,
                                         const bool        is_symmetric)
  {
    const Pivot       &pivot   = order.pivots()[number];
    const unsigned int n       = size(pivot.group);
    double            *block   = &blocks[pivot.block];
    double             largest = 0;
    for (const int row : groups.rows[pivot.group])
      largest = std::max(largest, largest_in_row[row]);
    room.assign(block, block + n * n);
    if (is_symmetric &&
        factorize_definite_block(block, n, few_round_offs * largest))
      return is_definite[number] = true;
    std::copy(room.begin(), room.end(), block);
    if (!factorize_general_block(block,
                                 n,
                                 &exchanges[first_exchange[number]],
                                 few_round_offs * largest))
      return false;
    if (is_symmetric)
      negative += n_negative_eigenvalues(room.data(), n);
    return true;
  }

  void JointElimination::update_neighbours(const std::size_t number)
  {
    const Pivot       &pivot = order.pivots()[number];
    const unsigned int n     = size(pivot.group);
    for (const JointOrder::Link &link : pivot.right)
      solve_with_block(&blocks[pivot.block],
                       exchanges_of(number),
                       n,
                       &blocks[link.block],
                       size(link.group));
    auto target = pivot.between.begin();
    for (const JointOrder::Link &row : pivot.left)
      for (const JointOrder::Link &column : pivot.right)
        subtract_product(&blocks[*target++],
                         &blocks[row.block],
                         &blocks[column.block],
                         size(row.group),
                         n,
                         size(column.group));
  }

  JointRows JointElimination::make_rows() const
  {
    std::vector<int> selected;
    for (const unsigned int group : order.remaining())
      selected.insert(selected.end(),
                      groups.rows[group].begin(),
                      groups.rows[group].end());
    return JointRows(unknowns, selected);
  }

  void JointElimination::make_pattern(const SparseMatrix &matrix)
  {
    const std::size_t n_entries = count_reduced_entries(matrix);
    reduced.columns.reserve(n_entries);
    sources.reserve(n_entries);
    std::vector<Source> row_of_sources;
    for (unsigned int row = 0; row < joint_rows.layout().n_owned(); ++row)
      {
        if (const auto unknown = joint_rows.unknown(row))
          find_sources(matrix, *unknown, row_of_sources);
        else
          row_of_sources.assign(1, {row, 0});
        for (const Source &source : row_of_sources)
          {
            reduced.columns.push_back(source.column);
            sources.push_back(source.position);
          }
        reduced.first[row + 1] = reduced.columns.size();
      }
    reduced.entries.resize(reduced.columns.size());
  }

  std::size_t
  JointElimination::count_reduced_entries(const SparseMatrix &matrix) const
  {
    // Unused rows have one entry.
    std::size_t sum = joint_rows.layout().n_owned();
    for (const unsigned int group : order.remaining())
      {
        std::size_t n_columns = 0;
        for (const JointOrder::Link &link : order.links(group))
          n_columns += size(link.group);
        sum += n_columns * size(group);
        for (const int row : groups.rows[group])
          sum += std::count_if(matrix.columns.begin() + matrix.first[row],
                               matrix.columns.begin() + matrix.first[row + 1],
                               [this](const int column) {
                                 return !unknowns.layout.is_owned(column);
                               });
      }
    return sum;
  }

  void JointElimination::find_sources(const SparseMatrix  &matrix,
                                      const unsigned int   unknown,
                                      std::vector<Source> &row) const
  {
    row.clear();
    for (const JointOrder::Link &link : order.links(*groups.group[unknown]))
      {
        std::size_t position =
          link.block + groups.number[unknown] * size(link.group);
        for (const int other : groups.rows[link.group])
          row.push_back({*joint_rows.row(other), position++});
      }
    for (std::size_t i = matrix.first[unknown]; i < matrix.first[unknown + 1];
         ++i)
      if (const int column = matrix.columns[i];
          !unknowns.layout.is_owned(column) && joint_rows.row(column))
        row.push_back({*joint_rows.row(column), i});
    sort_by_column(row);
  }

  void JointElimination::fill_matrix(const SparseMatrix &matrix)
  {
    reduced.is_symmetric = matrix.is_symmetric;
    for (unsigned int row = 0; row < joint_rows.layout().n_owned(); ++row)
      {
        const auto unknown = joint_rows.unknown(row);
        for (std::size_t i = reduced.first[row]; i < reduced.first[row + 1];
             ++i)
          if (!unknown)
            reduced.entries[i] = stiffness;
          else if (joint_rows.layout().is_owned(reduced.columns[i]))
            reduced.entries[i] = blocks[sources[i]];
          else
            reduced.entries[i] = matrix.entries[sources[i]] * scale[*unknown] *
              scale[matrix.columns[sources[i]]];
      }
  }

  void JointElimination::reduce(const double *b, double *g)
  {
    values.resize(unknowns.layout.n_owned());
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] = groups.group[i] ? b[i] * scale[i] : b[i];
    for (std::size_t p = 0; p < order.pivots().size(); ++p)
      {
        const Pivot            &pivot = order.pivots()[p];
        const std::vector<int> &own   = groups.rows[pivot.group];
        room.resize(own.size());
        for (unsigned int i = 0; i < own.size(); ++i)
          room[i] = values[own[i]];
        solve_with_block(&blocks[pivot.block],
                         exchanges_of(p),
                         own.size(),
                         room.data(),
                         1);
        for (unsigned int i = 0; i < own.size(); ++i)
          values[own[i]] = room[i];
        for (const JointOrder::Link &link : pivot.left)
          {
            const double *entry = &blocks[link.block];
            for (const int row : groups.rows[link.group])
              for (const double value : room)
                values[row] -= *entry++ * value;
          }
      }
    for (unsigned int row = 0; row < joint_rows.layout().n_owned(); ++row)
      {
        const auto unknown = joint_rows.unknown(row);
        g[row]             = unknown ? values[*unknown] : 0.;
      }
  }

  void JointElimination::expand(const double *z, double *x)
  {
    for (unsigned int row = 0; row < joint_rows.layout().n_owned(); ++row)
      if (const auto unknown = joint_rows.unknown(row))
        values[*unknown] = z[row];
    for (std::size_t p = order.pivots().size(); p-- > 0;)
      {
        const Pivot &pivot = order.pivots()[p];
        for (const JointOrder::Link &link : pivot.right)
          {
            const double *entry = &blocks[link.block];
            for (const int row : groups.rows[pivot.group])
              for (const int other : groups.rows[link.group])
                values[row] -= *entry++ * values[other];
          }
      }
    for (unsigned int i = 0; i < values.size(); ++i)
      x[i] = groups.group[i] ? values[i] * scale[i] : values[i];
  }

  std::size_t JointElimination::memory() const
  {
    std::size_t sum = blocks.capacity() * sizeof(double) +
      exchanges.capacity() * sizeof(int) +
      sources.capacity() * sizeof(std::size_t);
    return sum + order.memory() + reduced.entries.capacity() * sizeof(double) +
      reduced.columns.capacity() * sizeof(int);
  }
} // namespace auxfem
