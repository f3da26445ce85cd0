#ifndef auxfem_algebra_boundary_elimination_h
#define auxfem_algebra_boundary_elimination_h

#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/neighbour_exchange.h>

#include <memory>

namespace auxfem
{
  /**
   * Exact elimination of joints with few neighbours at the boundaries between
   * ranks, of what JointElimination has left, see boundary_pivots(). The rank
   * that eliminates a joint gets its rows, and of rows that act on it their
   * entries in its columns: its front. What elimination leaves of a front goes
   * back and is added to the rows where they are. So only little moves, and no
   * rank gains or loses rows but those that are eliminated. All functions but
   * those without arguments are collective.
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
      return elimination->n_negative();
    }

    /** Makes @p g from the right-hand side @p b, owned rows. */
    void reduce(const double *b, double *g);

    /** Completes @p x, owned rows, from @p z and the last reduce(). */
    void expand(const double *z, double *x);

    /** Memory on this rank (bytes). */
    std::size_t memory() const;

  private:
    /** What a front has to know of a row. */
    struct FrontRow
    {
      int           global;
      bool          is_pivot;
      UnknownKind   kind;
      unsigned int  joint;
      unsigned char component;
    };

    /** Global numbers of an entry's row and column. */
    struct Place
    {
      int row, column;
    };

    /** Entries that stay what they are. */
    struct Run
    {
      std::size_t from, to, n;
    };

    /** Entries that come back to a row: column, local in `known`, and number
     * among all that come. */
    using Returned = std::vector<std::pair<int, std::size_t>>;

    /** What is part of an entry in this column of what is left. */
    struct Source
    {
      unsigned int column;
      bool         comes_back; ///< from a front, or is the matrix's own
      std::size_t  number;     ///< among those
    };

    void make_front(const SparseMatrix &matrix);
    void receive_front(const std::vector<FrontRow> &rows,
                       const std::vector<Place>    &places);
    void fill_front(const SparseMatrix &matrix);
    void make_pattern(const SparseMatrix &matrix);
    /** What the front leaves, by the rank whose rows it belongs to. */
    ListsByRank<Place> find_returns();
    void               choose_rows(const std::vector<Place> &returns);
    /** Of the row of an owned @p unknown, by columns. */
    void find_sources(const SparseMatrix  &matrix,
                      unsigned int         unknown,
                      const Returned      &returned,
                      std::vector<Source> &row) const;
    void append_row(const std::vector<Source> &row);
    void append_run(std::size_t from, std::size_t to);
    void fill_matrix(const SparseMatrix &matrix, double stiffness);

    const Unknowns    &before;
    const unsigned int most_neighbours;
    /** By local row, the rank that may eliminate it. */
    const std::vector<std::optional<unsigned int>> pivots;

    /** @name What goes to the fronts, one front after the other. */
    ///@{
    std::vector<int>         rows_there; ///< owned
    std::vector<std::size_t> entries_there;
    NeighbourExchange        send_values, return_values, send_entries;
    ///@}

    /** @name The front of this rank; rows of no pivot have no diagonal. */
    ///@{
    std::vector<int>                  globals; ///< of its rows, ascending
    std::unique_ptr<Unknowns>         unknowns;
    std::unique_ptr<SparseMatrix>     front;
    std::vector<std::size_t>          places_in_front; ///< of what comes
    std::unique_ptr<JointElimination> elimination;
    ///@}

    /** @name What comes back from the fronts, and what is left. */
    ///@{
    unsigned int                  n_orders = 0; ///< of the front till now
    std::vector<std::size_t>      entries_back; ///< of what the front leaves
    NeighbourExchange             return_entries;
    std::unique_ptr<Unknowns>     known; ///< those before, and more ghosts
    std::unique_ptr<JointRows>    joint_rows;
    std::unique_ptr<SparseMatrix> left;
    std::vector<Run>              runs;
    std::vector<std::size_t>      places_left; ///< of what comes back
    std::vector<std::size_t>      nothing;     ///< diagonals of such rows
    unsigned int                  n_patterns = 0;
    ///@}
  };
} // namespace auxfem

#endif
