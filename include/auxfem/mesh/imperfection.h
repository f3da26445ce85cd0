#ifndef auxfem_mesh_imperfection_h
#define auxfem_mesh_imperfection_h

#include <auxfem/mesh/lattice.h>

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
} // namespace auxfem

#endif
