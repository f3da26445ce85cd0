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
   * `Analysis = modes`: natural frequencies and modes into Output/Directory
   * (modes.csv, summary.json, `mode_1_solution.pvd`, ...) and onto the screen.
   * `Analysis = buckling`: factors of loads and buckling modes (buckling.csv).
   * Throws InputError, ComputationError. Collective.
   */
  RunResult run_modes(const Scene         &scene,
                      MPI_Comm             communicator,
                      const FolderOptions &options);

  /** The dry run: builds everything, prints counts and effects. Collective. */
  void check_modes(const Scene &scene, MPI_Comm communicator);

  /** Modes are those at t = 0, at rest or about an equilibrium.
   * @param analysis modes or buckling */
  RunPlan
  plan_of_modes(const Scene &scene, Analysis analysis, bool about_equilibrium);

  /** The modes that @p scene asks for. */
  RunPlan plan_of_modes(const Scene &scene);

  /** Which loads the scene asks to multiply. */
  BucklingLoads buckling_loads(const Scene &scene);

  /**
   * The first @p n under the loads that the scene of @p run asks for, which has
   * started. Throws as buckling_modes(), with messages that begin with
   * @p purpose: the parameter that asks for the modes. Collective.
   */
  BucklingModes buckling_modes_of(LatticeRun        &run,
                                  unsigned int       n,
                                  const std::string &purpose);

  /** Names of files that tell of modes, of any number of them. */
  std::vector<std::string> modes_files();
} // namespace auxfem

#endif
