#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/yield_curve.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Bisection alone would need about 60. */
    constexpr unsigned int max_iterations = 100;
  } // namespace

  YieldCurve::YieldCurve(const std::vector<Point> &points,
                         const double              kinematic,
                         const std::optional<Rate> rate)
    : kinematic_modulus(kinematic)
    , rate(rate)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      segments.push_back(
        {points[i].plastic_strain,
         points[i].stress,
         i + 1 < points.size() ? (points[i + 1].stress - points[i].stress) /
             (points[i + 1].plastic_strain - points[i].plastic_strain)
                               : 0.});
  }

  std::optional<double> YieldCurve::end_of_table() const
  {
    if (segments.size() == 1)
      return std::nullopt;
    return segments.back().begin;
  }

  Lanes YieldCurve::stress(const Lanes &plastic_strain) const
  {
    Lanes stress = segments.front().stress;
    for (const Segment &segment : segments)
      where(plastic_strain >= segment.begin, stress) =
        segment.stress + segment.slope * (plastic_strain - segment.begin);
    return stress;
  }

  YieldCurve::Flow YieldCurve::flow(const Lanes &stress,
                                    const Lanes &plastic_strain,
                                    const double dt) const
  {
    // The static increment lies in the last segment that the line of its own
    // resistance reaches.
    Flow flow{0, 0};
    for (const Segment &segment : segments)
      {
        const double resistance = 1 + kinematic_modulus + segment.slope;
        const Lanes  increment =
          (stress - segment.stress -
           segment.slope * (plastic_strain - segment.begin)) /
          resistance;
        const auto is_reached = plastic_strain + increment >= segment.begin;
        where(is_reached, flow.increment) = increment;
        where(is_reached, flow.slope)     = segment.slope + kinematic_modulus;
      }
    where(!(flow.increment > 0), flow.increment) = 0;
    if (!rate || !(dt > 0) || !any_of(flow.increment > 0))
      return flow;
    LaneArray<ShearFlowOf<double>> flows;
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      flows[lane] = shear_flow_at(lane_value(stress, lane),
                                  /*shear=*/0,
                                  lane_value(plastic_strain, lane),
                                  /*shear_ratio=*/1,
                                  dt);
    return {make_lanes([&](const auto lane) { return flows[lane].increment; }),
            make_lanes([&](const auto lane) {
              return kinematic_modulus + flows[lane].slope;
            })};
  }

  std::pair<double, double> YieldCurve::at(const double plastic_strain) const
  {
    const auto next =
      std::upper_bound(segments.begin() + 1,
                       segments.end(),
                       plastic_strain,
                       [](const double strain, const Segment &segment) {
                         return strain < segment.begin;
                       });
    const Segment &segment = *(next - 1);
    return {segment.stress + segment.slope * (plastic_strain - segment.begin),
            segment.slope};
  }

  std::pair<double, double> YieldCurve::rate_factor(const double increment,
                                                    const double dt) const
  {
    if (!rate || !(dt > 0))
      return {1, 0};
    const double x =
      std::pow(increment / (rate->reference * dt), 1 / rate->exponent);
    return {1 + x, increment > 0 ? x / (rate->exponent * increment) : 0};
  }

  YieldCurve::ShearFlow YieldCurve::shear_flow(const Lanes &normal,
                                               const Lanes &shear,
                                               const Lanes &plastic_strain,
                                               const double shear_ratio,
                                               const double dt) const
  {
    using std::sqrt;
    const auto yields =
      sqrt(Lanes(normal * normal + shear * shear)) > stress(plastic_strain);
    if (!any_of(yields))
      return {0, 0, 0};
    LaneArray<ShearFlowOf<double>> flows;
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      flows[lane] = shear_flow_at(lane_value(normal, lane),
                                  lane_value(shear, lane),
                                  lane_value(plastic_strain, lane),
                                  shear_ratio,
                                  dt);
    return {make_lanes([&](const auto lane) { return flows[lane].increment; }),
            make_lanes([&](const auto lane) { return flows[lane].multiplier; }),
            make_lanes([&](const auto lane) { return flows[lane].slope; })};
  }

  YieldCurve::ShearFlowOf<double>
  YieldCurve::shear_flow_at(const double normal,
                            const double shear,
                            const double plastic_strain,
                            const double shear_ratio,
                            const double dt) const
  {
    // The stress of each component is its elastic one over 1 + m times its
    // resistance, with the multiplier m; the equivalent stress falls with m,
    // the increment m times it grows. A bracket catches the kinks of the table
    // and the infinite slope that rates have at 0.
    const double by_normal = 1 + kinematic_modulus,
                 by_shear  = shear_ratio + kinematic_modulus;
    const double elastic   = std::hypot(normal, shear),
                 initial   = at(plastic_strain).first;
    if (!(elastic > initial))
      return {0, 0, 0};
    double low  = 0,
           high = (elastic / initial - 1) / std::min(by_normal, by_shear);
    double m    = high;
    for (unsigned int i = 0;; ++i)
      {
        const double n = normal / (1 + by_normal * m),
                     t = shear / (1 + by_shear * m), size = std::hypot(n, t);
        const double size_slope = -(by_normal * n * n / (1 + by_normal * m) +
                                    by_shear * t * t / (1 + by_shear * m)) /
          size;
        const double increment            = m * size;
        const auto [yield, slope]         = at(plastic_strain + increment);
        const auto [factor, factor_slope] = rate_factor(increment, dt);
        const double resistance   = slope * factor + yield * factor_slope;
        const double excess       = size - yield * factor;
        (excess > 0 ? low : high) = m;
        const double excess_slope =
          size_slope - resistance * (size + m * size_slope);
        double next = m - excess / excess_slope;
        if (!(next >= low && next <= high))
          next = (low + high) / 2;
        if (std::abs(next - m) <= few_round_offs * m || i == max_iterations)
          return {increment, m, resistance};
        m = next;
      }
  }
} // namespace auxfem
