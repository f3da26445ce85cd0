#include <auxfem/analysis/backward_differences.h>

#include <deal.II/base/exceptions.h>

namespace auxfem
{
  std::optional<Vector>
  BackwardDifferences::difference(const unsigned int order,
                                  const double       time,
                                  const Vector      &now,
                                  const double       dt) const
  {
    Assert(order <= largest_order, dealii::ExcInternalError());
    if (samples.size() < order)
      return {};
    std::vector<double>         times;
    std::vector<const Vector *> values;
    for (std::size_t i = samples.size() - order; i < samples.size(); ++i)
      {
        times.push_back(samples[i].time);
        values.push_back(&samples[i].value);
      }
    times.push_back(time);
    values.push_back(&now);
    Vector result(now.size(), 0.);
    for (unsigned int i = 0; i <= order; ++i)
      {
        double weight = 1;
        for (unsigned int j = 0, n = 1; j <= order; ++j)
          if (j != i)
            weight *= n++ * dt / (times[i] - times[j]);
        add_multiple(weight, *values[i], result);
      }
    return result;
  }

  void BackwardDifferences::add(const double time, const Vector &value)
  {
    if (samples.size() == largest_order)
      samples.pop_front();
    samples.push_back({time, value});
  }

  void BackwardDifferences::save(const std::string    &name,
                                 const UnknownRecords &unknowns,
                                 Records              &records) const
  {
    for (unsigned int i = 0; i < samples.size(); ++i)
      {
        const std::string sample_name = name + " " + std::to_string(i);
        records.keep(sample_name + ": time", {samples[i].time});
        unknowns.keep(sample_name, samples[i].value, records);
      }
  }

  void BackwardDifferences::resume(const std::string    &name,
                                   const UnknownRecords &unknowns,
                                   const Records        &records)
  {
    clear();
    for (unsigned int i = 0; i < largest_order; ++i)
      if (const std::string sample_name = name + " " + std::to_string(i);
          records.has(sample_name))
        samples.push_back({records.values(sample_name + ": time", 1)[0],
                           unknowns.values(sample_name, records)});
  }
} // namespace auxfem
