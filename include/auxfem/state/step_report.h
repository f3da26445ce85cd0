#ifndef auxfem_state_step_report_h
#define auxfem_state_step_report_h

#include <chrono>
#include <sstream>
#include <string>

namespace auxfem
{
  /** Adds the wall time of its lifetime (s) to a sum. */
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

  /**
   * Text of State::time = @p value: `t = 0.1 s` or, if @p on_path, `arc length
   * 0.1 m`.
   */
  inline std::string
  moment_text(const bool on_path, const double value, const int precision = 6)
  {
    std::ostringstream text;
    text.precision(precision);
    text << (on_path ? "arc length " : "t = ") << value
         << (on_path ? " m" : " s");
    return text.str();
  }

  /** Summary of one step, for the console, the log and the summary. */
  struct StepReport
  {
    unsigned int iterations = 0; ///< Newton iterations, retries included
    /** Number of accepted parts of the step. */
    unsigned int substeps = 0;
    unsigned int retries  = 0; ///< rejected steps
    /** Residual of the last iteration over the force scale. */
    double relative_residual = 0;
    double dt                = 0; ///< length of the shortest accepted part (s)
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
    double contact   = 0; ///< contact detection
    double output    = 0; ///< without checkpoints
    /** Writing checkpoints. */
    double checkpoints = 0;
  };

  /** Effort of a run so far, including its start. */
  struct Work
  {
    unsigned long steps = 0, iterations = 0, factorizations = 0, retries = 0;
    /** Residuals evaluated in line searches. */
    unsigned long shortened = 0;
    /** Solutions by all linear solvers, including checks at the start. */
    unsigned long linear_solutions = 0;
    /** Iterations of the iterative linear solver; 0 with direct ones. */
    unsigned long linear_iterations = 0;
    /**
     * Linear solver used last and the reason for its choice; empty before the
     * first factorization.
     */
    std::string linear_solver;
    PhaseTimes  wall;

    /** Adds the effort of another run, except its steps. */
    void add_effort(const Work &other);
  };
} // namespace auxfem

#endif
