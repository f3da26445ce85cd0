#ifndef auxfem_joints_constraint_definition_h
#define auxfem_joints_constraint_definition_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace auxfem
{
  /** `Constraints/NAME`: linear relations between motions of joints. */
  struct ConstraintDefinition
  {
    enum class Type
    {
      equal_motion, ///< joints move alike in some components
      line,         ///< each joint stays on a straight line
      relation      ///< one sum of motions is zero
    };

    /** Coefficient times the mean motion of a set of joints. */
    struct Term
    {
      /** m before rotations if the relation has displacements, too; else 1. */
      double       coefficient;
      unsigned int component;
      std::string  joints;
    };

    std::string name;
    Type        type = Type::equal_motion;
    std::string joints; ///< joint set; of a relation in its terms
    /** Components in which joints move alike. */
    std::array<bool, n_motion_components> components = {};
    dealii::Tensor<1, 3> direction; ///< unit vector of the line
    std::vector<Term>    terms;     ///< of the relation
    std::string          path;      ///< for messages
  };

  /** Schema of `Constraints`. */
  SubsectionSchema constraints_schema();

  /** Reads `Constraints/NAME`. Throws InputError if a value has no meaning. */
  ConstraintDefinition read_constraint(ParameterValues &values);
} // namespace auxfem

#endif
