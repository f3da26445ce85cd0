#include <auxfem/analysis/paths/singular_points.h>
#include <auxfem/parameters/numerical_limits.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** How near the points are that a bifurcation is interpolated from. */
    constexpr double beside = 2e-3;
    /** Closer ones are not told apart. */
    constexpr double indistinguishable = 1e-4;

    /** What is seen of the path at some distance from the start of a step. */
    struct Look
    {
      double       length; ///< m
      double       load_rate;
      PathPosition position;
    };

    bool has_limit(const Look &begin, const Look &end)
    {
      return begin.load_rate * end.load_rate < 0;
    }

    /** How many eigenvalues have changed their sign, as far as is known. */
    unsigned long n_changes(const Look &begin, const Look &end)
    {
      const PathPosition &before = begin.position, &after = end.position;
      if (before.n_negative && after.n_negative)
        return SingularPoint{SingularPoint::Kind::bifurcation,
                             before,
                             after,
                             {}}
          .multiplicity();
      const bool is_limit = has_limit(begin, end);
      // An even number, if any, leaves the determinant its sign.
      if (before.determinant_sign && after.determinant_sign)
        return before.determinant_sign != after.determinant_sign ? 1
          : is_limit                                             ? 2
                                                                 : 0;
      return is_limit ? 1 : 0;
    }

    /** Whether no eigenvalue is known to have changed its sign in between. */
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

      /** Finds those between two looks. */
      void search(const Look &begin, const Look &end)
      {
        const bool          limit   = has_limit(begin, end);
        const unsigned long changes = n_changes(begin, end);
        if (!limit && changes == 0)
          return;
        if (changes == 1)
          {
            enclose(begin, end);
            return;
          }
        const auto middle =
          end.length - begin.length > indistinguishable * length
          ? at((begin.length + end.length) / 2)
          : std::nullopt;
        if (!middle)
          {
            enclose(begin, end);
            return;
          }
        const Look look = look_at(*middle);
        search(begin, look);
        search(look, end);
      }

      /** Whether a direction stays free all along the step. */
      bool is_neutral()
      {
        return at(sqrt_round_off * length) && stepper.is_neutral() &&
          at(length) && stepper.is_neutral();
      }

      static Look look_at(const PathPoint &point, const double length)
      {
        return {length, point.tangent.load_rate, point.position()};
      }

      std::vector<LocatedPoint> found;

    private:
      std::optional<PathPoint> at(const double distance)
      {
        return stepper.step(from, from.tangent, distance).point;
      }

      Look look_at(const PathPoint &point) const
      {
        return look_at(point, point.arc_length() - from.arc_length());
      }

      /** Enclosed by what changes its sign there. */
      void enclose(const Look &begin, const Look &end)
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
        // Several at once have no eigenvalue of their own.
        if (n_changes(begin, end) > 1)
          add(begin, end, root(begin, end, is_before, sqrt_round_off));
        else
          add_bifurcation(begin, end, [&](const PathPoint &point) {
            const auto softest = stepper.softest();
            return softest ? is_before(point) * softest->second : 0.;
          });
      }

      /** Distance at which @p value of a point is zero, up to @p width of the
       * step. */
      template <class Value>
      double root(const Look  &begin,
                  const Look  &end,
                  const Value &value,
                  const double width)
      {
        const auto at_distance = [&](const double distance) {
          const auto point = at(distance);
          // Where the stiffness is singular to the last digit.
          return point ? value(*point) : 0.;
        };
        const double first    = begin.length + sqrt_round_off * length;
        const double at_begin = at_distance(first),
                     at_end   = at_distance(end.length);
        if (at_begin * at_end >= 0)
          return std::abs(at_begin) < std::abs(at_end) ? first : end.length;
        std::uintmax_t most_looks = 60;
        const auto [lower, upper] = boost::math::tools::toms748_solve(
          at_distance,
          first,
          end.length,
          at_begin,
          at_end,
          [&](const double one, const double other) {
            return std::abs(other - one) <= width * length;
          },
          most_looks);
        return (lower + upper) / 2;
      }

      /**
       * At a bifurcation round-off moves points along the branch that crosses;
       * load factor and distance are interpolated from points beside it, as
       * functions of the eigenvalue that vanishes.
       */
      template <class Value>
      void
      add_bifurcation(const Look &begin, const Look &end, const Value &value)
      {
        const double        near = root(begin, end, value, beside);
        std::vector<double> eigenvalues, distances, load_factors;
        for (const double part : {-2., -1., 1., 2.})
          if (const auto point = at(near + part * beside * length))
            {
              eigenvalues.push_back(value(*point));
              distances.push_back(look_at(*point).length);
              load_factors.push_back(point->load_factor());
            }
        const double distance = value_at_zero(eigenvalues, distances);
        const bool is_sound = std::abs(distance - near) <= 2 * beside * length;
        add(begin, end, is_sound ? distance : near);
        if (is_sound && !found.empty())
          found.back().point.solution.state.path->load_factor =
            value_at_zero(eigenvalues, load_factors);
      }

      /** Of the polynomial through @p values at @p places (Lagrange). */
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

      void add(const Look &begin, const Look &end, const double distance)
      {
        auto point = at(distance);
        // Nearest to it the stiffness may be too singular to solve with.
        for (double part = sqrt_round_off; !point && part <= beside; part *= 10)
          point = at(distance - part * length);
        if (!point)
          return;
        auto                softest = stepper.softest();
        const SingularPoint singular{has_limit(begin, end)
                                       ? SingularPoint::Kind::limit
                                       : SingularPoint::Kind::bifurcation,
                                     begin.position,
                                     end.position,
                                     softest ? std::move(softest->first)
                                             : Vector(),
                                     stepper.part_of_loads(*point)};
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
    const Look          begin = SingularPointSearch::look_at(from, 0.),
               end            = SingularPointSearch::look_at(to, length);
    if (!has_limit(begin, end) && n_changes(begin, end) > 0 &&
        search.is_neutral())
      return {};
    search.search(begin, end);
    return std::move(search.found);
  }
} // namespace auxfem
