#ifndef auxfem_elements_beam_3d_h
#define auxfem_elements_beam_3d_h

#include <auxfem/elements/beam_3d_strains.h>

namespace auxfem
{
  namespace Beam3D
  {
    /** Derivative of the energy per length by sum c_a N_a / |sum N_b p_b|. */
    template <int order>
    inline Quaternion energy_gradient(const Kinematics<order> &point,
                                      const Resultants        &s)
    {
      return {-2 * (s.moment * point.k.vector),
              2. * dealii::cross_product_3d(s.force, point.slope) -
                2 * point.k.scalar * s.moment +
                2. * dealii::cross_product_3d(s.moment, point.k.vector)};
    }

    /** Derivative of the energy per length by c_a. */
    template <int order>
    inline Quaternion node_gradient(const Kinematics<order> &point,
                                    const int                a,
                                    const Quaternion        &gradient,
                                    const SpaceVector       &moment)
    {
      return point.value[a] * gradient +
        2 * point.derivative[a] * Quaternion{0, moment};
    }

    /** Moment on a node: g . dc_a = moment . theta_a. */
    inline SpaceVector node_moment(const Quaternion &g, const Quaternion &c)
    {
      return 0.5 * (g * conjugate(c)).vector;
    }

    /** Adds the nodal forces of @p s at Gauss point @p g to @p force. */
    template <int order>
    inline void add_nodal_forces(const BeamShape<order>  &shape,
                                 const int                g,
                                 const double             jacobian,
                                 const Kinematics<order> &point,
                                 const Resultants        &s,
                                 double                  *force)
    {
      const Quaternion gradient = energy_gradient(point, s);
      const double     weight   = shape.weight[g] * jacobian;
      for (int a = 0; a <= order; ++a)
        {
          const SpaceVector moment =
            node_moment(node_gradient(point, a, gradient, s.moment),
                        point.relative[a]);
          for (int i = 0; i < 3; ++i)
            {
              force[n_components * a + i] +=
                shape.weight[g] * shape.derivative[g][a] * s.force[i];
              force[n_components * a + 3 + i] += weight * moment[i];
            }
        }
    }

    /**
     * Internal force of an element.
     * @param frames order Gauss points
     * @param jacobian half the element's length (m)
     * @param nodes order + 1 nodes
     * @param force receives 6 (order + 1) nodal forces and moments
     * @return strain energy (J)
     */
    template <int order>
    inline double internal_force(const BeamShape<order> &shape,
                                 const Frame            *frames,
                                 const double            jacobian,
                                 const Stiffness        &stiffness,
                                 const Node             *nodes,
                                 double                 *force)
    {
      double     energy    = 0;
      const auto rotations = aligned_rotations<order>(nodes);
      for (int i = 0; i < n_components * (order + 1); ++i)
        force[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const Kinematics<order> point =
            kinematics(shape, g, 1 / jacobian, frames[g], nodes, rotations);
          energy += shape.weight[g] * jacobian *
            energy_density(stiffness, point.strains);
          add_nodal_forces(shape,
                           g,
                           jacobian,
                           point,
                           resultants(point, stiffness),
                           force);
        }
      return energy;
    }

    /**
     * Second derivatives of the energy per length at constant section force and
     * moment, by r', c = sum c_a N_a / |sum N_b p_b| and k.
     */
    struct GeometricStiffness
    {
      SpaceVector force, moment, slope;
      double      scalar, vector; ///< twice by scalar or by vector part of c
      SpaceVector mixed;          ///< once by each

      /** By c and c, applied to @p c. */
      Quaternion by_c_and_c(const Quaternion &c) const
      {
        return {scalar * c.scalar + mixed * c.vector,
                c.scalar * mixed + 2 * (slope * c.vector) * force +
                  2 * (force * c.vector) * slope + vector * c.vector};
      }

