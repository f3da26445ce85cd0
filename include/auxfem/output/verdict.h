#ifndef auxfem_output_verdict_h
#define auxfem_output_verdict_h

#include <auxfem/equations/equations.h>
#include <auxfem/parameters/text.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/energies.h>

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

  /**
   * Judges a run by its energies: their balance, in both directions, and what
   * the time integration gives or takes, over the energy that came in
   * (doc/user/verdict.md).
   */
  class EnergyJudgement
  {
  public:
    /** What runs have energies for. */
    enum class Kind
    {
      motion,
      static_steps,
      static_path,
      reduced_cell
    };

    explicit EnergyJudgement(Kind kind);

    /** Of t = 0. */
    void start(const Energies &energies);

    /** Whether the balance at a state that is to be added asks for a finding,
     * unless it is round-off. */
    bool is_off(const Energies &energies) const;

    /**
     * Of an accepted state at @p time (s).
     * @param round_off of the balance (J)
     */
    void add(const Energies &energies, double time, double round_off = 0);

    std::vector<Finding> findings() const;

    void serialize(CheckpointArchive &archive);

  private:
    Finding error_finding(double moved) const;
    /** What to do about an error. */
    std::string advice() const;

    const Kind    kind;
    double        zero = 0, initial = 0, work = 0; ///< J
    LargestInTime error, given, taken;             ///< J
  };

  /**
   * What the user should know of a scene that is allowed, but may not be what
   * was meant: of the time scheme with rigid parts, functions of time
   * (time_function_notes()), sections too thick for their struts and, with
   * contact, struts that overlap at rest. A text each, for the screen and
   * summary.json.
   */
  std::vector<std::string> notes_on(const Equations &equations);
} // namespace auxfem

#endif
