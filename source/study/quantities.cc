#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/suggest.h>
#include <auxfem/study/quantities.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Measure = QuantityDefinition::Measure;

    bool is_among(const std::vector<std::string> &columns,
                  const std::string              &column)
    {
      return std::find(columns.begin(), columns.end(), column) != columns.end();
    }

    QuantityDefinition history_of(const std::string              &name,
                                  const std::vector<std::string> &columns)
    {
      QuantityDefinition quantity;
      quantity.name    = name;
      quantity.columns = columns;
      return quantity;
    }

    /** Those of the displacement of a probe. */
    std::vector<std::string>
    displacement_of(const std::string              &probe,
                    const std::vector<std::string> &columns)
    {
      std::vector<std::string> found;
      for (const char *const component : {".ux", ".uy", ".uz"})
        if (is_among(columns, probe + component))
          found.push_back(probe + component);
      return found;
    }

    std::vector<QuantityDefinition>
    default_quantities(const Scene                    &scene,
                       const std::vector<std::string> &columns)
    {
      if (scene.context.model == Model::reduced_cell)
        return {history_of("theta", {"theta"}), history_of("f2", {"f2"})};
      std::vector<QuantityDefinition> quantities;
      for (const ProbeDefinition &probe : scene.output.probes)
        {
          const auto displacement = displacement_of(probe.name, columns);
          if (!displacement.empty())
            quantities.push_back(history_of(probe.name, displacement));
        }
      if (quantities.empty())
        quantities.push_back(history_of("strain energy", {"strain"}));
      return quantities;
    }

    void refuse_what_is_not_there(const QuantityDefinition       &quantity,
                                  const std::vector<std::string> &columns,
                                  const double                    end_time)
    {
      for (const std::string &column : quantity.columns)
        if (!is_among(columns, column))
          throw InputError(quantity.path + ": there is no column \"" + column +
                           "\" in history.csv" + did_you_mean(column, columns) +
                           "\n  Columns of this scene: " + joined(columns));
      if (quantity.time && (*quantity.time < 0 || *quantity.time > end_time))
        throw InputError(quantity.path +
                         ": the time is not between 0 and the end time");
    }

    /** Not a number if one is none. */
    double largest_number(const QuantityValues &values)
    {
      double largest = 0;
      for (const double value : values)
        {
          if (std::isnan(value))
            return value;
          largest = std::max(largest, std::abs(value));
        }
      return largest;
    }
  } // namespace



  std::vector<QuantityDefinition>
  compared_quantities(const Scene                    &scene,
                      const std::vector<std::string> &columns)
  {
    const std::vector<QuantityDefinition> quantities =
      scene.study.quantities.empty() ? default_quantities(scene, columns)
                                     : scene.study.quantities;
    for (const QuantityDefinition &quantity : quantities)
      refuse_what_is_not_there(quantity, columns, scene.time.end_time);
    return quantities;
  }



  std::set<std::string>
  columns_of(const std::vector<QuantityDefinition> &quantities)
  {
    std::set<std::string> columns;
    for (const QuantityDefinition &quantity : quantities)
      columns.insert(quantity.columns.begin(), quantity.columns.end());
    return columns;
  }



  QuantityValues value_of(const QuantityDefinition  &quantity,
                          const MeasuredRun         &run,
                          const std::vector<double> &times)
  {
    const RecordedHistory history = run.history(quantity.columns.front());
    switch (quantity.measure)
      {
        case Measure::at_time:
          return {
            value_at(history, quantity.time.value_or(history.times.back()))};
        case Measure::maximum:
          return {maximum_of(history).value};
        case Measure::minimum:
          return {-maximum_of(negative(history)).value};
        case Measure::time_of_maximum:
          return {maximum_of(history).time};
        case Measure::time_of_minimum:
          return {maximum_of(negative(history)).time};
        case Measure::integral:
          return {integral_of(history)};
        case Measure::history:
          break;
      }
    QuantityValues values;
    for (const std::string &column : quantity.columns)
      {
        const RecordedHistory component = run.history(column);
        for (const double time : times)
          values.push_back(value_at(component, time));
      }
    return values;
  }



  std::optional<QuantityValues>
  exact_value_of(const QuantityDefinition  &quantity,
                 const double               end_time,
                 const std::vector<double> &times)
  {
    if (!quantity.exact)
      return {};
    if (quantity.measure != Measure::history)
      return QuantityValues{
        quantity.exact->value(quantity.time.value_or(end_time))};
    QuantityValues values;
    for (std::size_t i = 0; i < quantity.columns.size(); ++i)
      for (const double time : times)
        values.push_back(quantity.exact->value(time));
    return values;
  }



  double largest_change(const QuantityValues &values,
                        const QuantityValues &others)
  {
    QuantityValues change(values);
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] -= others[i];
    return largest_number(change);
  }



  double relative_difference(const QuantityValues &values,
                             const QuantityValues &reference)
  {
    const double scale = largest_number(reference);
    return largest_change(values, reference) / (scale > 0 ? scale : 1);
  }



  std::vector<double> times_of_comparison(const std::vector<MeasuredRun> &runs)
  {
    std::vector<double> times;
    for (const MeasuredRun &run : runs)
      if (run.completed())
        {
          const std::vector<double> &own = run.columns.at("time");
          if (times.empty() || own.size() < times.size())
            times = own;
        }
    if (!times.empty())
      times.erase(times.begin());
    return times;
  }
} // namespace auxfem
