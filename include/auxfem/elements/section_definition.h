#ifndef auxfem_elements_section_definition_h
#define auxfem_elements_section_definition_h

#include <auxfem/elements/section.h>
#include <auxfem/parameters/subsection_schema.h>

#include <string>

namespace auxfem
{
  /** `Sections/NAME`: cross-section and material of a set of struts. */
  struct SectionDefinition
  {
    std::string name;
    std::string struts; ///< strut set
    Section     section;
    std::string path;
    /** False: left out, which only a scene without inertia and weight may. */
    bool has_density = true;
  };

  /** `Sections`. */
  SubsectionSchema sections_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  SectionDefinition read_section(ParameterValues &values);
} // namespace auxfem

#endif
