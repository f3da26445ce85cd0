#ifndef auxfem_struts_beam_3d_h
#define auxfem_struts_beam_3d_h

#include <auxfem/struts/beam_3d_strains.h>

namespace auxfem
{
  namespace Beam3D
  {
    /** Derivatives of the energy per length by r', psi and psi' at constant
     * P_r, and the couple n x r' of a rotation of P_r at constant psi. */
    template <class Number>
    struct GradientOf
    {
      VectorOf<Number> force; ///< n
      VectorOf<Number> by_psi, by_gradient, couple;
      /** Section force and moment in axes rotated by P_r. */
      VectorOf<Number> middle_force, middle_moment;
      VectorOf<Number> middle_slope; ///< exp(-psi) r'
      TensorOf<Number> tangent;      ///< T(psi)
    };
    using Gradient = GradientOf<double>;

    /** @param force, moment section force and moment, in section axes */
    template <class Number>
    inline GradientOf<Number> energy_gradient(const KinematicsOf<Number> &point,
                                              const VectorOf<Number>     &force,
                                              const VectorOf<Number> &moment)
    {
      using dealii::cross_product_3d;
      const RotationCoefficientsOf<Number> &c = point.coefficients;
      GradientOf<Number>                    d;
      d.force         = point.axes * force;
      d.middle_force  = point.middle_axes * force;
      d.middle_moment = point.middle_axes * moment;
      d.middle_slope  = point.middle_axes * (point.slope * point.axes);
      d.tangent       = tangent_operator(c, point.psi);
      d.by_psi = cross_product_3d(d.middle_force, d.middle_slope) * d.tangent +
        times_tangent_derivative(d.middle_moment, c, point.psi, point.gradient);
      d.by_gradient = d.middle_moment * d.tangent;
      d.couple      = cross_product_3d(d.force, point.slope);
      return d;
    }

    /** tau and tau' of the middle rotation, as in Beam3D. */
    template <class Number>
    struct MiddleCoefficientsOf
    {
      Number tau, dtau;

      explicit MiddleCoefficientsOf(const VectorOf<Number> &chi)
      {
        using std::sqrt, std::tan;
        const Number square = chi * chi;
        // Power series of tan(x) / x with x = t / 2.
        constexpr std::array<double, 6> tau_series = {{1. / 2,
                                                       1. / 24,
                                                       1. / 240,
                                                       17. / 40320,
                                                       31. / 725760,
                                                       691. / 159667200}};
        std::array<double, 5>           dtau_series;
        for (int k = 0; k < 5; ++k)
          dtau_series[k] = 2 * (k + 1) * tau_series[k + 1];
        tau              = power_series(tau_series, square);
        dtau             = power_series(dtau_series, square);
        const auto large = square >= 0.01;
        if (any_of(large))
          {
            const Number t = sqrt(square), tangent = tan(Number(t / 2));
            where(large, tau)  = tangent / t;
            where(large, dtau) = ((1 + tangent * tangent) / 2 - tau) / square;
          }
      }
    };

    /** Derivatives of the middle rotation and of the nodal psi by nodal spins,
     * and derivatives of the moments that act on them. */
    template <int order, class Number = double>
    struct NodeOperators
    {
      VectorOf<Number> chi;
      /** V_0, V_1 of Beam3D. */
      TensorOf<Number> middle_by_spin[2];
      /** T(-psi_a)^-1. */
      TensorOf<Number> psi_by_spin[order + 1];

      explicit NodeOperators(const RelativeRotations<order, Number> &relative)
        : chi(relative.psi[1])
      {
        const Number tau = MiddleCoefficientsOf<Number>(chi).tau;
        for (int end = 0; end < 2; ++end)
          middle_by_spin[end] = plus_identity((end == 0 ? 0.5 : -0.5) * tau *
                                                cross_product_tensor(chi),
                                              Number(0.5));
        for (int a = 0; a <= order; ++a)
          psi_by_spin[a] = transpose(inverse_tangent_operator(
            InverseRotationCoefficientsOf<Number>(relative.psi[a]),
            relative.psi[a]));
      }

      /** Derivative of V_end^T @p couple by chi. */
      TensorOf<Number> end_derivative(const int               end,
                                      const VectorOf<Number> &couple) const
      {
        const MiddleCoefficientsOf<Number> c(chi);
        const TensorOf<Number>             second_end = 0.5 *
          (c.dtau * dyad(dealii::cross_product_3d(chi, couple), chi) -
           c.tau * cross_product_tensor(couple));
        return end == 1 ? second_end : -1. * second_end;
      }
    };

    /** Sums over the Gauss points of an element. */
    template <int order, class Number = double>
    struct ElementGradient
    {
      VectorOf<Number> force[order + 1]; ///< on the nodes
      VectorOf<Number> by_psi[order + 1];
      VectorOf<Number> couple; ///< on the middle rotation

