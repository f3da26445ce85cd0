#include <auxfem/elements/beam_shape.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * How far out Gauss points have to move for the compliance of an element
     * with a linear moment to be less by the part @p shear. With half the
     * points' second moment q, 1/3 at rest, it is as 1 / q where the deflection
     * is a cubic, and as (1 - q)^2 / q where it is a parabola that follows the
     * rotation at two points.
     */
    double distance_making_up_for(const double shear, const int order)
    {
      if (order > 2)
        return 1 / std::sqrt(1 - shear);
      const double half_sum = 1 + 2. / 3 * (1 - shear);
      return std::sqrt(3 * (half_sum - std::sqrt(half_sum * half_sum - 1)));
    }
  } // namespace

  template <int order>
  BeamShape<order>::BeamShape(const bool makes_up_for_shear)
  {
    // A single point stays where it is.
    const double distance = order > 1 && makes_up_for_shear
      ? distance_making_up_for(shear_made_up_for, order)
      : 1.;

    const dealii::FE_Q<1>   fe(order);
    const dealii::QGauss<1> reduced(order), full(order + 1);
    for (int a = 0; a < n_nodes; ++a)
      node[a] = 2 * fe.get_unit_support_points()[a][0] - 1;
    for (int g = 0; g < order; ++g)
      {
        point[g]  = distance * (2 * reduced.point(g)[0] - 1);
        weight[g] = 2 * reduced.weight(g);
        const dealii::Point<1> on_unit_cell((1 + point[g]) / 2);
        for (int a = 0; a < n_nodes; ++a)
          {
            value[g][a]      = fe.shape_value(a, on_unit_cell);
            derivative[g][a] = fe.shape_grad(a, on_unit_cell)[0] / 2;
          }
      }
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
