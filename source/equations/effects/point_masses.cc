#include <auxfem/equations/effects/point_masses.h>

namespace auxfem
{
  PointMasses::PointMasses(const DofNumbering &numbering) : numbering(numbering)
  {}

  void PointMasses::add(const unsigned int unknown, const double mass)
  {
    masses.push_back({static_cast<int>(unknown), mass});
  }

  bool PointMasses::empty() const
  {
    return masses.empty();
  }

  bool PointMasses::is_linear() const
  {
    return true;
  }

  void PointMasses::register_in(StateLayout &layout)
  {
    kinetic_entry   = layout.energies.enter(kinetic_energy_entry());
    numerical_entry = layout.energies.enter(numerical_energy_entry());
  }

  void PointMasses::register_blocks(TangentPattern &pattern)
  {
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const std::size_t block = pattern.register_block(&masses[i].unknown, 1);
        if (i == 0)
          first_block = block;
      }
  }

  void PointMasses::add_residual(const Evaluation &evaluation,
                                 double           *residual,
                                 EffectResults * /*results*/) const
  {
    const double *a = evaluation.to.acceleration->data();
    for (const Mass &mass : masses)
      residual[mass.unknown] += mass.mass * a[mass.unknown];
  }

  void PointMasses::add_tangent(const Evaluation & /*evaluation*/,
                                const EffectResults * /*results*/,
                                const TangentFactors &factors,
                                TangentMatrix        &matrix) const
  {
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const double value = factors.mass * masses[i].mass;
        matrix.add(first_block + i, &value);
      }
  }

  void PointMasses::account(const Evaluation & /*step*/,
                            const EffectResults * /*results*/,
                            EnergyAccount &account) const
  {
    account.add_inertia(kinetic_entry,
                        numerical_entry,
                        [&](const Vector &x, const Vector &y) {
                          double sum = 0;
                          for (const Mass &mass : masses)
                            if (numbering.layout().is_owned(mass.unknown))
                              sum +=
                                mass.mass * x[mass.unknown] * y[mass.unknown];
                          return sum;
                        });
  }
} // namespace auxfem
