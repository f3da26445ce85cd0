#include <auxfem/study/refinement.h>
#include <auxfem/study/settings.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace auxfem
{
  namespace
  {
    std::vector<unsigned int> meshes(const Scene &scene)
    {
      return tried_refinements(scene, /*further=*/2);
    }

    std::vector<double> steps(const Scene &scene)
    {
      return tried_time_steps(scene, {4, 2, 1});
    }

    std::vector<unsigned int> orders(const Scene &scene)
    {
      const unsigned int scene_order = scene.discretization.order;
      return values_or(tried_orders(scene, {scene_order}), scene_order);
    }

    std::string order_title(const unsigned int order)
    {
      return "order " + std::to_string(order);
    }

    /** Title from scheme and, for meshes, order. */
    std::string scheme_title(const Scene &scene, const Settings &settings)
    {
      return (has_mesh(scene) ? order_title(settings.order) + ", " : "") +
        settings.scheme;
    }

    void add_mesh_refinements(const Scene             &scene,
                              std::vector<Refinement> &refinements)
    {
      if (meshes(scene).empty())
        return;
      for (const unsigned int order : orders(scene))
        {
          Refinement refinement{RefinedParameter::mesh,
                                order_title(order),
                                {},
                                {}};
          Settings   settings = settings_of(scene);
          settings.order      = order;
          for (const unsigned int mesh : meshes(scene))
            {
              settings.refinements = mesh;
              refinement.runs.push_back(settings);
            }
          // All orders have the same limit, and the highest is closest to it.
          // Extrapolation needs runs of one order.
          if (!scene.study.extrapolates)
            settings.order = orders(scene).back();
          refinement.references =
            finer_meshes(scene, settings, !scene.study.extrapolates);
          refinements.push_back(refinement);
        }
    }

    void add_time_step_refinements(const Scene             &scene,
                                   std::vector<Refinement> &refinements)
    {
      if (steps(scene).empty())
        return;
      for (const std::string &scheme : tried_schemes(scene))
        {
          Refinement refinement{RefinedParameter::time_step, scheme, {}, {}};
          Settings   settings = settings_of(scene);
          settings.scheme     = scheme;
          for (const double step : steps(scene))
            {
              settings.time_step = step;
              refinement.runs.push_back(settings);
            }
          // All schemes have the same limit.
          if (!scene.study.extrapolates)
            settings.scheme = tried_schemes(scene).front();
          refinement.references.assign(2, settings);
          halve_time_steps(refinement.references);
          refinements.push_back(refinement);
        }
    }

    /**
     * Refines the tolerance @p member of the settings.
     * @param factor ratio of the tolerances of successive references
     */
    template <class Member>
    void add_tolerances(const Scene               &scene,
                        const RefinedParameter     refined,
                        const std::vector<double> &tolerances,
                        const Member               member,
                        const double               factor,
                        std::vector<Refinement>   &refinements)
    {
      if (tolerances.empty())
        return;
      Settings   settings = settings_of(scene);
      Refinement refinement{refined, scheme_title(scene, settings), {}, {}};
      for (const double tolerance : sorted_values(tolerances, std::greater<>()))
        {
          settings.*member = tolerance;
          refinement.runs.push_back(settings);
        }
      double finer = *std::min_element(tolerances.begin(), tolerances.end());
      for (unsigned int i = 0; i < 2; ++i)
        {
          finer /= factor;
          settings.*member = finer;
          refinement.references.push_back(settings);
        }
      refinements.push_back(refinement);
    }

    void add_joint_refinements(const Scene             &scene,
                               std::vector<Refinement> &refinements)
    {
      Settings settings = settings_of(scene);
      for (const unsigned int order : orders(scene))
        for (const std::string &scheme : tried_schemes(scene))
          {
            settings.order  = order;
            settings.scheme = scheme;
            Refinement refinement{RefinedParameter::mesh_and_time_step,
                                  scheme_title(scene, settings),
                                  {},
                                  {}};
            for (std::size_t i = 0; i < meshes(scene).size(); ++i)
              {
                settings.refinements = meshes(scene)[i];
                settings.time_step   = steps(scene)[i];
                refinement.runs.push_back(settings);
              }
            refinement.references =
              finer_meshes(scene, settings, /*raises_order=*/false);
            halve_time_steps(refinement.references);
            refinements.push_back(refinement);
          }
    }

    /** Value of a quantity in a run; empty if the run failed. */
    using Values = std::optional<QuantityValues>;

    std::optional<double> difference(const Values &one, const Values &other)
    {
      if (!one || !other)
        return {};
      const double result = relative_difference(*one, *other);
      return std::isfinite(result) ? std::optional<double>(result)
                                   : std::nullopt;
    }

    /** Absolute norm of the difference. */
    std::optional<double> change(const Values &one, const Values &other)
    {
      if (!one || !other)
        return {};
      const double result = norm_of_change(*one, *other);
      return std::isfinite(result) ? std::optional<double>(result)
                                   : std::nullopt;
    }

    /**
     * Convergence order from @p coarse to @p fine; empty if one is not
     * positive.
     */
    std::optional<double> convergence_order(const std::optional<double> &coarse,
                                            const std::optional<double> &fine,
                                            const double                 ratio)
    {
      if (!coarse || !fine || *fine <= 0 || *coarse <= 0)
        return {};
      return std::log(*coarse / *fine) / std::log(ratio);
    }

    /**
     * Remaining error of @p fine over the change from @p middle to @p fine, if
     * changes continue to decrease at the same rate; empty if they do not
     * decrease.
     */
    std::optional<double> remaining_fraction(const Values &coarse,
                                             const Values &middle,
                                             const Values &fine,
                                             const double  ratio)
    {
      const auto order =
        convergence_order(change(coarse, middle), change(middle, fine), ratio);
      if (!order || *order <= 0)
        return {};
      return 1 / (std::pow(ratio, *order) - 1);
    }

    /** Richardson limit of three values with the refinement ratio @p ratio. */
    Values limit_of(const Values &coarse,
                    const Values &middle,
                    const Values &fine,
                    const double  ratio)
    {
      const auto part = remaining_fraction(coarse, middle, fine, ratio);
      if (!part)
        return fine;
      QuantityValues limit = *fine;
      for (std::size_t i = 0; i < limit.numbers.size(); ++i)
        limit.numbers[i] += *part * (fine->numbers[i] - middle->numbers[i]);
      return limit;
    }

    double ratio_of_references(const Refinement &refinement)
    {
      return coarseness(refinement.refined, refinement.references[0]) /
        coarseness(refinement.refined, refinement.references[1]);
    }

    /**
     * Error of the finest reference: the remaining part of its change, or the
     * whole change if the runs have another order or scheme.
     */
    std::optional<double> error_of_finest(const Refinement &refinement,
                                          const Values     &last_run,
                                          const Values     &finer,
                                          const Values     &finest)
    {
      const Settings &run       = refinement.runs.back();
      const Settings &reference = refinement.references.front();
      const auto      whole     = difference(finer, finest);
      const auto      part      = remaining_fraction(last_run,
                                           finer,
                                           finest,
                                           ratio_of_references(refinement));
      const bool      is_same_kind =
        run.order == reference.order && run.scheme == reference.scheme;
      return whole && part && is_same_kind ? *part * *whole : whole;
    }

    std::optional<double> convergence_index(const Values &coarse,
                                            const Values &middle,
                                            const Values &fine,
                                            const double  ratio)
    {
      constexpr double safety = 1.25;
      const auto       part   = remaining_fraction(coarse, middle, fine, ratio);
      if (!part)
        return {};
      return safety * *part * *difference(middle, fine);
    }
  } // namespace

  const std::string &name_of(const RefinedParameter refined)
  {
    static const std::array<std::string, 5> names = {{"mesh",
                                                      "time step",
                                                      "relative tolerance",
                                                      "Newton tolerance",
                                                      "mesh and time step"}};
    return names[static_cast<std::size_t>(refined)];
  }

  std::vector<Refinement> refinements_of(const Scene &scene)
  {
    std::vector<Refinement> refinements;
    if (scene.study.together)
      add_joint_refinements(scene, refinements);
    else
      {
        add_mesh_refinements(scene, refinements);
        add_time_step_refinements(scene, refinements);
      }
    // A quarter of the error requires half the step length.
    add_tolerances(scene,
                   RefinedParameter::time_tolerance,
                   scene.study.time_tolerances,
                   &Settings::time_tolerance,
                   4,
                   refinements);
    add_tolerances(scene,
                   RefinedParameter::newton_tolerance,
                   scene.study.newton_tolerances,
                   &Settings::newton_tolerance,
                   10,
                   refinements);
    if (scene.study.is_exact())
      for (Refinement &refinement : refinements)
        refinement.references.clear();
    return refinements;
  }

  double coarseness(const RefinedParameter refined, const Settings &settings)
  {
    return refined == RefinedParameter::mesh        ? 1. / settings.elements()
      : refined == RefinedParameter::time_tolerance ? *settings.time_tolerance
      : refined == RefinedParameter::newton_tolerance
      ? settings.newton_tolerance
      : settings.time_step;
  }

  RefinementErrors errors_of(const Refinement               &refinement,
                             const QuantityDefinition       &quantity,
                             const std::vector<MeasuredRun> &runs,
                             const double                    end_time,
                             const bool                      extrapolates)
  {
    const Comparison    comparison = comparison_of(runs);
    std::vector<Values> values;
    for (const MeasuredRun &run : runs)
      values.push_back(run.completed()
                         ? Values(value_of(quantity, run, comparison))
                         : std::nullopt);
    const auto ratio = [&refinement](const std::size_t i) {
      return coarseness(refinement.refined, refinement.runs[i - 1]) /
        coarseness(refinement.refined, refinement.runs[i]);
    };

    RefinementErrors  result;
    const std::size_t n = refinement.runs.size();
    Values reference    = exact_value_of(quantity, end_time, comparison);
    if (!reference)
      {
        const Values &finer = values[n];
        reference           = values[n + 1];
        if (extrapolates)
          reference = limit_of(values[n - 1],
                               finer,
                               reference,
                               ratio_of_references(refinement));
        result.reference_error = extrapolates
          ? difference(values[n + 1], reference)
          : error_of_finest(refinement, values[n - 1], finer, reference);
      }

    // With five times the error of the reference, an order changes by at most a
    // third.
    constexpr double min_error_ratio = 5;
    for (std::size_t i = 0; i < n; ++i)
      {
        RunError one;
        one.error = difference(values[i], reference);
        if (values[i] && quantity.is_number())
          one.value = values[i]->numbers.front();
        if (i > 0 && one.error &&
            *one.error > min_error_ratio * result.reference_error.value_or(0))
          one.order =
            convergence_order(result.runs.back().error, one.error, ratio(i));
        if (i > 1)
          one.convergence_index = convergence_index(values[i - 2],
                                                    values[i - 1],
                                                    values[i],
                                                    ratio(i));
        result.runs.push_back(one);
      }
    return result;
  }

  std::string recommendations_text(const Scene       &scene,
                                   const Recommender &recommend)
  {
    constexpr std::array<std::pair<double, const char *>, 6> targets = {
      {{1e-6, "0.0001 %"},
       {1e-5, "0.001 %"},
       {1e-4, "0.01 %"},
       {1e-3, "0.1 %"},
       {1e-2, "1 %"},
       {1e-1, "10 %"}}};
    const Settings          scene_settings = settings_of(scene);
    std::string             text;
    std::optional<Settings> latest;
    for (const auto &[target, name] : targets)
      {
        const auto recommended = recommend(target);
        if (!recommended || (latest && recommended->settings == *latest))
          continue;
        latest = recommended->settings;
        const std::string changes =
          command_line_text(overrides(scene_settings, recommended->settings));
        text = "- for " + std::string(name) + ":" +
          (changes.empty() ? " the scene as it is" : changes) + "  (" +
          recommended->remark + ")\n" + text;
      }
    return text.empty() ? "No settings of the study give an error below 10 %.\n"
                        : text;
  }
} // namespace auxfem
