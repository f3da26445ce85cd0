#ifndef auxfem_algebra_boundary_elimination_h
#define auxfem_algebra_boundary_elimination_h

#include <auxfem/algebra/elimination_front.h>

#include <memory>

namespace auxfem
{
  /**
   * Exact elimination of joints with few neighbours at the boundaries between
   * ranks, of what JointElimination has left: each on one of the ranks that it
   * acts on, see boundary_pivots() and EliminationFront. So only little moves,
   * and no rank gains or loses rows but those that are eliminated. Functions
   * with arguments are collective.
   */
  class BoundaryElimination
  {
  public:
    /** @p matrix has the pattern and @p unknowns are of the rows and columns of
     * all matrices to come. */
    BoundaryElimination(const SparseMatrix &matrix,
                        const Unknowns     &unknowns,
                        unsigned int        most_neighbours);

    /**
     * Makes matrix(). Returns false if a block of @p matrix is singular.
     * @param stiffness on the diagonal of rows that stand for nothing (N/m)
     */
    bool factorize(const SparseMatrix &matrix, double stiffness);

    /** How often rows() and the pattern of matrix() have changed. */
    unsigned int version() const
    {
      return n_patterns;
    }

    /** What is left, and its rows. */
    const SparseMatrix &matrix() const
    {
      return *left;
    }

    const JointRows &rows() const
    {
      return *joint_rows;
    }

    /** Negative eigenvalues of what this rank has eliminated, if the matrix is
     * symmetric. */
    unsigned long n_negative() const
    {
      return front.elimination().n_negative();
    }

    /** Makes @p g from the right-hand side @p b, owned rows. */
    void reduce(const double *b, double *g);

    /** Completes @p x, owned rows, from @p z and the last reduce(). */
    void expand(const double *z, double *x);

    /** Memory on this rank (bytes). */
    std::size_t memory() const;

  private:
    /** What is part of an entry in this column of what is left. */
    struct Source
    {
      unsigned int column;
      bool         comes_back; ///< from a front, or is the matrix's own
      std::size_t  number;     ///< among those
    };

    /** Entries of the matrix that stay what they are. */
    struct Run
    {
      std::size_t from, to, n;
    };

    void make_pattern(const SparseMatrix &matrix);
    void choose_rows(const std::vector<EliminationFront::Place> &returns);
    /** Appends to what comes back to the row of the owned @p unknown what it
     * keeps, and sorts by columns. */
    void complete_sources(const SparseMatrix  &matrix,
                          unsigned int         unknown,
                          std::vector<Source> &row) const;
    void append_row(const std::vector<Source> &row);
    void append_run(std::size_t from, std::size_t to);

    const Unknowns &before;
    /** By local row, the rank that may eliminate it. */
    const std::vector<std::optional<unsigned int>> pivots;
    EliminationFront                               front;

    std::unique_ptr<Unknowns>     known; ///< those before, and more ghosts
    std::unique_ptr<JointRows>    joint_rows;
    std::unique_ptr<SparseMatrix> left;
    std::vector<Run>              runs;
    std::vector<std::size_t>      places_of_returns;
    std::vector<std::size_t>      nothing;        ///< diagonals of such rows
    unsigned int                  n_patterns = 0; ///< the front has left
  };
} // namespace auxfem

#endif
