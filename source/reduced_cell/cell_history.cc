#include <auxfem/reduced_cell/cell_history.h>

namespace auxfem
{
  std::vector<Column> cell_columns()
  {
    std::vector<Column> columns = {
      {"time", "s", "time"},
      {"theta", "rad", "angle of the bars against the horizontal"},
      {"Y1", "m", "rise of the upper part, extension of the connector"},
      {"Y2", "m", "rise of the lower part"},
      {"f1", "N", "load on the upper part, positive downwards"},
      {"f2", "N", "force on the foundation, positive in compression"}};
    for (const Column &column : energy_columns(cell_energies().ledger()))
      columns.push_back(column);
    return columns;
  }



  std::vector<double> cell_values(const CellSample   &sample,
                                  const EnergyRecord &energies)
  {
    std::vector<double> row = {sample.time,
                               sample.angle,
                               sample.upper_rise,
                               sample.lower_rise,
                               sample.load,
                               sample.transmitted};
    for (const double energy : energy_values(energies))
      row.push_back(energy);
    return row;
  }
} // namespace auxfem
