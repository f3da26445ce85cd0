#ifndef auxfem_algebra_elimination_stages_h
#define auxfem_algebra_elimination_stages_h

#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/row_migration.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * Exact elimination of joints with few neighbours on several ranks, see
   * JointElimination: each rank those inside its part, then, rows moving
   * between ranks, those at the boundaries. What is left is shared by the ranks
   * evenly. factorize(), reduce() and expand() are collective, the rest is of
   * this rank.
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
    const SparseMatrix &matrix() const;
    const JointRows    &rows() const;
    /** Right-hand side of what is left, then its solution: owned rows(). */
    std::vector<double> &x();

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
    /** Rows that come from elsewhere, and what elimination makes of them. */
    struct Stage
    {
      std::unique_ptr<RowMigration>     migration; ///< none in the first
      std::unique_ptr<JointElimination> elimination;
      unsigned int                      version = 0;
      std::vector<double>               b, x;

      const JointRows &rows() const
      {
        return elimination->rows();
      }
    };

    /** What is left of all stages, where it was in the first of them: stages
     * leave more to ranks with a small number. */
    struct Left
    {
      Left(const JointElimination &last, std::vector<unsigned int> first_ranks);

      RowMigration        migration;
      JointRows           rows;
      std::vector<double> x;
    };

    const JointElimination &last() const
    {
      return *stages.back().elimination;
    }

    void bring_back(bool is_new);
    bool is_uneven() const;
    /** Ranks that what is left had in the first stage, by row of last(). */
    std::vector<unsigned int> first_ranks() const;

    const UnknownLayout  &layout;
    std::vector<Stage>    stages;
    unsigned int          n_patterns = 0;
    std::unique_ptr<Left> left; ///< where that is uneven
  };
} // namespace auxfem

#endif
