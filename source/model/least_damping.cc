#include <auxfem/model/least_damping.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    double least_of_struts(const Scene &scene, const LatticeModel &model)
    {
      if (!model.simulated.strut_damping ||
          have_rotational_springs(model.releases) ||
          (!scene.connectors.empty() && !model.simulated.connector_viscosity))
        return 0;
      double least = std::numeric_limits<double>::infinity();
      for (const Section &section : model.sections)
        least = std::min(least, section.stiffness_proportional_damping);
      return least;
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
    if (of_struts == 0 || omega == 0)
      return 0;
    double least = of_struts;
    for (const std::shared_ptr<const ConnectorLaw> &law : connectors)
      {
        const std::complex<double> stiffness =
          law->dynamic_stiffness({0, omega});
        if (stiffness.real() > 0)
          least =
            std::min(least, stiffness.imag() / (omega * stiffness.real()));
      }
    return least;
  }
} // namespace auxfem
