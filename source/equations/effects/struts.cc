#include <auxfem/equations/effects/beam_forces.h>

namespace auxfem
{
  std::unique_ptr<StrutForces>
  StrutForces::make(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model)
  {
    return (lattice.dimension == 2
              ? make_plane_struts
              : make_space_struts)(lattice, numbering, group, sections, model);
  }
} // namespace auxfem
