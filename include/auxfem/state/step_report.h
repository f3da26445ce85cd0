#ifndef auxfem_state_step_report_h
#define auxfem_state_step_report_h

#include <chrono>
#include <sstream>
#include <string>

namespace auxfem
{
  /** Adds the wall time of its own life (s) to a sum. */
  class Stopwatch
  {
  public:
    explicit Stopwatch(double &sum)
      : sum(sum)
      , start(std::chrono::steady_clock::now())
    {}

    ~Stopwatch()
    {
      sum +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
          .count();
    }

    Stopwatch(const Stopwatch &)            = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    double                                     &sum;
    const std::chrono::steady_clock::time_point start;
  };

  /** Where State::time is @p value, in words: `t = 0.1 s`, if @p on_path, one of
   * equilibria, `arc length 0.1 m`. */
  inline std::string
  moment_text(const bool on_path, const double value, const int precision = 6)
  {
    std::ostringstream text;
    text.precision(precision);
    text << (on_path ? "arc length " : "t = ") << value
         << (on_path ? " m" : " s");
    return text.str();
  }

  /** What happened in one step, for the console, the log and the summary. */
  struct StepReport
  {
    unsigned int iterations = 0; ///< Newton iterations, retries included
    /** Accepted parts the step was divided into. */
    unsigned int substeps = 0;
    unsigned int retries  = 0; ///< rejected steps
    /** Of the last iteration, in units of the force scale. */
    double relative_residual = 0;
    double dt                = 0; ///< length of the smallest accepted part (s)
  };

  /** Wall seconds by phase. */
  struct PhaseTimes
  {
    /** Reading, mesh, numbering, pattern; without the phases below. */
    double setup     = 0;
    double residual  = 0; ///< assembly of residuals
    double tangent   = 0; ///< assembly of tangents
    double factorize = 0;
    double solve     = 0;
    double contact   = 0; ///< search for what comes near, or passes
    double output    = 0; ///< without checkpoints
    /** Writing checkpoints. */
    double checkpoints = 0;
  };

  /** All that a run has done so far, its start included. */
  struct Work
  {
    unsigned long steps = 0, iterations = 0, factorizations = 0, retries = 0;
    /** Residuals of shortened increments, beside one an iteration. */
    unsigned long shortened = 0;
    /** By all linear solvers, those of checks at the start included. */
    unsigned long linear_solutions = 0;
    /** Of the iterative linear solver; 0 with direct ones. */
    unsigned long linear_iterations = 0;
    /** What solved the linear equations last, and why that was chosen; empty if
     * nothing was factorized. */
    std::string linear_solver;
    PhaseTimes  wall;

    /** Adds all that another run has done, but for its steps. */
    void add_effort(const Work &other);
  };
} // namespace auxfem

#endif
