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
          const Resultants s        = resultants(point, stiffness);
          const Quaternion gradient = energy_gradient(point, s);
          const double     weight   = shape.weight[g] * jacobian;
          energy += weight * energy_density(stiffness, point.strains);
          for (int a = 0; a <= order; ++a)
            {
              const SpaceVector moment = weight *
                node_moment(node_gradient(point, a, gradient, s.moment),
                            point.relative[a]);
              for (int i = 0; i < 3; ++i)
                {
                  force[n_components * a + i] +=
                    shape.weight[g] * shape.derivative[g][a] * s.force[i];
                  force[n_components * a + 3 + i] += moment[i];
                }
            }
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
    geometric_stiffness(const Kinematics<order> &point,
                        const Resultants        &s,
                        const Quaternion        &gradient)
    {
      const double torque = 4 * (s.moment * point.k.vector);
      return {s.force,
              s.moment,
              point.slope,
              torque,
              -4 * (s.force * point.slope) - torque,
              2. * dealii::cross_product_3d(s.force, point.slope) -
                2. * gradient.vector};
    }

    /** Variations at a Gauss point by the three spins of one node. */
    struct SpinVariation
    {
      Quaternion  c[3], k[3];
      SpaceTensor gamma, kappa; ///< R dGamma and R dK, a column each spin
      /** Of the derivatives of the energy by c, k and r' (a column each). */
      Quaternion  gradient_c[3], gradient_k[3];
      SpaceTensor force;
    };

    template <int order>
    inline SpinVariation spin_variation(const Kinematics<order>  &point,
                                        const int                 a,
                                        const GeometricStiffness &geometric,
                                        const SpaceTensor        &turned)
    {
      SpinVariation v;
      for (int j = 0; j < 3; ++j)
        {
          Quaternion half_spin{0, {}};
          half_spin.vector[j] = 0.5;
          const Quaternion dc = half_spin * point.relative[a];
          v.c[j]              = point.value[a] * dc;
          v.k[j]              = point.derivative[a] * dc;
          v.gradient_c[j] =
            geometric.by_c_and_c(v.c[j]) + geometric.by_c_and_k(v.k[j]);
          v.gradient_k[j] = geometric.by_k_and_c(v.c[j]);

          const SpaceVector gamma =
            2. * dealii::cross_product_3d(point.slope, v.c[j].vector);
          const SpaceVector kappa =
            2. * (v.k[j].vector - (v.c[j] * point.k).vector);
          const SpaceVector force =
            turned * gamma + geometric.by_slope_and_c(v.c[j]);
          for (int i = 0; i < 3; ++i)
            {
              v.gamma[i][j] = gamma[i];
              v.kappa[i][j] = kappa[i];
              v.force[i][j] = force[i];
            }
        }
      return v;
    }

    /** Second derivative of the energy per length by spins of two nodes. */
    inline SpaceTensor spin_stiffness(const SpinVariation &a,
                                      const SpinVariation &b,
                                      const SpaceTensor   &turned_force,
                                      const SpaceTensor   &turned_moment)
    {
      SpaceTensor result =
        dealii::transpose(a.gamma) * (turned_force * b.gamma) +
        dealii::transpose(a.kappa) * (turned_moment * b.kappa);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result[i][j] +=
            dot(a.c[i], b.gradient_c[j]) + dot(a.k[i], b.gradient_k[j]);
      return result;
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
          const Resultants         s        = resultants(point, stiffness);
          const Quaternion         gradient = energy_gradient(point, s);
          const GeometricStiffness geometric =
            geometric_stiffness(point, s, gradient);
          const SpaceTensor turned_force =
            with_principal_values(point.axes,
                                  section_force(stiffness,
                                                SpaceVector({1., 1., 1.})));
          const SpaceTensor turned_moment =
            with_principal_values(point.axes,
                                  section_moment(stiffness,
                                                 SpaceVector({1., 1., 1.})));
          SpinVariation spins[order + 1];
          double        derivative[order + 1];
          for (int a = 0; a <= order; ++a)
            {
              spins[a]      = spin_variation(point, a, geometric, turned_force);
              derivative[a] = shape.derivative[g][a] / jacobian;
            }
          const double weight = factor * shape.weight[g] * jacobian;
          for (int a = 0; a <= order; ++a)
            for (int b = 0; b <= order; ++b)
              {
                SpaceTensor by_spins = spin_stiffness(spins[a],
                                                      spins[b],
                                                      turned_force,
                                                      turned_moment);
                if (a == b)
                  by_spins += own_spin_stiffness(
                    node_gradient(point, a, gradient, s.moment),
                    point.relative[a]);
                double *block = matrix + n_components * (a * n + b);
                for (int i = 0; i < 3; ++i)
                  for (int j = 0; j < 3; ++j)
                    {
                      block[i * n + j] += weight * derivative[a] *
                        derivative[b] * turned_force[i][j];
                      block[i * n + 3 + j] +=
                        weight * derivative[a] * spins[b].force[i][j];
                      block[(3 + i) * n + j] +=
                        weight * derivative[b] * spins[a].force[j][i];
                      block[(3 + i) * n + 3 + j] += weight * by_spins[i][j];
                    }
              }
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
