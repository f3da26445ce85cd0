#include <auxfem/equations/effects/strut_touch.h>

namespace auxfem
{
  namespace
  {
    /** Largest number of nodes of an axis. */
    constexpr unsigned int max_nodes = AxisCurve::max_degree + 1;
  } // namespace

  StrutTouchMotion::StrutTouchMotion(const StrutCurves      &curves,
                                     const unsigned int      dimension,
                                     const StrutTouch       &touch,
                                     const AxisPair         &pair,
                                     const std::vector<int> &unknowns)
    : curves(curves)
    , dimension(dimension)
    , touch(touch)
    , pair(pair)
    , unknowns(unknowns)
  {}

  unsigned int StrutTouchMotion::first_of(const unsigned int axis) const
  {
    return axis == pair[0] ? 0 : curves.list()[pair[0]].n_nodes() * dimension;
  }

  template <class Add>
  void StrutTouchMotion::for_each_share(const double opposite,
                                        const Add   &add) const
  {
    double     values[max_nodes];
    const auto add_axis = [&](const unsigned int axis,
                              const double       parameter,
                              const double       sign) {
      curves.shape(axis, parameter, values);
      const unsigned int begin = first_of(axis);
      for (unsigned int node = 0; node < curves.list()[axis].n_nodes(); ++node)
        add(begin + node * dimension, sign * values[node]);
    };
    add_axis(touch.axis, touch.parameter, 1.);
    add_axis(touch.other, opposite, -1.);
  }

  dealii::Tensor<1, 3> StrutTouchMotion::difference(const Vector &values) const
  {
    dealii::Tensor<1, 3> result;
    for_each_share(touch.opposites.back().parameter,
                   [&](const unsigned int first, const double share) {
                     for (unsigned int c = 0; c < dimension; ++c)
                       result[c] += share * values[unknowns[first + c]];
                   });
    return result;
  }

  dealii::Tensor<1, 3>
  StrutTouchMotion::difference_slope(const Vector &values) const
  {
    double shapes[max_nodes], slopes[max_nodes];
    curves.shape(touch.other, touch.opposites.back().parameter, shapes, slopes);
    const unsigned int   begin = first_of(touch.other);
    dealii::Tensor<1, 3> result;
    for (unsigned int node = 0; node < curves.list()[touch.other].n_nodes();
         ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        result[c] -=
          slopes[node] * values[unknowns[begin + node * dimension + c]];
    return result;
  }

  void StrutTouchMotion::add_force(const double                opposite,
                                   const dealii::Tensor<1, 3> &force,
                                   double *const               forces) const
  {
    for_each_share(opposite, [&](const unsigned int first, const double share) {
      for (unsigned int c = 0; c < dimension; ++c)
        forces[unknowns[first + c]] += share * force[c];
    });
  }

  std::vector<double>
  StrutTouchMotion::gradient(const double                opposite,
                             const dealii::Tensor<1, 3> &vector) const
  {
    std::vector<double> result(unknowns.size(), 0.);
    for_each_share(opposite, [&](const unsigned int first, const double share) {
      for (unsigned int c = 0; c < dimension; ++c)
        result[first + c] += share * vector[c];
    });
    return result;
  }

  std::vector<double>
  StrutTouchMotion::tangent_gradient(const dealii::Tensor<1, 3> &vector) const
  {
    std::vector<double> result(unknowns.size(), 0.);
    double              values[max_nodes], slopes[max_nodes];
    curves.shape(touch.other, touch.opposites.back().parameter, values, slopes);
    const unsigned int begin = first_of(touch.other);
    for (unsigned int node = 0; node < curves.list()[touch.other].n_nodes();
         ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        result[begin + node * dimension + c] += slopes[node] * vector[c];
    return result;
  }

  std::vector<double>
  StrutTouchMotion::nearest_change(const AxisCurve &other) const
  {
    const StrutTouch::Opposite &last     = touch.opposites.back();
    const dealii::Tensor<1, 3>  tangent  = other.tangent(last.parameter);
    const double                distance = touch.distance;
    const double                growth =
      tangent * tangent / distance - last.normal * other.bend(last.parameter);
    std::vector<double>       change = tangent_gradient(last.normal);
    const std::vector<double> along  = gradient(last.parameter, tangent);
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] = (change[i] + along[i] / distance) / growth;
    return change;
  }
} // namespace auxfem
