#ifndef auxfem_analysis_small_motions_modes_h
#define auxfem_analysis_small_motions_modes_h

#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

namespace auxfem
{
  /**
   * Runs `Analysis = modes` (natural frequencies, modes.csv) or `Analysis =
   * buckling` (load factors, buckling.csv). Writes to Output/Directory, also
   * summary.json and `mode_1_solution.pvd` etc., and to the screen. Throws
   * InputError, ComputationError. Collective.
   */
  RunResult run_modes(const Scene         &scene,
                      MPI_Comm             communicator,
                      const FolderOptions &options);

  /** The dry run: builds everything, prints counts and effects. Collective. */
  void check_modes(const Scene &scene, MPI_Comm communicator);

  /**
   * Plan for modes at t = 0, at rest or about an equilibrium.
   * @param analysis modes or buckling
   */
  RunPlan
  plan_of_modes(const Scene &scene, Analysis analysis, bool about_equilibrium);

  /** Plan for the mode analysis that @p scene requests. */
  RunPlan plan_of_modes(const Scene &scene);

  /** The plan of run_modes(): with elements that meet the tolerance of @p scene,
   * if it has one. Throws ComputationError. Collective. */
  RunPlan plan_with_accepted_elements(const Scene &scene,
                                      MPI_Comm     communicator);

  /** Load case that the scene requests. */
  BucklingLoads buckling_loads(const Scene &scene);

  /**
   * Computes the first @p n buckling modes of @p run, which has started, under
   * the load case of its scene. Throws as buckling_modes(); messages begin with
   * @p purpose, the parameter that requests the modes. Collective.
   */
  BucklingModes buckling_modes_of(LatticeRun        &run,
                                  unsigned int       n,
                                  const std::string &purpose);

  /** Names of all files that a mode analysis can write. */
  std::vector<std::string> modes_files();
} // namespace auxfem

#endif
