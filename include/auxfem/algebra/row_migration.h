#ifndef auxfem_algebra_row_migration_h
#define auxfem_algebra_row_migration_h

#include <auxfem/algebra/neighbour_exchange.h>
#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <memory>

namespace auxfem
{
  /** Rows of a matrix on other ranks than before. All functions are collective.
   */
  class RowMigration
  {
  public:
    /**
     * Joints that act on joints of a rank with a smaller number go there, and
     * their neighbours with them, so that joints at the boundary between ranks
     * come to lie inside. Rows and columns of @p matrix are the @p unknowns.
     */
    RowMigration(const SparseMatrix &matrix, const Unknowns &unknowns);

    /** Owned rows go to the ranks @p target_of_row, all of a joint to one. */
    RowMigration(const SparseMatrix       &matrix,
                 const Unknowns           &unknowns,
                 std::vector<unsigned int> target_of_row);

    /** The unknowns where they are now. */
    const Unknowns &unknowns() const
    {
      return *new_unknowns;
    }

    /** The matrix where it is now, with the entries of the last fill(). */
    const SparseMatrix &matrix() const
    {
      return *new_matrix;
    }

    /** Takes the entries of @p matrix, whose pattern the constructor got. */
    void fill(const SparseMatrix &matrix);

    /** Brings values of owned rows there, and back. */
    void go(const double *before, double *now) const;
    void come_back(const double *now, double *before) const;

  private:
    void number_rows();
    void move_pattern(const SparseMatrix &matrix);
    /** The next row, of local @p columns as they come. */
    void                append_row(const std::vector<int> &columns);
    void                move_unknowns(const Unknowns &unknowns);
    std::vector<double> there(const std::vector<double> &before) const;

    const UnknownLayout      &old_layout;
    std::vector<unsigned int> target; ///< rank, by old owned row
    std::vector<int>          kept;   ///< old owned rows, first of the new ones
    std::vector<int>          new_number; ///< global, by old local row
    /** Old rows and, beyond them, those that come here. */
    std::unique_ptr<UnknownLayout> arrivals;
    /** New rows and, beyond them, those that have left. */
    std::unique_ptr<UnknownLayout> returns;
    std::unique_ptr<UnknownLayout> new_layout;
    std::unique_ptr<Unknowns>      new_unknowns;
    std::unique_ptr<SparseMatrix>  new_matrix;
    NeighbourExchange              entries; ///< of the rows that move
    /** Entry of the new matrix that the next one of all that come goes to. */
    std::vector<std::size_t> order;
  };
} // namespace auxfem

#endif
