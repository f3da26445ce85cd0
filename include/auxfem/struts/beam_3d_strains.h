#ifndef auxfem_struts_beam_3d_strains_h
#define auxfem_struts_beam_3d_strains_h

#include <auxfem/mathematics/rotation_operators.h>
#include <auxfem/struts/beam_shape.h>

#include <array>

namespace auxfem
{
  /**
   * The geometrically exact beam in space of Simo (1985) and Simo & Vu-Quoc
   * (1986). The section rotates by P(s) from its axes R0 at rest to R = P R0.
   * Axis 1 is normal to the section, axes 2 and 3 lie in it. With the beam axis
   * r(s), in section components,
   *
   *     Gamma = R^T r' - R0^T r0'       N = EA Gamma_1, Q_2 = kGA_2 Gamma_2,
   *                                     Q_3 = kGA_3 Gamma_3
   *     K     = R^T axial(P' P^T)       T = GJ K_1, M_2 = EI_2 K_2,
   *                                     M_3 = EI_3 K_3
   *
   * K is the change of curvature and torsion, so curved and twisted struts are
   * free of stress at rest. M_3 bends the plane of axes 1 and 2, in which Q_2
   * acts: with axis 3 along z this is Beam2D.
   *
   * P is interpolated as in Crisfield & Jelenic (1999, Proceedings of the Royal
   * Society A 455, 1125-1147), relative to the middle rotation P_r of the
   * element's ends:
   *
   *     P(s) = exp(psi(s)) P_r,  psi = sum N_a psi_a,  exp(psi_a) = P_a P_r^-1.
   *
   * The interpolation is objective and path-independent for any order; in a
   * plane it interpolates the angle. Interpolating P instead of R allows exact
   * axes R0 at the Gauss points and avoids cancellation in small strains. The
   * ends of an element must rotate by less than two half turns relative to each
   * other, neighbouring nodes by less than one.
   *
   * With T of rotation_operators.h the curvature is R K = exp(psi) T(psi) psi'.
   * Spins theta_a (P_a <- exp(theta_a) P_a) rotate P_r by
   *
   *     rho = V_0 theta_0 + V_1 theta_1,   V_0, V_1 = (I +- tau [chi]x) / 2,
   *     tau = tan(|chi| / 2) / |chi|,      chi = psi_1 = -psi_0,
   *
   * and change psi_a, in a frame that rotates with P_r, by T(-psi_a)^-1
   * (theta_a - rho).
   *
   * Unknowns of an element: u_x, u_y, u_z, theta_x, theta_y, theta_z node by
   * node, theta being the spin. The tangent is the derivative of the residual
   * by spins; it is symmetric where nodal moments balance. @p Number is double
   * or, for several elements at a time, Lanes.
   */
  namespace Beam3D
  {
    /** Undeformed axis at a Gauss point. */
    template <class Number>
    struct FrameOf
    {
      TensorOf<Number> axes;  ///< section axes 1, 2, 3 as columns
      VectorOf<Number> slope; ///< r0', of unit length for a straight strut
    };
    using Frame = FrameOf<double>;

    /** Section stiffness: EA, kGA_2, kGA_3 (N); GJ, EI_2, EI_3 (N m2). */
    template <class Number>
    struct StiffnessOf
    {
      /** Whether the type has stiffnesses between unlike strains. */
      static constexpr bool can_couple = false;

      Number axial, shear_2, shear_3;
      Number torsion, bending_2, bending_3;
    };
    using Stiffness = StiffnessOf<double>;

    /** Section stiffness of a law. */
    template <class Number>
    struct CoupledStiffnessOf : public StiffnessOf<Number>
    {
      static constexpr bool can_couple = true;

      /** Whether forces depend on other strains than their own; the tensors
       * then hold all derivatives, else they are unset. */
      bool is_coupled = false;
      /** Derivatives of forces by gamma (N) and by kappa (N m), and of moments
       * by kappa (N m2). */
      TensorOf<Number> by_gamma, gamma_by_kappa, by_kappa;
    };

    /** Motion of a node since rest. */
    template <class Number>
    struct NodeOf
    {
      VectorOf<Number>     displacement; ///< m
      QuaternionOf<Number> rotation;     ///< of unit norm
    };
    using Node = NodeOf<double>;

    /** Strains in components along the section's axes. */
    template <class Number>
    struct StrainsOf
    {
      /** Axial strain, shear strains along axes 2 and 3. */
      VectorOf<Number> gamma;
      VectorOf<Number> kappa; ///< torsion, curvature about axes 2 and 3 (1/m)
    };
    using Strains = StrainsOf<double>;

    /** Number of unknowns per node. */
    constexpr int n_components = 6;

    /** psi and its derivative by s at a point. */
    template <class Number>
    struct RelativeRotationOf
    {
      VectorOf<Number> psi, gradient;
    };

    /** Rotations of the nodes relative to the middle of the element's ends. */
    template <int order, class Number = double>
    struct RelativeRotations
    {
      QuaternionOf<Number> middle;         ///< P_r
      VectorOf<Number>     psi[order + 1]; ///< of the nodes (rad)

