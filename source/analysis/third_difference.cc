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

  void ThirdDifference::save(const std::string    &name,
                             const UnknownRecords &unknowns,
                             Records              &records) const
  {
    for (unsigned int i = 0; i < before.size(); ++i)
      {
        const std::string of_sample = name + " " + std::to_string(i);
        records.keep(of_sample + ": time", {before[i].time});
        unknowns.keep(of_sample, before[i].value, records);
      }
  }

  void ThirdDifference::resume(const std::string    &name,
                               const UnknownRecords &unknowns,
                               const Records        &records)
  {
    forget();
    for (unsigned int i = 0; i < n_before; ++i)
      if (const std::string of_sample = name + " " + std::to_string(i);
          records.has(of_sample))
        before.push_back({records.values(of_sample + ": time", 1)[0],
                          unknowns.values(of_sample, records)});
  }
} // namespace auxfem
