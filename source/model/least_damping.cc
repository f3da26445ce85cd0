#include <auxfem/model/least_damping.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    double least_of_struts(const Scene &scene, const LatticeModel &model)
    {
      const bool has_springs =
        std::any_of(model.releases.begin(),
                    model.releases.end(),
                    [](const JointRelease &release) {
                      return release.definition->type ==
                        JointDefinition::Type::rotational_spring;
                    });
      const bool has_undamped_connectors =
        !scene.connectors.empty() && !model.simulated.connector_viscosity;
      if (!model.simulated.strut_damping || has_springs ||
          has_undamped_connectors || model.sections.empty())
        return 0;
      const auto damping = [](const Section &section) {
        return section.stiffness_proportional_damping;
      };
      return damping(
        *std::min_element(model.sections.begin(),
                          model.sections.end(),
                          [&](const Section &one, const Section &other) {
                            return damping(one) < damping(other);
                          }));
    }
  } // namespace

  LeastDamping::LeastDamping(const Scene &scene, const LatticeModel &model)
    : of_struts(least_of_struts(scene, model))
  {
    for (const ConnectorDefinition &definition : scene.connectors)
      connectors.push_back(definition.law);
  }

  double LeastDamping::rate(const double omega) const
  {
    const double ratio = omega * time(omega) / 2;
    return ratio < 1 ? ratio * omega
                     : omega / (ratio + std::sqrt(ratio * ratio - 1));
  }

  double LeastDamping::time(const double omega) const
  {
    double least = of_struts;
    for (const std::shared_ptr<const ConnectorLaw> &law : connectors)
      {
        if (!(least > 0 && omega > 0))
          return 0;
        const std::complex<double> stiffness =
          law->dynamic_stiffness({0, omega});
        if (stiffness.real() > 0)
          least =
            std::min(least, stiffness.imag() / (omega * stiffness.real()));
      }
    return least;
  }
} // namespace auxfem
