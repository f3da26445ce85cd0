#include <auxfem/struts/factors.h>
#include <auxfem/struts/grading.h>
#include <auxfem/struts/section.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    /** A number of the material that may vary. */
    struct MaterialNumber
    {
      std::string name;
      /** Multiplies it; false if the section has none. */
      bool (*multiply)(Section &section, double factor);
    };

    bool multiply(std::optional<double> &number, const double factor)
    {
      if (number)
        *number *= factor;
      return number.has_value();
    }

    const std::vector<MaterialNumber> &material_numbers()
    {
      static const std::vector<MaterialNumber> numbers = {
        {"Young's modulus",
         [](Section &section, const double factor) {
           section.youngs_modulus *= factor;
           section.shear_modulus *= factor;
           // A law that yields has stresses of its own.
           return !section.yields();
         }},
        {"Density",
         [](Section &section, const double factor) {
           section.density *= factor;
           return section.density > 0;
         }},
        {"Yield strain",
         [](Section &section, const double factor) {
           return multiply(section.yield_strain, factor);
         }},
        {"Stiffness-proportional damping",
         [](Section &section, const double factor) {
           section.stiffness_proportional_damping *= factor;
           return section.stiffness_proportional_damping > 0;
         }},
        {"Mass-proportional damping",
         [](Section &section, const double factor) {
           section.mass_proportional_damping *= factor;
           return section.mass_proportional_damping > 0;
         }},
        {"Thermal expansion", [](Section &section, const double factor) {
           return multiply(section.thermal_expansion, factor);
         }}};
      return numbers;
    }

    std::vector<std::string> numbers_of(const Section         &section,
                                        const Parameters      &shape_parameters,
                                        const ParameterValues &values)
    {
      std::vector<std::string> names = numbers_among(shape_parameters, values);
      for (const MaterialNumber &number : material_numbers())
        if (Section copy = section; number.multiply(copy, 1))
          names.push_back(number.name);
      return names;
    }

    std::string text_of(const StrutPlace &place)
    {
      std::ostringstream text;
      text.precision(3);
      text << "at strut " << place.strut << " (middle " << place.x << ", "
           << place.y << ", " << place.z << " m)";
      return text.str();
    }
  } // namespace

  Grading::Grading(const ParameterValues   &values,
                   const Parameter         &parameter,
                   const SectionDefinition &section,
                   const Parameters        &shape_parameters,
                   void (*const read_shape)(ParameterValues &,
                                            SectionDefinition &))
    : values(values)
    , parameter(parameter)
    , variables(std::make_unique<Variables>())
    , read_shape(read_shape)
  {
    Factors::Language language{
      parameter,
      {{"strut", &variables->strut}, {"cell", &variables->cell}},
      &variables->item,
      "Write NAME: EXPRESSION in x, y, z, xmin, xmax, ... (m), strut, cell, "
      "random(seed), normal(seed), e.g. Height: 1 + 0.5 * y / ymax"};
    for (unsigned int d = 0; d < 3; ++d)
      {
        const std::string axis(1, "xyz"[d]);
        language.variables.emplace_back(axis, &variables->position[d]);
        language.variables.emplace_back(axis + "min", &variables->lowest[d]);
        language.variables.emplace_back(axis + "max", &variables->highest[d]);
      }
    factors = std::make_unique<const Factors>(values,
                                              language,
                                              numbers_of(section.section,
                                                         shape_parameters,
                                                         values));
    for (const std::string &name : factors->names())
      dimensions.push_back(find_by_name(material_numbers(), name) != nullptr
                             ? 0.
                             : quantity_of(name, values));
  }

  Grading::~Grading() = default;

  void Grading::set_bounds(const std::array<dealii::Point<3>, 2> &bounds)
  {
    for (unsigned int d = 0; d < 3; ++d)
      {
        variables->lowest[d]  = bounds[0][d];
        variables->highest[d] = bounds[1][d];
      }
  }

  std::vector<double> Grading::factors_at(const StrutPlace &place)
  {
    variables->position = {{place.x, place.y, place.z}};
    variables->strut    = place.strut;
    variables->cell     = place.cell;
    variables->item     = place.strut;
    std::vector<double> result;
    for (unsigned int i = 0; i < factors->names().size(); ++i)
      result.push_back(factors->factor(i, [&] { return text_of(place); }));
    return result;
  }

  SectionDefinition Grading::with_factors(const std::vector<double> &factors,
                                          const SectionDefinition   &section)
  {
    SectionDefinition graded    = section;
    bool              has_shape = false;
    for (unsigned int i = 0; i < factors.size(); ++i)
      {
        const std::string &name = this->factors->names()[i];
        if (const MaterialNumber *const number =
              find_by_name(material_numbers(), name))
          number->multiply(graded.section, factors[i]);
        else
          {
            set_quantity(name, factors[i] * dimensions[i], values);
            has_shape = true;
          }
      }
    if (!has_shape)
      return graded;
    read_shape(values, graded);
    if (const auto &law = section.section.law; law &&
        !are_alike(law->needed_shape(section.section.shape),
                   law->needed_shape(graded.section.shape)))
      values.refuse(parameter,
                    "the proportions of the section vary, for which this "
                    "material has no fibres. Let both dimensions vary alike, "
                    "or divide the struts into several sections");
    return graded;
  }
} // namespace auxfem
