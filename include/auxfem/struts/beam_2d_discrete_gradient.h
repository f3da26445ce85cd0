#ifndef auxfem_struts_beam_2d_discrete_gradient_h
#define auxfem_struts_beam_2d_discrete_gradient_h

#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/struts/beam_2d_tangent.h>
#include <auxfem/struts/beam_dispatch.h>

/**
 * @file
 * Mean forces of Beam2D over a step from state 0 to state 1 that conserve
 * energy and momenta. They use the algorithmic strain operators of Simo, Tarnow
 * & Doblare (1995) and Romero & Armero (2002) in the plane. With a bar for
 * means over the step, a delta for increments and d = (phi_1 - phi_0) / 2,
 * @code
 * stress      = C (E_0 + E_1) / 2 + beta C delta E / dt
 * d(epsilon)  = (t_0 + t_1)/2 . dr' + (n_0 + n_1)/2 . rbar' dphi_g
 * d(gamma)    = (n_0 + n_1)/2 . dr' - (t_0 + t_1)/2 . rbar' dphi_g
 * @endcode
 * Cayley's measure 2 tan d describes rotations. With subscripts a for nodes, g
 * for Gauss points and d_r = (d_first + d_last) / 2 of the ends,
 * @code
 * dphi_r = sum_ends cos(d_a) dphi_a / sum_ends cos(d_a)
 * c_a    = cos(d_a) cos(d_r) / sinc(d_a - d_r)
 * dphi_g = dphi_r + sinc(d_g - d_r) / (cos(d_g) cos(d_r)) *
 *            sum_a N_a c_a (dphi_a - dphi_r)
 * dkappa = sum_a N_a' c_a (dphi_a - dphi_r)
 * @endcode
 * For dr = delta r and dphi_a = 2 tan d_a these are exactly the strain
 * increments; for rigid motions they vanish.
 */
namespace auxfem
{
  namespace Beam2D
  {
    /** A Gauss point at the start of a step. */
    template <class Number>
    struct PointAtStartOf
    {
      StrainsOf<Number> strains;
      Number            cosine, sine; ///< direction of t
      Number            x, y;         ///< r'
    };

    /** Element at the start of a step; all iterations of the step share it. */
    template <int order, class Number = double>
    struct StepStart
    {
      /** Leaves the values unset. */
      StepStart() = default;

      /** Start of a step with displacements @p u. */
      StepStart(const BeamShape<order> &shape,
                const FrameOf<Number>  *frames,
                const Number            jacobian,
                const Number           *u)
      {
        std::copy(u, u + 3 * (order + 1), displacements);
        for (int g = 0; g < order; ++g)
          {
            const FrameOf<Number>   &frame = frames[g];
            const GradientOf<Number> d =
              interpolate(shape, g, Number(1 / jacobian), u);
            const KinematicsOf<Number> k = kinematics<true>(frame, d);
            points[g]                    = {{k.epsilon, k.gamma, k.kappa},
                                            k.cosine,
                                            k.sine,
                                            frame.axial * frame.cosine - frame.shear * frame.sine +
                                              d.ux,
                                            frame.axial * frame.sine + frame.shear * frame.cosine +
                                              d.uy};
          }
      }

      Number                 displacements[3 * (order + 1)];
      PointAtStartOf<Number> points[order];
    };

