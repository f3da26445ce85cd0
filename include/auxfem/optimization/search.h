#ifndef auxfem_optimization_search_h
#define auxfem_optimization_search_h

#include <auxfem/optimization/design_runs.h>
#include <auxfem/optimization/search_method.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A search for the best design. */
  struct SearchTask
  {
    DesignPoint  start;
    unsigned int objective = 0;
    /** Upper limit of the merit of the other objective. */
    std::optional<double> other_merit = {};
    /** Folder for numbered folders of its runs. */
    std::string folder = {};
  };

  /** Outcome of a search. */
  struct SearchResult
  {
    std::vector<Design> designs; ///< that it has run, in their order
    /** Whether it ended because of Optimization/Evaluations. */
    bool is_cut_short = false;
  };

  /**
   * Searches from the start of @p task with each method in turn, the next one
   * from the best design so far. A design without results counts as worse than
   * the worst one before. Throws Interrupted. Collective.
   * @param known designs that need no run
   */
  SearchResult run_search(const Scene               &scene,
                          const SearchTask          &task,
                          Goals                     &goals,
                          MPI_Comm                   communicator,
                          const FileRules           &rules,
                          const std::vector<Design> &known,
                          const DesignListener      &listener);

  /**
   * Runs searches, side by side if there are enough for the ranks; results are
   * the same for any number of ranks. Throws Interrupted. Collective.
   * @param listener receives the designs of the first rank
   */
  std::vector<SearchResult> run_searches(const Scene                   &scene,
                                         const std::vector<SearchTask> &tasks,
                                         Goals                         &goals,
                                         MPI_Comm         communicator,
                                         const FileRules &rules,
                                         const std::vector<Design> &known,
                                         const DesignListener      &listener);
} // namespace auxfem

#endif
