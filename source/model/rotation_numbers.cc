#include <auxfem/model/rotation_numbers.h>

namespace auxfem
{
  std::vector<unsigned int> rotation_numbers(const Lattice      &lattice,
                                             const DofNumbering &numbering)
  {
    const unsigned int n_parts  = lattice.rigid_parts.size(),
                       n_joints = lattice.joints.size(),
                       n_ends   = 2 * lattice.struts.size();
    std::vector<unsigned int> numbers(numbering.rotations().size());
    if (numbers.empty())
      return numbers;
    const auto name = [&](const int spin, const unsigned int number) {
      if (spin >= 0)
        numbers[numbering.rotations().with(spin)] = number;
    };

    // What comes later has a better claim to the name.
    const std::vector<std::size_t> &first_node = numbering.global().first_nodes;
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      {
        const StrutInterval &interval = numbering.elements()[e].interval;
        const unsigned int   order    = numbering.elements()[e].order;
        const int           *unknowns = numbering.element_unknowns(e);
        for (unsigned int node = 0; node <= order; ++node)
          name(unknowns[numbering.n_components() * node + first_rotation],
               n_parts + n_joints + n_ends + first_node[interval.strut] +
                 order * interval.number() + place_along(node, order));
      }
    for (unsigned int strut = 0; strut < lattice.struts.size(); ++strut)
      for (const unsigned int end : {0u, 1u})
        name(numbering.end_rotation(strut, end, first_rotation),
             n_parts + n_joints + 2 * strut + end);
    for (unsigned int joint = 0; joint < n_joints; ++joint)
      name(numbering.joint_unknown(joint, first_rotation), n_parts + joint);
    for (const unsigned int part : numbering.constraints().rigid_parts())
      name(numbering.constraints().motion(part, first_rotation), part);
    return numbers;
  }
} // namespace auxfem
