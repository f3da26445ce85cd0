#include <auxfem/mesh/sets.h>
#include <auxfem/model/effect_decisions.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Larger bending stiffness of a strut over its length (N m). */
    double rotational_stiffness(const Strut   &strut,
                                const RunPlan &plan,
                                const Lattice &lattice)
    {
      const Section &section = plan.scene.sections[strut.section].section;
      const double   bending = lattice.dimension == 2
          ? section.bending_stiffness_3()
          : std::max(section.bending_stiffness_2(),
                   section.bending_stiffness_3());
      return bending / lattice.length(strut);
    }

    /** Whether a joint has a single strut, whose spring holds it to the
     * ground. */
    bool has_lone_end(const std::vector<unsigned int> &joints,
                      const Lattice                   &lattice)
    {
      std::vector<unsigned int> n_ends(lattice.joints.size());
      for (const Strut &strut : lattice.struts)
        for (const unsigned int joint : strut.joints)
          ++n_ends[joint];
      return std::any_of(joints.begin(),
                         joints.end(),
                         [&n_ends](const unsigned int joint) {
                           return n_ends[joint] == 1;
                         });
    }

    /** Largest relative compliance that springs of @p joint add to a strut,
     * 3 EI / (k L) per end. */
    double added_compliance(const JointDefinition           &joint,
                            const std::vector<unsigned int> &joints,
                            const RunPlan                   &plan,
                            const Lattice                   &lattice)
    {
      double largest = 0;
      for (const unsigned int s : struts_of(joint, lattice, plan.scene.context))
        {
          const Strut &strut = lattice.struts[s];
          if (strut.is_rigid())
            continue;
          const auto n_ends =
            std::count_if(strut.joints.begin(),
                          strut.joints.end(),
                          [&](const auto end) {
                            return std::binary_search(joints.begin(),
                                                      joints.end(),
                                                      end);
                          });
          if (n_ends > 0)
            largest =
              std::max(largest,
                       3 * n_ends * rotational_stiffness(strut, plan, lattice) /
                         joint.stiffness);
        }
      return largest;
    }

    /** Measure for linear rotational springs; nothing for hinges, without which
     * the structure is another one, and for laws, whose stiffness changes. */
    std::optional<EffectMeasure> measure_hinges(const RunPlan &plan,
                                                const Lattice &lattice)
    {
      double largest = 0;
      for (const JointDefinition &joint : plan.scene.joints)
        {
          const auto joints = joints_of(joint, lattice, plan.scene.context);
          if (joint.type != JointDefinition::Type::rotational_spring ||
              joint.law || !(joint.stiffness > 0) ||
              has_lone_end(joints, lattice))
            return std::nullopt;
          largest =
            std::max(largest, added_compliance(joint, joints, plan, lattice));
        }
      return EffectMeasure{std::min(1., largest), "the bending compliance"};
    }
  } // namespace

  EffectDefinition hinges_effect()
  {
    return {"hinges",
            &EffectSwitches::hinges,
            &SimulatedEffects::hinges,
            [](const RunPlan &plan) -> EffectCause {
              return {!plan.scene.joints.empty(),
                      plan.scene.joints.empty()
                        ? "no strut ends are released"
                        : "joints with released struts"};
            },
            measure_hinges,
            [](const SimulatedEffects & /*before*/) -> std::string {
              return "springs in joints are kept";
            }};
  }
} // namespace auxfem
