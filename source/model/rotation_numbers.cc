#include <auxfem/model/rotation_numbers.h>

#include <cmath>

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
    const unsigned int order = numbering.order();
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      {
        const StrutMesh::Interval &interval = numbering.elements()[e].interval;
        // All struts have equally many elements.
        const double       length  = interval.end - interval.begin;
        const unsigned int n_nodes = order * std::lround(1 / length),
                           before =
                             order * std::lround(interval.begin / length);
        const int *unknowns = numbering.element_unknowns(e);
        for (unsigned int node = 0; node <= order; ++node)
          {
            // Both ends come first.
            const unsigned int inside =
              node == 0 ? 0 : (node == 1 ? order : node - 1);
            name(unknowns[numbering.n_components() * node + first_rotation],
                 n_parts + n_joints + n_ends + interval.strut * (n_nodes + 1) +
                   before + inside);
          }
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
