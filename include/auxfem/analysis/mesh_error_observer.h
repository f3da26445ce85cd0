#ifndef auxfem_analysis_mesh_error_observer_h
#define auxfem_analysis_mesh_error_observer_h

#include <auxfem/analysis/mesh_error.h>
#include <auxfem/output/recorder.h>

namespace auxfem
{
  /** Elements of the struts that the program has chosen for a run of a scene,
   * and how it has found them. */
  struct ChosenElements
  {
    /** By strut; empty: all have common_division() of the scene. */
    std::vector<StrutDivision> divisions;
    OrderReport                report;

    /** @name For runs that are resumed. */
    ///@{
    void                  save(Records &records) const;
    static ChosenElements saved(const Records &records);
    ///@}
  };

  /** Wave number times length of the first bending mode between clamped ends.
   */
  inline constexpr double clamped_phase = 4.73004074;

  /** Angular frequencies (rad/s) of the first bending modes of all elastic
   * struts with a mass between clamped ends. */
  std::vector<double> own_frequencies(const Lattice              &lattice,
                                      const std::vector<Section> &sections);

  /** Estimates the error of the elements of a run at instants in equal
   * distances. */
  class MeshErrorObserver
  {
  public:
    /**
     * @param scene, model must outlive the object
     * @param report what is known of the choice before the run
     */
    MeshErrorObserver(const Scene        &scene,
                      const LatticeModel &model,
                      const OrderReport  &report);

    const MeshError &error() const
    {
      return estimate;
    }

    /** The state at t = 0. */
    void start(const State &state);
    /** The state after a step of the scene. */
    void step(const State &state, const StepReport &report);

    /** Adds what was found out about the elements. Collective. */
    void add_to(RunResult &result) const;

    /** @name For runs that are resumed. */
    ///@{
    void save(Records &records) const;
    void resume(const Records &records);
    ///@}

  private:
    /**
     * Struts that vibrate by themselves, as far as steps until @p time (s) can
     * tell: the first bending mode between clamped ends turns by less than one
     * radian in a step of mean length, or a stage of it. Errors of
     * accelerations inside struts and of such frequencies add up over the time,
     * of which estimates at an instant know nothing.
     */
    unsigned int n_vibrating(double time) const;

    const double      distance;      ///< of instants (s)
    const double      parts_of_step; ///< stages, each of which follows a motion
    const OrderReport report;
    MeshError         estimate;
    const MPI_Comm    communicator;
    /** Since when an instant is due (s). */
    double next = 0, seconds = 0;
    /** Of struts (rad/s); none without inertia. */
    std::vector<double> frequencies;
    double              n_parts = 0; ///< of steps so far
  };
} // namespace auxfem

#endif
