#ifndef auxfem_elements_beam_2d_between_h
#define auxfem_elements_beam_2d_between_h

#include <auxfem/elements/beam_2d.h>
#include <auxfem/elements/cayley_rotation.h>
#include <auxfem/elements/increment_damping.h>

/**
 * @file
 * Mean forces of Beam2D over a step from a state 0 to a state 1 that conserve
 * energy and momenta (algorithmic strain operators of Simo, Tarnow & Doblare
 * 1995 and Romero & Armero 2002, in the plane). With a bar for means over the
 * step, a delta for increments and d = (phi_1 - phi_0) / 2,
 * @code
 * stress      = C (E_0 + E_1) / 2 + beta C delta E / dt
 * d(epsilon)  = (t_0 + t_1)/2 . dr' + (n_0 + n_1)/2 . rbar' dphi_g
 * d(gamma)    = (n_0 + n_1)/2 . dr' - (t_0 + t_1)/2 . rbar' dphi_g
 * @endcode
 * Rotations are measured by Cayley's 2 tan d. With subscripts a for nodes, g
 * for Gauss points and d_r = (d_first + d_last) / 2 of the ends,
 * @code
 * dphi_r = sum_ends cos(d_a) dphi_a / sum_ends cos(d_a)
 * c_a    = cos(d_a) cos(d_r) / sinc(d_a - d_r)
 * dphi_g = dphi_r + sinc(d_g - d_r) / (cos(d_g) cos(d_r)) *
 *            sum_a N_a c_a (dphi_a - dphi_r)
 * dkappa = sum_a N_a' c_a (dphi_a - dphi_r)
 * @endcode
 * For dr = delta r, dphi_a = 2 tan d_a these are the increments of the strains,
 * exactly; for rigid motions they are zero.
 */
namespace auxfem
{
  namespace Beam2D
  {
    /** Rotation increments of the nodes of an element in a step. */
    template <int order>
    struct NodeIncrements
    {
      /** Of displacements @p u0 and @p u1 at start and end. */
      NodeIncrements(const double *u0, const double *u1)
      {
        double cosines[order + 1];
        for (int a = 0; a <= order; ++a)
          {
            half[a]    = (u1[3 * a + 2] - u0[3 * a + 2]) / 2;
            cosines[a] = cosine_of_small(half[a]);
          }
        reference        = (half[0] + half[1]) / 2;
        reference_cosine = cosine_of_small(reference);
        // Both ends are as far from their mean.
        const double of_ends = reference_cosine / sinc(half[0] - reference);
        for (int end = 0; end < 2; ++end)
          c[end] = cosines[end] * of_ends;
        for (int a = 2; a <= order; ++a)
          c[a] = cosines[a] * reference_cosine / sinc(half[a] - reference);
        for (int end = 0; end < 2; ++end)
          of_end[end] = cosines[end] / (cosines[0] + cosines[1]);
      }

      double half[order + 1];             ///< d_a
      double reference, reference_cosine; ///< d_r
      double c[order + 1];                ///< c_a
      double of_end[2];                   ///< dphi_r by dphi_a
    };

    /**
     * How the rotation at a Gauss point and its slope follow those of the nodes
     * over a step.
     */
    template <int order>
    struct RotationShapes
    {
      /** @param cosine of d_g */
      RotationShapes(const BeamShape<order>      &shape,
                     const int                    g,
                     const NodeIncrements<order> &increments,
                     const double                 cosine)
      {
        double half = 0, sum = 0, slope = 0;
        for (int a = 0; a <= order; ++a)
          {
            half += shape.value[g][a] * increments.half[a];
            value[a]      = shape.value[g][a] * increments.c[a];
            derivative[a] = shape.derivative[g][a] * increments.c[a];
            sum += value[a];
            slope += derivative[a];
          }
        const double scale = sinc(half - increments.reference) /
          (cosine * increments.reference_cosine);
        for (int a = 0; a <= order; ++a)
          value[a] *= scale;
        for (int end = 0; end < 2; ++end)
          {
            value[end] += increments.of_end[end] * (1 - scale * sum);
            derivative[end] -= increments.of_end[end] * slope;
          }
      }

      double value[order + 1];      ///< dphi_g by dphi_a
      double derivative[order + 1]; ///< dkappa_g by dphi_a, times J
    };

    /** Increments of strains. */
    struct Strains
    {
      double epsilon, gamma, kappa;
    };

    /** Kinematics of a Gauss point over a step. */
    struct StepKinematics
    {
      Kinematics start, end;
      Strains    increment;
      /** Means of t, n = (-sine, cosine) over the step; not of unit length. */
      double cosine, sine;
      double half_cosine;   ///< cos(d_g), the length of these means
      double x, y;          ///< mean of r'
      double stretch, slip; ///< mean of r' times the means of t and n
    };

