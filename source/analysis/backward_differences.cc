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
    // Later values may have further ghosts.
    Vector result(values.front()->size(), 0.);
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

  void BackwardDifferences::serialize(const std::string    &name,
                                      const UnknownRecords &unknowns,
                                      CheckpointArchive    &archive)
  {
    std::size_t n = samples.size();
    archive.values(name + ": number", n);
    samples.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const std::string sample_name = name + " " + std::to_string(i);
        archive.values(sample_name + ": time", samples[i].time);
        unknowns.serialize(sample_name, samples[i].value, archive);
      }
  }
} // namespace auxfem
