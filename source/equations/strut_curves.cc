#include <auxfem/equations/strut_curves.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Coefficients of Lagrange polynomials through points of [0, 1], point
     * after point. */
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
  } // namespace

  StrutCurves::StrutCurves(const LatticeModel             &model,
                           const std::vector<ContactAxis> &axes)
    : model(model)
    , axes(axes)
    , rest(axes.size())
  {
    for (unsigned int a = 0; a < axes.size(); ++a)
      {
        const unsigned int order = axes[a].n_nodes() - 1;
        Basis             &basis = bases[order];
        if (basis.coefficients.empty())
          basis = {order,
                   lagrange_coefficients(
                     dealii::FE_Q<1>(order).get_unit_support_points())};
        basis_of.push_back(&basis);
        const auto [entry, is_new] =
          axes_of_struts.emplace(axes[a].strut,
                                 std::array<unsigned int, 2>{{a, a + 1}});
        if (!is_new)
          entry->second[1] = a + 1;
        set_rest(a);
      }
    find_neighbours();
  }

  void StrutCurves::set_rest(const unsigned int a)
  {
    const ContactAxis &axis  = axes[a];
    const Strut       &strut = model.lattice.struts[axis.strut];
    AxisCurve         &curve = rest[a];
    if (strut.sagitta == 0)
      {
        curve.degree          = 1;
        curve.coefficients[0] = axis.ends[0];
        curve.coefficients[1] = axis.ends[1] - axis.ends[0];
        return;
      }
    constexpr unsigned int         n = 11;
    const dealii::QGaussLobatto<1> points(n);
    const std::vector<double>      powers =
      lagrange_coefficients(points.get_points());
    curve.degree = n - 1;
    for (unsigned int i = 0; i < n; ++i)
      {
        dealii::Point<3>     position;
        dealii::Tensor<1, 3> tangent;
        model.lattice.axis(strut,
                           axis.begin +
                             (axis.end - axis.begin) * points.point(i)[0],
                           position,
                           tangent);
        for (unsigned int k = 0; k < n; ++k)
          curve.coefficients[k] += powers[i * n + k] * position;
      }
  }

  AxisCurve StrutCurves::at_rest(const unsigned int axis) const
  {
    return rest[axis];
  }

  AxisCurve StrutCurves::curve(const unsigned int  a,
                               const int *const    unknowns,
                               const double *const values) const
  {
    const Basis       &basis     = *basis_of[a];
    const unsigned int dimension = model.lattice.dimension,
                       n         = basis.degree + 1;
    AxisCurve curve              = rest[a];
    curve.degree                 = std::max(curve.degree, basis.degree);
    for (unsigned int node = 0; node < n; ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        {
          const double u = values[unknowns[node * dimension + c]];
          for (unsigned int k = 0; k < n; ++k)
            curve.coefficients[k][c] += basis.coefficients[node * n + k] * u;
        }
    return curve;
  }

  void StrutCurves::shape(const unsigned int a,
                          const double       parameter,
                          double            *values,
                          double            *slopes) const
  {
    const Basis       &basis = *basis_of[a];
    const unsigned int n     = basis.degree + 1;
    for (unsigned int node = 0; node < n; ++node)
      {
        const double *c     = basis.coefficients.data() + node * n;
        double        value = c[n - 1], slope = 0;
        for (unsigned int k = n - 1; k-- > 0;)
          {
            slope = value + parameter * slope;
            value = c[k] + parameter * value;
          }
        values[node] = value;
        if (slopes != nullptr)
          slopes[node] = slope;
      }
  }

  std::array<unsigned int, 2>
  StrutCurves::axes_of(const unsigned int strut) const
  {
    return axes_of_struts.at(strut);
  }

  bool StrutCurves::are_neighbours(const unsigned int one,
                                   const unsigned int other) const
  {
    const auto &first  = model.lattice.struts[axes[one].strut].joints,
               &second = model.lattice.struts[axes[other].strut].joints;
    return axes[one].strut == axes[other].strut || first[0] == second[0] ||
      first[0] == second[1] || first[1] == second[0] || first[1] == second[1];
  }

  bool StrutCurves::never_touch(const unsigned int one,
                                const unsigned int other) const
  {
    const Strut &first  = model.lattice.struts[axes[one].strut],
                &second = model.lattice.struts[axes[other].strut];
    return (first.is_rigid() && first.rigid_part == second.rigid_part) ||
      !(thickness(one, other) > 0) || axes[one].stiffness == 0 ||
      axes[other].stiffness == 0 || (first.is_rigid() && first.sagitta != 0) ||
      (second.is_rigid() && second.sagitta != 0);
  }

  void StrutCurves::find_neighbours()
  {
    std::map<unsigned int, std::vector<unsigned int>> struts_at;
    for (const auto &[strut, range] : axes_of_struts)
      for (const unsigned int joint : model.lattice.struts[strut].joints)
        struts_at[joint].push_back(strut);
    for (const auto &[strut, range] : axes_of_struts)
      {
        std::vector<unsigned int> others = {strut};
        for (const unsigned int joint : model.lattice.struts[strut].joints)
          for (const unsigned int other : struts_at[joint])
            if (other > strut)
              others.push_back(other);
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        for (const unsigned int other : others)
          for (unsigned int a = range[0]; a < range[1]; ++a)
            for (unsigned int b = axes_of(other)[0]; b < axes_of(other)[1]; ++b)
              // A straight element cannot reach itself.
              if ((a < b || (a == b && basis_of[a]->degree > 2)) &&
                  !never_touch(a, b))
                neighbour_pairs.push_back({{a, b}});
      }
  }

  double StrutCurves::rest_distance(const unsigned int axis,
                                    const double       parameter,
                                    const unsigned int strut) const
  {
    const AxisCurve::Vector point = rest[axis].at(parameter);
    double                  least = std::numeric_limits<double>::infinity();
    for (unsigned int b = axes_of(strut)[0]; b < axes_of(strut)[1]; ++b)
      least = std::min(least, nearest_point(rest[b], point).distance);
    return least;
  }

  double StrutCurves::free_end(const unsigned int axis,
                               const unsigned int strut,
                               const double       least,
                               double             occupied,
                               double             free) const
  {
    constexpr double digits = 1e-3;
    while (std::abs(free - occupied) > digits)
      {
        const double middle = (free + occupied) / 2;
        (rest_distance(axis, middle, strut) < least ? occupied : free) = middle;
      }
    return free;
  }

  const ParameterRanges &
  StrutCurves::free_ranges(const unsigned int axis,
                           const unsigned int other) const
  {
    const std::array<unsigned int, 2> key{{axis, axes[other].strut}};
    const auto                        known = known_ranges.find(key);
    if (known != known_ranges.end())
      return known->second;
    return known_ranges.emplace(key, find_free_ranges(axis, other))
      .first->second;
  }

  ParameterRanges StrutCurves::find_free_ranges(const unsigned int axis,
                                                const unsigned int other) const
  {
    // Neighbours come apart as far as they are thick before they count: at a
    // joint they bend.
    constexpr double apart = 2;
    if (axes[axis].strut == axes[other].strut)
      return {{{0., 1.}}};
    const unsigned int strut = axes[other].strut;
    const double       least =
      thickness(axis, other) * (are_neighbours(axis, other) ? apart : 1.);
    const unsigned int n = 8 + 2 * rest[axis].degree;
    ParameterRanges    ranges;
    double             begin = -1, before = 0;
    bool               was_free = false;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double at      = double(i) / n;
        const bool   is_free = rest_distance(axis, at, strut) >= least;
        if (is_free && !was_free)
          begin = i == 0 ? 0. : free_end(axis, strut, least, before, at);
        if (!is_free && was_free)
          ranges.push_back({{begin, free_end(axis, strut, least, at, before)}});
        was_free = is_free;
        before   = at;
      }
    if (was_free)
      ranges.push_back({{begin, 1.}});
    return ranges;
  }

  ParameterRanges StrutCurves::parts_apart(const unsigned int axis,
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

  bool StrutCurves::overlap_at_rest(const unsigned int one,
                                    const unsigned int other) const
  {
    const ParameterRanges &ranges = free_ranges(one, other);
    return !are_neighbours(one, other) &&
      (ranges.size() != 1 || ranges[0][0] > 0 || ranges[0][1] < 1);
  }
} // namespace auxfem
