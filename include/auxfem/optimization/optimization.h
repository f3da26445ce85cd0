#ifndef auxfem_optimization_optimization_h
#define auxfem_optimization_optimization_h

#include <auxfem/optimization/search.h>
#include <auxfem/optimization/sensitivities.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Outcome of an optimization. */
  struct OptimizationResult
  {
    Design first; ///< with the values of the scene
    /** Best design for the first objective; `first` if none is better. */
    Design best;
    /** All designs of the searches, after the first one. */
    std::vector<Design> designs;
    /** With two objectives: designs that no other one surpasses in both, the
     * first objective rising. */
    std::vector<Design> front;
    /** Values of the first and the best design with a finer mesh and half the
     * step; none where there is nothing to refine or the run has failed. */
    std::optional<GoalValues> refined_first, refined_best;
    /** At the best design, by variable. */
    std::vector<std::optional<VariableSensitivities>> sensitivities;
    /** Designs near the best one, up to twice the difference step away; none
     * with direct derivatives. */
    std::vector<Design> neighbours;
    /** Whether a search ended because of Optimization/Evaluations. */
    bool is_cut_short = false;

    /** Number of designs without usable results. */
    std::size_t n_failed() const
    {
      return std::count_if(designs.begin(),
                           designs.end(),
                           [](const Design &design) {
                             return !design.is_usable();
                           });
    }
  };

  /**
   * Runs the optimization of @p scene into its folder: optimization.csv with a
   * row for each design, with two objectives front.csv, best.prm, summary.json,
   * and the runs in the folder `designs`, from which an interrupted
   * optimization continues. Throws InputError and Interrupted; ComputationError
   * if the design of the scene itself fails. Collective.
   */
  RunResult run_optimization(const Scene         &scene,
                             MPI_Comm             communicator,
                             const FolderOptions &options);
} // namespace auxfem

#endif
