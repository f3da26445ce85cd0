#ifndef auxfem_struts_beam_2d_h
#define auxfem_struts_beam_2d_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/struts/beam_shape.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  /**
   * The planar geometrically exact beam of Reissner (1972) and Simo & Vu-Quoc
   * (1986), with axis r(s) and section rotation phi(s). With t, n the section
   * normal and in-plane direction, rotated by phi from t0, n0 at rest,
   *
   *     axial strain    epsilon = r'.t - r0'.t0        N = EA  epsilon
   *     shear strain    gamma   = r'.n - r0'.n0        Q = kGA gamma
   *     curvature       kappa   = phi'                 M = EI  kappa
   *
   * The virtual work is N d(epsilon) + Q d(gamma) + M d(kappa) with d(epsilon)
   * = dr'.t + (r'.n) dphi, d(gamma) = dr'.n - (r'.t) dphi. The
   * small-displacement form uses t, n and r' at rest. Unknowns of an element:
   * u_x, u_y, phi node by node. @p Number is double or, for several elements at
   * a time, Lanes.
   */
  namespace Beam2D
  {
    /** Undeformed axis at a Gauss point. */
    template <class Number>
    struct FrameOf
    {
      Number cosine, sine; ///< section normal t0 = (cosine, sine)
      /** Slope r0' in components along t0, n0: (1, 0) for a straight strut. */
      Number axial, shear;
    };
    using Frame = FrameOf<double>;

    /** Section stiffness (N, N, N m2) and retardation time of
     * stiffness-proportional damping (s). */
    template <class Number>
    struct StiffnessOf
    {
      Number axial, shear, bending;
      Number damping_time;
    };
    using Stiffness = StiffnessOf<double>;

    /** Strains at a point, or increments of strains. */
    template <class Number>
    struct StrainsOf
    {
      Number epsilon, gamma, kappa;
    };

    /** Section forces N, Q (N), M (N m). */
    template <class Number>
    struct ForcesOf
    {
      Number axial, shear, bending;
    };

    /** Section forces and the energy stored per length (J/m). */
    template <class Number>
    struct ResponseOf
    {
      ForcesOf<Number> forces;
      Number           stored;
    };

    /** Section forces and their derivatives by the conjugate strains. */
    template <class Number>
    struct LinearizedOf
    {
      ForcesOf<Number>    forces;
      StiffnessOf<Number> stiffness;
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
                                  const StrainsOf<Number> &e) const
      {
        const ForcesOf<Number> f = forces(e);
        return {
          f,
          (f.axial * e.epsilon + f.shear * e.gamma + f.bending * e.kappa) / 2};
      }

      /** Linearized response at Gauss point @p g. */
      LinearizedOf<Number> linearized(const int /*g*/,
                                      const StrainsOf<Number> &e) const
      {
        return {forces(e), stiffness};
      }

      /** Mean forces over a step and the energy stored at its end. */
      ResponseOf<Number> mean(const int /*g*/,
                              const StrainsOf<Number> &start,
                              const StrainsOf<Number> &increment) const
      {
        const StrainsOf<Number> end = {start.epsilon + increment.epsilon,
                                       start.gamma + increment.gamma,
                                       start.kappa + increment.kappa};
        return {mean_linearized(0, start, increment).forces,
                (stiffness.axial * end.epsilon * end.epsilon +
                 stiffness.shear * end.gamma * end.gamma +
                 stiffness.bending * end.kappa * end.kappa) /
                  2};
      }

      /** Mean forces and twice their derivatives by the strains at the end. */
      LinearizedOf<Number>
      mean_linearized(const int /*g*/,
                      const StrainsOf<Number> &start,
                      const StrainsOf<Number> &increment) const
      {
        return {forces({start.epsilon + increment.epsilon / 2,
                        start.gamma + increment.gamma / 2,
                        start.kappa + increment.kappa / 2}),
                stiffness};
      }

    private:
      ForcesOf<Number> forces(const StrainsOf<Number> &e) const
      {
        return {stiffness.axial * e.epsilon,
                stiffness.shear * e.gamma,
                stiffness.bending * e.kappa};
      }
    };

    template <class Number>
    ElasticSection(const StiffnessOf<Number> &) -> ElasticSection<Number>;

    /** Strains at a point and the kinematics that forces and tangents need. */
    template <class Number>
    struct KinematicsOf
    {
      Number epsilon, gamma, kappa;
      Number stretch, slip; ///< r'.t, r'.n
      Number cosine, sine;  ///< direction of t in the global frame

      StrainsOf<Number> strains() const
      {
        return {epsilon, gamma, kappa};
      }
    };
    using Kinematics = KinematicsOf<double>;

    /** Displacement gradient, rotation and curvature at a Gauss point. */
    template <class Number>
    struct GradientOf
    {
      Number ux, uy, phi, kappa;
    };
    using Gradient = GradientOf<double>;

    template <int order, class Number>
    inline GradientOf<Number> interpolate(const BeamShape<order> &shape,
                                          const int               g,
                                          const Number  inverse_jacobian,
                                          const Number *u)
    {
      GradientOf<Number> d{0, 0, 0, 0};
      for (int a = 0; a <= order; ++a)
        {
          d.ux += shape.derivative[g][a] * u[3 * a];
          d.uy += shape.derivative[g][a] * u[3 * a + 1];
          d.kappa += shape.rotation_derivative[g][a] * u[3 * a + 2];
          d.phi += shape.value[g][a] * u[3 * a + 2];
        }
      d.ux *= inverse_jacobian;
      d.uy *= inverse_jacobian;
      d.kappa *= inverse_jacobian;
      return d;
    }

    /** Strains from the displacement gradient. The form 1 - cos(phi) = 2
     * sin^2(phi/2) avoids cancellation in small strains. */
    template <bool large_rotation, class Number>
    inline KinematicsOf<Number> kinematics(const FrameOf<Number>    &frame,
                                           const GradientOf<Number> &d)
    {
      const Number p = frame.cosine * d.ux + frame.sine * d.uy,
                   q = frame.cosine * d.uy - frame.sine * d.ux;
      KinematicsOf<Number> k;
      k.kappa = d.kappa;
      if (large_rotation)
        {
          const auto [half_sine, half_cosine] =
            sine_and_cosine(Number(d.phi / 2));
          const Number s       = 2 * half_sine * half_cosine;
          const Number versine = 2 * half_sine * half_sine, c = 1 - versine;
          k.epsilon = p * c + q * s - frame.axial * versine + frame.shear * s;
          k.gamma   = q * c - p * s - frame.axial * s - frame.shear * versine;
          k.cosine  = frame.cosine * c - frame.sine * s;
          k.sine    = frame.sine * c + frame.cosine * s;
          k.stretch = k.epsilon + frame.axial;
          k.slip    = k.gamma + frame.shear;
        }
      else
        {
          k.epsilon = p + frame.shear * d.phi;
          k.gamma   = q - frame.axial * d.phi;
          k.cosine  = frame.cosine;
          k.sine    = frame.sine;
          k.stretch = frame.axial;
          k.slip    = frame.shear;
        }
      return k;
    }

    /** Strain rates from the velocity gradient @p v. */
    template <class Number>
    inline void strain_rates(const KinematicsOf<Number> &k,
                             const GradientOf<Number>   &v,
                             Number                     &epsilon,
                             Number                     &gamma)
    {
      epsilon = k.cosine * v.ux + k.sine * v.uy + k.slip * v.phi;
      gamma   = k.cosine * v.uy - k.sine * v.ux - k.stretch * v.phi;
    }

    /** Strain energy (J) and power lost to damping (W) of an element. */
    template <class Number>
    struct EnergyRateOf
    {
      Number strain = 0, dissipation = 0;
    };
    using EnergyRate = EnergyRateOf<double>;

    /**
     * Internal force of an element.
     * @param frames order Gauss points
     * @param jacobian half the element's length (m)
     * @param section response of the section, see ElasticSection
     * @param u displacements of the element, 3 (order + 1)
     * @param v velocities, used only if @p damped
     * @param force receives 3 (order + 1) nodal forces and moments
     */
    template <int  order,
              bool large_rotation,
              bool damped,
              class Number,
              class Section>
    inline EnergyRateOf<Number> internal_force(const BeamShape<order> &shape,
                                               const FrameOf<Number>  *frames,
                                               const Number            jacobian,
                                               const Section          &section,
                                               const Number           *u,
                                               const Number           *v,
                                               Number                 *force)
    {
      EnergyRateOf<Number> energy;
      const Number         inverse_jacobian     = 1 / jacobian;
      Number               sum[3 * (order + 1)] = {};
      for (int g = 0; g < order; ++g)
        {
          const KinematicsOf<Number> k = kinematics<large_rotation>(
            frames[g],
            interpolate(shape, g, inverse_jacobian, u));
          auto [forces, stored]         = section.response(g, k.strains());
          auto &[axial, shear, bending] = forces;
          const Number weight           = shape.weight[g] * jacobian;
          energy.strain += weight * stored;
          if constexpr (damped)
            {
              const StiffnessOf<Number> &stiffness = section.stiffness;
              const GradientOf<Number>   rate =
                interpolate(shape, g, inverse_jacobian, v);
              Number epsilon_rate, gamma_rate;
              strain_rates(k, rate, epsilon_rate, gamma_rate);
              const Number N = stiffness.damping_time * stiffness.axial *
                epsilon_rate,
                           Q = stiffness.damping_time * stiffness.shear *
                gamma_rate,
                           M = stiffness.damping_time * stiffness.bending *
                rate.kappa;
              energy.dissipation +=
                weight * (N * epsilon_rate + Q * gamma_rate + M * rate.kappa);
              axial += N;
              shear += Q;
              bending += M;
            }
          const double w  = shape.weight[g];
          const Number fx = w * (k.cosine * axial - k.sine * shear),
                       fy = w * (k.sine * axial + k.cosine * shear),
                       m  = w * jacobian * (axial * k.slip - shear * k.stretch);
          bending *= w;
          for (int a = 0; a <= order; ++a)
            {
              sum[3 * a] += shape.derivative[g][a] * fx;
              sum[3 * a + 1] += shape.derivative[g][a] * fy;
              sum[3 * a + 2] += shape.rotation_derivative[g][a] * bending +
                shape.value[g][a] * m;
            }
        }
      std::copy_n(sum, 3 * (order + 1), force);
      return energy;
    }

    /** Adds the geometric part of a section tangent: axial and shear force
     * rotate with the section. */
    template <class Number>
    inline void add_geometric_part(const KinematicsOf<Number> &k,
                                   const Number                axial,
                                   const Number                shear,
                                   Number (&G)[3][3])
    {
      G[0][2] -= shear;
      G[1][2] += axial;
      G[2][0] -= shear;
      G[2][1] += axial;
      G[2][2] -= axial * k.stretch + shear * k.slip;
    }

    /** Derivative of the section forces by (r'.t, r'.n, phi) at a Gauss point,
     * in the frame of the rotated section; rows and columns in this order. */
    template <bool large_rotation, bool damped, class Number>
    inline void section_tangent(const KinematicsOf<Number> &k,
                                const LinearizedOf<Number> &section,
                                const GradientOf<Number>   &velocity,
                                const double                stiffness_factor,
                                const double                damping_factor,
                                Number (&G)[3][3])
    {
      const StiffnessOf<Number> &stiffness = section.stiffness;
      const Number               beta = damped ? stiffness.damping_time : 0.;
      const Number material = stiffness_factor + beta * damping_factor;
      // Derivatives of N and Q by r'.t, r'.n, phi.
      Number dN[3] = {stiffness.axial * material,
                      0,
                      stiffness.axial * material * k.slip};
      Number dQ[3] = {0,
                      stiffness.shear * material,
                      -stiffness.shear * material * k.stretch};
      Number N = section.forces.axial, Q = section.forces.shear;
      if (damped)
        {
          Number epsilon_rate, gamma_rate;
          strain_rates(k, velocity, epsilon_rate, gamma_rate);
          N += beta * stiffness.axial * epsilon_rate;
          Q += beta * stiffness.shear * gamma_rate;
          if (large_rotation)
            {
              const Number vt = k.cosine * velocity.ux + k.sine * velocity.uy,
                           vn = k.cosine * velocity.uy - k.sine * velocity.ux,
                           omega = velocity.phi;
              const Number a     = beta * stiffness_factor * stiffness.axial,
                           s     = beta * stiffness_factor * stiffness.shear;
              dN[1] += a * omega;
              dN[2] += a * (vn - omega * k.stretch);
              dQ[0] -= s * omega;
              dQ[2] -= s * (vt + omega * k.slip);
            }
        }
      for (int j = 0; j < 3; ++j)
        {
          G[0][j] = dN[j];
          G[1][j] = dQ[j];
          G[2][j] = dN[j] * k.slip - dQ[j] * k.stretch;
        }
      if (large_rotation)
        add_geometric_part(k, stiffness_factor * N, stiffness_factor * Q, G);
    }

    /** Adds a Gauss point with its section tangent and bending stiffness to an
     * element tangent. */
    template <int order, class Number>
    inline void add_section(const BeamShape<order>     &shape,
                            const int                   g,
                            const Number                jacobian,
                            const KinematicsOf<Number> &k,
                            const Number (&G)[3][3],
                            const Number bending,
                            Number      *matrix)
    {
      constexpr int n                = 3 * (order + 1);
      const Number  inverse_jacobian = 1 / jacobian;
      // Section tangent in the global frame.
      const Number c = k.cosine, s = k.sine;
      const Number T[2][3] = {{c * G[0][0] - s * G[1][0],
                               c * G[0][1] - s * G[1][1],
                               c * G[0][2] - s * G[1][2]},
                              {s * G[0][0] + c * G[1][0],
                               s * G[0][1] + c * G[1][1],
                               s * G[0][2] + c * G[1][2]}};
      const Number xx      = c * T[0][0] - s * T[0][1],
                   xy      = s * T[0][0] + c * T[0][1],
                   yx      = c * T[1][0] - s * T[1][1],
                   yy      = s * T[1][0] + c * T[1][1],
                   zx      = c * G[2][0] - s * G[2][1],
                   zy      = s * G[2][0] + c * G[2][1];
      const double w       = shape.weight[g];
      for (int a = 0; a <= order; ++a)
        for (int b = 0; b <= order; ++b)
          {
            const Number dd = w * inverse_jacobian * shape.derivative[g][a] *
              shape.derivative[g][b],
                         dv = w * shape.derivative[g][a] * shape.value[g][b],
                         vd = w * shape.value[g][a] * shape.derivative[g][b],
                         vv =
                           w * jacobian * shape.value[g][a] * shape.value[g][b],
                         kk = w * inverse_jacobian *
              shape.rotation_derivative[g][a] * shape.rotation_derivative[g][b];
            Number *block = matrix + 3 * a * n + 3 * b;
            block[0] += dd * xx;
            block[1] += dd * xy;
            block[2] += dv * T[0][2];
            block[n] += dd * yx;
            block[n + 1] += dd * yy;
            block[n + 2] += dv * T[1][2];
            block[2 * n] += vd * zx;
            block[2 * n + 1] += vd * zy;
            block[2 * n + 2] += vv * G[2][2] + kk * bending;
          }
    }

    /** Tangent stiffness_factor * dF/du + damping_factor * dF/dv of the
     * internal force, row by row into @p matrix (3 (order + 1) squared). */
    template <int  order,
              bool large_rotation,
              bool damped,
              class Number,
              class Section>
    inline void tangent(const BeamShape<order> &shape,
                        const FrameOf<Number>  *frames,
                        const Number            jacobian,
                        const Section          &section,
                        const Number           *u,
                        const Number           *v,
                        const double            stiffness_factor,
                        const double            damping_factor,
                        Number                 *matrix)
    {
      constexpr int n                = 3 * (order + 1);
      const Number  inverse_jacobian = 1 / jacobian;
      for (int i = 0; i < n * n; ++i)
        matrix[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const KinematicsOf<Number> k = kinematics<large_rotation>(
            frames[g],
            interpolate(shape, g, inverse_jacobian, u));
          const GradientOf<Number>   rate = damped
              ? interpolate(shape, g, inverse_jacobian, v)
              : GradientOf<Number>{0, 0, 0, 0};
          const LinearizedOf<Number> linearized =
            section.linearized(g, k.strains());
          Number G[3][3];
          section_tangent<large_rotation, damped>(k,
                                                  linearized,
                                                  rate,
                                                  stiffness_factor,
                                                  damping_factor,
                                                  G);
          const StiffnessOf<Number> &stiffness = linearized.stiffness;
          const Number               bending   = stiffness.bending *
            (stiffness_factor +
             (damped ? stiffness.damping_time * damping_factor : 0.));

          add_section(shape, g, jacobian, k, G, bending, matrix);
        }
    }

    /** Geometric stiffness of section @p forces at the Gauss points (N and Q at
     * indices 0 and 1; M has no effect) at the displacements @p u. */
    template <int order, class Forces>
    inline void geometric_tangent(const BeamShape<order> &shape,
                                  const Frame            *frames,
                                  const double            jacobian,
                                  const double           *u,
                                  const Forces           *forces,
                                  double                 *matrix)
    {
      constexpr int n = 3 * (order + 1);
      std::fill(matrix, matrix + n * n, 0.);
      for (int g = 0; g < order; ++g)
        {
          const Kinematics k =
            kinematics<true>(frames[g], interpolate(shape, g, 1 / jacobian, u));
          double G[3][3] = {};
          add_geometric_part(k, forces[g][0], forces[g][1], G);
          add_section(shape, g, jacobian, k, G, /*bending=*/0., matrix);
        }
    }
  } // namespace Beam2D
} // namespace auxfem

#endif
