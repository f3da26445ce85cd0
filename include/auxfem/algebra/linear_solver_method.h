#ifndef auxfem_algebra_linear_solver_method_h
#define auxfem_algebra_linear_solver_method_h

#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/parameters/subsection_schema.h>

#include <memory>
#include <string>

namespace auxfem
{
  /** Parameters of subsection `Solver`. */
  struct SolverParameters
  {
    /** `auto`, `cholmod`, `klu`, `mumps`, `gmres`. */
    std::string type           = "auto";
    std::string preconditioner = "amg"; ///< `amg`, `ilu`
    /** Relative residual of an iterative solution. */
    double       tolerance          = 1e-8;
    unsigned int maximum_iterations = 1000;
    /**
     * Whether the analysis needs LinearSolver::inertia() of symmetric matrices;
     * `auto` then avoids methods without it.
     */
    bool needs_inertia = false;
  };

  /** Schema of subsection `Solver`. */
  SubsectionSchema solver_schema();

  /** Reads subsection `Solver`. */
  SolverParameters read_solver(ParameterValues &values);

  /** Solver of the equations at the joints. */
  enum class LinearSolverType
  {
    cholmod,
    klu,
    mumps,
    iterative
  };

  /** Name for messages, e.g. `CHOLMOD`. */
  std::string name_of(LinearSolverType type);

  /** Properties that decide on the solver; the same on all ranks. */
  struct EquationsAtJoints
  {
    /** `given` and `enforced` mean symmetric matrices. */
    Symmetry      symmetry      = Symmetry::given;
    unsigned long n_unknowns    = 0;
    unsigned long n_multipliers = 0;
    unsigned int  n_ranks       = 1;
    unsigned int  n_components  = 3; ///< per node: 3 in the plane, 6 in space
  };

  /** A solver type and the reason for it, as a part of a sentence. */
  struct LinearSolverChoice
  {
    LinearSolverType type;
    std::string      reason;
  };

  /**
   * The type set by @p parameters, or for `auto` the one that suits @p
   * equations best. Throws InputError for CHOLMOD with multipliers.
   */
  LinearSolverChoice choose_linear_solver(const SolverParameters  &parameters,
                                          const EquationsAtJoints &equations);

  /** Elimination order with the smallest factors for @p equations. */
  EliminationOrder choose_elimination_order(const EquationsAtJoints &equations);

  /**
   * Ranks on which MUMPS is fastest; the first one if it makes no difference,
   * since MUMPS then repeats its round-off.
   */
  MumpsRanks choose_mumps_ranks(const EquationsAtJoints &equations);

  /**
   * Whether Newton's method is faster with the symmetric part of an unsymmetric
   * matrix of @p n_unknowns, those inside struts included. A strongly
   * unsymmetric matrix then costs more iterations and tangents.
   * @param asymmetry TangentMatrix::asymmetry()
   */
  bool symmetric_part_pays(const SolverParameters &parameters,
                           double                  asymmetry,
                           unsigned long           n_unknowns);

  /**
   * Solver of the equations at the joints. All functions but inertia(),
   * determinant_sign() and the counts are collective.
   */
  class LinearSolverMethod
  {
  public:
    virtual ~LinearSolverMethod() = default;

    /**
     * Symbolic factorization: uses the pattern only.
     * @param unknowns unknowns of the rows; they must outlive the object.
     */
    virtual FactorizationOutcome analyse(const SparseMatrix &matrix,
                                         const Unknowns     &unknowns) = 0;

    /** Factorizes @p matrix, which must have the pattern analysed last. */
    virtual FactorizationOutcome factorize(const SparseMatrix &matrix) = 0;

    /**
     * Replaces the right-hand side @p x on owned rows by the solution. Returns
     * an empty text or the reason of failure.
     */
    virtual std::string solve(double *x) = 0;

    /** Inertia of the whole matrix; none if unknown. */
    virtual std::optional<Inertia> inertia() const = 0;

    /**
     * Lower bound for the negative eigenvalues beyond one per multiplier, for a
     * symmetric matrix without inertia(); exact if 0, none if unknown. Costs a
     * solution. Collective.
     */
    virtual std::optional<unsigned long> n_negative_at_least()
    {
      return std::nullopt;
    }

    /**
     * Sign of the determinant of the whole matrix, 1 or -1; none if unknown.
     */
    virtual std::optional<int> determinant_sign() const = 0;

    /** Iterations of all solutions so far; 0 for direct solvers. */
    virtual unsigned long n_iterations() const = 0;

    /** Memory on this rank (bytes). */
    virtual std::size_t memory() const = 0;

    /**
     * Makes the next factorization choose its pivots anew; the present factors
     * are lost.
     */
    virtual void forget_pivots()
    {}
  };

  /**
   * Iterative solver for joints without multipliers or unknowns inside struts:
   * JointElimination, then KrylovSolver for the rest. Prescribed rows and
   * columns are those of the identity. It has no inertia, memory() excludes the
   * preconditioner, and a solution that misses the tolerance is the best
   * iterate or not finite. Collective.
   */
  std::unique_ptr<LinearSolverMethod>
  make_iterative_solver(const SolverParameters &parameters);

  /** Creates the solver of the given type for @p equations. */
  std::unique_ptr<LinearSolverMethod>
  make_linear_solver_method(LinearSolverType         type,
                            const EquationsAtJoints &equations,
                            const SolverParameters  &parameters);
} // namespace auxfem

#endif
