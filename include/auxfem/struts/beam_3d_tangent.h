#ifndef auxfem_struts_beam_3d_tangent_h
#define auxfem_struts_beam_3d_tangent_h

#include <auxfem/struts/beam_3d.h>

namespace auxfem
{
  namespace Beam3D
  {
    /** Second derivatives of the energy per length, in the notation of
     * Gradient. */
    template <class Number>
    struct HessianOf
    {
      TensorOf<Number> slope_slope, slope_psi, psi_psi, psi_gradient,
        gradient_gradient;
      /** Zero unless the section couples gamma and kappa. */
      TensorOf<Number> slope_gradient;
    };
    using Hessian = HessianOf<double>;

    /** Derivatives of section forces by gamma, in components along the columns
     * of @p axes turned to the fixed ones. */
    template <class Number>
    inline TensorOf<Number> force_by_gamma(const TensorOf<Number>    &axes,
                                           const StiffnessOf<Number> &stiffness)
    {
      return with_principal_values(
        axes,
        section_force(stiffness, VectorOf<Number>({1., 1., 1.})));
    }

    /** @copydoc force_by_gamma */
    template <class Number>
    inline TensorOf<Number>
    force_by_gamma(const TensorOf<Number>           &axes,
                   const CoupledStiffnessOf<Number> &stiffness)
    {
      using Uncoupled = StiffnessOf<Number>;
      return stiffness.is_coupled
        ? TensorOf<Number>(axes * stiffness.by_gamma * transpose(axes))
        : force_by_gamma(axes, static_cast<const Uncoupled &>(stiffness));
    }

    /** As force_by_gamma(), of section moments by kappa. */
    template <class Number>
    inline TensorOf<Number>
    moment_by_kappa(const TensorOf<Number>    &axes,
                    const StiffnessOf<Number> &stiffness)
    {
      return with_principal_values(
        axes,
        section_moment(stiffness, VectorOf<Number>({1., 1., 1.})));
    }

    /** @copydoc moment_by_kappa */
    template <class Number>
    inline TensorOf<Number>
    moment_by_kappa(const TensorOf<Number>           &axes,
                    const CoupledStiffnessOf<Number> &stiffness)
    {
      using Uncoupled = StiffnessOf<Number>;
      return stiffness.is_coupled
        ? TensorOf<Number>(axes * stiffness.by_kappa * transpose(axes))
        : moment_by_kappa(axes, static_cast<const Uncoupled &>(stiffness));
    }

    /**
     * Adds the second derivatives by which forces depend on kappa and moments
     * on gamma.
     * @param gamma_by_psi, kappa_by_psi derivatives of strains in the frame
     *   @p middle_axes
     * @param T derivative of kappa by psi'
     */
    template <class Number>
    inline void add_couplings(const KinematicsOf<Number>       &point,
                              const CoupledStiffnessOf<Number> &stiffness,
                              const TensorOf<Number>           &turn,
                              const TensorOf<Number>           &gamma_by_psi,
                              const TensorOf<Number>           &kappa_by_psi,
                              const TensorOf<Number>           &T,
                              HessianOf<Number>                &h)
    {
      const TensorOf<Number> force_by_kappa = point.middle_axes *
        stiffness.gamma_by_kappa * transpose(point.middle_axes);
      const TensorOf<Number> force_by_psi = force_by_kappa * kappa_by_psi,
                             psi_psi = transpose(gamma_by_psi) * force_by_psi;
      h.slope_psi += turn * force_by_psi;
      h.slope_gradient = turn * force_by_kappa * T;
      h.psi_psi += psi_psi + transpose(psi_psi);
      h.psi_gradient += transpose(gamma_by_psi) * force_by_kappa * T;
    }

    template <class Number, class Stiffness>
    inline HessianOf<Number> energy_hessian(const KinematicsOf<Number> &point,
                                            const Stiffness          &stiffness,
                                            const GradientOf<Number> &d)
    {
      const RotationCoefficientsOf<Number> &c = point.coefficients;
      const TensorOf<Number>                by_gamma =
                               force_by_gamma(point.middle_axes, stiffness),
                             by_kappa =
                               moment_by_kappa(point.middle_axes, stiffness);
      const TensorOf<Number> slope_cross = cross_product_tensor(d.middle_slope),
                             force_cross = cross_product_tensor(d.middle_force);
      const TensorOf<Number> &T          = d.tangent;
      const TensorOf<Number>  kappa_by_psi =
        tangent_derivative(c, point.psi, point.gradient);
      const TensorOf<Number> turn = point.axes * transpose(point.middle_axes);
      const TensorOf<Number> force_by_spin =
        by_gamma * slope_cross - force_cross;

      HessianOf<Number> h;
      h.slope_slope = force_by_gamma(point.axes, stiffness);
      h.slope_psi   = turn * force_by_spin * T;
      h.psi_psi     = transpose(T) *
          (force_cross * slope_cross - slope_cross * by_gamma * slope_cross) *
          T +
        left_tangent_derivative(c,
                                point.psi,
                                dealii::cross_product_3d(d.middle_force,
                                                         d.middle_slope)) +
        transpose(kappa_by_psi) * by_kappa * kappa_by_psi +
        tangent_second_derivative(c,
                                  point.psi,
                                  point.gradient,
                                  d.middle_moment);
      h.psi_gradient = transpose(kappa_by_psi) * by_kappa * T +
        transpose(left_tangent_derivative(c, point.psi, d.middle_moment));
      h.gradient_gradient = transpose(T) * by_kappa * T;
      if constexpr (Stiffness::can_couple)
        if (stiffness.is_coupled)
          add_couplings(point,
                        stiffness,
                        turn,
                        slope_cross * T,
                        kappa_by_psi,
                        T,
                        h);
      return h;
    }

