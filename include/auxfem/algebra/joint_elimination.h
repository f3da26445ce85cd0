#ifndef auxfem_algebra_joint_elimination_h
#define auxfem_algebra_joint_elimination_h

#include <auxfem/algebra/joint_order.h>
#include <auxfem/algebra/joint_rows.h>

#include <memory>

namespace auxfem
{
  /**
   * Exact elimination of joints with few neighbours and of multipliers, by each
   * rank inside its own part: what is coupled with rows of other ranks stays.
   * With E eliminated and L left, A x = b becomes
   *
   *     S z = g,  S = A_LL - A_LE A_EE^-1 A_EL.
   *
   * S has fewer, stouter members between joints than the
   * lattice: multigrid finds their bending less soft against their extension.
   * Moments are divided by a length and rotations measured in that length times
   * radian, constraints and multipliers measured by the largest stiffness, so
   * that all entries of S have the unit N/m.
   */
  class JointElimination
  {
  public:
    /** @param unknowns of the rows and columns of all matrices to come */
    explicit JointElimination(const Unknowns &unknowns);

    /**
     * Makes S, with a new order if there is none yet or if the one there is
     * meets a singular block. Returns false if other orders do so too, on any
     * rank. Collective.
     */
    bool factorize(const SparseMatrix &matrix);

    /** How often rows() and the pattern of S have changed. */
    unsigned int version() const
    {
      return n_patterns;
    }

    /** The rows that are left. */
    const JointRows &rows() const
    {
      return *joint_rows;
    }

    /** S. */
    const SparseMatrix &matrix() const
    {
      return *left;
    }

    /** Negative eigenvalues of A_EE of this rank, if A is symmetric. */
    unsigned long n_negative() const
    {
      return negative;
    }

    /** Makes @p g from the right-hand side @p b, owned rows. */
    void reduce(const double *b, double *g);

    /** Completes @p x, owned rows, from @p z and the last reduce(). */
    void expand(const double *z, double *x);

    /** Memory on this rank (bytes). */
    std::size_t memory() const;

  private:
    using Pivot = JointOrder::Pivot;

    /** Where an entry of S in this column is found: in the blocks if the column
     * is owned, else in the matrix. */
    struct Source
    {
      unsigned int column;
      std::size_t  position;
    };

    void measure(const SparseMatrix &matrix);
    bool eliminate_with_some_order(const SparseMatrix &matrix);
    void find_order(const SparseMatrix &matrix);
    /** With the order there is; returns the pivot that fails. */
    const Pivot *eliminate(const SparseMatrix &matrix);
    void         fill_blocks(const SparseMatrix &matrix);
    void         fill_row(const SparseMatrix &matrix, unsigned int row);
    bool         factorize_pivot(std::size_t number, bool is_symmetric);
    void         update_neighbours(std::size_t number);
    /** Makes one group of a pivot and its neighbour; false if it has none. */
    bool        merge_with_neighbour(const Pivot &pivot);
    void        make_pattern(const SparseMatrix &matrix);
    std::size_t count_entries_left(const SparseMatrix &matrix) const;
    /** Of the row of @p unknown, by columns. */
    void find_sources(const SparseMatrix  &matrix,
                      unsigned int         unknown,
                      std::vector<Source> &row) const;
    void fill_matrix(const SparseMatrix &matrix);

    unsigned int size(unsigned int group) const;
    /** nullptr for positive definite blocks. */
    const int *exchanges_of(const std::size_t pivot) const
    {
      return is_definite[pivot] ? nullptr : &exchanges[first_exchange[pivot]];
    }

    const Unknowns     &unknowns;
    std::vector<double> scale; ///< by local unknown
    /** Largest stiffness between joints, over all ranks (N/m), on the diagonal
     * of S in rows that stand for nothing. */
    double                           stiffness = 0;
    std::vector<std::pair<int, int>> merged;
    std::unique_ptr<JointGroups>     groups;
    /** None if the last one has failed. */
    std::unique_ptr<JointOrder>   order;
    bool                          has_pattern = false;
    unsigned int                  n_patterns  = 0;
    std::unique_ptr<JointRows>    joint_rows;
    std::unique_ptr<SparseMatrix> left;
    std::vector<std::size_t>      sources; ///< of all entries of S

    std::vector<double>      blocks;
    std::vector<double>      largest_in_row; ///< before elimination
    std::vector<int>         exchanges;      ///< of pivots, one after the other
    std::vector<std::size_t> first_exchange;
    std::vector<bool>        is_definite; ///< by pivot
    std::vector<double>      room;
    unsigned long            negative = 0;
    std::vector<double>      values; ///< by owned unknown, between two stages
  };
} // namespace auxfem

#endif
