#ifndef auxfem_rigid_effects_natural_parts_h
#define auxfem_rigid_effects_natural_parts_h

#include <auxfem/rigid/effects/rigid_part_group.h>

#include <cmath>

namespace auxfem
{
  /** Difference of @p values between the base points, whose unknowns come
   * first. */
  template <int dim, std::size_t n>
  dealii::Tensor<1, dim> base_difference(const std::array<int, n> &unknowns,
                                         const double             *values)
  {
    dealii::Tensor<1, dim> difference;
    for (unsigned int c = 0; c < dim; ++c)
      difference[c] = values[unknowns[dim + c]] - values[unknowns[c]];
    return difference;
  }

  /** Shortest rotation vector from @p rest to @p now in space (rad). */
  inline SpaceVector shortest_rotation(const SpaceVector &rest,
                                       const SpaceVector &now)
  {
    const SpaceVector across = dealii::cross_product_3d(rest, now);
    const double      sine   = across.norm();
    return sine > 0 ? std::atan2(sine, rest * now) / sine * across
                    : SpaceVector();
  }

  /**
   * Constraints of rigid parts in natural coordinates: bodies in the plane (dim
   * = 2), with a constraint for each clamped strut, and bars in space (dim =
   * 3). make_rigid_part_constraints() makes them.
   */
  template <int dim>
  class NaturalParts : public RigidPartGroup
  {
  public:
    NaturalParts(const std::vector<NaturalBody<dim>> &bodies,
                 const RigidPartSetting              &setting)
      : bodies(bodies)
      , lattice(setting.lattice)
      , numbering(setting.numbering)
      , large_rotation(setting.large_rotation)
      , gravity(setting.gravity)
      , base_acceleration(setting.base_acceleration)
    {
      for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          add_constraints(bodies[b]);
          if (bodies[b].owned)
            reported.push_back(b);
        }
      joint_begin.push_back(joints.size());
      clamp_begin.push_back(clamps.size());
    }

    bool is_linear() const override
    {
      return !large_rotation;
    }

