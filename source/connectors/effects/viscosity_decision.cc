#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/load_history.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Tip stiffness (N/m) of the softest strut, 3 EI / L^3. */
    double softest_strut(const RunPlan &plan, const Lattice &lattice)
    {
      double softest = std::numeric_limits<double>::infinity();
      for (const Strut &strut : lattice.struts)
        if (!strut.is_rigid())
          {
            const Section &section = plan.scene.sections[strut.section].section;
            const double   bending = lattice.dimension == 2
                ? section.bending_stiffness_3()
                : std::min(section.bending_stiffness_2(),
                         section.bending_stiffness_3());
            softest =
              std::min(softest,
                       3 * bending / std::pow(lattice.length(strut), 3));
          }
      return std::isfinite(softest) ? softest : 0;
    }

    /** Force over extension (N/m) at the end of a ramp of @p duration (s). */
    double ramp_stiffness(const ConnectorLaw &law, const double duration)
    {
      const ConnectorMotion     motion{1, 1 / duration, 0, duration};
      const std::vector<double> at_rest(law.n_history());
      std::vector<double>       at_end(law.n_history());
      ConnectorResponse         response;
      law.evaluate(1, &motion, at_rest.data(), at_end.data(), &response);
      return response.force;
    }

    template <class Definition>
    bool has_dashpot(const Definition &definition)
    {
      return definition.law && definition.law->is_viscous();
    }

    std::optional<EffectMeasure>
    measure_connector_viscosity(const RunPlan &plan, const Lattice &lattice)
    {
      const double      strut_stiffness = softest_strut(plan, lattice);
      const LoadHistory history         = load_history(plan);
      if (!(history.rate > 0))
        return EffectMeasure{0, "the connectors' stiffness"};
      double largest = 0;
      for (const ConnectorDefinition &connector : plan.scene.connectors)
        if (connector.law->is_viscous())
          {
            // The size of the motion, which decides here, is not known.
            if (!connector.law->is_linear())
              {
                largest = 1;
                continue;
              }
            const double ramp =
              ramp_stiffness(*connector.law, 1 / history.rate);
            const double long_time = connector.law->relaxed(0).stiffness;
            largest =
              std::max(largest, (ramp - long_time) / (ramp + strut_stiffness));
          }
      if (std::any_of(plan.scene.joints.begin(),
                      plan.scene.joints.end(),
                      has_dashpot<JointDefinition>))
        largest = 1;
      return EffectMeasure{history.lost(plan, largest),
                           "the connectors' stiffness"};
    }
  } // namespace

  EffectDefinition connector_viscosity_effect()
  {
    return {"connector viscosity",
            &EffectSwitches::connector_viscosity,
            &SimulatedEffects::connector_viscosity,
            [](const RunPlan &plan) -> EffectCause {
              if (plan.analysis == Analysis::static_path)
                return {false, no_rates_on_paths};
              return {std::any_of(plan.scene.connectors.begin(),
                                  plan.scene.connectors.end(),
                                  has_dashpot<ConnectorDefinition>) ||
                        std::any_of(plan.scene.joints.begin(),
                                    plan.scene.joints.end(),
                                    has_dashpot<JointDefinition>),
                      "no connector has a dashpot"};
            },
            measure_connector_viscosity};
  }
} // namespace auxfem
