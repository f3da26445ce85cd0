#ifndef auxfem_struts_beam_3d_damping_h
#define auxfem_struts_beam_3d_damping_h

#include <auxfem/struts/beam_3d_tangent.h>

namespace auxfem
{
  namespace Beam3D
  {
    /**
     * @file
     * Stiffness-proportional damping of the beam in space: section forces and
     * moments are those of the strains plus beta times the strain rates. With
     * the notation of Beam3D and a dot for the rate,
     *
     *     R Gamma. = v' + r' x omega,   R K. = omega',
     *
     * where v and the angular velocity omega are interpolated from the nodes.
     * The rate of the interpolated rotation differs by the interpolation error.
     * In a rigid motion both rates vanish. The damping forces are the
     * derivatives of half their power by the velocities and are in equilibrium.
     * The small-displacement form uses small_displacement_force() of beta times
     * the velocities.
     */

    /** Velocity of a node, both parts in the global frame. */
    template <class Number>
    struct NodeVelocityOf
    {
      VectorOf<Number> linear, angular; ///< m/s, rad/s
    };
    using NodeVelocity = NodeVelocityOf<double>;

    /** Rates at a Gauss point, in the global frame. */
    template <class Number>
    struct RatesOf
    {
      VectorOf<Number> gamma, kappa; ///< R Gamma., R K. = omega'
      VectorOf<Number> angular;      ///< omega
    };
    using Rates = RatesOf<double>;

    template <int order, class Number>
    inline RatesOf<Number> rates(const BeamShape<order>       &shape,
                                 const int                     g,
                                 const Number                  inverse_jacobian,
                                 const KinematicsOf<Number>   &point,
                                 const NodeVelocityOf<Number> *velocities)
    {
      RatesOf<Number> r;
      for (int a = 0; a <= order; ++a)
        {
          r.gamma +=
            shape.derivative[g][a] * inverse_jacobian * velocities[a].linear;
          r.angular += shape.value[g][a] * velocities[a].angular;
          r.kappa += shape.rotation_derivative[g][a] * inverse_jacobian *
            velocities[a].angular;
        }
      r.gamma += dealii::cross_product_3d(point.slope, r.angular);
      return r;
    }

    /** Section force and moment of damping in the global frame. */
    template <class Number>
    struct ViscousResultantsOf
    {
      VectorOf<Number> force, moment;
    };
    using ViscousResultants = ViscousResultantsOf<double>;

    template <class Number>
    inline ViscousResultantsOf<Number>
    viscous_resultants(const KinematicsOf<Number> &point,
                       const StiffnessOf<Number>  &stiffness,
                       const Number                damping_time,
                       const RatesOf<Number>      &r)
    {
      return {damping_time *
                (point.axes * section_force(stiffness, r.gamma * point.axes)),
              damping_time *
                (point.axes * section_moment(stiffness, r.kappa * point.axes))};
    }

    /** Derivatives of the resultants by the rates, in the global frame. */
    template <class Number>
    struct ViscousStiffnessOf
    {
      TensorOf<Number> by_gamma, by_kappa;
    };
    using ViscousStiffness = ViscousStiffnessOf<double>;

    template <class Number>
    inline ViscousStiffnessOf<Number>
    viscous_stiffness(const KinematicsOf<Number> &point,
                      const StiffnessOf<Number>  &stiffness,
                      const Number                damping_time)
    {
      const VectorOf<Number> ones({damping_time, damping_time, damping_time});
      return {with_principal_values(point.axes, section_force(stiffness, ones)),
              with_principal_values(point.axes,
                                    section_moment(stiffness, ones))};
    }

    /**
     * Adds the damping force of an element to @p force.
     * @param damping_time beta (s)
     * @param velocities velocities of order + 1 nodes
     * @return dissipated power (W)
     */
    template <int order, class Number>
    inline Number
    add_damping_force(const BeamShape<order>                 &shape,
                      const ElementKinematics<order, Number> &element,
                      const Number                            jacobian,
                      const StiffnessOf<Number>              &stiffness,
                      const Number                            damping_time,
                      const NodeVelocityOf<Number>           *velocities,
                      Number                                 *force)
    {
      Number power = 0;
      for (int g = 0; g < order; ++g)
        {
          const KinematicsOf<Number> &point = element.points[g];
          const RatesOf<Number>       r =
            rates(shape, g, 1 / jacobian, point, velocities);
          const ViscousResultantsOf<Number> s =
            viscous_resultants(point, stiffness, damping_time, r);
          const VectorOf<Number> couple =
            dealii::cross_product_3d(s.force, point.slope);
          const Number weight = shape.weight[g] * jacobian;
          power += weight * (s.force * r.gamma + s.moment * r.kappa);
          for (int a = 0; a <= order; ++a)
            for (int i = 0; i < 3; ++i)
              {
                const double w = shape.weight[g];
                force[n_components * a + i] +=
                  w * shape.derivative[g][a] * s.force[i];
                force[n_components * a + 3 + i] +=
                  w * shape.rotation_derivative[g][a] * s.moment[i] +
                  weight * shape.value[g][a] * couple[i];
              }
        }
      return power;
    }

