#include <auxfem/time/state.h>

namespace auxfem
{
  State::State(const Epetra_BlockMap &unknowns, const StateLayout &layout)
    : displacement(unknowns)
    , residual(unknowns)
    , rotations(layout.n_rotations)
    , history(layout.n_history, 0.)
    , dissipated(layout.n_dissipated, 0.)
  {
    if (layout.velocity)
      velocity.emplace(unknowns);
    if (layout.acceleration)
      acceleration.emplace(unknowns);
    if (layout.algorithmic_acceleration)
      algorithmic_acceleration.emplace(unknowns);
  }
} // namespace auxfem
