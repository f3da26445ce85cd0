#ifndef auxfem_analysis_small_motions_mesh_error_estimate_h
#define auxfem_analysis_small_motions_mesh_error_estimate_h

#include <auxfem/analysis/simulation/lattice_run.h>

namespace auxfem
{
  /**
   * Discretization errors of the values that an analysis of small motions
   * reports, estimated by comparison with finer elements.
   */
  struct MeshErrors
  {
    /** Relative error of each value; not finite if unknown. */
    std::vector<double> relative;
    /**
     * Number of modes of the finer elements below the last one that the coarse
     * elements miss.
     */
    unsigned long n_missing = 0;
    /** Whether too few modes were found and finer elements have more. */
    bool has_too_few = false;
    /** Reason for a missing comparison; empty if there is one. */
    std::string unknown_reason = {};

    /** Largest relative error; infinite if one is unknown. */
    double largest() const;
  };

  /**
   * Upper bound of the phase (rad) along a strut of the highest of the @p n
   * lowest modes, from clamped joints, which raise all frequencies.
   */
  double phase_of_modes(const Scene &scene, unsigned int n);

  /**
   * Phase (rad) along a strut of the highest of the @p n lowest buckling modes,
   * for equally loaded struts between clamped joints.
   */
  double phase_of_buckling(const Scene &scene, unsigned int n);

  /**
   * Phase (rad) of bending waves at the angular frequency @p omega (rad/s)
   * along the strut with the shortest waves.
   */
  double phase_at(const Scene &scene, double omega);

  /**
   * Gives all struts of @p plan the fewest unknowns for which waves have the
   * relative error @p tolerance. The dispersion error of order p is (p! / (2
   * p)!)^2 / (2 p + 1) (phase of an element)^(2 p) (Ainsworth 2004).
   * @param phase phase of the shortest wave along a strut (rad)
   */
  void choose_elements(double phase, double tolerance, RunPlan &plan);

  /**
   * Gives all struts of @p plan more unknowns, so that @p errors meet its
   * tolerance if they follow that dispersion. Returns false if there are no
   * such elements.
   * @param first plan with the elements chosen first
   */
  bool refine_elements(const RunPlan    &first,
                       const MeshErrors &errors,
                       RunPlan          &plan);

  /** The plan of a comparison: twice as many elements, of the next order. */
  RunPlan with_finer_elements(RunPlan plan);

  /**
   * Whether @p errors meet the tolerance of @p scene, or the user prescribes
   * the elements.
   */
  bool elements_accepted(const Scene &scene, const MeshErrors &errors);

  /**
   * Findings on the elements of @p plan.
   * @param values name of the values with errors, e.g. `natural frequencies`
   */
  std::vector<Finding> mesh_findings(const RunPlan     &plan,
                                     const MeshErrors  &errors,
                                     const std::string &values);

  /** Line on elements and errors, without the final line break. */
  std::string mesh_text(const RunPlan &plan, const MeshErrors &errors);

  /** Elements and errors for summary.json. */
  Json json_of(const RunPlan &plan, const MeshErrors &errors);

  /**
   * The scene of a coarse run on elements of half the length and one order
   * higher, for error estimates.
   */
  class FinerRun
  {
  public:
    /**
     * Starts the run. Collective.
     * @param coarse must outlive the object
     */
    explicit FinerRun(LatticeRun &coarse);

    /** Adds the effort to that of the coarse run. */
    ~FinerRun();

    FinerRun(const FinerRun &)            = delete;
    FinerRun &operator=(const FinerRun &) = delete;

    /**
     * Interpolates @p shape, values of all local unknowns of the coarse run, to
     * this run. Collective.
     */
    Vector prolongated(const Vector &shape) const;

    TangentSolver &solver()
    {
      return run.solver();
    }

    const State &state() const
    {
      return run.solution.state;
    }

    LatticeRun &lattice_run()
    {
      return run;
    }

  private:
    LatticeRun &coarse;
    LatticeRun  run;
  };
} // namespace auxfem

#endif