    /** Derivative of the section rotation at a Gauss point by nodal spins. */
    template <int order, class Number = double>
    struct SectionSpin
    {
      TensorOf<Number> by_spin[order + 1];

      SectionSpin(const BeamShape<order>             &shape,
                  const int                           g,
                  const KinematicsOf<Number>         &point,
                  const NodeOperators<order, Number> &nodes)
      {
        const TensorOf<Number> T =
          transpose(tangent_operator(point.coefficients, point.psi));
        TensorOf<Number> by_middle =
          plus_identity(TensorOf<Number>(), Number(1));
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
    template <class Number>
    inline void
    add_block(const TensorOf<Number> &tensor, const int n, Number *position)
    {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          position[i * n + j] += tensor[i][j];
    }

    /**
     * Adds the tangent of the damping force to @p matrix: @p stiffness_factor
     * dF/d(u, theta) + dF/d(v, omega) d(v, omega). Displacements change v by @p
     * damping_factor, and spins change omega by @p angular_velocity_by_spin
     * (order + 1 nodes).
     */
    template <int order, class Number>
    inline void
    add_damping_tangent(const BeamShape<order>                 &shape,
                        const ElementKinematics<order, Number> &element,
                        const Number                            jacobian,
                        const StiffnessOf<Number>              &stiffness,
                        const Number                            damping_time,
                        const NodeVelocityOf<Number>           *velocities,
                        const double            stiffness_factor,
                        const double            damping_factor,
                        const TensorOf<Number> *angular_velocity_by_spin,
                        Number                 *matrix)
    {
      constexpr int                      n = n_components * (order + 1);
      const NodeOperators<order, Number> operators(element.relative);
      for (int g = 0; g < order; ++g)
        {
          const KinematicsOf<Number> &point = element.points[g];
          const RatesOf<Number>       r =
            rates(shape, g, 1 / jacobian, point, velocities);
          const ViscousResultantsOf<Number> s =
            viscous_resultants(point, stiffness, damping_time, r);
          const ViscousStiffnessOf<Number> by_rates =
            viscous_stiffness(point, stiffness, damping_time);
          const SectionSpin<order, Number> spin(shape, g, point, operators);

          const TensorOf<Number> slope_cross =
            cross_product_tensor(point.slope);
          const TensorOf<Number> force_by_rotation = stiffness_factor *
            (by_rates.by_gamma * cross_product_tensor(r.gamma) -
             cross_product_tensor(s.force)),
                                 moment_by_rotation = stiffness_factor *
            (by_rates.by_kappa * cross_product_tensor(r.kappa) -
             cross_product_tensor(s.moment)),
                                 force_by_omega =
                                   by_rates.by_gamma * slope_cross;
          const TensorOf<Number> force_by_slope = by_rates.by_gamma *
            plus_identity(-stiffness_factor * cross_product_tensor(r.angular),
                          Number(damping_factor));
          const TensorOf<Number> couple_by_slope =
            stiffness_factor * cross_product_tensor(s.force) -
            slope_cross * force_by_slope;
          const Number weight = shape.weight[g] * jacobian;
          for (int b = 0; b <= order; ++b)
            {
              const double Nb = shape.value[g][b];
              const Number Db = shape.derivative[g][b] / jacobian,
                           Rb = shape.rotation_derivative[g][b] / jacobian;
              const TensorOf<Number> &omega = angular_velocity_by_spin[b];
              const TensorOf<Number>  force =
                                       force_by_rotation * spin.by_spin[b] +
                Nb * force_by_omega * omega,
                                     moment =
                                       moment_by_rotation * spin.by_spin[b] +
                Rb * by_rates.by_kappa * omega,
                                     couple = -1. * slope_cross * force;
              for (int a = 0; a <= order; ++a)
                {
                  const Number Na = weight * shape.value[g][a];
                  const double Da = shape.weight[g] * shape.derivative[g][a],
                               Ra = shape.weight[g] *
                    shape.rotation_derivative[g][a];
                  Number *block = matrix + n_components * (a * n + b);
                  add_block(Da * Db * force_by_slope, n, block);
                  add_block(Da * force, n, block + 3);
                  add_block(Na * Db * couple_by_slope, n, block + 3 * n);
                  add_block(Ra * moment + Na * couple, n, block + 3 * n + 3);
                }
            }
        }
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
