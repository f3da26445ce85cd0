#include <auxfem/analysis/watch.h>

#include <algorithm>

namespace auxfem
{
  Watches::Watches(const Scene &scene, const Equations &equations, Work &work)
  {
    const bool has_inertia = equations.model().simulated.inertia;
    watches.push_back(make_energy_watch(has_inertia));
    // What is linear is as stable as at the start, where mechanisms are
    // refused.
    if (!equations.is_linear())
      watches.push_back(make_stability_watch(scene, equations, work));
    if (has_inertia)
      watches.push_back(make_step_watch(scene, equations));
    // Nor does what is in proportion to the loads show by its size.
    if (!equations.reporting().struts.empty() && !equations.is_linear())
      {
        watches.push_back(make_strain_watch(equations));
        if (!scene.lattice.struts_may_cross)
          watches.push_back(make_crossing_watch(scene, equations));
      }
  }

  void Watches::start(const State &state)
  {
    for (const auto &watch : watches)
      watch->start(state);
  }

  void Watches::step(const Evaluation        &step,
                     const EvaluationResults &results,
                     TangentSolver           &solver)
  {
    for (const auto &watch : watches)
      watch->step(step, results, solver);
  }

  std::vector<Finding> Watches::findings() const
  {
    std::vector<Finding> all;
    for (const auto &watch : watches)
      for (const Finding &finding : watch->findings())
        all.push_back(finding);
    std::stable_sort(all.begin(),
                     all.end(),
                     [](const Finding &one, const Finding &other) {
                       return one.verdict > other.verdict;
                     });
    return all;
  }

  void Watches::save(Records &records) const
  {
    for (const auto &watch : watches)
      watch->save(records);
  }

  void Watches::resume(const Records &records)
  {
    for (const auto &watch : watches)
      watch->resume(records);
  }
} // namespace auxfem
