#ifndef auxfem_mesh_strut_mesh_h
#define auxfem_mesh_strut_mesh_h

#include <auxfem/mesh/strut_division.h>
#include <auxfem/mesh/strut_interval.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace auxfem
{
  /**
   * The finite-element mesh of struts: a line on which strut s is the chain of
   * cells from s to s + 1, sharing no vertex with any other (deal.II lines may
   * not branch; joints are made by the numbering of unknowns instead). Where
   * the strut lies in space is told by Lattice::axis().
   */
  class StrutMesh
  {
  public:
    /**
     * Makes a cell for every element of @p struts.
     *
     * @param divisions of all struts of the lattice; must outlive the mesh
     * @param struts ascending; without rigid ones
     */
    StrutMesh(const std::vector<StrutDivision> &divisions,
              const std::vector<unsigned int>  &struts);

    /** The mesh, without levels if there are no struts. */
    const dealii::Triangulation<1> &triangulation() const
    {
      return mesh;
    }

    /** Position of an active cell. */
    StrutInterval
    interval(const dealii::Triangulation<1>::cell_iterator &cell) const;

    /** Those of all active cells in their order. */
    std::vector<StrutInterval> intervals() const;

  private:
    const std::vector<StrutDivision> &divisions;
    dealii::Triangulation<1>          mesh;
  };
} // namespace auxfem

#endif
