#ifndef auxfem_loads_support_definition_h
#define auxfem_loads_support_definition_h

#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/motion_components.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <string>

namespace auxfem
{
  /** `Supports/NAME`: prescribed motion of a set of joints. */
  struct SupportDefinition
  {
    std::string name;
    std::string joints; ///< joint set
    /** Which components are prescribed, and their course (m, rad). */
    std::array<bool, n_motion_components>         fixed = {};
    std::array<TimeFunction, n_motion_components> motion;
    std::string                                   path;
  };

  /** `Supports`. */
  SubsectionSchema supports_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  SupportDefinition read_support(ParameterValues &values);
} // namespace auxfem

#endif
