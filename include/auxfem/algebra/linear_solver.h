#ifndef auxfem_algebra_linear_solver_h
#define auxfem_algebra_linear_solver_h

#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/algebra/strut_condensation.h>

#include <map>

namespace auxfem
{
  /** What a factorization is for. */
  enum class Exactness
  {
    /** The equations as they are. */
    exact,
    /**
     * An unsymmetric matrix may give way to its symmetric part, whose
     * factorization costs a fraction: for Newton's method.
     */
    approximate
  };

  /** How many modes have a negative stiffness. */
  struct NegativeModes
  {
    unsigned long n = 0;
    /** There may be more, if there are any: iteration does not count all. */
    bool is_least = false;
  };

  /**
   * Solution of the linear equations A x = b of a TangentMatrix: what lies
   * inside struts is condensed, what is left at the joints solved directly or
   * by iteration, with factors that serve until the next factorize(). Only that
   * needs the entries of the matrix. All functions are collective but those
   * that return a text or a count.
   */
  class LinearSolver
  {
  public:
    /** @param matrix must outlive the object. */
    LinearSolver(const SolverParameters &parameters,
                 const TangentMatrix    &matrix);

    /**
     * Factorizes the matrix as it is now. If the outcome is not `done`, why()
     * says what was found and what to do. The outcome is the same on all ranks,
     * but std::bad_alloc is thrown on one of several ranks that has no memory
     * for the matrix of the joints. Throws InputError where Solver/Type cannot
     * serve the scene.
     */
    FactorizationOutcome factorize(Exactness exactness);

    /** Whether the last factorization is that of the matrix, not of its
     * symmetric part. */
    bool is_exact() const
    {
      return solves_given_matrix;
    }

    /**
     * Numbers of eigenvalues of all free unknowns and multipliers, of the
     * symmetric part if not is_exact(); none where the matrix is unsymmetric or
     * solved by iteration. Costs nothing but where KLU has factorized, which
     * does not tell: then one factorization by MUMPS.
     */
    std::optional<Inertia> inertia();

    /**
     * Negative eigenvalues beyond one a multiplier, of what inertia() is of:
     * modes in which an equilibrium is unstable. None where the matrix is
     * unsymmetric, or solved with ILU. Of multigrid it costs a solution.
     */
    std::optional<NegativeModes> negative_modes();

    /**
     * 1 or -1: sign of the determinant of the matrix of all free unknowns and
     * multipliers, symmetric or not. None if not is_exact() or solved by
     * iteration.
     */
    std::optional<int> determinant_sign() const;

    /**
     * Replaces @p values at local unknowns, owned rows of the right-hand side
     * with increments in prescribed rows, by the solution, ghosts included.
     * Returns false if that fails: why() tells the reason, and the values are
     * not finite.
     */
    bool solve(std::vector<double> &values);

    /** Why the last factorize() or solve() failed, as a part of a sentence;
     * empty if it did not. */
    const std::string &why() const
    {
      return failure_reason;
    }

    /** Which method solves, and why, e.g. `CHOLMOD (symmetric matrix, 300
     * unknowns at joints)`; empty before the first factorization. */
    const std::string &method() const
    {
      return description_of_current;
    }

    /** Iterations of all solutions so far; 0 for direct types. */
    unsigned long n_iterations() const;

    /** The next factorization depends on its matrix alone; that of before is
     * lost. */
    void forget_pivots();

    /** Memory of all factors on this rank (bytes). */
    std::size_t memory() const;

  private:
    /** A method and the version of the pattern that it has analysed. */
    struct Analysed
    {
      std::unique_ptr<LinearSolverMethod> method;
      std::optional<unsigned long>        version;
    };

    /** Sets solves_given_matrix, too. Collective. */
    Symmetry             choose_symmetry(Exactness exactness);
    FactorizationOutcome try_to_factorize(Exactness exactness);
    FactorizationOutcome factorize_joints(const LinearSolverChoice &choice);
    EquationsAtJoints    equations_at_joints() const;
    std::unique_ptr<LinearSolverMethod>
                           make_method(LinearSolverType type) const;
    std::optional<Inertia> inertia_by_mumps() const;
    std::string            message(FactorizationOutcome outcome) const;

    const SolverParameters parameters;
    const TangentMatrix   &matrix;
    const unsigned long    n_prescribed, n_multipliers;
    StrutCondensation      condensation;
    Symmetry               symmetry = Symmetry::given;
    /** Whether what is factorized is not another symmetric part. */
    bool                                 solves_given_matrix = true;
    std::map<LinearSolverType, Analysed> methods;
    /** The one that solves. */
    LinearSolverMethod *current = nullptr;
    std::string         description_of_current, failure_reason;
    std::vector<double> joint_values;
  };
} // namespace auxfem

#endif