    inline StepKinematics
    step_kinematics(const Frame &frame, const Gradient &d0, const Gradient &d1)
    {
      StepKinematics k;
      k.start           = kinematics<true>(frame, d0);
      const double half = (d1.phi - d0.phi) / 2, half_sine = half * sinc(half);
      k.half_cosine = cosine_of_small(half);
      k.cosine      = k.half_cosine *
        (k.half_cosine * k.start.cosine - half_sine * k.start.sine);
      k.sine = k.half_cosine *
        (k.half_cosine * k.start.sine + half_sine * k.start.cosine);
      k.x = frame.axial * frame.cosine - frame.shear * frame.sine +
        (d0.ux + d1.ux) / 2;
      k.y = frame.axial * frame.sine + frame.shear * frame.cosine +
        (d0.uy + d1.uy) / 2;
      k.stretch = k.cosine * k.x + k.sine * k.y;
      k.slip    = k.cosine * k.y - k.sine * k.x;

      // By increments, not as differences of strains; with them those at the
      // end cost no further sine and cosine.
      const double ux = d1.ux - d0.ux, uy = d1.uy - d0.uy;
      const double increment = 2 * half_sine / k.half_cosine;
      k.increment   = {k.cosine * ux + k.sine * uy + k.slip * increment,
                       k.cosine * uy - k.sine * ux - k.stretch * increment,
                       d1.kappa - d0.kappa};
      k.end.epsilon = k.start.epsilon + k.increment.epsilon;
      k.end.gamma   = k.start.gamma + k.increment.gamma;
      k.end.kappa   = d1.kappa;
      k.end.stretch = k.end.epsilon + frame.axial;
      k.end.slip    = k.end.gamma + frame.shear;
      k.end.cosine  = 2 * k.cosine - k.start.cosine;
      k.end.sine    = 2 * k.sine - k.start.sine;
      return k;
    }

    /** Mean section forces over a step: N, Q (N), M (N m). */
    struct MeanForces
    {
      double axial, shear, bending;
    };

    /** Elastic ones of the mean strains. */
    inline MeanForces mean_forces(const StepKinematics &k,
                                  const Stiffness      &stiffness)
    {
      return {stiffness.axial * (k.start.epsilon + k.end.epsilon) / 2,
              stiffness.shear * (k.start.gamma + k.end.gamma) / 2,
              stiffness.bending * (k.start.kappa + k.end.kappa) / 2};
    }

    /**
     * Adds those of damping, from the increment of the strains over the time
     * @p dt (s); returns what is lost in the step (J/m).
     */
    inline double add_damping(const StepKinematics &k,
                              const Stiffness      &stiffness,
                              const double          dt,
                              MeanForces           &forces)
    {
      const double rate = stiffness.damping_time / dt;
      const double N    = rate * stiffness.axial * k.increment.epsilon,
                   Q    = rate * stiffness.shear * k.increment.gamma,
                   M    = rate * stiffness.bending * k.increment.kappa;
      forces.axial += N;
      forces.shear += Q;
      forces.bending += M;
      return N * k.increment.epsilon + Q * k.increment.gamma +
        M * k.increment.kappa;
    }

    /**
     * Adds those of @p damping at Gauss point @p g; returns what it takes in the
     * step (J/m).
     */
    inline double add_damping(const StepKinematics   &k,
                              const Stiffness        &stiffness,
                              const IncrementDamping &damping,
                              const int               g,
                              MeanForces             &forces)
    {
      const Strains &d = k.increment;
      const double   N = stiffness.axial * damping(3 * g, d.epsilon),
                   Q   = stiffness.shear * damping(3 * g + 1, d.gamma),
                   M   = stiffness.bending * damping(3 * g + 2, d.kappa);
      forces.axial += N;
      forces.shear += Q;
      forces.bending += M;
      return N * d.epsilon + Q * d.gamma + M * d.kappa;
    }

    /** Strain energy at the end of a step, energy lost in it and taken by
     * IncrementDamping (J). */
    struct StepEnergy
    {
      double strain = 0, lost = 0, taken = 0;
    };

