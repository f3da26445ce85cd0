#ifndef auxfem_output_verdict_h
#define auxfem_output_verdict_h

#include <auxfem/parameters/json.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** How far the results of a run can be relied on, from good to bad. */
  enum class Verdict
  {
    sound,
    doubtful,
    not_to_be_used
  };

  /** Something a run has found out about its own results. */
  struct Finding
  {
    Verdict     verdict;  ///< what it alone makes of the run
    std::string text;     ///< a sentence or two, with what to do
    double      time;     ///< s, since when, or when it was worst
    std::string location; ///< e.g. `joint 3`; empty if it is everywhere
  };

  /** That a run has ended at @p time (s) before its first step was done. */
  Finding nothing_computed(double time);

  /** That a run has ended at @p time (s) before its end, by a signal or a
   * failure. */
  Finding incomplete(double time);

  /** The worst of @p findings; sound without any. */
  Verdict verdict_of(const std::vector<Finding> &findings);

  /** `sound`, `doubtful`, `not to be used`. */
  const std::string &name_of(Verdict verdict);

  /** Adds `verdict` and `warnings`, with time and location, to @p summary. */
  void add_verdict(Json &summary, const std::vector<Finding> &findings);

  /** The verdict and its reasons, lines without the last line break. */
  std::string verdict_text(const std::vector<Finding> &findings);
} // namespace auxfem

#endif
