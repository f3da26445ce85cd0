#include <auxfem/model/effect_definition.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** What shear and bending add to the compliance of struts. */
    struct Compliances
    {
      double shear   = 0; ///< L / kGA (m/N)
      double bending = 0; ///< L^3 / 12 EI (m/N)
    };

    /** Of @p length, across the strut where shear adds most to it. */
    Compliances compliances(const Section     &section,
                            const double       length,
                            const unsigned int dimension)
    {
      const auto across = [length](const double shear, const double bending) {
        return Compliances{length / shear,
                           length * length * length / (12 * bending)};
      };
      const Compliances in_plane =
        across(section.shear_stiffness_2(), section.bending_stiffness_3());
      if (dimension == 2)
        return in_plane;
      const Compliances other =
        across(section.shear_stiffness_3(), section.bending_stiffness_2());
      return other.shear * in_plane.bending > in_plane.shear * other.bending
        ? other
        : in_plane;
    }

    /** The largest part of shear in the compliance of the struts of a section.
     */
    std::optional<EffectMeasure> measure_shear(const RunPlan &plan,
                                               const Lattice &lattice)
    {
      std::vector<Compliances> of_sections(plan.scene.sections.size());
      for (const Strut &strut : lattice.struts)
        if (!strut.is_rigid())
          {
            const Compliances added =
              compliances(plan.scene.sections[strut.section].section,
                          lattice.length(strut),
                          lattice.dimension);
            of_sections[strut.section].shear += added.shear;
            of_sections[strut.section].bending += added.bending;
          }
      double largest = 0;
      for (const Compliances &sum : of_sections)
        if (sum.bending > 0)
          largest = std::max(largest, sum.shear / sum.bending);
      return EffectMeasure{std::min(1., largest), "the bending compliance"};
    }
  } // namespace

  EffectDefinition shear_flexibility_effect()
  {
    return {"shear flexibility",
            &EffectSwitches::shear_flexibility,
            &SimulatedEffects::shear_flexibility,
            [](const RunPlan &plan) -> EffectCause {
              return {!plan.scene.sections.empty(), "no elastic struts"};
            },
            measure_shear};
  }
} // namespace auxfem
