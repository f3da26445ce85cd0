#include <auxfem/elements/strut_order.h>
#include <auxfem/study/tried_values.h>

#include <cmath>
#include <functional>

namespace auxfem
{
  std::vector<unsigned int>
  tried_orders(const Scene &scene, const std::vector<unsigned int> &automatic)
  {
    if (!has_mesh(scene))
      return {};
    return sorted_values(scene.study.orders.value_or(automatic), std::less<>());
  }



  std::vector<unsigned int> tried_refinements(const Scene       &scene,
                                              const unsigned int further)
  {
    if (!has_mesh(scene))
      return {};
    std::vector<unsigned int> automatic;
    for (unsigned int i = 0; i <= further; ++i)
      automatic.push_back(scene.discretization.refinements + i);
    return sorted_values(scene.study.refinements.value_or(automatic),
                         std::less<>());
  }



  std::vector<double> tried_time_steps(const Scene               &scene,
                                       const std::vector<double> &factors)
  {
    std::vector<double> automatic;
    if (scene.time.scheme->is_dynamic())
      for (const double factor : factors)
        automatic.push_back(factor * scene.time.step);
    return sorted_values(scene.study.time_steps.value_or(automatic),
                         std::greater<>());
  }



  std::vector<std::string> tried_schemes(const Scene &scene)
  {
    return values_or(scene.study.schemes, scene.time.scheme->name());
  }



  unsigned int highest_order(const Scene &scene)
  {
    return highest_strut_order(scene.context.dimension);
  }



  bool has_mesh(const Scene &scene)
  {
    return scene.context.model == Model::lattice;
  }



  std::vector<Settings> finer_meshes(const Scene    &scene,
                                     const Settings &settings,
                                     const bool      raises_order)
  {
    std::vector<Settings> finer(2, settings);
    if (!has_mesh(scene))
      return finer;
    const bool raises = raises_order && settings.order < highest_order(scene);
    for (unsigned int i = 0; i < finer.size(); ++i)
      {
        finer[i].order += raises;
        finer[i].refinements += raises ? i : i + 1;
      }
    return finer;
  }



  void halve_time_steps(std::vector<Settings> &settings)
  {
    for (std::size_t i = 0; i < settings.size(); ++i)
      settings[i].time_step = std::ldexp(settings[i].time_step, -int(i) - 1);
  }
} // namespace auxfem
