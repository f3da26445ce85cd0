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

    constexpr unsigned int max_values = 50;

    const Choice kind = {
      "Kind",
      "convergence",
      {"convergence", "work-precision", "effects"},
      "Kind of study. convergence: error and cost as mesh, time step and Newton "
      "tolerance are refined one by one; work-precision: the fastest combination "
      "of order, refinement, time step and scheme for each error; effects: change "
      "of the results and time saved if each effect is left out in turn."};
    const QuantityList orders = {
      "Orders",
      "auto",
      "1",
      Range::closed(1, largest_plane_order),
      1,
      max_values,
      "Polynomial orders of the elements; none: that of the scene; auto: with "
      "Kind = work-precision also the next lower and higher one.",
      {"auto", "none"}};
    const QuantityList refinements = {
      "Refinements",
      "auto",
      "1",
      Range::closed(0, 10),
      1,
      max_values,
      "Numbers n of halvings, 2^n elements a strut; none: that of the scene; "
      "auto: with Kind = convergence also the next two.",
      {"auto", "none"}};
    const QuantityList time_steps = {
      "Time steps",
      "auto",
      "s",
      Range::positive(),
      1,
      max_values,
      "Lengths of a time step; none: that of the scene; auto: 4, 2 and 1 times "
      "that of the scene, with Kind = work-precision also half of it, in statics "
      "that of the scene only.",
      {"auto", "none"}};
    const QuantityList time_tolerances = {
      "Relative tolerances",
      "none",
      "1",
      Range::open(0, 1),
      1,
      max_values,
      "Values of Time/Relative tolerance; none: that of the scene.",
      {"none"}};
    const QuantityList newton_tolerances = {
      "Newton tolerances",
      "none",
      "1",
      Range::open(0, 1),
      1,
      max_values,
      "Values of Newton's tolerance; none: that of the scene.",
      {"none"}};
    const Text schemes = {
      "Schemes",
      "none",
      "Time integrators, separated by commas; none: that of the scene."};
    const Boolean refine_together = {
      "Refine together",
      false,
      "Whether the n-th refinement is combined with the n-th time step; otherwise "
      "each is refined while the other stays as in the scene."};
    const Choice reference = {
      "Reference",
      "finer run",
      {"finer run", "extrapolation"},
      "Reference for errors where no exact value is given. finer run: a run finer "
      "than all others; extrapolation: the limit of two such runs (Richardson)."};

    const Integer repetitions = {
      "Repetitions",
      3,
      1,
      100,
      "With Kind = work-precision or effects: repetitions of each timed run; the "
      "shortest time counts."};
    const Quantity tolerance = {
      "Tolerance",
      "1 %",
      "1",
      Range::positive(),
      "With Kind = effects: relative change of a quantity above which an effect "
      "is needed."};

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
          refine_together,
          "give as many Refinements as Time steps, or set Refine together "
          "= false");
    }

    /** Text at the beginning of a quantity and the measure it stands for. */
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
      {"integral of ", Measure::integral},
      {"mean square deviation of ", Measure::mean_square_deviation}};

    const std::string separator = " at ";

    bool begins_with(const std::string &text, const std::string &beginning)
    {
      return text.compare(0, beginning.size(), beginning) == 0;
    }

    std::vector<std::string> columns_in(const std::string &text)
    {
      return dealii::Utilities::split_string_list(text, ',');
    }

    /** Reads the text before `at TIME`: a norm or a column. */
    void read_norm_or_column(const std::string  &text,
                             QuantityDefinition &quantity)
    {
      if (text == "energy norm")
        quantity.measure = Measure::energy_norm;
      else if (text == "total energy norm")
        quantity.measure = Measure::total_energy_norm;
      else
        {
          quantity.measure = Measure::at_time;
          quantity.columns = columns_in(text);
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
          "time of minimum of COLUMN, integral of COLUMN, mean square deviation "
          "of COLUMN from FUNCTION, each maybe followed by an exact value, = "
          "EXPRESSION; energy norm at TIME, total energy norm "
          "at TIME. Columns are those of history.csv, e.g. " +
          quantity.name + " = history top.uy");
      read_norm_or_column(trim(text.substr(0, at)), quantity);
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
        if (begins_with(text, form.beginning))
          {
            quantity.measure = form.measure;
            quantity.columns = columns_in(text.substr(form.beginning.size()));
            return;
          }
      read_at_time(text, quantity);
    }

    /** Converts a number with a unit to SI; returns any other @p text as it
     * is. */
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
          return text; // an expression
        }
    }

    /** Reads a function of time from character @p begin on. */
    TimeFunction read_function(ParameterValues &values, const std::size_t begin)
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
    const std::string from = " from ";

    /** Reads `COLUMN from FUNCTION` of a mean square deviation. */
    void read_target(ParameterValues &values, QuantityDefinition &quantity)
    {
      const std::string text     = text_of_free_entry(values);
      const std::size_t position = text.find(from);
      if (position == std::string::npos)
        throw InputError(
          quantity.path + " = " + text +
          ": the function to compare with is missing. Allowed: "
          "mean square deviation of COLUMN from an expression in "
          "t or table: FILE, e.g. from table: measured.csv");
      const std::string &beginning = forms.back().beginning;
      quantity.columns =
        columns_in(text.substr(beginning.size(), position - beginning.size()));
      quantity.target = read_function(values, position + from.size());
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
    return {
      "Study",
      SubsectionSchema::Form::fixed,
      "With Analysis = study: many runs with other parameters, to find the "
      "cost of accuracy.",
      {kind,
       orders,
       refinements,
       time_steps,
       time_tolerances,
       newton_tolerances,
       schemes,
       refine_together,
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
    study.together          = values[refine_together];
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
      "Quantities by which a study compares its runs, from columns of "
      "history.csv: \"history COLUMN\" (its largest difference; for a vector "
      "\"history COLUMN, COLUMN\"), \"COLUMN at TIME\", \"COLUMN at end\", "
      "\"maximum of COLUMN\", \"minimum of COLUMN\", \"time of maximum of "
      "COLUMN\", \"time of minimum of COLUMN\", \"integral of COLUMN\" (over "
      "time), \"mean square deviation of COLUMN from FUNCTION\" (an expression in t "
      "or table: FILE, mean over time). A known exact value may follow: \"... = EXPRESSION\", for a history "
      "in t. \"energy norm at TIME\": square root of the strain energy of the "
      "difference, over all struts; \"total energy norm at TIME\": with kinetic "
      "energy; TIME is that of a step, or end. Without quantities: the histories "
      "of the probes' displacements.",
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
    // The target of a deviation may be a condition.
    const bool        is_deviation = begins_with(text, forms.back().beginning);
    const std::size_t sign = is_deviation ? std::string::npos : text.find('=');
    read_form(trim(text.substr(0, sign)), quantity);
    if (is_deviation)
      read_target(values, quantity);
    if (quantity.columns.empty() && !quantity.is_field())
      throw InputError(quantity.path + " = " + text +
                       ": a column of history.csv is missing");
    if (quantity.columns.size() > 1 && quantity.measure != Measure::history)
      throw InputError(quantity.path + " = " + text +
                       ": several columns are allowed in a history only; give "
                       "each column a line of its own");
    if (quantity.is_field() && sign != std::string::npos)
      throw InputError(
        quantity.path + " = " + text +
        ": a norm has no exact value, it is measured against the "
        "reference; remove the text from = on");
    if (sign != std::string::npos)
      quantity.exact = read_function(values, sign + 1);
    return quantity;
  }
} // namespace auxfem