    /**
     * Second derivatives of the energy of an element. Rows: forces, moments on
     * psi, couple on the middle rotation. Columns: displacements, psi, rotation
     * of the middle rotation.
     */
    template <int order, class Number = double>
    struct ElementHessian
    {
      static constexpr int n = order + 1;
      TensorOf<Number>     force_force[n][n], force_psi[n][n], psi_psi[n][n];
      TensorOf<Number>     force_middle[n], psi_middle[n], middle_force[n],
        middle_psi[n], middle_middle;

      /** Adds a Gauss point; @p couples as HessianOf::slope_gradient. */
      template <bool couples>
      void add(const BeamShape<order>     &shape,
               const int                   g,
               const Number                jacobian,
               const KinematicsOf<Number> &point,
               const GradientOf<Number>   &d,
               const HessianOf<Number>    &h)
      {
        const TensorOf<Number> slope_cross = cross_product_tensor(point.slope),
                               couple_by_slope = cross_product_tensor(d.force) -
          slope_cross * h.slope_slope,
                               couple_by_psi = -1. * slope_cross * h.slope_psi,
                               slope_by_middle = h.slope_slope * slope_cross,
                               psi_by_middle =
                                 transpose(h.slope_psi) * slope_cross;
        const Number weight = shape.weight[g] * jacobian;
        middle_middle += weight * couple_by_slope * slope_cross;
        for (int a = 0; a < n; ++a)
          {
            const Number Da = shape.derivative[g][a] / jacobian,
                         Ra = shape.rotation_derivative[g][a] / jacobian;
            const double Na = shape.value[g][a];
            force_middle[a] += weight * Da * slope_by_middle;
            psi_middle[a] += weight * Na * psi_by_middle;
            middle_force[a] += weight * Da * couple_by_slope;
            middle_psi[a] += weight * Na * couple_by_psi;
            if constexpr (couples)
              {
                psi_middle[a] +=
                  weight * Ra * transpose(h.slope_gradient) * slope_cross;
                middle_psi[a] -= weight * Ra * slope_cross * h.slope_gradient;
              }
            for (int b = 0; b < n; ++b)
              {
                const Number Db = shape.derivative[g][b] / jacobian,
                             Rb = shape.rotation_derivative[g][b] / jacobian;
                const double Nb = shape.value[g][b];
                force_force[a][b] += weight * Da * Db * h.slope_slope;
                force_psi[a][b] += weight * Da * Nb * h.slope_psi;
                if constexpr (couples)
                  force_psi[a][b] += weight * Da * Rb * h.slope_gradient;
                // Fill the upper half; complete() transposes it.
                if (b >= a)
                  psi_psi[a][b] += weight *
                    (Na * Nb * h.psi_psi + Na * Rb * h.psi_gradient +
                     Ra * Nb * transpose(h.psi_gradient) +
                     Ra * Rb * h.gradient_gradient);
              }
          }
      }

      void complete()
      {
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < a; ++b)
            psi_psi[a][b] = transpose(psi_psi[b][a]);
      }
    };

    /** Rows of the tangent for a force or moment: derivatives by the nodal
     * motion. */
    template <int order, class Number = double>
    struct Rows
    {
      TensorOf<Number> by_displacement[order + 1];
      /** By spins, at a fixed middle rotation. */
      TensorOf<Number> by_spin[order + 1];
      TensorOf<Number> by_middle;

      /** Replaces the derivative by the middle rotation by derivatives by the
       * spins of the ends. */
      void eliminate_middle(const NodeOperators<order, Number> &nodes)
      {
        for (int end = 0; end < 2; ++end)
          by_spin[end] += by_middle * nodes.middle_by_spin[end];
      }
    };

