#ifndef auxfem_mesh_strut_mesh_h
#define auxfem_mesh_strut_mesh_h

#include <auxfem/mesh/lattice.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <cmath>
#include <tuple>
#include <vector>

namespace auxfem
{
  /** Division of a strut into elements of equal length. */
  struct StrutDivision
  {
    unsigned int order; ///< polynomial order
    unsigned int n_elements;

    /** Number of nodes between the joints. */
    unsigned int n_inner_nodes() const
    {
      return order * n_elements - 1;
    }

    bool operator==(const StrutDivision &other) const
    {
      return order == other.order && n_elements == other.n_elements;
    }

    /** Compares orders, then numbers of elements. */
    bool operator<(const StrutDivision &other) const
    {
      return std::tie(order, n_elements) <
        std::tie(other.order, other.n_elements);
    }
  };

  /** Position of an element: its strut and the fractions of the strut's length
   * at which it begins and ends. */
  struct StrutInterval
  {
    unsigned int strut;
    double       begin;
    double       end;

    /** Fraction of the strut's length at @p xi in [-1, 1] of the element. */
    double at(const double xi) const
    {
      return begin + (end - begin) * (1 + xi) / 2;
    }

    /** Number of the element along its strut. */
    unsigned int number() const
    {
      return std::lround(begin / (end - begin));
    }

    /** Whether @p node of the element, in the order of FE_Q, lies at a joint. */
    bool is_joint(const unsigned int node) const
    {
      return (node == 0 && begin == 0.) || (node == 1 && end == 1.);
    }
  };

  /**
   * Position along the element, 0..order, of @p node in the order of FE_Q (both
   * ends, then the inner nodes).
   */
  inline unsigned int position_along(const unsigned int node,
                                     const unsigned int order)
  {
    return node == 0 ? 0 : (node == 1 ? order : node - 1);
  }

  /** Division of the struts of a lattice into elements and among the ranks; the
   * same on every rank. */
  struct StrutPartition
  {
    /**
     * Assigns each strut of @p lattice to a rank of @p communicator.
     *
     * @param divisions by strut; those of rigid struts are unused
     */
    StrutPartition(const Lattice             &lattice,
                   std::vector<StrutDivision> divisions,
                   MPI_Comm                   communicator);

    std::vector<StrutDivision> divisions; ///< by strut
    std::vector<unsigned int>  ranks;     ///< by strut, rigid struts included
  };

  /**
   * Rank of every strut. METIS partitions the graph of unit cells that meet at
   * a joint, or that of struts if a rank would have fewer than a hundred cells.
   * Throws InputError if there are more ranks than struts.
   */
  std::vector<unsigned int> partition_struts(const Lattice &lattice,
                                             unsigned int   n_ranks);

  /**
   * The finite-element mesh of the struts. Strut s is the chain of cells from s
   * to s + 1 on a line; struts share no vertices, because deal.II lines cannot
   * branch. The numbering of unknowns connects them at joints, and
   * Lattice::axis() maps them to space.
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

    /** The mesh; it has no levels if there are no struts. */
    const dealii::Triangulation<1> &triangulation() const
    {
      return mesh;
    }

    /** Position of an active cell. */
    StrutInterval
    interval(const dealii::Triangulation<1>::cell_iterator &cell) const;

    /** Positions of all active cells in their order. */
    std::vector<StrutInterval> intervals() const;

  private:
    const std::vector<StrutDivision> &divisions;
    dealii::Triangulation<1>          mesh;
  };
} // namespace auxfem

#endif