    /**
     * Mean force of an element over a step; as internal_force().
     * @param u0, u1 displacements at start and end
     * @param dt length of the step (s), used only if @p damped
     */
    template <int  order,
              bool damped,
              class HighFrequencyDamping = NoIncrementDamping>
    inline StepEnergy
    mean_force(const BeamShape<order>                      &shape,
               const Frame                                 *frames,
               const double                                 jacobian,
               const Stiffness                             &stiffness,
               const double                                *u0,
               const double                                *u1,
               const double                                 dt,
               double                                      *force,
               [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      StepEnergy                  energy;
      const double                inverse_jacobian = 1 / jacobian;
      const NodeIncrements<order> increments(u0, u1);
      for (int i = 0; i < 3 * (order + 1); ++i)
        force[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const StepKinematics k =
            step_kinematics(frames[g],
                            interpolate(shape, g, inverse_jacobian, u0),
                            interpolate(shape, g, inverse_jacobian, u1));
          MeanForces                  mean = mean_forces(k, stiffness);
          const RotationShapes<order> rotation(shape,
                                               g,
                                               increments,
                                               k.half_cosine);
          const double                w      = shape.weight[g];
          const double                weight = w * jacobian;
          energy.strain += weight / 2 *
            (stiffness.axial * k.end.epsilon * k.end.epsilon +
             stiffness.shear * k.end.gamma * k.end.gamma +
             stiffness.bending * k.end.kappa * k.end.kappa);
          if (damped)
            energy.lost += weight * add_damping(k, stiffness, dt, mean);
          if constexpr (HighFrequencyDamping::is_used)
            energy.taken +=
              weight * add_damping(k, stiffness, damping, g, mean);
          const double fx = w * (k.cosine * mean.axial - k.sine * mean.shear),
                       fy = w * (k.sine * mean.axial + k.cosine * mean.shear),
                       m  = weight *
            (mean.axial * k.slip - mean.shear * k.stretch);
          for (int a = 0; a <= order; ++a)
            {
              force[3 * a] += shape.derivative[g][a] * fx;
              force[3 * a + 1] += shape.derivative[g][a] * fy;
              force[3 * a + 2] += rotation.derivative[a] * w * mean.bending +
                rotation.value[a] * m;
            }
        }
      return energy;
    }

    /**
     * Derivative of mean_force() by @p u1 but for that of the shapes of the
     * rotation: it vanishes with the rotation increment. Not symmetric: rows
     * are those of the mean configuration, columns those of the end.
     * @param stiffness_factor, damping_factor how means and rates of strains
     *   follow those at the end
     */
    template <int  order,
              bool damped,
              class HighFrequencyDamping = NoIncrementDamping>
    inline void
    mean_tangent(const BeamShape<order>                      &shape,
                 const Frame                                 *frames,
                 const double                                 jacobian,
                 const Stiffness                             &stiffness,
                 const double                                *u0,
                 const double                                *u1,
                 const double                                 dt,
                 const double                                 stiffness_factor,
                 const double                                 damping_factor,
                 double                                      *matrix,
                 [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      constexpr int n                = 3 * (order + 1);
      const double  inverse_jacobian = 1 / jacobian;
      double        material         = stiffness_factor +
        (damped ? stiffness.damping_time * damping_factor : 0.);
      if constexpr (HighFrequencyDamping::is_used)
        material += damping.in_tangent;
      const NodeIncrements<order> increments(u0, u1);
      for (int i = 0; i < n * n; ++i)
        matrix[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const StepKinematics k =
            step_kinematics(frames[g],
                            interpolate(shape, g, inverse_jacobian, u0),
                            interpolate(shape, g, inverse_jacobian, u1));
          MeanForces mean = mean_forces(k, stiffness);
          if (damped)
            add_damping(k, stiffness, dt, mean);
          if constexpr (HighFrequencyDamping::is_used)
            add_damping(k, stiffness, damping, g, mean);
          // Mean N and Q by x', y' and phi at the end.
          const double EA = material * stiffness.axial,
                       GA = material * stiffness.shear, c = k.end.cosine,
                       s     = k.end.sine;
          const double dN[3] = {EA * c, EA * s, EA * k.end.slip},
                       dQ[3] = {-GA * s, GA * c, -GA * k.end.stretch};
          double G[3][3];
          for (int j = 0; j < 3; ++j)
            {
              G[0][j] = k.cosine * dN[j] - k.sine * dQ[j];
              G[1][j] = k.sine * dN[j] + k.cosine * dQ[j];
              G[2][j] = k.slip * dN[j] - k.stretch * dQ[j];
            }
          // The means of t and n turn with half of the rotation at the end.
          const double along = c * k.x + s * k.y, across = c * k.y - s * k.x;
          const double N = stiffness_factor * mean.axial,
                       Q = stiffness_factor * mean.shear;
          G[0][2] -= N * s + Q * c;
          G[1][2] += N * c - Q * s;
          G[2][0] -= N * k.sine + Q * k.cosine;
          G[2][1] += N * k.cosine - Q * k.sine;
          G[2][2] -= N * along + Q * across;

          const RotationShapes<order> rotation(shape,
                                               g,
                                               increments,
                                               k.half_cosine);
          const double                w = shape.weight[g];
          const double                bending =
            w * inverse_jacobian * material * stiffness.bending;
          for (int a = 0; a <= order; ++a)
            for (int b = 0; b <= order; ++b)
              {
                const double slope = shape.derivative[g][a];
                const double dd =
                  w * inverse_jacobian * slope * shape.derivative[g][b];
                const double dv = w * slope * shape.value[g][b];
                const double vd =
                  w * rotation.value[a] * shape.derivative[g][b];
                const double vv =
                  w * jacobian * rotation.value[a] * shape.value[g][b];
                double *block = matrix + 3 * a * n + 3 * b;
                for (int i = 0; i < 2; ++i)
                  {
                    for (int j = 0; j < 2; ++j)
                      block[n * i + j] += dd * G[i][j];
                    block[n * i + 2] += dv * G[i][2];
                    block[2 * n + i] += vd * G[2][i];
                  }
                block[2 * n + 2] += vv * G[2][2] +
                  bending * rotation.derivative[a] * shape.derivative[g][b];
              }
        }
    }
  } // namespace Beam2D
} // namespace auxfem

#endif
