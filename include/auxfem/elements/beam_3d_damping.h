#ifndef auxfem_elements_beam_3d_damping_h
#define auxfem_elements_beam_3d_damping_h

#include <auxfem/elements/beam_3d_tangent.h>

namespace auxfem
{
  namespace Beam3D
  {
    /**
     * @file
     * Stiffness-proportional damping of the beam in space: section forces and
     * moments are those of the strains plus beta times their rates, for the
     * same stiffness. With the notation of Beam3D and a dot for the rate,
     *
     *     R Gamma. = v' + r' x omega,   R K. = omega',
     *
     * where v and the angular velocity omega are interpolated from the nodes.
     * (That of the interpolated rotation differs from it by the error of the
     * interpolation.) In a rigid motion both rates vanish, the damping forces
     * are the derivatives of half their power by the velocities, and they are
     * in equilibrium. The small-displacement form has the damping force
     * small_displacement_force() of beta times the velocities.
     */

    /** Velocity of a node, both parts in the global frame. */
    struct NodeVelocity
    {
      SpaceVector linear, angular; ///< m/s, rad/s
    };

    /** Rates at a Gauss point, in the global frame. */
    struct Rates
    {
      SpaceVector gamma, kappa; ///< R Gamma., R K. = omega'
      SpaceVector angular;      ///< omega
    };

    template <int order>
    inline Rates rates(const BeamShape<order> &shape,
                       const int               g,
                       const double            inverse_jacobian,
                       const Kinematics       &point,
                       const NodeVelocity     *velocities)
    {
      Rates r;
      for (int a = 0; a <= order; ++a)
        {
          const double derivative = shape.derivative[g][a] * inverse_jacobian;
          r.gamma += derivative * velocities[a].linear;
          r.angular += shape.value[g][a] * velocities[a].angular;
          r.kappa += derivative * velocities[a].angular;
        }
      r.gamma += dealii::cross_product_3d(point.slope, r.angular);
      return r;
    }

    /** Section force and moment of damping in the global frame. */
    struct ViscousResultants
    {
      SpaceVector force, moment;
    };

    inline ViscousResultants viscous_resultants(const Kinematics &point,
                                                const Stiffness  &stiffness,
                                                const double      damping_time,
                                                const Rates      &r)
    {
      return {damping_time *
                (point.axes * section_force(stiffness, r.gamma * point.axes)),
              damping_time *
                (point.axes * section_moment(stiffness, r.kappa * point.axes))};
    }

    /** By what rates make the resultants, in the global frame. */
    struct ViscousStiffness
    {
      SpaceTensor by_gamma, by_kappa;
    };

    inline ViscousStiffness viscous_stiffness(const Kinematics &point,
                                              const Stiffness  &stiffness,
                                              const double      damping_time)
    {
      const SpaceVector ones({damping_time, damping_time, damping_time});
      return {with_principal_values(point.axes, section_force(stiffness, ones)),
              with_principal_values(point.axes,
                                    section_moment(stiffness, ones))};
    }

    /**
     * Adds the damping force of an element to @p force.
     * @param damping_time beta (s)
     * @param velocities of order + 1 nodes
     * @return power lost (W)
     */
    template <int order>
    inline double add_damping_force(const BeamShape<order>         &shape,
                                    const ElementKinematics<order> &element,
                                    const double                    jacobian,
                                    const Stiffness                &stiffness,
                                    const double        damping_time,
                                    const NodeVelocity *velocities,
                                    double             *force)
    {
      double power = 0;
      for (int g = 0; g < order; ++g)
        {
          const Kinematics &point = element.points[g];
          const Rates r = rates(shape, g, 1 / jacobian, point, velocities);
          const ViscousResultants s =
            viscous_resultants(point, stiffness, damping_time, r);
          const SpaceVector couple =
            dealii::cross_product_3d(s.force, point.slope);
          const double weight = shape.weight[g] * jacobian;
          power += weight * (s.force * r.gamma + s.moment * r.kappa);
          for (int a = 0; a <= order; ++a)
            for (int i = 0; i < 3; ++i)
              {
                const double derivative =
                  shape.weight[g] * shape.derivative[g][a];
                force[n_components * a + i] += derivative * s.force[i];
                force[n_components * a + 3 + i] += derivative * s.moment[i] +
                  weight * shape.value[g][a] * couple[i];
              }
        }
      return power;
    }

