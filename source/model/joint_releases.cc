#include <auxfem/mesh/sets.h>
#include <auxfem/model/joint_releases.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using Type      = JointDefinition::Type;
    using OwnerKind = RotationOwner::Kind;

    /** Ends of elastic or of rigid struts, by joint. */
    std::vector<std::vector<StrutEnd>> ends_by_joint(const Lattice &lattice,
                                                     const bool     rigid)
    {
      std::vector<std::vector<StrutEnd>> ends_at(lattice.joints.size());
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        for (unsigned int end = 0;
             end < 2 && lattice.struts[s].is_rigid() == rigid;
             ++end)
          ends_at[lattice.struts[s].joints[end]].push_back({s, end});
      return ends_at;
    }

    /** Rejects a spring between a single strut and a rigid part in the plane,
     * which has no rotation. */
    [[noreturn]] void
    refuse_spring_to_rigid_part(const JointDefinition &definition,
                                const unsigned int     joint)
    {
      throw InputError(
        definition.path + "/Joints: a rigid part is hinged at joint " +
        std::to_string(joint) +
        ", and a rotational spring cannot act on it. Take the joint out, "
        "or put a short elastic strut clamped to the part between.");
    }

    [[noreturn]] void refuse_bar(const JointDefinition &definition,
                                 const unsigned int     joint)
    {
      throw InputError(
        definition.path + "/Joints: the rigid part at joint " +
        std::to_string(joint) +
        " lies on one line, so it has no rotation that a spring or a revolute "
        "hinge could act on. Leave its struts or the joint out, or set Elastic "
        "struts = clamped for the part, which gives it a rotation.");
    }

    /** The rigid parts of the chosen rigid struts that end at a joint. */
    std::vector<unsigned int>
    chosen_rigid_parts(const JointDefinition       &definition,
                       const Lattice               &lattice,
                       const std::vector<StrutEnd> &ends,
                       const std::vector<bool>     &chosen,
                       const unsigned int           joint)
    {
      std::vector<unsigned int> parts;
      for (const StrutEnd &end : ends)
        {
          const unsigned int part = lattice.struts[end.strut].rigid_part;
          if (!chosen[end.strut] ||
              std::count(parts.begin(), parts.end(), part) > 0)
            continue;
          if (lattice.rigid_parts[part].has_rotation)
            parts.push_back(part);
          else if (definition.type == Type::revolute)
            refuse_bar(definition, joint);
        }
      return parts;
    }

    /** Released rotations at a joint, in order. */
    std::vector<RotationOwner> rotation_owners(const JointRelease::AtJoint &at)
    {
      std::vector<RotationOwner> rotation_owner;
      for (const StrutEnd &end : at.ends)
        rotation_owner.push_back({OwnerKind::strut_end, end.strut, end.end});
      for (const unsigned int part : at.rigid_parts)
        rotation_owner.push_back({OwnerKind::rigid_part, part, 0});
      return rotation_owner;
    }

    /** Base rotation of the released @p ends at a joint. */
    RotationOwner base_of(const JointRelease::AtJoint      &at,
                          const std::vector<RotationOwner> &ends,
                          const RotationOwner              &joint_owner,
                          const JointDefinition            &definition,
                          const bool                        at_bar)
    {
      if (joint_owner.kind != OwnerKind::ground &&
          std::count(ends.begin(), ends.end(), joint_owner) == 0)
        return joint_owner;
      if (ends.size() > 1)
        return ends.front();
      // A single part rotates relative to the ground; a strut at a bar has no
      // base.
      if (at_bar && ends.front().kind == OwnerKind::strut_end)
        refuse_bar(definition, at.joint);
      return {};
    }

    /** The releases of all `Joints/NAME`, without pairs. */
    std::vector<JointRelease> chosen_ends(const Scene   &scene,
                                          const Lattice &lattice)
    {
      const std::vector<std::vector<StrutEnd>> ends_at =
                                                 ends_by_joint(lattice, false),
                                               rigid_ends_at =
                                                 ends_by_joint(lattice, true);

      const std::vector<bool>   is_of_part = joints_of_rigid_parts(lattice);
      std::vector<JointRelease> releases;
      for (const JointDefinition &definition : scene.joints)
        {
          std::vector<bool> chosen(lattice.struts.size(), false);
          for (const unsigned int s :
               struts_of(definition, lattice, scene.context))
            chosen[s] = true;
          JointRelease release{&definition, {}, {}};
          for (const unsigned int joint :
               joints_of(definition, lattice, scene.context))
            {
              JointRelease::AtJoint at{joint, {}, {}};
              for (const StrutEnd &end : ends_at[joint])
                if (chosen[end.strut])
                  at.ends.push_back(end);
              if (lattice.dimension == 3 && definition.type != Type::hinge)
                at.rigid_parts = chosen_rigid_parts(definition,
                                                    lattice,
                                                    rigid_ends_at[joint],
                                                    chosen,
                                                    joint);
              // With two struts the spring acts between them.
              if (lattice.dimension == 2 &&
                  definition.type == Type::rotational_spring &&
                  ends_at[joint].size() < 2 && is_of_part[joint])
                refuse_spring_to_rigid_part(definition, joint);
              if (at.ends.empty() && at.rigid_parts.empty())
                throw InputError(definition.path + ": no elastic strut of '" +
                                 definition.struts + "' ends at joint " +
                                 std::to_string(joint) +
                                 ". Name struts that end at all these joints.");
              release.joints.push_back(std::move(at));
            }
          releases.push_back(std::move(release));
        }
      return releases;
    }


    std::vector<std::array<bool, 2>>
    released_ends(const std::vector<JointRelease> &releases,
                  const Lattice                   &lattice)
    {
      std::vector<std::array<bool, 2>> released(lattice.struts.size(),
                                                {{false, false}});
      for (const JointRelease &release : releases)
        for (const JointRelease::AtJoint &at : release.joints)
          for (const StrutEnd &end : at.ends)
            released[end.strut][end.end] = true;
      return released;
    }

    /** Finds the rotations coupled by springs and revolute hinges. */
    void find_pairs(std::vector<JointRelease> &releases, const Lattice &lattice)
    {
      const std::vector<RotationOwner> joint_owners =
        joint_rotations(lattice, released_ends(releases, lattice));
      const std::vector<bool> is_of_part = joints_of_rigid_parts(lattice);
      for (JointRelease &release : releases)
        {
          const JointDefinition &definition = *release.definition;
          if (definition.type == Type::hinge)
            continue;
          for (const JointRelease::AtJoint &at : release.joints)
            {
              const std::vector<RotationOwner> ends = rotation_owners(at);
              const RotationOwner              base =
                base_of(at,
                        ends,
                        joint_owners[at.joint],
                        definition,
                        lattice.dimension == 3 && is_of_part[at.joint]);
              for (const RotationOwner &end : ends)
                if (!(end == base))
                  release.pairs.push_back({at.joint, base, end});
            }
        }
    }
  } // namespace

  std::vector<JointRelease> joint_releases(const Scene   &scene,
                                           const Lattice &lattice)
  {
    std::vector<JointRelease> releases = chosen_ends(scene, lattice);
    find_pairs(releases, lattice);
    return releases;
  }

  bool have_rotational_springs(const std::vector<JointRelease> &releases)
  {
    return std::any_of(releases.begin(),
                       releases.end(),
                       [](const JointRelease &release) {
                         return release.definition->type ==
                           Type::rotational_spring;
                       });
  }

  Ties ties_of(const std::vector<JointRelease> &releases,
               const Lattice                   &lattice)
  {
    Ties ties;
    ties.released = released_ends(releases, lattice);
    for (const JointRelease &release : releases)
      {
        auto &coupled = release.definition->type == Type::revolute
          ? ties.hinged
          : ties.sprung;
        coupled.insert(coupled.end(),
                       release.pairs.begin(),
                       release.pairs.end());
      }
    return ties;
  }

  namespace
  {
    /** Whether a load acts on rotations; follower forces rotate with their
     * joint. */
    bool acts_on_rotation(const JointLoadDefinition &load)
    {
      return load.follows_joint ||
        std::any_of(load.components.begin() + first_rotation,
                    load.components.end(),
                    [](const TimeFunction &component) {
                      return !component.is_zero();
                    });
    }

    /** Joints whose rotation is acted on by other things than struts. */
    std::vector<bool>
    joints_held_or_turned(const RunPlan                     &plan,
                          const Lattice                     &lattice,
                          const std::vector<JointRelease>   &releases,
                          const std::vector<LinearRelation> &relations)
    {
      std::vector<bool> is_held = joints_of_rigid_parts(lattice);
      is_held.resize(lattice.joints.size(), false);
      for (const SupportDefinition &support : plan.scene.supports)
        if (std::any_of(support.fixed.begin() + first_rotation,
                        support.fixed.end(),
                        [](const bool is_fixed) { return is_fixed; }))
          for (const unsigned int joint :
               joints_of(support, lattice, plan.scene.context))
            is_held[joint] = true;
      for (const JointLoadDefinition &load : plan.joint_loads())
        if (acts_on_rotation(load))
          for (const unsigned int joint :
               joints_of(load, lattice, plan.scene.context))
            is_held[joint] = true;
      for (const JointRelease &release : releases)
        for (const RotationPair &pair : release.pairs)
          is_held[pair.joint] = true;
      for (const LinearRelation &relation : relations)
        for (const LinearRelation::Term &term : relation.terms)
          if (term.motion.component >= first_rotation)
            is_held[term.motion.joint] = true;
      return is_held;
    }

    /** Finds chains of struts from one ball hinge to the next. */
    class StrutChains
    {
    public:
      StrutChains(const RunPlan                     &plan,
                  const Lattice                     &lattice,
                  const std::vector<JointRelease>   &releases,
                  const std::vector<LinearRelation> &relations)
        : lattice(lattice)
        , released(ties_of(releases, lattice).released)
        , is_coupled(lattice.struts.size(), {{false, false}})
        , is_held(joints_held_or_turned(plan, lattice, releases, relations))
        , rigid_ends(lattice.joints.size())
      {
        for (const JointRelease &release : releases)
          for (const RotationPair &pair : release.pairs)
            for (const RotationOwner &owner : {pair.base, pair.end})
              if (owner.kind == RotationOwner::Kind::strut_end)
                is_coupled[owner.index][owner.end] = true;
        for (unsigned int s = 0; s < lattice.struts.size(); ++s)
          for (unsigned int end = 0; end < 2; ++end)
            if (!lattice.struts[s].is_rigid() && !released[s][end])
              rigid_ends[lattice.struts[s].joints[end]].push_back({s, end});
      }

      /** Chain that starts at a strut end; empty if there is none. */
      std::vector<unsigned int> chain_from(const StrutEnd &first) const
      {
        std::vector<unsigned int> chain;
        StrutEnd                  end = first;
        if (!is_ball_hinge(end))
          return {};
        while (is_straight(end.strut) &&
               (chain.empty() || are_in_line(chain.back(), end.strut)))
          {
            chain.push_back(end.strut);
            const StrutEnd other = {end.strut, 1 - end.end};
            if (is_free_end(other))
              return chain;
            const unsigned int joint =
              lattice.struts[end.strut].joints[other.end];
            const auto &there = rigid_ends[joint];
            if (is_released(other) || is_held[joint] || there.size() != 2)
              return {};
            end = there[0].strut == end.strut ? there[1] : there[0];
            // Stops at closed rings.
            if (std::count(chain.begin(), chain.end(), end.strut) > 0)
              return {};
          }
        return {};
      }

    private:
      bool is_released(const StrutEnd &end) const
      {
        return released[end.strut][end.end];
      }

      bool is_ball_hinge(const StrutEnd &end) const
      {
        return is_released(end) && !is_coupled[end.strut][end.end];
      }

      /** A ball hinge, or a single strut at a free joint, for example on a pin
       * support. */
      bool is_free_end(const StrutEnd &end) const
      {
        const unsigned int joint = lattice.struts[end.strut].joints[end.end];
        return is_ball_hinge(end) ||
          (!is_released(end) && !is_held[joint] &&
           rigid_ends[joint].size() == 1);
      }

      bool is_straight(const unsigned int strut) const
      {
        return !lattice.struts[strut].is_rigid() &&
          lattice.struts[strut].sagitta == 0;
      }

      dealii::Tensor<1, 3> direction(const unsigned int strut) const
      {
        const auto                &ends = lattice.struts[strut].joints;
        const dealii::Tensor<1, 3> span =
          lattice.joints[ends[1]] - lattice.joints[ends[0]];
        return span / span.norm();
      }

      bool are_in_line(const unsigned int one, const unsigned int other) const
      {
        return cross_product_3d(direction(one), direction(other)).norm() <
          input_precision;
      }

      const Lattice                         &lattice;
      const std::vector<std::array<bool, 2>> released;
      std::vector<std::array<bool, 2>>       is_coupled;
      const std::vector<bool>                is_held; ///< by joint
      /** Unreleased ends of elastic struts, by joint. */
      std::vector<std::vector<StrutEnd>> rigid_ends;
    };
  } // namespace

  std::vector<FreeSpin> free_spins(const RunPlan                     &plan,
                                   const Lattice                     &lattice,
                                   const std::vector<JointRelease>   &releases,
                                   const std::vector<LinearRelation> &relations)
  {
    std::vector<FreeSpin> spins;
    if (lattice.dimension == 2 || releases.empty())
      return spins;
    const StrutChains chains(plan, lattice, releases, relations);
    std::vector<bool> is_found(lattice.struts.size(), false);
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        if (!is_found[s] && !lattice.struts[s].is_rigid())
          {
            const std::vector<unsigned int> chain = chains.chain_from({s, end});
            for (const unsigned int found : chain)
              is_found[found] = true;
            if (!chain.empty())
              spins.push_back({chain, {s, end}});
          }
    return spins;
  }
} // namespace auxfem
