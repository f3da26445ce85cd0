#include <auxfem/system/tangent_matrix.h>

#include <deal.II/base/exceptions.h>

#include <Epetra_CrsGraph.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <cmath>

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
    const int n_owned = numbering.n_owned();

    std::vector<std::vector<int>> columns(n_owned);
    for (int row = 0; row < n_owned; ++row)
      columns[row].push_back(row);
    const auto for_each_block = [this](const auto &action) {
      for (std::size_t b = 0; b + 1 < unknowns_begin.size(); ++b)
        action(block_unknowns.data() + unknowns_begin[b],
               block_unknowns.data() + unknowns_begin[b + 1]);
    };
    for_each_block([&](const int *begin, const int *end) {
      for (const int *row = begin; row != end; ++row)
        if (*row >= 0 && *row < n_owned)
          for (const int *column = begin; column != end; ++column)
            if (*column >= 0)
              columns[*row].push_back(*column);
    });
    std::vector<int> row_lengths(n_owned);
    for (int row = 0; row < n_owned; ++row)
      {
        auto &list = columns[row];
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        row_lengths[row] = list.size();
      }

    Epetra_CrsGraph graph(Copy,
                          numbering.owned_map(),
                          numbering.local_map(),
                          row_lengths.data(),
                          /*StaticProfile=*/true);
    for (int row = 0; row < n_owned; ++row)
      graph.InsertMyIndices(row, row_lengths[row], columns[row].data());
    graph.FillComplete(numbering.owned_map(), numbering.owned_map());
    graph.OptimizeStorage();
    crs = std::make_unique<Epetra_CrsMatrix>(Copy, graph);
    crs->FillComplete(numbering.owned_map(), numbering.owned_map());
    crs->OptimizeStorage();

    int      *offsets = nullptr, *indices = nullptr;
    const int error = crs->ExtractCrsDataPointers(offsets, indices, entries);
    AssertThrow(error == 0,
                dealii::ExcMessage("Epetra storage is not contiguous."));
    n_entries           = n_owned > 0 ? offsets[n_owned] : 0;
    const auto position = [&](const int row, const int column) -> int {
      if (row < 0 || row >= n_owned || column < 0 ||
          numbering.kind(row) == UnknownKind::prescribed)
        return -1;
      return std::lower_bound(indices + offsets[row],
                              indices + offsets[row + 1],
                              column) -
        indices;
    };
    positions.reserve(block_begin.back());
    for_each_block([&](const int *begin, const int *end) {
      for (const int *row = begin; row != end; ++row)
        for (const int *column = begin; column != end; ++column)
          positions.push_back(position(*row, *column));
    });
    for (int row = 0; row < n_owned; ++row)
      if (numbering.kind(row) == UnknownKind::prescribed)
        identity_positions.push_back(
          std::lower_bound(indices + offsets[row],
                           indices + offsets[row + 1],
                           row) -
          indices);
    block_unknowns = {};
    unknowns_begin = {};
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