    /** Increments of the displacements of an element in a step. */
    template <int order, class Number = double>
    struct NodeIncrements
    {
      /** @param u0, u1 displacements at the start and the end */
      NodeIncrements(const Number *u0, const Number *u1)
      {
        Number cosines[order + 1];
        for (int a = 0; a <= order; ++a)
          {
            x[a]       = u1[3 * a] - u0[3 * a];
            y[a]       = u1[3 * a + 1] - u0[3 * a + 1];
            half[a]    = (u1[3 * a + 2] - u0[3 * a + 2]) / 2;
            cosines[a] = small_angle_cosine(half[a]);
          }
        reference        = (half[0] + half[1]) / 2;
        reference_cosine = small_angle_cosine(reference);
        // Both ends have the same distance from their mean.
        const Number end_factor =
          reference_cosine / sinc(Number(half[0] - reference));
        for (int end = 0; end < 2; ++end)
          c[end] = cosines[end] * end_factor;
        for (int a = 2; a <= order; ++a)
          c[a] =
            cosines[a] * reference_cosine / sinc(Number(half[a] - reference));
        end_shares[0] = cosines[0] / (cosines[0] + cosines[1]);
        end_shares[1] = 1 - end_shares[0];
      }

      Number x[order + 1], y[order + 1];  ///< translation increments
      Number half[order + 1];             ///< d_a
      Number reference, reference_cosine; ///< d_r
      Number c[order + 1];                ///< c_a
      Number end_shares[2];               ///< dphi_r by dphi_a
    };

    /** Increments at a Gauss point. */
    template <class Number>
    struct PointIncrementsOf
    {
      template <int order>
      PointIncrementsOf(const BeamShape<order>              &shape,
                        const int                            g,
                        const Number                         inverse_jacobian,
                        const NodeIncrements<order, Number> &nodes)
      {
        for (int a = 0; a <= order; ++a)
          {
            x += shape.derivative[g][a] * nodes.x[a];
            y += shape.derivative[g][a] * nodes.y[a];
            kappa += shape.rotation_derivative[g][a] * nodes.half[a];
            half += shape.value[g][a] * nodes.half[a];
          }
        x *= inverse_jacobian;
        y *= inverse_jacobian;
        kappa *= 2 * inverse_jacobian;
      }

      Number x = 0, y = 0; ///< increment of r'
      Number kappa = 0;
      Number half  = 0; ///< d_g
    };

    /** Kinematics of a Gauss point over a step. */
    template <class Number>
    struct StepKinematicsOf
    {
      StrainsOf<Number> start, increment;
      /** Means of t, n = (-sine, cosine) over the step; not unit vectors. */
      Number cosine, sine;
      Number half_cosine;   ///< cos(d_g), the length of these means
      Number x, y;          ///< mean of r'
      Number stretch, slip; ///< mean of r' times the means of t and n

      StrainsOf<Number> end() const
      {
        return {start.epsilon + increment.epsilon,
                start.gamma + increment.gamma,
                start.kappa + increment.kappa};
      }
    };

    template <class Number>
    inline StepKinematicsOf<Number>
    step_kinematics(const PointAtStartOf<Number>    &start,
                    const PointIncrementsOf<Number> &d)
    {
      StepKinematicsOf<Number> k;
      k.start                = start.strains;
      const Number half_sine = d.half * sinc(d.half);
      k.half_cosine          = small_angle_cosine(d.half);
      k.cosine =
        k.half_cosine * (k.half_cosine * start.cosine - half_sine * start.sine);
      k.sine =
        k.half_cosine * (k.half_cosine * start.sine + half_sine * start.cosine);
      k.x       = start.x + d.x / 2;
      k.y       = start.y + d.y / 2;
      k.stretch = k.cosine * k.x + k.sine * k.y;
      k.slip    = k.cosine * k.y - k.sine * k.x;

      // Increments avoid the cancellation of strain differences and need no
      // sine and cosine at the end.
      const Number turn = 2 * half_sine / k.half_cosine;
      k.increment       = {k.cosine * d.x + k.sine * d.y + k.slip * turn,
                           k.cosine * d.y - k.sine * d.x - k.stretch * turn,
                           d.kappa};
      return k;
    }

    /** Ratio of the rotation of a Gauss point relative to d_r to its
     * interpolation with the c_a. */
    template <int order, class Number>
    inline Number rotation_scale(const NodeIncrements<order, Number> &nodes,
                                 const PointIncrementsOf<Number>     &point,
                                 const StepKinematicsOf<Number>      &k)
    {
      return sinc(Number(point.half - nodes.reference)) /
        (k.half_cosine * nodes.reference_cosine);
    }

