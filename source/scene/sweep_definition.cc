#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/sweep_definition.h>

#include <deal.II/base/utilities.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::split_string_list;
    using dealii::Utilities::trim;

    /** Largest number of values of a parameter, and of cases. */
    constexpr unsigned int most = 100000;

    const Integer samples = {
      "Samples",
      0,
      0,
      most,
      "Number of cases of a Latin hypercube: each range is divided into as many "
      "parts, each of which has one case; 0: all combinations of the values."};
    const Integer seed    = {"Seed",
                             1,
                             0,
                             2147483647,
                             "Seed of the random numbers of a Latin hypercube."};
    const Text    results = {
         "Results",
         "auto",
         "Results in the table of a sweep, separated by commas: names in "
            "summary.json, e.g. nu12, or Quantities. auto: all numbers of the "
            "analysis, and Quantities."};

    [[noreturn]] void refuse(const ParameterValues &values,
                             const std::string     &text,
                             const std::string     &why)
    {
      throw InputError(
        values.context.path + " = " + text + ": " + why +
        ". Allowed: begin:end:step with a unit, e.g. 50:80:5 deg; a list, e.g. "
        "50, 60, 75 deg or star, re-entrant (split by semicolons if a value has "
        "commas); with Sampling/Samples also begin:end");
    }

    void read_range(const ParameterValues &values,
                    const std::string     &text,
                    SweptParameter        &swept)
    {
      ParsedRange range;
      try
        {
          range = split_range(text);
        }
      catch (const InputError &error)
        {
          refuse(values, text, error.what());
        }
      if (range.numbers.size() > 3)
        refuse(values, text, "a range has at most three numbers");
      const double begin = range.numbers[0], end = range.numbers[1];
      swept.unit  = range.unit;
      swept.range = {{begin, end}};
      if (range.numbers.size() == 2)
        return;
      const double step = range.numbers[2];
      const double n    = (end - begin) / step;
      if (!(n >= 0) || n > most)
        refuse(values,
               text,
               "the step does not lead from the first to the second number in "
               "at most " +
                 std::to_string(most) + " steps");
      // The end counts in spite of round-off.
      for (unsigned int i = 0; i <= std::floor(n + 1e-9); ++i)
        swept.values.push_back(quantity_text(begin + i * step, swept.unit));
    }

    bool is_number(const std::string &text)
    {
      return !text.empty() &&
        text.find_first_not_of("0123456789.+-eE") == std::string::npos;
    }

    std::vector<std::string> list_of(const std::string &text)
    {
      const char separator = text.find(';') != std::string::npos ? ';' : ',';
      std::vector<std::string> items;
      for (const std::string &item : split_string_list(text, separator))
        items.push_back(trim(item));
      // A unit behind the last number holds for all.
      const std::size_t blank = items.back().find(' ');
      if (blank != std::string::npos &&
          is_number(items.back().substr(0, blank)) &&
          std::all_of(items.begin(), items.end() - 1, is_number))
        for (std::size_t i = 0; i + 1 < items.size(); ++i)
          items[i] += items.back().substr(blank);
      return items;
    }
  } // namespace

  std::string SweptParameter::at(const double part) const
  {
    if (!range)
      return values[std::min<std::size_t>(part * values.size(),
                                          values.size() - 1)];
    return quantity_text((*range)[0] + part * ((*range)[1] - (*range)[0]),
                         unit);
  }

  SubsectionSchema sweep_schema()
  {
    return {
      "Sweep",
      SubsectionSchema::Form::path_entries,
      "Parameters with many values: \"set Lattice/Opening angle = 50:80:5 deg\" "
      "(begin:end:step), \"set Lattice/Cell = star, re-entrant\". The analysis "
      "runs for all combinations, side by side on the ranks; sweep.csv has a "
      "row for each case. The option --sweep adds an entry.",
      {},
      "",
      {},
      {Model::lattice, Model::reduced_cell}};
  }

  SweptParameter read_swept_parameter(ParameterValues &values)
  {
    SweptParameter swept;
    swept.path             = values.name();
    const std::string text = text_of_free_entry(values);
    if (trim(text).empty())
      refuse(values, text, "no value is given");
    if (text.find(':') != std::string::npos)
      read_range(values, text, swept);
    else
      swept.values = list_of(text);
    return swept;
  }

  SubsectionSchema sampling_schema()
  {
    return {
      "Sampling",
      SubsectionSchema::Form::fixed,
      "With Sweep: which cases are computed, and which results tabulated.",
      {samples, seed, results},
      "",
      {},
      {Model::lattice, Model::reduced_cell}};
  }

  void read_sampling(const ParameterValues &values, SweepDefinition &sweep)
  {
    if (const unsigned int n = values[samples]; n > 0)
      sweep.samples = n;
    sweep.seed = values[seed];
    if (values[results] != "auto")
      for (const std::string &name : split_string_list(values[results], ','))
        sweep.results.push_back(trim(name));
  }

  namespace
  {
    std::vector<std::vector<std::string>>
    all_combinations(const SweepDefinition &sweep)
    {
      std::vector<std::vector<std::string>> cases(1);
      for (const SweptParameter &swept : sweep.parameters)
        {
          if (swept.values.empty())
            throw InputError("Sweep/" + swept.path +
                             ": a range without a step is for a Latin "
                             "hypercube. Give a step, begin:end:step, or "
                             "Sampling/Samples");
          std::vector<std::vector<std::string>> longer;
          for (const auto &one : cases)
            for (const std::string &value : swept.values)
              {
                longer.push_back(one);
                longer.back().push_back(value);
              }
          if (longer.size() > most)
            throw InputError(
              "Sweep: these are more than " + std::to_string(most) +
              " combinations. Give fewer values, or Sampling/Samples");
          cases.swap(longer);
        }
      return cases;
    }

    std::vector<std::vector<std::string>>
    sampled_cases(const SweepDefinition &sweep)
    {
      std::vector<std::vector<std::string>>  cases(*sweep.samples);
      const std::vector<std::vector<double>> points =
        latin_hypercube(cases.size(), sweep.parameters.size(), sweep.seed);
      for (std::size_t i = 0; i < cases.size(); ++i)
        for (std::size_t p = 0; p < sweep.parameters.size(); ++p)
          cases[i].push_back(sweep.parameters[p].at(points[i][p]));
      return cases;
    }
  } // namespace

  std::vector<std::vector<double>>
  latin_hypercube(const unsigned int n_points,
                  const unsigned int n_coordinates,
                  const unsigned int seed)
  {
    // Boost gives the same numbers with any standard library.
    boost::random::mt19937            generator(seed);
    boost::random::uniform_01<double> within;
    std::vector<std::vector<double>>  points(n_points,
                                            std::vector<double>(n_coordinates));
    for (unsigned int c = 0; c < n_coordinates; ++c)
      {
        std::vector<unsigned int> order(n_points);
        std::iota(order.begin(), order.end(), 0);
        for (unsigned int i = n_points; i-- > 1;)
          std::swap(
            order[i],
            order[boost::random::uniform_int_distribution<unsigned int>(0, i)(
              generator)]);
        for (unsigned int i = 0; i < n_points; ++i)
          points[i][c] = (order[i] + within(generator)) / n_points;
      }
    return points;
  }

  std::vector<std::vector<std::string>> cases_of(const SweepDefinition &sweep)
  {
    return sweep.samples ? sampled_cases(sweep) : all_combinations(sweep);
  }
} // namespace auxfem
