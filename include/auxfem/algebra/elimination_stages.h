#ifndef auxfem_algebra_elimination_stages_h
#define auxfem_algebra_elimination_stages_h

#include <auxfem/algebra/boundary_elimination.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * Exact elimination of joints with few neighbours on several ranks: each rank
   * those inside its part, see JointElimination, then those at the boundaries,
   * see BoundaryElimination. What is left stays where it is. factorize(),
   * reduce() and expand() are collective, the rest is of this rank.
   */
  class EliminationStages
  {
  public:
    /** @param unknowns of the rows and columns of all matrices to come */
    explicit EliminationStages(const Unknowns &unknowns);

    /** Returns false if a block of @p matrix is singular whatever the order. */
    bool factorize(const SparseMatrix &matrix);

    /** Makes x() from the right-hand side @p b, owned rows. */
    void reduce(const double *b);

    /** Completes @p all, owned rows, from x() and the last reduce(). */
    void expand(double *all);

    /** What is left, and its rows. */
    const SparseMatrix &matrix() const
    {
      return matrix_of(boundary.size());
    }

    const JointRows &rows() const
    {
      return rows_of(boundary.size());
    }

    /** Right-hand side of what is left, then its solution: owned rows(). */
    std::vector<double> &x()
    {
      return values.back();
    }

    /** How often rows() and the pattern of matrix() have changed. */
    unsigned int version() const
    {
      return n_patterns;
    }

    /** Negative eigenvalues of what this rank has eliminated, if the matrix is
     * symmetric. */
    unsigned long n_negative() const;

    /** Memory on this rank (bytes). */
    std::size_t memory() const;

  private:
    /** What is left before boundary stage @p s; that of boundary.size(): after
     * the last. */
    const SparseMatrix &matrix_of(std::size_t s) const;
    const JointRows    &rows_of(std::size_t s) const;

    /** What stages from boundary stage @p first on were made of has changed. */
    void forget_from(std::size_t first);

    const UnknownLayout &layout;
    JointElimination     inside;
    /** One after the other; none until factorization comes to it. */
    std::vector<std::unique_ptr<BoundaryElimination>> boundary;
    /** Of the rows that each stage leaves. */
    std::vector<std::vector<double>> values;
    unsigned int                     n_patterns = 0;
  };
} // namespace auxfem

#endif
