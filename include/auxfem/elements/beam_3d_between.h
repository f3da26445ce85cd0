#ifndef auxfem_elements_beam_3d_between_h
#define auxfem_elements_beam_3d_between_h

#include <auxfem/elements/beam_3d_damping.h>
#include <auxfem/elements/cayley_rotation.h>
#include <auxfem/elements/increment_damping.h>

/**
 * @file
 * Mean forces of Beam3D over a step from a state 0 to a state 1 that conserve
 * energy and momenta (algorithmic strain operators of Simo, Tarnow & Doblare
 * 1995 and Romero & Armero 2002). With a bar for means over the step, a delta
 * for increments and Theta, Cayley's measure of the rotation R_1 R_0^T of a
 * section,
 * @code
 * stress       = C (E_0 + E_1) / 2 + beta C delta E / dt
 * delta Gamma  = Rbar^T (delta r' - Theta x rbar')
 * delta K      = cof(Rbar)^T Theta'
 * @endcode
 * are the increments of the strains, exactly, as R_1 - R_0 = [Theta]x Rbar. The
 * same with the spins theta = sum A_a theta_a and slopes theta' = sum B_a
 * theta_a in place of Theta and Theta' are the operators of the virtual work.
 * A_a and B_a are those of the interpolation of rotations half way between the
 * states, corrected such that the Cayley rotations Theta_a of the nodes give
 * Theta and Theta' as well:
 * @code
 * A_a <- A_a + (Theta - sum A_b Theta_b) y_a^T / sum |y_b|^2,
 * y_a  = Theta_a - mean(Theta_b)
 * @endcode
 * and B_a alike. As sum y_a = 0, rigid rotations stay such: sum A_a = I,
 * sum B_a = 0. The correction goes with the square of the step.
 */
namespace auxfem
{
  namespace Beam3D
  {
    /** Section at a Gauss point at one end of a step. */
    struct SectionInStep
    {
      Quaternion  rotation; ///< P
      SpaceVector slope;    ///< r'
      Strains     strains;

      /** Values are not set. */
      SectionInStep() = default;

      template <int order>
      SectionInStep(const BeamShape<order>         &shape,
                    const int                       g,
                    const double                    inverse_jacobian,
                    const Frame                    &frame,
                    const Node                     *nodes,
                    const RelativeRotations<order> &relative)
      {
        SpaceVector stretch, psi, gradient;
        for (int a = 0; a <= order; ++a)
          {
            const double derivative = shape.derivative[g][a] * inverse_jacobian;
            stretch += derivative * nodes[a].displacement;
            psi += shape.value[g][a] * relative.psi[a];
            gradient += derivative * relative.psi[a];
          }
        rotation                 = exponential(psi) * relative.middle;
        slope                    = frame.slope + stretch;
        const Quaternion inverse = conjugate(rotation);
        strains.gamma =
          (rotated(inverse, stretch) + rotation_change(inverse, frame.slope)) *
          frame.axes;
        strains.kappa =
          rotated(conjugate(relative.middle),
                  tangent_product(TangentCoefficients(psi), psi, gradient)) *
          frame.axes;
      }
    };

    /** Rotation exp(psi) of a Gauss point relative to P_r, and its derivatives.
     */
    struct RelativePoint
    {
      SpaceVector          psi, gradient; ///< psi, psi'
      RotationCoefficients coefficients;  ///< of psi
      Quaternion           turn;          ///< exp(psi)
      SpaceTensor          tangent;       ///< T(psi)

      template <int order>
      RelativePoint(const BeamShape<order>         &shape,
                    const int                       g,
                    const double                    inverse_jacobian,
                    const RelativeRotations<order> &relative)
      {
        for (int a = 0; a <= order; ++a)
          {
            psi += shape.value[g][a] * relative.psi[a];
            gradient +=
              shape.derivative[g][a] * inverse_jacobian * relative.psi[a];
          }
        coefficients = RotationCoefficients(psi);
        turn         = exponential(psi);
        tangent      = tangent_operator(coefficients, psi);
      }
    };

