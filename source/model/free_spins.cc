#include <auxfem/mesh/sets.h>
#include <auxfem/model/free_spins.h>
#include <auxfem/model/rigid_parts.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** A force that follows its joint turns with it. */
    bool turns(const JointLoadDefinition &load)
    {
      return load.follows_joint ||
        std::any_of(load.components.begin() + first_rotation,
                    load.components.end(),
                    [](const TimeFunction &component) {
                      return !component.is_zero();
                    });
    }

    /** Joints whose rotation something may act on beside the struts there. */
    std::vector<bool>
    joints_held_or_turned(const RunPlan                   &plan,
                          const Lattice                   &lattice,
                          const std::vector<JointRelease> &releases)
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
        if (turns(load))
          for (const unsigned int joint :
               joints_of(load, lattice, plan.scene.context))
            is_held[joint] = true;
      for (const JointRelease &release : releases)
        for (const RotationPair &pair : release.pairs)
          is_held[pair.joint] = true;
      return is_held;
    }

    /** Finds chains of struts from one ball hinge to the next. */
    class Chains
    {
    public:
      Chains(const RunPlan                   &plan,
             const Lattice                   &lattice,
             const std::vector<JointRelease> &releases)
        : lattice(lattice)
        , released(ties_of(releases, lattice).released)
        , is_coupled(lattice.struts.size(), {{false, false}})
        , is_held(joints_held_or_turned(plan, lattice, releases))
        , rigid_ends(lattice.joints.size())
      {
        for (const JointRelease &release : releases)
          for (const RotationPair &pair : release.pairs)
            for (const RotationOwner &owner : {pair.base, pair.end})
              if (owner.what == RotationOwner::What::strut_end)
                is_coupled[owner.index][owner.end] = true;
        for (unsigned int s = 0; s < lattice.struts.size(); ++s)
          for (unsigned int end = 0; end < 2; ++end)
            if (!lattice.struts[s].is_rigid() && !released[s][end])
              rigid_ends[lattice.struts[s].joints[end]].push_back({s, end});
      }

      /** That which begins at a strut's end; empty if none does. */
      std::vector<unsigned int> from(const StrutEnd &first) const
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
            // A ring would go on for ever.
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

      /** Or one that ends alone at a joint that nothing turns or holds, as on a
       * support of type pin. */
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
          given_digits;
      }

      const Lattice                         &lattice;
      const std::vector<std::array<bool, 2>> released;
      std::vector<std::array<bool, 2>>       is_coupled;
      const std::vector<bool>                is_held; ///< by joint
      /** Elastic struts by joint. */
      std::vector<std::vector<StrutEnd>> rigid_ends;
    };
  } // namespace

  std::vector<FreeSpin> free_spins(const RunPlan                   &plan,
                                   const Lattice                   &lattice,
                                   const std::vector<JointRelease> &releases)
  {
    std::vector<FreeSpin> spins;
    if (lattice.dimension == 2 || releases.empty())
      return spins;
    const Chains      chains(plan, lattice, releases);
    std::vector<bool> is_found(lattice.struts.size(), false);
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        if (!is_found[s] && !lattice.struts[s].is_rigid())
          {
            const std::vector<unsigned int> chain = chains.from({s, end});
            for (const unsigned int found : chain)
              is_found[found] = true;
            if (!chain.empty())
              spins.push_back({chain, {s, end}});
          }
    return spins;
  }
} // namespace auxfem
