#include <auxfem/time/extrapolation.h>

#include <array>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /**
     * Factor by which an extrapolation may enlarge errors of its values.
     * @tuned judgement: a parabola over equal steps has 7, a cubic 15
     */
    constexpr double largest_sum_of_weights = 8;

    struct Parabola
    {
      std::array<unsigned int, 3> points  = {};
      std::array<double, 3>       weights = {}; ///< of their values (Lagrange)
      /** What its error is proportional to. */
      double distance = std::numeric_limits<double>::infinity();
    };

    void find_weights(Parabola                  &parabola,
                      const std::vector<double> &times,
                      const double               time)
    {
      const auto &points = parabola.points;
      parabola.weights   = {{1, 1, 1}};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          if (j != i)
            parabola.weights[i] *=
              (time - times[points[j]]) / (times[points[i]] - times[points[j]]);
    }

    bool enlarges_errors(const Parabola &parabola)
    {
      double sum = 0;
      for (const double weight : parabola.weights)
        sum += std::abs(weight);
      // Not a number where two times are the same.
      return !(sum <= largest_sum_of_weights);
    }
  } // namespace

  std::vector<std::pair<unsigned int, double>>
  extrapolation(const std::vector<double> &times, const double time)
  {
    const unsigned int n        = times.size();
    const auto         distance = [&](const unsigned int point) {
      return std::abs(time - times[point]);
    };
    Parabola   best;
    const auto try_points =
      [&](const unsigned int i, const unsigned int j, const unsigned int k) {
        Parabola parabola;
        parabola.points   = {{i, j, k}};
        parabola.distance = distance(i) * distance(j) * distance(k);
        if (!(parabola.distance < best.distance))
          return;
        find_weights(parabola, times, time);
        if (!enlarges_errors(parabola))
          best = parabola;
      };
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        for (unsigned int k = 0; k < j; ++k)
          try_points(i, j, k);

    std::vector<std::pair<unsigned int, double>> list;
    if (best.distance < std::numeric_limits<double>::infinity())
      for (unsigned int i = 0; i < 3; ++i)
        list.emplace_back(best.points[i], best.weights[i]);
    else if (n > 0)
      {
        unsigned int nearest = 0;
        for (unsigned int i = 1; i < n; ++i)
          if (distance(i) < distance(nearest))
            nearest = i;
        list.emplace_back(nearest, 1.);
      }
    return list;
  }
} // namespace auxfem
