#ifndef auxfem_output_energy_record_h
#define auxfem_output_energy_record_h

#include <auxfem/output/csv_table.h>
#include <auxfem/parameters/json.h>
#include <auxfem/time/checkpoint_archive.h>
#include <auxfem/time/energies.h>

#include <optional>

namespace auxfem
{
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