      /** By c and k, applied to @p k. */
      Quaternion by_c_and_k(const Quaternion &k) const
      {
        return {-2 * (moment * k.vector),
                -2 * k.scalar * moment +
                  2. * dealii::cross_product_3d(moment, k.vector)};
      }

      /** By k and c, applied to @p c. */
      Quaternion by_k_and_c(const Quaternion &c) const
      {
        return {-2 * (moment * c.vector),
                -2 * c.scalar * moment +
                  2. * dealii::cross_product_3d(c.vector, moment)};
      }

      /** By r' and c, applied to @p c. */
      SpaceVector by_slope_and_c(const Quaternion &c) const
      {
        return 2. * dealii::cross_product_3d(c.vector, force);
      }
    };

    template <int order>
    inline GeometricStiffness
    geometric_stiffness(const Kinematics<order> &point, const Resultants &s)
    {
      const double torque = 4 * (s.moment * point.k.vector);
      return {s.force,
              s.moment,
              point.slope,
              torque,
              -4 * (s.force * point.slope) - torque,
              2. * dealii::cross_product_3d(s.force, point.slope) -
                2. * energy_gradient(point, s).vector};
    }

    /** Variations at a Gauss point by the three spins of one node. */
    struct SpinVariation
    {
      Quaternion  c[3], k[3];
      SpaceTensor gamma, kappa; ///< R dGamma and R dK, a column each spin
    };

    /** Sets column @p j of a matrix. */
    inline void
    set_column(SpaceTensor &matrix, const int j, const SpaceVector &column)
    {
      for (int i = 0; i < 3; ++i)
        matrix[i][j] = column[i];
    }

    /** A spin of 1 about axis @p j, as the quaternion that halves it. */
    inline Quaternion half_unit_spin(const int j)
    {
      Quaternion spin{0, {}};
      spin.vector[j] = 0.5;
      return spin;
    }

    /** R dGamma by a variation @p c at constant r'. */
    template <int order>
    inline SpaceVector gamma_variation(const Kinematics<order> &point,
                                       const Quaternion        &c)
    {
      return 2. * dealii::cross_product_3d(point.slope, c.vector);
    }

    /** R dK by variations @p c and @p k. */
    template <int order>
    inline SpaceVector kappa_variation(const Kinematics<order> &point,
                                       const Quaternion        &c,
                                       const Quaternion        &k)
    {
      return 2. * (k.vector - (c * point.k).vector);
    }

    template <int order>
    inline SpinVariation spin_variation(const Kinematics<order> &point,
                                        const int                a)
    {
      SpinVariation v;
      for (int j = 0; j < 3; ++j)
        {
          const Quaternion dc = half_unit_spin(j) * point.relative[a];
          v.c[j]              = point.value[a] * dc;
          v.k[j]              = point.derivative[a] * dc;
          set_column(v.gamma, j, gamma_variation(point, v.c[j]));
          set_column(v.kappa, j, kappa_variation(point, v.c[j], v.k[j]));
        }
      return v;
    }

    /**
     * Variations of section force and moment in the frame of the section, but
     * in global components (R dN, R dM).
     */
    template <int order>
    struct ResultantVariation
    {
      SpaceTensor force_by_slope;                      ///< by r'
      SpaceTensor force[order + 1], moment[order + 1]; ///< by the nodes' spins
    };

    /** Stiffness of a section in global components. */
    struct SectionTensors
    {
      SpaceTensor force, moment;
    };

    template <int order>
    inline SectionTensors section_tensors(const Kinematics<order> &point,
                                          const Stiffness         &stiffness)
    {
      const SpaceVector ones({1., 1., 1.});
      return {with_principal_values(point.axes, section_force(stiffness, ones)),
              with_principal_values(point.axes,
                                    section_moment(stiffness, ones))};
    }

