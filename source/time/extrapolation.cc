#include <auxfem/time/extrapolation.h>

#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** By how much errors of the values may be enlarged. */
    constexpr double largest_sum_of_weights = 8;

    using Weights = std::vector<std::pair<unsigned int, double>>;

    /** Of the polynomial through some @p points (Lagrange). */
    Weights weights_of(const std::vector<unsigned int> &points,
                       const std::vector<double>       &times,
                       const double                     time)
    {
      Weights weights;
      for (const unsigned int i : points)
        {
          double weight = 1;
          for (const unsigned int j : points)
            if (j != i)
              weight *= (time - times[j]) / (times[i] - times[j]);
          weights.emplace_back(i, weight);
        }
      return weights;
    }

    /** What the error of that polynomial is proportional to. */
    double distance_of(const std::vector<unsigned int> &points,
                       const std::vector<double>       &times,
                       const double                     time)
    {
      double distance = 1;
      for (const unsigned int i : points)
        distance *= std::abs(time - times[i]);
      return distance;
    }

    bool enlarges_errors(const Weights &weights)
    {
      double sum = 0;
      for (const auto &[point, weight] : weights)
        sum += std::abs(weight);
      // Not a number where two times are the same.
      return !(sum <= largest_sum_of_weights);
    }
  } // namespace

  std::vector<std::pair<unsigned int, double>>
  extrapolation(const std::vector<double> &times, const double time)
  {
    Weights            best;
    double             least = std::numeric_limits<double>::infinity();
    const unsigned int n     = times.size();
    const auto try_points    = [&](const std::vector<unsigned int> &points) {
      const Weights weights  = weights_of(points, times, time);
      const double  distance = distance_of(points, times, time);
      if (distance < least && !enlarges_errors(weights))
        {
          least = distance;
          best  = weights;
        }
    };
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        for (unsigned int k = 0; k < j; ++k)
          try_points({i, j, k});
    if (best.empty())
      for (unsigned int i = 0; i < n; ++i)
        try_points({i});
    return best;
  }
} // namespace auxfem
