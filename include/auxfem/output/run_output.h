#ifndef auxfem_output_run_output_h
#define auxfem_output_run_output_h

#include <auxfem/output/summary.h>
#include <auxfem/parameters/scene.h>
#include <auxfem/system/system.h>
#include <auxfem/time/step_report.h>

#include <memory>

namespace auxfem
{
  /**
   * Everything a run leaves behind, in one folder: parameters.prm,
   * original.prm, log.txt, history.csv, solution.pvd, rigid_parts.pvd and
   * connectors.pvd with their series (of what the scene has), summary.json.
   * Also the lines on the screen. Rows are on disk as soon as they are written;
   * what was computed before a failure stays readable.
   *
   * Results of an earlier run in the same folder are removed in begin() (files
   * of these names only), so that what is there belongs together.
   */
  class RunOutput
  {
  public:
    /**
     * The wall time of the summary starts here; nothing is written before
     * begin(), so that a scene found wrong during set-up costs no results.
     * @param scene must outlive the object.
     * @param communicator all ranks take part in every call.
     * @param start of this rank, for the summary.
     */
    RunOutput(const Scene      &scene,
              MPI_Comm          communicator,
              const StartTimes &start = StartTimes());
    ~RunOutput();

    /**
     * Makes the folder, prints and logs counts and what is simulated and left
     * out, starts the history. Throws InputError for a probe whose joints do
     * not exist, and if the folder cannot be written to.
     */
    void begin(const System &system);

    /** Rows and files for the state at t = 0. */
    void write_start(const State &state);

    /**
     * A finished step: progress line; history row and graphics when due.
     * @p state must be the last given to System::residual(). Throws
     * ComputationError if the disk takes no more.
     */
    void write_step(const State &state, const StepReport &report);

    /**
     * Closes the run: last graphics, summary.json. @p exit_state is `completed`
     * or the reason it was not; @p totals what run() counted.
     *
     * After a failure @p state is the last accepted one, but connectors and
     * energies know the failed trial: then the struts are drawn, and the
     * history ends with the row last due.
     */
    void finish(const System      &system,
                const State       &state,
                const RunTotals   &totals,
                const std::string &exit_state);

    /** The folder. */
    const std::string &folder() const;

    /** Wall seconds spent writing so far. */
    double seconds() const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation;
  };

  /** Prints what RunOutput::begin() prints, and writes nothing. Collective. */
  void print_overview(const Scene &scene, const System &system);
} // namespace auxfem

#endif