      explicit RelativeRotations(const NodeOf<Number> *nodes)
      {
        // Choose signs such that neighbours along the axis lie in one
        // hemisphere.
        QuaternionOf<Number> rotations[order + 1];
        rotations[0] = nodes[0].rotation;
        int before   = 0;
        for (int i = 1; i <= order; ++i)
          {
            // Both ends come before the inner nodes.
            const int a    = i == order ? 1 : i + 1;
            Number    sign = 1;
            where(dot(nodes[a].rotation, rotations[before]) < 0, sign) = -1;
            rotations[a] = sign * nodes[a].rotation;
            before       = a;
          }
        middle = normalized(rotations[0] + rotations[1]);
        const QuaternionOf<Number> inverse = conjugate(middle);
        for (int a = 0; a <= order; ++a)
          psi[a] = rotation_vector(rotations[a] * inverse);
      }

      /** Relative rotation at Gauss point @p g. */
      RelativeRotationOf<Number> at_point(const BeamShape<order> &shape,
                                          const int               g,
                                          const Number inverse_jacobian) const
      {
        RelativeRotationOf<Number> point;
        for (int a = 0; a <= order; ++a)
          {
            point.psi += shape.value[g][a] * psi[a];
            point.gradient +=
              shape.rotation_derivative[g][a] * inverse_jacobian * psi[a];
          }
        return point;
      }

      /** P at a point where the shape functions are @p values. */
      QuaternionOf<Number> at(const double *values) const
      {
        VectorOf<Number> p;
        for (int a = 0; a <= order; ++a)
          p += values[a] * psi[a];
        return exponential(p) * middle;
      }
    };

    /** Kinematics at a Gauss point, in the notation above. */
    template <class Number>
    struct KinematicsOf
    {
      StrainsOf<Number> strains;
      VectorOf<Number>  slope;         ///< r'
      VectorOf<Number>  psi, gradient; ///< psi, psi'
      TensorOf<Number>  axes;          ///< R
      TensorOf<Number>  middle_axes;   ///< P_r R0
      /** Coefficients of the rotation operators of psi. */
      RotationCoefficientsOf<Number> coefficients;
    };
    using Kinematics = KinematicsOf<double>;

    /** u' at Gauss point @p g. */
    template <int order, class Number>
    inline VectorOf<Number> displacement_slope(const BeamShape<order> &shape,
                                               const int               g,
                                               const Number inverse_jacobian,
                                               const NodeOf<Number> *nodes)
    {
      VectorOf<Number> slope;
      for (int a = 0; a <= order; ++a)
        slope +=
          shape.derivative[g][a] * inverse_jacobian * nodes[a].displacement;
      return slope;
    }

    template <int order, class Number>
    inline KinematicsOf<Number>
    kinematics(const BeamShape<order>                 &shape,
               const int                               g,
               const Number                            inverse_jacobian,
               const FrameOf<Number>                  &frame,
               const NodeOf<Number>                   *nodes,
               const RelativeRotations<order, Number> &relative)
    {
      const VectorOf<Number> stretch =
        displacement_slope(shape, g, inverse_jacobian, nodes);
      const auto [psi, gradient] =
        relative.at_point(shape, g, inverse_jacobian);
      const RotationCoefficientsOf<Number> c(psi);
      const QuaternionOf<Number>           turn     = exponential(psi);
      const QuaternionOf<Number>           rotation = turn * relative.middle,
                                 inverse            = conjugate(rotation);
      KinematicsOf<Number> point{{},
                                 frame.slope + stretch,
                                 psi,
                                 gradient,
                                 rotated(rotation, frame.axes),
                                 rotated(relative.middle, frame.axes),
                                 c};
      point.strains.gamma =
        (rotated(inverse, stretch) + rotation_change(inverse, frame.slope)) *
        frame.axes;
      point.strains.kappa =
        (tangent_operator(c, psi) * gradient) * point.middle_axes;
      return point;
    }

    /** Kinematics of an element, the input of its forces and tangents. */
    template <int order, class Number = double>
    struct ElementKinematics
    {
      RelativeRotations<order, Number>        relative;
      std::array<KinematicsOf<Number>, order> points; ///< Gauss points

      /**
       * @param frames order Gauss points
       * @param jacobian half the element's length (m)
       * @param nodes order + 1 nodes
       */
      ElementKinematics(const BeamShape<order> &shape,
                        const FrameOf<Number>  *frames,
                        const Number            jacobian,
                        const NodeOf<Number>   *nodes)
        : relative(nodes)
      {
        for (int g = 0; g < order; ++g)
          points[g] =
            kinematics(shape, g, 1 / jacobian, frames[g], nodes, relative);
      }
    };

    /** Force N, Q_2, Q_3 (N) or moment T, M_2, M_3 (N m) from its strain. */
    template <class Number>
    inline VectorOf<Number> section_force(const StiffnessOf<Number> &stiffness,
                                          const VectorOf<Number>    &gamma)
    {
      return VectorOf<Number>({stiffness.axial * gamma[0],
                               stiffness.shear_2 * gamma[1],
                               stiffness.shear_3 * gamma[2]});
    }

