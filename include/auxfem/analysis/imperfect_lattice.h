#ifndef auxfem_analysis_imperfect_lattice_h
#define auxfem_analysis_imperfect_lattice_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/run_plan.h>

#include <mpi.h>

namespace auxfem
{
  /**
   * The lattice of @p plan with its imperfections, for which buckling modes of
   * the designed one may have to be computed: collective then. Throws as
   * build_lattice() and buckling_modes(), and InputError for a mode that is not
   * there.
   */
  Lattice imperfect_lattice(const RunPlan &plan, MPI_Comm communicator);
} // namespace auxfem

#endif