    /** Writes @p rows, times @p factor, to three rows of a square matrix. */
    template <int order, class Number>
    inline void write_rows(const Rows<order, Number> &rows,
                           const Number               factor,
                           Number                    *matrix)
    {
      constexpr int n = n_components * (order + 1);
      for (int b = 0; b <= order; ++b)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            {
              Number *entry = matrix + i * n + n_components * b + j;
              entry[0]      = factor * rows.by_displacement[b][i][j];
              entry[3]      = factor * rows.by_spin[b][i][j];
            }
    }

    /** Rows of a nodal force: converts derivatives by psi to derivatives by
     * spins. */
    template <int order, class Number>
    inline Rows<order, Number>
    rows_of_force(const ElementHessian<order, Number> &h,
                  const NodeOperators<order, Number>  &nodes,
                  const int                            a,
                  const VectorOf<Number>              &force)
    {
      Rows<order, Number> rows;
      // The force turns with the middle rotation.
      rows.by_middle = h.force_middle[a] - cross_product_tensor(force);
      for (int b = 0; b <= order; ++b)
        {
          rows.by_displacement[b] = h.force_force[a][b];
          rows.by_spin[b]         = h.force_psi[a][b] * nodes.psi_by_spin[b];
          rows.by_middle -= rows.by_spin[b];
        }
      return rows;
    }

    /** Rows of the nodal moment T(psi_a)^-1 times the moment @p by_psi that
     * acts on psi_a. */
    template <int order, class Number>
    inline Rows<order, Number>
    rows_of_moment(const ElementHessian<order, Number>    &h,
                   const NodeOperators<order, Number>     &nodes,
                   const RelativeRotations<order, Number> &relative,
                   const int                               a,
                   const VectorOf<Number>                 &by_psi)
    {
      Rows<order, Number>    rows;
      const TensorOf<Number> to_spin = transpose(nodes.psi_by_spin[a]);
      rows.by_middle                 = to_spin * h.psi_middle[a];
      for (int b = 0; b <= order; ++b)
        {
          rows.by_displacement[b] = to_spin * transpose(h.force_psi[b][a]);
          rows.by_spin[b] = to_spin * h.psi_psi[a][b] * nodes.psi_by_spin[b];
          if (b == a)
            rows.by_spin[a] +=
              inverse_tangent_derivative(InverseRotationCoefficientsOf<Number>(
                                           relative.psi[a]),
                                         relative.psi[a],
                                         by_psi) *
              nodes.psi_by_spin[a];
          rows.by_middle -= rows.by_spin[b];
        }
      return rows;
    }

    /** Rows of the moment on the middle rotation: the couple minus the nodal
     * moments. */
    template <int order, class Number>
    inline Rows<order, Number>
    rows_of_middle(const ElementHessian<order, Number> &h,
                   const NodeOperators<order, Number>  &nodes,
                   const Rows<order, Number>           *moments)
    {
      Rows<order, Number> rows;
      rows.by_middle = h.middle_middle;
      for (int b = 0; b <= order; ++b)
        {
          rows.by_displacement[b] = h.middle_force[b];
          rows.by_spin[b]         = h.middle_psi[b] * nodes.psi_by_spin[b];
          rows.by_middle -= rows.by_spin[b];
        }
      for (int a = 0; a <= order; ++a)
        {
          for (int b = 0; b <= order; ++b)
            {
              rows.by_displacement[b] -= moments[a].by_displacement[b];
              rows.by_spin[b] -= moments[a].by_spin[b];
            }
          rows.by_middle -= moments[a].by_middle;
        }
      return rows;
    }

    /** Adds V_end^T times the moment on the middle rotation to the moment of an
     * end. */
    template <int order, class Number>
    inline void add_to_end(const int                           end,
                           const NodeOperators<order, Number> &nodes,
                           const Rows<order, Number>          &middle_rows,
                           const VectorOf<Number>             &on_middle,
                           Rows<order, Number>                &moment)
    {
      const TensorOf<Number> share = transpose(nodes.middle_by_spin[end]);
      for (int b = 0; b <= order; ++b)
        {
          moment.by_displacement[b] += share * middle_rows.by_displacement[b];
          moment.by_spin[b] += share * middle_rows.by_spin[b];
        }
      // chi is psi of the second end.
      const TensorOf<Number> by_chi =
        nodes.end_derivative(end, on_middle) * nodes.psi_by_spin[1];
      moment.by_spin[1] += by_chi;
      moment.by_middle += share * middle_rows.by_middle - by_chi;
    }

