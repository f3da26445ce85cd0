#ifndef auxfem_algebra_joint_elimination_h
#define auxfem_algebra_joint_elimination_h

#include <auxfem/algebra/joint_order.h>

namespace auxfem
{
  /**
   * Exact elimination of joints with few neighbours, by each rank inside its
   * own part; rows coupled with other ranks remain. With E eliminated and L
   * remaining, A x = b becomes
   *
   *     S z = g,  S = A_LL - A_LE A_EE^-1 A_EL.
   *
   * Multigrid converges faster on S, whose members are stouter. Moments are
   * divided by a length and rotations multiplied by it, so that S is in N/m.
   * Multipliers are not supported.
   */
  class JointElimination
  {
  public:
    /**
     * Collective.
     * @param matrix has the pattern of all later matrices
     * @param unknowns unknowns of its rows and columns
     */
    JointElimination(const SparseMatrix &matrix, const Unknowns &unknowns);

    /**
     * Computes S. Returns false if a pivot block is singular on any rank.
     * Collective.
     */
    bool factorize(const SparseMatrix &matrix);

    /** Rows of S. */
    const JointRows &rows() const
    {
      return joint_rows;
    }

    /** S. */
    const SparseMatrix &matrix() const
    {
      return reduced;
    }

    /**
     * Number of negative eigenvalues of A_EE on this rank, if A is symmetric.
     */
    unsigned long n_negative() const
    {
      return negative;
    }

    /** Computes @p g from the right-hand side @p b, owned rows. */
    void reduce(const double *b, double *g);

    /** Computes @p x, owned rows, from @p z and the last reduce(). */
    void expand(const double *z, double *x);

    /** Memory on this rank (bytes). */
    std::size_t memory() const;

  private:
    using Pivot = JointOrder::Pivot;

    /**
     * Source of an entry of S: a position in the blocks if the column is owned,
     * else in the matrix.
     */
    struct Source
    {
      unsigned int column;
      std::size_t  position;
    };

    double      find_largest_stiffness(const SparseMatrix &matrix) const;
    bool        eliminate(const SparseMatrix &matrix);
    void        fill_blocks(const SparseMatrix &matrix);
    void        fill_row(const SparseMatrix &matrix, unsigned int row);
    bool        factorize_pivot(std::size_t number, bool is_symmetric);
    void        update_neighbours(std::size_t number);
    JointRows   make_rows() const;
    void        make_pattern(const SparseMatrix &matrix);
    std::size_t count_reduced_entries(const SparseMatrix &matrix) const;
    /** Sources of the row of @p unknown, by columns. */
    void find_sources(const SparseMatrix  &matrix,
                      unsigned int         unknown,
                      std::vector<Source> &row) const;
    void fill_matrix(const SparseMatrix &matrix);

    unsigned int size(unsigned int group) const;
    /** Row exchanges of a pivot; nullptr if it is positive definite. */
    const int *exchanges_of(const std::size_t pivot) const
    {
      return is_definite[pivot] ? nullptr : &exchanges[first_exchange[pivot]];
    }

    const Unknowns     &unknowns;
    const JointGroups   groups;
    const JointOrder    order;
    const JointRows     joint_rows;
    SparseMatrix        reduced;
    std::vector<double> scale; ///< by local unknown
    /**
     * Largest stiffness between joints over all ranks (N/m): diagonal of S in
     * unused rows.
     */
    double                   stiffness = 0;
    std::vector<std::size_t> sources; ///< of all entries of S

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
