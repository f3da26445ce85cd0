#ifndef auxfem_algebra_linear_solver_h
#define auxfem_algebra_linear_solver_h

#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/algebra/strut_condensation.h>

#include <map>

namespace auxfem
{
  /** Accuracy demanded of a factorization. */
  enum class Exactness
  {
    /** Solves the given equations. */
    exact,
    /**
     * May replace an unsymmetric matrix by its symmetric part, whose
     * factorization costs a fraction; for Newton's method.
     */
    approximate
  };

  /** Number of modes with negative stiffness. */
  struct NegativeModes
  {
    unsigned long n = 0;
    /**
     * Whether `n`, if positive, is only a lower bound: iterative solvers do not
     * count all.
     */
    bool is_lower_bound = false;
  };

  /**
   * Solves A x = b of a TangentMatrix: condenses the insides of struts and
   * solves the remaining equations at the joints directly or iteratively. The
   * factors stay valid until the next factorize(), which alone needs the
   * entries of the matrix. All functions are collective but those that return a
   * text or a count.
   */
  class LinearSolver
  {
  public:
    /** @param matrix must outlive the object. */
    LinearSolver(const SolverParameters &parameters,
                 const TangentMatrix    &matrix);

    /**
     * Factorizes the matrix as it is now. If the outcome is not `done`,
     * last_failure() gives the reason and the remedy. The outcome is the same
     * on all ranks, but a rank without memory for the matrix of the joints
     * throws std::bad_alloc. Throws InputError if Solver/Type cannot solve the
     * scene.
     */
    FactorizationOutcome factorize(Exactness exactness);

    /**
     * Whether the last factorization is of the given matrix, not of its
     * symmetric part.
     */
    bool is_exact() const
    {
      return solves_given_matrix;
    }

    /**
     * Inertia over all free unknowns and multipliers, of the symmetric part if
     * not is_exact(); none if the factorized matrix is unsymmetric or solved
     * iteratively. After KLU, which does not compute it, MUMPS factorizes once
     * more.
     */
    std::optional<Inertia> inertia();

    /**
     * Negative eigenvalues of the matrix of inertia() beyond one per
     * multiplier: unstable modes of an equilibrium. None if that matrix is
     * unsymmetric or solved with ILU. With multigrid it costs a solution.
     */
    std::optional<NegativeModes> negative_modes();

    /**
     * Sign of the determinant over all free unknowns and multipliers, 1 or -1;
     * none if not is_exact() or solved iteratively.
     */
    std::optional<int> determinant_sign() const;

    /**
     * Solves for @p values at local unknowns: the right-hand side in owned rows
     * and increments in prescribed rows become the solution, ghosts included.
     * On failure returns false; last_failure() gives the reason and the
     * values are not finite.
     */
    bool solve(std::vector<double> &values);

    /**
     * Reason why the last factorize() or solve() failed, as a part of a
     * sentence; empty if it succeeded.
     */
    const std::string &last_failure() const
    {
      return failure_reason;
    }

    /**
     * The current method and the reason for it, e.g. `CHOLMOD (symmetric
     * matrix, 300 unknowns at joints)`; empty before the first factorization.
     */
    const std::string &method() const
    {
      return description_of_current;
    }

    /** Iterations of all solutions so far; 0 for direct solvers. */
    unsigned long n_iterations() const;

    /**
     * Makes the next factorization choose its pivots anew; the present factors
     * are lost.
     */
    void forget_pivots();

    /** Memory of all factors on this rank (bytes). */
    std::size_t memory() const;

  private:
    /** A method and the pattern version it has analysed. */
    struct Analysed
    {
      std::unique_ptr<LinearSolverMethod> method;
      std::optional<unsigned long>        version;
    };

    /** Also sets solves_given_matrix. Collective. */
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
    /** Whether the given matrix, not its symmetric part, is factorized. */
    bool                                 solves_given_matrix = true;
    std::map<LinearSolverType, Analysed> methods;
    /** The method in use. */
    LinearSolverMethod *current = nullptr;
    std::string         description_of_current, failure_reason;
    std::vector<double> joint_values;
  };
} // namespace auxfem

#endif
