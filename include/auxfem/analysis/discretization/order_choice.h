#ifndef auxfem_analysis_discretization_order_choice_h
#define auxfem_analysis_discretization_order_choice_h

#include <auxfem/output/recorder.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/struts/effects/clamped_strut_problems.h>

namespace auxfem
{
  /**
   * Error that the elements of a run make in the motion of the joints,
   * estimated strut by strut at instants of it.
   *
   * Each strut is solved again with its ends held and its acceleration kept, on
   * elements of half the length and one order more. By how much this changes
   * the forces r_s on its ends is what the joints are out of equilibrium by:
   * they move by e = K^-1 sum r_s, K being the stiffness of the lattice. With
   * the stiffness K_s of a strut alone,
   *
   *     e.K e <= sum r_s.K_s^+ r_s,
   *
   * (the energy of a sum of loads on a sum of springs), so what is added up
   * strut by strut is no less than the square of the error in the energy norm,
   * as long as K is that of small motions.
   */
  class MeshError
  {
  public:
    /** @param model must outlive the object. */
    explicit MeshError(const LatticeModel &model);

    /** Looks at an instant. Collective. */
    void look(const State &state);

    /**
     * Largest error at one instant in the energy norm, relative to that of the
     * largest motion so far.
     */
    double relative() const;

    /** Twice the largest strain energy so far (J). */
    double largest_energy() const
    {
      return energy;
    }

    /** The struts that this rank counts. */
    const std::vector<unsigned int> &struts() const
    {
      return same.struts();
    }

    /** Of each of struts(), the motion in which its error was largest. */
    const std::vector<StrutMotion> &critical_motions() const
    {
      return motions;
    }

    void serialize(CheckpointArchive &archive);

  private:
    const LatticeModel       &model;
    ClampedStrutProblems      same, finer;
    std::vector<unsigned int> first_elements; ///< of the model, by struts()
    std::vector<double>       largest;        ///< errors (J), by struts()
    std::vector<StrutMotion>  motions;
    /** Largest sum of the errors, twice the largest strain energy (J). */
    double error = 0, energy = 0;
  };

  /**
   * Errors (J, as the square of the energy norm) that struts would have with
   * other elements.
   *
   * @param seen the motions that their ends have; errors are not finite where
   *   they are not
   * @param which struts, by their numbers in MeshError::struts()
   */
  std::vector<double> division_errors(const LatticeModel              &model,
                                      const MeshError                 &seen,
                                      const std::vector<unsigned int> &which,
                                      StrutDivision division);

  /**
   * Part of the tolerance that chosen elements aim at: their error is known
   * by an estimate, from another motion than that of the run.
   * @tuned judgement: estimates are good to a factor of two
   */
  inline constexpr double part_of_tolerance_for_elements = 0.5;

  /**
   * Instants of a run at which the error of its elements is estimated.
   */
  inline constexpr unsigned int n_mesh_error_samples = 64;

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
     * @param model must outlive the object
     * @param report what is known of the choice before the run
     */
    MeshErrorObserver(const LatticeModel &model, const OrderReport &report);

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

    void serialize(CheckpointArchive &archive);

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
    /** Natural angular frequencies of struts (rad/s); none without inertia. */
    std::vector<double> frequencies;
    double              n_parts = 0; ///< of steps so far
  };

  /**
   * Orders and numbers of elements, strut by strut, with which the estimated
   * errors of all struts add up to no more than `Discretization/Tolerance`, and
   * as few unknowns as possible; what comes nearest where none are enough. The
   * motion that asks for them is that of a search run: the scene with one order
   * for all struts and fewer steps, which @p recorder is told of. Where the
   * errors of that are large, a second one has what the first found.
   * Collective. Throws InputError for a probe whose joints do not exist.
   */
  ChosenElements choose_elements(const RunPlan &plan,
                                 MPI_Comm       communicator,
                                 Recorder      &recorder);
} // namespace auxfem

#endif
