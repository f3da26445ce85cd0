#include <auxfem/mesh/strut_mesh.h>
#include <auxfem/model/numbering.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

namespace auxfem
{
  SpatialRotations::SpatialRotations(const unsigned int n_local_unknowns)
    : of_unknown(n_local_unknowns, -1)
  {}

  void SpatialRotations::add(const std::array<int, 3> &spins)
  {
    if (spins[0] < 0 || of_unknown[spins[0]] >= 0)
      return;
    for (const int spin : spins)
      of_unknown[spin] = rotations.size();
    rotations.push_back(spins);
  }

  unsigned int SpatialRotations::axis(const unsigned int unknown) const
  {
    const std::array<int, 3> &spins = rotations[of_unknown[unknown]];
    return std::find(spins.begin(), spins.end(), static_cast<int>(unknown)) -
      spins.begin();
  }

  namespace
  {
    std::vector<unsigned int> components_of_nodes(const unsigned int dimension)
    {
      if (dimension == 2)
        return {0, 1, rotation_z};
      return {0, 1, 2, 3, 4, 5};
    }
  } // namespace

  DofNumbering::DofNumbering(const Lattice        &lattice,
                             const StrutPartition &partition,
                             const Ties           &ties,
                             const MPI_Comm        communicator)
    : of_lattice(lattice)
    , of_struts(partition.divisions)
    , node_components(components_of_nodes(lattice.dimension))
    , numbers(lattice,
              partition,
              node_components,
              ties,
              dealii::Utilities::MPI::n_mpi_processes(communicator))
    , kept(find_kept(partition,
                     ties,
                     dealii::Utilities::MPI::this_mpi_process(communicator)))
    , of_unknowns(UnknownLayout(communicator, kept.n_owned, kept.ghosts))
    , of_constraints(numbers, layout(), kept.rigid_parts)
    , in_space(layout().n_local())
  {
    take_elements();
    mark_unknowns();
    mark_constraints();
    mark_prescribed(ties.prescribed);
    if (of_lattice.dimension == 3)
      find_rotations();
  }

  std::vector<unsigned int>
  DofNumbering::find_struts(const StrutPartition &partition,
                            const unsigned int    rank) const
  {
    const auto has_mine = [&](const GlobalNumbers::OfMotion &of_motion) {
      return std::any_of(of_motion.begin(), of_motion.end(), [&](const int g) {
        return numbers.owns(rank, g);
      });
    };
    std::vector<unsigned int> struts;
    for (unsigned int s = 0; s < of_lattice.struts.size(); ++s)
      if (const Strut &strut = of_lattice.struts[s]; !strut.is_rigid() &&
          (partition.ranks[s] == rank ||
           has_mine(numbers.joints[strut.joints[0]]) ||
           has_mine(numbers.joints[strut.joints[1]]) ||
           has_mine(numbers.end_rotation(of_lattice, s, 0)) ||
           has_mine(numbers.end_rotation(of_lattice, s, 1))))
        struts.push_back(s);
    return struts;
  }

  DofNumbering::Kept DofNumbering::find_kept(const StrutPartition &partition,
                                             const Ties           &ties,
                                             const unsigned int    rank)
  {
    const auto is_mine = [&](const int g) { return numbers.owns(rank, g); };
    Kept       result;
    result.n_owned = numbers.first_owned[rank + 1] - numbers.first_owned[rank];

    std::vector<bool> is_known(numbers.first_owned.back(), false);
    const auto        keep = [&](const int g) {
      if (g >= 0 && !is_mine(g) && !is_known[g])
        {
          is_known[g] = true;
          result.ghosts.push_back(g);
        }
    };
    const StrutMesh  mesh(of_struts, find_struts(partition, rank));
    std::vector<int> of_element;
    for (const StrutInterval &interval : mesh.intervals())
      {
        const unsigned int order = of_struts[interval.strut].order;
        of_element.clear();
        numbers.add_element(of_lattice, interval, order, of_element);
        if (std::none_of(of_element.begin(), of_element.end(), is_mine))
          continue;
        std::for_each(of_element.begin(), of_element.end(), keep);
        result.elements.push_back(result.numbers.size());
        result.numbers.insert(result.numbers.end(),
                              of_element.begin(),
                              of_element.end());
        // The rank of the last node owns an unknown of the element, so it
        // keeps the element; the rank of the strut may not.
        element_list.push_back({interval, order, is_mine(of_element.back())});
      }
    sort_elements(result);
    for (const JointPair &pair : ties.connected)
      for (const unsigned int mine : {pair.first, pair.second})
        if (mine != invalid_index && is_mine(numbers.joints[mine][0]))
          for (const unsigned int other : {pair.first, pair.second})
            if (other != invalid_index)
              for (unsigned int component = 0; component < of_lattice.dimension;
                   ++component)
                keep(numbers.joints[other][component]);
    for (const std::vector<int> &of_tie : numbers.coupled(ties))
      if (std::any_of(of_tie.begin(), of_tie.end(), is_mine))
        std::for_each(of_tie.begin(), of_tie.end(), keep);
    for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
      {
        const std::vector<int> of_part = numbers.of_rigid_part(of_lattice, p);
        if (std::none_of(of_part.begin(), of_part.end(), is_mine))
          continue;
        std::for_each(of_part.begin(), of_part.end(), keep);
        result.rigid_parts.push_back(p);
      }
    return result;
  }

