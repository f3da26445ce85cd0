#ifndef auxfem_study_settings_h
#define auxfem_study_settings_h

#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>
#include <auxfem/study/study_runs.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Settings that determine the error and the cost of a simulation. */
  struct Settings
  {
    unsigned int order            = 1; ///< order of the struts' elements
    unsigned int refinements      = 0; ///< 2^n elements per strut
    double       time_step        = 1; ///< s
    double       newton_tolerance = 1;
    std::string  scheme; ///< as in Time/Scheme
    /** Time/Relative tolerance. */
    std::optional<double> time_tolerance = {};

    /** Number of elements per strut. */
    unsigned long elements() const
    {
      return 1ul << refinements;
    }
  };

  bool operator==(const Settings &one, const Settings &other);

  /** Settings of @p scene. */
  Settings settings_of(const Scene &scene);

  /**
   * Command line assignments that change a scene from the settings @p from to
   * @p to.
   */
  std::vector<std::string> overrides(const Settings &from, const Settings &to);

  /** Options after `auxfem FILE.prm` for these overrides. */
  std::string command_line_text(const std::vector<std::string> &overrides);

  /**
   * Simulation of @p scene with other parameters. Throws InputError if they are
   * invalid.
   */
  Scene scene_with(const Scene                    &scene,
                   const std::vector<std::string> &overrides);

  /** Distinct settings of the simulations of a study. */
  class SettingsList
  {
  public:
    /**
     * Adds settings that are not in the list yet.
     * @param repetitions number of computations, for timing
     */
    void add(const std::vector<Settings> &settings, unsigned int repetitions);

    /**
     * Simulations of @p scene with these settings. Throws InputError if one is
     * invalid or converges to another limit than the scene.
     */
    std::vector<PlannedRun> planned_runs(const Scene &scene) const;

    /**
     * Selects from @p runs, the results of planned_runs(), those with @p
     * settings, which must be in the list.
     */
    std::vector<MeasuredRun>
    results_for(const std::vector<Settings>    &settings,
                const std::vector<MeasuredRun> &runs) const;

  private:
    std::size_t index(const Settings &settings) const;

    std::vector<Settings>     list;
    std::vector<unsigned int> repetitions;
  };

  /**
   * Name of a run, e.g. `order 2, 4 elements a strut, newmark, step 2e-05 s`.
   */
  std::string name_of_run(const Scene &scene, const Settings &settings);

  /** @p values sorted by @p is_coarser, without duplicates. */
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
   * @name Values of each parameter that a study tries, from coarse to fine.
   * Empty if only the value of the scene is used.
   */
  ///@{
  /** @param automatic values for `auto` */
  std::vector<unsigned int>
  tried_orders(const Scene &scene, const std::vector<unsigned int> &automatic);

  /**
   * @param further number of refinements beyond the value of the scene for
   *   `auto`
   */
  std::vector<unsigned int> tried_refinements(const Scene &scene,
                                              unsigned int further);

  /**
   * @param factors multiples of the value of the scene for `auto`; in statics
   *   only that value, because any step length is valid
   */
  std::vector<double> tried_time_steps(const Scene               &scene,
                                       const std::vector<double> &factors);

  /** Schemes to try, at least one. */
  std::vector<std::string> tried_schemes(const Scene &scene);
  ///@}

  /** Highest order of struts in the space of @p scene. */
  unsigned int highest_order(const Scene &scene);

  /** Whether the scene has a mesh. */
  bool has_mesh(const Scene &scene);

  /**
   * Two meshes finer than that of @p settings, the finest last; one order
   * higher if @p raises_order and possible.
   */
  std::vector<Settings>
  finer_meshes(const Scene &scene, const Settings &settings, bool raises_order);

  /** Halves the first time step once, the second twice, and so on. */
  void halve_time_steps(std::vector<Settings> &settings);
} // namespace auxfem

#endif
