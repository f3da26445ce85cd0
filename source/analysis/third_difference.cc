#include <auxfem/analysis/third_difference.h>

#include <array>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int n_before = 3;
  }

  std::optional<Vector> ThirdDifference::with(const double  time,
                                              const Vector &now,
                                              const double  dt) const
  {
    if (before.size() < n_before)
      return {};
    std::array<double, n_before + 1>         times;
    std::array<const Vector *, n_before + 1> values;
    for (unsigned int i = 0; i < n_before; ++i)
      {
        times[i]  = before[i].time;
        values[i] = &before[i].value;
      }
    times.back()  = time;
    values.back() = &now;
    Vector difference(now.size(), 0.);
    for (unsigned int i = 0; i < times.size(); ++i)
      {
        double weight = 6; // 3!, of the third derivative of a cubic.
        for (unsigned int j = 0; j < times.size(); ++j)
          if (j != i)
            weight *= dt / (times[i] - times[j]);
        add_multiple(weight, *values[i], difference);
      }
    return difference;
  }

  void ThirdDifference::add(const double time, const Vector &value)
  {
    if (before.size() == n_before)
      before.pop_front();
    before.push_back({time, value});
  }

  bool ThirdDifference::has_begun() const
  {
    return !before.empty();
  }

  void ThirdDifference::forget()
  {
    before.clear();
  }
} // namespace auxfem
