#ifndef auxfem_optimization_refined_designs_h
#define auxfem_optimization_refined_designs_h

#include <auxfem/optimization/design_runs.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Overrides for a finer discretization of @p scene: one more refinement of
   * the mesh, half the time step and a quarter of the tolerance on the step,
   * which halves the steps of a scheme of second order; empty if there is
   * nothing to refine.
   */
  std::vector<std::string> finer_discretization(const Scene &scene);

  /** These overrides in words, e.g. `a finer mesh and half the step`. */
  std::string refinement_text(const Scene &scene);

  /**
   * Goals of @p designs with finer_discretization(), computed in folders
   * `PARENT/0001` ...; none where the run has failed. Throws Interrupted.
   * Collective.
   */
  std::vector<std::optional<GoalValues>>
  refined_goals(const Scene               &scene,
                const std::vector<Design> &designs,
                Goals                     &goals,
                MPI_Comm                   communicator,
                const FileRules           &rules,
                const std::string         &parent);
} // namespace auxfem

#endif