    /** An element at both ends of a step and half way, and by how much its
     * nodes turn. */
    template <int order>
    struct StepElement
    {
      RelativeRotations<order> start, end, middle;
      NodeOperators<order>     at_middle;
      SpaceVector              turns[order + 1];      ///< Theta_a
      SpaceVector              deviations[order + 1]; ///< y_a
      double                   square = 0;            ///< sum |y_a|^2
      /** By how much the Theta_a turn P_r and psi of the nodes half way. */
      SpaceVector middle_turn, relative_turns[order + 1];

      /** @param nodes_0, nodes_1 order + 1 nodes at start and end. */
      StepElement(const Node *nodes_0, const Node *nodes_1)
        : start(nodes_0)
        , end(nodes_1)
        , middle(halfway(nodes_0, nodes_1).data())
        , at_middle(middle)
      {
        SpaceVector mean;
        for (int a = 0; a <= order; ++a)
          {
            turns[a] = cayley_rotation(nodes_1[a].rotation *
                                       conjugate(nodes_0[a].rotation));
            mean += turns[a] / (order + 1);
          }
        middle_turn = at_middle.middle_by_spin[0] * turns[0] +
          at_middle.middle_by_spin[1] * turns[1];
        for (int a = 0; a <= order; ++a)
          {
            deviations[a] = turns[a] - mean;
            square += deviations[a].norm_square();
            relative_turns[a] =
              at_middle.psi_by_spin[a] * (turns[a] - middle_turn);
          }
      }

    private:
      /** Only rotations. */
      static std::array<Node, order + 1> halfway(const Node *nodes_0,
                                                 const Node *nodes_1)
      {
        std::array<Node, order + 1> nodes;
        for (int a = 0; a <= order; ++a)
          {
            const Quaternion &q0 = nodes_0[a].rotation,
                             &q1 = nodes_1[a].rotation;
            nodes[a].rotation =
              normalized(q0 + (dot(q0, q1) < 0 ? -1. : 1.) * q1);
          }
        return nodes;
      }
    };

    /** Kinematics of a Gauss point over a step. */
    struct StepPoint
    {
      SectionInStep start, end;
      RelativePoint middle;
      SpaceVector   turn;        ///< Theta
      SpaceVector   slope;       ///< mean of r'
      double        determinant; ///< of Rbar
      Strains       increment;   ///< of the strains
      /** Theta - sum A_a Theta_a and Theta' - sum B_a Theta_a before the
       * correction; zero where they are round-off of the rotations. */
      SpaceVector missing_turn, missing_slope;

      template <int order>
      StepPoint(const BeamShape<order>   &shape,
                const int                 g,
                const double              jacobian,
                const Frame              &frame,
                const Node               *nodes_0,
                const Node               *nodes_1,
                const StepElement<order> &element)
        : start(shape, g, 1 / jacobian, frame, nodes_0, element.start)
        , end(shape, g, 1 / jacobian, frame, nodes_1, element.end)
        , middle(shape, g, 1 / jacobian, element.middle)
        , turn(cayley_rotation(end.rotation * conjugate(start.rotation)))
        , slope((start.slope + end.slope) / 2)
        , determinant(1 / (1 + turn.norm_square() / 4))
        , increment{end.strains.gamma - start.strains.gamma,
                    end.strains.kappa - start.strains.kappa}
      {
        constexpr double least = 4e-15;
        SpaceVector      sum, sum_of_slopes;
        for (int a = 0; a <= order; ++a)
          {
            sum += shape.value[g][a] * element.relative_turns[a];
            sum_of_slopes +=
              shape.derivative[g][a] / jacobian * element.relative_turns[a];
          }
        // exp(psi) T = T^T.
        missing_turn = turn - element.middle_turn - sum * middle.tangent;
        if (missing_turn.norm() <= least)
          missing_turn = SpaceVector();
        missing_slope =
          mean_over_rotation(turn,
                             rotated(start.rotation,
                                     frame.axes * increment.kappa)) /
            determinant -
          rotated(middle.turn,
                  tangent_derivative_product(middle.coefficients,
                                             middle.psi,
                                             middle.gradient,
                                             sum) +
                    middle.tangent * sum_of_slopes);
        if (missing_slope.norm() <= least / jacobian)
          missing_slope = SpaceVector();
      }
    };

