#include <auxfem/time/extrapolation.h>

#include <array>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** By how much errors of the values may be enlarged. */
    constexpr double largest_sum_of_weights = 8;

    /** The polynomial through the values at some points. */
    template <std::size_t n>
    struct Interpolation
    {
      std::array<unsigned int, n> points  = {};
      std::array<double, n>       weights = {};
      /** What its error is proportional to. */
      double distance = std::numeric_limits<double>::infinity();
    };

    /** Weights by Lagrange's polynomials. */
    template <std::size_t n>
    std::array<double, n> weights_of(const std::array<unsigned int, n> &points,
                                     const std::vector<double>         &times,
                                     const double                       time)
    {
      std::array<double, n> weights;
      for (std::size_t i = 0; i < n; ++i)
        {
          weights[i] = 1;
          for (std::size_t j = 0; j < n; ++j)
            if (j != i)
              weights[i] *= (time - times[points[j]]) /
                (times[points[i]] - times[points[j]]);
        }
      return weights;
    }

    template <std::size_t n>
    bool enlarges_errors(const std::array<double, n> &weights)
    {
      double sum = 0;
      for (const double weight : weights)
        sum += std::abs(weight);
      // Not a number where two times are the same.
      return !(sum <= largest_sum_of_weights);
    }

    /** Puts the polynomial through @p points in the place of @p best if its error
     * is less. */
    template <std::size_t n>
    void take_better(Interpolation<n>                  &best,
                     const std::array<unsigned int, n> &points,
                     const std::vector<double>         &times,
                     const double                       time)
    {
      double distance = 1;
      for (const unsigned int i : points)
        distance *= std::abs(time - times[i]);
      if (!(distance < best.distance))
        return;
      const std::array<double, n> weights = weights_of(points, times, time);
      if (!enlarges_errors(weights))
        best = {points, weights, distance};
    }

    template <std::size_t n>
    std::vector<std::pair<unsigned int, double>>
    listed(const Interpolation<n> &best)
    {
      std::vector<std::pair<unsigned int, double>> list;
      if (best.distance < std::numeric_limits<double>::infinity())
        for (std::size_t i = 0; i < n; ++i)
          list.emplace_back(best.points[i], best.weights[i]);
      return list;
    }
  } // namespace

  std::vector<std::pair<unsigned int, double>>
  extrapolation(const std::vector<double> &times, const double time)
  {
    const unsigned int n = times.size();
    Interpolation<3>   parabola;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        for (unsigned int k = 0; k < j; ++k)
          take_better<3>(parabola, {i, j, k}, times, time);
    const auto by_parabola = listed(parabola);
    if (!by_parabola.empty())
      return by_parabola;
    Interpolation<1> constant;
    for (unsigned int i = 0; i < n; ++i)
      take_better<1>(constant, {i}, times, time);
    return listed(constant);
  }
} // namespace auxfem
