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
   * Saves the accepted @p state, or restores it in place of the initial state.
   * Digits are equal on equal numbers of ranks. Throws InputError if a record
   * is missing. Collective.
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

  /** Number of scene steps, or path points, until a saved state. */
  unsigned long step_of_saved_state(const CheckpointData &records);

  /** Load factor of a saved state on an equilibrium path. */
  double load_factor_of_saved_state(const CheckpointData &records);

  /**
   * The lattice of @p plan with its imperfections. May compute buckling modes
   * of the perfect lattice and is collective then. Throws as build_lattice()
   * and buckling_modes(), and InputError for a mode that does not exist.
   */
  Lattice imperfect_lattice(const RunPlan &plan, MPI_Comm communicator);
} // namespace auxfem

#endif