    /** Derivatives of the rotation at a Gauss point and of its slope by nodal
     * rotations over a step. */
    template <int order, class Number>
    struct RotationShapes
    {
      RotationShapes(const BeamShape<order>              &shape,
                     const int                            g,
                     const NodeIncrements<order, Number> &increments,
                     const Number                         scale)
      {
        Number sum = 0, slope = 0;
        for (int a = 0; a <= order; ++a)
          {
            value[a]      = shape.value[g][a] * increments.c[a] * scale;
            derivative[a] = shape.rotation_derivative[g][a] * increments.c[a];
            sum += value[a];
            slope += derivative[a];
          }
        for (int end = 0; end < 2; ++end)
          {
            value[end] += increments.end_shares[end] * (1 - sum);
            derivative[end] -= increments.end_shares[end] * slope;
          }
      }

      Number value[order + 1];      ///< dphi_g by dphi_a
      Number derivative[order + 1]; ///< dkappa_g by dphi_a, times J
    };

    /** Adds damping forces from the strain increment over @p dt (s); returns
     * the energy dissipated in the step (J/m). */
    template <class Number>
    inline Number add_damping(const StepKinematicsOf<Number> &k,
                              const StiffnessOf<Number>      &stiffness,
                              const double                    dt,
                              ForcesOf<Number>               &forces)
    {
      const Number rate = stiffness.damping_time / dt;
      const Number N    = rate * stiffness.axial * k.increment.epsilon,
                   Q    = rate * stiffness.shear * k.increment.gamma,
                   M    = rate * stiffness.bending * k.increment.kappa;
      forces.axial += N;
      forces.shear += Q;
      forces.bending += M;
      return N * k.increment.epsilon + Q * k.increment.gamma +
        M * k.increment.kappa;
    }

    /** Adds the forces of @p damping at Gauss point @p g; returns its numerical
     * dissipation in the step (J/m). */
    template <class Number>
    inline Number add_damping(const StepKinematicsOf<Number>   &k,
                              const StiffnessOf<Number>        &stiffness,
                              const IncrementDampingOf<Number> &damping,
                              const int                         g,
                              ForcesOf<Number>                 &forces)
    {
      const StrainsOf<Number> &d = k.increment;
      const Number             N = stiffness.axial * damping(3 * g, d.epsilon),
                   Q = stiffness.shear * damping(3 * g + 1, d.gamma),
                   M = stiffness.bending * damping(3 * g + 2, d.kappa);
      forces.axial += N;
      forces.shear += Q;
      forces.bending += M;
      return N * d.epsilon + Q * d.gamma + M * d.kappa;
    }

    /** Strain energy at the end of a step, energy dissipated in it and
     * numerical dissipation by IncrementDamping (J). */
    template <class Number>
    struct StepEnergyOf
    {
      Number strain = 0, dissipation = 0, numerical_dissipation = 0;
    };

