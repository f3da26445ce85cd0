#include <auxfem/analysis/watch.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    bool has_yield_strain(const Scene &scene)
    {
      return std::any_of(scene.sections.begin(),
                         scene.sections.end(),
                         [](const SectionDefinition &definition) {
                           return definition.section.yield_strain.has_value();
                         });
    }

    bool has_friction(const Scene &scene, const Equations &equations)
    {
      return equations.model().simulated.contact && scene.contact.friction > 0;
    }
    bool is_free_in_space(const Scene &scene, const Equations &equations)
    {
      const LatticeModel &model = equations.model();
      return model.lattice.dimension == 3 && model.simulated.large_rotation &&
        model.supports.empty() && model.lattice.rigid_parts.empty() &&
        scene.plates.empty();
    }
  } // namespace

  std::string shorter_step_text(const double          scene_step,
                                const ImplicitScheme &scheme,
                                const double          missed)
  {
    std::ostringstream text;
    text.precision(2);
    text << " (Time/Time step = " << scene_step << " s). A step of "
         << scene_step * std::pow(0.01 / missed, 1. / scheme.order())
         << " s would miss 1 %.";
    return text.str();
  }

  Watches::Watches(const Scene &scene, const Equations &equations, Work &work)
  {
    const SimulatedEffects &simulated   = equations.model().simulated;
    const bool              has_inertia = simulated.inertia;
    const bool              has_struts  = !equations.reporting().struts.empty();
    watches.push_back(make_energy_watch(scene, equations));
    // What is linear is as stable as at the start, where mechanisms are
    // refused.
    // A path counts what is unstable itself.
    if (!equations.is_linear() && scene.analysis != Analysis::static_path)
      watches.push_back(make_stability_watch(scene, equations, work));
    if (!simulated.large_rotation && !simulated.small_displacements_are_limited)
      watches.push_back(make_small_displacement_watch(scene, equations, work));
    if (has_inertia)
      {
        watches.push_back(make_step_watch(scene, equations));
        watches.push_back(make_load_step_watch(scene));
      }
    if (has_inertia && scene.time.relative_tolerance &&
        is_free_in_space(scene, equations))
      watches.push_back(make_spin_watch(scene, equations));
    // Time of elastic statics is but a parameter.
    if (!has_inertia &&
        (simulated.connector_viscosity || simulated.strut_damping ||
         has_friction(scene, equations)))
      watches.push_back(make_load_speed_watch(scene, equations));
    if (!equations.is_linear() && !equations.reporting().connectors.empty())
      watches.push_back(make_connector_watch(equations));
    if (equations.reporting().plates != nullptr ||
        equations.reporting().strut_contact != nullptr)
      {
        watches.push_back(make_contact_watch(equations));
        if (has_inertia)
          watches.push_back(make_impact_watch(scene, equations));
      }
    if (!scene.plates.empty() && equations.reporting().plates == nullptr)
      watches.push_back(make_plate_crossing_watch(scene, equations));
    if (simulated.shear_flexibility)
      for (const StrutGroup &group : equations.reporting().struts)
        if (group.forces->elements().order == 1)
          watches.push_back(make_bending_watch(group, scene, equations));
    if (has_struts && has_inertia)
      watches.push_back(make_wave_watch(scene, equations));
    if (has_struts && has_yield_strain(scene))
      watches.push_back(make_yield_watch(equations));
    // Nor does what is in proportion to the loads show by its size.
    if (has_struts &&
        (!equations.is_linear() || simulated.small_displacements_are_limited))
      watches.push_back(make_strain_watch(equations));
    if (has_struts && !equations.is_linear())
      watches.push_back(make_local_buckling_watch(scene, equations));
    // Small displacements that are limited end where struts touch.
    if (has_struts && !scene.lattice.struts_may_cross &&
        equations.reporting().strut_contact == nullptr &&
        (!simulated.small_displacements_are_limited ||
         scene.effects.contact == Switch::off))
      watches.push_back(make_crossing_watch(scene, equations));
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

  bool Watches::changes_stability(const Evaluation &step, TangentSolver &solver)
  {
    bool one_does = false;
    for (const auto &watch : watches)
      one_does = watch->changes_stability(step, solver) || one_does;
    return one_does;
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

  std::optional<double> Watches::largest_penetration() const
  {
    for (const auto &watch : watches)
      if (const auto largest = watch->largest_penetration())
        return largest;
    return std::nullopt;
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
