#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/discretization_parameters.h>

namespace auxfem
{
  namespace
  {
    const Integer  order     = {"Order",
                                "default",
                                1,
                                largest_plane_order,
                                "Polynomial order of the struts' elements; "
                                     "with Dimension = 3 at most 4. default: auto with "
                                     "Analysis = modes, buckling or frequency "
                                     "response, else 3. auto: order and number of "
                                     "elements are chosen to meet the tolerance, in "
                                     "simulations strut by strut with as few unknowns as "
                                     "possible after a search run with order 2 and fewer "
                                     "steps, else equal ones for all struts.",
                                {"default", "auto"}};
    const Quantity tolerance = {
      "Tolerance",
      "1e-4",
      "1",
      Range::open(0, 1),
      "With Order = auto: error that the elements may make, by estimate: in the "
      "motion of the joints at any time, in the energy norm and relative to the "
      "largest motion; of each natural frequency or buckling factor, relative "
      "to it; of each column of a frequency response, relative to its largest "
      "amplitude."};
    const Integer refinements = {
      "Global refinements",
      0,
      0,
      10,
      "Number n of halvings: 2^n elements a strut. With "
      "Order = auto that many, or a multiple of it."};
  } // namespace



  SubsectionSchema discretization_schema()
  {
    return {"Discretization",
            SubsectionSchema::Form::fixed,
            "Finite elements of the struts.",
            {order, tolerance, refinements}};
  }



  DiscretizationParameters read_discretization(const ParameterValues &values,
                                               const bool is_chosen_by_default)
  {
    DiscretizationParameters discretization;
    if (!values.is_word(order))
      discretization.order = values[order];
    else if (is_chosen_by_default || !values.is_default(order))
      discretization.tolerance = values[tolerance];
    discretization.refinements = values[refinements];
    return discretization;
  }
} // namespace auxfem
