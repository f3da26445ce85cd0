#include <auxfem/optimization/direct_derivatives.h>
#include <auxfem/optimization/sensitivities.h>

#include <cmath>
#include <utility>

namespace auxfem
{
  namespace
  {
    void add_multiple(std::vector<double>       &sum,
                      const double               weight,
                      const std::vector<double> &values)
    {
      sum.resize(values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
        sum[i] += weight * values[i];
    }
  } // namespace

  DifferenceFormulas::DifferenceFormulas(const DesignPoint &point,
                                         const double       step)
  {
    for (std::size_t v = 0; v < point.size(); ++v)
      {
        std::vector<double> offsets = {-step, step};
        weights.push_back({-0.5 / step, 0.5 / step});
        const double side = point[v] - step < 0 ? 1
          : point[v] + step > 1                 ? -1
                                                : 0;
        if (side != 0)
          {
            offsets        = {0, side * step, 2 * side * step};
            weights.back() = {-1.5 * side / step,
                              2 * side / step,
                              -0.5 * side / step};
          }
        for (const double offset : offsets)
          {
            point_list.push_back(point);
            point_list.back()[v] += offset;
          }
      }
  }

  Derivatives DifferenceFormulas::differences(
    const std::vector<std::optional<GoalValues>> &values) const
  {
    Derivatives derivatives;
    auto        value = values.begin();
    for (const std::vector<double> &formula : weights)
      {
        std::optional<GoalDerivatives> derivative(std::in_place);
        for (const double weight : formula)
          {
            if (!*value)
              derivative.reset();
            if (derivative)
              {
                add_multiple(derivative->objectives,
                             weight,
                             (*value)->objectives);
                add_multiple(derivative->limited, weight, (*value)->limited);
                add_multiple(derivative->limits, weight, (*value)->limits);
              }
            ++value;
          }
        derivatives.push_back(derivative);
      }
    return derivatives;
  }

  Derivatives derivatives_by_runs(DesignRuns        &runs,
                                  const DesignPoint &point,
                                  const double       step)
  {
    const DifferenceFormulas               formulas(point, step);
    std::vector<std::optional<GoalValues>> values;
    for (const Design &design : runs.at_all(formulas.points()))
      values.push_back(design.is_usable() ? design.goals : std::nullopt);
    return formulas.differences(values);
  }

  bool Sensitivity::is_resolved() const
  {
    return std::abs(derivative) > error;
  }

  namespace
  {
    /** Derivative of the value of @p variable by the part of its range. */
    double slope_at(const DesignVariable &variable, const double part)
    {
      return variable.is_logarithmic
        ? variable.value_at(part) * std::log(variable.upper / variable.lower)
        : variable.upper - variable.lower;
    }

    std::vector<Sensitivity> combine(const std::vector<double> &coarse,
                                     const std::vector<double> &fine,
                                     const std::vector<double> &values,
                                     const double               slope,
                                     const double               variable)
    {
      std::vector<Sensitivity> list;
      for (std::size_t i = 0; i < values.size(); ++i)
        {
          // Richardson's extrapolation of differences of second order.
          const double derivative = (4 * fine[i] - coarse[i]) / 3 / slope;
          const double error      = std::abs((fine[i] - coarse[i]) / slope),
                       ratio      = variable / values[i];
          list.push_back(
            {derivative, error, derivative * ratio, error * std::abs(ratio)});
        }
      return list;
    }
  } // namespace

  std::vector<std::optional<VariableSensitivities>>
  sensitivities_at(DesignRuns                   &runs,
                   const OptimizationDefinition &optimization,
                   const Design                 &design)
  {
    const double      step   = optimization.difference_step;
    const Derivatives coarse = derivatives_at(runs, design.point, step, 2),
                      fine   = derivatives_at(runs, design.point, step);
    std::vector<std::optional<VariableSensitivities>> sensitivities(
      coarse.size());
    for (std::size_t v = 0; v < coarse.size(); ++v)
      if (coarse[v] && fine[v])
        {
          const DesignVariable &variable = optimization.variables[v];
          const double          slope    = slope_at(variable, design.point[v]),
                       value             = variable.value_at(design.point[v]);
          sensitivities[v]               = {combine(coarse[v]->objectives,
                                      fine[v]->objectives,
                                      design.goals->objectives,
                                      slope,
                                      value),
                                            combine(coarse[v]->limited,
                                      fine[v]->limited,
                                      design.goals->limited,
                                      slope,
                                      value)};
        }
    return sensitivities;
  }
} // namespace auxfem
