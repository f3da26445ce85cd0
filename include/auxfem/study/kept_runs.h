#ifndef auxfem_study_kept_runs_h
#define auxfem_study_kept_runs_h

#include <auxfem/study/measured_run.h>

#include <optional>
#include <string>

namespace auxfem
{
  /**
   * All that the result of a simulation of @p scene on @p n_ranks ranks depends
   * on: program, parameters, files that are read. Output, Study and Quantities
   * do not belong to it.
   */
  std::string key_of(const Scene &scene, unsigned int n_ranks);

  /** The run of @p key in @p folder, unless it was never finished there or is
   * not readable. */
  std::optional<MeasuredRun> kept_run(const std::string &folder,
                                      const std::string &key);

  /**
   * Writes @p run, in one move, to where kept_run() finds it. Throws
   * ComputationError if it cannot.
   */
  void keep_run(const std::string &folder,
                const std::string &key,
                const MeasuredRun &run);
} // namespace auxfem

#endif
