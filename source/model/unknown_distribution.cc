#include <auxfem/model/unknown_distribution.h>

namespace auxfem
{
  std::vector<RotationOwner>
  joint_rotations(const Lattice                          &lattice,
                  const std::vector<std::array<bool, 2>> &released)
  {
    using What = RotationOwner::What;
    std::vector<RotationOwner> rotation_owner(lattice.joints.size());
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        if (const unsigned int joint = lattice.struts[s].joints[end];
            !lattice.struts[s].is_rigid() && !released[s][end])
          rotation_owner[joint] = {What::joint, joint, 0};

    std::vector<unsigned int> n_parts(lattice.joints.size(), 0);
    for (const RigidPart &part : lattice.rigid_parts)
      if (part.has_rotation)
        for (const unsigned int joint : part.joints)
          ++n_parts[joint];
    for (unsigned int p = 0; p < lattice.rigid_parts.size(); ++p)
      if (const RigidPart &part = lattice.rigid_parts[p]; part.has_rotation)
        for (const unsigned int joint : part.joints)
          if (rotation_owner[joint].what == What::joint ? part.clamps_struts
                                                        : n_parts[joint] == 1)
            rotation_owner[joint] = {What::rigid_part, p, 0};
    return rotation_owner;
  }

  UnknownDistribution::UnknownDistribution(const Lattice     &lattice,
                                           const Ties        &ties,
                                           const unsigned int n_ranks)
    : lattice(lattice)
    , ties(ties)
    , rotation_of_joint(joint_rotations(lattice, ties.released))
    , of_joint(lattice.joints.size())
    , of_part(lattice.rigid_parts.size())
    , of_hinge(ties.hinged.size())
    , count(n_ranks, 0)
  {
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        if (!lattice.struts[s].is_rigid() && ties.released[s][end])
          of_released_end[{s, end}];
  }

  void UnknownDistribution::assign(Unknown &unknown, const int rank)
  {
    if (unknown.owner < 0)
      unknown = {rank, count[rank]++};
  }

  int UnknownDistribution::assign_inner(const unsigned int n, const int rank)
  {
    const int first = count[rank];
    count[rank] += n;
    return first;
  }

  UnknownDistribution::Motion &
  UnknownDistribution::motion_of(const RotationOwner &rotation_owner)
  {
    switch (rotation_owner.what)
      {
        case RotationOwner::What::strut_end:
          return of_released_end.at({rotation_owner.index, rotation_owner.end});
        case RotationOwner::What::rigid_part:
          return of_part[rotation_owner.index].motion;
        default:
          return of_joint[rotation_owner.index];
      }
  }

  const UnknownDistribution::Motion &
  UnknownDistribution::motion_of(const RotationOwner &rotation_owner) const
  {
    return const_cast<UnknownDistribution *>(this)->motion_of(rotation_owner);
  }

  void UnknownDistribution::assign_end(const unsigned int strut,
                                       const unsigned int end,
                                       const unsigned int component,
                                       const int          rank)
  {
    const unsigned int joint  = lattice.struts[strut].joints[end];
    Motion            &motion = component < first_rotation ? of_joint[joint]
                 : ties.released[strut][end] ? of_released_end.at({strut, end})
                                             : motion_of(rotation_of_joint[joint]);
    assign(motion[component], rank);
  }

  void
  UnknownDistribution::assign_joints(const std::vector<unsigned int> &ranks)
  {
    const auto assign_displacements = [&](const unsigned int joint,
                                          const int          rank) {
      for (unsigned int component = 0; component < lattice.dimension;
           ++component)
        assign(of_joint[joint][component], rank);
    };
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      if (lattice.struts[s].is_rigid())
        for (const unsigned int joint : lattice.struts[s].joints)
          assign_displacements(joint, ranks[s]);
    // A joint without struts (a mass on connectors) has displacements only.
    for (unsigned int joint = 0; joint < of_joint.size(); ++joint)
      assign_displacements(joint, 0);
  }

  void UnknownDistribution::assign_rigid_parts()
  {
    for (unsigned int p = 0; p < of_part.size(); ++p)
      {
        const RigidPart   &part   = lattice.rigid_parts[p];
        RigidPartUnknowns &claims = of_part[p];
        const int          rank   = of_joint[part.joints[0]][0].owner;
        const unsigned int d = lattice.dimension, n = part.joints.size();
        if (part.has_rotation)
          for (Unknown &unknown : claims.motion)
            assign(unknown, rank);
        else if (part.clamps_struts)
          for (const unsigned int joint : part.joints)
            if (of_joint[joint][rotation_z].owner >= 0)
              claims.clamped_joints.push_back(joint);
        claims.multipliers.resize(part.has_rotation ? d * n
                                                    : 1 + d * (n - 2) +
                                      claims.clamped_joints.size());
        for (Unknown &multiplier : claims.multipliers)
          assign(multiplier, rank);
      }
  }

  void UnknownDistribution::assign_hinges()
  {
    for (unsigned int h = 0; h < of_hinge.size(); ++h)
      for (Unknown &multiplier : of_hinge[h])
        assign(multiplier, motion_of(ties.hinged[h].end)[rotation_z].owner);
  }

  UnknownDistribution::Motion
  UnknownDistribution::joint(const unsigned int joint) const
  {
    Motion        motion   = of_joint[joint];
    const Motion &rotation = motion_of(rotation_of_joint[joint]);
    if (rotation_of_joint[joint].what != RotationOwner::What::ground)
      std::copy(rotation.begin() + first_rotation,
                rotation.end(),
                motion.begin() + first_rotation);
    return motion;
  }
} // namespace auxfem
