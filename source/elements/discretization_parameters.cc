#include <auxfem/elements/discretization_parameters.h>
#include <auxfem/elements/strut_order.h>

namespace auxfem
{
  namespace
  {
    const Integer order       = {"Order",
                                 3,
                                 1,
                                 largest_plane_order,
                                 "Polynomial order of the struts' elements; "
                                       "with Dimension = 3 at most 4."};
    const Integer refinements = {"Global refinements",
                                 0,
                                 0,
                                 10,
                                 "Number n of halvings: 2^n elements a strut."};
  } // namespace



  SubsectionSchema discretization_schema()
  {
    return {"Discretization",
            SubsectionSchema::Form::fixed,
            "Finite elements of the struts.",
            {order, refinements}};
  }



  DiscretizationParameters read_discretization(ParameterValues &values)
  {
    DiscretizationParameters discretization;
    discretization.order       = values[order];
    discretization.refinements = values[refinements];
    return discretization;
  }
} // namespace auxfem
