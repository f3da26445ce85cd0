#ifndef auxfem_mesh_imperfection_h
#define auxfem_mesh_imperfection_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <string>

namespace auxfem
{
  /** Offsets of joints and strut middles of a lattice from the designed
   * geometry (m). */
  struct GeometryOffsets
  {
    /** Zero offsets for the joints and struts of @p lattice. */
    explicit GeometryOffsets(const Lattice &lattice);

    /** Offsets of the joints, and of the middles of the struts (m). */
    std::vector<dealii::Tensor<1, 3>> joints, middles;

    /** Mean offset of both ends of @p strut (m): that of its middle if the
     * strut keeps its shape. */
    dealii::Tensor<1, 3> mean_of_ends(const Strut &strut) const
    {
      return (joints[strut.joints[0]] + joints[strut.joints[1]]) / 2;
    }

    /** Norm of the largest offset (m). */
    double largest() const;

    /** Adds @p factor times @p others. */
    void add(double factor, const GeometryOffsets &others);
  };

  /**
   * Moves the joints of @p lattice. Struts whose middles do not follow their
   * ends become arcs, or arcs of another rise. Lattice::as_designed keeps the
   * lattice before the change.
   */
  void disturb(const GeometryOffsets &offsets, Lattice &lattice);

  /** `Imperfections/NAME`: a deviation of the stress-free lattice from the
   * designed one. */
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
    /** Type::random: standard deviation of each coordinate; modes and results:
     * largest displacement (m). */
    double       amplitude = 0;
    std::string  joints; ///< Type::random: joint selection as written
    unsigned int seed = 0;
    /** Type::expression: expressions in x, y, z (m). */
    std::array<std::string, 3> displacement;
    unsigned int               mode = 1; ///< number of the mode, from 1 on
    std::string                folder;   ///< Type::result: folder of the run
  };

  /** Schema of `Imperfections`. */
  SubsectionSchema imperfections_schema();

  /** Reads one subsection `Imperfections/NAME`. */
  ImperfectionDefinition read_imperfection(const ParameterValues &values);
} // namespace auxfem

#endif