    void register_blocks(TangentPattern &pattern) override
    {
      // Numbered consecutively: bases, then joints, then clamps.
      first_block = pattern.register_blocks(bases, &Base::unknowns);
      pattern.register_blocks(joints, &Joint::unknowns);
      pattern.register_blocks(clamps, &Clamp::unknowns);
    }

    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectCache * /*results*/) const override
    {
      add_base_rows(evaluation, residual);
      add_joint_rows(evaluation, residual);
      if constexpr (dim == 2)
        add_clamp_rows(evaluation, residual);
    }

    void add_tangent(const Evaluation &evaluation,
                     const EffectCache * /*results*/,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override
    {
      // Constraint gradients enter the matrix for any unknown, displacement or
      // acceleration.
      std::size_t block = first_block;
      add_base_blocks(evaluation, factors, matrix, block);
      add_joint_blocks(matrix, block);
      if constexpr (dim == 2)
        add_clamp_blocks(evaluation, factors, matrix, block);
    }

    void row_force_bounds(const Evaluation &evaluation,
                          const EffectCache * /*results*/,
                          double *forces) const override
    {
      const double *u = evaluation.to.displacement.data();
      for (const Base &base : bases)
        for (unsigned int i = 0; i < 2 * dim; ++i)
          raise_bound(forces,
                      base.unknowns[i],
                      std::abs(u[base.unknowns[2 * dim]]));
      for (const Joint &joint : joints)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const double lambda = std::abs(u[joint.unknowns[3 * dim + c]]);
            raise_bound(forces, joint.unknowns[c], lambda);
            for (unsigned int i = 0; i < 2 * dim; ++i)
              raise_bound(forces,
                          joint.unknowns[dim + i],
                          lambda * std::abs(joint.shapes[c][i]));
          }
      for (const Clamp &clamp : clamps)
        {
          const double lambda = std::abs(u[clamp.unknowns[5]]);
          for (unsigned int i = 0; i < 4; ++i)
            raise_bound(forces, clamp.unknowns[i], lambda);
          raise_bound(forces,
                      clamp.unknowns[4],
                      lambda * clamp.constraint.length);
        }
    }

    void find_rates(const State &state, double *rates) const override
    {
      const double *u = state.displacement.data();
      const double *v = state.velocity->data();
      for (const Base &base : bases)
        rates[base.unknowns[2 * dim]] =
          gradient(base, u) * base_difference<dim>(base.unknowns, v);
      for (const Joint &joint : joints)
        for (unsigned int c = 0; c < dim; ++c)
          {
            double rate = v[joint.unknowns[c]];
            for (unsigned int i = 0; i < 2 * dim; ++i)
              rate -= joint.shapes[c][i] * v[joint.unknowns[dim + i]];
            rates[joint.unknowns[3 * dim + c]] = rate;
          }
      if constexpr (dim == 2)
        find_clamp_rates(state, rates);
    }

    unsigned int n_reported() const override
    {
      return reported.size();
    }

    unsigned int part(const unsigned int i) const override
    {
      return bodies[reported[i]].part;
    }

    SpaceVector rotation(const unsigned int i,
                         const State       &state) const override
    {
      const NaturalBody<dim> &body = bodies[reported[i]];
      const Vec               stretch =
        base_difference<dim>(body.base, state.displacement.data());
      SpaceVector result;
      if constexpr (dim == 2)
        {
          const double across = perpendicular(body.rest) * stretch;
          result[2]           = large_rotation
                      ? std::atan2(across, body.rest * (body.rest + stretch))
                      : across / (body.length * body.length);
        }
      else
        result = large_rotation
          ? shortest_rotation(body.rest, body.rest + stretch)
          : dealii::cross_product_3d(body.rest, stretch) /
            (body.length * body.length);
      return result;
    }

    PointMotion motion(const unsigned int      i,
                       const dealii::Point<3> &point,
                       const State            &state) const override
    {
      const NaturalBody<dim> &body = bodies[reported[i]];
      PointMotion             result;
      for (unsigned int c = 0; c < dim; ++c)
        for (const auto &[unknown, share] :
             force_shares(body, lattice, numbering, point, c))
          {
            result.displacement[c] += share * state.displacement[unknown];
            if (state.velocity)
              result.velocity[c] += share * (*state.velocity)[unknown];
          }
      return result;
    }

    RigidPartReport report(const unsigned int i,
                           const State       &state) const override;

  private:
    using Vec = dealii::Tensor<1, dim>;

    /** Distance constraint of the base joints of one body. */
    struct Base
    {
      std::array<int, 2 * dim + 1> unknowns; ///< base, multiplier
      DistanceConstraint<dim>      constraint;
    };
    /** Position constraint of another joint. */
    struct Joint
    {
      unsigned int             index_in_part; ///< index into RigidPart::joints
      std::array<int, 4 * dim> unknowns;      ///< joint's, base, multipliers
      std::array<std::array<double, 2 * dim>, dim> shapes;
    };
    /** Rotation constraint of a clamped strut end, in the plane. */
    struct Clamp
    {
      std::array<int, 6> unknowns; ///< base, rotation, multiplier
      ClampConstraint    constraint;
    };

    void add_constraints(const NaturalBody<dim> &body);

    /**
     * Direction of the multiplier forces. With Kind::discrete_gradient their
     * work is exactly the increment of the constraint; moments work on Cayley's
     * measure of rotation increments.
     */
    Vec force_direction(const Base &base, const Evaluation &evaluation) const
    {
      const Vec now = gradient(base, evaluation.to.displacement.data());
      return evaluation.kind == Evaluation::Kind::discrete_gradient
        ? (gradient(base, evaluation.from.displacement.data()) + now) / 2
        : now;
    }

    std::pair<PlaneVector, double>
    force_direction(const Clamp &clamp, const Evaluation &evaluation) const;

    Vec gradient(const Base &base, const double *u) const
    {
      return base.constraint.gradient(
        large_rotation ? base_difference<dim>(base.unknowns, u) : Vec());
    }

    /** Derivatives dg / d(r1 - r0) and dg / dphi. */
    std::pair<PlaneVector, double> gradient(const Clamp  &clamp,
                                            const double *u) const
    {
      if (!large_rotation)
        return {clamp.constraint.normal(0), -clamp.constraint.length};
      const double      phi = u[clamp.unknowns[4]];
      const PlaneVector d =
        clamp.constraint.rest + base_difference<2>(clamp.unknowns, u);
      return {clamp.constraint.normal(phi),
              clamp.constraint.normal_derivative(phi) * d};
    }

    void add_base_rows(const Evaluation &evaluation, double *residual) const;
    void add_joint_rows(const Evaluation &evaluation, double *residual) const;
    void add_clamp_rows(const Evaluation &evaluation, double *residual) const;
    void add_base_blocks(const Evaluation     &evaluation,
                         const TangentFactors &factors,
                         TangentMatrix        &matrix,
                         std::size_t          &block) const;
    void add_joint_blocks(TangentMatrix &matrix, std::size_t &block) const;
    void add_clamp_blocks(const Evaluation     &evaluation,
                          const TangentFactors &factors,
                          TangentMatrix        &matrix,
                          std::size_t          &block) const;
    void find_clamp_rates(const State &state, double *rates) const;
    /** Subtracts the forces of the clamp constraints from the @p forces on the
     * base of a body. */
    void subtract_clamp_forces(unsigned int                 body,
                               const double                *u,
                               std::array<double, 2 * dim> &forces) const;

    const std::vector<NaturalBody<dim>> bodies;
    const Lattice                      &lattice;
    const DofNumbering                 &numbering;
    const bool                          large_rotation;
    const std::array<TimeFunction, 3>   gravity, base_acceleration;

    std::vector<Base>  bases; ///< one per body
    std::vector<Joint> joints;
    std::vector<Clamp> clamps;
    /** Range of body b: [b] to [b + 1]. */
    std::vector<unsigned int> joint_begin, clamp_begin;
    std::vector<unsigned int> reported; ///< bodies
    std::size_t               first_block = 0;
  };
} // namespace auxfem

#endif
