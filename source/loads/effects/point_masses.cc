#include <auxfem/equations/effect.h>
#include <auxfem/equations/make_effects.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/point_masses.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/struts/rotary_inertia.h>

#include <array>

namespace auxfem
{
  namespace
  {
    /** Masses on displacements, and in the plane inertias on rotations. */
    class PointMasses : public InertiaEffect
    {
    public:
      PointMasses(const DofNumbering &numbering, std::vector<PointMass> masses)
        : numbering(numbering)
        , masses(std::move(masses))
      {}

      bool is_linear() const override
      {
        return true;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block =
          pattern.register_blocks(masses, [](const PointMass &mass) {
            return std::array<int, 1>{{mass.unknown}};
          });
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        const double *a = evaluation.to.acceleration->data();
        for (const PointMass &mass : masses)
          residual[mass.unknown] += mass.mass * a[mass.unknown];
      }

      void add_tangent(const Evaluation & /*evaluation*/,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        for (unsigned int i = 0; i < masses.size(); ++i)
          {
            const double value = factors.mass * masses[i].mass;
            matrix.add(first_block + i, &value);
          }
      }

    private:
      double mass_product(const Vector &x, const Vector &y) const override
      {
        double sum = 0;
        for (const PointMass &mass : masses)
          if (numbering.layout().is_owned(mass.unknown))
            sum += mass.mass * x[mass.unknown] * y[mass.unknown];
        return sum;
      }

      const DofNumbering          &numbering;
      const std::vector<PointMass> masses;
      std::size_t                  first_block = 0;
    };

    /** Rotary inertia at nodes in space: Euler's equations, without gyroscopic
     * terms if rotations are small. */
    class RotaryMasses : public InertiaEffect
    {
    public:
      RotaryMasses(const DofNumbering     &numbering,
                   const bool              large_rotation,
                   std::vector<RotaryMass> masses)
        : numbering(numbering)
        , rotations(numbering)
        , large_rotation(large_rotation)
        , masses(std::move(masses))
      {}

      bool is_linear() const override
      {
        return !large_rotation;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block = pattern.register_blocks(
          masses,
          [&](const RotaryMass &mass) -> const std::array<int, 3> & {
            return numbering.rotations()[mass.rotation];
          });
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        for (const RotaryMass &mass : masses)
          {
            const RotaryInertia::Motion now = motion(mass, evaluation.to);
            const SpaceVector inertial      = mass.inertia * now.acceleration;
            const SpaceVector torque        = !large_rotation ? inertial
                     : evaluation.kind == Evaluation::Kind::discrete_gradient
                     ? mean_torque(mass, evaluation)
                     : RotaryInertia::torque(mass.inertia,
                                      evaluation.to.rotations[mass.rotation],
                                      now);
            const std::array<int, 3> &spins =
              numbering.rotations()[mass.rotation];
            for (unsigned int c = 0; c < 3; ++c)
              residual[spins[c]] += torque[c];
          }
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        for (unsigned int i = 0; i < masses.size(); ++i)
          {
            SpaceTensor block = factors.mass * masses[i].inertia;
            if (large_rotation)
              {
                const unsigned int rotation = masses[i].rotation;
                if (evaluation.kind == Evaluation::Kind::discrete_gradient)
                  block = mean_tangent(masses[i], evaluation, factors);
                else
                  {
                    const RotaryInertia::Tangent tangent =
                      RotaryInertia::tangent(masses[i].inertia,
                                             evaluation.to.rotations[rotation],
                                             motion(masses[i], evaluation.to));
                    block = factors.stiffness * tangent.by_spin +
                      (factors.damping * tangent.by_velocity +
                       factors.mass * tangent.by_acceleration) *
                        rotations.increment_by_spin(evaluation, rotation);
                  }
              }
            double values[9];
            for (unsigned int r = 0; r < 3; ++r)
              for (unsigned int c = 0; c < 3; ++c)
                values[3 * r + c] = block[r][c];
            matrix.add(first_block + i, values);
          }
      }

