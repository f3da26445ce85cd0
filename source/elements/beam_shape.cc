#include <auxfem/elements/beam_shape.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace auxfem
{
  namespace
  {
    template <int order>
    using PointMatrix = std::array<std::array<double, order>, order>;

    /** Orthonormal polynomials of degree 0 to order - 1, by degree, at the
     * Gauss points. */
    template <int order>
    PointMatrix<order> legendre_polynomials(const BeamShape<order> &shape)
    {
      PointMatrix<order> values;
      for (int g = 0; g < order; ++g)
        {
          double before = 0, now = 1;
          for (int k = 0; k < order; ++k)
            {
              values[k][g] = std::sqrt(k + 0.5) * now;
              const double next =
                ((2 * k + 1) * shape.point[g] * now - k * before) / (k + 1);
              before = now;
              now    = next;
            }
        }
      return values;
    }

    /** Integrals of the products of their derivatives. */
    template <int order>
    PointMatrix<order> products_of_derivatives()
    {
      PointMatrix<order> products;
      for (int i = 0; i < order; ++i)
        for (int k = 0; k < order; ++k)
          {
            // P_i' = sum of (2 j + 1) P_j, j = i - 1, i - 3, ...
            const int lower = std::min(i, k);
            products[i][k]  = (i + k) % 2 != 0
               ? 0.
               : std::sqrt((i + 0.5) * (k + 0.5)) * lower * (lower + 1);
          }
      return products;
    }

    /**
     * L^-1 with L L^T = I - X, X the compliance of the @p shear that is made up
     * for over that of bending, both of moments in terms of
     * legendre_polynomials().
     */
    template <int order>
    PointMatrix<order> inverse_root_of_compliance(const double shear)
    {
      const PointMatrix<order> products = products_of_derivatives<order>();
      PointMatrix<order>       L{}, inverse{};
      for (int i = 0; i < order; ++i)
        for (int k = 0; k <= i; ++k)
          {
            double rest = (i == k ? 1. : 0.) - shear / 3 * products[i][k];
            for (int j = 0; j < k; ++j)
              rest -= L[i][j] * L[k][j];
            L[i][k] = i == k ? std::sqrt(rest) : rest / L[k][k];
          }
      for (int k = 0; k < order; ++k)
        for (int i = k; i < order; ++i)
          {
            double rest = i == k ? 1. : 0.;
            for (int j = k; j < i; ++j)
              rest -= L[i][j] * inverse[j][k];
            inverse[i][k] = rest / L[i][i];
          }
      return inverse;
    }

    /** Sets rotation_derivative and moment. */
    template <int order>
    void make_up_for_shear(BeamShape<order> &shape)
    {
      const PointMatrix<order> polynomials = legendre_polynomials(shape),
                               root        = inverse_root_of_compliance<order>(
                                 BeamShape<order>::shear_made_up_for);
      for (int g = 0; g < order; ++g)
        {
          std::fill_n(shape.moment[g], order, 0.);
          std::fill_n(shape.rotation_derivative[g], order + 1, 0.);
          for (int h = 0; h < order; ++h)
            {
              double curvature = 0;
              for (int i = 0; i < order; ++i)
                for (int k = 0; k <= i; ++k)
                  {
                    const double part = shape.weight[h] * root[i][k];
                    curvature += part * polynomials[i][g] * polynomials[k][h];
                    shape.moment[g][h] +=
                      part * polynomials[k][g] * polynomials[i][h];
                  }
              for (int a = 0; a <= order; ++a)
                shape.rotation_derivative[g][a] +=
                  curvature * shape.derivative[h][a];
            }
        }
    }
  } // namespace

  template <int order>
  BeamShape<order>::BeamShape(const bool makes_up_for_shear)
  {
    const dealii::FE_Q<1>   fe(order);
    const dealii::QGauss<1> reduced(order), full(order + 1);
    for (int a = 0; a < n_nodes; ++a)
      node[a] = 2 * fe.get_unit_support_points()[a][0] - 1;
    for (int g = 0; g < order; ++g)
      {
        point[g]  = 2 * reduced.point(g)[0] - 1;
        weight[g] = 2 * reduced.weight(g);
        const dealii::Point<1> on_unit_cell((1 + point[g]) / 2);
        for (int a = 0; a < n_nodes; ++a)
          {
            value[g][a]               = fe.shape_value(a, on_unit_cell);
            derivative[g][a]          = fe.shape_grad(a, on_unit_cell)[0] / 2;
            rotation_derivative[g][a] = derivative[g][a];
          }
        for (int h = 0; h < order; ++h)
          moment[g][h] = h == g ? 1. : 0.;
      }
    // Linear elements are stiffer as they are.
    if (makes_up_for_shear && order > 1)
      make_up_for_shear(*this);
    for (int a = 0; a < n_nodes; ++a)
      {
        integral[a] = 0;
        for (int b = 0; b < n_nodes; ++b)
          mass[a][b] = 0;
        for (unsigned int q = 0; q < full.size(); ++q)
          {
            const double weighted =
              2 * full.weight(q) * fe.shape_value(a, full.point(q));
            integral[a] += weighted;
            for (int b = 0; b < n_nodes; ++b)
              mass[a][b] += weighted * fe.shape_value(b, full.point(q));
          }
      }
  }

  template <int order>
  void BeamShape<order>::values_at(const double xi, double *values) const
  {
    for (int a = 0; a < n_nodes; ++a)
      {
        values[a] = 1;
        for (int b = 0; b < n_nodes; ++b)
          if (b != a)
            values[a] *= (xi - node[b]) / (node[a] - node[b]);
      }
  }

  template <int order>
  void BeamShape<order>::gauss_interpolation_at(const double xi,
                                                double      *values) const
  {
    for (int g = 0; g < order; ++g)
      {
        values[g] = 1;
        for (int h = 0; h < order; ++h)
          if (h != g)
            values[g] *= (xi - point[h]) / (point[g] - point[h]);
      }
  }

  template struct BeamShape<1>;
  template struct BeamShape<2>;
  template struct BeamShape<3>;
  template struct BeamShape<4>;
  template struct BeamShape<5>;
  template struct BeamShape<6>;
} // namespace auxfem
