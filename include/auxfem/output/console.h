#ifndef auxfem_output_console_h
#define auxfem_output_console_h

#include <auxfem/equations/equations.h>
#include <auxfem/model/mass_and_size.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/verdict.h>
#include <auxfem/state/state.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>

namespace auxfem
{
  /** Progress of a run, for one line. */
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

    /** Error of the energy balance over the largest energy so far, if known. */
    std::optional<double> relative_balance;

    double seconds = 0; ///< wall time since the first step was begun (s)
    /** Start time of the first step (s); not 0 in a resumed run. */
    double begin_time = 0;

    /**
     * Position on a path of equilibria. Then `time` is the arc length (m) and
     * the number of steps an upper bound.
     */
    std::optional<PathPosition> path;

    /** Completed fraction of the time, in [0, 1]. */
    double fraction() const
    {
      return end_time > 0 ? std::min(1., std::max(0., time / end_time)) : 1;
    }
  };

  /**
   * @p text in indented lines that fit a screen, without the final line break.
   */
  std::string indented(const std::string &text);

  /**
   * One line of fewer than 100 characters: step, time, time step, iterations,
   * residual, energy balance, remaining time. On a path, load factor and number
   * of negative eigenvalues replace times.
   */
  std::string format_progress(const Progress &progress);

  /** Duration as `0:07`, `12:30` or `3:05:00` (hours from one hour on). */
  std::string format_duration(double seconds);

  /**
   * Width of the terminal in characters; 0 if standard output is no terminal or
   * there are several processes.
   */
  unsigned int terminal_width(unsigned int n_processes);

  /**
   * Screen and log of a run, on one rank. On a terminal, one progress line is
   * rewritten at most ten times a second. Otherwise and in the log, there is a
   * plain line for each twentieth of the time, or each tenth point of a path.
   * The log also lists every repeated step.
   */
  class Console
  {
  public:
    /**
     * @param screen, log must outlive the console
     * @param terminal_width width of @p screen, see terminal_width(); 0: it is
     *   no terminal
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
     * Replaces the progress line of a terminal by @p text, at most ten times a
     * second; does nothing otherwise.
     */
    void show(const std::string &text);

    /** Shows and logs the progress of a finished step if it is due. */
    void progress(const Progress &progress);

    /** Shows and logs the latest progress, unless that was done. */
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
    int                     last_twentieth   = -1;
    double                  last_rewrite     = 0;
    double                  last_show        = 0;
    /** Length of the open progress line. */
    std::size_t line_length = 0;
  };

  /**
   * Folder, log and screen of an analysis without time history, which has no
   * Recorder.
   */
  class RunReport
  {
  public:
    /**
     * Makes the folder and prints the overview. Throws as RunFolder.
     * Collective.
     * @param scene must outlive the object
     */
    RunReport(const Scene          &scene,
              const Equations      &equations,
              const FileRules      &rules,
              const FolderContents &further);

    /** @name On the first rank. */
    ///@{
    void print(const std::string &text);
    void claim_series(const std::vector<std::string> &names);

    /**
     * Writes summary.json with @p found; prints the folder of the results and
     * the verdict.
     */
    void finish(const Json &found, const std::vector<Finding> &findings);
    ///@}

  private:
    const Scene                   &scene;
    MassAndSize                    size;
    const std::vector<std::string> notes;
    std::optional<RunFolder>       files;   ///< on rank 0
    std::optional<Console>         console; ///< on rank 0
  };
} // namespace auxfem

#endif
