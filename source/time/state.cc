#include <auxfem/time/state.h>

namespace auxfem
{
  State::State(const Epetra_BlockMap &unknowns, const StateLayout &layout)
    : displacement(unknowns)
    , residual(unknowns)
    , rotations(layout.n_rotations)
    , history(layout.history.n_values(), 0.)
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
