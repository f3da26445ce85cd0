#include <auxfem/parameters/errors.h>
#include <auxfem/system/tangent_matrix.h>

#include <deal.II/base/exceptions.h>

#include <Epetra_CrsGraph.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace auxfem
{
  TangentMatrix::TangentMatrix(const DofNumbering &numbering)
    : numbering(numbering)
    , unknowns_begin(1, 0)
    , block_begin(1, 0)
  {
    const unsigned int n = (numbering.order() + 1) * numbering.n_components();
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      register_block(numbering.element_unknowns(e), n);
  }

  std::size_t TangentMatrix::register_block(const int         *unknowns,
                                            const unsigned int n)
  {
    Assert(!crs, dealii::ExcMessage("The pattern is already made."));
    block_unknowns.insert(block_unknowns.end(), unknowns, unknowns + n);
    unknowns_begin.push_back(block_unknowns.size());
    block_begin.push_back(block_begin.back() + std::size_t(n) * n);
    return block_begin.size() - 2;
  }

  void TangentMatrix::finalize()
  {
    const BlockRows blocks(*this);
    make_matrix(blocks);
    find_positions(blocks);
    block_unknowns = {};
    unknowns_begin = {};
  }

  TangentMatrix::BlockRows::BlockRows(const TangentMatrix &matrix)
    : begins(matrix.numbering.n_owned() + 1, 0)
  {
    const auto for_each_owned = [&](const auto &action) {
      const int n_owned = matrix.numbering.n_owned();
      for (std::size_t b = 0; b + 1 < matrix.unknowns_begin.size(); ++b)
        for (std::size_t i = matrix.unknowns_begin[b];
             i < matrix.unknowns_begin[b + 1];
             ++i)
          if (const int unknown = matrix.block_unknowns[i];
              unknown >= 0 && unknown < n_owned)
            action(unknown, b, i - matrix.unknowns_begin[b]);
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
    const int        n_owned = numbering.n_owned();
    std::vector<int> last_row(numbering.n_local(), -1), columns;
    const auto       collect_columns = [&](const int row) {
      columns.assign(1, row);
      last_row[row] = row;
      for (const BlockRow *in = blocks.begin(row); in != blocks.end(row); ++in)
        for (std::size_t i = unknowns_begin[in->block];
             i < unknowns_begin[in->block + 1];
             ++i)
          if (const int column = block_unknowns[i];
              column >= 0 && last_row[column] != row)
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
    const int n_owned = numbering.n_owned();
    int      *offsets = nullptr, *indices = nullptr;
    const int error = crs->ExtractCrsDataPointers(offsets, indices, entries);
    AssertThrow(error == 0,
                dealii::ExcMessage("Epetra storage is not contiguous."));
    n_entries = n_owned > 0 ? offsets[n_owned] : 0;

    positions.assign(block_begin.back(), -1);
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
            const std::size_t begin = unknowns_begin[in->block],
                              n     = unknowns_begin[in->block + 1] - begin;
            int *place = &positions[block_begin[in->block] + in->row * n];
            for (std::size_t i = begin; i < begin + n; ++i, ++place)
              if (block_unknowns[i] >= 0)
                *place = in_row[block_unknowns[i]];
          }
      }
  }

  void TangentMatrix::reset()
  {
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
