#ifndef auxfem_mesh_strut_mesh_h
#define auxfem_mesh_strut_mesh_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_division.h>

#include <deal.II/distributed/shared_tria.h>

#include <cmath>

namespace auxfem
{
  /**
   * The finite-element mesh of a lattice: a line on which elastic strut s is
   * the chain of cells from s to s + 1, sharing no vertex with any other
   * (deal.II lines may not branch; joints are made by the numbering of unknowns
   * instead). Where the strut lies in space is told by Lattice::axis(). Every
   * rank holds the whole mesh; METIS divides the struts among the ranks.
   */
  class StrutMesh
  {
  public:
    using Triangulation = dealii::parallel::shared::Triangulation<1>;

    /**
     * Where an active cell lies: on which strut, and between which fractions
     * of its length.
     */
    struct Interval
    {
      unsigned int strut;
      double       begin;
      double       end;

      /** Fraction of the strut's length at @p xi in [-1, 1] of the cell. */
      double at(const double xi) const
      {
        return begin + (end - begin) * (1 + xi) / 2;
      }

      /** Number of the cell along its strut: all cells of a strut are equally
       * long. */
      unsigned int number() const
      {
        return std::lround(begin / (end - begin));
      }

      /** Whether @p node of the cell, in the order of FE_Q, lies at a joint. */
      bool is_joint(const unsigned int node) const
      {
        return (node == 0 && begin == 0.) || (node == 1 && end == 1.);
      }
    };

    /**
     * Makes a cell for every element of the struts of @p lattice and gives each
     * strut to one of the ranks of @p communicator. Collective.
     *
     * @param divisions by strut, the same on every rank; those of rigid ones
     *   mean nothing
     */
    StrutMesh(const Lattice             &lattice,
              std::vector<StrutDivision> divisions,
              MPI_Comm                   communicator);

    /** Empty, and not to be looped over, if all struts are rigid. */
    const Triangulation &triangulation() const
    {
      return mesh;
    }

    /** Number of active cells of all ranks. */
    unsigned int n_cells() const;

    /** The elements of the struts. */
    const std::vector<StrutDivision> &divisions() const
    {
      return of_struts;
    }

    /** Position of an active cell. */
    Interval interval(const Triangulation::cell_iterator &cell) const;

    /** Rank a strut was given to, rigid ones included. */
    unsigned int rank(const unsigned int strut) const
    {
      return ranks[strut];
    }

  private:
    Triangulation                    mesh;
    const std::vector<StrutDivision> of_struts;
    const std::vector<unsigned int>  ranks; ///< by strut
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

  /** Active cells of @p container on @p mesh, which may have none. */
  template <class Container>
  auto active_cells(const Container &container, const StrutMesh &mesh)
  {
    using Range = decltype(container.active_cell_iterators());
    return mesh.n_cells() > 0 ? container.active_cell_iterators()
                              : Range(container.end(), container.end());
  }

  /**
   * Rank of every strut: METIS on the graph of struts that meet at a joint.
   * All zero for one rank. Throws InputError if there are more ranks than
   * struts.
   */
  std::vector<unsigned int> partition_struts(const Lattice &lattice,
                                             unsigned int   n_ranks);
} // namespace auxfem

#endif
