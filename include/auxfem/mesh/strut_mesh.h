#ifndef auxfem_mesh_strut_mesh_h
#define auxfem_mesh_strut_mesh_h

#include <auxfem/mesh/lattice.h>

#include <deal.II/distributed/shared_tria.h>

namespace auxfem
{
  /**
   * The finite-element mesh of a lattice: every elastic strut is a chain of
   * line cells of its own, sharing no vertex with any other (deal.II lines may
   * not branch; joints are made by the numbering of unknowns instead). Every
   * rank holds the whole mesh; METIS divides the struts among the ranks.
   *
   * Vertices lie on the chord of a strut; the true axis of an arc comes from
   * Lattice::axis().
   */
  class StrutMesh
  {
  public:
    /**
     * Where an active cell lies: on which strut, and between which fractions
     * of its length.
     */
    struct Place
    {
      unsigned int strut;
      double       begin;
      double       end;

      /** Fraction of the strut's length at @p xi in [-1, 1] of the cell. */
      double at(const double xi) const
      {
        return begin + (end - begin) * (1 + xi) / 2;
      }
    };

    /**
     * Makes 2^refinements cells for every strut of @p lattice and divides the
     * struts among the ranks of @p communicator.
     */
    StrutMesh(const Lattice &lattice,
              unsigned int   refinements,
              MPI_Comm       communicator);

    /** Empty, and not to be looped over, if all struts are rigid. */
    const dealii::parallel::shared::Triangulation<1, 3> &triangulation() const;

    /** Number of active cells of all ranks. */
    unsigned int n_cells() const;

    /** Place of the active cell with this active_cell_index(). */
    const Place &place(unsigned int active_cell_index) const;

    /** Rank a strut was given to, rigid ones included. */
    unsigned int rank(unsigned int strut) const;

  private:
    dealii::parallel::shared::Triangulation<1, 3> mesh;
    const std::vector<unsigned int>               ranks; ///< by strut
    std::vector<Place>                            places;
  };

  /**
   * Rank of every strut: METIS on the graph of struts that meet at a joint.
   * All zero for one rank. Throws InputError if there are more ranks than
   * struts.
   */
  std::vector<unsigned int> partition_struts(const Lattice &lattice,
                                             unsigned int   n_ranks);
} // namespace auxfem

#endif
