#ifndef auxfem_analysis_mesh_error_recorder_h
#define auxfem_analysis_mesh_error_recorder_h

#include <auxfem/analysis/mesh_error.h>
#include <auxfem/output/order_report.h>
#include <auxfem/output/recorder.h>

namespace auxfem
{
  /** Wave number times length of the first bending mode between clamped ends.
   */
  inline constexpr double clamped_phase = 4.73004074;

  /** Angular frequencies (rad/s) of the first bending modes of all elastic
   * struts with a mass between clamped ends. */
  std::vector<double> own_frequencies(const Lattice              &lattice,
                                      const std::vector<Section> &sections);

  /**
   * Tells another recorder all that it is told, and estimates the error of the
   * elements at instants in equal distances over the run.
   */
  class MeshErrorRecorder : public ForwardingRecorder
  {
  public:
    /**
     * @param scene, recorder must outlive the object.
     * @param report what is known of the choice before the run
     */
    MeshErrorRecorder(const Scene       &scene,
                      Recorder          &recorder,
                      const OrderReport &report = {});

    /** What was found; nullptr before the run has begun. */
    const MeshError *error() const
    {
      return estimate.get();
    }

    /** @p result with what was found out about the elements. */
    RunResult completed(RunResult result) const;

    void begin(const Equations &equations) override;
    void start(const Solution &solution) override;
    void resume(const Solution &solution, const Records &records) override;
    void save(Records &records) const override;
    void step(const Solution &solution, const StepReport &report) override;
    void finish(const Solution &last, const RunResult &result) override;

  private:
    void look(const State &state);

    /**
     * Struts that vibrate by themselves, as far as steps until @p time (s) can
     * tell: the first bending mode between clamped ends turns by less than one
     * radian in a step of mean length, or a stage of it. Errors of
     * accelerations inside struts and of such frequencies add up over the time,
     * of which estimates at an instant know nothing.
     */
    unsigned int n_vibrating(double time) const;

    const Scene               &scene;
    OrderReport                report;
    std::unique_ptr<MeshError> estimate;
    /** Since when no look is due (s). */
    double   next = 0, seconds = 0;
    MPI_Comm communicator = MPI_COMM_NULL;
    /** Of struts (rad/s); none without inertia. */
    std::vector<double> frequencies;
    double              n_parts = 0; ///< of steps so far, stages included
  };
} // namespace auxfem

#endif
