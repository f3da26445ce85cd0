#include <auxfem/contact/effects/strut_curves.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace auxfem
{
  namespace
  {
    /** Monomial coefficients of the Lagrange polynomials on points of [0, 1],
     * by point. */
    std::vector<double>
    lagrange_coefficients(const std::vector<dealii::Point<1>> &points)
    {
      std::vector<double> coefficients;
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          std::vector<double> powers = {1.};
          for (unsigned int j = 0; j < points.size(); ++j)
            if (j != i)
              {
                const double width = points[i][0] - points[j][0];
                powers.push_back(0.);
                for (std::size_t k = powers.size(); k-- > 0;)
                  powers[k] =
                    ((k > 0 ? powers[k - 1] : 0.) - points[j][0] * powers[k]) /
                    width;
              }
          coefficients.insert(coefficients.end(), powers.begin(), powers.end());
        }
      return coefficients;
    }

    /** Whether a point is at least @p least (m) from all curves. */
    bool is_apart(const AxisCurve::Vector      &point,
                  const std::vector<AxisCurve> &curves,
                  const double                  least)
    {
      return std::all_of(curves.begin(),
                         curves.end(),
                         [&](const AxisCurve &curve) {
                           return nearest_point(curve, point).distance >= least;
                         });
    }

    /** Parameter at which a curve leaves the range of others, by bisection. */
    double free_end(const AxisCurve              &curve,
                    const std::vector<AxisCurve> &others,
                    const double                  least,
                    double                        occupied,
                    double                        free)
    {
      while (std::abs(free - occupied) > position_tolerance)
        {
          const double middle = (free + occupied) / 2;
          (is_apart(curve.at(middle), others, least) ? free : occupied) =
            middle;
        }
      return free;
    }
  } // namespace

  StrutCurves::StrutCurves(const LatticeModel             &model,
                           const std::vector<ContactAxis> &axes)
    : model(model)
    , axes(axes)
    , axes_of_lines(axes.empty() ? 0 : axes.back().line + 1)
  {
    basis_of.reserve(axes.size());
    for (unsigned int a = 0; a < axes.size(); ++a)
      {
        const unsigned int order = axes[a].order;
        Basis             &basis = bases[order];
        if (basis.coefficients.empty())
          basis = make_basis(order);
        basis_of.push_back(&basis);
        std::array<unsigned int, 2> &axis_range = axes_of_lines[axes[a].line];
        if (axis_range[0] == axis_range[1])
          axis_range[0] = a;
        axis_range[1] = a + 1;
        if (model.lattice.struts[axes[a].strut].sagitta != 0)
          arcs.emplace(a, arc_at_rest(axes[a]));
      }
    find_connected();
  }

  StrutCurves::Basis StrutCurves::make_basis(const unsigned int order)
  {
    Basis               basis{order,
                lagrange_coefficients(
                  dealii::FE_Q<1>(order).get_unit_support_points()),
                {},
                0};
    std::vector<double> values(order + 1), slopes(order + 1);
    for (unsigned int i = 0; i <= order; ++i)
      {
        basis.values_at(double(i) / order, values.data(), slopes.data());
        basis.slopes.insert(basis.slopes.end(), slopes.begin(), slopes.end());
        double sum = 0;
        for (const double slope : slopes)
          sum += std::abs(slope);
        basis.steepest = std::max(basis.steepest, sum);
      }
    return basis;
  }

  void StrutCurves::Basis::values_at(const double parameter,
                                     double      *values,
                                     double      *derivatives) const
  {
    const unsigned int n = degree + 1;
    for (unsigned int node = 0; node < n; ++node)
      {
        const double *c     = coefficients.data() + node * n;
        double        value = c[n - 1], slope = 0;
        for (unsigned int k = n - 1; k-- > 0;)
          {
            slope = value + parameter * slope;
            value = c[k] + parameter * value;
          }
        values[node] = value;
        if (derivatives != nullptr)
          derivatives[node] = slope;
      }
  }

  template <unsigned int dimension>
  double StrutCurves::Basis::largest_slope(const double *const motion) const
  {
    const unsigned int n       = degree + 1;
    const double      *slope   = slopes.data();
    double             largest = 0;
    for (unsigned int i = 0; i < n; ++i)
      {
        std::array<double, dimension> sum{};
        for (unsigned int node = 0; node < n; ++node, ++slope)
          for (unsigned int c = 0; c < dimension; ++c)
            sum[c] += *slope * motion[node * dimension + c];
        double square = 0;
        for (const double component : sum)
          square += component * component;
        largest = std::max(largest, square);
      }
    return std::sqrt(largest);
  }

  double StrutCurves::axis_rotation(const unsigned int  axis,
                                    const double *const motion) const
  {
    const Basis &basis = *basis_of[axis];
    return (model.lattice.dimension == 2 ? basis.largest_slope<2>(motion)
                                         : basis.largest_slope<3>(motion)) /
      axes[axis].length;
  }

  double StrutCurves::largest_axis_rotation(const unsigned int axis,
                                            const double       motion) const
  {
    return basis_of[axis]->steepest * motion / axes[axis].length;
  }

  AxisCurve StrutCurves::arc_at_rest(const ContactAxis &axis) const
  {
    constexpr unsigned int         n = 11;
    const dealii::QGaussLobatto<1> points(n);
    const std::vector<double>      powers =
      lagrange_coefficients(points.get_points());
    AxisCurve curve;
    curve.degree = n - 1;
    // The strut of a copy lies elsewhere.
    dealii::Point<3>     first;
    dealii::Tensor<1, 3> any;
    model.lattice.axis(model.lattice.struts[axis.strut],
                       axis.begin,
                       first,
                       any);
    for (unsigned int i = 0; i < n; ++i)
      {
        dealii::Point<3>     position;
        dealii::Tensor<1, 3> tangent;
        model.lattice.axis(model.lattice.struts[axis.strut],
                           axis.begin +
                             (axis.end - axis.begin) * points.point(i)[0],
                           position,
                           tangent);
        position += axis.ends[0] - first;
        for (unsigned int k = 0; k < n; ++k)
          curve.coefficients[k] += powers[i * n + k] * position;
      }
    return curve;
  }

  AxisCurve StrutCurves::at_rest(const unsigned int axis) const
  {
    if (const auto arc = arcs.find(axis); arc != arcs.end())
      return arc->second;
    AxisCurve line;
    line.degree          = 1;
    line.coefficients[0] = axes[axis].ends[0];
    line.coefficients[1] = axes[axis].ends[1] - axes[axis].ends[0];
    return line;
  }

  AxisCurve StrutCurves::curve(const unsigned int  a,
                               const int *const    unknowns,
                               const double *const values) const
  {
    const Basis       &basis     = *basis_of[a];
    const unsigned int dimension = model.lattice.dimension,
                       n         = basis.degree + 1;
    AxisCurve curve              = at_rest(a);
    curve.degree                 = std::max(curve.degree, basis.degree);
    for (unsigned int node = 0; node < n; ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        {
          const double u = values[unknowns[node * dimension + c]];
          for (unsigned int k = 0; k < n; ++k)
            curve.coefficients[k][c] += basis.coefficients[node * n + k] * u;
        }
    const std::vector<double> &factors = axes[a].axis_factors;
    for (unsigned int d = 0; d < factors.size(); ++d)
      for (unsigned int c = 0; c < dimension; ++c)
        curve.coefficients[0][c] +=
          factors[d] * values[unknowns[(n + d) * dimension + c]];
    // Lowering the degree speeds up straight axes, which are frequent.
    while (curve.degree > 1 &&
           curve.coefficients[curve.degree] == AxisCurve::Vector())
      --curve.degree;
    return curve;
  }

  bool StrutCurves::are_neighbours(const unsigned int one,
                                   const unsigned int other) const
  {
    const auto &first = axes[one].strut_ends, &second = axes[other].strut_ends;
    return axes[one].line == axes[other].line || first[0] == second[0] ||
      first[0] == second[1] || first[1] == second[0] || first[1] == second[1];
  }

  namespace
  {
    /** Whether another pair stands for the contact of two axes in an infinite
     * lattice: a strut touches copies of later ones, and of itself on one side.
     */
    bool is_repeated(const ContactAxis &one, const ContactAxis &other)
    {
      if (one.is_copy() == other.is_copy())
        return one.is_copy();
      const ContactAxis &original = one.is_copy() ? other : one,
                        &copy     = one.is_copy() ? one : other;
      return copy.strut < original.strut ||
        (copy.strut == original.strut && copy.shift < std::array<int, 3>{});
    }
  } // namespace

  bool StrutCurves::never_touch(const unsigned int one,
                                const unsigned int other) const
  {
    const Strut &first  = model.lattice.struts[axes[one].strut],
                &second = model.lattice.struts[axes[other].strut];
    return is_removed(one) || is_removed(other) ||
      is_repeated(axes[one], axes[other]) ||
      (first.is_rigid() && first.rigid_part == second.rigid_part &&
       axes[one].shift == axes[other].shift) ||
      !(thickness(one, other) > 0) || axes[one].stiffness == 0 ||
      axes[other].stiffness == 0 || (first.is_rigid() && first.sagitta != 0) ||
      (second.is_rigid() && second.sagitta != 0);
  }

  std::vector<CommonNode>
  StrutCurves::common_nodes(const unsigned int one,
                            const unsigned int other) const
  {
    // FE_Q lists the end nodes first.
    std::vector<CommonNode> nodes;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        if (axes[one].end_points[i] == axes[other].end_points[j])
          nodes.push_back({{{double(i), double(j)}}});
    return nodes;
  }

  void StrutCurves::find_connected()
  {
    unsigned int n_points = 0;
    for (const ContactAxis &axis : axes)
      for (const unsigned int point : axis.end_points)
        n_points = std::max(n_points, point + 1);
    const IndexLists          at_points(n_points, [&](const auto &add) {
      for (unsigned int a = 0; a < axes.size(); ++a)
        for (const unsigned int point : axes[a].end_points)
          add(point, a);
    });
    std::vector<unsigned int> others;
    for (unsigned int a = 0; a < axes.size(); ++a)
      {
        others.clear();
        for (const unsigned int point : axes[a].end_points)
          for (const unsigned int other : at_points[point])
            if (other > a)
              others.push_back(other);
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        // A straight element cannot reach itself.
        if (basis_of[a]->degree > 2)
          others.insert(others.begin(), a);
        for (const unsigned int other : others)
          if (!never_touch(a, other))
            connected_pairs.push_back({{a, other}});
      }
  }

  const ParameterRanges &
  StrutCurves::free_ranges(const unsigned int axis,
                           const unsigned int other) const
  {
    const auto key   = (std::uint64_t(axis) << 32) | axes[other].line;
    const auto known = known_ranges.find(key);
    if (known != known_ranges.end())
      return known->second;
    return known_ranges.emplace(key, find_free_ranges(axis, other))
      .first->second;
  }

  ParameterRanges StrutCurves::find_free_ranges(const unsigned int axis,
                                                const unsigned int other) const
  {
    if (axes[axis].line == axes[other].line)
      return {{{0., 1.}}};
    const double           least = free_distance(axis, other);
    std::vector<AxisCurve> others;
    const auto [first, last] = axes_of(axes[other].line);
    for (unsigned int b = first; b < last; ++b)
      others.push_back(at_rest(b));
    const AxisCurve    curve = at_rest(axis);
    const unsigned int n     = 8 + 2 * curve.degree;
    ParameterRanges    ranges;
    double             begin = -1, before = 0;
    bool               was_free = false;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double at      = double(i) / n;
        const bool   is_free = is_apart(curve.at(at), others, least);
        if (is_free && !was_free)
          begin = i == 0 ? 0. : free_end(curve, others, least, before, at);
        if (!is_free && was_free)
          ranges.push_back(
            {{begin, free_end(curve, others, least, at, before)}});
        was_free = is_free;
        before   = at;
      }
    if (was_free)
      ranges.push_back({{begin, 1.}});
    return ranges;
  }

  ParameterRanges
  StrutCurves::self_contact_ranges(const unsigned int axis,
                                   const double       parameter,
                                   const unsigned int other) const
  {
    const ContactAxis &one = axes[axis], &target = axes[other];
    const double       length = one.length / (one.end - one.begin),
                 apart = dealii::numbers::PI * thickness(axis, other) / length,
                 here  = one.begin + (one.end - one.begin) * parameter;
    const auto parameter_at = [&target](const double fraction) {
      return std::clamp((fraction - target.begin) / (target.end - target.begin),
                        0.,
                        1.);
    };
    ParameterRanges parts;
    if (const double end = parameter_at(here - apart); end > 0)
      parts.push_back({{0., end}});
    if (const double begin = parameter_at(here + apart); begin < 1)
      parts.push_back({{begin, 1.}});
    return parts;
  }
} // namespace auxfem
