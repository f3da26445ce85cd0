#ifndef auxfem_output_csv_table_h
#define auxfem_output_csv_table_h

#include <fstream>
#include <string>
#include <vector>

namespace auxfem
{
  /** A column of a table: its name in the header, its unit, what it holds. */
  struct Column
  {
    std::string name;
    std::string unit;
    std::string meaning;
  };

  /**
   * A table, mostly of numbers, in a comma-separated file that grows by rows:
   * one header line with the names, then numbers with 15 significant digits.
   * Every row is on its way to the disk when append() returns.
   */
  class CsvTable
  {
  public:
    /**
     * Creates or empties @p file and writes the header. Throws InputError if it
     * cannot be written.
     */
    CsvTable(const std::string &file, const std::vector<Column> &columns);

    /**
     * Goes on with @p file, of which the first @p length bytes are kept. Throws
     * InputError if it is shorter or has other columns, or cannot be written.
     */
    CsvTable(const std::string         &file,
             const std::vector<Column> &columns,
             std::size_t                length);

    /** Bytes in the file. */
    std::size_t length() const;

    /**
     * Appends one row, a number for each column; numbers that are not finite
     * appear as `nan`, `inf`. Throws ComputationError if the disk takes no
     * more.
     */
    void append(const std::vector<double> &row);

    /** As append(), for a row of words and of numbers already written out. */
    void append_text(const std::vector<std::string> &row);

  private:
    void write_line();

    std::string file;
    /** Asked for where it stands, also by what is constant. */
    mutable std::ofstream stream;
    std::string           line;
    std::size_t           n_columns;
  };

  /**
   * Writes the companion of a table: columns `column`, `unit`, `meaning`, one
   * line for each of @p columns. Throws InputError if @p file cannot be written.
   */
  void write_column_reference(const std::string         &file,
                              const std::vector<Column> &columns);
} // namespace auxfem

#endif
