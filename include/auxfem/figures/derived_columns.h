#ifndef auxfem_figures_derived_columns_h
#define auxfem_figures_derived_columns_h

#include <auxfem/parameters/subsection_schema.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  class Expression;

  /** `Columns/NAME`: a column of history.csv computed from others. */
  struct DerivedColumn
  {
    std::string name;       ///< empty: no other column may use it
    std::string expression; ///< of the names of other columns
    std::string unit;       ///< in SI; empty: none
    std::vector<std::pair<std::string, double>> constants;
    std::string                                 path; ///< for messages
  };

  /** Schema of `Columns`. */
  SubsectionSchema columns_schema();

  /** Reads one entry, `EXPRESSION [UNIT]`. Throws InputError for a unit that is
   * not SI. */
  DerivedColumn read_derived_column(ParameterValues &values);

  /** Names that an expression refers to. */
  struct ExpressionNames
  {
    std::vector<std::string> known;
    /** Words that are no names, constants or functions. */
    std::vector<std::string> unknown;
  };

  /** Names in the expression of @p column, which may use @p names and its
   * constants. */
  ExpressionNames names_in(const DerivedColumn            &column,
                           const std::vector<std::string> &names);

  /** Values of derived columns in a row of others. */
  class DerivedValues
  {
  public:
    /**
     * @param definitions columns in order; each may use those before it
     * @param names of the other columns; may contain blanks and points
     * Throws InputError for an expression that is not understood, and for a
     * name that is taken.
     */
    DerivedValues(const std::vector<DerivedColumn> &definitions,
                  const std::vector<std::string>   &names);

    DerivedValues(DerivedValues &&) noexcept;
    DerivedValues &operator=(DerivedValues &&) noexcept;
    ~DerivedValues();

    /** Appends the values to @p row, which has those of the other columns. */
    void append_to(std::vector<double> &row);

  private:
    /** Values of the columns, which the expressions refer to. */
    std::vector<double>                      variables;
    std::vector<std::unique_ptr<Expression>> expressions;
    /** Number of other columns. */
    std::size_t n_columns;
  };
} // namespace auxfem

#endif
