#ifndef auxfem_struts_beam_3d_step_h
#define auxfem_struts_beam_3d_step_h

#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/beam_3d.h>

/**
 * @file
 * Kinematics of Beam3D over a step from state 0 to state 1 for mean forces
 * (beam_3d_discrete_gradient.h).
 */
namespace auxfem
{
  namespace Beam3D
  {
    /** Section at a Gauss point at one end of a step. */
    template <class Number>
    struct SectionInStepOf
    {
      QuaternionOf<Number> rotation; ///< P
      VectorOf<Number>     slope;    ///< r'
      StrainsOf<Number>    strains;

      /** Leaves the values unset. */
      SectionInStepOf() = default;

      template <int order>
      SectionInStepOf(const BeamShape<order>                 &shape,
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
        rotation                           = exponential(psi) * relative.middle;
        slope                              = frame.slope + stretch;
        const QuaternionOf<Number> inverse = conjugate(rotation);
        strains.gamma =
          (rotated(inverse, stretch) + rotation_change(inverse, frame.slope)) *
          frame.axes;
        strains.kappa =
          rotated(conjugate(relative.middle),
                  tangent_product(TangentCoefficientsOf<Number>(psi),
                                  psi,
                                  gradient)) *
          frame.axes;
      }
    };

    /** Element at the start of a step; all iterations of the step share it. */
    template <int order, class Number = double>
    struct StepStart
    {
      QuaternionOf<Number>    rotations[order + 1]; ///< of the nodes
      SectionInStepOf<Number> sections[order];      ///< at the Gauss points

      /** Leaves the values unset. */
      StepStart() = default;

      /** @param nodes order + 1 nodes */
      StepStart(const BeamShape<order> &shape,
                const FrameOf<Number>  *frames,
                const Number            jacobian,
                const NodeOf<Number>   *nodes)
      {
        const RelativeRotations<order, Number> relative(nodes);
        for (int a = 0; a <= order; ++a)
          rotations[a] = nodes[a].rotation;
        for (int g = 0; g < order; ++g)
          sections[g] = {shape, g, 1 / jacobian, frames[g], nodes, relative};
      }
    };

    /** Rotation exp(psi) of a Gauss point relative to P_r, and its derivatives.
     */
    template <class Number>
    struct RelativePointOf : public RelativeRotationOf<Number>
    {
      RotationCoefficientsOf<Number> coefficients; ///< of psi
      QuaternionOf<Number>           turn;         ///< exp(psi)
      TensorOf<Number>               tangent;      ///< T(psi)

      template <int order>
      RelativePointOf(const BeamShape<order>                 &shape,
                      const int                               g,
                      const Number                            inverse_jacobian,
                      const RelativeRotations<order, Number> &relative)
        : RelativeRotationOf<Number>(
            relative.at_point(shape, g, inverse_jacobian))
        , coefficients(this->psi)
        , turn(exponential(this->psi))
        , tangent(tangent_operator(coefficients, this->psi))
      {}
    };

    /** Element half way through a step and at its end, with the rotation
     * increments of its nodes. */
    template <int order, class Number = double>
    struct StepElement
    {
      RelativeRotations<order, Number> end, middle;
      NodeOperators<order, Number>     at_middle;
      VectorOf<Number>                 turns[order + 1]; ///< Theta_a
      /** y_a / sum |y_b|^2; zero if all nodes rotate alike. */
      VectorOf<Number> shares[order + 1];
      /** Increments of P_r and of nodal psi half way, by the Theta_a. */
      VectorOf<Number> middle_turn, relative_turns[order + 1];

      /** @param nodes order + 1 nodes at the end */
      StepElement(const StepStart<order, Number> &start,
                  const NodeOf<Number>           *nodes)
        : end(nodes)
        , middle(halfway(start, nodes).data())
        , at_middle(middle)
      {
        VectorOf<Number> mean;
        for (int a = 0; a <= order; ++a)
          {
            turns[a] = cayley_rotation(nodes[a].rotation *
                                       conjugate(start.rotations[a]));
            mean += 1. / (order + 1) * turns[a];
          }
        middle_turn = at_middle.middle_by_spin[0] * turns[0] +
          at_middle.middle_by_spin[1] * turns[1];
        Number square = 0;
        for (int a = 0; a <= order; ++a)
          {
            shares[a] = turns[a] - mean;
            square += shares[a].norm_square();
            relative_turns[a] =
              at_middle.psi_by_spin[a] * (turns[a] - middle_turn);
          }
        Number inverse_square             = 0;
        where(square > 0, inverse_square) = 1 / square;
        for (VectorOf<Number> &share : shares)
          share *= inverse_square;
      }

    private:
      /** Nodes half way through the step; sets rotations only. */
      static std::array<NodeOf<Number>, order + 1>
      halfway(const StepStart<order, Number> &start,
              const NodeOf<Number>           *nodes_1)
      {
        std::array<NodeOf<Number>, order + 1> nodes;
        for (int a = 0; a <= order; ++a)
          {
            const QuaternionOf<Number> &q0 = start.rotations[a],
                                       &q1 = nodes_1[a].rotation;
            Number sign                    = 1;
            where(dot(q0, q1) < 0, sign)   = -1;
            nodes[a].rotation              = normalized(q0 + sign * q1);
          }
        return nodes;
      }
    };

