#ifndef auxfem_algebra_linear_solver_method_h
#define auxfem_algebra_linear_solver_method_h

#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/parameters/subsection_schema.h>

#include <memory>
#include <string>

namespace auxfem
{
  /** `Solver`: linear solver. */
  struct SolverParameters
  {
    /** `auto`, `cholmod`, `klu`, `mumps`, `gmres`. */
    std::string type           = "auto";
    std::string preconditioner = "amg"; ///< `amg`, `ilu`
    /** Of an iterative solution, relative to the right-hand side. */
    double       tolerance          = 1e-8;
    unsigned int maximum_iterations = 1000;
    /** Of the analysis: `auto` takes no method that does not know
     * LinearSolver::inertia() of symmetric matrices. */
    bool needs_inertia = false;
  };

  /** `Solver`. */
  SubsectionSchema solver_schema();

  /** The values of that subsection. */
  SolverParameters read_solver(ParameterValues &values);

  /** How the equations at the joints are solved. */
  enum class LinearSolverType
  {
    cholmod,
    klu,
    mumps,
    iterative
  };

  /** Name for messages, e.g. `CHOLMOD`. */
  std::string name_of(LinearSolverType type);

  /** What a choice among the types depends on; the same on all ranks. */
  struct EquationsAtJoints
  {
    /** `given` or `enforced`: symmetric matrices come. */
    Symmetry      symmetry      = Symmetry::given;
    unsigned long n_unknowns    = 0;
    unsigned long n_multipliers = 0;
    unsigned int  n_ranks       = 1;
    unsigned int  n_components  = 3; ///< of a node: 3 in the plane, 6 in space
  };

  /** A type with the reason for it, as a part of a sentence. */
  struct LinearSolverChoice
  {
    LinearSolverType type;
    std::string      reason;
  };

  /**
   * The type that @p parameters ask for, or the one that suits @p equations
   * best. Throws InputError for CHOLMOD where there are multipliers.
   */
  LinearSolverChoice choose_linear_solver(const SolverParameters  &parameters,
                                          const EquationsAtJoints &equations);

  /** The order that keeps factors of @p equations smallest. */
  EliminationOrder choose_elimination_order(const EquationsAtJoints &equations);

  /** The ranks on which MUMPS is quickest; all on one where that is no matter,
   * as it then repeats its digits. */
  MumpsRanks choose_mumps_ranks(const EquationsAtJoints &equations);

  /**
   * Whether Newton's method is quicker with the symmetric part of an
   * unsymmetric matrix of @p n_unknowns, those inside struts included: if it is
   * not near to the matrix, it takes more iterations, and more tangents.
   * @param asymmetry TangentMatrix::asymmetry()
   */
  bool symmetric_part_pays(const SolverParameters &parameters,
                           double                  asymmetry,
                           unsigned long           n_unknowns);

  /**
   * Solution of the equations at the joints by one of the types. All functions
   * but inertia(), determinant_sign() and the counts are collective.
   */
  class LinearSolverMethod
  {
  public:
    virtual ~LinearSolverMethod() = default;

    /**
     * Does what depends on the pattern only.
     * @param unknowns of the rows; they must outlive the object.
     */
    virtual FactorizationOutcome analyse(const SparseMatrix &matrix,
                                         const Unknowns     &unknowns) = 0;

    /** Factorizes @p matrix, whose pattern was analysed last. */
    virtual FactorizationOutcome factorize(const SparseMatrix &matrix) = 0;

    /**
     * Replaces the right-hand side @p x on owned rows by the solution. Returns
     * an empty text or why the equations were not solved.
     */
    virtual std::string solve(double *x) = 0;

    /** Of the whole matrix; none where it is not known. */
    virtual std::optional<Inertia> inertia() const = 0;

    /**
     * Of a symmetric matrix whose inertia() is not known: negative eigenvalues
     * beyond one a multiplier, at least so many, and none at all if 0; nothing
     * where that cannot be told. Costs a solution. Collective.
     */
    virtual std::optional<unsigned long> n_negative_at_least()
    {
      return std::nullopt;
    }

    /** Of the whole matrix, 1 or -1; none where it is not known. */
    virtual std::optional<int> determinant_sign() const = 0;

    /** Iterations of all solutions so far; 0 for direct types. */
    virtual unsigned long n_iterations() const = 0;

    /** On this rank (bytes). */
    virtual std::size_t memory() const = 0;

    /** The next factorization chooses its pivots from its own entries; that of
     * before is lost. */
    virtual void forget_pivots()
    {}
  };

  /**
   * Iteration for the unknowns at joints, none of them inside struts or
   * multipliers: joints with few neighbours are eliminated (JointElimination),
   * the rest is solved by a Krylov method with multigrid or an incomplete
   * factorization (KrylovSolver). Rows and columns of prescribed unknowns are
   * those of the identity. The inertia is not known, and memory() is without
   * the preconditioner's; a solution that misses the tolerance is the best that
   * was found or not finite. All functions are collective.
   */
  std::unique_ptr<LinearSolverMethod>
  make_iterative_solver(const SolverParameters &parameters);

  /** Solution of @p equations by the given type. */
  std::unique_ptr<LinearSolverMethod>
  make_linear_solver_method(LinearSolverType         type,
                            const EquationsAtJoints &equations,
                            const SolverParameters  &parameters);
} // namespace auxfem

#endif
