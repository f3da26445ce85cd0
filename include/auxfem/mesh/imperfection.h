#ifndef auxfem_mesh_imperfection_h
#define auxfem_mesh_imperfection_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <string>

namespace auxfem
{
  /** How far the geometry of a lattice is off the designed one. */
  struct GeometryOffsets
  {
    /** None, for the joints and struts of @p lattice. */
    explicit GeometryOffsets(const Lattice &lattice);

    /** Of the joints, and of the middles of the struts (m). */
    std::vector<dealii::Tensor<1, 3>> joints, middles;

    /** That of the middle of a strut that keeps its shape (m). */
    dealii::Tensor<1, 3> mean_of_ends(const Strut &strut) const
    {
      return (joints[strut.joints[0]] + joints[strut.joints[1]]) / 2;
    }

    /** The largest of all (m). */
    double largest() const;

    void add(double factor, const GeometryOffsets &others);
  };

  /**
   * Moves joints and makes arcs of the struts whose middles are moved off their
   * place, or arcs of another rise. The designed lattice is kept for whoever
   * selects by position, see Lattice::as_designed.
   */
  void disturb(const GeometryOffsets &offsets, Lattice &lattice);

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