    /** Returns @p vector, or zero if its length is at most @p threshold. */
    template <class Number>
    inline VectorOf<Number> zero_below(const Number           &threshold,
                                       const VectorOf<Number> &vector)
    {
      VectorOf<Number> result = vector;
      const auto       none   = vector.norm_square() <= threshold * threshold;
      for (int i = 0; i < 3; ++i)
        where(none, result[i]) = 0;
      return result;
    }

    /** Kinematics of a Gauss point over a step. */
    template <class Number>
    struct StepPointOf
    {
      SectionInStepOf<Number> start, end;
      RelativePointOf<Number> middle;
      VectorOf<Number>        turn;        ///< Theta
      VectorOf<Number>        slope;       ///< mean of r'
      Number                  determinant; ///< of Rbar
      StrainsOf<Number>       increment;   ///< of the strains
      /** Theta - sum A_a Theta_a and Theta' - sum B_a Theta_a before the
       * correction; zero at the round-off of rotations. */
      VectorOf<Number> missing_turn, missing_slope;

      /** @param nodes at the end */
      template <int order>
      StepPointOf(const BeamShape<order>           &shape,
                  const int                         g,
                  const Number                      inverse_jacobian,
                  const FrameOf<Number>            &frame,
                  const SectionInStepOf<Number>    &start,
                  const NodeOf<Number>             *nodes,
                  const StepElement<order, Number> &element)
        : start(start)
        , end(shape, g, inverse_jacobian, frame, nodes, element.end)
        , middle(shape, g, inverse_jacobian, element.middle)
        , turn(cayley_rotation(end.rotation * conjugate(start.rotation)))
        , slope(0.5 * (start.slope + end.slope))
        , determinant(1 / (1 + 0.25 * turn.norm_square()))
        , increment{end.strains.gamma - start.strains.gamma,
                    end.strains.kappa - start.strains.kappa}
      {
        const Number     threshold = few_round_offs;
        VectorOf<Number> sum, sum_of_slopes;
        for (int a = 0; a <= order; ++a)
          {
            sum += shape.value[g][a] * element.relative_turns[a];
            sum_of_slopes += shape.rotation_derivative[g][a] *
              inverse_jacobian * element.relative_turns[a];
          }
        // exp(psi) T = T^T.
        missing_turn  = zero_below(threshold,
                                  VectorOf<Number>(turn - element.middle_turn -
                                                   sum * middle.tangent));
        missing_slope = zero_below(
          Number(threshold * inverse_jacobian),
          VectorOf<Number>(
            1 / determinant *
              mean_over_rotation(turn,
                                 rotated(start.rotation,
                                         VectorOf<Number>(frame.axes *
                                                          increment.kappa))) -
            rotated(middle.turn,
                    VectorOf<Number>(
                      tangent_derivative_product(middle.coefficients,
                                                 middle.psi,
                                                 middle.gradient,
                                                 sum) +
                      middle.tangent * sum_of_slopes))));
      }
    };

    /** Derivatives of section rotations and their slopes by nodal spins. */
    template <int order, class Number = double>
    struct SpinShapes
    {
      TensorOf<Number> value[order + 1]; ///< A_a
      TensorOf<Number> slope[order + 1]; ///< B_a (1/m)

      /** Shapes of the interpolation at Gauss point @p g. */
      SpinShapes(const BeamShape<order>             &shape,
                 const int                           g,
                 const Number                        inverse_jacobian,
                 const RelativePointOf<Number>      &point,
                 const NodeOperators<order, Number> &nodes)
      {
        const TensorOf<Number> by_psi      = transpose(point.tangent),
                               by_gradient = rotated(point.turn, point.tangent),
                               slope_by_psi =
                                 rotated(point.turn,
                                         tangent_derivative(point.coefficients,
                                                            point.psi,
                                                            point.gradient));
        TensorOf<Number> value_by_middle =
                           plus_identity(TensorOf<Number>(), Number(1)),
                         slope_by_middle;
        for (int a = 0; a <= order; ++a)
          {
            const Number derivative =
              shape.rotation_derivative[g][a] * inverse_jacobian;
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

      /** Corrected shapes of @p point in a step. */
      SpinShapes(const BeamShape<order>           &shape,
                 const int                         g,
                 const Number                      inverse_jacobian,
                 const StepPointOf<Number>        &point,
                 const StepElement<order, Number> &element)
        : SpinShapes(shape,
                     g,
                     inverse_jacobian,
                     point.middle,
                     element.at_middle)
      {
        for (int a = 0; a <= order; ++a)
          {
            value[a] += dyad(point.missing_turn, element.shares[a]);
            slope[a] += dyad(point.missing_slope, element.shares[a]);
          }
      }
    };
  } // namespace Beam3D
} // namespace auxfem

#endif
