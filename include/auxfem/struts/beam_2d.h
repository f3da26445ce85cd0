#ifndef auxfem_struts_beam_2d_h
#define auxfem_struts_beam_2d_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/struts/beam_shape.h>

#include <algorithm>

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
      /** Whether the type has stiffnesses between unlike strains. */
      static constexpr bool can_couple = false;

      Number axial, shear, bending;
      Number damping_time;
    };
    using Stiffness = StiffnessOf<double>;

    /** Section stiffness of a law. */
    template <class Number>
    struct CoupledStiffnessOf : public StiffnessOf<Number>
    {
      static constexpr bool can_couple = true;

      /** Whether forces depend on other strains than their own. */
      bool is_coupled = false;
      /** Derivatives of N by gamma (N), N and Q by kappa (N m); symmetric. */
      Number axial_shear = 0, axial_bending = 0, shear_bending = 0;
    };

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
  } // namespace Beam2D
} // namespace auxfem

#endif
