#ifndef auxfem_study_settings_h
#define auxfem_study_settings_h

#include <auxfem/scene/scene.h>
#include <auxfem/study/study_runs.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** What decides on the error of a simulation and on its price. */
  struct Settings
  {
    unsigned int order            = 1; ///< of the struts' elements
    unsigned int refinements      = 0; ///< 2^n elements a strut
    double       time_step        = 1; ///< s
    double       newton_tolerance = 1;
    std::string  scheme; ///< as in Time/Scheme
    /** Time/Relative tolerance. */
    std::optional<double> time_tolerance = {};

    /** Elements a strut. */
    unsigned long elements() const
    {
      return 1ul << refinements;
    }
  };

  bool operator==(const Settings &one, const Settings &other);

  /** Those of @p scene. */
  Settings settings_of(const Scene &scene);

  /**
   * Assignments of the command line that turn a scene of the settings @p from
   * into one of @p to.
   */
  std::vector<std::string> overrides(const Settings &from, const Settings &to);

  /** What follows `auxfem FILE.prm` on a command line for these overrides. */
  std::string command_line_text(const std::vector<std::string> &overrides);

  /**
   * The simulation of @p scene with other parameters. Throws InputError if they
   * are wrong.
   */
  Scene scene_with(const Scene                    &scene,
                   const std::vector<std::string> &overrides);

  /** @p value with twelve digits, zeros at the end left out. */
  std::string short_number(double value);

  /** The different settings that a study computes a scene with, each once. */
  class SettingsList
  {
  public:
    /**
     * Does nothing with those that are in the list.
     * @param repetitions how often they are computed, for their time.
     */
    void add(const std::vector<Settings> &settings, unsigned int repetitions);

    /** The simulations of @p scene with them. Throws InputError if one is wrong,
     * or has another limit than the scene. */
    std::vector<PlannedRun> planned_runs(const Scene &scene) const;

    /** Those of @p runs, the results of planned_runs(), that were done with
     * @p settings, which must be in the list. */
    std::vector<MeasuredRun> of(const std::vector<Settings>    &settings,
                                const std::vector<MeasuredRun> &runs) const;

  private:
    std::size_t index(const Settings &settings) const;

    std::vector<Settings>     list;
    std::vector<unsigned int> repetitions;
  };

  /** E.g. `order 2, 4 elements a strut, newmark, step 2e-05 s`. */
  std::string name_of_run(const Scene &scene, const Settings &settings);

  /** @p values sorted by @p is_coarser, each once. */
  template <class Value, class Order>
  std::vector<Value> sorted_values(std::vector<Value> values,
                                   const Order       &is_coarser)
  {
    std::sort(values.begin(), values.end(), is_coarser);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  }

  /** @p values, or @p only if there are none. */
  template <class Value>
  std::vector<Value> values_or(const std::vector<Value> &values,
                               const Value              &only)
  {
    return values.empty() ? std::vector<Value>{only} : values;
  }

  /**
   * @name What a study tries of each parameter, from coarse to fine
   * Empty where the user wants the value of the scene alone.
   */
  ///@{
  /** @param automatic what `auto` stands for. */
  std::vector<unsigned int>
  tried_orders(const Scene &scene, const std::vector<unsigned int> &automatic);

  /** @param further `auto` stands for the value of the scene, and so many
   * refinements after it. */
  std::vector<unsigned int> tried_refinements(const Scene &scene,
                                              unsigned int further);

  /** @param factors `auto` stands for the value of the scene times each; in
   * statics, which may be followed in any steps, for that value alone. */
  std::vector<double> tried_time_steps(const Scene               &scene,
                                       const std::vector<double> &factors);

  /** One at least. */
  std::vector<std::string> tried_schemes(const Scene &scene);
  ///@}

  /** Highest order of struts in the space of @p scene. */
  unsigned int highest_order(const Scene &scene);

  /** Whether struts are divided into elements at all. */
  bool has_mesh(const Scene &scene);

  /**
   * Two meshes finer than that of @p settings, the finest last: of one order
   * more if @p raises_order and there is one.
   */
  std::vector<Settings>
  finer_meshes(const Scene &scene, const Settings &settings, bool raises_order);

  /** Halves the time steps: the first once, the second twice, and so on. */
  void halve_time_steps(std::vector<Settings> &settings);
} // namespace auxfem

#endif
