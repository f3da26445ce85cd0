#ifndef auxfem_output_console_h
#define auxfem_output_console_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/verdict.h>
#include <auxfem/state/state.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>

namespace auxfem
{
  /** How far a run has come, for one line. */
  struct Progress
  {
    unsigned long step     = 0;
    unsigned long n_steps  = 0; ///< expected in all
    double        time     = 0; ///< s
    double        end_time = 0; ///< s
    double        dt       = 0; ///< s

    unsigned int iterations        = 0;
    unsigned int retries           = 0;
    double       relative_residual = 0;

    /** Error of the energy balance over the largest energy so far, where known.
     */
    std::optional<double> relative_balance;

    double seconds = 0; ///< wall time since the first step was begun (s)
    /** Time (s) the first step began at; not 0 in a run that was resumed. */
    double begin_time = 0;

    /** On a path of equilibria, of which `time` is the arc length (m) and the
     * number of steps the largest possible. */
    std::optional<PathPosition> path;

    /** Part of the time that is done, in [0, 1]. */
    double fraction() const
    {
      return end_time > 0 ? std::min(1., std::max(0., time / end_time)) : 1;
    }
  };

  /** @p text in indented lines that fit on a screen, without the last line
   * break. */
  std::string indented(const std::string &text);

  /**
   * One line of fewer than 100 characters: step, time, time step, iterations,
   * residual, energy balance, time left; on a path load factor and number of
   * negative eigenvalues in place of times.
   */
  std::string format_progress(const Progress &progress);

  /**
   * A time such as `0:07`, `12:30`, `3:05:00` (minutes and seconds; from one
   * hour on with hours).
   */
  std::string format_duration(double seconds);

  /**
   * Characters a line of standard output holds; 0 if that is not the terminal
   * of a program of one process.
   */
  unsigned int terminal_width(unsigned int n_processes);

  /**
   * Screen and log of a run. On a terminal the progress is one line rewritten
   * in place, at most ten times a second; else it is a plain line for each
   * twentieth of the time, on a path for each tenth point. The log has those
   * plain lines in both cases, and every step that had to be repeated. To be
   * made on one rank only.
   */
  class Console
  {
  public:
    /**
     * @param screen where lines are shown.
     * @param terminal_width characters a line of @p screen holds if it is a
     *   terminal, see terminal_width(); 0 if it is none.
     * @param log the log; both streams must outlive the console.
     */
    Console(std::ostream &screen,
            unsigned int  terminal_width,
            std::ostream &log);

    /** Ends a progress line that is still open. */
    ~Console();

    Console(const Console &)            = delete;
    Console &operator=(const Console &) = delete;

    /** Shows and logs @p text, adding a line break. */
    void print(const std::string &text);

    /** Logs @p text, adding a line break. */
    void print_to_log(const std::string &text);

    /**
     * Shows @p text in place of the former one where the screen is a terminal,
     * at most ten times a second; else and in the log it is left out.
     */
    void show(const std::string &text);

    /** Shows and logs the progress of a finished step if it is time to. */
    void progress(const Progress &progress);

    /** Shows and logs the progress last given, unless that was done. */
    void end_progress();

  private:
    void rewrite(const std::string &text);
    void close_line();

    std::ostream      &screen;
    std::ostream      &log;
    const unsigned int terminal_width;

    std::optional<Progress> latest;
    bool                    latest_on_screen = true;
    bool                    latest_in_log    = true;
    int                     twentieth        = -1;
    double                  last_rewrite     = 0;
    double                  last_show        = 0;
    /** Of the open progress line. */
    std::size_t line_length = 0;
  };

  /**
   * Folder, log and screen of a run that tells no Recorder, as its questions
   * have no course in time.
   */
  class RunReport
  {
  public:
    /** Makes the folder and prints the overview. @p scene must outlive the
     * object. Throws as RunFolder. Collective. */
    RunReport(const Scene          &scene,
              const Equations      &equations,
              const FileRules      &rules,
              const FolderContents &further);

    /** @name On the first rank. */
    ///@{
    void print(const std::string &text);
    void claim_series(const std::vector<std::string> &names);

    /** Writes summary.json with @p found, prints where results are, and the
     * verdict. */
    void finish(const Json &found, const std::vector<Finding> &findings);
    ///@}

  private:
    const Scene                   &scene;
    const std::vector<std::string> notes;
    std::optional<RunFolder>       files;   ///< on rank 0
    std::optional<Console>         console; ///< on rank 0
  };
} // namespace auxfem

#endif
