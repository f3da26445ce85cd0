#include <auxfem/mesh/sets.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Mass (kg) of struts, rigid parts and point masses. */
    double total_mass(const RunPlan &plan, const Lattice &lattice)
    {
      double mass = 0;
      for (const Strut &strut : lattice.struts)
        if (!strut.is_rigid())
          mass += plan.scene.sections[strut.section].section.mass_per_length() *
            lattice.length(strut);
      for (const RigidPart &part : lattice.rigid_parts)
        mass += part.mass;
      for (const MassDefinition &point : plan.scene.masses)
        mass +=
          point.mass * joints_of(point, lattice, plan.scene.context).size();
      return mass;
    }

    /** The largest length of a vector that is a function of time. */
    template <std::size_t n>
    double largest_length(const std::array<TimeFunction, n> &components,
                          const double                       end_time)
    {
      constexpr unsigned int n_looks = 256;
      double                 largest = 0;
      for (unsigned int i = 0; i <= n_looks; ++i)
        {
          double square = 0;
          for (unsigned int c = 0; c < 3; ++c)
            if (!components[c].is_zero())
              square +=
                std::pow(components[c].value(end_time * i / n_looks), 2);
          largest = std::max(largest, std::sqrt(square));
        }
      return largest;
    }

    /** Sum of the largest values of all given forces (N). */
    double given_forces(const RunPlan &plan, const Lattice &lattice)
    {
      double sum = 0;
      for (const JointLoadDefinition &load : plan.joint_loads())
        sum += largest_length(load.components, plan.time.end_time) *
          joints_of(load, lattice, plan.scene.context).size();
      for (const LineLoadDefinition &load : plan.scene.line_loads)
        for (const unsigned int s :
             struts_of(load, lattice, plan.scene.context))
          sum += largest_length(load.components, plan.time.end_time) *
            lattice.length(lattice.struts[s]);
      return sum;
    }

    /**
     * Weight over the given forces. Motions and moments have no force to
     * compare with: nothing then.
     */
    std::optional<EffectMeasure> measure_gravity(const RunPlan &plan,
                                                 const Lattice &lattice)
    {
      double forces = 0;
      try
        {
          forces = given_forces(plan, lattice);
        }
      catch (const ComputationError &)
        {
          // What is no number stops the run when it gets there.
        }
      if (!(forces > 0))
        return std::nullopt;
      const double weight = total_mass(plan, lattice) *
        largest_length(plan.scene.gravity.acceleration, plan.time.end_time);
      return EffectMeasure{std::min(1., weight / forces), "the loads"};
    }
  } // namespace

  EffectDefinition gravity_effect()
  {
    return {"gravity",
            &EffectSwitches::gravity,
            &SimulatedEffects::gravity,
            [](const RunPlan &plan) -> EffectCause {
              return {!plan.scene.gravity.is_zero(),
                      plan.scene.gravity.is_zero()
                        ? "no acceleration given"
                        : "an acceleration is given"};
            },
            measure_gravity};
  }
} // namespace auxfem