    /**
     * Derivative @p factor dF/d(u, theta) of the internal force, row by row
     * into @p matrix (6 (order + 1) squared).
     * @param sections section forces at the Gauss points and their derivatives
     *   by strains
     */
    template <int order, class Number, class Stiffness>
    inline void tangent_with_forces(
      const BeamShape<order>                 &shape,
      const ElementKinematics<order, Number> &element,
      const Number                            jacobian,
      const LinearizedOf<Number, Stiffness> (&sections)[order],
      const Number factor,
      Number      *matrix)
    {
      constexpr int                  n = n_components * (order + 1);
      ElementGradient<order, Number> gradient;
      ElementHessian<order, Number>  hessian;
      for (int g = 0; g < order; ++g)
        {
          const KinematicsOf<Number> &point = element.points[g];
          const GradientOf<Number>    at_point =
            energy_gradient(point,
                            sections[g].forces.force,
                            sections[g].forces.moment);
          gradient.add(shape, g, jacobian, at_point);
          hessian.template add<Stiffness::can_couple>(
            shape,
            g,
            jacobian,
            point,
            at_point,
            energy_hessian(point, sections[g].stiffness, at_point));
        }
      hessian.complete();
      const NodeOperators<order, Number> operators(element.relative);
      VectorOf<Number>                   moments[order + 1], at_ends;
      gradient.find_moments(operators, moments, at_ends);

      Rows<order, Number> moment_rows[order + 1];
      for (int a = 0; a <= order; ++a)
        moment_rows[a] = rows_of_moment(hessian,
                                        operators,
                                        element.relative,
                                        a,
                                        gradient.by_psi[a]);
      const Rows<order, Number> middle_rows =
        rows_of_middle(hessian, operators, moment_rows);
      for (int a = 0; a <= order; ++a)
        {
          Rows<order, Number> force_rows =
            rows_of_force(hessian, operators, a, gradient.force[a]);
          force_rows.eliminate_middle(operators);
          write_rows(force_rows, factor, matrix + n_components * a * n);
          if (a < 2)
            add_to_end(a, operators, middle_rows, at_ends, moment_rows[a]);
          moment_rows[a].by_middle -= cross_product_tensor(moments[a]);
          moment_rows[a].eliminate_middle(operators);
          write_rows(moment_rows[a],
                     factor,
                     matrix + (n_components * a + 3) * n);
        }
    }

    /** Tangent stiffness @p factor dF/d(u, theta) of the internal force, row by
     * row into @p matrix (6 (order + 1) squared). */
    template <int order, class Number, class Section>
    inline void tangent(const BeamShape<order>                 &shape,
                        const ElementKinematics<order, Number> &element,
                        const Number                            jacobian,
                        const Section                          &section,
                        const Number                            factor,
                        Number                                 *matrix)
    {
      decltype(section.linearized(0, StrainsOf<Number>())) sections[order];
      for (int g = 0; g < order; ++g)
        sections[g] = section.linearized(g, element.points[g].strains);
      tangent_with_forces(shape, element, jacobian, sections, factor, matrix);
    }

    /** Geometric stiffness of section @p forces at the Gauss points (N, Q_2,
     * Q_3, T, M_2, M_3). */
    template <int order, class Number, class Forces>
    inline void
    geometric_tangent(const BeamShape<order>                 &shape,
                      const ElementKinematics<order, Number> &element,
                      const Number                            jacobian,
                      const Forces                           *forces,
                      Number                                 *matrix)
    {
      LinearizedOf<Number> sections[order];
      for (int g = 0; g < order; ++g)
        sections[g] = {
          {VectorOf<Number>({forces[g][0], forces[g][1], forces[g][2]}),
           VectorOf<Number>({forces[g][3], forces[g][4], forces[g][5]})},
          StiffnessOf<Number>{}};
      tangent_with_forces(shape,
                          element,
                          jacobian,
                          sections,
                          /*factor=*/Number(1),
                          matrix);
    }

    /**
     * Tangent of the small-displacement form: the exact tangent at rest with
     * the
     * stiffness of the section at the strains of @p u.
     */
    template <int order, class Number, class Section>
    inline void small_displacement_tangent(const BeamShape<order> &shape,
                                           const FrameOf<Number>  *frames,
                                           const Number            jacobian,
                                           const Section          &section,
                                           const Number           *u,
                                           const Number            factor,
                                           Number                 *matrix)
    {
      const NodeOf<Number> at_rest[order + 1] = {};
      decltype(section.linearized(0, StrainsOf<Number>())) sections[order];
      for (int g = 0; g < order; ++g)
        {
          sections[g] = section.linearized(
            g,
            small_displacement_strains(shape, g, frames, jacobian, u));
          sections[g].forces = {};
        }
      tangent_with_forces(
        shape,
        ElementKinematics<order, Number>(shape, frames, jacobian, at_rest),
        jacobian,
        sections,
        factor,
        matrix);
    }
  } // namespace Beam3D
} // namespace auxfem

#endif
