#ifndef auxfem_output_csv_table_h
#define auxfem_output_csv_table_h

#include <auxfem/figures/recorded_table.h>
#include <auxfem/parameters/text.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/energies.h>

#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /**
   * A table, mostly of numbers, in a comma-separated file that grows by rows:
   * one header line with the names, then numbers with 15 significant digits.
   * append() flushes every row.
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
     * Continues @p file after its first @p length bytes. Throws InputError if
     * it is shorter, has other columns or cannot be written.
     */
    CsvTable(const std::string         &file,
             const std::vector<Column> &columns,
             std::size_t                length);

    /** Bytes in the file. */
    std::size_t length() const;

    /**
     * Appends one row with a number for each column; non-finite numbers appear
     * as `nan`, `inf`. Throws ComputationError if writing fails.
     */
    void append(const std::vector<double> &row);

    /** As append(), for a row of texts. */
    void append_text(const std::vector<std::string> &row);

  private:
    void write_line();

    std::string file;
    /** Mutable, because length() asks for its position. */
    mutable std::ofstream stream;
    std::string           line;
    std::size_t           n_columns;
  };

  /** Text of a number in a table: 15 significant digits. */
  std::string text_of_cell(double value);

  /**
   * Writes the companion of a table: columns `column`, `unit`, `meaning`, one
   * line for each of @p columns. Throws InputError if @p file cannot be written.
   */
  void write_column_reference(const std::string         &file,
                              const std::vector<Column> &columns);

  /** Energies of a run recorded in its history so far (J). */
  struct EnergyRecord
  {
    Energies latest;
    double   balance         = 0; ///< the latest error of the balance
    double   largest_balance = 0; ///< the largest |balance|
    /** Largest mechanical or dissipated energy or work. */
    double largest_energy = 0;

    /** Records @p energies; the balance starts from the first ones. */
    void add(const Energies &energies);

    /** Saves after the first add(), or restores with the latest @p energies. */
    void serialize(const Energies &energies, CheckpointArchive &archive);

    /** @p energy over the largest energy; 0 without energy. */
    double relative(double energy) const;

  private:
    std::optional<double> start;
  };

  /**
   * Energy columns of history.csv: the sum of each kind in @p ledger, each
   * cause of dissipation and work, and the balance.
   */
  std::vector<Column> energy_columns(const EnergyLedger &ledger);

  /** The numbers in these columns after the latest add(). */
  std::vector<double> energy_values(const EnergyRecord &record);

  /** Causes of dissipation and their shares of all dissipated energy, the
   * largest first; none without dissipation. */
  std::vector<std::pair<std::string, double>>
  dissipated_shares(const Energies &energies);

  /** Final energies for summary.json. */
  Json json_of_energies(const EnergyRecord &record);
} // namespace auxfem

#endif
