#include <auxfem/output/run_quantities.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/study/quantities.h>
#include <auxfem/study/settings.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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

    /** Columns of the displacement of a probe. */
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

    void require_energy_norm(const QuantityDefinition &quantity,
                             const Scene              &scene)
    {
      if (scene.context.model != Model::lattice)
        throw InputError(
          quantity.path +
          ": energy norms need Model = lattice, because they are integrals "
          "over struts. Compare columns of history.csv");
      if (quantity.measure == Measure::total_energy_norm &&
          !scene.time.scheme->is_dynamic())
        throw InputError(quantity.path + ": in statics, Time/Scheme = " +
                         scene.time.scheme->name() +
                         ", there is no kinetic energy. Allowed: energy norm");
    }

    /** Norm of the values; NaN if one of them is NaN. */
    double norm_of(const QuantityValues &values)
    {
      double largest = 0, squares = 0;
      for (const double value : values.numbers)
        {
          if (std::isnan(value))
            return value;
          largest = std::max(largest, std::abs(value));
          squares += value * value;
        }
      return values.is_field ? std::sqrt(squares) : largest;
    }

    std::vector<double> fewest_times(const std::vector<MeasuredRun> &runs)
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
  } // namespace

  std::vector<QuantityDefinition>
  compared_quantities(const Scene                    &scene,
                      const std::vector<std::string> &columns)
  {
    const std::vector<QuantityDefinition> quantities =
      scene.study.quantities.empty() ? default_quantities(scene, columns)
                                     : scene.study.quantities;
    for (const QuantityDefinition &quantity : quantities)
      {
        require_columns(quantity, columns);
        if (quantity.time &&
            (*quantity.time < 0 || *quantity.time > scene.time.end_time))
          throw InputError(quantity.path +
                           ": the time is not between 0 and the end time");
        if (quantity.is_field())
          require_energy_norm(quantity, scene);
      }
    return quantities;
  }

  Selection selection_for(const std::vector<QuantityDefinition> &quantities,
                          const double                           end_time)
  {
    Selection selection;
    for (const QuantityDefinition &quantity : quantities)
      {
        selection.columns.insert(quantity.columns.begin(),
                                 quantity.columns.end());
        if (quantity.is_field())
          selection.field_times.insert(quantity.time.value_or(end_time));
      }
    return selection;
  }

  Comparison comparison_of(const std::vector<MeasuredRun> &runs)
  {
    Comparison comparison;
    comparison.times = fewest_times(runs);
    for (const MeasuredRun &run : runs)
      if (run.completed())
        for (const auto &[time, field] : run.fields)
          {
            std::vector<FieldPoint>  own    = integration_points(field);
            std::vector<FieldPoint> &points = comparison.points[time];
            if (own.size() > points.size())
              points = std::move(own);
          }
    return comparison;
  }

  QuantityValues value_of(const QuantityDefinition &quantity,
                          const MeasuredRun        &run,
                          const Comparison         &comparison)
  {
    if (quantity.is_field())
      {
        // The last field is that of the end time.
        const auto field = quantity.time ? run.fields.find(*quantity.time)
                                         : std::prev(run.fields.end());
        return {energy_roots(field->second,
                             comparison.points.at(field->first),
                             quantity.measure == Measure::total_energy_norm),
                true};
      }
    if (quantity.is_number())
      return {{number_of(quantity, run.history(quantity.columns.front()))}};
    QuantityValues values;
    for (const std::string &column : quantity.columns)
      {
        const RecordedHistory component = run.history(column);
        for (const double time : comparison.times)
          values.numbers.push_back(value_at(component, time));
      }
    return values;
  }

  std::optional<QuantityValues>
  exact_value_of(const QuantityDefinition &quantity,
                 const double              end_time,
                 const Comparison         &comparison)
  {
    if (!quantity.exact)
      return {};
    if (quantity.is_number())
      return QuantityValues{
        {quantity.exact->value(quantity.time.value_or(end_time))}};
    QuantityValues values;
    for (std::size_t i = 0; i < quantity.columns.size(); ++i)
      for (const double time : comparison.times)
        values.numbers.push_back(quantity.exact->value(time));
    return values;
  }

  double norm_of_change(const QuantityValues &values,
                        const QuantityValues &others)
  {
    QuantityValues change(values);
    for (std::size_t i = 0; i < change.numbers.size(); ++i)
      change.numbers[i] -= others.numbers[i];
    return norm_of(change);
  }

  double relative_difference(const QuantityValues &values,
                             const QuantityValues &reference)
  {
    const double scale = norm_of(reference);
    return norm_of_change(values, reference) / (scale > 0 ? scale : 1);
  }
} // namespace auxfem
