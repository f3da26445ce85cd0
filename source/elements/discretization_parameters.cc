#include <auxfem/elements/discretization_parameters.h>
#include <auxfem/elements/strut_order.h>

namespace auxfem
{
  namespace
  {
    const Integer  order     = {"Order",
                                3,
                                1,
                                largest_plane_order,
                                "Polynomial order of the struts' elements; "
                                     "with Dimension = 3 at most 4. auto: order and "
                                     "number of elements are chosen strut by strut, "
                                     "as few unknowns as the tolerance allows, after "
                                     "a search run with order 2 and fewer steps.",
                                {"auto"}};
    const Quantity tolerance = {
      "Tolerance",
      "1e-4",
      "1",
      Range::open(0, 1),
      "With Order = auto: error that the elements may make in the motion of the "
      "joints at any time, by estimate, in the energy norm and relative to the "
      "largest motion."};
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



  DiscretizationParameters read_discretization(ParameterValues &values)
  {
    DiscretizationParameters discretization;
    if (values.is_word(order))
      discretization.tolerance = values[tolerance];
    else
      discretization.order = values[order];
    discretization.refinements = values[refinements];
    return discretization;
  }
} // namespace auxfem
