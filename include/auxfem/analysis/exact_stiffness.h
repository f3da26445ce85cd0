#ifndef auxfem_analysis_exact_stiffness_h
#define auxfem_analysis_exact_stiffness_h

#include <auxfem/analysis/tangent_solver.h>

#include <optional>

namespace auxfem
{
  /**
   * The stiffness of exact kinematics, and some inertia, factorized: at rest,
   * which serves for motions that are small enough and is kept from one of them
   * to the next, or at another state. What computes is collective.
   */
  class ExactStiffness
  {
  public:
    /** @param solver of the exact equations; must outlive the object
     * @param inertia factor of the mass matrix (1/s2) */
    ExactStiffness(TangentSolver &solver, double inertia);

    /** The unloaded state, whose rates are zero. Made anew for every look at a
     * motion: looks are rare. */
    State at_rest() const;

    /** @name What is factorized; neither: nothing is. */
    ///@{
    bool is_of_rest() const
    {
      return factorized == Factorized::at_rest;
    }
    bool is_of_another() const
    {
      return factorized == Factorized::at_another_state;
    }
    ///@}

    /** Factorizes it at rest, unless that is there; returns whether it is. */
    bool take_that_of_rest();

    /** At evaluation.to; returns whether that succeeds.
     * @param results of TangentSolver::residual() */
    bool factorize(const Evaluation        &evaluation,
                   const EvaluationResults &results);

    /** Whether that at evaluation.to is positive definite, as far as that can
     * be told: of one that is not symmetric the determinant is looked at.
     * Replaces what was factorized. */
    std::optional<bool> is_positive(const Evaluation &evaluation);

    void forget()
    {
      factorized = Factorized::nothing;
    }

    /** Lets go of what will not be asked for when the next motion is looked at.
     */
    void end_look();

    /** @name For runs that are resumed. */
    ///@{
    void save(Records &records) const;
    void resume(const Records &records);
    ///@}

  private:
    enum class Factorized
    {
      nothing,
      at_rest,
      at_another_state
    };

    void assemble_at_rest();

    TangentSolver &solver;
    const double   inertia; ///< 1/s2
    Factorized     factorized = Factorized::nothing;
  };
} // namespace auxfem

#endif
