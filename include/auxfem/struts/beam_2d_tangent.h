#ifndef auxfem_struts_beam_2d_tangent_h
#define auxfem_struts_beam_2d_tangent_h

#include <auxfem/struts/beam_2d.h>

#include <algorithm>
#include <type_traits>

namespace auxfem
{
  namespace Beam2D
  {
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
                                const ForcesOf<Number>     &forces,
                                const StiffnessOf<Number>  &stiffness,
                                const GradientOf<Number>   &velocity,
                                const double                stiffness_factor,
                                const double                damping_factor,
                                Number (&G)[3][3])
    {
      const Number beta     = damped ? stiffness.damping_time : 0.;
      const Number material = stiffness_factor + beta * damping_factor;
      // Derivatives of N and Q by r'.t, r'.n, phi.
      Number dN[3] = {stiffness.axial * material,
                      0,
                      stiffness.axial * material * k.slip};
      Number dQ[3] = {0,
                      stiffness.shear * material,
                      -stiffness.shear * material * k.stretch};
      Number N = forces.axial, Q = forces.shear;
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

    /** Derivatives of epsilon, gamma, kappa at a point by u_x, u_y, phi of the
     * nodes. */
    template <int order, class Number>
    struct StrainOperator
    {
      /**
       * @param cosine, sine direction of t
       * @param stretch, slip r'.t, r'.n
       * @param value, rotation_slope derivatives of the rotation at the point
       *   and of its slope times J by nodal rotations
       */
      template <class Values, class Slopes>
      StrainOperator(const BeamShape<order> &shape,
                     const int               g,
                     const Number           &jacobian,
                     const Number           &cosine,
                     const Number           &sine,
                     const Number           &stretch,
                     const Number           &slip,
                     const Values           &value,
                     const Slopes           &rotation_slope)
      {
        for (int a = 0; a <= order; ++a)
          {
            const Number slope      = shape.derivative[g][a] / jacobian;
            const Number rows[3][3] = {
              {cosine * slope, sine * slope, slip * value[a]},
              {-sine * slope, cosine * slope, -stretch * value[a]},
              {0, 0, rotation_slope[a] / jacobian}};
            for (int k = 0; k < 3; ++k)
              std::copy_n(rows[k], 3, by_node[a][k]);
          }
      }

      StrainOperator(const BeamShape<order>     &shape,
                     const int                   g,
                     const Number               &jacobian,
                     const KinematicsOf<Number> &k)
        : StrainOperator(shape,
                         g,
                         jacobian,
                         k.cosine,
                         k.sine,
                         k.stretch,
                         k.slip,
                         shape.value[g],
                         shape.rotation_derivative[g])
      {}

      Number by_node[order + 1][3][3]; ///< node, strain, component
    };

    /**
     * Adds the part of an element tangent by which section forces depend on
     * other strains than their own.
     * @param factor weight of the Gauss point
     * @param rows, columns strains by virtual and by real displacements
     */
    template <int order, class Number>
    inline void add_couplings(const CoupledStiffnessOf<Number>    &stiffness,
                              const Number                        &factor,
                              const StrainOperator<order, Number> &rows,
                              const StrainOperator<order, Number> &columns,
                              Number                              *matrix)
    {
      constexpr int n       = 3 * (order + 1);
      const Number  C[3][3] = {
         {0, factor * stiffness.axial_shear, factor * stiffness.axial_bending},
         {factor * stiffness.axial_shear, 0, factor * stiffness.shear_bending},
         {factor * stiffness.axial_bending,
          factor * stiffness.shear_bending,
          0}};
      for (int a = 0; a <= order; ++a)
        for (int i = 0; i < 3; ++i)
          {
            Number by_strain[3] = {};
            for (int k = 0; k < 3; ++k)
              for (int l = 0; l < 3; ++l)
                by_strain[l] += rows.by_node[a][k][i] * C[k][l];
            for (int b = 0; b <= order; ++b)
              for (int j = 0; j < 3; ++j)
                for (int l = 0; l < 3; ++l)
                  matrix[(3 * a + i) * n + 3 * b + j] +=
                    by_strain[l] * columns.by_node[b][l][j];
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
          const GradientOf<Number> rate = damped
            ? interpolate(shape, g, inverse_jacobian, v)
            : GradientOf<Number>{0, 0, 0, 0};
          const auto linearized         = section.linearized(g, k.strains());
          Number     G[3][3];
          section_tangent<large_rotation, damped>(k,
                                                  linearized.forces,
                                                  linearized.stiffness,
                                                  rate,
                                                  stiffness_factor,
                                                  damping_factor,
                                                  G);
          const StiffnessOf<Number> &stiffness = linearized.stiffness;
          const Number               bending   = stiffness.bending *
            (stiffness_factor +
             (damped ? stiffness.damping_time * damping_factor : 0.));

          add_section(shape, g, jacobian, k, G, bending, matrix);
          if constexpr (std::decay_t<
                          decltype(linearized.stiffness)>::can_couple)
            if (linearized.stiffness.is_coupled)
              {
                const StrainOperator<order, Number> strains(shape,
                                                            g,
                                                            jacobian,
                                                            k);
                add_couplings(linearized.stiffness,
                              Number(shape.weight[g] * jacobian *
                                     stiffness_factor),
                              strains,
                              strains,
                              matrix);
              }
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
