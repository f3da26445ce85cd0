#include <auxfem/state/state.h>

namespace auxfem
{
  State::State(const unsigned int n_unknowns, const StateLayout &layout)
    : displacement(n_unknowns, 0.)
    , residual(n_unknowns, 0.)
    , rotations(layout.n_rotations)
    , has_mean_work(layout.mean_work)
    , plane_rotations(
        std::make_shared<const std::vector<int>>(layout.plane_rotations))
    , space_rotations(std::make_shared<const std::vector<std::array<int, 3>>>(
        layout.space_rotations))
    , history(layout.history.n_values(), 0.)
    , energies(std::make_shared<const EnergyLedger>(layout.energies))
    , energy_sums(energies.amounts())
    , largest_forces(n_unknowns, 0.)
  {
    if (layout.path)
      path.emplace();
    if (layout.velocity)
      velocity.emplace(n_unknowns, 0.);
    if (layout.acceleration)
      acceleration.emplace(n_unknowns, 0.);
    if (layout.algorithmic_acceleration)
      algorithmic_acceleration.emplace(n_unknowns, 0.);
    if (layout.compensation)
      compensation.emplace(n_unknowns, 0.);
  }

  void State::extend_ghosts(const UnknownLayout &layout)
  {
    const auto take = [&layout](Vector &values) {
      values.resize(layout.n_local(), 0.);
      layout.update_ghosts(values.data());
    };
    take(displacement);
    if (before)
      {
        take(before->displacement);
        before->residual.resize(layout.n_local(), 0.);
      }
    residual.resize(layout.n_local(), 0.);
    largest_forces.resize(layout.n_local(), 0.);
    for (std::optional<Vector> *values : {&velocity,
                                          &acceleration,
                                          &algorithmic_acceleration,
                                          &compensation,
                                          &is_massless})
      if (*values)
        take(**values);
  }
} // namespace auxfem
