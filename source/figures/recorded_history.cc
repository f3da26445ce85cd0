#include <auxfem/figures/recorded_history.h>
#include <auxfem/parameters/numerical_limits.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Polynomial through consecutive values, by Neville's algorithm. */
    class Polynomial
    {
    public:
      /** Interpolates at most @p n values, centred at number @p middle. */
      Polynomial(const RecordedHistory &history,
                 const std::size_t      middle,
                 const std::size_t      n)
        : history(history)
        , count(std::min(n, history.times.size()))
        , first(std::min(middle - std::min(middle, count / 2),
                         history.times.size() - count))
      {}

      double operator()(const double time) const
      {
        std::vector<double> value(history.values.begin() + first,
                                  history.values.begin() + first + count);
        const double *const t = history.times.data() + first;
        for (std::size_t level = 1; level < count; ++level)
          for (std::size_t i = 0; i + level < count; ++i)
            value[i] = ((time - t[i + level]) * value[i] +
                        (t[i] - time) * value[i + 1]) /
              (t[i] - t[i + level]);
        return value[0];
      }

    private:
      const RecordedHistory &history;
      const std::size_t      count, first;
    };
  } // namespace

  double value_at(const RecordedHistory &history, const double time)
  {
    const std::vector<double> &times = history.times;
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    const std::size_t next =
      std::min<std::size_t>(after - times.begin(), times.size() - 1);
    const std::size_t nearest =
      next > 0 && time - times[next - 1] < times[next] - time ? next - 1 : next;
    if (std::abs(times[nearest] - time) <=
        round_off * (times.back() - times.front()))
      return history.values[nearest];
    return Polynomial(history, nearest, 5)(time);
  }

  Maximum maximum_of(const RecordedHistory &history)
  {
    const std::size_t largest =
      std::max_element(history.values.begin(), history.values.end()) -
      history.values.begin();
    const Maximum recorded{history.times[largest], history.values[largest]};
    if (largest == 0 || largest + 1 == history.times.size())
      return recorded;
    const Polynomial polynomial(history, largest, 5);
    const auto [time, depth] = boost::math::tools::brent_find_minima(
      [&polynomial](const double t) { return -polynomial(t); },
      history.times[largest - 1],
      history.times[largest + 1],
      std::numeric_limits<double>::digits / 2);
    return -depth > recorded.value ? Maximum{time, -depth} : recorded;
  }

  double integral_of(const RecordedHistory &history)
  {
    // Two Gauss points are exact for cubic polynomials.
    const double point = std::sqrt(1. / 3.);
    double       sum   = 0;
    for (std::size_t i = 1; i < history.times.size(); ++i)
      {
        const double     half   = (history.times[i] - history.times[i - 1]) / 2;
        const double     middle = history.times[i] - half;
        const Polynomial polynomial(history, i, 4);
        sum += half *
          (polynomial(middle - half * point) +
           polynomial(middle + half * point));
      }
    return sum;
  }

  RecordedHistory negative(RecordedHistory history)
  {
    for (double &value : history.values)
      value = -value;
    return history;
  }
} // namespace auxfem
