#include <auxfem/model/rotation_numbers.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** By strut, if the nodes of all are numbered one after the other; @p of_any
     * is any element, as all struts have equally many. */
    std::vector<unsigned int>
    first_nodes(const std::vector<unsigned int> &orders,
                const StrutMesh::Interval       &of_any)
    {
      const unsigned int n_elements =
        std::lround(1 / (of_any.end - of_any.begin));
      std::vector<unsigned int> first(1, 0);
      for (const unsigned int order : orders)
        first.push_back(first.back() + order * n_elements + 1);
      return first;
    }
  } // namespace

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
    std::vector<unsigned int> first_node;
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      {
        const StrutMesh::Interval &interval = numbering.elements()[e].interval;
        const unsigned int         order    = numbering.elements()[e].order;
        if (first_node.empty())
          first_node = first_nodes(numbering.orders(), interval);
        const int *unknowns = numbering.element_unknowns(e);
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
