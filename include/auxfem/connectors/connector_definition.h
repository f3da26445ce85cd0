#ifndef auxfem_connectors_connector_definition_h
#define auxfem_connectors_connector_definition_h

#include <auxfem/connectors/connector_law.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace auxfem
{
  /** `Connectors/NAME`: equal connectors between pairs of joints. */
  struct ConnectorDefinition
  {
    enum class Geometry
    {
      line,     ///< along the current line between the two ends
      direction ///< along a direction fixed in space
    };
    std::string                         name;
    std::shared_ptr<const ConnectorLaw> law;
    /**
     * Pair set of the cell (`in-cell`, `rod`), or `3 5; 7 9`, or `ground:
     * SET`.
     */
    std::string          between;
    Geometry             geometry = Geometry::line;
    dealii::Tensor<1, 3> direction; ///< unit vector for Geometry::direction
    /**
     * For `ground: SET`: the ground point is the joint's position at rest plus
     * this (m).
     */
    dealii::Tensor<1, 3> ground_offset;
    std::string          path;
  };

  /** `Connectors`. */
  SubsectionSchema connectors_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  ConnectorDefinition read_connector(ParameterValues &values);
} // namespace auxfem

#endif
