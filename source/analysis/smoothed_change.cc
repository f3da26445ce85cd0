#include <auxfem/analysis/smoothed_change.h>

#include <array>

namespace auxfem
{
  namespace
  {
    constexpr std::array<double, 3> weights = {0.25, 0.5, 0.25};
  }

  std::optional<Vector> SmoothedChange::with(const Vector &change,
                                             const double  dt) const
  {
    if (dt != length || before.size() + 1 < weights.size())
      return {};
    Vector mean(change.size(), 0.);
    add_multiple(weights.back(), change, mean);
    for (std::size_t i = 0; i < before.size(); ++i)
      add_multiple(weights[i], before[i], mean);
    return mean;
  }

  void SmoothedChange::add(const Vector &change, const double dt)
  {
    if (dt != length)
      before.clear();
    length = dt;
    before.push_back(change);
    if (before.size() == weights.size())
      before.pop_front();
  }

  void SmoothedChange::forget()
  {
    before.clear();
  }
} // namespace auxfem
