#include <auxfem/algebra/dense_block.h>
#include <auxfem/struts/beam_shape.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <array>
#include <vector>

namespace auxfem
{
  namespace
  {
    template <int order>
    using PointMatrix = std::array<std::array<double, order>, order>;

    /**
     * Curvatures at the Gauss points by the derivatives of rotations there. In
     * orthonormal polynomials this is L^-1 with L L^T = I - X. X is the shear
     * compliance of @p shear over the bending compliance (doc/theory/struts.md,
     * Sections).
     */
    template <int order>
    PointMatrix<order> curvatures_by_derivatives(const double shear)
    {
      const dealii::QGauss<1> gauss(order);
      const auto              legendre =
        dealii::Polynomials::Legendre::generate_complete_basis(order - 1);
      PointMatrix<order> values, slopes;
      for (int k = 0; k < order; ++k)
        for (int g = 0; g < order; ++g)
          {
            std::vector<double> value_and_slope(2);
            legendre[k].value(gauss.point(g)[0], value_and_slope);
            values[k][g] = value_and_slope[0];
            slopes[k][g] = value_and_slope[1];
          }
      double root[order * order];
      for (int i = 0; i < order; ++i)
        for (int k = 0; k < order; ++k)
          {
            double &compliance = root[i * order + k];
            compliance         = i == k ? 1. : 0.;
            for (int g = 0; g < order; ++g)
              compliance -=
                shear / 12 * gauss.weight(g) * slopes[i][g] * slopes[k][g];
          }
      invert_root(root, order);
      PointMatrix<order> curvatures;
      for (int g = 0; g < order; ++g)
        for (int h = 0; h < order; ++h)
          {
            curvatures[g][h] = 0;
            for (int i = 0; i < order; ++i)
              for (int k = 0; k < order; ++k)
                curvatures[g][h] += values[i][g] * root[i * order + k] *
                  values[k][h] * gauss.weight(h);
          }
      return curvatures;
    }

    /** Sets rotation_derivative and moment. */
    template <int order>
    void compensate_shear(BeamShape<order> &shape, const double shear)
    {
      const PointMatrix<order> curvatures =
        curvatures_by_derivatives<order>(shear);
      for (int g = 0; g < order; ++g)
        {
          std::fill_n(shape.rotation_derivative[g], order + 1, 0.);
          for (int h = 0; h < order; ++h)
            {
              shape.moment[g][h] =
                curvatures[h][g] * shape.weight[h] / shape.weight[g];
              for (int a = 0; a <= order; ++a)
                shape.rotation_derivative[g][a] +=
                  curvatures[g][h] * shape.derivative[h][a];
            }
        }
    }
  } // namespace

  template <int order>
  BeamShape<order>::BeamShape(const double compensated_shear)
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
    // Linear elements already have this stiffness.
    if (compensated_shear > 0 && order > 1)
      compensate_shear(*this, compensated_shear);
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
