#include <auxfem/loads/one_sided_limit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace auxfem
{
  namespace
  {
    constexpr double epsilon  = std::numeric_limits<double>::epsilon();
    constexpr double infinity = std::numeric_limits<double>::infinity();

    constexpr unsigned int n_points = 7;
    using Values                    = std::array<double, n_points>;

    /** One-sided differences of order six and five (Fornberg, Mathematics of
     * Computation 51, 1988, 699). */
    constexpr Values first_weights  = {-147. / 60,
                                       360. / 60,
                                       -450. / 60,
                                       400. / 60,
                                       -225. / 60,
                                       72. / 60,
                                       -10. / 60},
                     second_weights = {812. / 180,
                                       -3132. / 180,
                                       5265. / 180,
                                       -5080. / 180,
                                       2970. / 180,
                                       -972. / 180,
                                       137. / 180};

    double product(const Values &weights, const Values &values)
    {
      double sum = 0;
      for (unsigned int i = 0; i < n_points; ++i)
        sum += weights[i] * values[i];
      return sum;
    }

    double sign_of(const TimeSide side)
    {
      return side == TimeSide::before ? -1 : 1;
    }

    TimeSide opposite(const TimeSide side)
    {
      return side == TimeSide::before ? TimeSide::after : TimeSide::before;
    }

    /** Selects the best of several estimates of a derivative, made with growing
     * intervals. */
    class Derivative
    {
    public:
      /** @param round_off error of @p estimate by round-off of values */
      void add(const double estimate, const double round_off)
      {
        if (is_done)
          return;
        if (has_previous)
          {
            const double difference = std::abs(estimate - previous);
            if (difference + round_off < error)
              {
                value = estimate;
                error = difference + round_off;
              }
            // At a pole of the derivative, estimates grow by about the same
            // factor with each halved interval.
            const bool grows = difference > 3 * previous_round_off &&
              std::abs(previous) > 1.1 * std::abs(estimate) &&
              previous * estimate > 0;
            n_growing = grows ? n_growing + 1 : 0;
            diverges  = diverges || n_growing >= 8;
            // Longer intervals no longer resolve the function.
            is_done = difference > 1e3 * error;
          }
        else
          value = estimate;
        previous           = estimate;
        previous_round_off = round_off;
        has_previous       = true;
      }

      /** Best estimate; zero if it is below its error, infinite if estimates
       * grow without bound. */
      double result() const
      {
        if (diverges)
          return std::copysign(infinity, value);
        return std::abs(value) <= error && std::isfinite(error) ? 0 : value;
      }

      double error = infinity;

    private:
      double       value = 0, previous = 0, previous_round_off = 0;
      unsigned int n_growing    = 0;
      bool         has_previous = false, is_done = false, diverges = false;
    };

    /** Derivatives by differences of values on one side of a time. */
    class OneSidedDifferences
    {
    public:
      OneSidedDifferences(const BranchedFunction &function,
                          const double            t,
                          const TimeSide          side)
        : function(function)
        , t(t)
        , sign(sign_of(side))
        , branches(function(t + sign * time_resolution(t)).branches)
        , value(limit(function, t, side))
      {
        sample_all();
        for (const Level &level : levels)
          {
            const double slope =
              sign * product(first_weights, level.values) / level.h;
            const double round_off =
              noise + epsilon * (std::abs(t) + level.h) * std::abs(slope);
            first.add(slope, 10 * round_off / level.h);
            second.add(product(second_weights, level.values) /
                         (level.h * level.h),
                       30 * round_off / (level.h * level.h));
          }
      }

      /** Whether another branch limits the interval. */
      bool is_limited() const
      {
        return levels.empty() || levels.back().h < longest_interval / 2;
      }

      JetEstimate estimate() const
      {
        return {{value, first.result(), second.result()},
                first.error,
                second.error};
      }

    private:
      static constexpr double longest_interval = 1; ///< s

      struct Level
      {
        double h; ///< interval (s)
        Values values;
      };

      void sample_all()
      {
        sample_levels();
        double greatest = 0;
        for (const Level &sampled : levels)
          for (const double value : sampled.values)
            greatest = std::max(greatest, std::abs(value));
        noise += epsilon * greatest;
      }

      /** Doubles the interval while it has no other branch. */
      void sample_levels()
      {
        // Errors of one in the values make sixth differences of about 30.
        constexpr Values sixth = {1, -6, 15, -20, 15, -6, 1};
        Level            level{time_resolution(t), {value}};
        unsigned int     first_new = 1;
        for (; level.h < longest_interval; level.h *= 2)
          {
            for (unsigned int i = first_new; i < n_points; ++i)
              if (!sample(level, i))
                return;
            if (levels.empty())
              noise = std::abs(product(sixth, level.values)) / 30;
            levels.push_back(level);
            for (unsigned int i = 1; 2 * i < n_points; ++i)
              level.values[i] = level.values[2 * i];
            first_new = (n_points + 1) / 2;
          }
      }

      bool sample(Level &level, const unsigned int i) const
      {
        const auto sampled = function(t + sign * i * level.h);
        level.values[i]    = sampled.value;
        return sampled.branches == branches && std::isfinite(sampled.value);
      }

      const BranchedFunction &function;
      const double            t, sign;
      const std::uint64_t     branches;
      const double            value;
      std::vector<Level>      levels;
      double                  noise = 0; ///< round-off error of values
      Derivative              first, second;
    };
  } // namespace

  double
  limit(const BranchedFunction &function, const double t, const TimeSide side)
  {
    const auto here   = function(t);
    double     inside = t + sign_of(side) * time_resolution(t), outside = t;
    const auto beside = function(inside);
    if (here.branches == beside.branches)
      return here.value;
    double                 value          = beside.value;
    constexpr unsigned int max_bisections = 64;
    for (unsigned int i = 0; i < max_bisections; ++i)
      {
        const double middle = inside + (outside - inside) / 2;
        if (middle == inside || middle == outside)
          break;
        const auto sampled = function(middle);
        if (sampled.branches == beside.branches)
          {
            inside = middle;
            value  = sampled.value;
          }
        else
          outside = middle;
      }
    // Near a pole, values grow with the inverse of the distance.
    constexpr double growth_at_pole = 1e3;
    if (std::abs(value) > growth_at_pole * std::abs(beside.value) &&
        beside.value != 0)
      return std::copysign(infinity, value);
    const double change =
      std::abs(beside.value - value) + 8 * epsilon * std::abs(value);
    return std::abs(value - here.value) <= change ? here.value : value;
  }

  JetEstimate jet_estimate(const BranchedFunction &function,
                           const double            t,
                           const TimeSide          side)
  {
    const OneSidedDifferences differences(function, t, side);
    JetEstimate               result      = differences.estimate();
    const auto                branches_at = [&](const double time) {
      return function(time).branches;
    };
    const double reach = time_resolution(t);
    if (!differences.is_limited() ||
        branches_at(t - reach) != branches_at(t + reach))
      return result;
    const JetEstimate other =
      OneSidedDifferences(function, t, opposite(side)).estimate();
    if (other.first_error < result.first_error)
      {
        result.jet.first   = other.jet.first;
        result.first_error = other.first_error;
      }
    if (other.second_error < result.second_error)
      {
        result.jet.second   = other.jet.second;
        result.second_error = other.second_error;
      }
    return result;
  }
} // namespace auxfem
