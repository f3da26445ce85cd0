#ifndef auxfem_study_tried_values_h
#define auxfem_study_tried_values_h

#include <auxfem/study/settings.h>

#include <algorithm>
#include <string>
#include <vector>

namespace auxfem
{
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
