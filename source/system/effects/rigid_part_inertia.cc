#include <auxfem/system/effects/rigid_part_inertia.h>

namespace auxfem
{
  RigidPartInertia::RigidPartInertia(std::vector<RigidBody> bodies)
    : bodies(std::move(bodies))
  {}

  bool RigidPartInertia::is_linear() const
  {
    return true;
  }

  void RigidPartInertia::register_blocks(TangentMatrix &matrix)
  {
    for (unsigned int i = 0; i < bodies.size(); ++i)
      {
        const std::size_t block =
          matrix.register_block(bodies[i].base.data(), bodies[i].base.size());
        if (i == 0)
          first_block = block;
      }
  }

  void RigidPartInertia::add_residual(const Step &step, double *residual)
  {
    const double *a = step.to.acceleration->Values();
    for (const RigidBody &body : bodies)
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          residual[body.base[i]] += body.mass[4 * i + j] * a[body.base[j]];
  }

  void RigidPartInertia::add_tangent(const Step & /*step*/,
                                     const TangentFactors &factors,
                                     TangentMatrix        &matrix) const
  {
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        std::array<double, 16> block = bodies[b].mass;
        for (double &entry : block)
          entry *= factors.mass;
        matrix.add(first_block + b, block.data());
      }
  }

  void RigidPartInertia::add_energies(const State &state,
                                      Energies    &energies) const
  {
    const double *v = state.velocity->Values();
    for (const RigidBody &body : bodies)
      if (body.counted)
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < 4; ++j)
            energies.kinetic +=
              body.mass[4 * i + j] / 2 * v[body.base[i]] * v[body.base[j]];
  }
} // namespace auxfem