    /** How section rotations and their slopes follow spins of the nodes. */
    template <int order>
    struct SpinShapes
    {
      SpaceTensor value[order + 1]; ///< A_a
      SpaceTensor slope[order + 1]; ///< B_a (1/m)

      /** Those of the interpolation at Gauss point @p g. */
      SpinShapes(const BeamShape<order>     &shape,
                 const int                   g,
                 const double                inverse_jacobian,
                 const RelativePoint        &point,
                 const NodeOperators<order> &nodes)
      {
        const SpaceTensor by_psi      = transpose(point.tangent),
                          by_gradient = rotated(point.turn, point.tangent),
                          slope_by_psi =
                            rotated(point.turn,
                                    tangent_derivative(point.coefficients,
                                                       point.psi,
                                                       point.gradient));
        SpaceTensor value_by_middle = plus_identity(SpaceTensor(), 1.),
                    slope_by_middle;
        for (int a = 0; a <= order; ++a)
          {
            const double derivative = shape.derivative[g][a] * inverse_jacobian;
            value[a] = shape.value[g][a] * by_psi * nodes.psi_by_spin[a];
            slope[a] =
              (shape.value[g][a] * slope_by_psi + derivative * by_gradient) *
              nodes.psi_by_spin[a];
            value_by_middle -= value[a];
            slope_by_middle -= slope[a];
          }
        for (int end = 0; end < 2; ++end)
          {
            value[end] += value_by_middle * nodes.middle_by_spin[end];
            slope[end] += slope_by_middle * nodes.middle_by_spin[end];
          }
      }

      /** Those of @p point in a step. */
      SpinShapes(const BeamShape<order>   &shape,
                 const int                 g,
                 const double              inverse_jacobian,
                 const StepPoint          &point,
                 const StepElement<order> &element)
        : SpinShapes(shape,
                     g,
                     inverse_jacobian,
                     point.middle,
                     element.at_middle)
      {
        if (element.square == 0)
          return;
        for (int a = 0; a <= order; ++a)
          {
            const SpaceVector part = element.deviations[a] / element.square;
            value[a] += dyad(point.missing_turn, part);
            slope[a] += dyad(point.missing_slope, part);
          }
      }
    };

    /** Mean section force and moment over a step, in axes of the section. */
    struct MeanForces
    {
      SpaceVector force, moment;
    };

    /** Those of @p strains, which are means. */
    inline MeanForces mean_forces(const Strains   &strains,
                                  const Stiffness &stiffness)
    {
      return {section_force(stiffness, strains.gamma),
              section_moment(stiffness, strains.kappa)};
    }

    /** Mean strains and, with @p damping_rate beta / dt, what damping adds. */
    inline Strains mean_strains(const StepPoint &point,
                                const double     damping_rate)
    {
      return {(point.start.strains.gamma + point.end.strains.gamma) / 2 +
                damping_rate * point.increment.gamma,
              (point.start.strains.kappa + point.end.strains.kappa) / 2 +
                damping_rate * point.increment.kappa};
    }

    /** What @p damping adds at Gauss point @p g. */
    inline Strains added_strains(const IncrementDamping &damping,
                                 const int               g,
                                 const Strains          &increment)
    {
      Strains added;
      for (int i = 0; i < 3; ++i)
        {
          added.gamma[i] = damping(6 * g + i, increment.gamma[i]);
          added.kappa[i] = damping(6 * g + 3 + i, increment.kappa[i]);
        }
      return added;
    }

    /** Strain energy at the end of a step, energy lost in it and taken by
     * IncrementDamping (J). */
    struct StepEnergy
    {
      double strain = 0, lost = 0, taken = 0;
    };

