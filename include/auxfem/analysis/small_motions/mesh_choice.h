#ifndef auxfem_analysis_small_motions_mesh_choice_h
#define auxfem_analysis_small_motions_mesh_choice_h

#include <auxfem/analysis/simulation/lattice_run.h>

namespace auxfem
{
  /** Errors that the elements make in what an analysis of small motions
   * reports, found by a comparison with finer elements. */
  struct MeshErrors
  {
    /** Relative errors, one a value; not finite where it is not known. */
    std::vector<double> relative;
    /** Modes of finer elements below the last one that are not reported. */
    unsigned long n_missing = 0;
    /** Whether finer elements have more modes where too few were found. */
    bool has_too_few = false;
    /** Why there is no comparison; empty if there is one. */
    std::string why_unknown = {};

    /** Infinite if one of them is not known. */
    double largest() const;
  };

  /** The phase (rad) that the highest of the @p n lowest modes of a lattice can
   * have along a strut: clamped joints make all frequencies higher. */
  double phase_of_modes(const Scene &scene, unsigned int n);

  /** The phase (rad) along a strut of the highest of the @p n lowest buckling
   * modes, if equally loaded struts buckle between clamped joints. */
  double phase_of_buckling(const Scene &scene, unsigned int n);

  /** The phase (rad) of bending waves of an angular frequency (rad/s) along the
   * strut that has the shortest. */
  double phase_at(const Scene &scene, double omega);

  /**
   * Gives all struts of @p plan the fewest unknowns with which waves have a
   * relative error of @p wanted, by the dispersion of elements of order p
   * (Ainsworth 2004): (p! / (2 p)!)^2 / (2 p + 1) (phase of an element)^(2 p).
   * @param phase of the shortest wave along a strut (rad)
   */
  void choose_elements(double phase, double wanted, RunPlan &plan);

  /**
   * Gives all struts of @p plan more unknowns, with which @p errors meet its
   * tolerance if they follow that dispersion.
   * @param first the plan with the elements that were chosen first
   * Returns false if there are no such elements.
   */
  bool refine_elements(const RunPlan    &first,
                       const MeshErrors &errors,
                       RunPlan          &plan);

  /** Whether @p errors meet the tolerance of @p scene, or elements are given.
   */
  bool are_accepted(const Scene &scene, const MeshErrors &errors);

  /** Findings on the elements of @p plan.
   * @param values what errs, e.g. `natural frequencies` */
  std::vector<Finding> findings_of_mesh(const RunPlan     &plan,
                                        const MeshErrors  &errors,
                                        const std::string &values);

  /** A line on elements and errors, without the last line break. */
  std::string mesh_text(const RunPlan &plan, const MeshErrors &errors);

  /** The same for summary.json. */
  Json json_of(const RunPlan &plan, const MeshErrors &errors);

  /** The same scene on elements of half the length and one order more, beside
   * the run that it judges. */
  class FinerRun
  {
  public:
    /** Starts. @param coarse must outlive the object. Collective. */
    explicit FinerRun(LatticeRun &coarse);

    /** The effort counts as that of the coarse run. */
    ~FinerRun();

    FinerRun(const FinerRun &)            = delete;
    FinerRun &operator=(const FinerRun &) = delete;

    /** @p shape of all local unknowns of the coarse run as one of this run's.
     * Collective. */
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
