#ifndef auxfem_struts_beam_3d_discrete_gradient_h
#define auxfem_struts_beam_3d_discrete_gradient_h

#include <auxfem/struts/beam_3d_damping.h>
#include <auxfem/struts/beam_3d_step.h>
#include <auxfem/struts/beam_dispatch.h>

/**
 * @file
 * Mean forces of Beam3D over a step from state 0 to state 1 that conserve
 * energy and momenta. They use the algorithmic strain operators of Simo, Tarnow
 * & Doblare (1995) and Romero & Armero (2002). With a bar for means over the
 * step, a delta for increments and Theta, Cayley's measure of the section
 * rotation R_1 R_0^T,
 * @code
 * stress       = C (E_0 + E_1) / 2 + beta C delta E / dt
 * delta Gamma  = Rbar^T (delta r' - Theta x rbar')
 * delta K      = cof(Rbar)^T Theta'
 * @endcode
 * The increments of the strains are exact, since R_1 - R_0 = [Theta]x Rbar. The
 * virtual work uses the same operators with the spins theta = sum A_a theta_a
 * and slopes theta' = sum B_a theta_a. A_a and B_a interpolate rotations half
 * way between the states. A correction lets the nodal Cayley rotations Theta_a
 * reproduce Theta and Theta':
 * @code
 * A_a <- A_a + (Theta - sum A_b Theta_b) y_a^T / sum |y_b|^2,
 * y_a  = Theta_a - mean(Theta_b)
 * @endcode
 * and B_a alike. Since sum y_a = 0, rigid rotations remain rigid: sum A_a = I,
 * sum B_a = 0. The correction is of second order in the step.
 */
namespace auxfem
{
  namespace Beam3D
  {
    /**
     * Strains whose elastic forces damping adds to the mean forces at Gauss
     * point
     * @p g: those of the strain rate, with @p damping_rate beta / dt, and those
     * of @p damping, added to @p by_damping too.
     */
    template <class Number, class HighFrequencyDamping>
    inline StrainsOf<Number>
    added_strains(const StepPointOf<Number>                   &point,
                  const Number                                 damping_rate,
                  [[maybe_unused]] const HighFrequencyDamping &damping,
                  [[maybe_unused]] const int                   g,
                  [[maybe_unused]] StrainsOf<Number>          &by_damping)
    {
      StrainsOf<Number> added{damping_rate * point.increment.gamma,
                              damping_rate * point.increment.kappa};
      if constexpr (HighFrequencyDamping::is_used)
        {
          for (int i = 0; i < 3; ++i)
            {
              by_damping.gamma[i] =
                damping(6 * g + i, point.increment.gamma[i]);
              by_damping.kappa[i] =
                damping(6 * g + 3 + i, point.increment.kappa[i]);
            }
          added.gamma += by_damping.gamma;
          added.kappa += by_damping.kappa;
        }
      return added;
    }

    /** Strain energy at the end of a step, energy dissipated in it and
     * numerical dissipation by IncrementDamping (J). */
    template <class Number>
    struct StepEnergyOf
    {
      Number strain = 0, dissipation = 0, numerical_dissipation = 0;
    };

    /**
     * Contribution of mean section forces n and moments m to ElementGradient.
     * @param force, moment n, m in fixed axes
     */
    template <class Number>
    inline GradientOf<Number> mean_gradient(const StepPointOf<Number> &point,
                                            const VectorOf<Number>    &force,
                                            const VectorOf<Number>    &moment)
    {
      GradientOf<Number> d;
      d.force  = force;
      d.couple = dealii::cross_product_3d(force, point.slope);
      const VectorOf<Number> middle_moment =
        rotated(conjugate(point.middle.turn), moment);
      d.by_psi = point.middle.tangent * d.couple +
        times_tangent_derivative(middle_moment,
                                 point.middle.coefficients,
                                 point.middle.psi,
                                 point.middle.gradient);
      d.by_gradient = middle_moment * point.middle.tangent;
      return d;
    }

