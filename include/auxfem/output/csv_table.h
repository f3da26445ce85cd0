#ifndef auxfem_output_csv_table_h
#define auxfem_output_csv_table_h

#include <auxfem/parameters/text.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/energies.h>

#include <fstream>
#include <optional>
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

  /** Energies of a run as its history has seen them so far (J). */
  struct EnergyRecord
  {
    Energies latest;
    double   balance         = 0; ///< the latest error of the balance
    double   largest_balance = 0; ///< the largest |balance|
    /** Of mechanical, dissipated energy and work. */
    double largest_energy = 0;

    /** Takes note of @p energies; the first ones are those the balance starts from. */
    void add(const Energies &energies);

    /** After the first add(), or with the latest @p energies. */
    void serialize(const Energies &energies, CheckpointArchive &archive);

    /** @p energy over the largest energy; 0 as long as there is no energy. */
    double relative(double energy) const;

  private:
    std::optional<double> start;
  };

  /**
   * Columns of history.csv for energies: the sum of each kind that @p ledger
   * has, then its causes of dissipation and of work one by one, then the
   * balance.
   */
  std::vector<Column> energy_columns(const EnergyLedger &ledger);

  /** The numbers in these columns after the latest add(). */
  std::vector<double> energy_values(const EnergyRecord &record);

  /** The energies in summary.json: what the columns hold at the end. */
  Json json_of_energies(const EnergyRecord &record);
} // namespace auxfem

#endif