      void row_force_bounds(const Evaluation &evaluation,
                            const EffectCache * /*results*/,
                            double *forces) const override
      {
        // The inertia torques of a freely spinning body cancel: bounds need
        // both terms.
        for (const RotaryMass &mass : masses)
          {
            const RotaryInertia::Motion now = motion(mass, evaluation.to);
            const double torque = (mass.inertia * now.acceleration).norm() +
              now.velocity.norm() * (mass.inertia * now.velocity).norm();
            for (const int spin : numbering.rotations()[mass.rotation])
              raise_bound(forces, spin, torque);
          }
      }

    private:
      /** Without gyroscopic torques, which do no work. */
      double mass_product(const Vector &x, const Vector &y) const override
      {
        double sum = 0;
        for (const RotaryMass &mass : masses)
          if (numbering.layout().is_owned(
                numbering.rotations()[mass.rotation][0]))
            sum += rotations.values(x, mass.rotation) *
              (mass.inertia * rotations.values(y, mass.rotation));
        return sum;
      }

      RotaryInertia::Motion motion(const RotaryMass &mass,
                                   const State      &state) const
      {
        return {rotations.values(*state.velocity, mass.rotation),
                rotations.values(*state.acceleration, mass.rotation)};
      }

      /** Torque of a discrete-gradient step (N m). */
      SpaceVector mean_torque(const RotaryMass &mass,
                              const Evaluation &step) const
      {
        const RotaryInertia::Motion start = motion(mass, step.from),
                                    end   = motion(mass, step.to);
        return RotaryInertia::mean_torque(
          step.from.rotations[mass.rotation],
          step.to.rotations[mass.rotation],
          mass.inertia * ((start.velocity + end.velocity) / 2),
          mass.inertia * end.acceleration,
          step.dt,
          0.);
      }

      /** Derivative of mean_torque() by spins at the end. */
      SpaceTensor mean_tangent(const RotaryMass     &mass,
                               const Evaluation     &step,
                               const TangentFactors &factors) const
      {
        const Quaternion &rotation = step.to.rotations[mass.rotation];
        return factors.mass *
          rotated(rotation,
                  mass.inertia *
                    rotations.increment_by_spin(step, mass.rotation)) -
          2 * factors.stiffness / step.dt *
          cross_product_tensor(
            rotated(rotation, mass.inertia * motion(mass, step.to).velocity));
      }

      const DofNumbering           &numbering;
      const NodeRotations           rotations;
      const bool                    large_rotation;
      const std::vector<RotaryMass> masses;
      std::size_t                   first_block = 0;
    };

    /** Inertia of rigid parts in natural coordinates: constant mass matrices on
     * the unknowns of their bases. */
    class RigidPartInertia : public InertiaEffect
    {
    public:
      explicit RigidPartInertia(RigidBodies bodies) : bodies(std::move(bodies))
      {}

      bool is_linear() const override
      {
        return true;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block = pattern.n_blocks();
        for_each([&](const auto &body) {
          pattern.register_block(body.base.data(), body.base.size());
        });
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        const double *a = evaluation.to.acceleration->data();
        for_each([&](const auto &body) {
          constexpr unsigned int n = std::tuple_size_v<decltype(body.base)>;
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              residual[body.base[i]] += body.mass[n * i + j] * a[body.base[j]];
        });
      }

      void add_tangent(const Evaluation & /*evaluation*/,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        std::size_t number = first_block;
        for_each([&](const auto &body) {
          auto block = body.mass;
          for (double &entry : block)
            entry *= factors.mass;
          matrix.add(number++, block.data());
        });
      }

    private:
      double mass_product(const Vector &x, const Vector &y) const override
      {
        double sum = 0;
        for_each([&](const auto &body) {
          constexpr unsigned int n = std::tuple_size_v<decltype(body.base)>;
          if (body.owned)
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                sum += body.mass[n * i + j] * x[body.base[i]] * y[body.base[j]];
        });
        return sum;
      }

