#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <Epetra_CrsGraph.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace auxfem
{
  TangentPattern::TangentPattern(const DofNumbering &numbering)
    : dofs(numbering)
  {
    clear();
  }

  void TangentPattern::clear()
  {
    unknowns.clear();
    first.assign(1, 0);
    const unsigned int n = (dofs.order() + 1) * dofs.n_components();
    for (unsigned int e = 0; e < dofs.elements().size(); ++e)
      register_block(dofs.element_unknowns(e), n);
    ++changes;
  }

  std::size_t TangentPattern::register_block(const int         *of_block,
                                             const unsigned int n)
  {
    unknowns.insert(unknowns.end(), of_block, of_block + n);
    first.push_back(unknowns.size());
    ++changes;
    return n_blocks() - 1;
  }

  unsigned long TangentPattern::version() const
  {
    return changes;
  }

  const DofNumbering &TangentPattern::numbering() const
  {
    return dofs;
  }

  std::size_t TangentPattern::n_blocks() const
  {
    return first.size() - 1;
  }

  const int *TangentPattern::begin(const std::size_t block) const
  {
    return unknowns.data() + first[block];
  }

  const int *TangentPattern::end(const std::size_t block) const
  {
    return unknowns.data() + first[block + 1];
  }

  TangentMatrix::TangentMatrix(const TangentPattern &pattern) : pattern(pattern)
  {
    rebuild();
  }

  void TangentMatrix::rebuild()
  {
    const BlockRows blocks(pattern);
    make_matrix(blocks);
    find_positions(blocks);
    built_version = pattern.version();
  }

  TangentMatrix::BlockRows::BlockRows(const TangentPattern &pattern)
    : begins(pattern.numbering().n_owned() + 1, 0)
  {
    const auto for_each_owned = [&](const auto &action) {
      const int n_owned = pattern.numbering().n_owned();
      for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
        for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
          if (*i >= 0 && *i < n_owned)
            action(*i, b, i - pattern.begin(b));
    };
    for_each_owned([this](const int unknown, std::size_t, std::size_t) {
      ++begins[unknown + 1];
    });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    rows.resize(begins.back());
    std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
    for_each_owned(
      [&](const int unknown, const std::size_t b, const std::size_t row) {
        rows[next[unknown]++] = {static_cast<unsigned int>(b),
                                 static_cast<unsigned int>(row)};
      });
  }

  void TangentMatrix::make_matrix(const BlockRows &blocks)
  {
    const DofNumbering &numbering = pattern.numbering();
    const int           n_owned   = numbering.n_owned();
    std::vector<int>    last_row(numbering.n_local(), -1), columns;
    const auto          collect_columns = [&](const int row) {
      columns.assign(1, row);
      last_row[row] = row;
      for (const BlockRow *in = blocks.begin(row); in != blocks.end(row); ++in)
        for (const int *i = pattern.begin(in->block);
             i != pattern.end(in->block);
             ++i)
          if (const int column = *i; column >= 0 && last_row[column] != row)
            {
              columns.push_back(column);
              last_row[column] = row;
            }
    };
    std::vector<int> row_lengths(n_owned);
    long long        n_needed = 0, n_largest = 0;
    for (int row = 0; row < n_owned; ++row)
      {
        collect_columns(row);
        row_lengths[row] = columns.size();
        n_needed += columns.size();
      }
    numbering.communicator().MaxAll(&n_needed, &n_largest, 1);
    if (n_largest > std::numeric_limits<int>::max())
      throw InputError(
        "The matrix of this lattice would have " + std::to_string(n_largest) +
        " entries on one MPI rank; at most " +
        std::to_string(std::numeric_limits<int>::max()) +
        " can be stored. Start auxfem on more ranks (mpirun -n ...), or take "
        "fewer cells, fewer Refinements or a lower Order.");

    Epetra_CrsGraph graph(Copy,
                          numbering.owned_map(),
                          numbering.local_map(),
                          row_lengths.data(),
                          /*StaticProfile=*/true);
    std::fill(last_row.begin(), last_row.end(), -1);
    for (int row = 0; row < n_owned; ++row)
      {
        collect_columns(row);
        std::sort(columns.begin(), columns.end());
        graph.InsertMyIndices(row, columns.size(), columns.data());
      }
    graph.FillComplete(numbering.owned_map(), numbering.owned_map());
    graph.OptimizeStorage();
    crs = std::make_unique<Epetra_CrsMatrix>(Copy, graph);
    crs->FillComplete(numbering.owned_map(), numbering.owned_map());
    crs->OptimizeStorage();
  }

  void TangentMatrix::find_positions(const BlockRows &blocks)
  {
    const DofNumbering &numbering = pattern.numbering();
    const int           n_owned   = numbering.n_owned();
    int                *offsets = nullptr, *indices = nullptr;
    const int error = crs->ExtractCrsDataPointers(offsets, indices, entries);
    AssertThrow(error == 0,
                dealii::ExcMessage("Epetra storage is not contiguous."));
    n_entries = n_owned > 0 ? offsets[n_owned] : 0;

    block_begin.assign(1, 0);
    for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
      {
        const std::size_t n = pattern.end(b) - pattern.begin(b);
        block_begin.push_back(block_begin.back() + n * n);
      }
    positions.assign(block_begin.back(), -1);
    identity_positions.clear();
    std::vector<int> in_row(numbering.n_local(), -1);
    for (int row = 0; row < n_owned; ++row)
      {
        for (int i = offsets[row]; i < offsets[row + 1]; ++i)
          in_row[indices[i]] = i;
        if (numbering.kind(row) == UnknownKind::prescribed)
          {
            identity_positions.push_back(in_row[row]);
            continue;
          }
        for (const BlockRow *in = blocks.begin(row); in != blocks.end(row);
             ++in)
          {
            const int *const        begin = pattern.begin(in->block),
                             *const end   = pattern.end(in->block);
            int                    *place = &positions[block_begin[in->block] +
                                    in->row * std::size_t(end - begin)];
            for (const int *i = begin; i != end; ++i, ++place)
              if (*i >= 0)
                *place = in_row[*i];
          }
      }
  }

  void TangentMatrix::reset()
  {
    if (built_version != pattern.version())
      rebuild();
    std::fill(entries, entries + n_entries, 0.);
    for (const int position : identity_positions)
      entries[position] = 1.;
  }

  const Epetra_CrsMatrix &TangentMatrix::matrix() const
  {
    return *crs;
  }

  Epetra_CrsMatrix &TangentMatrix::matrix()
  {
    return *crs;
  }

  unsigned long TangentMatrix::version() const
  {
    return built_version;
  }

  std::vector<double> TangentMatrix::row_sizes() const
  {
    std::vector<double> sizes(crs->NumMyRows(), 0.);
    for (int row = 0; row < crs->NumMyRows(); ++row)
      {
        int     n      = 0;
        double *values = nullptr;
        crs->ExtractMyRowView(row, n, values);
        for (int i = 0; i < n; ++i)
          sizes[row] = std::max(sizes[row], std::abs(values[i]));
      }
    return sizes;
  }
} // namespace auxfem
