#ifndef auxfem_output_verdict_h
#define auxfem_output_verdict_h

#include <auxfem/parameters/text.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/energies.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Relative error above which a result is doubtful.
   * @tuned judgement: 8 steps a period with the trapezoidal rule
   */
  inline constexpr double doubtful_error = 0.05;

  /**
   * Relative error above which a result is not to be used.
   * @tuned judgement: 3.6 steps a period with the trapezoidal rule
   */
  inline constexpr double unusable_error = 0.25;

  /** Reliability of the results of a run, from good to bad. */
  enum class Verdict
  {
    sound,
    doubtful,
    not_to_be_used
  };

  /** A finding of a run on its own results. */
  struct Finding
  {
    Verdict     verdict;  ///< verdict on the run from this finding alone
    std::string text;     ///< one or two sentences with advice
    double      time;     ///< begin or maximum (s)
    std::string location; ///< e.g. `joint 3`; empty: everywhere
  };

  /**
   * Finding: the run has ended at @p time (s) before the end of its first step.
   */
  Finding nothing_computed(double time);

  /** Finding: a signal or a failure has ended the run early at @p time (s). */
  Finding incomplete(double time);

  /** Worst verdict of @p findings; sound without any. */
  Verdict verdict_of(const std::vector<Finding> &findings);

  /** `sound`, `doubtful`, `not to be used`. */
  const std::string &name_of(Verdict verdict);

  /** Adds `verdict` and `warnings`, with time and location, to @p summary. */
  void add_verdict(Json &summary, const std::vector<Finding> &findings);

  /** The verdict and its reasons, lines without the last line break. */
  std::string verdict_text(const std::vector<Finding> &findings);

  /**
   * Judges a run by the error of its energy balance and by energy gained or
   * lost by the time integration, relative to the energy input
   * (doc/user/verdict.md).
   */
  class EnergyJudgement
  {
  public:
    /** Kind of run. */
    enum class Kind
    {
      motion,
      static_steps,
      static_path,
      reduced_cell
    };

    explicit EnergyJudgement(Kind kind);

    /** Starts with the energies at t = 0. */
    void start(const Energies &energies);

    /**
     * Whether the balance of a state, before it is added, is beyond the limit
     * of a finding, if it is not round-off.
     */
    bool exceeds_balance_limit(const Energies &energies) const;

    /**
     * Adds an accepted state at @p time (s).
     * @param round_off round-off of the balance (J)
     */
    void add(const Energies &energies, double time, double round_off = 0);

    std::vector<Finding> findings() const;

    void serialize(CheckpointArchive &archive);

  private:
    Finding error_finding(double energy_input) const;
    /** Advice against an error. */
    std::string advice() const;

    const Kind    kind;
    double        zero = 0, initial = 0, work = 0; ///< J
    LargestInTime error, energy_gain, energy_loss; ///< J
  };
} // namespace auxfem

#endif
