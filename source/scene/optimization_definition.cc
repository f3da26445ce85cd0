#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/optimization_definition.h>
#include <auxfem/scene/scene.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::split_string_list;
    using dealii::Utilities::trim;

    /** Largest number of runs of a search, and of searches. */
    constexpr unsigned int most_runs = 100000, most_searches = 1000;

    const Text objective = {
      "Objective",
      "none",
      "\"minimize EXPRESSION\" or \"maximize EXPRESSION\" of results of the "
      "analysis: numbers in summary.json by their paths or the ends of these, e.g. "
      "\"minimize abs(floor.y.peak_force)\", and Quantities. Two objectives, separated "
      "by a semicolon, lead to their Pareto front."};
    const Text limits = {
      "Constraints",
      "none",
      "Limits of results, \"EXPRESSION <= LIMIT\" or \"EXPRESSION >= LIMIT\", "
      "separated by semicolons, e.g. \"mass_kilogram <= 20 g; abs(head.y.stroke) <= 5 mm\"."};
    const Text method = {
      "Method",
      "auto",
      "Methods of the library NLopt, one after another, each from the best design "
      "of the one before. Local: COBYLA, BOBYQA, Subplex; global: DIRECT-L, CRS; "
      "by derivatives: MMA, SLSQP. auto: COBYLA with constraints or one variable, "
      "else BOBYQA."};
    const Integer evaluations = {
      "Evaluations",
      200,
      1,
      most_runs,
      "Largest number of designs that each search tries with each method."};
    const Integer starts = {
      "Starts",
      1,
      1,
      most_searches,
      "Number of searches: the first one from the values of the scene, further "
      "ones from the points of a Latin hypercube. They run side by side on the "
      "ranks."};
    const Integer search_seed = {
      "Seed",
      1,
      0,
      2147483647,
      "Seed of the random numbers of the starts and of Method = CRS."};
    const Quantity first_step = {
      "First step",
      "20 %",
      "1",
      Range::open(0, 1),
      "First change of the variables, as a part of their ranges."};
    const Quantity search_tolerance = {
      "Tolerance",
      "1e-4",
      "1",
      Range::open(0, 1),
      "Change of the variables, as a part of their ranges, at which a search "
      "ends. Constraints may be exceeded by this part of their limits, at most a "
      "thousandth."};
    const Integer front_points = {
      "Front points",
      9,
      3,
      most_searches,
      "With two objectives: number of searches along the front, its ends "
      "included."};
    const Boolean sensitivities = {
      "Sensitivities",
      true,
      "Whether the derivatives of objectives and constraints at the best design "
      "are computed, with their errors."};
    const Quantity difference_step = {
      "Difference step",
      "0.5 %",
      "1",
      Range::open(0, 0.25),
      "Change of the variables, as a part of their ranges, for derivatives by "
      "differences of runs; those of equilibria without contact, effective "
      "properties and natural frequencies are direct."};

    [[noreturn]] void refuse_bounds(const ParameterValues &values,
                                    const std::string     &text,
                                    const std::string     &why)
    {
      throw InputError(values.context.path + " = " + text + ": " + why +
                       ". Allowed: LOWER:UPPER with a unit, e.g. 5:40 kN/m, "
                       "maybe followed by \"logarithmic\"");
    }

    /** Removes @p ending from @p text; returns whether it was there. */
    bool cut(std::string &text, const std::string &ending)
    {
      if (text.size() <= ending.size() ||
          text.compare(text.size() - ending.size(), ending.size(), ending) != 0)
        return false;
      text = trim(text.substr(0, text.size() - ending.size()));
      return true;
    }
  } // namespace

  double DesignVariable::value_at(const double part) const
  {
    if (part <= 0)
      return lower;
    if (part >= 1)
      return upper;
    return is_logarithmic ? lower * std::pow(upper / lower, part)
                          : lower + part * (upper - lower);
  }

  double DesignVariable::part_at(const double value) const
  {
    return is_logarithmic ? std::log(value / lower) / std::log(upper / lower)
                          : (value - lower) / (upper - lower);
  }

  std::string DesignVariable::text_at(const double part) const
  {
    // All digits that a number keeps: differences of near values matter.
    constexpr int n_digits = 15;
    return number_text(value_at(part), n_digits) +
      (unit.empty() ? "" : " " + unit);
  }

  SubsectionSchema design_variables_schema()
  {
    return {
      "Design variables",
      SubsectionSchema::Form::path_entries,
      "Parameters that Optimization may change, with their bounds: \"set "
      "Connectors/damper/Spring stiffness = 5:40 kN/m\"; \"logarithmic\" "
      "behind the unit for a search by factors. Several parameters change "
      "together by a constant that they refer to: \"set Constants/h = "
      "0.5:2 mm\". The search begins at the values of the scene.",
      {},
      "",
      {},
      {Model::lattice, Model::reduced_cell}};
  }

  DesignVariable read_design_variable(ParameterValues &values)
  {
    const std::string whole = text_of_free_entry(values);
    std::string       text  = trim(whole);
    DesignVariable    variable;
    variable.path           = values.name();
    variable.is_logarithmic = cut(text, "logarithmic");
    ParsedRange range;
    try
      {
        range = split_range(text);
      }
    catch (const InputError &error)
      {
        refuse_bounds(values, whole, error.what());
      }
    if (range.numbers.size() != 2)
      refuse_bounds(values, whole, "two bounds are needed");
    variable.unit  = range.unit;
    variable.lower = range.numbers[0];
    variable.upper = range.numbers[1];
    if (!(variable.lower < variable.upper))
      refuse_bounds(values,
                    whole,
                    "the lower bound must be less than the upper one");
    if (variable.is_logarithmic && variable.lower <= 0)
      refuse_bounds(values, whole, "logarithmic bounds must be positive");
    return variable;
  }

  SubsectionSchema optimization_schema()
  {
    return {
      "Optimization",
      SubsectionSchema::Form::fixed,
      "With Design variables: runs of the scene's analysis with other values of "
      "them, in search of the best results. optimization.csv has a row for each "
      "run; best.prm is the best scene.",
      {objective,
       limits,
       method,
       evaluations,
       starts,
       search_seed,
       first_step,
       search_tolerance,
       front_points,
       sensitivities,
       difference_step},
      "",
      {},
      {Model::lattice, Model::reduced_cell}};
  }

  namespace
  {
    Objective objective_in(const std::string &text)
    {
      const std::size_t blank = text.find(' ');
      const std::string goal  = text.substr(0, blank);
      if (blank == std::string::npos ||
          (goal != "minimize" && goal != "maximize"))
        throw InputError("Optimization/Objective = " + text +
                         ": not understood. Allowed: minimize EXPRESSION, "
                         "maximize EXPRESSION, e.g. minimize peak_force");
      return {trim(text.substr(blank)), goal == "maximize"};
    }

    /** One side of a constraint. */
    struct Side
    {
      std::string expression; ///< a quantity with a unit as its SI number
      std::string unit;       ///< of a quantity, else empty
    };

    Side side_of(const std::string &text)
    {
      try
        {
          constexpr int        n_digits = 15;
          const ParsedQuantity quantity = split_quantity(text);
          if (quantity.unit.empty())
            return {text, ""};
          return {number_text(quantity.number *
                                parse_unit(quantity.unit).factor,
                              n_digits),
                  quantity.unit};
        }
      catch (const InputError &)
        {
          return {text, ""}; // an expression
        }
    }

    /** Positions in @p text of `<=` and `>=` outside of parentheses. */
    std::vector<std::size_t> comparisons_in(const std::string &text)
    {
      std::vector<std::size_t> positions;
      int                      depth = 0;
      for (std::size_t i = 0; i + 1 < text.size(); ++i)
        {
          depth += (text[i] == '(') - (text[i] == ')');
          if (depth == 0 && (text[i] == '<' || text[i] == '>') &&
              text[i + 1] == '=')
            positions.push_back(i);
        }
      return positions;
    }

    ResultLimit limit_in(const std::string &text)
    {
      const auto refuse = [&text](const std::string &problem) {
        throw InputError("Optimization/Constraints = " + text + ": " + problem +
                         ". Allowed: EXPRESSION <= LIMIT, EXPRESSION >= LIMIT, "
                         "e.g. mass_kilogram <= 20 g");
      };
      const std::vector<std::size_t> comparisons = comparisons_in(text);
      if (comparisons.size() > 1)
        refuse("a constraint has one limit. Write two of them, separated by a "
               "semicolon");
      if (comparisons.empty())
        refuse("not understood");
      const std::size_t sign = comparisons.front();
      const Side        left = side_of(trim(text.substr(0, sign))),
                 right       = side_of(trim(text.substr(sign + 2)));
      if (left.expression.empty() || right.expression.empty())
        refuse("not understood");
      const bool is_upper = text[sign] == '<';
      // 0.2 MPa <= E1
      if (!left.unit.empty())
        return {right.expression, left.expression, left.unit, !is_upper, text};
      return {left.expression, right.expression, right.unit, is_upper, text};
    }
  } // namespace

  void read_optimization(const ParameterValues  &values,
                         OptimizationDefinition &optimization)
  {
    if (values[objective] != "none")
      for (const std::string &text : split_string_list(values[objective], ';'))
        optimization.objectives.push_back(objective_in(trim(text)));
    if (optimization.objectives.size() > 2)
      values.refuse(objective,
                    "there may be one or two objectives. Make the others "
                    "constraints");
    if (values[limits] != "none")
      for (const std::string &text : split_string_list(values[limits], ';'))
        optimization.limits.push_back(limit_in(trim(text)));
    if (values[method] != "auto")
      for (const std::string &name : split_string_list(values[method], ','))
        optimization.methods.push_back(trim(name));
    optimization.n_evaluations     = values[evaluations];
    optimization.n_starts          = values[starts];
    optimization.seed              = values[search_seed];
    optimization.first_step        = values[first_step];
    optimization.tolerance         = values[search_tolerance];
    optimization.n_front_points    = values[front_points];
    optimization.has_sensitivities = values[sensitivities];
    optimization.difference_step   = values[difference_step];
  }

  void check_optimization(const Scene &scene, Mistakes &mistakes)
  {
    // A parameter with a mistake would be reported as missing, too.
    if (!mistakes.empty())
      return;
    const OptimizationDefinition &optimization = scene.optimization;
    if (optimization.is_given() == !optimization.objectives.empty())
      {
        if (optimization.is_given() && scene.sweep.is_given())
          mistakes.add(scene.file +
                       ": Sweep and Design variables are two ways to run the "
                       "scene with other values. Remove one of them");
        if (optimization.is_given() && scene.analysis == Analysis::study)
          mistakes.add(scene.file +
                       ": Design variables need the results of one run, but "
                       "Analysis = study makes many. Choose another analysis");
        return;
      }
    mistakes.add(
      scene.file +
      (optimization.is_given()
         ? ": Design variables need an objective. Give "
           "Optimization/Objective, e.g. minimize peak_force"
         : ": Optimization/Objective needs parameters that may change. Give "
           "Design variables, e.g. set Connectors/damper/Spring stiffness = "
           "5:40 kN/m"));
  }
} // namespace auxfem
