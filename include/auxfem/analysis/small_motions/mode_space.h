#ifndef auxfem_analysis_small_motions_mode_space_h
#define auxfem_analysis_small_motions_mode_space_h

#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/analysis/tangent_solver.h>

#include <optional>
#include <vector>

namespace auxfem
{
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
    void turn_up(Vector &shape) const;

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

  /** Eigenvalues below @p limit. */
  unsigned long n_below(const std::vector<Eigenpair> &pairs, double limit);
} // namespace auxfem

#endif
