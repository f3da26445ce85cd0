#include <auxfem/loads/load_definitions.h>
#include <auxfem/scene/mean_deformation.h>

namespace auxfem
{
  namespace
  {
    constexpr const char *free_strain = "free";

    TimeExpression strain_parameter(const unsigned int i, const unsigned int j)
    {
      const std::string name = component_name(i, j);
      // Without the lower shears the mean rotation is zero.
      return {"Strain " + name,
              i <= j ? free_strain : "0",
              "1",
              "Mean derivative of the displacement along " + name.substr(0, 1) +
                " by " + name.substr(1) + "; free: follows from Stress " +
                name + (i < 2 && j < 2 ? "." : "; with Dimension = 3 only."),
              {free_strain}};
    }

    TimeExpression stress_parameter(const unsigned int i, const unsigned int j)
    {
      const std::string name = component_name(i, j);
      return {"Stress " + name,
              "0",
              "Pa",
              "Mean force along " + name.substr(0, 1) +
                " per area at rest with its normal along " + name.substr(1) +
                ", where Strain " + name + " = free" +
                (i < 2 && j < 2 ? "." : "; with Dimension = 3 only.")};
    }

    template <class Make>
    std::vector<TimeExpression> all_components(const Make &make)
    {
      std::vector<TimeExpression> all;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          all.push_back(make(i, j));
      return all;
    }

    const std::vector<TimeExpression> strains =
                                        all_components(strain_parameter),
                                      stresses =
                                        all_components(stress_parameter);

    const Integer stability_waves = {
      "Stability waves",
      6,
      0,
      1000,
      "Number of wave vectors along each reciprocal vector for which each step "
      "checks that the lattice is stable against waves; 0: no check."};
  } // namespace

  std::string component_name(const unsigned int i, const unsigned int j)
  {
    return {"xyz"[i], "xyz"[j]};
  }

  bool MeanDeformation::is_given() const
  {
    for (const auto &row : components)
      for (const Component &component : row)
        if (!component.strain.is_zero() || !component.stress.is_zero())
          return true;
    return false;
  }

  SubsectionSchema mean_deformation_schema()
  {
    Parameters parameters;
    parameters.insert(parameters.end(), strains.begin(), strains.end());
    parameters.insert(parameters.end(), stresses.begin(), stresses.end());
    parameters.push_back(stability_waves);
    return {"Mean deformation",
            SubsectionSchema::Form::fixed,
            "With Analysis = effective response: history of the mean strain or "
            "stress of the infinite lattice.",
            parameters};
  }

  MeanDeformation read_mean_deformation(ParameterValues &values)
  {
    MeanDeformation    mean;
    const unsigned int dimension = values.context.dimension;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const TimeExpression &strain = strains[3 * i + j],
                               &stress = stresses[3 * i + j];
          if (i >= dimension || j >= dimension)
            {
              require_space(values, strain);
              require_space(values, stress);
              continue;
            }
          MeanDeformation::Component &component = mean.components[i][j];
          component.is_strain_given             = !values.is_word(strain);
          component.stress = read_time_function(values, stress);
          if (!component.is_strain_given)
            continue;
          component.strain = read_time_function(values, strain);
          if (!component.stress.is_zero())
            values.refuse(stress,
                          strain.name +
                            " is given, so that the stress follows from it. "
                            "Set one of the two; " +
                            strain.name + " = free leaves the strain open");
        }
    mean.stability_waves = values[stability_waves];
    return mean;
  }
} // namespace auxfem
