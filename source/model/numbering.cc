#include <auxfem/mesh/strut_mesh.h>
#include <auxfem/model/numbering.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

namespace auxfem
{
  SpatialRotations::SpatialRotations(const unsigned int n_local_unknowns)
    : rotation_index(n_local_unknowns, -1)
  {}

  void SpatialRotations::add(const std::array<int, 3> &spins)
  {
    if (spins[0] < 0 || rotation_index[spins[0]] >= 0)
      return;
    for (const int spin : spins)
      rotation_index[spin] = rotations.size();
    rotations.push_back(spins);
  }

  unsigned int SpatialRotations::axis(const unsigned int unknown) const
  {
    const std::array<int, 3> &spins = rotations[rotation_index[unknown]];
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

    std::vector<unsigned int>
    first_elements(const std::vector<StrutDivision> &divisions)
    {
      std::vector<unsigned int> first;
      unsigned int              n_elements = 0;
      for (const StrutDivision &division : divisions)
        {
          first.push_back(n_elements);
          n_elements += division.n_elements;
        }
      return first;
    }
  } // namespace

  DofNumbering::DofNumbering(const Lattice                   &lattice,
                             const StrutPartition            &partition,
                             const Ties                      &ties,
                             const MPI_Comm                   communicator,
                             const std::vector<unsigned int> &laws)
    : base_lattice(lattice)
    , strut_divisions(partition.divisions)
    , first_element_of_strut(first_elements(strut_divisions))
    , node_components(components_of_nodes(lattice.dimension))
    , numbers(lattice,
              partition,
              node_components,
              ties,
              dealii::Utilities::MPI::n_mpi_processes(communicator))
    , local_subset(find_local_subset(partition,
                                     ties,
                                     dealii::Utilities::MPI::this_mpi_process(
                                       communicator),
                                     laws))
    , unknown_data(
        UnknownLayout(communicator, local_subset.n_owned, local_subset.ghosts))
    , constraint_unknowns(numbers, layout(), local_subset.rigid_parts)
    , spatial_rotations(layout().n_local())
  {
    localize_elements();
    mark_unknowns();
    mark_constraints();
    mark_prescribed(ties.prescribed);
    if (base_lattice.dimension == 3)
      find_rotations();
  }

  std::vector<unsigned int>
  DofNumbering::find_struts(const StrutPartition &partition,
                            const unsigned int    rank) const
  {
    const auto has_mine = [&](const GlobalNumbers::MotionNumbers &motion) {
      return std::any_of(motion.begin(), motion.end(), [&](const int g) {
        return numbers.owns(rank, g);
      });
    };
    std::vector<unsigned int> struts;
    for (unsigned int s = 0; s < base_lattice.struts.size(); ++s)
      if (const Strut &strut = base_lattice.struts[s]; !strut.is_rigid() &&
          (partition.ranks[s] == rank ||
           has_mine(numbers.joints[strut.joints[0]]) ||
           has_mine(numbers.joints[strut.joints[1]]) ||
           has_mine(numbers.end_rotation(base_lattice, s, 0)) ||
           has_mine(numbers.end_rotation(base_lattice, s, 1))))
        struts.push_back(s);
    return struts;
  }