      /** Adds a Gauss point. */
      void add(const BeamShape<order>   &shape,
               const int                 g,
               const Number              jacobian,
               const GradientOf<Number> &d)
      {
        const Number weight = shape.weight[g] * jacobian;
        for (int a = 0; a <= order; ++a)
          {
            const double w = shape.weight[g];
            force[a] += w * shape.derivative[g][a] * d.force;
            by_psi[a] += weight * shape.value[g][a] * d.by_psi +
              w * shape.rotation_derivative[g][a] * d.by_gradient;
          }
        couple += weight * d.couple;
      }

      /** Computes the moments on the nodes; @p at_ends receives the moment on
       * the middle rotation. */
      void find_moments(const NodeOperators<order, Number> &nodes,
                        VectorOf<Number>                   *moments,
                        VectorOf<Number>                   &at_ends) const
      {
        at_ends = couple;
        for (int a = 0; a <= order; ++a)
          {
            moments[a] = by_psi[a] * nodes.psi_by_spin[a];
            at_ends -= moments[a];
          }
        for (int end = 0; end < 2; ++end)
          moments[end] += at_ends * nodes.middle_by_spin[end];
      }
    };

    /**
     * Internal force of an element.
     * @param jacobian half the element's length (m)
     * @param section response of the section, see ElasticSection
     * @param force receives 6 (order + 1) nodal forces and moments
     * @return strain energy (J)
     */
    template <int order, class Number, class Section>
    inline Number
    internal_force(const BeamShape<order>                 &shape,
                   const ElementKinematics<order, Number> &element,
                   const Number                            jacobian,
                   const Section                          &section,
                   Number                                 *force)
    {
      ElementGradient<order, Number> sum;
      Number                         energy = 0;
      for (int g = 0; g < order; ++g)
        {
          const KinematicsOf<Number> &point = element.points[g];
          const ResponseOf<Number>    response =
            section.response(g, point.strains);
          energy += shape.weight[g] * jacobian * response.stored;
          sum.add(shape,
                  g,
                  jacobian,
                  energy_gradient(point,
                                  response.forces.force,
                                  response.forces.moment));
        }
      VectorOf<Number> moments[order + 1], at_ends;
      sum.find_moments(NodeOperators<order, Number>(element.relative),
                       moments,
                       at_ends);
      for (int a = 0; a <= order; ++a)
        for (int i = 0; i < 3; ++i)
          {
            force[n_components * a + i]     = sum.force[a][i];
            force[n_components * a + 3 + i] = moments[a][i];
          }
      return energy;
    }

    /**
     * Strains of the small-displacement form with unknowns @p u (displacement
     * and rotation vector node by node): Gamma = R0^T (u' + r0' x theta), K =
     * R0^T theta'.
     */
    template <int order, class Number>
    inline StrainsOf<Number>
    small_displacement_strains(const BeamShape<order> &shape,
                               const int               g,
                               const FrameOf<Number>  *frames,
                               const Number            jacobian,
                               const Number           *u)
    {
      VectorOf<Number> slope, rotation, curvature;
      for (int a = 0; a <= order; ++a)
        for (int i = 0; i < 3; ++i)
          {
            const Number *node = u + n_components * a;
            slope[i] += shape.derivative[g][a] / jacobian * node[i];
            rotation[i] += shape.value[g][a] * node[3 + i];
            curvature[i] +=
              shape.rotation_derivative[g][a] / jacobian * node[3 + i];
          }
      const FrameOf<Number> &frame = frames[g];
      return {(slope + dealii::cross_product_3d(frame.slope, rotation)) *
                frame.axes,
              curvature * frame.axes};
    }

    /** Internal force of the small-displacement form; arguments as in
     * internal_force(). */
    template <int order, class Number, class Section>
    inline Number small_displacement_force(const BeamShape<order> &shape,
                                           const FrameOf<Number>  *frames,
                                           const Number            jacobian,
                                           const Section          &section,
                                           const Number           *u,
                                           Number                 *force)
    {
      Number energy = 0;
      for (int i = 0; i < n_components * (order + 1); ++i)
        force[i] = 0;
      for (int g = 0; g < order; ++g)
        {
          const StrainsOf<Number> strain =
            small_displacement_strains(shape, g, frames, jacobian, u);
          const ResponseOf<Number> response = section.response(g, strain);
          const VectorOf<Number>   section_force =
            frames[g].axes * response.forces.force;
          const VectorOf<Number> moment =
            frames[g].axes * response.forces.moment;
          const VectorOf<Number> lever =
            dealii::cross_product_3d(section_force, frames[g].slope);
          const Number weight = shape.weight[g] * jacobian;
          energy += weight * response.stored;
          for (int a = 0; a <= order; ++a)
            for (int i = 0; i < 3; ++i)
              {
                const double w = shape.weight[g];
                force[n_components * a + i] +=
                  w * shape.derivative[g][a] * section_force[i];
                force[n_components * a + 3 + i] +=
                  w * shape.rotation_derivative[g][a] * moment[i] +
                  weight * shape.value[g][a] * lever[i];
              }
        }
      return energy;
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
