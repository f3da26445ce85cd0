#include <auxfem/loads/load_definitions.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/scene/study_definition.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::trim;
    using Measure = QuantityDefinition::Measure;

    constexpr unsigned int most_values = 50;

    const Choice kind = {
      "Kind",
      "convergence",
      {"convergence", "work-precision", "effects"},
      "What is asked. convergence: how the error falls with mesh, time step and "
      "Newton tolerance, each refined alone, and what that costs; "
      "work-precision: which of all combinations of order, refinement, time step "
      "and scheme has an error for the least time; effects: what becomes of the "
      "scene without each of its effects in turn, and what that saves."};
    const QuantityList orders = {
      "Orders",
      "auto",
      "1",
      Range::closed(1, largest_plane_order),
      1,
      most_values,
      "Polynomial orders of the struts' elements; auto: that of the scene, with "
      "Kind = work-precision also the one below and above; none: that of the "
      "scene.",
      {"auto", "none"}};
    const QuantityList refinements = {
      "Refinements",
      "auto",
      "1",
      Range::closed(0, 10),
      1,
      most_values,
      "Numbers n of halvings, 2^n elements a strut; auto: that of the scene, with "
      "Kind = convergence also the next two; none: that of the scene.",
      {"auto", "none"}};
    const QuantityList time_steps = {
      "Time steps",
      "auto",
      "s",
      Range::positive(),
      1,
      most_values,
      "Lengths of a time step; auto: 4, 2 and 1 times that of the scene, with Kind "
      "= work-precision also half of it, in statics that alone; none: that of the "
      "scene.",
      {"auto", "none"}};
    const QuantityList time_tolerances = {
      "Relative tolerances",
      "none",
      "1",
      Range::open(0, 1),
      1,
      most_values,
      "Tolerances of the time integration, Time/Relative tolerance; none: that "
      "of the scene.",
      {"none"}};
    const QuantityList newton_tolerances = {
      "Newton tolerances",
      "none",
      "1",
      Range::open(0, 1),
      1,
      most_values,
      "Tolerances of Newton's method; none: that of the scene.",
      {"none"}};
    const Text schemes = {
      "Schemes",
      "none",
      "Time integrators, by commas; none: that of the scene."};
    const Boolean together = {
      "Refine together",
      false,
      "Whether the n-th refinement goes with the n-th time step, as many of "
      "both; else each is refined with the other as in the scene."};
    const Choice reference = {
      "Reference",
      "finer run",
      {"finer run", "extrapolation"},
      "What errors are measured against where no exact value is given. finer "
      "run: one finer than all others; extrapolation: the limit that two such "
      "runs point to (Richardson)."};

    const Integer repetitions = {
      "Repetitions",
      3,
      1,
      100,
      "With Kind = work-precision or effects: how often a simulation is done for "
      "its time, of which the least counts."};
    const Quantity tolerance = {
      "Tolerance",
      "1 %",
      "1",
      Range::positive(),
      "With Kind = effects: relative change of a quantity that an effect has to "
      "make to be called for."};

    std::vector<unsigned int> whole_numbers(const ParameterValues &values,
                                            const QuantityList    &parameter)
    {
      std::vector<unsigned int> numbers;
      if (values.is_word(parameter))
        return numbers;
      for (const double value : values[parameter])
        {
          if (value != std::floor(value))
            values.refuse(parameter, "these must be whole numbers");
          numbers.push_back(value);
        }
      return numbers;
    }

    bool is_auto(const ParameterValues &values, const QuantityList &parameter)
    {
      return values.text(parameter) == "auto";
    }

    std::vector<std::string> scheme_names(const ParameterValues &values)
    {
      if (values[schemes] == "none")
        return {};
      std::vector<std::string> known;
      for (const TimeSchemeEntry &entry : time_scheme_registry())
        if (entry.serves(values.context.model))
          known.push_back(entry.name);
      const std::vector<std::string> names =
        dealii::Utilities::split_string_list(values[schemes], ',');
      for (const std::string &name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
          values.refuse(schemes,
                        "\"" + name + "\" is no time integrator of this model" +
                          did_you_mean(name, known) +
                          "; allowed: " + joined(known));
      return names;
    }

    void refuse_unequal_lengths(const ParameterValues &values,
                                const StudyDefinition &study)
    {
      if (!study.together)
        return;
      if (!study.refinements || !study.time_steps ||
          study.refinements->size() != study.time_steps->size())
        values.refuse(
          together,
          "give as many Refinements as Time steps, or set Refine together "
          "= false");
    }

    /** The form of a quantity: how it begins, what that measures. */
    struct Form
    {
      std::string beginning;
      Measure     measure;
    };

    const std::vector<Form> forms = {
      {"history ", Measure::history},
      {"maximum of ", Measure::maximum},
      {"minimum of ", Measure::minimum},
      {"time of maximum of ", Measure::time_of_maximum},
      {"time of minimum of ", Measure::time_of_minimum},
      {"integral of ", Measure::integral}};

    const std::string separator = " at ";

    std::vector<std::string> columns_in(const std::string &text)
    {
      return dealii::Utilities::split_string_list(text, ',');
    }

    /** What is taken at a time: a norm, or else a column. */
    void read_what_at_time(const std::string  &what,
                           QuantityDefinition &quantity)
    {
      if (what == "energy norm")
        quantity.measure = Measure::energy_norm;
      else if (what == "total energy norm")
        quantity.measure = Measure::total_energy_norm;
      else
        {
          quantity.measure = Measure::at_time;
          quantity.columns = columns_in(what);
        }
    }

    void read_at_time(const std::string &text, QuantityDefinition &quantity)
    {
      const std::size_t at = text.rfind(separator);
      if (at == std::string::npos)
        throw InputError(
          quantity.path + " = " + text +
          ": not understood; allowed: history COLUMN, COLUMN at TIME, COLUMN at "
          "end, maximum of COLUMN, minimum of COLUMN, time of maximum of COLUMN, "
          "time of minimum of COLUMN, integral of COLUMN, each with an exact "
          "value after it if one is known, = EXPRESSION; energy norm at TIME, "
          "total energy norm at TIME. Columns are those of history.csv, e.g. " +
          quantity.name + " = history top.uy");
      read_what_at_time(trim(text.substr(0, at)), quantity);
      const std::string time = trim(text.substr(at + separator.size()));
      if (time == "end")
        return;
      try
        {
          quantity.time = parse_quantity(time, "s");
        }
      catch (const InputError &error)
        {
          throw InputError(quantity.path + " = " + text + ": " + error.what() +
                           "; allowed after \"at\": a time, e.g. 5 ms, or end");
        }
    }

    void read_form(const std::string &text, QuantityDefinition &quantity)
    {
      for (const Form &form : forms)
        if (text.compare(0, form.beginning.size(), form.beginning) == 0)
          {
            quantity.measure = form.measure;
            quantity.columns = columns_in(text.substr(form.beginning.size()));
            return;
          }
      read_at_time(text, quantity);
    }

    /** A number with a unit word becomes one in SI; else @p text as it is. */
    std::string in_si(const std::string &text)
    {
      try
        {
          const std::string unit = split_quantity(text).unit;
          if (unit.empty())
            return text;
          std::ostringstream number;
          number << std::setprecision(std::numeric_limits<double>::max_digits10)
                 << parse_quantity(text, unit);
          return number.str();
        }
      catch (const InputError &)
        {
          // an expression
          return text;
        }
    }

    /** What stands from character @p begin on. */
    TimeFunction read_exact_value(ParameterValues  &values,
                                  const std::size_t begin)
    {
      const TimeExpression exact{values.name(), "", "1", ""};
      const std::string    text    = text_of_free_entry(values);
      SceneContext         context = values.context;
      context.path                 = "Quantities";
      ParameterValues value({exact}, context, values.location);
      value.set(exact.name, in_si(trim(text.substr(begin))));
      const TimeFunction function = read_time_function(value, exact);
      values.set(exact.name, text.substr(0, begin) + " " + value.text(exact));
      values.files = value.files;
      return function;
    }
  } // namespace



  bool StudyDefinition::is_exact() const
  {
    return !quantities.empty() &&
      std::all_of(quantities.begin(),
                  quantities.end(),
                  [](const QuantityDefinition &quantity) {
                    return quantity.exact.has_value();
                  });
  }



  SubsectionSchema study_schema()
  {
    return {"Study",
            SubsectionSchema::Form::fixed,
            "With Analysis = study: the scene is computed again and again with "
            "other parameters, to see what accuracy costs.",
            {kind,
             orders,
             refinements,
             time_steps,
             time_tolerances,
             newton_tolerances,
             schemes,
             together,
             reference,
             repetitions,
             tolerance},
            "",
            {},
            {Model::lattice, Model::reduced_cell}};
  }



  StudyDefinition read_study(ParameterValues &values)
  {
    StudyDefinition study;
    study.kind = values[kind];
    if (!is_auto(values, orders))
      study.orders = whole_numbers(values, orders);
    if (!is_auto(values, refinements))
      study.refinements = whole_numbers(values, refinements);
    if (!is_auto(values, time_steps))
      study.time_steps = values.value_or(time_steps, {});
    study.time_tolerances   = values.value_or(time_tolerances, {});
    study.newton_tolerances = values.value_or(newton_tolerances, {});
    study.schemes           = scheme_names(values);
    study.together          = values[together];
    study.extrapolates      = values[reference] == "extrapolation";
    study.repetitions       = values[repetitions];
    study.tolerance         = values[tolerance];
    refuse_unequal_lengths(values, study);
    return study;
  }



  SubsectionSchema quantities_schema()
  {
    return {
      "Quantities",
      SubsectionSchema::Form::free_entries,
      "What the runs of a study are compared by, by columns of "
      "history.csv: \"history COLUMN\" (its largest difference; of a vector "
      "\"history COLUMN, COLUMN\"), \"COLUMN "
      "at TIME\", \"COLUMN at end\", \"maximum of COLUMN\", \"minimum of "
      "COLUMN\", \"time of maximum of COLUMN\", \"time of minimum of "
      "COLUMN\", \"integral of COLUMN\" (over time). Where the exact value "
      "is known it may follow: \"... = EXPRESSION\", for a history in t. "
      "\"energy norm at TIME\": the square root of the strain energy of the "
      "difference, over all struts; \"total energy norm at TIME\": with its "
      "kinetic energy; TIME is that of a step, or end. "
      "Without any: the histories of the probes' displacements.",
      {},
      "",
      {},
      {Model::lattice, Model::reduced_cell}};
  }



  QuantityDefinition read_quantity(ParameterValues &values)
  {
    QuantityDefinition quantity;
    quantity.name          = values.name();
    quantity.path          = values.context.path;
    const std::string text = text_of_free_entry(values);
    const std::size_t sign = text.find('=');
    read_form(trim(text.substr(0, sign)), quantity);
    if (quantity.columns.empty() && !quantity.is_field())
      throw InputError(quantity.path + " = " + text +
                       ": a column of history.csv is missing");
    if (quantity.columns.size() > 1 && quantity.measure != Measure::history)
      throw InputError(quantity.path + " = " + text +
                       ": several columns have a meaning in a history only; "
                       "give each a line of its own");
    if (quantity.is_field() && sign != std::string::npos)
      throw InputError(quantity.path + " = " + text +
                       ": a field has no exact value here; remove what follows "
                       "the norm, it is measured against the reference");
    if (sign != std::string::npos)
      quantity.exact = read_exact_value(values, sign + 1);
    return quantity;
  }
} // namespace auxfem
