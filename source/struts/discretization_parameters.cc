#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/discretization_parameters.h>

namespace auxfem
{
  namespace
  {
    const Integer order = {
      "Order",
      "default",
      1,
      largest_plane_order,
      "Polynomial order of the struts' elements; at most 4 with Dimension = 3. "
      "default: auto with Analysis = modes, buckling or frequency response and "
      "no tapered sections, 4 with materials that yield, else 3. auto: order and number of elements meet Tolerance, in "
      "simulations per strut after a coarse search run, else equal for all "
      "struts.",
      {"default", "auto"}};
    const Quantity tolerance = {
      "Tolerance",
      "1e-4",
      "1",
      Range::open(0, 1),
      "With Order = auto: largest estimated discretization error. Simulations: "
      "joint motion at any time, in the energy norm, relative to the largest "
      "motion. Modes and buckling: relative error of each frequency or factor. "
      "Frequency response: each column, relative to its largest amplitude."};
    const Integer refinements = {
      "Global refinements",
      "default",
      0,
      10,
      "Number n of halvings: 2^n elements per strut; with Order = auto this "
      "number or a multiple. default: 4 with tapered sections, 1 with materials "
      "that yield, else 0.",
      {"default"}};
  } // namespace

  SubsectionSchema discretization_schema()
  {
    return {"Discretization",
            SubsectionSchema::Form::fixed,
            "Finite elements of the struts.",
            {order, tolerance, refinements}};
  }

  DiscretizationParameters read_discretization(const ParameterValues &values,
                                               const bool is_chosen_by_default,
                                               const bool yields,
                                               const bool tapers)
  {
    DiscretizationParameters discretization;
    if (!values.is_word(order))
      discretization.order = values[order];
    else if (tapers && !values.is_default(order))
      values.refuse(order,
                    "elements of struts with a Taper are constant each, an "
                    "error which it does not estimate. Give an order and "
                    "compare runs with different Global refinements");
    else if ((is_chosen_by_default && !tapers) || !values.is_default(order))
      discretization.tolerance = values[tolerance];
    else if (yields)
      discretization.order = 4;
    discretization.is_default =
      values.is_default(order) && values.is_word(refinements);
    discretization.refinements =
      values.value_or(refinements, tapers ? 4 : (yields ? 1 : 0));
    return discretization;
  }
} // namespace auxfem
