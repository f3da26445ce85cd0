#include <auxfem/mesh/sets.h>
#include <auxfem/model/load_history.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/model/supports.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <map>

namespace auxfem
{
  namespace
  {
    /** Records which support prescribes each unknown, on all ranks. */
    class PrescribedMotions
    {
    public:
      /** Whether @p definition is the first to prescribe a component of a
       * joint. Two supports may both fix it, as at a corner; otherwise the
       * second is rejected. */
      bool is_first(const SupportDefinition &definition,
                    const unsigned int       joint,
                    const unsigned int       component,
                    const Lattice           &lattice,
                    const DofNumbering      &numbering)
      {
        const bool at_rest = definition.motion[component].is_zero();
        // Joints of a rigid part may share a rotation.
        const auto [prescription, is_new] =
          prescriptions.insert({numbering.global().joints[joint][component],
                                {&definition, at_rest}});
        if (!is_new && !(at_rest && prescription->second.at_rest) &&
            prescription->second.support != &definition)
          throw InputError(definition.path + ": the " +
                           motion_name(component, lattice.dimension) +
                           " of joint " + std::to_string(joint) +
                           " is already prescribed by " +
                           prescription->second.support->path +
                           ". Take the joint out of one of the two sets.");
        return is_new;
      }

    private:
      struct Prescription
      {
        const SupportDefinition *support;
        bool                     at_rest;
      };
      std::map<int, Prescription> prescriptions;
    };

    /** Whether a joint lacks the component and needs no support; throws if it
     * needs one. */
    bool is_needless(const SupportDefinition &definition,
                     const unsigned int       joint,
                     const unsigned int       component,
                     const DofNumbering      &numbering,
                     const std::vector<bool> &is_of_rigid_part)
    {
      if (numbering.joint_has(joint, component))
        return false;
      // A clamped hinge has no rotation to fix.
      if (definition.motion[component].is_zero() && !is_of_rigid_part[joint])
        return true;
      throw InputError(definition.path + "/Rotation " +
                       "xyz"[component - first_rotation] + ": " +
                       missing_rotation_reason(numbering, joint) +
                       " Type = pin holds displacements only.");
    }

    /** With fewer than three prescribed axes angles are integrated, so they
     * must start at zero. */
    void refuse_turned_at_start(const SupportDefinition &definition)
    {
      const auto        first = definition.fixed.begin() + first_rotation;
      const std::size_t n     = std::count(first, definition.fixed.end(), true);
      for (unsigned int c = first_rotation; c < n_motion_components && n < 3;
           ++c)
        if (definition.fixed[c] && definition.motion[c].value(0) != 0)
          throw InputError(
            definition.path + "/Rotation " + "xyz"[c - first_rotation] +
            ": a large rotation prescribed about some axes alone begins with "
            "zero at t = 0. Increase it in time, e.g. as 0.1 * t, prescribe the "
            "rotations about the other axes as well, or set Effects/Large rotation = "
            "off.");
    }

    void group_rotations(const DofNumbering &numbering, Support &support)
    {
      for (const Support::PrescribedUnknown &prescribed : support.unknowns)
        {
          if (prescribed.component < first_rotation)
            continue;
          const unsigned int rotation =
            numbering.rotations().with(prescribed.unknown);
          if (support.rotations.empty() ||
              support.rotations.back().rotation != rotation)
            support.rotations.push_back({rotation, {{false, false, false}}});
          support.rotations.back()
            .fixed[prescribed.component - first_rotation] = true;
        }
    }
  } // namespace

  bool Support::moves(const PrescribedRotation &prescribed) const
  {
    for (unsigned int c = 0; c < 3; ++c)
      if (prescribed.fixed[c] && !motion[first_rotation + c].is_zero())
        return true;
    return false;
  }

  bool Support::is_at_rest() const
  {
    return std::all_of(motion.begin(),
                       motion.end(),
                       [](const TimeFunction &component) {
                         return component.is_zero();
                       });
  }

  std::vector<JointMotion> prescribed_motions(const Scene   &scene,
                                              const Lattice &lattice)
  {
    std::vector<JointMotion> motions;
    for (const SupportDefinition &definition : scene.supports)
      for (const unsigned int joint :
           joints_of(definition, lattice, scene.context))
        for (unsigned int c = 0; c < n_motion_components; ++c)
          if (definition.fixed[c])
            motions.push_back({joint, c});
    return motions;
  }

  std::vector<Support> make_supports(const RunPlan      &plan,
                                     const Lattice      &lattice,
                                     const DofNumbering &numbering,
                                     const bool          large_rotations)
  {
    const std::vector<bool> is_of_rigid_part = joints_of_rigid_parts(lattice);
    PrescribedMotions       prescriptions;
    std::vector<Support>    supports;
    for (const SupportDefinition &definition : plan.scene.supports)
      {
        Support support{definition.name, {}, {}, definition.motion};
        for (TimeFunction &motion : support.motion)
          motion = proportional(motion, plan);
        for (const unsigned int joint :
             joints_of(definition, lattice, plan.scene.context))
          for (const unsigned int c : numbering.components())
            {
              if (!definition.fixed[c] ||
                  is_needless(definition,
                              joint,
                              c,
                              numbering,
                              is_of_rigid_part) ||
                  !prescriptions
                     .is_first(definition, joint, c, lattice, numbering))
                continue;
              const int unknown = numbering.joint_unknown(joint, c);
              if (unknown >= 0)
                support.unknowns.push_back({unknown, c, joint});
            }
        if (large_rotations && lattice.dimension == 3)
          {
            refuse_turned_at_start(definition);
            group_rotations(numbering, support);
          }
        supports.push_back(support);
      }
    return supports;
  }
} // namespace auxfem
