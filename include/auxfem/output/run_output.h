#ifndef auxfem_output_run_output_h
#define auxfem_output_run_output_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/summary.h>
#include <auxfem/scene/scene.h>
#include <auxfem/time/step_report.h>

#include <memory>

namespace auxfem
{
  /**
   * Everything a run leaves behind, in one folder: parameters.prm,
   * original.prm, log.txt, history.csv, solution.pvd, rigid_parts.pvd and
   * connectors.pvd with their series (of what the scene has), summary.json,
   * checkpoints.
   * Also the lines on the screen. Rows are on disk as soon as they are written;
   * what was computed before a failure stays readable.
   *
   * Results of an earlier run in the same folder are removed in begin() (files
   * of these names only), so that what is there belongs together.
   */
  class RunOutput : public Recorder
  {
  public:
    /**
     * The wall time of the summary starts here; nothing is written before
     * begin(), so that a scene found wrong during set-up costs no results.
     * @param scene must outlive the object.
     * @param communicator all ranks take part in every call.
     * @param start of this rank, for the summary.
     * @param rules files that the scene was read from are always spared.
     * @param goes_on_from checkpoint of a run that has ended in the same
     *   folder, whose results are continued
     */
    RunOutput(const Scene           &scene,
              MPI_Comm               communicator,
              const StartTimes      &start        = StartTimes(),
              const FileRules       &rules        = FileRules(),
              std::optional<Records> goes_on_from = {});
    ~RunOutput() override;

    /** A progress line on the screen. */
    void search_step(const Scene      &search,
                     const State      &state,
                     const StepReport &report) override;

    /**
     * Makes the folder, prints and logs counts and what is simulated and left
     * out, starts the history. Throws InputError for a probe whose joints do
     * not exist, and if the folder cannot be written to.
     */
    void begin(const Equations &equations) override;

    /** Rows and files for the solution at t = 0. */
    void start(const Solution &solution) override;

    /** The one given, until a run has gone on from it. */
    const Records *goes_on_from() const override;

    bool keeps_checkpoints() const override;
    bool wants_checkpoint() override;
    void take(const Records &checkpoint) override;

    /**
     * Rows and files follow those that were there when @p records were saved;
     * later ones are removed.
     */
    void resume(const Solution &solution, const Records &records) override;

    void save(Records &records) const override;

    /** When a row or graphics are due that do not go by steps. */
    std::optional<double> next_time(double time) const override;

    /** Writes these. Throws ComputationError if the disk takes no more. */
    void between(const Solution &solution) override;

    /**
     * A finished step: progress line; history row if rows go by steps. Throws
     * ComputationError if the disk takes no more.
     */
    void singular_point(const Solution      &solution,
                        const SingularPoint &point) override;
    void step(const Solution &solution, const StepReport &report) override;

    /** Closes the run: last row and graphics, summary.json. */
    void finish(const Solution &last, const RunResult &result) override;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation;
  };

  /** Prints what RunOutput::begin() prints, and writes nothing. Collective. */
  void print_overview(const Scene &scene, const Equations &equations);
} // namespace auxfem

#endif
