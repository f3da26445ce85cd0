#ifndef auxfem_struts_discretization_parameters_h
#define auxfem_struts_discretization_parameters_h

#include <auxfem/mesh/strut_mesh.h>
#include <auxfem/parameters/subsection_schema.h>

#include <optional>

namespace auxfem
{
  /** `Discretization`. */
  struct DiscretizationParameters
  {
    unsigned int order = 3; ///< polynomial order 1..6, in space 1..4
    /** Global refinements: 2^n elements per strut. */
    unsigned int refinements = 0;
    /** Allowed discretization error (1) for the choice of elements; nothing:
     * use the elements given here. */
    std::optional<double> tolerance = {};
    /** Whether the scene leaves the elements to the program. */
    bool is_default = true;

    StrutDivision common_division() const
    {
      return {order, 1u << refinements};
    }
  };

  /** `Discretization`. */
  SubsectionSchema discretization_schema();

  /**
   * Reads the values of that subsection.
   * @param is_chosen_by_default whether `Order = default` means `auto` in the
   *   analysis of the scene
   * @param yields whether a material of the scene yields
   * @param tapers whether a section varies along its struts
   */
  DiscretizationParameters read_discretization(const ParameterValues &values,
                                               bool is_chosen_by_default,
                                               bool yields,
                                               bool tapers);
} // namespace auxfem

#endif