  void DofNumbering::sort_elements(Kept &kept)
  {
    std::set<unsigned int> used;
    for (unsigned int strut = 0; strut < of_struts.size(); ++strut)
      if (!of_lattice.struts[strut].is_rigid())
        used.insert(of_struts[strut].order);
    std::vector<Element>     sorted;
    std::vector<std::size_t> sorted_numbers;
    for (const unsigned int order : used)
      {
        const unsigned int begin = sorted.size();
        for (std::size_t e = 0; e < element_list.size(); ++e)
          if (element_list[e].order == order)
            {
              sorted.push_back(element_list[e]);
              sorted_numbers.push_back(kept.elements[e]);
            }
        element_groups.push_back(
          {order, begin, static_cast<unsigned int>(sorted.size())});
      }
    element_list.swap(sorted);
    kept.elements.swap(sorted_numbers);
  }

  void DofNumbering::take_elements()
  {
    first_number.assign(1, 0);
    for (std::size_t e = 0; e < element_list.size(); ++e)
      {
        const unsigned int n = (element_list[e].order + 1) * n_components();
        for (unsigned int i = 0; i < n; ++i)
          element_numbers.push_back(
            layout().local(kept.numbers[kept.elements[e] + i]));
        first_number.push_back(element_numbers.size());
      }
    kept = Kept();
  }

  void DofNumbering::mark(const int          unknown,
                          const unsigned int node,
                          const unsigned int component)
  {
    if (unknown < 0)
      return;
    of_unknowns.joint[unknown]     = node;
    of_unknowns.component[unknown] = component;
    if (component < first_rotation)
      return;
    of_unknowns.kinds[unknown]       = UnknownKind::rotation;
    of_unknowns.is_rotation[unknown] = true;
  }

  void DofNumbering::mark_unknowns()
  {
    std::vector<dealii::Point<3>> positions = of_lattice.joints;
    of_unknowns.components                  = node_components;
    const auto mark_all = [this](const GlobalNumbers::OfMotion &of_motion,
                                 const unsigned int             node) {
      for (unsigned int c = 0; c < n_motion_components; ++c)
        if (of_motion[c] >= 0)
          mark(layout().local(of_motion[c]), node, c);
    };
    for (std::size_t e = 0; e < element_list.size(); ++e)
      for (unsigned int node = 0; node <= element_list[e].order; ++node)
        if (!element_list[e].interval.is_joint(node))
          for (unsigned int c = 0; c < n_components(); ++c)
            {
              const int unknown =
                element_unknowns(e)[node * n_components() + c];
              mark(unknown, 0, node_components[c]);
              of_unknowns.strut[unknown] = element_list[e].interval.strut;
            }
    for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
      {
        const RigidPart &part = of_lattice.rigid_parts[p];
        dealii::Point<3> middle;
        for (const unsigned int joint : part.joints)
          middle += of_lattice.joints[joint] / double(part.joints.size());
        mark_all(numbers.rigid_parts[p].motion, positions.size());
        positions.push_back(middle);
      }
    for (unsigned int joint = 0; joint < numbers.joints.size(); ++joint)
      mark_all(numbers.joints[joint], joint);
    for (const auto &[end, of_motion] : numbers.released_ends)
      mark_all(of_motion, of_lattice.struts[end.first].joints[end.second]);
    of_unknowns.positions =
      std::make_shared<const std::vector<dealii::Point<3>>>(
        std::move(positions));
  }

  void DofNumbering::mark_constraints()
  {
    const auto mark_multiplier = [this](const int global, const int joint) {
      const int unknown = layout().local(global);
      if (unknown < 0)
        return;
      of_unknowns.kinds[unknown] = UnknownKind::multiplier;
      of_unknowns.joint[unknown] = joint;
    };
    for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
      for (unsigned int i = 0; i < numbers.rigid_parts[p].multipliers.size();
           ++i)
        mark_multiplier(numbers.rigid_parts[p].multipliers[i],
                        numbers.constrained_joint(of_lattice, p, i));
    for (const GlobalNumbers::OfHinge &hinge : numbers.hinges)
      for (const int global : hinge.multipliers)
        mark_multiplier(global, hinge.joint);
  }

  void DofNumbering::mark_prescribed(const std::vector<JointMotion> &motions)
  {
    for (const JointMotion &motion : motions)
      if (const int unknown = joint_unknown(motion.joint, motion.component);
          unknown >= 0)
        of_unknowns.kinds[unknown] = UnknownKind::prescribed;
  }

  void DofNumbering::find_rotations()
  {
    const auto add_global = [this](const GlobalNumbers::OfMotion &of_motion) {
      if (of_motion[first_rotation] >= 0)
        in_space.add({{layout().local(of_motion[3]),
                       layout().local(of_motion[4]),
                       layout().local(of_motion[5])}});
    };
    for (std::size_t i = 0; i < element_numbers.size(); i += n_components())
      in_space.add({{element_numbers[i + 3],
                     element_numbers[i + 4],
                     element_numbers[i + 5]}});
    for (const GlobalNumbers::OfMotion &joint : numbers.joints)
      add_global(joint);
    for (const auto &end : numbers.released_ends)
      add_global(end.second);
    for (const GlobalNumbers::OfRigidPart &part : numbers.rigid_parts)
      add_global(part.motion);
  }

  int DofNumbering::end_rotation(const unsigned int strut,
                                 const unsigned int end,
                                 const unsigned int component) const
  {
    if (of_lattice.struts[strut].is_rigid())
      return -1;
    return layout().local(
      numbers.end_rotation(of_lattice, strut, end)[component]);
  }

  int DofNumbering::rotation_unknown(const RotationOwner &rotation_owner,
                                     const unsigned int   component) const
  {
    return layout().local(numbers.rotation(rotation_owner)[component]);
  }

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
