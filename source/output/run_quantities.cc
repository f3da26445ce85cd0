#include <auxfem/output/run_quantities.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    using Measure = QuantityDefinition::Measure;

    /** Value at @p time; NaN outside of the history. */
    double value_within(const RecordedHistory &history, const double time)
    {
      const double first = history.times.front(), last = history.times.back(),
                   resolution = time_resolution(last);
      return time < first - resolution || time > last + resolution
        ? std::nan("")
        : value_at(history, time);
    }

    /** Mean over time of the square of @p history minus @p target, as far as the
     * target is known; NaN if that is less than two rows. */
    double mean_square_deviation(const RecordedHistory &history,
                                 const TimeFunction    &target)
    {
      const double first = target.first_time().value_or(history.times.front()),
                   last  = target.last_time().value_or(history.times.back()),
                   resolution = time_resolution(last);
      RecordedHistory squares;
      for (std::size_t i = 0; i < history.times.size(); ++i)
        if (const double time = history.times[i];
            time >= first - resolution && time <= last + resolution)
          {
            squares.times.push_back(time);
            squares.values.push_back(
              std::pow(history.values[i] - target.value(time), 2));
          }
      if (squares.times.size() < 2)
        return std::nan("");
      return integral_of(squares) /
        (squares.times.back() - squares.times.front());
    }
  } // namespace

  double number_of(const QuantityDefinition &quantity,
                   const RecordedHistory    &history)
  {
    switch (quantity.measure)
      {
        case Measure::at_time:
          return value_within(history,
                              quantity.time.value_or(history.times.back()));
        case Measure::maximum:
          return maximum_of(history).value;
        case Measure::minimum:
          return -maximum_of(negative(history)).value;
        case Measure::time_of_maximum:
          return maximum_of(history).time;
        case Measure::time_of_minimum:
          return maximum_of(negative(history)).time;
        case Measure::integral:
          return integral_of(history);
        default:
          return mean_square_deviation(history, *quantity.target);
      }
  }

  void require_columns(const QuantityDefinition       &quantity,
                       const std::vector<std::string> &columns)
  {
    for (const std::string &column : quantity.columns)
      if (std::find(columns.begin(), columns.end(), column) == columns.end())
        throw InputError(quantity.path + ": there is no column \"" + column +
                         "\" in history.csv" + did_you_mean(column, columns) +
                         "\n  Columns of this scene: " + joined(columns));
  }

  void require_quantities(const Scene                    &scene,
                          const std::vector<std::string> &columns)
  {
    for (const QuantityDefinition &quantity : scene.study.quantities)
      require_columns(quantity, columns);
  }

  NamedResults quantities_in(const Scene &scene, const RecordedTable &history)
  {
    require_quantities(scene, history.names);
    NamedResults results;
    if (history.n_rows() == 0)
      return results;
    for (const QuantityDefinition &quantity : scene.study.quantities)
      if (quantity.is_number())
        results.emplace_back(quantity.name,
                             number_of(quantity,
                                       history.history(quantity.columns[0])));
    return results;
  }

  Json json_of_quantities(const NamedResults &quantities)
  {
    Json json;
    for (const auto &[name, value] : quantities)
      json[name] = value;
    return json;
  }

  namespace
  {
    /** SI unit of @p quantity, whose column has the unit @p column and whose
     * history goes on in @p time. */
    std::string unit_of(const QuantityDefinition &quantity,
                        const std::string        &column,
                        const std::string        &time)
    {
      switch (quantity.measure)
        {
          case Measure::time_of_maximum:
          case Measure::time_of_minimum:
            return time;
          case Measure::integral:
            return column == "1" ? time : column + " " + time;
          case Measure::mean_square_deviation:
            return "(" + column + ")2";
          default:
            return column;
        }
    }
  } // namespace

  std::string text_of_quantities(const NamedResults        &quantities,
                                 const Scene               &scene,
                                 const std::vector<Column> &columns)
  {
    std::string text;
    for (const auto &[name, value] : quantities)
      for (const QuantityDefinition &quantity : scene.study.quantities)
        if (quantity.name == name)
          {
            const auto column =
              std::find_if(columns.begin(),
                           columns.end(),
                           [&quantity](const Column &one) {
                             return one.name == quantity.columns[0];
                           });
            text += "Quantity " + name + ": " + rounded_text(value, 6) + " " +
              unit_of(quantity, column->unit, columns[0].unit) + '\n';
          }
    return text;
  }
} // namespace auxfem
