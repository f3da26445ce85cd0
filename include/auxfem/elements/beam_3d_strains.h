#ifndef auxfem_elements_beam_3d_strains_h
#define auxfem_elements_beam_3d_strains_h

#include <auxfem/elements/beam_shape.h>
#include <auxfem/elements/rotation.h>

#include <array>

namespace auxfem
{
  /**
   * The geometrically exact beam in space of Simo (1985) and Simo & Vu-Quoc
   * (1986). Axis r(s); the section turns by P(s) from its axes R0 at rest to
   * R = P R0, of which 1 is normal to the section, 2 and 3 are in it. In
   * components along these axes,
   *
   *     Gamma = R^T r' - R0^T r0'       N = EA Gamma_1, Q_2 = kGA_2 Gamma_2,
   *                                     Q_3 = kGA_3 Gamma_3
   *     K     = R^T axial(P' P^T)       T = GJ K_1, M_2 = EI_2 K_2,
   *                                     M_3 = EI_3 K_3
   *
   * K is the change of curvature and torsion, so any curved and twisted strut
   * is free of stress at rest. M_3 bends the plane of axes 1 and 2, in which
   * Q_2 acts: with axis 3 along z this is Beam2D.
   *
   * The unit quaternions p_a of P at the nodes are interpolated by
   * p = sum N_a p_a / |sum N_a p_a| (Romero 2004, Computational Mechanics 34,
   * 121-133), for any order objective and a function of the state alone. P and
   * not R is interpolated: R0 at the Gauss points can then be that of the exact
   * axis, and small strains are not differences of numbers near one. Between
   * neighbouring nodes P must turn by less than a half turn.
   *
   * With ( ) a quaternion without scalar part, c_a = p_a p^-1, and k the
   * derivative of sum N_a c_a / |sum N_b p_b| by s, spins theta_a
   * (P_a <- exp(theta_a) P_a) vary these by dc_a = (theta_a) c_a / 2, and
   * at the point itself, where sum N_a c_a / |sum N_b p_b| = 1,
   *
   *     R K = 2 vec(k),   R dK = 2 vec(dk - dc k),
   *     R dGamma = dr' + 2 r' x vec(dc).
   *
   * Unknowns of an element: displacement and spin node by node,
   * u_x, u_y, u_z, theta_x, theta_y, theta_z. The tangent is the derivative of
   * the residual by spins; it is symmetric where moments at nodes balance.
   */
  namespace Beam3D
  {
    /** Undeformed axis at a Gauss point. */
    struct Frame
    {
      SpaceTensor axes;  ///< section axes 1, 2, 3 as columns
      SpaceVector slope; ///< r0', of unit length for a straight strut
    };

    /** Section stiffness: EA, kGA_2, kGA_3 (N); GJ, EI_2, EI_3 (N m2). */
    struct Stiffness
    {
      double axial, shear_2, shear_3;
      double torsion, bending_2, bending_3;
    };

    /** Motion of a node since rest. */
    struct Node
    {
      SpaceVector displacement; ///< m
      Quaternion  rotation;     ///< of unit norm
    };

    /** Strains in components along the section's axes. */
    struct Strains
    {
      SpaceVector gamma; ///< axial strain, shear strains along axes 2 and 3
      SpaceVector kappa; ///< torsion, curvature about axes 2 and 3 (1/m)
    };

    /** Unknowns of a node. */
    constexpr int n_components = 6;

    /** Kinematics at a Gauss point, in the notation above. */
    template <int order>
    struct Kinematics
    {
      Strains     strains;
      SpaceVector slope; ///< r'
      SpaceTensor axes;  ///< R
      Quaternion  k;
      /** c_a and its share in sum c_a N_a / |sum N_b p_b| and in k. */
      Quaternion relative[order + 1];
      double     value[order + 1], derivative[order + 1];
    };