    /** @copydoc section_force */
    template <class Number>
    inline VectorOf<Number> section_moment(const StiffnessOf<Number> &stiffness,
                                           const VectorOf<Number>    &kappa)
    {
      return VectorOf<Number>({stiffness.torsion * kappa[0],
                               stiffness.bending_2 * kappa[1],
                               stiffness.bending_3 * kappa[2]});
    }

    /** Strain energy per length (J/m). */
    template <class Number>
    inline Number energy_density(const StiffnessOf<Number> &stiffness,
                                 const StrainsOf<Number>   &strains)
    {
      return (strains.gamma * section_force(stiffness, strains.gamma) +
              strains.kappa * section_moment(stiffness, strains.kappa)) /
        2;
    }

    /** Section force and moment in section axes: N, Q_2, Q_3 (N) and T, M_2,
     * M_3 (N m). */
    template <class Number>
    struct ForcesOf
    {
      VectorOf<Number> force, moment;
    };

    /** Section forces and the energy stored per length (J/m). */
    template <class Number>
    struct ResponseOf
    {
      ForcesOf<Number> forces;
      Number           stored;
    };

    /** Section forces and their derivatives by the strains. */
    template <class Number, class Stiffness = StiffnessOf<Number>>
    struct LinearizedOf
    {
      ForcesOf<Number> forces;
      Stiffness        stiffness;
    };

    /**
     * Linear elastic section. The kernels take the response of a section from a
     * class with these members; LawSection (struts/effects/law_section.h) is
     * the other one.
     */
    template <class Number>
    struct ElasticSection
    {
      const StiffnessOf<Number> &stiffness;

      /** Response at Gauss point @p g. */
      ResponseOf<Number> response(const int /*g*/,
                                  const StrainsOf<Number> &strains) const
      {
        return {elastic_forces(strains), energy_density(stiffness, strains)};
      }

      /** Linearized response at Gauss point @p g. */
      LinearizedOf<Number> linearized(const int /*g*/,
                                      const StrainsOf<Number> &strains) const
      {
        return {elastic_forces(strains), stiffness};
      }

      /** Mean forces over a step plus the elastic forces of the strains @p
       * added, and the energy stored at the end. */
      ResponseOf<Number> mean(const int                g,
                              const StrainsOf<Number> &start,
                              const StrainsOf<Number> &end,
                              const StrainsOf<Number> &added) const
      {
        return {mean_linearized(g, start, end, added).forces,
                energy_density(stiffness, end)};
      }

      /** Forces of mean() and twice their derivatives by the strains at the
       * end. */
      LinearizedOf<Number> mean_linearized(const int /*g*/,
                                           const StrainsOf<Number> &start,
                                           const StrainsOf<Number> &end,
                                           const StrainsOf<Number> &added) const
      {
        return {elastic_forces({0.5 * (start.gamma + end.gamma) + added.gamma,
                                0.5 * (start.kappa + end.kappa) + added.kappa}),
                stiffness};
      }

      /** Forces of @p strains by the elastic stiffness. */
      ForcesOf<Number> elastic_forces(const StrainsOf<Number> &strains) const
      {
        return {section_force(stiffness, strains.gamma),
                section_moment(stiffness, strains.kappa)};
      }
    };

    template <class Number>
    ElasticSection(const StiffnessOf<Number> &) -> ElasticSection<Number>;

    /** @p factor times @p one plus @p other_factor times @p other. */
    template <class Number, class Factor>
    inline StiffnessOf<Number> combined(const Factor              &factor,
                                        const StiffnessOf<Number> &one,
                                        const Number              &other_factor,
                                        const StiffnessOf<Number> &other)
    {
      const auto sum = [&](Number StiffnessOf<Number>::*entry) {
        return factor * one.*entry + other_factor * other.*entry;
      };
      using S = StiffnessOf<Number>;
      return {sum(&S::axial),
              sum(&S::shear_2),
              sum(&S::shear_3),
              sum(&S::torsion),
              sum(&S::bending_2),
              sum(&S::bending_3)};
    }

    /** @copydoc combined */
    template <class Number, class Factor>
    inline CoupledStiffnessOf<Number>
    combined(const Factor                     &factor,
             const CoupledStiffnessOf<Number> &one,
             const Number                     &other_factor,
             const StiffnessOf<Number>        &other)
    {
      CoupledStiffnessOf<Number> result;
      static_cast<StiffnessOf<Number> &>(result) =
        combined(factor,
                 static_cast<const StiffnessOf<Number> &>(one),
                 other_factor,
                 other);
      result.is_coupled = one.is_coupled;
      if (!one.is_coupled)
        return result;
      const VectorOf<Number> ones({1, 1, 1});
      result.gamma_by_kappa = factor * one.gamma_by_kappa;
      result.by_gamma       = factor * one.by_gamma;
      result.by_kappa       = factor * one.by_kappa;
      for (int i = 0; i < 3; ++i)
        {
          result.by_gamma[i][i] += other_factor * section_force(other, ones)[i];
          result.by_kappa[i][i] +=
            other_factor * section_moment(other, ones)[i];
        }
      return result;
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
