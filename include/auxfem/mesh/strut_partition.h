#ifndef auxfem_mesh_strut_partition_h
#define auxfem_mesh_strut_partition_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_division.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace auxfem
{
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
} // namespace auxfem

#endif