    /** What ElementGradient takes of mean section forces n and moments m.
     * @param force, moment n, m in fixed axes */
    inline Gradient mean_gradient(const StepPoint   &point,
                                  const SpaceVector &force,
                                  const SpaceVector &moment)
    {
      Gradient d;
      d.force  = force;
      d.couple = dealii::cross_product_3d(force, point.slope);
      const SpaceVector middle_moment =
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
     * Mean force of an element over a step; as internal_force().
     * @param nodes_0, nodes_1 order + 1 nodes at start and end
     * @param damping_rate beta / dt, 0 without damping
     */
    template <int order, class HighFrequencyDamping = NoIncrementDamping>
    inline StepEnergy
    mean_force(const BeamShape<order>                      &shape,
               const Frame                                 *frames,
               const double                                 jacobian,
               const Stiffness                             &stiffness,
               const Node                                  *nodes_0,
               const Node                                  *nodes_1,
               const double                                 damping_rate,
               double                                      *force,
               [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      const StepElement<order> element(nodes_0, nodes_1);
      StepEnergy               energy;
      ElementGradient<order>   sum;
      double                   on_missing = 0;
      for (int g = 0; g < order; ++g)
        {
          const StepPoint
            point(shape, g, jacobian, frames[g], nodes_0, nodes_1, element);
          const double weight  = shape.weight[g] * jacobian;
          Strains      strains = mean_strains(point, damping_rate);
          if constexpr (HighFrequencyDamping::is_used)
            {
              const Strains added = added_strains(damping, g, point.increment);
              const MeanForces forces = mean_forces(added, stiffness);
              energy.taken += weight *
                (forces.force * point.increment.gamma +
                 forces.moment * point.increment.kappa);
              strains.gamma += added.gamma;
              strains.kappa += added.kappa;
            }
          const MeanForces  mean = mean_forces(strains, stiffness);
          const Quaternion &axes = point.start.rotation;
          const SpaceVector at_start =
                              rotated(axes, frames[g].axes * mean.moment),
                            moment = point.determinant *
            (at_start + dealii::cross_product_3d(point.turn / 2, at_start));
          const Gradient d = mean_gradient(
            point,
            mean_over_rotation(point.turn,
                               rotated(axes, frames[g].axes * mean.force)),
            moment);
          energy.strain +=
            weight * energy_density(stiffness, point.end.strains);
          energy.lost += 2 * damping_rate * weight *
            energy_density(stiffness, point.increment);
          sum.add(shape, g, jacobian, d);
          on_missing += weight *
            (d.couple * point.missing_turn + moment * point.missing_slope);
        }
      SpaceVector moments[order + 1], at_ends;
      sum.find_moments(element.at_middle, moments, at_ends);
      const double correction =
        element.square > 0 ? on_missing / element.square : 0.;
      for (int a = 0; a <= order; ++a)
        for (int i = 0; i < 3; ++i)
          {
            force[n_components * a + i] = sum.force[a][i];
            force[n_components * a + 3 + i] =
              moments[a][i] + correction * element.deviations[a][i];
          }
      return energy;
    }

    /** Derivatives of mean section forces by slope and rotation at the end of a
     * step. */
    struct MeanStiffness
    {
      SpaceTensor force_by_slope, force_by_spin;   ///< of n
      SpaceTensor couple_by_slope, couple_by_spin; ///< of n x rbar'
      SpaceTensor moment_by_spin, moment_by_spin_slope;
    };

    inline MeanStiffness mean_stiffness(const StepPoint &point,
                                        const Frame     &frame,
                                        const Stiffness &stiffness,
                                        const Strains   &mean_strains,
                                        const double     stiffness_factor,
                                        const double     material_factor)
    {
      const SpaceTensor start_axes = rotated(point.start.rotation, frame.axes),
                        end_axes   = rotated(point.end.rotation, frame.axes),
                        axes       = (start_axes + end_axes) / 2,
                        cofactor   = point.determinant *
        plus_identity(0.5 * cross_product_tensor(point.turn), 1.) * start_axes;
      const SpaceVector ones({1., 1., 1.});
      const SpaceVector by_gamma = section_force(stiffness, ones),
                        by_kappa = section_moment(stiffness, ones);
      SpaceTensor force_by_gamma, moment_by_kappa;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          {
            force_by_gamma[i][j] = material_factor * axes[i][j] * by_gamma[j];
            moment_by_kappa[i][j] =
              material_factor * cofactor[i][j] * by_kappa[j];
          }
      const MeanForces  mean = mean_forces(mean_strains, stiffness);
      const SpaceVector n = axes * mean.force, m = cofactor * mean.moment;
      const SpaceTensor slope_cross = cross_product_tensor(point.slope);
      MeanStiffness     k;
      k.force_by_slope = force_by_gamma * transpose(end_axes);
      k.force_by_spin =
        k.force_by_slope * cross_product_tensor(point.end.slope) -
        stiffness_factor * cross_product_tensor(end_axes * mean.force);
      k.couple_by_slope = stiffness_factor * cross_product_tensor(n) -
        slope_cross * k.force_by_slope;
      k.couple_by_spin               = -1. * slope_cross * k.force_by_spin;
      k.moment_by_spin_slope         = moment_by_kappa * transpose(end_axes);
      const SpaceTensor turn_by_spin = cayley_change_by_spin(-1. * point.turn);
      k.moment_by_spin               = -stiffness_factor * point.determinant *
        (cross_product_tensor(start_axes * mean.moment) + dyad(m, point.turn)) *
        turn_by_spin;
      return k;
    }

    /**
     * Derivative of mean_force() by displacements and spins at the end but for
     * that of A_a and B_a, row by row. Not symmetric: rows are those of the
     * mean configuration, columns those of the end.
     * @param stiffness_factor how mean strains follow those at the end
     * @param material_factor how stresses over C do, without @p damping
     */
    template <int order, class HighFrequencyDamping = NoIncrementDamping>
    inline void
    mean_tangent(const BeamShape<order>                      &shape,
                 const Frame                                 *frames,
                 const double                                 jacobian,
                 const Stiffness                             &stiffness,
                 const Node                                  *nodes_0,
                 const Node                                  *nodes_1,
                 const double                                 damping_rate,
                 const double                                 stiffness_factor,
                 double                                       material_factor,
                 double                                      *matrix,
                 [[maybe_unused]] const HighFrequencyDamping &damping = {})
    {
      if constexpr (HighFrequencyDamping::is_used)
        material_factor += damping.in_tangent;
      constexpr int              n = n_components * (order + 1);
      const StepElement<order>   element(nodes_0, nodes_1);
      const NodeOperators<order> at_end(element.end);
      std::fill(matrix, matrix + n * n, 0.);
      for (int g = 0; g < order; ++g)
        {
          const StepPoint
            point(shape, g, jacobian, frames[g], nodes_0, nodes_1, element);
          const SpinShapes<order> mean(shape, g, 1 / jacobian, point, element);
          const SpinShapes<order> end(
            shape,
            g,
            1 / jacobian,
            RelativePoint(shape, g, 1 / jacobian, element.end),
            at_end);
          Strains strains = mean_strains(point, damping_rate);
          if constexpr (HighFrequencyDamping::is_used)
            {
              const Strains added = added_strains(damping, g, point.increment);
              strains.gamma += added.gamma;
              strains.kappa += added.kappa;
            }
          const MeanStiffness k      = mean_stiffness(point,
                                                 frames[g],
                                                 stiffness,
                                                 strains,
                                                 stiffness_factor,
                                                 material_factor);
          const double        weight = shape.weight[g] * jacobian;
          for (int b = 0; b <= order; ++b)
            {
              const double      Db     = shape.derivative[g][b] / jacobian;
              const SpaceTensor force  = k.force_by_spin * end.value[b],
                                couple = k.couple_by_spin * end.value[b],
                                moment = k.moment_by_spin * end.value[b] +
                k.moment_by_spin_slope * end.slope[b];
              for (int a = 0; a <= order; ++a)
                {
                  const double Da = shape.weight[g] * shape.derivative[g][a];
                  const SpaceTensor A = transpose(mean.value[a]),
                                    B = transpose(mean.slope[a]);
                  double *block       = matrix + n_components * (a * n + b);
                  add_block(Da * Db * k.force_by_slope, n, block);
                  add_block(Da * force, n, block + 3);
                  add_block(weight * Db * A * k.couple_by_slope,
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
