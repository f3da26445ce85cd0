#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/system/joint_releases.h>

namespace auxfem
{
  namespace
  {
    /** Ends of elastic struts; rigid ones are hinged everywhere. */
    std::vector<std::vector<StrutEnd>> ends_by_joint(const Lattice &lattice)
    {
      std::vector<std::vector<StrutEnd>> ends_at(lattice.joints.size());
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        for (unsigned int end = 0; end < 2 && !lattice.struts[s].is_rigid();
             ++end)
          ends_at[lattice.struts[s].joints[end]].push_back({s, end});
      return ends_at;
    }

    /** What a released strut end turns against. */
    struct SpringBase
    {
      /** -1 without `is_ground`: not on this rank. */
      int  unknown   = -1;
      bool is_ground = false;
    };

    SpringBase spring_base(const JointRelease::AtJoint &at,
                           const DofNumbering          &numbering)
    {
      if (numbering.joint_has(at.joint, rotation_z))
        return {numbering.joint_unknown(at.joint, rotation_z), false};
      if (at.ends.size() == 1)
        return {-1, true};
      return {numbering.end_rotation(at.ends[0].strut, at.ends[0].end), false};
    }

    /** A rigid part has no rotation that the spring of a lone strut could act
     * on. */
    void refuse_spring_to_rigid_part(const JointDefinition &definition,
                                     const Lattice         &lattice,
                                     const unsigned int     joint)
    {
      for (const RigidPart &part : lattice.rigid_parts)
        for (const unsigned int candidate : part.joints)
          if (candidate == joint)
            throw InputError(
              definition.path + "/Joints: a rigid part is hinged at joint " +
              std::to_string(joint) +
              ", and a rotational spring cannot act on it. Take the joint out, "
              "or put a short elastic strut clamped to the part between.");
    }
  } // namespace

  std::vector<JointRelease> joint_releases(const Scene   &scene,
                                           const Lattice &lattice)
  {
    const std::vector<std::vector<StrutEnd>> ends_at = ends_by_joint(lattice);

    std::vector<JointRelease> releases;
    for (const JointDefinition &definition : scene.joints)
      {
        std::vector<bool> chosen(lattice.struts.size(), false);
        for (const unsigned int s : select_struts(lattice,
                                                  definition.struts,
                                                  scene.context,
                                                  definition.path + "/Struts"))
          chosen[s] = true;
        JointRelease release{definition.type, definition.stiffness, {}};
        for (const unsigned int joint :
             select_joints(lattice,
                           definition.joints,
                           scene.context,
                           definition.path + "/Joints"))
          {
            JointRelease::AtJoint at{joint, {}};
            for (const StrutEnd &end : ends_at[joint])
              if (chosen[end.strut])
                at.ends.push_back(end);
            // Elsewhere it acts between elastic struts.
            if (definition.type == JointDefinition::Type::rotational_spring &&
                ends_at[joint].size() < 2)
              refuse_spring_to_rigid_part(definition, lattice, joint);
            if (at.ends.empty())
              throw InputError(definition.path + ": no elastic strut of '" +
                               definition.struts + "' ends at joint " +
                               std::to_string(joint) +
                               ". Name struts that end at all these joints.");
            release.joints.push_back(at);
          }
        releases.push_back(release);
      }
    return releases;
  }

  void release(const std::vector<JointRelease> &releases, Ties &ties)
  {
    for (const JointRelease &release : releases)
      for (const JointRelease::AtJoint &at : release.joints)
        {
          for (const StrutEnd &end : at.ends)
            ties.released[end.strut][end.end] = true;
          if (release.type == JointDefinition::Type::rotational_spring)
            ties.sprung_joints.push_back(at.joint);
        }
  }

  std::unique_ptr<RotationalSprings>
  make_rotational_springs(const std::vector<JointRelease> &releases,
                          const DofNumbering              &numbering)
  {
    auto springs = std::make_unique<RotationalSprings>(numbering);
    bool is_used = false;
    for (const JointRelease &release : releases)
      if (release.type == JointDefinition::Type::rotational_spring)
        for (const JointRelease::AtJoint &at : release.joints)
          {
            const SpringBase base = spring_base(at, numbering);
            for (const StrutEnd &end : at.ends)
              {
                const int rotation = numbering.end_rotation(end.strut, end.end);
                if (rotation < 0 || rotation == base.unknown ||
                    (base.unknown < 0 && !base.is_ground))
                  continue;
                springs->add(base.unknown, rotation, release.stiffness);
                is_used = true;
              }
          }
    return is_used ? std::move(springs) : nullptr;
  }
} // namespace auxfem
