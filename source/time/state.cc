#include <auxfem/time/state.h>

namespace auxfem
{
  std::size_t StateLayout::keep(const std::string               &name,
                                const std::vector<unsigned int> &items,
                                const unsigned int values_per_item)
  {
    const std::size_t first = n_history();
    records.push_back({name, items, values_per_item, first});
    return first;
  }

  const std::vector<HistoryRecord> &StateLayout::history() const
  {
    return records;
  }

  std::size_t StateLayout::n_history() const
  {
    return records.empty() ? 0
                           : records.back().first +
        records.back().items.size() * records.back().values_per_item;
  }

  State::State(const Epetra_BlockMap &unknowns, const StateLayout &layout)
    : displacement(unknowns)
    , residual(unknowns)
    , rotations(layout.n_rotations)
    , plane_rotations(
        std::make_shared<const std::vector<int>>(layout.plane_rotations))
    , history(layout.n_history(), 0.)
    , energies(std::make_shared<const EnergyLedger>(layout.energies))
    , energy_sums(energies.amounts())
    , powers(energies.amounts())
  {
    if (layout.velocity)
      velocity.emplace(unknowns);
    if (layout.acceleration)
      acceleration.emplace(unknowns);
    if (layout.algorithmic_acceleration)
      algorithmic_acceleration.emplace(unknowns);
  }
} // namespace auxfem
