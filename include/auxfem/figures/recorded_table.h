#ifndef auxfem_figures_recorded_table_h
#define auxfem_figures_recorded_table_h

#include <auxfem/figures/recorded_history.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** A column of a table: name in the header, unit, meaning. */
  struct Column
  {
    std::string name;
    std::string unit;
    std::string meaning;
  };

  /** Columns of numbers with names, such as those of history.csv. */
  struct RecordedTable
  {
    std::vector<std::string>         names;
    std::vector<std::vector<double>> columns; ///< in the order of the names

    /** The column @p name; nullptr if there is none. */
    const std::vector<double> *find(const std::string &name) const;

    /** The column @p name over the first one. Throws InputError if there is no
     * such column. */
    RecordedHistory history(const std::string &name) const;

    /** Number of rows. */
    std::size_t n_rows() const
    {
      return columns.empty() ? 0 : columns[0].size();
    }
  };

  /**
   * Reads a table that CsvTable has written; text is NaN, and an incomplete
   * last line is left out. Without a file the table is empty.
   */
  RecordedTable read_table(const std::string &file);
} // namespace auxfem

#endif
