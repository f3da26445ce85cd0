#ifndef auxfem_joints_joint_definition_h
#define auxfem_joints_joint_definition_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace auxfem
{
  /** `Joints/NAME`: joints at which struts are not rigidly connected. */
  struct JointDefinition
  {
    enum class Type
    {
      hinge,    ///< free to rotate; in space a spherical joint
      revolute, ///< in space: free to rotate about one axis
      rotational_spring
    };
    std::string name;
    std::string joints; ///< joint set
    std::string struts; ///< strut set whose ends are released there
    Type        type = Type::hinge;
    /** Rotational stiffness K' of a released strut end at rest (N m/rad). */
    double stiffness = 0;
    /** Law of its moment (N m) over its relative rotation (rad), in space about
     * the axis of a revolute hinge; nullptr: linear, by the stiffness. */
    std::shared_ptr<const ConnectorLaw> law;
    /** Unit vector of a revolute hinge's axis at rest; 0 for others. */
    dealii::Tensor<1, 3> axis;
    std::string          path; ///< for messages
  };

  /** Schema of `Joints`. */
  SubsectionSchema joints_schema();

  /** Reads `Joints/NAME`. Throws InputError if values contradict each other. */
  JointDefinition read_joint(ParameterValues &values);
} // namespace auxfem

#endif
