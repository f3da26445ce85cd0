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
   * factorized for it, from a random start that is the same in every run.
   *
   * @param weight diagonal of W, on owned rows
   * @param takes_part whether a local unknown is part of the mode; the others
   *   are zero
   * @param mode receives the last iterate, on local unknowns
   * @param is_enough whether @p mode will do after so many iterations
   * @return by how much the last iteration has made the largest entry grow;
   *   nothing if A is singular
   */
  std::optional<double>
  inverse_iteration(TangentSolver                           &solver,
                    const Vector                            &weight,
                    const std::function<bool(unsigned int)> &takes_part,
                    unsigned int                             n_iterations,
                    Vector                                  &mode,
                    const std::function<bool(unsigned int)> &is_enough = {});

  /**
   * Refuses a structure that can move without resistance, where equilibrium
   * without inertia is asked for. The softest mode of the stiffness at
   * @p state is found by inverse iteration; if its energy is round-off, an InputError
   * names the joint that moves most in it.
   *
   * @param first_step length of the step (s) that viscosity resists in; none:
   *   it does not resist.
   * @return whether the solver's factorization now is that of this stiffness,
   *   as it is.
   */
  bool refuse_mechanism(TangentSolver        &solver,
                        const State          &state,
                        std::optional<double> first_step);

  /**
   * Refuses constraints that follow from others, or from the supports: the
   * forces in rigid parts and hinges would not be determined. Throws
   * InputError, naming one of them. Collective, as are the others.
   */
  void refuse_overconstrained(TangentSolver &solver, const State &state);

  /**
   * Lowest angular frequency (1/s) of small undamped oscillations about
   * @p state: Rayleigh's quotient of the tangent stiffness and the mass matrix
   * after a few inverse iterations with the diagonal of the latter, from above
   * and within a few per cent. Nothing if the structure can move freely.
   * Collective.
   */
  std::optional<double> first_frequency(TangentSolver &solver,
                                        const State   &state);

  /**
   * What modes of a lattice are made of: free unknowns, neither prescribed nor
   * multipliers of constraints, and symmetric matrices between them. All
   * functions but is_...() are collective.
   */
  class ModeSpace
  {
  public:
    /** @p solver must outlive the object. */
    explicit ModeSpace(TangentSolver &solver);

    /** Of an owned unknown. */
    ///@{
    bool is_prescribed(unsigned int i) const;
    bool is_free(unsigned int i) const;
    ///@}

    /** How many free unknowns there are that constraints leave. */
    unsigned int n_free() const;

    /** Largest size of @p values of owned rows among free unknowns.
     * Collective. */
    double largest_free(const std::vector<double> &values) const;

    /** @p y = A x of owned rows, between free unknowns. */
    void
    multiply(const TangentMatrix &matrix, const double *x, double *y) const;

    /** Solves with the matrix that was factorized, constraints included.
     * @param x owned rows; returns whether that succeeded. */
    bool solve(double *x);

    /** Negative eigenvalues of the matrix that was factorized last, without
     * those of constraints; nothing where they are not known or were asked for
     * before. */
    std::optional<unsigned long> n_negative();

    /** 1 or -1: sign of the determinant of the matrix that was factorized last,
     * without that of constraints, so 1 in stable equilibrium; nothing where it
     * is not known. */
    std::optional<int> determinant_sign() const;

    /** A mode on all local unknowns; its largest entry is positive, of equal
     * ones the first. */
    Vector shape(const std::vector<double> &owned) const;

  private:
    void normalize_sign(Vector &shape) const;

    TangentSolver       &solver;
    const Unknowns      &unknowns;
    const UnknownLayout &layout;
  };

  /** Makes what constraints have in @p matrix zero. */
  void leave_out_constraints(TangentMatrix &matrix);

  /** Further modes, between which a gap is looked for to count them. */
  inline constexpr unsigned int n_guard_modes = 4;

  /** Attempts to find as many as are counted, each with twice as many modes. */
  inline constexpr unsigned int n_attempts_to_find_all = 4;

  /** Of the last pairs, how many lie before the widest gap, in units of the
   * distance from the @p shift; at least @p n. */
  unsigned int before_widest_gap(const std::vector<Eigenpair> &pairs,
                                 unsigned int                  n,
                                 double                        shift);

  /** Values of modes on finer elements. */
  struct FinerValues
  {
    /** By size; fewer than modes where these are none of the finer elements. */
    std::vector<double> values;
    /** How many finer elements have at most. */
    unsigned int n_possible = 0;
    /** Values below the last that are not among them, as far as is known. */
    unsigned long n_missing = 0;
  };

  /** Where values below the last are to be counted, and how many of them there
   * are. */
  struct CountLimit
  {
    double        limit;
    unsigned long n_below;
  };

  /** Just below the last of @p values, all of which are above @p lowest, and of
   * those that are as good as equal to it. */
  CountLimit limit_below_last(const std::vector<double> &values, double lowest);

  /** Products of the iterates u_i = (K - sigma M)^-1 M x_i between each other,
   * which are as exact where K itself would lose digits. */
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
   * Inverse iterations of some @p shapes, of all local unknowns.
   * @param problem of which `multiply_mass` and `solve` are used
   * @param n_iterations iterates of each shape; the x_i of later ones are those
   *   before
   * Nothing where solving fails. Collective.
   */
  std::optional<IteratedProducts>
  iterated_products(const ShiftedEigenproblem &problem,
                    const std::vector<Vector> &shapes,
                    unsigned int               n_iterations = 1);

  /** Eigenvalues below @p limit. */
  unsigned long n_below(const std::vector<Eigenpair> &pairs, double limit);
} // namespace auxfem

#endif
