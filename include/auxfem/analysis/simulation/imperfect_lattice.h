#ifndef auxfem_analysis_simulation_imperfect_lattice_h
#define auxfem_analysis_simulation_imperfect_lattice_h

#include <auxfem/equations/equations.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/run_plan.h>
#include <auxfem/state/checkpoint_archive.h>

#include <mpi.h>

namespace auxfem
{
  /**
   * Saves @p state, an accepted one, or restores it in place of the initial
   * state, with equal digits on as many ranks. Throws InputError if a record is
   * missing. Collective.
   */
  void serialize_state(const Equations   &equations,
                       CheckpointArchive &archive,
                       State             &state);

  /** Displacements of a saved state. Throws as serialize_state(). Collective.
   */
  Vector saved_displacement(const Equations      &equations,
                            const CheckpointData &records);

  /** Time of a saved state (s); on a path of equilibria its arc length (m). */
  double time_of_saved_state(const CheckpointData &records);

  /** Steps of the scene until a saved state, or points of a path. */
  unsigned long step_of_saved_state(const CheckpointData &records);

  /** Load factor of a saved state on a path of equilibria. */
  double load_factor_of_saved_state(const CheckpointData &records);

  /**
   * The lattice of @p plan with its imperfections, for which buckling modes of
   * the designed one may have to be computed: collective then. Throws as
   * build_lattice() and buckling_modes(), and InputError for a mode that is not
   * there.
   */
  Lattice imperfect_lattice(const RunPlan &plan, MPI_Comm communicator);
} // namespace auxfem

#endif
