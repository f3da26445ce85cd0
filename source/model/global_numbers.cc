#include <auxfem/model/global_numbers.h>
#include <auxfem/model/unknown_records.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    std::vector<std::size_t>
    find_first_nodes(const std::vector<StrutDivision> &divisions)
    {
      std::vector<std::size_t> first(1, 0);
      first.reserve(divisions.size() + 1);
      for (const StrutDivision &division : divisions)
        first.push_back(first.back() + division.n_inner_nodes() + 2);
      return first;
    }

    /** Position of a node in the numbering of inner nodes of its strut: per
     * element first the end shared with the next element, then inner nodes. */
    unsigned int place_among_inner(const StrutInterval &element,
                                   const unsigned int   order,
                                   const unsigned int   node)
    {
      const unsigned int first = element.number() * order;
      if (node == 0)
        return first - order;
      const bool is_last = element.end == 1.;
      return node == 1 ? first : first + (is_last ? 0 : 1) + node - 2;
    }
  } // namespace

  GlobalNumbers::GlobalNumbers(const Lattice                   &lattice,
                               const StrutPartition            &partition,
                               const std::vector<unsigned int> &components,
                               const Ties                      &ties,
                               const unsigned int               n_ranks)
    : first_nodes(find_first_nodes(partition.divisions))
    , first_inner(lattice.struts.size(), -1)
    , components(components)
  {
    // Each rank first counts its own numbers; the first strut at an unknown
    // decides the owner. Then the numbers are shifted to rank ranges.
    UnknownDistribution distribution(lattice, ties, n_ranks);
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      {
        if (lattice.struts[s].is_rigid())
          continue;
        const int rank = partition.ranks[s];
        for (const unsigned int end : {0, 1})
          for (const unsigned int component : components)
            distribution.assign_end(s, end, component, rank);
        first_inner[s] =
          distribution.assign_inner(partition.divisions[s].n_inner_nodes() *
                                      components.size(),
                                    rank);
      }
    distribution.assign_joints(partition.ranks);
    distribution.assign_rigid_parts();
    distribution.assign_hinges();
    distribution.assign_relations();
    assign_numbers(distribution);

    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      if (first_inner[s] >= 0)
        first_inner[s] += first_owned[partition.ranks[s]];
    for (unsigned int h = 0; h < hinges.size(); ++h)
      hinges[h].joint = ties.hinged[h].joint;
    for (unsigned int r = 0; r < relations.size(); ++r)
      {
        relations[r].path  = ties.relations[r].path;
        relations[r].joint = ties.relations[r].terms.front().motion.joint;
      }
  }

  void GlobalNumbers::assign_numbers(const UnknownDistribution &distribution)
  {
    first_owned.assign(1, 0);
    for (const int n_owned_by_rank : distribution.counts())
      first_owned.push_back(first_owned.back() + n_owned_by_rank);
    const auto global = [this](const UnknownDistribution::Unknown &unknown) {
      return unknown.owner < 0 ? -1
                               : first_owned[unknown.owner] + unknown.number;
    };
    const auto all_global = [&](const UnknownDistribution::Motion &unknowns) {
      MotionNumbers numbers;
      std::transform(unknowns.begin(), unknowns.end(), numbers.begin(), global);
      return numbers;
    };
    joints.reserve(distribution.n_joints());
    for (unsigned int joint = 0; joint < distribution.n_joints(); ++joint)
      joints.push_back(all_global(distribution.joint(joint)));
    for (const auto &[end, rotation] : distribution.released_ends())
      released_ends[end] = all_global(rotation);
    for (const UnknownDistribution::RigidPartUnknowns &part :
         distribution.rigid_parts())
      {
        rigid_parts.push_back(
          {part.clamped_joints, all_global(part.motion), {}});
        for (const UnknownDistribution::Unknown &multiplier : part.multipliers)
          rigid_parts.back().multipliers.push_back(global(multiplier));
      }
    for (const auto &hinge : distribution.hinges())
      hinges.push_back({invalid_index, {{global(hinge[0]), global(hinge[1])}}});
    for (const UnknownDistribution::Unknown &relation :
         distribution.relations())
      relations.push_back({"", invalid_index, global(relation)});
  }

  std::vector<int>
  GlobalNumbers::rigid_part_unknowns(const Lattice     &lattice,
                                     const unsigned int rigid_part) const
  {
    const RigidPartNumbers &part   = rigid_parts[rigid_part];
    std::vector<int>        result = part.multipliers;
    result.insert(result.end(), part.motion.begin(), part.motion.end());
    for (const unsigned int joint : lattice.rigid_parts[rigid_part].joints)
      for (unsigned int component = 0; component < lattice.dimension;
           ++component)
        result.push_back(joints[joint][component]);
    for (const unsigned int joint : part.clamped_joints)
      result.push_back(joints[joint][rotation_z]);
    return result;
  }

  unsigned int GlobalNumbers::constrained_joint(const Lattice     &lattice,
                                                const unsigned int rigid_part,
                                                const unsigned int number) const
  {
    const RigidPart   &part = lattice.rigid_parts[rigid_part];
    const unsigned int d    = lattice.dimension;
    if (part.has_rotation)
      return part.joints[number / d];
    if (number == 0)
      return part.joints[1];
    const unsigned int joint = 2 + (number - 1) / d;
    return joint < part.joints.size()
      ? part.joints[joint]
      : rigid_parts[rigid_part]
          .clamped_joints[number - 1 - d * (part.joints.size() - 2)];
  }

  const GlobalNumbers::MotionNumbers &
  GlobalNumbers::end_rotation(const Lattice     &lattice,
                              const unsigned int strut,
                              const unsigned int end) const
  {
    const auto released = released_ends.find({strut, end});
    return released == released_ends.end()
      ? joints[lattice.struts[strut].joints[end]]
      : released->second;
  }

  void GlobalNumbers::add_element(const Lattice       &lattice,
                                  const StrutInterval &element,
                                  const unsigned int   order,
                                  std::vector<int>    &result) const
  {
    for (unsigned int node = 0; node <= order; ++node)
      {
        if (element.is_joint(node))
          {
            const MotionNumbers &displacement =
              joints[lattice.struts[element.strut].joints[node]];
            const MotionNumbers &rotation =
              end_rotation(lattice, element.strut, node);
            for (const unsigned int component : components)
              result.push_back(component < first_rotation
                                 ? displacement[component]
                                 : rotation[component]);
            continue;
          }
        for (unsigned int c = 0; c < components.size(); ++c)
          result.push_back(
            first_inner[element.strut] +
            int(place_among_inner(element, order, node) * components.size() +
                c));
      }
  }

  GlobalNumbers::MotionNumbers
  GlobalNumbers::rotation(const RotationOwner &rotation_owner) const
  {
    MotionNumbers numbers       = {{-1, -1, -1, -1, -1, -1}};
    const auto    copy_rotation = [&numbers](const MotionNumbers &from) {
      for (unsigned int c = first_rotation; c < n_motion_components; ++c)
        numbers[c] = from[c];
    };
    switch (rotation_owner.kind)
      {
        case RotationOwner::Kind::ground:
          break;
        case RotationOwner::Kind::joint:
          copy_rotation(joints[rotation_owner.index]);
          break;
        case RotationOwner::Kind::strut_end:
          copy_rotation(
            released_ends.at({rotation_owner.index, rotation_owner.end}));
          break;
        case RotationOwner::Kind::rigid_part:
          copy_rotation(rigid_parts[rotation_owner.index].motion);
          break;
      }
    return numbers;
  }

  std::vector<std::vector<int>> GlobalNumbers::coupled(const Ties &ties) const
  {
    std::vector<std::vector<int>> result;
    const auto                    add = [&](const RotationPair &pair) {
      result.emplace_back();
      for (const RotationOwner &rotation_owner : {pair.base, pair.end})
        for (const int number : rotation(rotation_owner))
          if (number >= 0)
            result.back().push_back(number);
    };
    for (const RotationPair &pair : ties.sprung)
      add(pair);
    for (unsigned int h = 0; h < ties.hinged.size(); ++h)
      {
        add(ties.hinged[h]);
        result.back().insert(result.back().end(),
                             hinges[h].multipliers.begin(),
                             hinges[h].multipliers.end());
      }
    for (unsigned int r = 0; r < ties.relations.size(); ++r)
      {
        result.push_back({relations[r].multiplier});
        const bool all_components = ties.relations[r].is_of_equal_rotations;
        for (const LinearRelation::Term &term : ties.relations[r].terms)
          for (unsigned int c = 0; c < n_motion_components; ++c)
            if (const int number = joints[term.motion.joint][c]; number >= 0 &&
                (c == term.motion.component ||
                 (all_components && c >= first_rotation)))
              result.back().push_back(number);
      }
    return result;
  }

  ConstraintUnknowns::ConstraintUnknowns(
    const GlobalNumbers             &numbers,
    const UnknownLayout             &layout,
    const std::vector<unsigned int> &rigid_parts)
    : local_rigid_parts(rigid_parts)
  {
    const auto all_local = [&layout](const auto &globals) {
      auto locals = globals;
      std::transform(globals.begin(),
                     globals.end(),
                     locals.begin(),
                     [&layout](const int g) { return layout.local(g); });
      return locals;
    };
    const auto keep = [this](const auto &multipliers) {
      for (const int multiplier : multipliers)
        if (multiplier >= 0)
          local_multipliers.push_back(multiplier);
    };
    for (const GlobalNumbers::RigidPartNumbers &part : numbers.rigid_parts)
      rigid_part_numbers.push_back({all_local(part.motion),
                                    part.clamped_joints,
                                    all_local(part.multipliers)});
    for (const GlobalNumbers::HingeNumbers &hinge : numbers.hinges)
      hinge_numbers.push_back(all_local(hinge.multipliers));
    for (const GlobalNumbers::RelationNumbers &relation : numbers.relations)
      relation_numbers.push_back(layout.local(relation.multiplier));
    for (const unsigned int p : local_rigid_parts)
      keep(rigid_part_numbers[p].multipliers);
    for (const std::array<int, 2> &multipliers : hinge_numbers)
      keep(multipliers);
    keep(relation_numbers);
  }

  unsigned int ConstraintUnknowns::n_multipliers() const
  {
    unsigned int sum = 2 * hinge_numbers.size() + relation_numbers.size();
    for (const RigidPartNumbers &part : rigid_part_numbers)
      sum += part.multipliers.size();
    return sum;
  }
} // namespace auxfem
