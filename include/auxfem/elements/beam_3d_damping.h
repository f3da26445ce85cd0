#ifndef auxfem_elements_beam_3d_damping_h
#define auxfem_elements_beam_3d_damping_h

#include <auxfem/elements/beam_3d.h>

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
     *     R Gamma. = v' + 2 r' x vec(c.),   R K. = 2 vec(k. - c. k),
     *
     * where angular velocities omega_a take the place of spins in c. and k..
     * The small-displacement form has the damping force
     * small_displacement_force() of beta times the velocities.
     */

    /** Velocity of a node, both parts in the global frame. */
    struct NodeVelocity
    {
      SpaceVector linear, angular; ///< m/s, rad/s
    };

    /** Rates at a Gauss point. */
    struct Rates
    {
      SpaceVector slope;        ///< v'
      Quaternion  c, k;         ///< c., k.
      SpaceVector gamma, kappa; ///< R Gamma., R K.
    };

    template <int order>
    inline Rates rates(const BeamShape<order>  &shape,
                       const int                g,
                       const double             inverse_jacobian,
                       const Kinematics<order> &point,
                       const NodeVelocity      *velocities)
    {
      Rates r{{}, {0, {}}, {0, {}}, {}, {}};
      for (int a = 0; a <= order; ++a)
        {
          const Quaternion dc =
            Quaternion{0, 0.5 * velocities[a].angular} * point.relative[a];
          r.slope +=
            shape.derivative[g][a] * inverse_jacobian * velocities[a].linear;
          r.c = r.c + point.value[a] * dc;
          r.k = r.k + point.derivative[a] * dc;
        }
      r.gamma = r.slope + gamma_variation(point, r.c);
      r.kappa = kappa_variation(point, r.c, r.k);
      return r;
    }

    /**
     * Adds the damping force of an element to @p force.
     * @param damping_time beta (s)
     * @param velocities of order + 1 nodes
     * @return power lost (W)
     */
    template <int order>
    inline double add_damping_force(const BeamShape<order> &shape,
                                    const Frame            *frames,
                                    const double            jacobian,
                                    const Stiffness        &stiffness,
                                    const double            damping_time,
                                    const Node             *nodes,
                                    const NodeVelocity     *velocities,
                                    double                 *force)
    {
      double     power     = 0;
      const auto rotations = aligned_rotations<order>(nodes);
      for (int g = 0; g < order; ++g)
        {
          const Kinematics<order> point =
            kinematics(shape, g, 1 / jacobian, frames[g], nodes, rotations);
          const Rates r = rates(shape, g, 1 / jacobian, point, velocities);
          const SectionTensors section = section_tensors(point, stiffness);
          const Resultants     s = {damping_time * section.force * r.gamma,
                                    damping_time * section.moment * r.kappa};
          power += shape.weight[g] * jacobian *
            (s.force * r.gamma + s.moment * r.kappa);
          add_nodal_forces(shape, g, jacobian, point, s, force);
        }
      return power;
    }

    /**
     * Variation of R Gamma. by the variation @p c at fixed nodal velocities,
     * less what the variation of c. itself adds.
     */
    template <int order>
    inline SpaceVector gamma_rate_variation(const Kinematics<order> &point,
                                            const Rates             &r,
                                            const Quaternion        &c)
    {
      using dealii::cross_product_3d;
      const SpaceVector &w = point.slope, &d = c.vector, &rate = r.c.vector;
      return 2. * cross_product_3d(r.slope, d) -
        2 * r.c.scalar * cross_product_3d(w, d) -
        2 * c.scalar * cross_product_3d(w, rate) + 2 * (w * rate) * d +
        2 * (w * d) * rate - 4 * (d * rate) * w;
    }

    /** The same of R K. by @p c and @p k. */
    template <int order>
    inline SpaceVector kappa_rate_variation(const Kinematics<order> &point,
                                            const Rates             &r,
                                            const Quaternion        &c,
                                            const Quaternion        &k)
    {
      const auto by_c = [&point](const Quaternion &q) {
        return point.k.scalar * q.vector +
          dealii::cross_product_3d(q.vector, point.k.vector);
      };
      return 4 * (c.scalar * r.c.scalar - c.vector * r.c.vector) *
        point.k.vector +
        4 * r.c.scalar * by_c(c) + 4 * c.scalar * by_c(r.c) -
        2. * (r.c * k).vector - 2. * (c * r.k).vector;
    }

    /**
     * Variation of section force and moment of damping: factors times those by
     * motion and by velocity.
     */
    template <int order>
    inline ResultantVariation<order>
    damping_variation(const Kinematics<order> &point,
                      const SectionTensors    &section,
                      const Rates             &r,
                      const NodeVelocity      *velocities,
                      const SpinVariation     *spins,
                      const double             stiffness_factor,
                      const double             damping_factor,
                      const SpaceTensor       *angular_velocity_by_spin)
    {
      ResultantVariation<order> variation;
      SpaceTensor               by_slope =
        -2 * stiffness_factor * cross_product_tensor(r.c.vector);
      for (int i = 0; i < 3; ++i)
        by_slope[i][i] += damping_factor;
      variation.force_by_slope = section.force * by_slope;
      for (int a = 0; a <= order; ++a)
        {
          SpaceTensor gamma, kappa;
          for (int j = 0; j < 3; ++j)
            {
              const Quaternion &c = spins[a].c[j], &k = spins[a].k[j];
              // Of c. and k. by the node's own quaternion
              const Quaternion half_velocity{0, 0.5 * velocities[a].angular};
              const Quaternion own =
                half_velocity * half_unit_spin(j) * point.relative[a];
              const Quaternion own_c = point.value[a] * own,
                               own_k = point.derivative[a] * own;
              set_column(gamma,
                         j,
                         gamma_rate_variation(point, r, c) +
                           gamma_variation(point, own_c));
              set_column(kappa,
                         j,
                         kappa_rate_variation(point, r, c, k) +
                           kappa_variation(point, own_c, own_k));
            }
          variation.force[a] = section.force *
            (stiffness_factor * gamma +
             spins[a].gamma * angular_velocity_by_spin[a]);
          variation.moment[a] = section.moment *
            (stiffness_factor * kappa +
             spins[a].kappa * angular_velocity_by_spin[a]);
        }
      return variation;
    }

    /**
     * Adds the tangent of the damping force to @p matrix: @p stiffness_factor
     * dF/d(u, theta) + dF/d(v, omega) d(v, omega), where displacements change v
     * by @p damping_factor and spins change omega by
     * @p angular_velocity_by_spin (order + 1 nodes).
     */
    template <int order>
    inline void add_damping_tangent(const BeamShape<order> &shape,
                                    const Frame            *frames,
                                    const double            jacobian,
                                    const Stiffness        &stiffness,
                                    const double            damping_time,
                                    const Node             *nodes,
                                    const NodeVelocity     *velocities,
                                    const double            stiffness_factor,
                                    const double            damping_factor,
                                    const SpaceTensor *angular_velocity_by_spin,
                                    double            *matrix)
    {
      const auto rotations = aligned_rotations<order>(nodes);
      for (int g = 0; g < order; ++g)
        {
          const Kinematics<order> point =
            kinematics(shape, g, 1 / jacobian, frames[g], nodes, rotations);
          const Rates    r = rates(shape, g, 1 / jacobian, point, velocities);
          SectionTensors section = section_tensors(point, stiffness);
          section.force *= damping_time;
          section.moment *= damping_time;
          SpinVariation spins[order + 1];
          for (int a = 0; a <= order; ++a)
            spins[a] = spin_variation(point, a);
          add_tangent(shape,
                      g,
                      jacobian,
                      point,
                      spins,
                      damping_variation(point,
                                        section,
                                        r,
                                        velocities,
                                        spins,
                                        stiffness_factor,
                                        damping_factor,
                                        angular_velocity_by_spin),
                      {section.force * r.gamma, section.moment * r.kappa},
                      stiffness_factor,
                      matrix);
        }
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
