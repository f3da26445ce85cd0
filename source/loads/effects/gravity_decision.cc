#include <auxfem/mesh/sets.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/mass_and_size.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Largest norm of a vector function of time, by samples. */
    template <std::size_t n>
    double largest_norm(const std::array<TimeFunction, n> &components,
                        const double                       end_time)
    {
      constexpr unsigned int n_samples = 256;
      double                 largest   = 0;
      for (unsigned int i = 0; i <= n_samples; ++i)
        {
          double square = 0;
          for (std::size_t c = 0; c < std::min<std::size_t>(3, n); ++c)
            if (!components[c].is_zero())
              square +=
                std::pow(components[c].value(end_time * i / n_samples), 2);
          largest = std::max(largest, std::sqrt(square));
        }
      return largest;
    }

    /** Largest force (N) of a @p load per length of struts, whose largest value
     * is @p largest (N/m). */
    template <class Load>
    double force_along_struts(const Load    &load,
                              const double   largest,
                              const RunPlan &plan,
                              const Lattice &lattice)
    {
      double           sum = 0;
      PositionFunction factor =
        load_distribution(load, lattice, plan.scene.context);
      for (const unsigned int s : struts_of(load, lattice, plan.scene.context))
        sum += largest * lattice.length(lattice.struts[s]) *
          std::abs(factor.value_at(lattice.centroid(lattice.struts[s])));
      return sum;
    }

    /** Sum of the largest norms of all forces of the scene (N). */
    double sum_of_forces(const RunPlan &plan, const Lattice &lattice)
    {
      const double end = plan.time.end_time;
      double       sum = 0;
      for (const JointLoadDefinition &load : plan.joint_loads())
        {
          const double     largest = largest_norm(load.components, end);
          PositionFunction factor =
            load_distribution(load, lattice, plan.scene.context);
          for (const unsigned int joint :
               joints_of(load, lattice, plan.scene.context))
            sum += largest * std::abs(factor.value_at(lattice.joints[joint]));
        }
      for (const LineLoadDefinition &load : plan.scene.line_loads)
        sum += force_along_struts(load,
                                  largest_norm(load.components, end),
                                  plan,
                                  lattice);
      for (const PressureDefinition &load : plan.scene.pressures)
        sum += force_along_struts(load,
                                  largest_norm<1>({{load.pressure}}, end),
                                  plan,
                                  lattice);
      return sum;
    }

    /** Ratio of weight to the other forces; nothing if there are none, as with
     * prescribed motions and moments only. */
    std::optional<EffectMeasure> measure_gravity(const RunPlan &plan,
                                                 const Lattice &lattice)
    {
      double forces = 0;
      try
        {
          forces = sum_of_forces(plan, lattice);
        }
      catch (const ComputationError &)
        {
          // A value is not finite; the run reports it when it gets there.
        }
      if (!(forces > 0))
        return std::nullopt;
      const double weight = total_mass(plan.scene, lattice) *
        largest_norm(plan.scene.gravity.acceleration, plan.time.end_time);
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