    /**
     * What the second variation of a node's own quaternion adds: from
     * d(theta c / 2) = theta (dtheta c / 2) / 2, a multiple of the identity and
     * half the cross product with the moment on the node.
     */
    inline SpaceTensor own_spin_stiffness(const Quaternion &g,
                                          const Quaternion &c)
    {
      SpaceTensor result = -0.5 * cross_product_tensor(node_moment(g, c));
      for (int i = 0; i < 3; ++i)
        result[i][i] = -0.25 * dot(g, c);
      return result;
    }

    /** Second derivative of the energy at constant resultants, by spins. */
    inline SpaceTensor spin_stiffness(const GeometricStiffness &geometric,
                                      const SpinVariation      &a,
                                      const SpinVariation      &b)
    {
      SpaceTensor result;
      for (int j = 0; j < 3; ++j)
        {
          const Quaternion by_c =
            geometric.by_c_and_c(b.c[j]) + geometric.by_c_and_k(b.k[j]);
          const Quaternion by_k = geometric.by_k_and_c(b.c[j]);
          for (int i = 0; i < 3; ++i)
            result[i][j] = dot(a.c[i], by_c) + dot(a.k[i], by_k);
        }
      return result;
    }

    /** The same by r' and spins. */
    inline SpaceTensor slope_stiffness(const GeometricStiffness &geometric,
                                       const SpinVariation      &b)
    {
      SpaceTensor result;
      for (int j = 0; j < 3; ++j)
        set_column(result, j, geometric.by_slope_and_c(b.c[j]));
      return result;
    }

    /** Adds block @p tensor times @p factor at @p position of a square matrix. */
    inline void add_block(const SpaceTensor &tensor,
                          const double       factor,
                          const int          n,
                          double            *position)
    {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          position[i * n + j] += factor * tensor[i][j];
    }

    /**
     * Adds the tangent at Gauss point @p g: the variation of the resultants and,
     * times @p geometric_factor, that of the kinematics at resultants @p s.
     */
    template <int order>
    inline void add_tangent(const BeamShape<order>          &shape,
                            const int                        g,
                            const double                     jacobian,
                            const Kinematics<order>         &point,
                            const SpinVariation             *spins,
                            const ResultantVariation<order> &variation,
                            const Resultants                &s,
                            const double                     geometric_factor,
                            double                          *matrix)
    {
      constexpr int            n         = n_components * (order + 1);
      const GeometricStiffness geometric = geometric_stiffness(point, s);
      const Quaternion         gradient  = energy_gradient(point, s);
      SpaceTensor              by_slope_and_spin[order + 1];
      for (int a = 0; a <= order; ++a)
        by_slope_and_spin[a] =
          geometric_factor * slope_stiffness(geometric, spins[a]);
      const double weight = shape.weight[g] * jacobian;
      for (int a = 0; a <= order; ++a)
        {
          const double      da    = shape.derivative[g][a] / jacobian;
          const SpaceTensor gamma = transpose(spins[a].gamma),
                            kappa = transpose(spins[a].kappa);
          const SpaceTensor by_slope =
            gamma * variation.force_by_slope + transpose(by_slope_and_spin[a]);
          for (int b = 0; b <= order; ++b)
            {
              const double db = shape.derivative[g][b] / jacobian;
              SpaceTensor  by_spins =
                spin_stiffness(geometric, spins[a], spins[b]);
              if (a == b)
                by_spins += own_spin_stiffness(
                  node_gradient(point, a, gradient, s.moment),
                  point.relative[a]);
              by_spins = geometric_factor * by_spins +
                gamma * variation.force[b] + kappa * variation.moment[b];

              double *block = matrix + n_components * (a * n + b);
              add_block(variation.force_by_slope, weight * da * db, n, block);
              add_block(variation.force[b] + by_slope_and_spin[b],
                        weight * da,
                        n,
                        block + 3);
              add_block(by_slope, weight * db, n, block + 3 * n);
              add_block(by_spins, weight, n, block + 3 * n + 3);
            }
        }
    }

