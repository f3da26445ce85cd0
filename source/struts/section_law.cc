#include <auxfem/struts/section_law.h>

namespace auxfem
{
  const Registry<SectionLaw> &section_law_registry()
  {
    static const Registry<SectionLaw> registry = {
      {"elastic",
       "Linear elastic.",
       {},
       [](ParameterValues &) -> std::unique_ptr<SectionLaw> {
         return nullptr;
       }},
      viscoelastic_entry(),
      elastic_plastic_entry()};
    return registry;
  }
} // namespace auxfem
