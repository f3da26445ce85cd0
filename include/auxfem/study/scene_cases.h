#ifndef auxfem_study_scene_cases_h
#define auxfem_study_scene_cases_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/run_quantities.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** A scene with other parameters and a folder of its own. */
  struct SceneCase
  {
    std::string folder; ///< for its results
    /** For scene_of_case(), including the folder. Many scenes at once would
     * need much memory. */
    std::vector<std::string> overrides;
  };

  /** Folder `PARENT/0012` of case @p n. */
  std::string numbered_folder(const std::string &parent, std::size_t n);

  /** The case of @p folder with @p values for the parameters @p paths. */
  SceneCase scene_case(const std::string              &folder,
                       const std::vector<std::string> &paths,
                       const std::vector<std::string> &values);

  /** How the computation of a case has ended. */
  struct CaseEnd
  {
    std::string failure;           ///< reason; empty: it is computed
    bool        is_reused = false; ///< an earlier run has computed it
    /** Whether the failure is a mistake in the input. */
    bool is_mistake = false;
  };

  /** Receives the end of case @p index; @p signal is not 0 if a signal has
   * interrupted it. */
  using CaseListener =
    std::function<void(std::size_t index, const CaseEnd &end, int signal)>;

  /**
   * Computes @p cases of @p scene, each in its folder and silently; skips those
   * that an earlier run has completed there. On several ranks they run side by
   * side if there are enough of them. Throws Interrupted. Collective.
   * @param listener receives the cases of the first rank
   */
  std::vector<CaseEnd> run_cases(const Scene                  &scene,
                                 const std::vector<SceneCase> &cases,
                                 MPI_Comm                      communicator,
                                 const FileRules              &rules,
                                 const CaseListener           &listener);

  /**
   * Numbers of the analysis in the @p summary of a run, in its order: names are
   * paths such as `effective_properties.constants.nu12`, with numbers from 1
   * for elements of lists.
   */
  NamedResults results_in(const Json &summary);

  /** Adds @p quantities in place of results of the same names. */
  void add_quantities(const NamedResults &quantities, NamedResults &results);

  /** The summary of the run in @p folder; null if it is missing or damaged. */
  Json summary_in(const std::string &folder);

  /** Results of a case. */
  struct CaseResults
  {
    NamedResults results; ///< of the summary, then Quantities
    std::string  verdict, exit_state;
  };

  /**
   * Results in the folder of @p one; none if its @p end is a failure, which is
   * then the exit state.
   */
  CaseResults
  results_of(const Scene &scene, const SceneCase &one, const CaseEnd &end);

  /** Names without their paths where they stay unique. */
  std::vector<std::string> short_names(const std::vector<std::string> &paths);

  /**
   * Positions in @p paths by name: each path, and the ends of it that no other
   * path has, e.g. `floor.y.peak_force` for
   * `evaluation.bodies.floor.y.peak_force`.
   */
  std::map<std::string, std::size_t>
  names_of_results(const std::vector<std::string> &paths);
} // namespace auxfem

#endif
