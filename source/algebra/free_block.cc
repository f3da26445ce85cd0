#include <auxfem/algebra/free_block.h>

namespace auxfem
{
  std::unique_ptr<Epetra_CrsMatrix> free_block(const TangentMatrix &matrix,
                                               const DofNumbering  &numbering)
  {
    const auto is_free = [&numbering](const int local) {
      return numbering.kind(local) != UnknownKind::prescribed;
    };
    std::vector<int> free_rows;
    for (unsigned int row = 0; row < numbering.n_owned(); ++row)
      if (is_free(row))
        free_rows.push_back(numbering.owned_map().GID(row));
    const Epetra_Map map(-1,
                         free_rows.size(),
                         free_rows.data(),
                         0,
                         numbering.communicator());

    auto             block = std::make_unique<Epetra_CrsMatrix>(Copy, map, 0);
    std::vector<int> columns;
    std::vector<double> values;
    for (unsigned int row = 0; row < numbering.n_owned(); ++row)
      {
        if (!is_free(row))
          continue;
        int     n          = 0;
        int    *of_row     = nullptr;
        double *row_values = nullptr;
        matrix.matrix().ExtractMyRowView(row, n, row_values, of_row);
        columns.clear();
        values.clear();
        for (int i = 0; i < n; ++i)
          // Columns of the matrix are numbered as local unknowns.
          if (is_free(of_row[i]))
            {
              columns.push_back(numbering.local_map().GID(of_row[i]));
              values.push_back(row_values[i]);
            }
        block->InsertGlobalValues(numbering.owned_map().GID(row),
                                  columns.size(),
                                  values.data(),
                                  columns.data());
      }
    block->FillComplete();
    return block;
  }
} // namespace auxfem
