#ifndef auxfem_algebra_elimination_front_h
#define auxfem_algebra_elimination_front_h

#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/neighbour_exchange.h>

#include <memory>

namespace auxfem
{
  /**
   * The rows of a matrix that this rank may eliminate, and of rows that act on
   * them the entries in their columns, wherever they are (multifrontal method;
   * Duff and Reid 1983). What elimination leaves of them goes back, to be added
   * to the rows where they are. All is collective but elimination(),
   * rows_in_fronts() and memory().
   */
  class EliminationFront
  {
  public:
    /** Global numbers of an entry's row and column. */
    struct Place
    {
      int row, column;
    };

    /**
     * @param matrix has the pattern of all matrices to come
     * @param unknowns of its rows and columns
     * @param pivots by local row, the rank that may eliminate it; joints that
     * act on each other have the same, or none
     * @param most_neighbours joints with more of them stay
     */
    EliminationFront(const SparseMatrix                             &matrix,
                     const Unknowns                                 &unknowns,
                     const std::vector<std::optional<unsigned int>> &pivots,
                     unsigned int most_neighbours);

    /** Returns false if a block of @p matrix is singular whatever the order. */
    bool factorize(const SparseMatrix &matrix);

    /** What eliminates, on this rank. */
    const JointElimination &elimination() const
    {
      return *joints;
    }

    /** Where what fronts leave of owned rows is to be added, after every change
     * of elimination().version(). */
    std::vector<Place> places_of_returns();

    /** What is to be added there. */
    std::vector<double> returns() const;

    /** Owned rows that fronts have part of, one front after the other. */
    const std::vector<int> &rows_in_fronts() const
    {
      return rows_there;
    }

    /** Replaces the right-hand side of the pivots among rows_in_fronts(), zero
     * of others, by what is to be added to that of the rows that are left. */
    void reduce(std::vector<double> &values);

    /** Completes the solution in rows_in_fronts() from that in rows that are
     * left. */
    void expand(std::vector<double> &values);

    /** Memory on this rank (bytes). */
    std::size_t memory() const;

  private:
    /** What a front has to know of a row. */
    struct Row
    {
      int           global;
      bool          is_pivot;
      UnknownKind   kind;
      unsigned int  joint;
      unsigned char component;
    };

    void receive(const std::vector<Row> &rows,
                 const Unknowns         &of_all,
                 unsigned int            most_neighbours);
    void make_pattern(const std::vector<Place> &places);

    const UnknownLayout      &layout;
    std::vector<int>          rows_there; ///< owned
    std::vector<std::size_t>  entries_there;
    NeighbourExchange         send_values, return_values, send_entries;
    std::vector<int>          globals; ///< of its rows, ascending
    std::unique_ptr<Unknowns> unknowns;
    /** Rows of no pivot have no diagonal. */
    std::unique_ptr<SparseMatrix>     front;
    std::vector<std::size_t>          places_in_front; ///< of what comes
    std::unique_ptr<JointElimination> joints;
    std::vector<std::size_t>          entries_back; ///< of what is left
    NeighbourExchange                 return_entries;
  };
} // namespace auxfem

#endif