    /** By what the spins of the nodes turn the section at a Gauss point. */
    template <int order>
    struct SectionSpin
    {
      SpaceTensor by_spin[order + 1];

      SectionSpin(const BeamShape<order>     &shape,
                  const int                   g,
                  const Kinematics           &point,
                  const NodeOperators<order> &nodes)
      {
        const SpaceTensor T =
          transpose(tangent_operator(point.coefficients, point.psi));
        SpaceTensor by_middle = plus_identity(SpaceTensor(), 1.);
        for (int a = 0; a <= order; ++a)
          {
            by_spin[a] = shape.value[g][a] * T * nodes.psi_by_spin[a];
            by_middle -= by_spin[a];
          }
        for (int end = 0; end < 2; ++end)
          by_spin[end] += by_middle * nodes.middle_by_spin[end];
      }
    };

    /** Adds block @p tensor at @p position of a square matrix of @p n rows. */
    inline void
    add_block(const SpaceTensor &tensor, const int n, double *position)
    {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          position[i * n + j] += tensor[i][j];
    }

    /**
     * Adds the tangent of the damping force to @p matrix: @p stiffness_factor
     * dF/d(u, theta) + dF/d(v, omega) d(v, omega), where displacements change v
     * by @p damping_factor and spins change omega by
     * @p angular_velocity_by_spin (order + 1 nodes).
     */
    template <int order>
    inline void add_damping_tangent(const BeamShape<order>         &shape,
                                    const ElementKinematics<order> &element,
                                    const double                    jacobian,
                                    const Stiffness                &stiffness,
                                    const double        damping_time,
                                    const NodeVelocity *velocities,
                                    const double        stiffness_factor,
                                    const double        damping_factor,
                                    const SpaceTensor *angular_velocity_by_spin,
                                    double            *matrix)
    {
      constexpr int              n = n_components * (order + 1);
      const NodeOperators<order> operators(element.relative);
      for (int g = 0; g < order; ++g)
        {
          const Kinematics &point = element.points[g];
          const Rates r = rates(shape, g, 1 / jacobian, point, velocities);
          const ViscousResultants s =
            viscous_resultants(point, stiffness, damping_time, r);
          const ViscousStiffness by_rates =
            viscous_stiffness(point, stiffness, damping_time);
          const SectionSpin<order> spin(shape, g, point, operators);

          const SpaceTensor slope_cross = cross_product_tensor(point.slope);
          const SpaceTensor force_by_rotation = stiffness_factor *
            (by_rates.by_gamma * cross_product_tensor(r.gamma) -
             cross_product_tensor(s.force)),
                            moment_by_rotation = stiffness_factor *
            (by_rates.by_kappa * cross_product_tensor(r.kappa) -
             cross_product_tensor(s.moment)),
                            force_by_omega = by_rates.by_gamma * slope_cross;
          const SpaceTensor force_by_slope = by_rates.by_gamma *
            plus_identity(-stiffness_factor * cross_product_tensor(r.angular),
                          damping_factor);
          const SpaceTensor couple_by_slope =
            stiffness_factor * cross_product_tensor(s.force) -
            slope_cross * force_by_slope;
          const double weight = shape.weight[g] * jacobian;
          for (int b = 0; b <= order; ++b)
            {
              const double Nb          = shape.value[g][b],
                           Db          = shape.derivative[g][b] / jacobian;
              const SpaceTensor &omega = angular_velocity_by_spin[b];
              const SpaceTensor  force = force_by_rotation * spin.by_spin[b] +
                Nb * force_by_omega * omega,
                                moment = moment_by_rotation * spin.by_spin[b] +
                Db * by_rates.by_kappa * omega,
                                couple = -1. * slope_cross * force;
              for (int a = 0; a <= order; ++a)
                {
                  const double Na = weight * shape.value[g][a],
                               Da = shape.weight[g] * shape.derivative[g][a];
                  double *block   = matrix + n_components * (a * n + b);
                  add_block(Da * Db * force_by_slope, n, block);
                  add_block(Da * force, n, block + 3);
                  add_block(Na * Db * couple_by_slope, n, block + 3 * n);
                  add_block(Da * moment + Na * couple, n, block + 3 * n + 3);
                }
            }
        }
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
