#ifndef auxfem_equations_mode_space_h
#define auxfem_equations_mode_space_h

#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/equations/tangent_solver.h>

#include <functional>
#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * Inverse iteration x <- A^-1 W x with the matrix A of @p solver, which is
   * factorized here. The random start is the same in every run.
   *
   * @param weight diagonal of W, on owned rows
   * @param takes_part whether a local unknown belongs to the mode; others are
   *   zero
   * @param mode receives the last iterate, on local unknowns
   * @param is_enough stopping criterion for @p mode after a number of
   *   iterations
   * @return growth of the largest entry in the last iteration; empty if A is
   *   singular
   */
  std::optional<double>
  inverse_iteration(TangentSolver                           &solver,
                    const Vector                            &weight,
                    const std::function<bool(unsigned int)> &takes_part,
                    unsigned int                             n_iterations,
                    Vector                                  &mode,
                    const std::function<bool(unsigned int)> &is_enough = {});

  /**
   * Rejects mechanisms before a static analysis. Inverse iteration finds the
   * softest mode of the stiffness at @p state; if its energy is round-off,
   * InputError names the joint that moves most.
   *
   * @param first_step length of the step (s) in which viscosity resists; empty
   *   without viscosity
   * @return whether the solver now holds the factorization of the unmodified
   *   stiffness
   */
  bool refuse_mechanism(TangentSolver        &solver,
                        const State          &state,
                        std::optional<double> first_step);

  /**
   * Rejects redundant constraints, which would leave forces in rigid parts and
   * hinges undetermined. InputError names one of them. Collective, as are the
   * others.
   */
  void refuse_overconstrained(TangentSolver &solver, const State &state);

  /**
   * Estimates the lowest angular frequency (1/s) about @p state: Rayleigh
   * quotient after a few inverse iterations with the lumped mass, an upper
   * bound within a few per cent. Empty if the structure can move freely.
   * Collective.
   */
  std::optional<double> first_frequency(TangentSolver &solver,
                                        const State   &state);

  /**
   * Space of the modes of a lattice: free unknowns, without prescribed ones and
   * multipliers, and symmetric matrices on them. All functions except is_...()
   * are collective.
   */
  class ModeSpace
  {
  public:
    /** @p solver must outlive the object. */
    explicit ModeSpace(TangentSolver &solver);

    /** Kind of an owned unknown. */
    ///@{
    bool is_prescribed(unsigned int i) const;
    bool is_free(unsigned int i) const;
    ///@}

    /** Number of free unknowns minus the number of constraints. */
    unsigned int n_free() const;

    /** Largest absolute value of @p values (owned rows) at free unknowns. */
    double largest_free(const std::vector<double> &values) const;

    /** @p y = A x on free unknowns, for owned rows. */
    void
    multiply(const TangentMatrix &matrix, const double *x, double *y) const;

    /** Solves with the factorized matrix, including constraints.
     * @param x owned rows; @return success */
    bool solve(double *x);

    /** Number of negative eigenvalues of the last factorized matrix, without
     * those of constraints; empty if unknown or already queried. */
    std::optional<unsigned long> n_negative();

    /** Sign of the determinant of the last factorized matrix without the effect
     * of constraints: 1 in stable equilibrium; empty if unknown. */
    std::optional<int> determinant_sign() const;

    /** A mode on all local unknowns, with its first largest entry positive. */
    Vector shape(const std::vector<double> &owned) const;

  private:
    void normalize_sign(Vector &shape) const;

    TangentSolver       &solver;
    const Unknowns      &unknowns;
    const UnknownLayout &layout;
  };

  /** Sets the entries of constraints in @p matrix to zero. */
  void clear_constraint_entries(TangentMatrix &matrix);

  /** Additional modes in which a spectral gap for counting is searched. */
  inline constexpr unsigned int n_guard_modes = 4;

  /** Attempts to find all counted modes; each doubles the number of modes. */
  inline constexpr unsigned int n_attempts_to_find_all = 4;

  /**
   * Number of pairs before the widest spectral gap, relative to the distance
   * from the @p shift; at least @p n.
   */
  unsigned int count_before_widest_gap(const std::vector<Eigenpair> &pairs,
                                       unsigned int                  n,
                                       double                        shift);

  /** Values of modes on finer elements. */
  struct FinerValues
  {
    /** Ascending values; fewer than modes if some have no counterpart on finer
     * elements. */
    std::vector<double> values;
    /** Largest number of modes on finer elements. */
    unsigned int n_possible = 0;
    /** Number of values below the last that are known to be missing. */
    unsigned long n_missing = 0;
  };

  /** Limit for counting eigenvalues and the number of values below it. */
  struct CountLimit
  {
    double        limit;
    unsigned long n_below;
  };

  /**
   * Limit just below the last of @p values and its near-multiples; all values
   * exceed @p lowest.
   */
  CountLimit limit_below_last(const std::vector<double> &values, double lowest);

  /**
   * Mutual products of the iterates u_i = (K - sigma M)^-1 M x_i; they keep
   * digits that products with K would lose.
   */
  struct IteratedProducts
  {
    dealii::FullMatrix<double>       by_stiffness; ///< u_i.(K - sigma M) u_j
    dealii::FullMatrix<double>       by_mass;      ///< u_i.M u_j
    std::vector<std::vector<double>> vectors;      ///< u_i, owned rows

    /** Sum of the u_i times column @p j of @p coefficients. */
    std::vector<double>
    combination(const dealii::FullMatrix<double> &coefficients,
                unsigned int                      j) const;
  };

  /**
   * Inverse iterations of @p shapes given on all local unknowns.
   * @param problem provides `multiply_mass` and `solve`
   * @param n_iterations number of iterates per shape; each starts from the
   *   previous one Empty if solving fails. Collective.
   */
  std::optional<IteratedProducts>
  iterated_products(const ShiftedEigenproblem &problem,
                    const std::vector<Vector> &shapes,
                    unsigned int               n_iterations = 1);

  /** Number of eigenvalues below @p limit. */
  unsigned long n_below(const std::vector<Eigenpair> &pairs, double limit);
} // namespace auxfem

#endif
