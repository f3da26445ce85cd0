#ifndef auxfem_mesh_imperfection_definition_h
#define auxfem_mesh_imperfection_definition_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <string>

namespace auxfem
{
  /** `Imperfections/NAME`: by what the stress-free lattice is off the designed
   * one. */
  struct ImperfectionDefinition
  {
    enum class Type
    {
      random,
      expression,
      buckling_mode,
      result
    };
    std::string name;
    std::string path; ///< for messages
    Type        type = Type::random;
    /** Of random ones the standard deviation of each coordinate, of modes and
     * results the largest displacement (m). */
    double       amplitude = 0;
    std::string  joints; ///< random ones, as written
    unsigned int seed = 0;
    /** By expressions in x, y, z (m). */
    std::array<std::string, 3> displacement;
    unsigned int               mode = 1; ///< from 1 on
    std::string                folder;   ///< of a result
  };

  SubsectionSchema imperfections_schema();

  /** The values of one such subsection. */
  ImperfectionDefinition read_imperfection(const ParameterValues &values);
} // namespace auxfem

#endif
