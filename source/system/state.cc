#include <auxfem/system/state.h>

namespace auxfem
{
  State::State(const DofNumbering &numbering, const StateLayout &layout)
    : displacement(numbering.local_map())
    , residual(numbering.local_map())
    , history(layout.n_history, 0.)
    , dissipated(layout.n_dissipated, 0.)
  {
    if (layout.velocity)
      velocity.emplace(numbering.local_map());
    if (layout.acceleration)
      acceleration.emplace(numbering.local_map());
    if (layout.algorithmic_acceleration)
      algorithmic_acceleration.emplace(numbering.local_map());
  }
} // namespace auxfem