    /**
     * Mean force of an element over a step; arguments as in internal_force().
     * @param u1 displacements at the end
     * @param dt length of the step (s), used only if @p damped
     */
    template <int  order,
              bool damped,
              class Number,
              class Section,
              class HighFrequencyDamping = NoIncrementDamping>
    inline StepEnergyOf<Number>
    mean_force(const BeamShape<order>                      &shape,
               const Number                                 jacobian,
               const Section                               &section,
               const StepStart<order, Number>              &start,
               const Number                                *u1,
               const double                                 dt,
               Number                                      *force,
               [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      StepEnergyOf<Number>                energy;
      const Number                        inverse_jacobian = 1 / jacobian;
      const NodeIncrements<order, Number> increments(start.displacements, u1);
      // Moments conjugate to (dphi_a - dphi_r) / c_a and to a common rotation
      // of all nodes.
      Number by_rotations[order + 1] = {}, on_common_rotation = 0;
      for (int i = 0; i < 3 * (order + 1); ++i)
        force[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const PointIncrementsOf<Number> point(shape,
                                                g,
                                                inverse_jacobian,
                                                increments);
          const StepKinematicsOf<Number>  k =
            step_kinematics(start.points[g], point);
          const ResponseOf<Number> response =
            section.mean(g, k.start, k.increment);
          ForcesOf<Number> mean   = response.forces;
          const double     w      = shape.weight[g];
          const Number     weight = w * jacobian;
          energy.strain += weight * response.stored;
          if (damped)
            energy.dissipation +=
              weight * add_damping(k, section.stiffness, dt, mean);
          if constexpr (HighFrequencyDamping::is_used)
            energy.numerical_dissipation +=
              weight * add_damping(k, section.stiffness, damping, g, mean);
          const Number fx = w * (k.cosine * mean.axial - k.sine * mean.shear),
                       fy = w * (k.sine * mean.axial + k.cosine * mean.shear),
                       m  = weight *
            (mean.axial * k.slip - mean.shear * k.stretch);
          const Number by_value   = m * rotation_scale(increments, point, k),
                       by_bending = w * mean.bending;
          for (int a = 0; a <= order; ++a)
            {
              force[3 * a] += shape.derivative[g][a] * fx;
              force[3 * a + 1] += shape.derivative[g][a] * fy;
              by_rotations[a] += shape.rotation_derivative[g][a] * by_bending +
                shape.value[g][a] * by_value;
            }
          on_common_rotation += m;
        }
      for (int a = 0; a <= order; ++a)
        {
          force[3 * a + 2] = increments.c[a] * by_rotations[a];
          on_common_rotation -= force[3 * a + 2];
        }
      for (int end = 0; end < 2; ++end)
        force[3 * end + 2] += increments.end_shares[end] * on_common_rotation;
      return energy;
    }

    /**
     * Derivative of mean_force() by @p u1, without the derivative of the
     * rotation shapes, which vanishes with the rotation increment. It is not
     * symmetric: rows belong to the mean configuration, columns to the end.
     * @param stiffness_factor, damping_factor derivatives of mean strains and
     *   strain rates by strains at the end
     */
    template <int  order,
              bool damped,
              class Number,
              class Section,
              class HighFrequencyDamping = NoIncrementDamping>
    inline void
    mean_tangent(const BeamShape<order>                      &shape,
                 const FrameOf<Number>                       *frames,
                 const Number                                 jacobian,
                 const Section                               &section,
                 const StepStart<order, Number>              &start,
                 const Number                                *u1,
                 const double                                 dt,
                 const double                                 stiffness_factor,
                 const double                                 damping_factor,
                 Number                                      *matrix,
                 [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      constexpr int n                = 3 * (order + 1);
      const Number  inverse_jacobian = 1 / jacobian;
      // Derivative of the added stress over the elastic stiffness.
      [[maybe_unused]] Number added =
        damped ? section.stiffness.damping_time * damping_factor : Number(0);
      if constexpr (HighFrequencyDamping::is_used)
        added += damping.tangent_factor;
      const NodeIncrements<order, Number> increments(start.displacements, u1);
      for (int i = 0; i < n * n; ++i)
        matrix[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const PointIncrementsOf<Number> point(shape,
                                                g,
                                                inverse_jacobian,
                                                increments);
          const StepKinematicsOf<Number>  k =
            step_kinematics(start.points[g], point);
          const auto linearized =
            section.mean_linearized(g, k.start, k.increment);
          ForcesOf<Number> mean = linearized.forces;
          if (damped)
            add_damping(k, section.stiffness, dt, mean);
          if constexpr (HighFrequencyDamping::is_used)
            add_damping(k, section.stiffness, damping, g, mean);
          // Derivatives of mean N, Q and M by the strains at the end.
          const auto by_strain = [&](const Number &mean_stiffness,
                                     const Number &elastic) {
            return stiffness_factor * mean_stiffness + added * elastic;
          };
          const auto  &law = linearized.stiffness;
          const Number EA  = by_strain(law.axial, section.stiffness.axial),
                       GA  = by_strain(law.shear, section.stiffness.shear),
                       EI  = by_strain(law.bending, section.stiffness.bending);
          // Derivatives of mean N and Q by x', y' and phi at the end.
          const Number c                = 2 * k.cosine - start.points[g].cosine,
                       s                = 2 * k.sine - start.points[g].sine;
          const StrainsOf<Number> end   = k.end();
          const Number            dN[3] = {EA * c,
                                           EA * s,
                                           EA * (end.gamma + frames[g].shear)},
                       dQ[3]            = {-GA * s,
                                           GA * c,
                                           -GA * (end.epsilon + frames[g].axial)};
          Number G[3][3];
          for (int j = 0; j < 3; ++j)
            {
              G[0][j] = k.cosine * dN[j] - k.sine * dQ[j];
              G[1][j] = k.sine * dN[j] + k.cosine * dQ[j];
              G[2][j] = k.slip * dN[j] - k.stretch * dQ[j];
            }
          // The means of t and n rotate by half of the rotation at the end.
          const Number along = c * k.x + s * k.y, across = c * k.y - s * k.x;
          const Number N = stiffness_factor * mean.axial,
                       Q = stiffness_factor * mean.shear;
          G[0][2] -= N * s + Q * c;
          G[1][2] += N * c - Q * s;
          G[2][0] -= N * k.sine + Q * k.cosine;
          G[2][1] += N * k.cosine - Q * k.sine;
          G[2][2] -= N * along + Q * across;

          const RotationShapes<order, Number> rotation(
            shape,
            g,
            increments,
            rotation_scale(increments, point, k));
          const double w       = shape.weight[g];
          const Number bending = w * inverse_jacobian * EI;
          for (int a = 0; a <= order; ++a)
            for (int b = 0; b <= order; ++b)
              {
                const double slope = shape.derivative[g][a];
                const Number dd =
                  w * inverse_jacobian * slope * shape.derivative[g][b];
                const double dv = w * slope * shape.value[g][b];
                const Number vd =
                  w * rotation.value[a] * shape.derivative[g][b];
                const Number vv =
                  w * jacobian * rotation.value[a] * shape.value[g][b];
                Number *block = matrix + 3 * a * n + 3 * b;
                for (int i = 0; i < 2; ++i)
                  {
                    for (int j = 0; j < 2; ++j)
                      block[n * i + j] += dd * G[i][j];
                    block[n * i + 2] += dv * G[i][2];
                    block[2 * n + i] += vd * G[2][i];
                  }
                block[2 * n + 2] += vv * G[2][2] +
                  bending * rotation.derivative[a] *
                    shape.rotation_derivative[g][b];
              }
          if constexpr (std::decay_t<decltype(law)>::can_couple)
            if (law.is_coupled)
              add_couplings(law,
                            Number(w * jacobian * stiffness_factor),
                            StrainOperator<order, Number>(shape,
                                                          g,
                                                          jacobian,
                                                          k.cosine,
                                                          k.sine,
                                                          k.stretch,
                                                          k.slip,
                                                          rotation.value,
                                                          rotation.derivative),
                            StrainOperator<order, Number>(
                              shape,
                              g,
                              jacobian,
                              c,
                              s,
                              Number(end.epsilon + frames[g].axial),
                              Number(end.gamma + frames[g].shear),
                              shape.value[g],
                              shape.rotation_derivative[g]),
                            matrix);
        }
    }
  } // namespace Beam2D
} // namespace auxfem

#endif