    /**
     * Tangent stiffness @p factor dF/d(u, theta) of the internal force, row by
     * row into @p matrix (6 (order + 1) squared).
     */
    template <int order>
    inline void tangent(const BeamShape<order> &shape,
                        const Frame            *frames,
                        const double            jacobian,
                        const Stiffness        &stiffness,
                        const Node             *nodes,
                        const double            factor,
                        double                 *matrix)
    {
      constexpr int n         = n_components * (order + 1);
      const auto    rotations = aligned_rotations<order>(nodes);
      for (int i = 0; i < n * n; ++i)
        matrix[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const Kinematics<order> point =
            kinematics(shape, g, 1 / jacobian, frames[g], nodes, rotations);
          const SectionTensors      section = section_tensors(point, stiffness);
          SpinVariation             spins[order + 1];
          ResultantVariation<order> variation;
          variation.force_by_slope = factor * section.force;
          for (int a = 0; a <= order; ++a)
            {
              spins[a]            = spin_variation(point, a);
              variation.force[a]  = factor * section.force * spins[a].gamma;
              variation.moment[a] = factor * section.moment * spins[a].kappa;
            }
          add_tangent(shape,
                      g,
                      jacobian,
                      point,
                      spins,
                      variation,
                      resultants(point, stiffness),
                      factor,
                      matrix);
        }
    }

    /**
     * Strains of the small-displacement form, with unknowns @p u (displacement
     * and rotation vector node by node) and everything else at rest:
     * Gamma = R0^T (u' + r0' x theta), K = R0^T theta'.
     */
    template <int order>
    inline Strains small_displacement_strains(const BeamShape<order> &shape,
                                              const int               g,
                                              const Frame            *frames,
                                              const double            jacobian,
                                              const double           *u)
    {
      SpaceVector slope, rotation, curvature;
      for (int a = 0; a <= order; ++a)
        for (int i = 0; i < 3; ++i)
          {
            const double *node       = u + n_components * a;
            const double  derivative = shape.derivative[g][a] / jacobian;
            slope[i] += derivative * node[i];
            rotation[i] += shape.value[g][a] * node[3 + i];
            curvature[i] += derivative * node[3 + i];
          }
      const Frame &frame = frames[g];
      return {(slope + dealii::cross_product_3d(frame.slope, rotation)) *
                frame.axes,
              curvature * frame.axes};
    }

    /** Internal force of the small-displacement form; as internal_force(). */
    template <int order>
    inline double small_displacement_force(const BeamShape<order> &shape,
                                           const Frame            *frames,
                                           const double            jacobian,
                                           const Stiffness        &stiffness,
                                           const double           *u,
                                           double                 *force)
    {
      double energy = 0;
      for (int i = 0; i < n_components * (order + 1); ++i)
        force[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const Strains strain =
            small_displacement_strains(shape, g, frames, jacobian, u);
          const SpaceVector section =
            frames[g].axes * section_force(stiffness, strain.gamma);
          const SpaceVector moment =
            frames[g].axes * section_moment(stiffness, strain.kappa);
          const SpaceVector lever =
            dealii::cross_product_3d(section, frames[g].slope);
          const double weight = shape.weight[g] * jacobian;
          energy += weight * energy_density(stiffness, strain);
          for (int a = 0; a <= order; ++a)
            for (int i = 0; i < 3; ++i)
              {
                const double derivative =
                  shape.weight[g] * shape.derivative[g][a];
                force[n_components * a + i] += derivative * section[i];
                force[n_components * a + 3 + i] += derivative * moment[i] +
                  weight * shape.value[g][a] * lever[i];
              }
        }
      return energy;
    }

    /** Tangent of the small-displacement form: that of the exact one at rest.
     */
    template <int order>
    inline void small_displacement_tangent(const BeamShape<order> &shape,
                                           const Frame            *frames,
                                           const double            jacobian,
                                           const Stiffness        &stiffness,
                                           const double            factor,
                                           double                 *matrix)
    {
      const Node at_rest[order + 1] = {};
      tangent(shape, frames, jacobian, stiffness, at_rest, factor, matrix);
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