  DofNumbering::LocalSubset
  DofNumbering::find_local_subset(const StrutPartition            &partition,
                                  const Ties                      &ties,
                                  const unsigned int               rank,
                                  const std::vector<unsigned int> &laws)
  {
    const auto  is_mine = [&](const int g) { return numbers.owns(rank, g); };
    LocalSubset result;
    result.n_owned = numbers.first_owned[rank + 1] - numbers.first_owned[rank];

    std::vector<bool> is_known(numbers.first_owned.back(), false);
    const auto        keep = [&](const int g) {
      if (g >= 0 && !is_mine(g) && !is_known[g])
        {
          is_known[g] = true;
          result.ghosts.push_back(g);
        }
    };
    const StrutMesh  mesh(strut_divisions, find_struts(partition, rank));
    std::vector<int> globals;
    for (const StrutInterval &interval : mesh.intervals())
      {
        const unsigned int order = strut_divisions[interval.strut].order;
        globals.clear();
        numbers.add_element(base_lattice, interval, order, globals);
        if (std::none_of(globals.begin(), globals.end(), is_mine))
          continue;
        std::for_each(globals.begin(), globals.end(), keep);
        result.elements.push_back(result.numbers.size());
        result.numbers.insert(result.numbers.end(),
                              globals.begin(),
                              globals.end());
        // The owner of the last node stores the element, whereas the rank of
        // the strut may not.
        element_list.push_back({interval, order, is_mine(globals.back())});
      }
    sort_elements(result, laws);
    for (const JointPair &pair : ties.connected)
      for (const unsigned int mine : {pair.first, pair.second})
        if (mine != invalid_index && is_mine(numbers.joints[mine][0]))
          for (const unsigned int other : {pair.first, pair.second})
            if (other != invalid_index)
              for (unsigned int component = 0;
                   component < base_lattice.dimension;
                   ++component)
                keep(numbers.joints[other][component]);
    for (const std::vector<int> &coupled_unknowns : numbers.coupled(ties))
      if (std::any_of(coupled_unknowns.begin(),
                      coupled_unknowns.end(),
                      is_mine))
        std::for_each(coupled_unknowns.begin(), coupled_unknowns.end(), keep);
    for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
      {
        const std::vector<int> part_unknowns =
          numbers.rigid_part_unknowns(base_lattice, p);
        if (std::none_of(part_unknowns.begin(), part_unknowns.end(), is_mine))
          continue;
        std::for_each(part_unknowns.begin(), part_unknowns.end(), keep);
        result.rigid_parts.push_back(p);
      }
    return result;
  }

  void DofNumbering::sort_elements(LocalSubset                     &subset,
                                   const std::vector<unsigned int> &laws)
  {
    using OrderAndLaw = std::pair<unsigned int, unsigned int>;
    const auto key_of = [&](const unsigned int strut) {
      return OrderAndLaw(strut_divisions[strut].order,
                         laws.empty()
                           ? 0
                           : laws[base_lattice.struts[strut].section]);
    };
    std::set<OrderAndLaw> used;
    for (unsigned int strut = 0; strut < strut_divisions.size(); ++strut)
      if (!base_lattice.struts[strut].is_rigid())
        used.insert(key_of(strut));
    std::vector<Element>     sorted;
    std::vector<std::size_t> sorted_numbers;
    for (const OrderAndLaw &key : used)
      {
        const unsigned int begin = sorted.size();
        for (std::size_t e = 0; e < element_list.size(); ++e)
          if (key_of(element_list[e].interval.strut) == key)
            {
              sorted.push_back(element_list[e]);
              sorted_numbers.push_back(subset.elements[e]);
            }
        element_groups.push_back({key.first,
                                  begin,
                                  static_cast<unsigned int>(sorted.size()),
                                  key.second});
      }
    element_list.swap(sorted);
    subset.elements.swap(sorted_numbers);
  }

  void DofNumbering::localize_elements()
  {
    first_number.assign(1, 0);
    for (std::size_t e = 0; e < element_list.size(); ++e)
      {
        const unsigned int n = (element_list[e].order + 1) * n_components();
        for (unsigned int i = 0; i < n; ++i)
          element_numbers.push_back(
            layout().local(local_subset.numbers[local_subset.elements[e] + i]));
        first_number.push_back(element_numbers.size());
      }
    local_subset = LocalSubset();
  }

  void DofNumbering::mark(const int          unknown,
                          const unsigned int node,
                          const unsigned int component)
  {
    if (unknown < 0)
      return;
    unknown_data.joint[unknown]     = node;
    unknown_data.component[unknown] = component;
    if (component < first_rotation)
      return;
    unknown_data.kinds[unknown]       = UnknownKind::rotation;
    unknown_data.is_rotation[unknown] = true;
  }

