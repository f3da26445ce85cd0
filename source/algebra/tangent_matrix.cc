#include <auxfem/algebra/tangent_matrix.h>

#include <deal.II/base/exceptions.h>

#include <Epetra_CrsGraph.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <cmath>

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
    build_matrix();
    find_positions();
    built_version = pattern.version();
  }

  void TangentMatrix::build_matrix()
  {
    const DofNumbering &numbering = pattern.numbering();
    const int           n_owned   = numbering.n_owned();

    std::vector<std::vector<int>> columns(n_owned);
    for (int row = 0; row < n_owned; ++row)
      columns[row].push_back(row);
    for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
      for (const int *row = pattern.begin(b); row != pattern.end(b); ++row)
        if (*row >= 0 && *row < n_owned)
          for (const int *column = pattern.begin(b); column != pattern.end(b);
               ++column)
            if (*column >= 0)
              columns[*row].push_back(*column);
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
  }

  void TangentMatrix::find_positions()
  {
    const DofNumbering &numbering = pattern.numbering();
    const int           n_owned   = numbering.n_owned();

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
    positions.clear();
    block_begin.assign(1, 0);
    for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
      {
        for (const int *row = pattern.begin(b); row != pattern.end(b); ++row)
          for (const int *column = pattern.begin(b); column != pattern.end(b);
               ++column)
            positions.push_back(position(*row, *column));
        block_begin.push_back(positions.size());
      }
    identity_positions.clear();
    for (int row = 0; row < n_owned; ++row)
      if (numbering.kind(row) == UnknownKind::prescribed)
        identity_positions.push_back(
          std::lower_bound(indices + offsets[row],
                           indices + offsets[row + 1],
                           row) -
          indices);
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
