#include <auxfem/analysis/paths/singular_points.h>
#include <auxfem/parameters/numerical_limits.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Distance over the step length of the points used to interpolate a
     * bifurcation.
     */
    constexpr double neighbour_distance = 2e-3;
    /**
     * Distance over the step length below which singular points are not
     * separated.
     */
    constexpr double min_separation = 1e-4;

    /** Sample of the path at a distance from the start of a step. */
    struct PathSample
    {
      double       length; ///< m
      double       load_rate;
      PathPosition position;
    };

    bool has_limit(const PathSample &begin, const PathSample &end)
    {
      return begin.load_rate * end.load_rate < 0;
    }

    /** Number of eigenvalues with a sign change, as far as known. */
    unsigned long n_changes(const PathSample &begin, const PathSample &end)
    {
      const PathPosition &before = begin.position, &after = end.position;
      if (before.n_negative && after.n_negative)
        return SingularPoint{SingularPoint::Kind::bifurcation,
                             before,
                             after,
                             {}}
          .multiplicity();
      const bool is_limit = has_limit(begin, end);
      // An even number of changes preserves the sign of the determinant.
      if (before.determinant_sign && after.determinant_sign)
        return before.determinant_sign != after.determinant_sign ? 1
          : is_limit                                             ? 2
                                                                 : 0;
      return is_limit ? 1 : 0;
    }

    /** Whether no sign change of an eigenvalue in between is known. */
    bool are_alike(const PathPosition &one, const PathPosition &other)
    {
      return one.n_negative && other.n_negative
        ? one.n_negative == other.n_negative
        : one.determinant_sign == other.determinant_sign;
    }

    class SingularPointSearch
    {
    public:
      SingularPointSearch(PathStepper     &stepper,
                          const PathPoint &from,
                          const double     length)
        : stepper(stepper)
        , from(from)
        , length(length)
      {}

      /** Finds the singular points between two samples. */
      void search(const PathSample &begin, const PathSample &end)
      {
        const bool          limit   = has_limit(begin, end);
        const unsigned long changes = n_changes(begin, end);
        if (!limit && changes == 0)
          return;
        if (changes == 1)
          {
            locate(begin, end);
            return;
          }
        const auto middle = end.length - begin.length > min_separation * length
          ? at((begin.length + end.length) / 2)
          : std::nullopt;
        if (!middle)
          {
            locate(begin, end);
            return;
          }
        const PathSample sample_there = sample(*middle);
        search(begin, sample_there);
        search(sample_there, end);
      }

      /** Whether a direction has no stiffness along the whole step. */
      bool is_neutral()
      {
        return at(sqrt_round_off * length) && stepper.is_neutral() &&
          at(length) && stepper.is_neutral();
      }

      static PathSample sample(const PathPoint &point, const double length)
      {
        return {length, point.tangent.load_rate, point.position()};
      }

      std::vector<LocatedPoint> found;

    private:
      std::optional<PathPoint> at(const double distance)
      {
        return stepper.step(from, from.tangent, distance).point;
      }

      PathSample sample(const PathPoint &point) const
      {
        return sample(point, point.arc_length() - from.arc_length());
      }

      /** Locates the singular point by the quantity that changes its sign. */
      void locate(const PathSample &begin, const PathSample &end)
      {
        if (has_limit(begin, end))
          {
            const auto rate = [](const PathPoint &point) {
              return point.tangent.load_rate;
            };
            add(begin, end, root(begin, end, rate, sqrt_round_off));
            return;
          }
        const auto is_before = [&](const PathPoint &point) {
          return are_alike(point.position(), begin.position) ? 1. : -1.;
        };
        // A multiple zero has no single eigenvalue to follow.
        if (n_changes(begin, end) > 1)
          add(begin, end, root(begin, end, is_before, sqrt_round_off));
        else
          add_bifurcation(begin, end, [&](const PathPoint &point) {
            const auto softest_mode = stepper.softest_mode();
            return softest_mode ? is_before(point) * softest_mode->second : 0.;
          });
      }

      /**
       * Distance at which @p value of a point is zero, with the tolerance @p
       * width times the step length.
       */
      template <class Value>
      double root(const PathSample &begin,
                  const PathSample &end,
                  const Value      &value,
                  const double      width)
      {
        const auto at_distance = [&](const double distance) {
          const auto point = at(distance);
          // There is no point if the stiffness is exactly singular.
          return point ? value(*point) : 0.;
        };
        const double first    = begin.length + sqrt_round_off * length;
        const double at_begin = at_distance(first),
                     at_end   = at_distance(end.length);
        if (at_begin * at_end >= 0)
          return std::abs(at_begin) < std::abs(at_end) ? first : end.length;
        std::uintmax_t max_root_evaluations = 60;
        const auto [lower, upper]           = boost::math::tools::toms748_solve(
          at_distance,
          first,
          end.length,
          at_begin,
          at_end,
          [&](const double one, const double other) {
            return std::abs(other - one) <= width * length;
          },
          max_root_evaluations);
        return (lower + upper) / 2;
      }

      /**
       * At a bifurcation, round-off moves points along the crossing branch.
       * Load factor and distance are therefore interpolated from neighbouring
       * points as functions of the vanishing eigenvalue.
       */
      template <class Value>
      void add_bifurcation(const PathSample &begin,
                           const PathSample &end,
                           const Value      &value)
      {
        const double estimate = root(begin, end, value, neighbour_distance);
        std::vector<double> eigenvalues, distances, load_factors;
        for (const double part : {-2., -1., 1., 2.})
          if (const auto point =
                at(estimate + part * neighbour_distance * length))
            {
              eigenvalues.push_back(value(*point));
              distances.push_back(sample(*point).length);
              load_factors.push_back(point->load_factor());
            }
        const double distance = value_at_zero(eigenvalues, distances);
        const bool   is_sound =
          std::abs(distance - estimate) <= 2 * neighbour_distance * length;
        add(begin, end, is_sound ? distance : estimate);
        if (is_sound && !found.empty())
          found.back().point.solution.state.path->load_factor =
            value_at_zero(eigenvalues, load_factors);
      }

      /**
       * Value at zero of the Lagrange polynomial through @p values at @p
       * places.
       */
      static double value_at_zero(const std::vector<double> &places,
                                  const std::vector<double> &values)
      {
        double sum = 0;
        for (unsigned int i = 0; i < places.size(); ++i)
          {
            double weight = 1;
            for (unsigned int j = 0; j < places.size(); ++j)
              if (j != i)
                weight *= places[j] / (places[j] - places[i]);
            sum += weight * values[i];
          }
        return sum;
      }

      void
      add(const PathSample &begin, const PathSample &end, const double distance)
      {
        auto point = at(distance);
        // Very close to the point the stiffness may be too singular.
        for (double part = sqrt_round_off; !point && part <= neighbour_distance;
             part *= 10)
          point = at(distance - part * length);
        if (!point)
          return;
        auto                softest_mode = stepper.softest_mode();
        const SingularPoint singular{has_limit(begin, end)
                                       ? SingularPoint::Kind::limit
                                       : SingularPoint::Kind::bifurcation,
                                     begin.position,
                                     end.position,
                                     softest_mode
                                       ? std::move(softest_mode->first)
                                       : Vector(),
                                     stepper.load_projection(*point)};
        found.push_back({std::move(*point), singular});
      }

      PathStepper     &stepper;
      const PathPoint &from;
      const double     length;
    };
  } // namespace

  std::vector<LocatedPoint> find_singular_points(PathStepper     &stepper,
                                                 const PathPoint &from,
                                                 const PathPoint &to,
                                                 const double     length)
  {
    SingularPointSearch search(stepper, from, length);
    const PathSample    begin = SingularPointSearch::sample(from, 0.),
                     end      = SingularPointSearch::sample(to, length);
    if (!has_limit(begin, end) && n_changes(begin, end) > 0 &&
        search.is_neutral())
      return {};
    search.search(begin, end);
    return std::move(search.found);
  }
} // namespace auxfem
