#ifndef auxfem_elements_beam_3d_between_h
#define auxfem_elements_beam_3d_between_h

#include <auxfem/elements/beam_3d_damping.h>
#include <auxfem/elements/cayley_rotation.h>

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
                 const Kinematics           &point,
                 const NodeOperators<order> &nodes)
      {
        const SpaceTensor turn = point.axes * transpose(point.middle_axes);
        const SpaceTensor T = tangent_operator(point.coefficients, point.psi);
        // exp(psi) T = T^T.
        const SpaceTensor by_psi = transpose(T), by_gradient = turn * T,
                          slope_by_psi = turn *
          tangent_derivative(point.coefficients, point.psi, point.gradient);
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
    };

    /** An element at both ends of a step and half way, and by how much its
     * nodes turn. */
    template <int order>
    struct StepElement
    {
      ElementKinematics<order> start, end, middle;
      NodeOperators<order>     at_middle;
      SpaceVector              turns[order + 1];      ///< Theta_a
      SpaceVector              deviations[order + 1]; ///< y_a
      double                   square = 0;            ///< sum |y_a|^2

      /** Arguments as of ElementKinematics; nodes at start and end. */
      StepElement(const BeamShape<order> &shape,
                  const Frame            *frames,
                  const double            jacobian,
                  const Node             *nodes_0,
                  const Node             *nodes_1)
        : start(shape, frames, jacobian, nodes_0)
        , end(shape, frames, jacobian, nodes_1)
        , middle(shape, frames, jacobian, halfway(nodes_0, nodes_1).data())
        , at_middle(middle.relative)
      {
        SpaceVector mean;
        for (int a = 0; a <= order; ++a)
          {
            turns[a] = cayley_rotation(nodes_1[a].rotation *
                                       conjugate(nodes_0[a].rotation));
            mean += turns[a] / (order + 1);
          }
        for (int a = 0; a <= order; ++a)
          {
            deviations[a] = turns[a] - mean;
            square += deviations[a].norm_square();
          }
      }

    private:
      static std::array<Node, order + 1> halfway(const Node *nodes_0,
                                                 const Node *nodes_1)
      {
        std::array<Node, order + 1> nodes;
        for (int a = 0; a <= order; ++a)
          {
            const Quaternion &q0 = nodes_0[a].rotation,
                             &q1 = nodes_1[a].rotation;
            nodes[a] = {(nodes_0[a].displacement + nodes_1[a].displacement) / 2,
                        normalized(q0 + (dot(q0, q1) < 0 ? -1. : 1.) * q1)};
          }
        return nodes;
      }
    };

    /** Kinematics of a Gauss point over a step. */
    template <int order>
    struct StepPoint
    {
      const Kinematics &start, &end;
      SpaceVector       turn;        ///< Theta
      SpaceVector       slope;       ///< mean of r'
      SpaceTensor       axes;        ///< Rbar
      SpaceTensor       cofactor;    ///< cof(Rbar)
      double            determinant; ///< of Rbar
      Strains           increment;   ///< of the strains
      SpinShapes<order> spin;        ///< corrected

      StepPoint(const BeamShape<order>   &shape,
                const int                 g,
                const double              jacobian,
                const StepElement<order> &element)
        : start(element.start.points[g])
        , end(element.end.points[g])
        , turn(cayley_rotation(
            element.end.relative.at(shape.value[g]) *
            conjugate(element.start.relative.at(shape.value[g]))))
        , slope((start.slope + end.slope) / 2)
        , axes((start.axes + end.axes) / 2)
        , determinant(1 / (1 + turn.norm_square() / 4))
        , increment{end.strains.gamma - start.strains.gamma,
                    end.strains.kappa - start.strains.kappa}
        , spin(shape,
               g,
               1 / jacobian,
               element.middle.points[g],
               element.at_middle)
      {
        cofactor = determinant *
          plus_identity(0.5 * cross_product_tensor(turn), 1.) * start.axes;
        // What is less is round-off of the rotations.
        constexpr double least = 4e-15;
        correct(element, turn, least, spin.value);
        correct(element,
                axes * increment.kappa / determinant,
                least / jacobian,
                spin.slope);
      }

    private:
      /** Makes the turns of the nodes give @p wanted. */
      static void correct(const StepElement<order> &element,
                          const SpaceVector        &wanted,
                          const double              least,
                          SpaceTensor              *shapes)
      {
        SpaceVector missing = wanted;
        for (int a = 0; a <= order; ++a)
          missing -= shapes[a] * element.turns[a];
        if (missing.norm() <= least)
          return;
        for (int a = 0; a <= order; ++a)
          shapes[a] += dyad(missing, element.deviations[a] / element.square);
      }
    };

    /** Mean section force and moment over a step, in axes of the section. */
    struct MeanForces
    {
      SpaceVector force, moment;
    };

    /** Those of mean strains and, with @p damping_rate beta / dt, of their rates. */
    template <int order>
    inline MeanForces mean_forces(const StepPoint<order> &point,
                                  const Stiffness        &stiffness,
                                  const double            damping_rate)
    {
      return {
        section_force(stiffness,
                      (point.start.strains.gamma + point.end.strains.gamma) /
                          2 +
                        damping_rate * point.increment.gamma),
        section_moment(stiffness,
                       (point.start.strains.kappa + point.end.strains.kappa) /
                           2 +
                         damping_rate * point.increment.kappa)};
    }

    /** Strain energy at the end of a step and energy lost in it (J). */
    struct StepEnergy
    {
      double strain = 0, lost = 0;
    };

    /**
     * Mean force of an element over a step; as internal_force().
     * @param nodes_0, nodes_1 order + 1 nodes at start and end
     * @param damping_rate beta / dt, 0 without damping
     */
    template <int order>
    inline StepEnergy mean_force(const BeamShape<order> &shape,
                                 const Frame            *frames,
                                 const double            jacobian,
                                 const Stiffness        &stiffness,
                                 const Node             *nodes_0,
                                 const Node             *nodes_1,
                                 const double            damping_rate,
                                 double                 *force)
    {
      const StepElement<order> element(shape,
                                       frames,
                                       jacobian,
                                       nodes_0,
                                       nodes_1);
      StepEnergy               energy;
      SpaceVector              forces[order + 1], moments[order + 1];
      for (int g = 0; g < order; ++g)
        {
          const StepPoint<order> point(shape, g, jacobian, element);
          const MeanForces  mean = mean_forces(point, stiffness, damping_rate);
          const SpaceVector n    = point.axes * mean.force,
                            m    = point.cofactor * mean.moment,
                            couple = dealii::cross_product_3d(n, point.slope);
          const double weight      = shape.weight[g] * jacobian;
          energy.strain +=
            weight * energy_density(stiffness, point.end.strains);
          energy.lost += 2 * damping_rate * weight *
            energy_density(stiffness, point.increment);
          for (int a = 0; a <= order; ++a)
            {
              forces[a] += shape.weight[g] * shape.derivative[g][a] * n;
              moments[a] += weight *
                (couple * point.spin.value[a] + m * point.spin.slope[a]);
            }
        }
      for (int a = 0; a <= order; ++a)
        for (int i = 0; i < 3; ++i)
          {
            force[n_components * a + i]     = forces[a][i];
            force[n_components * a + 3 + i] = moments[a][i];
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

    template <int order>
    inline MeanStiffness mean_stiffness(const StepPoint<order> &point,
                                        const Stiffness        &stiffness,
                                        const double            damping_rate,
                                        const double stiffness_factor,
                                        const double material_factor)
    {
      const SpaceVector ones({1., 1., 1.});
      const SpaceVector by_gamma = section_force(stiffness, ones),
                        by_kappa = section_moment(stiffness, ones);
      SpaceTensor force_by_gamma, moment_by_kappa;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          {
            force_by_gamma[i][j] =
              material_factor * point.axes[i][j] * by_gamma[j];
            moment_by_kappa[i][j] =
              material_factor * point.cofactor[i][j] * by_kappa[j];
          }
      const MeanForces  mean = mean_forces(point, stiffness, damping_rate);
      const SpaceVector n    = point.axes * mean.force,
                        m    = point.cofactor * mean.moment;
      const SpaceTensor slope_cross = cross_product_tensor(point.slope);
      MeanStiffness     k;
      k.force_by_slope = force_by_gamma * transpose(point.end.axes);
      k.force_by_spin =
        k.force_by_slope * cross_product_tensor(point.end.slope) -
        stiffness_factor * cross_product_tensor(point.end.axes * mean.force);
      k.couple_by_slope = stiffness_factor * cross_product_tensor(n) -
        slope_cross * k.force_by_slope;
      k.couple_by_spin       = -1. * slope_cross * k.force_by_spin;
      k.moment_by_spin_slope = moment_by_kappa * transpose(point.end.axes);
      const SpaceTensor turn_by_spin = cayley_change_by_spin(-1. * point.turn);
      k.moment_by_spin               = -stiffness_factor * point.determinant *
        (cross_product_tensor(point.start.axes * mean.moment) +
         dyad(m, point.turn)) *
        turn_by_spin;
      return k;
    }

    /**
     * Derivative of mean_force() by displacements and spins at the end but for
     * that of A_a and B_a, row by row. Not symmetric: rows are those of the
     * mean configuration, columns those of the end.
     * @param stiffness_factor, damping_factor how means and rates of strains
     *   follow those at the end
     */
    template <int order>
    inline void mean_tangent(const BeamShape<order> &shape,
                             const Frame            *frames,
                             const double            jacobian,
                             const Stiffness        &stiffness,
                             const Node             *nodes_0,
                             const Node             *nodes_1,
                             const double            damping_rate,
                             const double            stiffness_factor,
                             const double            material_factor,
                             double                 *matrix)
    {
      constexpr int              n = n_components * (order + 1);
      const StepElement<order>   element(shape,
                                       frames,
                                       jacobian,
                                       nodes_0,
                                       nodes_1);
      const NodeOperators<order> at_end(element.end.relative);
      std::fill(matrix, matrix + n * n, 0.);
      for (int g = 0; g < order; ++g)
        {
          const StepPoint<order>  point(shape, g, jacobian, element);
          const SpinShapes<order> end(shape,
                                      g,
                                      1 / jacobian,
                                      element.end.points[g],
                                      at_end);
          const MeanStiffness     k      = mean_stiffness(point,
                                                 stiffness,
                                                 damping_rate,
                                                 stiffness_factor,
                                                 material_factor);
          const double            weight = shape.weight[g] * jacobian;
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
                  const SpaceTensor A = transpose(point.spin.value[a]),
                                    B = transpose(point.spin.slope[a]);
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
