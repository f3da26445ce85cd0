#ifndef auxfem_analysis_simulation_nearby_run_h
#define auxfem_analysis_simulation_nearby_run_h

#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/time/schemes/static.h>

namespace auxfem
{
  /**
   * Whether equilibria of @p equations depend on the loads alone and not on the
   * way to them: statics of elastic struts and springs, without plates and
   * without struts that touch.
   */
  bool has_independent_equilibria(const Equations &equations);

  /** Throws InputError if the numbers of unknowns differ. */
  void expect_equal_unknowns(const LatticeRun &run, const LatticeRun &other);

  /** The exact tangent at equilibria of a run. Constructor and functions are
   * collective. */
  class EquilibriumTangent
  {
  public:
    /** @param run must outlive the object; with independent equilibria */
    explicit EquilibriumTangent(LatticeRun &run);

    /** Factorizes at the current solution of the run, unless the tangent is the
     * same for all. Throws ComputationError if it is singular. */
    void update();

    TangentSolver &solver()
    {
      return tangent;
    }

  private:
    const LatticeRun &run;
    TangentSolver     tangent;
    EvaluationResults results;
    bool              is_constant = false;
  };

  /**
   * A scene that differs little from one that is being run, with the same
   * unknowns: its equilibria follow from those of the run by a few corrections
   * with the tangent of the run, the first of which is exact to first order in
   * the difference (direct differentiation; J. S. Arora, Introduction to
   * Optimum Design, ch. 14). Functions are collective.
   */
  class NearbyRun
  {
  public:
    /**
     * Sets up the scene. Throws InputError as LatticeRun, and if the unknowns
     * differ from those of @p run.
     * @param plan whose scene must outlive the object
     */
    NearbyRun(const RunPlan    &plan,
              const LatticeRun &run,
              MPI_Comm          communicator);

    /** Follows a step of the run, which leads to the equilibrium @p base.
     * @param tangent factorized there
     * Throws ComputationError if the linear equations cannot be solved. */
    void follow(const Solution &base, TangentSolver &tangent);

    const Solution &solution() const
    {
      return run.solution;
    }

    /** The set-up of the scene; its solution is that of the last equilibrium.
     */
    LatticeRun run;

  private:
    State               trial;
    EvaluationResults   results;
    const NodeRotations rotations;
    const QuasiStatic   scheme;
    /** Displacements of the run at its last equilibrium. */
    Vector base_before;
  };
} // namespace auxfem

#endif
