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
  /** The elements that a strut is divided into, all equally long. */
  struct StrutDivision
  {
    unsigned int order; ///< polynomial
    unsigned int n_elements;

    /** Nodes that are the strut's own, between its joints. */
    unsigned int n_inner_nodes() const
    {
      return order * n_elements - 1;
    }

    bool operator==(const StrutDivision &other) const
    {
      return order == other.order && n_elements == other.n_elements;
    }

    /** By order, then by number. */
    bool operator<(const StrutDivision &other) const
    {
      return std::tie(order, n_elements) <
        std::tie(other.order, other.n_elements);
    }
  };

  /** Where an element lies: on which strut, and between which fractions of its
   * length. */
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

    /** Number of the element along its strut: all elements of a strut are
     * equally long. */
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
  inline unsigned int place_along(const unsigned int node,
                                  const unsigned int order)
  {
    return node == 0 ? 0 : (node == 1 ? order : node - 1);
  }

  /** How the struts of a lattice are divided into elements and among the ranks:
   * the same on every rank. */
  struct StrutPartition
  {
    /**
     * Gives each strut of @p lattice to one of the ranks of @p communicator.
     *
     * @param divisions by strut; those of rigid ones mean nothing
     */
    StrutPartition(const Lattice             &lattice,
                   std::vector<StrutDivision> divisions,
                   MPI_Comm                   communicator);

    std::vector<StrutDivision> divisions; ///< by strut
    std::vector<unsigned int>  ranks;     ///< by strut, rigid ones included
  };

  /**
   * Rank of every strut: METIS on the graph of unit cells that meet at a joint,
   * or of struts where each rank has fewer than a hundred cells. All zero for
   * one rank. Throws InputError if there are more ranks than struts.
   */
  std::vector<unsigned int> partition_struts(const Lattice &lattice,
                                             unsigned int   n_ranks);

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
