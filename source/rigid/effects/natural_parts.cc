#include <auxfem/rigid/effects/natural_parts.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /**
     * Sets entries (i, j) and (j, i) of a symmetric row-major block of size n.
     */
    template <std::size_t n>
    void set_pair(std::array<double, n * n> &block,
                  const unsigned int         i,
                  const unsigned int         j,
                  const double               value)
    {
      block[n * i + j] = block[n * j + i] = value;
    }

    /** Sets forces @p column in column j and the constraint gradient @p row in
     * row j of such a block. */
    template <std::size_t n>
    void set_constraint(std::array<double, n * n> &block,
                        const unsigned int         i,
                        const unsigned int         j,
                        const double               column,
                        const double               row)
    {
      block[n * i + j] = column;
      block[n * j + i] = row;
    }
  } // namespace

  template <int dim>
  void NaturalParts<dim>::add_constraints(const NaturalBody<dim> &body)
  {
    const RigidPart &part = lattice.rigid_parts[body.part];
    unsigned int     next = 0;
    joint_begin.push_back(joints.size());
    clamp_begin.push_back(clamps.size());
    const auto multiplier = [&] {
      return numbering.constraints().multiplier(body.part, next++);
    };
    Base base{{}, {body.rest, body.length}};
    std::copy(body.base.begin(), body.base.end(), base.unknowns.begin());
    base.unknowns.back() = multiplier();
    bases.push_back(base);
    for (unsigned int k = 2; k < part.joints.size(); ++k)
      {
        const NaturalPosition position =
          position_in<dim>(part, lattice, lattice.joints[part.joints[k]]);
        Joint joint;
        joint.index_in_part = k;
        std::copy(body.base.begin(),
                  body.base.end(),
                  joint.unknowns.begin() + dim);
        for (unsigned int c = 0; c < dim; ++c)
          {
            joint.unknowns[c] = numbering.joint_unknown(part.joints[k], c);
            joint.unknowns[3 * dim + c] = multiplier();
            joint.shapes[c]             = shape<dim>(position, c);
          }
        joints.push_back(joint);
      }
    if constexpr (dim == 2)
      for (const unsigned int joint :
           numbering.constraints().clamped_joints(body.part))
        clamps.push_back({{{body.base[0],
                            body.base[1],
                            body.base[2],
                            body.base[3],
                            numbering.joint_unknown(joint, rotation_z),
                            multiplier()}},
                          {body.rest, body.length}});
  }

  template <int dim>
  std::pair<PlaneVector, double>
  NaturalParts<dim>::force_direction(const Clamp      &clamp,
                                     const Evaluation &evaluation) const
  {
    const double *u1 = evaluation.to.displacement.data();
    if (evaluation.kind != Evaluation::Kind::discrete_gradient ||
        !large_rotation)
      return gradient(clamp, u1);
    // With the mean normal, e_1 . d_1 - e_0 . d_0 is exactly the mean normal
    // times the increment of d plus the second term times the rotation
    // increment.
    const double     *u0   = evaluation.from.displacement.data();
    const PlaneVector mean = (clamp.constraint.normal(u0[clamp.unknowns[4]]) +
                              clamp.constraint.normal(u1[clamp.unknowns[4]])) /
      2,
                      d = clamp.constraint.rest +
      (base_difference<2>(clamp.unknowns, u0) +
       base_difference<2>(clamp.unknowns, u1)) /
        2;
    return {mean, perpendicular(mean) * d};
  }

  template <int dim>
  void NaturalParts<dim>::add_base_rows(const Evaluation &evaluation,
                                        double           *residual) const
  {
    const double *u = evaluation.to.displacement.data();
    for (const Base &base : bases)
      {
        const auto &unknowns  = base.unknowns;
        const Vec   G         = gradient(base, u);
        const Vec   direction = force_direction(base, evaluation);
        for (unsigned int c = 0; c < dim; ++c)
          {
            residual[unknowns[c]] -= u[unknowns[2 * dim]] * direction[c];
            residual[unknowns[dim + c]] += u[unknowns[2 * dim]] * direction[c];
          }
        double &row = residual[unknowns[2 * dim]];
        if (evaluation.has_constraint_accelerations())
          {
            row += G *
              base_difference<dim>(unknowns,
                                   evaluation.to.acceleration->data());
            if (large_rotation)
              row += base.constraint.curvature() *
                base_difference<dim>(unknowns, evaluation.to.velocity->data())
                  .norm_square();
          }
        else
          {
            const Vec stretch = base_difference<dim>(unknowns, u);
            row +=
              large_rotation ? base.constraint.value(stretch) : G * stretch;
          }
      }
  }

  template <int dim>
  void NaturalParts<dim>::add_joint_rows(const Evaluation &evaluation,
                                         double           *residual) const
  {
    const double *u = evaluation.to.displacement.data();
    const double *q = evaluation.has_constraint_accelerations()
      ? evaluation.to.acceleration->data()
      : u;
    for (const Joint &joint : joints)
      {
        const auto &unknowns = joint.unknowns;
        for (unsigned int c = 0; c < dim; ++c)
          {
            const double lambda = u[unknowns[3 * dim + c]];
            double       gap    = q[unknowns[c]];
            residual[unknowns[c]] += lambda;
            for (unsigned int i = 0; i < 2 * dim; ++i)
              {
                gap -= joint.shapes[c][i] * q[unknowns[dim + i]];
                residual[unknowns[dim + i]] -= lambda * joint.shapes[c][i];
              }
            residual[unknowns[3 * dim + c]] += gap;
          }
      }
  }

  template <int dim>
  void NaturalParts<dim>::add_clamp_rows(const Evaluation &evaluation,
                                         double           *residual) const
  {
    const double *u = evaluation.to.displacement.data();
    for (const Clamp &clamp : clamps)
      {
        const auto &unknowns     = clamp.unknowns;
        const auto [along, turn] = gradient(clamp, u);
        const auto   force       = force_direction(clamp, evaluation);
        const double lambda      = u[unknowns[5]];
        for (unsigned int c = 0; c < 2; ++c)
          {
            residual[unknowns[c]] -= lambda * force.first[c];
            residual[unknowns[2 + c]] += lambda * force.first[c];
          }
        residual[unknowns[4]] += lambda * force.second;

        double &row = residual[unknowns[5]];
        if (evaluation.has_constraint_accelerations())
          {
            const double *a = evaluation.to.acceleration->data();
            const double *v = evaluation.to.velocity->data();
            row +=
              along * base_difference<2>(unknowns, a) + turn * a[unknowns[4]];
            if (large_rotation)
              {
                const double      rate = v[unknowns[4]];
                const PlaneVector d =
                  clamp.constraint.rest + base_difference<2>(unknowns, u);
                row += 2 * rate *
                    (clamp.constraint.normal_derivative(u[unknowns[4]]) *
                     base_difference<2>(unknowns, v)) -
                  rate * rate * (along * d);
              }
          }
        else if (large_rotation)
          row +=
            along * (clamp.constraint.rest + base_difference<2>(unknowns, u));
        else
          row +=
            along * base_difference<2>(unknowns, u) + turn * u[unknowns[4]];
      }
  }

  template <int dim>
  void NaturalParts<dim>::add_base_blocks(const Evaluation     &evaluation,
                                          const TangentFactors &factors,
                                          TangentMatrix        &matrix,
                                          std::size_t          &block) const
  {
    constexpr unsigned int n = 2 * dim + 1;
    const double          *u = evaluation.to.displacement.data();
    for (const Base &base : bases)
      {
        const Vec    G                  = gradient(base, u);
        const Vec    direction          = force_direction(base, evaluation);
        const double geometric          = large_rotation ? factors.stiffness *
            u[base.unknowns[2 * dim]] * base.constraint.curvature()
                                                         : 0.;
        std::array<double, n *n> values = {};
        for (unsigned int c = 0; c < dim; ++c)
          {
            set_constraint<n>(values, c, 2 * dim, -direction[c], -G[c]);
            set_constraint<n>(values, dim + c, 2 * dim, direction[c], G[c]);
            set_pair<n>(values, c, c, geometric);
            set_pair<n>(values, dim + c, dim + c, geometric);
            set_pair<n>(values, c, dim + c, -geometric);
          }
        matrix.add(block++, values.data());
      }
  }

  template <int dim>
  void NaturalParts<dim>::add_joint_blocks(TangentMatrix &matrix,
                                           std::size_t   &block) const
  {
    constexpr unsigned int n = 4 * dim;
    for (const Joint &joint : joints)
      {
        std::array<double, n *n> values = {};
        for (unsigned int c = 0; c < dim; ++c)
          {
            set_pair<n>(values, c, 3 * dim + c, 1.);
            for (unsigned int i = 0; i < 2 * dim; ++i)
              set_pair<n>(values, dim + i, 3 * dim + c, -joint.shapes[c][i]);
          }
        matrix.add(block++, values.data());
      }
  }

  template <int dim>
  void NaturalParts<dim>::add_clamp_blocks(const Evaluation     &evaluation,
                                           const TangentFactors &factors,
                                           TangentMatrix        &matrix,
                                           std::size_t          &block) const
  {
    const double *u = evaluation.to.displacement.data();
    for (const Clamp &clamp : clamps)
      {
        const auto [along, turn]         = gradient(clamp, u);
        const auto             direction = force_direction(clamp, evaluation);
        std::array<double, 36> values    = {};
        set_constraint<6>(values, 4, 5, direction.second, turn);
        for (unsigned int c = 0; c < 2; ++c)
          {
            set_constraint<6>(values, c, 5, -direction.first[c], -along[c]);
            set_constraint<6>(values, 2 + c, 5, direction.first[c], along[c]);
          }
        if (large_rotation)
          {
            const double      force = factors.stiffness * u[clamp.unknowns[5]];
            const PlaneVector d =
              clamp.constraint.rest + base_difference<2>(clamp.unknowns, u);
            const PlaneVector derivative =
              clamp.constraint.normal_derivative(u[clamp.unknowns[4]]);
            set_pair<6>(values, 4, 4, -force * (along * d));
            for (unsigned int c = 0; c < 2; ++c)
              {
                set_pair<6>(values, c, 4, -force * derivative[c]);
                set_pair<6>(values, 2 + c, 4, force * derivative[c]);
              }
          }
        matrix.add(block++, values.data());
      }
  }

  template <int dim>
  void NaturalParts<dim>::find_clamp_rates(const State &state,
                                           double      *rates) const
  {
    const double *u = state.displacement.data();
    const double *v = state.velocity->data();
    for (const Clamp &clamp : clamps)
      {
        const auto [along, turn] = gradient(clamp, u);
        rates[clamp.unknowns[5]] =
          along * base_difference<2>(clamp.unknowns, v) +
          turn * v[clamp.unknowns[4]];
      }
  }

  template <int dim>
  void NaturalParts<dim>::subtract_clamp_forces(
    const unsigned int           body,
    const double                *u,
    std::array<double, 2 * dim> &forces) const
  {
    for (unsigned int k = clamp_begin[body]; k < clamp_begin[body + 1]; ++k)
      {
        const PlaneVector force =
          u[clamps[k].unknowns[5]] * gradient(clamps[k], u).first;
        for (unsigned int c = 0; c < 2; ++c)
          {
            forces[c] -= force[c];
            forces[2 + c] += force[c];
          }
      }
  }

  template <int dim>
  RigidPartReport NaturalParts<dim>::report(const unsigned int i,
                                            const State       &state) const
  {
    const unsigned int      b    = reported[i];
    const NaturalBody<dim> &body = bodies[b];
    const double           *u    = state.displacement.data();
    RigidPartReport         report;
    report.part = body.part;
    report.forces.resize(lattice.rigid_parts[body.part].joints.size());

    // The joint forces balance the inertia less the weight of the body and the
    // constraint forces.
    std::array<double, 2 *dim> on_base = {};
    for (unsigned int r = 0; r < 2 * dim; ++r)
      for (unsigned int s = 0; s < 2 * dim; ++s)
        on_base[r] += body.mass[2 * dim * r + s] *
          ((state.acceleration ? (*state.acceleration)[body.base[s]] : 0.) -
           gravity[s % dim].value(time_of_loads(state)) +
           base_acceleration[s % dim].value(time_of_loads(state)));
    const Vec G = gradient(bases[b], u);
    for (unsigned int c = 0; c < dim; ++c)
      {
        on_base[c] -= u[bases[b].unknowns[2 * dim]] * G[c];
        on_base[dim + c] += u[bases[b].unknowns[2 * dim]] * G[c];
      }
    for (unsigned int k = joint_begin[b]; k < joint_begin[b + 1]; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const Joint &joint  = joints[k];
          const double lambda = u[joint.unknowns[3 * dim + c]];
          report.forces[joint.index_in_part][c] = lambda;
          for (unsigned int r = 0; r < 2 * dim; ++r)
            on_base[r] -= lambda * joint.shapes[c][r];
        }
    if constexpr (dim == 2)
      subtract_clamp_forces(b, u, on_base);
    for (unsigned int r = 0; r < 2 * dim; ++r)
      report.forces[r / dim][r % dim] = on_base[r];
    return report;
  }

  template <int dim>
  std::unique_ptr<RigidPartGroup>
  make_natural_parts(const std::vector<NaturalBody<dim>> &bodies,
                     const RigidPartSetting              &setting)
  {
    return std::make_unique<NaturalParts<dim>>(bodies, setting);
  }

  template std::unique_ptr<RigidPartGroup>
  make_natural_parts(const std::vector<NaturalBody<2>> &,
                     const RigidPartSetting &);
  template std::unique_ptr<RigidPartGroup>
  make_natural_parts(const std::vector<NaturalBody<3>> &,
                     const RigidPartSetting &);
} // namespace auxfem
