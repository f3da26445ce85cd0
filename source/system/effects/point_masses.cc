#include <auxfem/system/effects/point_masses.h>

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

  void PointMasses::register_blocks(TangentMatrix &matrix)
  {
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const std::size_t block = matrix.register_block(&masses[i].unknown, 1);
        if (i == 0)
          first_block = block;
      }
  }

  void PointMasses::add_residual(const Step &step, double *residual)
  {
    const double *a = step.to.acceleration->Values();
    for (const Mass &mass : masses)
      residual[mass.unknown] += mass.mass * a[mass.unknown];
  }

  void PointMasses::add_tangent(const Step & /*step*/,
                                const TangentFactors &factors,
                                TangentMatrix        &matrix) const
  {
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const double value = factors.mass * masses[i].mass;
        matrix.add(first_block + i, &value);
      }
  }

  void PointMasses::add_energies(const State &state, Energies &energies) const
  {
    const double *v = state.velocity->Values();
    for (const Mass &mass : masses)
      if (numbering.is_owned(mass.unknown))
        energies.kinetic += mass.mass / 2 * v[mass.unknown] * v[mass.unknown];
  }
} // namespace auxfem