      /** Calls @p action for all bodies in natural coordinates. */
      template <class Action>
      void for_each(const Action &action) const
      {
        for (const NaturalBody<2> &body : bodies.in_plane)
          action(body);
        for (const NaturalBody<3> &body : bodies.bars)
          action(body);
      }

      const RigidBodies bodies;
      std::size_t       first_block = 0;
    };
  } // namespace

  std::unique_ptr<Effect> make_point_masses(const DofNumbering    &numbering,
                                            std::vector<PointMass> masses)
  {
    return std::make_unique<PointMasses>(numbering, std::move(masses));
  }

  std::unique_ptr<Effect> make_rotary_masses(const DofNumbering &numbering,
                                             const bool          large_rotation,
                                             std::vector<RotaryMass> masses)
  {
    return std::make_unique<RotaryMasses>(numbering,
                                          large_rotation,
                                          std::move(masses));
  }

  std::unique_ptr<Effect> make_rigid_part_inertia(const RigidBodies &bodies)
  {
    return std::make_unique<RigidPartInertia>(bodies);
  }

  namespace
  {
    /** Mass or moment of inertia of a component of motion. */
    double component_mass(const MassDefinition &mass,
                          const unsigned int    component)
    {
      return component < first_rotation
        ? mass.mass
        : mass.rotary_inertia[component - first_rotation];
    }

    void refuse_missing_rotation(const MassDefinition &mass,
                                 const DofNumbering   &numbering,
                                 const unsigned int    joint)
    {
      if (mass.rotary_inertia.norm() > 0 &&
          !numbering.joint_has(joint, rotation_z))
        throw InputError(mass.path + "/Rotary inertia: " +
                         missing_rotation_reason(numbering, joint));
    }

    SpaceTensor along_global_axes(const SpaceVector &values)
    {
      SpaceTensor result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c][c] = values[c];
      return result;
    }
  } // namespace

  std::vector<std::unique_ptr<Effect>> make_masses(const LatticeModel &model)
  {
    const Lattice          &lattice   = model.lattice;
    const DofNumbering     &numbering = model.numbering;
    std::vector<PointMass>  points;
    std::vector<RotaryMass> rotary;
    const bool              is_spatial = lattice.dimension == 3;
    for (const MassDefinition &mass : model.plan.scene.masses)
      for (const unsigned int joint :
           joints_of(mass, lattice, model.plan.scene.context))
        {
          if (lattice.is_image(joint))
            continue;
          refuse_missing_rotation(mass, numbering, joint);
          for (const unsigned int c : numbering.components())
            {
              const int unknown = numbering.joint_unknown(joint, c);
              if (unknown < 0 || component_mass(mass, c) == 0 ||
                  (is_spatial && c >= first_rotation))
                continue;
              points.push_back({unknown, component_mass(mass, c)});
            }
          const int spin = numbering.joint_unknown(joint, rotation_z);
          if (is_spatial && spin >= 0 && mass.rotary_inertia.norm() > 0)
            rotary.push_back({numbering.rotations().with(spin),
                              along_global_axes(mass.rotary_inertia)});
        }
    for (const RotatingBody &body : model.bodies.rotating)
      {
        const RigidPart &part = lattice.rigid_parts[body.part];
        if (part.mass == 0)
          continue;
        for (const int unknown : body.centre)
          points.push_back({unknown, part.mass});
        rotary.push_back(
          {numbering.rotations().with(body.rotation[0]), part.rotary_inertia});
      }
    std::vector<std::unique_ptr<Effect>> effects;
    if (!points.empty())
      effects.push_back(make_point_masses(numbering, std::move(points)));
    if (!rotary.empty())
      effects.push_back(make_rotary_masses(numbering,
                                           model.plan.simulated.large_rotation,
                                           std::move(rotary)));
    return effects;
  }
} // namespace auxfem
