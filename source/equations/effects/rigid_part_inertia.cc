#include <auxfem/equations/effects/rigid_part_inertia.h>

namespace auxfem
{
  RigidPartInertia::RigidPartInertia(RigidBodies bodies)
    : bodies(std::move(bodies))
  {}

  bool RigidPartInertia::is_linear() const
  {
    return true;
  }

  void RigidPartInertia::register_in(StateLayout &layout)
  {
    kinetic_entry   = layout.energies.enter(kinetic_energy_entry());
    numerical_entry = layout.energies.enter(numerical_energy_entry());
  }

  void RigidPartInertia::register_blocks(TangentPattern &pattern)
  {
    bool is_first = true;
    for_each([&](const auto &body) {
      const std::size_t block =
        pattern.register_block(body.base.data(), body.base.size());
      if (is_first)
        first_block = block;
      is_first = false;
    });
  }

  void RigidPartInertia::add_residual(const Evaluation &evaluation,
                                      double           *residual,
                                      EffectResults * /*results*/) const
  {
    const double *a = evaluation.to.acceleration->data();
    for_each([&](const auto &body) {
      constexpr unsigned int n = std::tuple_size_v<decltype(body.base)>;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          residual[body.base[i]] += body.mass[n * i + j] * a[body.base[j]];
    });
  }

  void RigidPartInertia::add_tangent(const Evaluation & /*evaluation*/,
                                     const EffectResults * /*results*/,
                                     const TangentFactors &factors,
                                     TangentMatrix        &matrix) const
  {
    std::size_t number = first_block;
    for_each([&](const auto &body) {
      auto block = body.mass;
      for (double &entry : block)
        entry *= factors.mass;
      matrix.add(number++, block.data());
    });
  }

  void RigidPartInertia::account(const Evaluation & /*step*/,
                                 const EffectResults * /*results*/,
                                 EnergyAccount &account) const
  {
    const auto product = [&](const Vector &x, const Vector &y) {
      double sum = 0;
      for_each([&](const auto &body) {
        constexpr unsigned int n = std::tuple_size_v<decltype(body.base)>;
        if (body.owned)
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              sum += body.mass[n * i + j] * x[body.base[i]] * y[body.base[j]];
      });
      return sum;
    };
    account.add_inertia(kinetic_entry, numerical_entry, product);
  }
} // namespace auxfem
