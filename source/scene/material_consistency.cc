#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene.h>

#include <string>

namespace auxfem
{
  bool is_static(const Scene &scene)
  {
    return !scene.time.scheme->is_dynamic() ||
      scene.analysis == Analysis::static_path ||
      scene.analysis == Analysis::buckling ||
      scene.analysis == Analysis::effective_properties ||
      scene.analysis == Analysis::effective_response;
  }

  namespace
  {
    std::string problem(const Scene &scene, const std::string &text)
    {
      return scene.file + ": " + text;
    }

    /** Refuses materials that flow under loads which last forever. */
    void check_long_time_stiffness(const Scene &scene, Mistakes &mistakes)
    {
      const bool is_relaxed = is_static(scene) ||
        is_linearized(scene.analysis) || scene.time.static_start ||
        scene.effects.strut_relaxation == Switch::off;
      if (!is_relaxed)
        return;
      for (const SectionDefinition &definition : scene.sections)
        if (const auto &law = definition.section.law;
            law && !(law->long_time_ratio(StrainType::shear) > 0))
          mistakes.add(
            problem(scene,
                    definition.material_path +
                      "/Relaxing parts add up to 1: the material flows "
                      "under loads that last, and here " +
                      (scene.effects.strut_relaxation == Switch::off
                         ? "Effects/Strut relaxation is off"
                         : "there are static states") +
                      ". Reduce the parts to less than 1 together, or "
                      "simulate the motion from rest with inertia"));
    }

    /** Refuses what does not work with struts that yield. */
    void check_plasticity(const Scene &scene, Mistakes &mistakes)
    {
      if (!yields(scene.sections) || scene.effects.plasticity == Switch::off)
        return;
      const auto refuse = [&](const std::string &what, const std::string &why) {
        mistakes.add(problem(scene,
                             what +
                               " with materials that yield (Law = "
                               "elastic-plastic): " +
                               why + ", or set Effects/Plasticity = off"));
      };
      const auto *scheme =
        dynamic_cast<const ImplicitScheme *>(scene.time.scheme.get());
      if (scheme != nullptr && scheme->stages() != nullptr)
        refuse("Time/Scheme = " + scheme->name(),
               "its stages would yield by themselves. Choose newmark, "
               "generalized-alpha or energy-momentum");
      if (scene.analysis == Analysis::static_path ||
          scene.analysis == Analysis::buckling)
        refuse("Analysis = " + name_of(scene.analysis),
               "it assumes forces that depend on the configuration alone. "
               "Prescribe a motion in load steps with Analysis = simulation "
               "and Scheme = static");
      if (scene.discretization.tolerance && !is_linearized(scene.analysis))
        refuse("Discretization/Order = auto",
               "its error estimate is one of elastic struts. Set Order = 4 and "
               "Global refinements = 1");
      if (scene.effects.shear_flexibility == Switch::off)
        refuse("Effects/Shear flexibility = off",
               "elements without shear correct bending by the elastic "
               "stiffness. Set it to on");
    }
    /** Refuses struts that break in motion if their nodes could not move
     * without stiffness. */
    void check_failure(const Scene &scene, Mistakes &mistakes)
    {
      if (is_static(scene) || scene.effects.plasticity == Switch::off ||
          scene.effects.rotary_inertia != Switch::off)
        return;
      for (const SectionDefinition &definition : scene.sections)
        if (const Section &section = definition.section;
            section.law && section.law->failure_time() && section.density > 0)
          mistakes.add(problem(
            scene,
            definition.material_path +
              "/Failure time: with Effects/Rotary inertia = off nothing "
              "would hold the rotations of struts with mass that have "
              "broken. Set it to on"));
    }
  } // namespace

  void check_materials(const Scene &scene, Mistakes &mistakes)
  {
    check_long_time_stiffness(scene, mistakes);
    check_plasticity(scene, mistakes);
    check_failure(scene, mistakes);
  }
} // namespace auxfem