    /**
     * The rotations of the nodes with signs such that neighbours along the axis
     * lie in one hemisphere.
     */
    template <int order>
    inline std::array<Quaternion, order + 1>
    aligned_rotations(const Node *nodes)
    {
      std::array<Quaternion, order + 1> rotations;
      rotations[0] = nodes[0].rotation;
      int before   = 0;
      for (int i = 1; i <= order; ++i)
        {
          // Both ends come before the inner nodes.
          const int a  = i == order ? 1 : i + 1;
          rotations[a] = nodes[a].rotation;
          if (dot(rotations[a], rotations[before]) < 0)
            rotations[a] = -1 * rotations[a];
          before = a;
        }
      return rotations;
    }

    template <int order>
    inline Kinematics<order>
    kinematics(const BeamShape<order>                  &shape,
               const int                                g,
               const double                             inverse_jacobian,
               const Frame                             &frame,
               const Node                              *nodes,
               const std::array<Quaternion, order + 1> &rotations)
    {
      Kinematics<order> point;
      SpaceVector       gradient;
      Quaternion        sum{0, {}};
      for (int a = 0; a <= order; ++a)
        {
          gradient +=
            shape.derivative[g][a] * inverse_jacobian * nodes[a].displacement;
          sum = sum + shape.value[g][a] * rotations[a];
        }
      const Quaternion rotation = normalized(sum);
      const Quaternion inverse  = conjugate(rotation);
      const double     scale    = 1 / dot(sum, rotation);
      point.k                   = {0, {}};
      for (int a = 0; a <= order; ++a)
        {
          point.value[a] = scale * shape.value[g][a];
          point.derivative[a] =
            scale * inverse_jacobian * shape.derivative[g][a];
          point.relative[a] = rotations[a] * inverse;
          point.k           = point.k + point.derivative[a] * point.relative[a];
        }
      point.slope = frame.slope + gradient;
      point.axes  = rotated(rotation, frame.axes);
      point.strains.gamma =
        (rotated(inverse, gradient) + rotation_change(inverse, frame.slope)) *
        frame.axes;
      point.strains.kappa = 2. * point.k.vector * point.axes;
      return point;
    }

    /**
     * Strains of an element at its Gauss point @p g.
     * @param jacobian half the element's length (m)
     */
    template <int order>
    inline Strains strains(const BeamShape<order> &shape,
                           const int               g,
                           const Frame            *frames,
                           const double            jacobian,
                           const Node             *nodes)
    {
      return kinematics(shape,
                        g,
                        1 / jacobian,
                        frames[g],
                        nodes,
                        aligned_rotations<order>(nodes))
        .strains;
    }

    /** Force N, Q_2, Q_3 (N) or moment T, M_2, M_3 (N m) from its strain. */
    inline SpaceVector section_force(const Stiffness   &stiffness,
                                     const SpaceVector &gamma)
    {
      return SpaceVector({stiffness.axial * gamma[0],
                          stiffness.shear_2 * gamma[1],
                          stiffness.shear_3 * gamma[2]});
    }

    /** @copydoc section_force */
    inline SpaceVector section_moment(const Stiffness   &stiffness,
                                      const SpaceVector &kappa)
    {
      return SpaceVector({stiffness.torsion * kappa[0],
                          stiffness.bending_2 * kappa[1],
                          stiffness.bending_3 * kappa[2]});
    }

    /** Strain energy per length (J/m). */
    inline double energy_density(const Stiffness &stiffness,
                                 const Strains   &strains)
    {
      return (strains.gamma * section_force(stiffness, strains.gamma) +
              strains.kappa * section_moment(stiffness, strains.kappa)) /
        2;
    }

    /** Section force and moment in the global frame. */
    struct Resultants
    {
      SpaceVector force, moment;
    };

    template <int order>
    inline Resultants resultants(const Kinematics<order> &point,
                                 const Stiffness         &stiffness)
    {
      return {point.axes * section_force(stiffness, point.strains.gamma),
              point.axes * section_moment(stiffness, point.strains.kappa)};
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