  void DofNumbering::mark_unknowns()
  {
    std::vector<dealii::Point<3>> positions = base_lattice.joints;
    unknown_data.components                 = node_components;
    const auto mark_all = [this](const GlobalNumbers::MotionNumbers &motion,
                                 const unsigned int                  node) {
      for (unsigned int c = 0; c < n_motion_components; ++c)
        if (motion[c] >= 0)
          mark(layout().local(motion[c]), node, c);
    };
    for (std::size_t e = 0; e < element_list.size(); ++e)
      for (unsigned int node = 0; node <= element_list[e].order; ++node)
        if (!element_list[e].interval.is_joint(node))
          for (unsigned int c = 0; c < n_components(); ++c)
            {
              const int unknown =
                element_unknowns(e)[node * n_components() + c];
              mark(unknown, 0, node_components[c]);
              unknown_data.strut[unknown] = element_list[e].interval.strut;
            }
    for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
      {
        const RigidPart &part = base_lattice.rigid_parts[p];
        dealii::Point<3> middle;
        for (const unsigned int joint : part.joints)
          middle += base_lattice.joints[joint] / double(part.joints.size());
        mark_all(numbers.rigid_parts[p].motion, positions.size());
        positions.push_back(middle);
      }
    for (unsigned int joint = 0; joint < numbers.joints.size(); ++joint)
      mark_all(numbers.joints[joint], joint);
    for (const auto &[end, motion] : numbers.released_ends)
      mark_all(motion, base_lattice.struts[end.first].joints[end.second]);
    unknown_data.positions =
      std::make_shared<const std::vector<dealii::Point<3>>>(
        std::move(positions));
  }

  void DofNumbering::mark_constraints()
  {
    const auto mark_multiplier = [this](const int global, const int joint) {
      const int unknown = layout().local(global);
      if (unknown < 0)
        return;
      unknown_data.kinds[unknown] = UnknownKind::multiplier;
      unknown_data.joint[unknown] = joint;
    };
    for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
      for (unsigned int i = 0; i < numbers.rigid_parts[p].multipliers.size();
           ++i)
        mark_multiplier(numbers.rigid_parts[p].multipliers[i],
                        numbers.constrained_joint(base_lattice, p, i));
    for (const GlobalNumbers::HingeNumbers &hinge : numbers.hinges)
      for (const int global : hinge.multipliers)
        mark_multiplier(global, hinge.joint);
    for (const GlobalNumbers::RelationNumbers &relation : numbers.relations)
      mark_multiplier(relation.multiplier, relation.joint);
  }

  void DofNumbering::mark_prescribed(const std::vector<JointMotion> &motions)
  {
    for (const JointMotion &motion : motions)
      if (const int unknown = joint_unknown(motion.joint, motion.component);
          unknown >= 0)
        unknown_data.kinds[unknown] = UnknownKind::prescribed;
  }

  void DofNumbering::find_rotations()
  {
    const auto add_global = [this](const GlobalNumbers::MotionNumbers &motion) {
      if (motion[first_rotation] >= 0)
        spatial_rotations.add({{layout().local(motion[3]),
                                layout().local(motion[4]),
                                layout().local(motion[5])}});
    };
    for (std::size_t i = 0; i < element_numbers.size(); i += n_components())
      spatial_rotations.add({{element_numbers[i + 3],
                              element_numbers[i + 4],
                              element_numbers[i + 5]}});
    for (const GlobalNumbers::MotionNumbers &joint : numbers.joints)
      add_global(joint);
    for (const auto &end : numbers.released_ends)
      add_global(end.second);
    for (const GlobalNumbers::RigidPartNumbers &part : numbers.rigid_parts)
      add_global(part.motion);
  }

  int DofNumbering::end_rotation(const unsigned int strut,
                                 const unsigned int end,
                                 const unsigned int component) const
  {
    if (base_lattice.struts[strut].is_rigid())
      return -1;
    return layout().local(
      numbers.end_rotation(base_lattice, strut, end)[component]);
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

    // Later assignments override earlier ones.
    const std::vector<std::size_t> &first_node = numbering.global().first_nodes;
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      {
        const StrutInterval &interval = numbering.elements()[e].interval;
        const unsigned int   order    = numbering.elements()[e].order;
        const int           *unknowns = numbering.element_unknowns(e);
        for (unsigned int node = 0; node <= order; ++node)
          name(unknowns[numbering.n_components() * node + first_rotation],
               n_parts + n_joints + n_ends + first_node[interval.strut] +
                 order * interval.number() + position_along(node, order));
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
