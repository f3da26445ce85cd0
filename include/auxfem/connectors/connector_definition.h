#ifndef auxfem_connectors_connector_definition_h
#define auxfem_connectors_connector_definition_h

#include <auxfem/connectors/connector_law.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <string>

namespace auxfem
{
  /** Limits beyond which a connector breaks for good; empty: never. */
  struct ConnectorLimits
  {
    std::optional<double> force;     ///< N, in tension and compression
    std::optional<double> extension; ///< m
  };

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
    /** Pairs of joints: pair set of the cell (`in-cell`, `rod`), `3 5; 7 9`, or
     * `ground: SET`. */
    std::string          between;
    Geometry             geometry = Geometry::line;
    dealii::Tensor<1, 3> direction; ///< unit vector for Geometry::direction
    /** Vector from the joint at rest to the ground point, for `ground: SET`
     * (m). */
    dealii::Tensor<1, 3> ground_offset;
    /** Length without force (m); empty: that in the lattice at rest. */
    std::optional<double> free_length;
    /** Extension of the law in the lattice at rest (m), by the preload. */
    double          preload_extension = 0;
    ConnectorLimits limits;
    std::string     path;

    /** Extension of the law in the lattice at rest (m) of a connector with @p
     * length (m) there. */
    double extension_at_rest(const double length) const
    {
      return free_length ? length - *free_length : preload_extension;
    }
  };

  /** `Connectors`. */
  SubsectionSchema connectors_schema();

  /** Reads the values of one such subsection. Throws InputError if they are
   * inconsistent. */
  ConnectorDefinition read_connector(ParameterValues &values);
} // namespace auxfem

#endif
