#ifndef auxfem_analysis_discretization_order_choice_h
#define auxfem_analysis_discretization_order_choice_h

#include <auxfem/output/recorder.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/struts/effects/clamped_strut_problems.h>

namespace auxfem
{
  /**
   * Estimates the error of the elements in the motion of the joints, strut by
   * strut, at sampled instants.
   *
   * Each strut is solved again with clamped ends and unchanged acceleration,
   * on elements of half the length and one order higher. The change r_s of its
   * end forces is the imbalance of the joints. They move by e = K^-1 sum r_s
   * with the stiffness K of the lattice. With the stiffness K_s of a single
   * strut,
   *
   *     e.K e <= sum r_s.K_s^+ r_s.
   *
   * The sum over struts thus bounds the squared error in the energy norm, as
   * long as K is that of small motions.
   */
  class MeshError
  {
  public:
    /** @param model must outlive the object. */
    explicit MeshError(const LatticeModel &model);

    /** Samples an instant. Collective. */
    void sample(const State &state);

    /**
     * Largest error at one instant over the largest motion so far, both in the
     * energy norm.
     */
    double relative() const;

    /** Twice the largest strain energy so far (J). */
    double largest_energy() const
    {
      return energy;
    }

    /** Struts counted by this rank. */
    const std::vector<unsigned int> &struts() const
    {
      return same.struts();
    }

    /** For each of struts(), the motion with its largest error. */
    const std::vector<StrutMotion> &critical_motions() const
    {
      return motions;
    }

    void serialize(CheckpointArchive &archive);

  private:
    const LatticeModel       &model;
    ClampedStrutProblems      same, finer;
    std::vector<unsigned int> first_elements; ///< in the model, by struts()
    std::vector<double>       largest;        ///< errors (J), by struts()
    std::vector<StrutMotion>  motions;
    /** Largest sum of the errors; twice the largest strain energy (J). */
    double error = 0, energy = 0;
  };

  /**
   * Errors (J, squared energy norm) of struts with other elements; not finite
   * where the problem cannot be solved.
   * @param seen motions of the ends
   * @param which struts, by their numbers in MeshError::struts()
   */
  std::vector<double> division_errors(const LatticeModel              &model,
                                      const MeshError                 &seen,
                                      const std::vector<unsigned int> &which,
                                      StrutDivision division);

  /**
   * Part of the tolerance that chosen elements aim at; their error is
   * estimated from another motion than that of the run.
   * @tuned judgement: estimates are good to a factor of two
   */
  inline constexpr double element_tolerance_fraction = 0.5;

  /** Number of instants of a run at which the element error is estimated. */
  inline constexpr unsigned int n_mesh_error_samples = 64;

  /**
   * Wave number times length of the first bending mode between clamped ends.
   */
  inline constexpr double clamped_phase = 4.73004074;

  /**
   * Angular frequencies (rad/s) of the first bending modes, between clamped
   * ends, of all elastic struts with mass.
   */
  std::vector<double> clamped_frequencies(const Lattice              &lattice,
                                          const std::vector<Section> &sections);

  /** Estimates the element error of a run at equidistant instants. */
  class MeshErrorObserver
  {
  public:
    /**
     * @param model must outlive the object
     * @param report of the element choice before the run
     */
    MeshErrorObserver(const LatticeModel &model, const OrderReport &report);

    const MeshError &error() const
    {
      return estimate;
    }

    /** Samples the state at t = 0. */
    void start(const State &state);
    /** Samples the state after a step of the scene, if it is due. */
    void step(const State &state, const StepReport &report);

    /** Adds findings about the elements. Collective. */
    void add_to(RunResult &result) const;

    void serialize(CheckpointArchive &archive);

  private:
    /**
     * Number of struts whose own vibrations the steps until @p time (s)
     * resolve: the first clamped bending mode turns by less than one radian
     * per mean step or stage. Their errors of frequency accumulate over time,
     * which estimates at instants cannot detect.
     */
    unsigned int n_vibrating(double time) const;

    const double      distance;      ///< between instants (s)
    const double      parts_of_step; ///< stages that each resolve the motion
    const OrderReport report;
    MeshError         estimate;
    const MPI_Comm    communicator;
    /** Next instant that is due (s); effort so far (s). */
    double next = 0, seconds = 0;
    /** Natural angular frequencies of struts (rad/s); none without inertia. */
    std::vector<double> frequencies;
    double              n_parts = 0; ///< steps or stages so far
  };

  /**
   * Chooses order and number of elements, strut by strut: the estimated errors
   * add up to at most `Discretization/Tolerance`, with as few unknowns as
   * possible. If that is impossible, takes the best available elements. The
   * motion is that of a search run with one order and fewer steps, reported to
   * @p recorder; if its error is large, a further search uses the chosen
   * elements. Collective. Throws InputError for a probe whose joints do not
   * exist.
   */
  ChosenElements choose_elements(const RunPlan &plan,
                                 MPI_Comm       communicator,
                                 Recorder      &recorder);
} // namespace auxfem

#endif