    /**
     * Mean force of an element over a step; arguments as in internal_force().
     * @param nodes order + 1 nodes at the end
     * @param damping_rate beta / dt, 0 without damping
     */
    template <int order,
              class Number,
              class Section,
              class HighFrequencyDamping = NoIncrementDamping>
    inline StepEnergyOf<Number>
    mean_force(const BeamShape<order>                      &shape,
               const FrameOf<Number>                       *frames,
               const Number                                 jacobian,
               const Section                               &section,
               const StepStart<order, Number>              &start,
               const NodeOf<Number>                        *nodes,
               const Number                                 damping_rate,
               Number                                      *force,
               [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      const StepElement<order, Number> element(start, nodes);
      StepEnergyOf<Number>             energy;
      ElementGradient<order, Number>   sum;
      Number                           correction_work = 0;
      for (int g = 0; g < order; ++g)
        {
          const StepPointOf<Number> point(shape,
                                          g,
                                          1 / jacobian,
                                          frames[g],
                                          start.sections[g],
                                          nodes,
                                          element);
          const Number              weight = shape.weight[g] * jacobian;
          StrainsOf<Number>         by_damping;
          const StrainsOf<Number>   added =
            added_strains(point, damping_rate, damping, g, by_damping);
          if constexpr (HighFrequencyDamping::is_used)
            {
              const ForcesOf<Number> forces =
                section.elastic_forces(by_damping);
              energy.numerical_dissipation += weight *
                (forces.force * point.increment.gamma +
                 forces.moment * point.increment.kappa);
            }
          const ResponseOf<Number> response =
            section.mean(g, point.start.strains, point.end.strains, added);
          const ForcesOf<Number>     &mean = response.forces;
          const QuaternionOf<Number> &axes = point.start.rotation;
          const VectorOf<Number>      at_start =
                                   rotated(axes, frames[g].axes * mean.moment),
                                 moment = point.determinant *
            (at_start +
             dealii::cross_product_3d(VectorOf<Number>(0.5 * point.turn),
                                      at_start));
          const GradientOf<Number> d = mean_gradient(
            point,
            mean_over_rotation(point.turn,
                               rotated(axes, frames[g].axes * mean.force)),
            moment);
          energy.strain += weight * response.stored;
          energy.dissipation += 2 * damping_rate * weight *
            energy_density(section.stiffness, point.increment);
          sum.add(shape, g, jacobian, d);
          correction_work += weight *
            (d.couple * point.missing_turn + moment * point.missing_slope);
        }
      VectorOf<Number> moments[order + 1], at_ends;
      sum.find_moments(element.at_middle, moments, at_ends);
      for (int a = 0; a <= order; ++a)
        for (int i = 0; i < 3; ++i)
          {
            force[n_components * a + i] = sum.force[a][i];
            force[n_components * a + 3 + i] =
              moments[a][i] + correction_work * element.shares[a][i];
          }
      return energy;
    }

    /** Derivatives of mean section forces by slope and rotation at the end of a
     * step. */
    template <class Number>
    struct MeanStiffnessOf
    {
      TensorOf<Number> force_by_slope, force_by_spin;   ///< of n
      TensorOf<Number> couple_by_slope, couple_by_spin; ///< of n x rbar'
      TensorOf<Number> moment_by_spin, moment_by_spin_slope;
      /** @name Zero unless the section couples gamma and kappa. */
      ///@{
      TensorOf<Number> force_by_spin_slope, couple_by_spin_slope,
        moment_by_slope;
      ///@}
    };

    /** Derivatives of mean section forces and moments by the strains at the end
     * of a step, in fixed axes times section axes. */
    template <class Number>
    struct MeanByStrainsOf
    {
      /** @param axes, cofactor fixed axes of forces and moments as columns */
      MeanByStrainsOf(const TensorOf<Number>    &axes,
                      const TensorOf<Number>    &cofactor,
                      const StiffnessOf<Number> &stiffness)
      {
        const VectorOf<Number> ones({1, 1, 1});
        const VectorOf<Number> by_gamma = section_force(stiffness, ones);
        const VectorOf<Number> by_kappa = section_moment(stiffness, ones);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            {
              force_by_gamma[i][j]  = axes[i][j] * by_gamma[j];
              moment_by_kappa[i][j] = cofactor[i][j] * by_kappa[j];
            }
      }

      MeanByStrainsOf(const TensorOf<Number>           &axes,
                      const TensorOf<Number>           &cofactor,
                      const CoupledStiffnessOf<Number> &stiffness)
        : MeanByStrainsOf(axes,
                          cofactor,
                          static_cast<const StiffnessOf<Number> &>(stiffness))
      {
        if (!stiffness.is_coupled)
          return;
        force_by_gamma  = axes * stiffness.by_gamma;
        moment_by_kappa = cofactor * stiffness.by_kappa;
      }

      TensorOf<Number> force_by_gamma, moment_by_kappa;
    };

    /** Adds the stiffness by which forces depend on kappa and moments on
     * gamma. */
    template <class Number>
    inline void add_couplings(const StepPointOf<Number>        &point,
                              const CoupledStiffnessOf<Number> &stiffness,
                              const TensorOf<Number>           &axes,
                              const TensorOf<Number>           &cofactor,
                              const TensorOf<Number>           &end_axes,
                              MeanStiffnessOf<Number>          &k)
    {
      k.force_by_spin_slope =
        axes * stiffness.gamma_by_kappa * transpose(end_axes);
      k.couple_by_spin_slope =
        -1. * cross_product_tensor(point.slope) * k.force_by_spin_slope;
      k.moment_by_slope =
        cofactor * transpose(stiffness.gamma_by_kappa) * transpose(end_axes);
      k.moment_by_spin +=
        k.moment_by_slope * cross_product_tensor(point.end.slope);
    }

    /**
     * @param stiffness derivatives of the mean section forces by the strains at
     *   the end
     * @param stiffness_factor derivative of mean strains by strains at the end
     */
    template <class Number, class Stiffness>
    inline MeanStiffnessOf<Number>
    mean_stiffness(const StepPointOf<Number> &point,
                   const FrameOf<Number>     &frame,
                   const ForcesOf<Number>    &mean,
                   const Stiffness           &stiffness,
                   const double               stiffness_factor)
    {
      const TensorOf<Number> start_axes =
                               rotated(point.start.rotation, frame.axes),
                             end_axes = rotated(point.end.rotation, frame.axes),
                             axes     = 0.5 * (start_axes + end_axes),
                             cofactor = point.determinant *
        plus_identity(0.5 * cross_product_tensor(point.turn), Number(1)) *
        start_axes;
      const MeanByStrainsOf<Number> by_strains(axes, cofactor, stiffness);
      const VectorOf<Number>  n = axes * mean.force, m = cofactor * mean.moment;
      const TensorOf<Number>  slope_cross = cross_product_tensor(point.slope);
      MeanStiffnessOf<Number> k;
      k.force_by_slope = by_strains.force_by_gamma * transpose(end_axes);
      k.force_by_spin =
        k.force_by_slope * cross_product_tensor(point.end.slope) -
        stiffness_factor * cross_product_tensor(end_axes * mean.force);
      k.couple_by_slope = stiffness_factor * cross_product_tensor(n) -
        slope_cross * k.force_by_slope;
      k.couple_by_spin       = -1. * slope_cross * k.force_by_spin;
      k.moment_by_spin_slope = by_strains.moment_by_kappa * transpose(end_axes);
      const TensorOf<Number> turn_by_spin =
        cayley_spin_derivative(-1. * point.turn);
      k.moment_by_spin = -stiffness_factor * point.determinant *
        (cross_product_tensor(start_axes * mean.moment) + dyad(m, point.turn)) *
        turn_by_spin;
      if constexpr (Stiffness::can_couple)
        if (stiffness.is_coupled)
          add_couplings(point, stiffness, axes, cofactor, end_axes, k);
      return k;
    }

    /**
     * Derivative of mean_force() by displacements and spins at the end, row by
     * row, without the derivatives of A_a and B_a. It is not symmetric: rows
     * belong to the mean configuration, columns to the end.
     * @param stiffness_factor derivative of mean strains by strains at the end
     * @param added_factor derivative of the damping strains by strains at the
     *   end, without @p damping
     */
    template <int order,
              class Number,
              class Section,
              class HighFrequencyDamping = NoIncrementDamping>
    inline void
    mean_tangent(const BeamShape<order>                      &shape,
                 const FrameOf<Number>                       *frames,
                 const Number                                 jacobian,
                 const Section                               &section,
                 const StepStart<order, Number>              &start,
                 const NodeOf<Number>                        *nodes,
                 const Number                                 damping_rate,
                 const double                                 stiffness_factor,
                 Number                                       added_factor,
                 Number                                      *matrix,
                 [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      if constexpr (HighFrequencyDamping::is_used)
        added_factor += damping.tangent_factor;
      constexpr int                      n = n_components * (order + 1);
      const StepElement<order, Number>   element(start, nodes);
      const NodeOperators<order, Number> at_end(element.end);
      std::fill_n(matrix, n * n, Number(0));
      for (int g = 0; g < order; ++g)
        {
          const StepPointOf<Number>       point(shape,
                                          g,
                                          1 / jacobian,
                                          frames[g],
                                          start.sections[g],
                                          nodes,
                                          element);
          const SpinShapes<order, Number> mean(shape,
                                               g,
                                               1 / jacobian,
                                               point,
                                               element);
          const SpinShapes<order, Number> end(
            shape,
            g,
            1 / jacobian,
            RelativePointOf<Number>(shape, g, 1 / jacobian, element.end),
            at_end);
          StrainsOf<Number> by_damping;
          const auto        linearized = section.mean_linearized(
            g,
            point.start.strains,
            point.end.strains,
            added_strains(point, damping_rate, damping, g, by_damping));
          const auto stiffness            = combined(stiffness_factor,
                                          linearized.stiffness,
                                          added_factor,
                                          section.stiffness);
          using Stiffness                 = std::decay_t<decltype(stiffness)>;
          const MeanStiffnessOf<Number> k = mean_stiffness(point,
                                                           frames[g],
                                                           linearized.forces,
                                                           stiffness,
                                                           stiffness_factor);
          const Number                  weight = shape.weight[g] * jacobian;
          for (int b = 0; b <= order; ++b)
            {
              const Number     Db           = shape.derivative[g][b] / jacobian;
              TensorOf<Number> force        = k.force_by_spin * end.value[b],
                               couple       = k.couple_by_spin * end.value[b];
              const TensorOf<Number> moment = k.moment_by_spin * end.value[b] +
                k.moment_by_spin_slope * end.slope[b];
              if constexpr (Stiffness::can_couple)
                {
                  force += k.force_by_spin_slope * end.slope[b];
                  couple += k.couple_by_spin_slope * end.slope[b];
                }
              for (int a = 0; a <= order; ++a)
                {
                  const double Da = shape.weight[g] * shape.derivative[g][a];
                  const TensorOf<Number> A = transpose(mean.value[a]),
                                         B = transpose(mean.slope[a]);
                  Number *block = matrix + n_components * (a * n + b);
                  add_block(Da * Db * k.force_by_slope, n, block);
                  add_block(Da * force, n, block + 3);
                  add_block(weight * Db * A * k.couple_by_slope,
                            n,
                            block + 3 * n);
                  if constexpr (Stiffness::can_couple)
                    add_block(weight * Db * B * k.moment_by_slope,
                              n,
                              block + 3 * n);
                  add_block(weight * (A * couple + B * moment),
                            n,
                            block + 3 * n + 3);
                }
            }
        }
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
