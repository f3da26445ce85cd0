#ifndef auxfem_time_step_report_h
#define auxfem_time_step_report_h

namespace auxfem
{
  /** What happened in one step, for the console, the log and the summary. */
  struct StepReport
  {
    unsigned int iterations     = 0; ///< Newton iterations, retries included
    unsigned int factorizations = 0;
    /** Of the iterative linear solver; 0 with direct ones. */
    unsigned int linear_iterations = 0;
    /** Accepted parts the step was divided into. */
    unsigned int substeps = 1;
    unsigned int retries  = 0; ///< attempts that were undone
    /** Of the last iteration, in units of the force scale. */
    double relative_residual = 0;
    double dt                = 0; ///< length of the smallest accepted part (s)
  };

  /** Wall seconds by phase since the start of the run. */
  struct PhaseTimes
  {
    double setup     = 0; ///< reading, mesh, numbering, pattern
    double residual  = 0; ///< assembly of residuals
    double tangent   = 0; ///< assembly of tangents
    double factorize = 0;
    double solve     = 0;
    double output    = 0;
  };
} // namespace auxfem

#endif
