#ifndef auxfem_reduced_cell_cell_history_h
#define auxfem_reduced_cell_cell_history_h

#include <auxfem/output/energy_record.h>
#include <auxfem/reduced_cell/cell_scheme.h>

#include <vector>

namespace auxfem
{
  /** Columns of history.csv for the reduced cell: its CellSample and its
   * energies. */
  std::vector<Column> cell_columns();

  /** The numbers in these columns, @p energies those up to @p sample. */
  std::vector<double> cell_values(const CellSample   &sample,
                                  const EnergyRecord &energies);
} // namespace auxfem

#endif
