#ifndef auxfem_struts_effects_make_struts_h
#define auxfem_struts_effects_make_struts_h

#include <auxfem/struts/effects/breaking_forces.h>

#include <type_traits>

namespace auxfem
{
  /** The variant of @p Beam <order, large_rotation, damped> that @p model asks for. */
  template <template <int, bool, bool> class Beam, int order>
  std::unique_ptr<StrutForces>
  make_struts_of_order(const Lattice              &lattice,
                       const DofNumbering         &numbering,
                       const DofNumbering::Group  &group,
                       const std::vector<Section> &sections,
                       const StrutModel           &model)
  {
    const auto make = [&](auto large_rotation,
                          auto damped) -> std::unique_ptr<StrutForces> {
      return std::make_unique<BeamForces<Beam<order, large_rotation, damped>>>(
        lattice,
        numbering,
        group,
        sections,
        model);
    };
    const auto make_with_law =
      [&](auto large_rotation) -> std::unique_ptr<StrutForces> {
      using Undamped = Beam<order, large_rotation, false>;
      if (model.law->failure_time())
        return std::make_unique<BreakingForces<Undamped>>(lattice,
                                                          numbering,
                                                          group,
                                                          sections,
                                                          model);
      return std::make_unique<LawForces<Undamped>>(lattice,
                                                   numbering,
                                                   group,
                                                   sections,
                                                   model);
    };
    const std::true_type  yes;
    const std::false_type no;
    if (model.law)
      return model.large_rotation ? make_with_law(yes) : make_with_law(no);
    if (model.large_rotation)
      return model.damping ? make(yes, yes) : make(yes, no);
    return model.damping ? make(no, yes) : make(no, no);
  }
} // namespace auxfem

#endif
