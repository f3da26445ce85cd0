#include <auxfem/output/energy_record.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    struct KindOfEnergy
    {
      EnergyKind  kind;
      std::string name, meaning;
    };

    const std::array<KindOfEnergy, 6> &kinds()
    {
      static const std::array<KindOfEnergy, 6> list = {
        {{EnergyKind::kinetic, "kinetic", "kinetic energy"},
         {EnergyKind::strain,
          "strain",
          "strain energy of struts and rotational springs"},
         {EnergyKind::stored, "stored", "energy in the springs of connectors"},
         {EnergyKind::dissipated,
          "dissipated",
          "energy lost since the start, by all causes"},
         {EnergyKind::work,
          "external",
          "work of loads and prescribed motion since the start"},
         {EnergyKind::numerical,
          "numerical",
          numerical_energy_entry().meaning}}};
      return list;
    }

    /** Whether an entry has a column of its own beside that of its kind. */
    bool has_own_column(const EnergyEntry &entry)
    {
      return std::none_of(kinds().begin(),
                          kinds().end(),
                          [&](const auto &kind) {
                            return kind.name == entry.name;
                          });
    }

    std::string balance_meaning(const EnergyLedger &ledger)
    {
      std::string sum;
      for (const KindOfEnergy &kind : kinds())
        if (kind.kind != EnergyKind::work && ledger.has(kind.kind))
          sum += (sum.empty() ? "" : " + ") + kind.name;
      if (ledger.has(EnergyKind::work))
        sum += " - external";
      return sum +
        " minus its value at the start: zero to round-off for linear scenes, "
        "else the error of the step length";
    }
  } // namespace

  void EnergyRecord::add(const Energies &energies)
  {
    // A run that starts from an equilibrium starts with work already done.
    if (!start)
      start = energies.balance(0);

    latest  = energies;
    balance = energies.balance(*start);
    // In this order a number that is none stays.
    largest_balance = std::max(std::abs(balance), largest_balance);
    largest_energy  = std::max({largest_energy,
                                std::abs(energies.total()),
                                std::abs(energies.dissipated()),
                                std::abs(energies.external())});
  }

  void EnergyRecord::serialize(const Energies    &energies,
                               CheckpointArchive &archive)
  {
    archive.values(
      "output: energies: initial balance, largest balance, largest "
      "energy",
      start,
      largest_balance,
      largest_energy);
    latest  = energies;
    balance = energies.balance(*start);
  }

  double EnergyRecord::relative(const double energy) const
  {
    if (largest_energy > 0 || std::isnan(energy))
      return energy / largest_energy;
    return 0;
  }

  std::vector<Column> energy_columns(const EnergyLedger &ledger)
  {
    std::vector<Column> columns;
    for (const KindOfEnergy &kind : kinds())
      if (ledger.has(kind.kind))
        columns.push_back({kind.name, "J", kind.meaning});
    for (const EnergyEntry &entry : ledger.entries())
      if (has_own_column(entry))
        columns.push_back({entry.name, "J", entry.meaning});
    columns.push_back({"balance", "J", balance_meaning(ledger)});
    return columns;
  }

  std::vector<double> energy_values(const EnergyRecord &record)
  {
    const Energies     &energies = record.latest;
    const EnergyLedger &ledger   = energies.ledger();
    std::vector<double> values;
    for (const KindOfEnergy &kind : kinds())
      if (ledger.has(kind.kind))
        values.push_back(energies.sum(kind.kind));
    for (unsigned int i = 0; i < ledger.entries().size(); ++i)
      if (has_own_column(ledger.entries()[i]))
        values.push_back(energies[i]);
    values.push_back(record.balance);
    return values;
  }

  Json json_of_energies(const EnergyRecord &record)
  {
    Json                      json;
    const std::vector<Column> columns = energy_columns(record.latest.ledger());
    const std::vector<double> values  = energy_values(record);
    for (unsigned int i = 0; i < columns.size(); ++i)
      json[columns[i].name] = values[i];
    json["largest"]                  = record.largest_energy;
    json["largest_relative_balance"] = record.relative(record.largest_balance);
    return json;
  }
} // namespace auxfem
