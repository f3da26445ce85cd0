#ifndef auxfem_elements_discretization_parameters_h
#define auxfem_elements_discretization_parameters_h

#include <auxfem/parameters/subsection_schema.h>

namespace auxfem
{
  /** `Discretization`. */
  struct DiscretizationParameters
  {
    unsigned int order = 3; ///< polynomial order 1..6, in space 1..4
    /** Global refinements: 2^n elements a strut. */
    unsigned int refinements = 0;
  };

  /** `Discretization`. */
  SubsectionSchema discretization_schema();

  /** The values of that subsection. */
  DiscretizationParameters read_discretization(ParameterValues &values);
} // namespace auxfem

#endif
