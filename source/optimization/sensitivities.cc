#include <auxfem/optimization/sensitivities.h>

#include <array>
#include <cmath>
#include <string>

namespace auxfem
{
  namespace
  {
    /** Points and weights of a difference formula for one variable. */
    struct Difference
    {
      std::array<double, 3> offsets, weights;
      unsigned int          n;
    };

    Difference difference_at(const double part, const double step)
    {
      if (part - step < 0)
        return {{{0, step, 2 * step}},
                {{-1.5 / step, 2 / step, -0.5 / step}},
                3};
      if (part + step > 1)
        return {{{0, -step, -2 * step}},
                {{1.5 / step, -2 / step, 0.5 / step}},
                3};
      return {{{-step, step, 0}}, {{-0.5 / step, 0.5 / step, 0}}, 2};
    }

    void add_multiple(std::vector<double>       &sum,
                      const double               weight,
                      const std::vector<double> &values)
    {
      sum.resize(values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
        sum[i] += weight * values[i];
    }
  } // namespace

  std::vector<std::optional<GoalDerivatives>>
  derivatives_by_differences(DesignRuns        &runs,
                             const DesignPoint &point,
                             const double       step)
  {
    std::vector<Difference>  formulas;
    std::vector<DesignPoint> points;
    for (std::size_t v = 0; v < point.size(); ++v)
      {
        formulas.push_back(difference_at(point[v], step));
        for (unsigned int k = 0; k < formulas[v].n; ++k)
          {
            points.push_back(point);
            points.back()[v] += formulas[v].offsets[k];
          }
      }
    const std::vector<Design>                   designs = runs.at_all(points);
    std::vector<std::optional<GoalDerivatives>> derivatives(point.size());
    auto                                        design = designs.begin();
    for (std::size_t v = 0; v < point.size(); ++v)
      {
        derivatives[v].emplace();
        for (unsigned int k = 0; k < formulas[v].n; ++k, ++design)
          if (!design->is_usable())
            derivatives[v].reset();
          else if (derivatives[v])
            {
              const double      weight = formulas[v].weights[k];
              const GoalValues &values = *design->goals;
              add_multiple(derivatives[v]->objectives,
                           weight,
                           values.objectives);
              add_multiple(derivatives[v]->limited, weight, values.limited);
              add_multiple(derivatives[v]->limits, weight, values.limits);
            }
      }
    return derivatives;
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
          list.push_back({derivative,
                          std::abs(fine[i] - coarse[i]) / std::abs(slope),
                          derivative * variable / values[i]});
        }
      return list;
    }
  } // namespace

  std::vector<std::optional<VariableSensitivities>>
  sensitivities_at(DesignRuns                   &runs,
                   const OptimizationDefinition &optimization,
                   const Design                 &design)
  {
    const double step = optimization.difference_step;
    const auto   coarse =
                 derivatives_by_differences(runs, design.point, 2 * step),
               fine = derivatives_by_differences(runs, design.point, step);
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
