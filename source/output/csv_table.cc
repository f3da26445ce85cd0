#include <auxfem/output/csv_table.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** @p text as one field, quoted if necessary. */
    std::string csv_field(const std::string &text)
    {
      if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char character : text)
        {
          if (character == '"')
            quoted += '"';
          quoted += character;
        }
      return quoted + '"';
    }

    std::string reason()
    {
      return output_error_text(errno);
    }

    [[noreturn]] void throw_cannot_write(const std::string &file)
    {
      throw InputError("Cannot write " + file + ": " + reason() +
                       ".\nRemove the obstacle, or choose another "
                       "folder with Output/Directory or --output DIR.");
    }

    std::ofstream open(const std::string &file)
    {
      std::ofstream stream = open_output_file(file);
      if (!stream)
        throw_cannot_write(file);
      return stream;
    }

    /** Header line; ends with a comma. */
    std::string header(const std::vector<Column> &columns)
    {
      std::string line;
      for (const Column &column : columns)
        line += csv_field(column.name) + ',';
      return line;
    }
  } // namespace

  CsvTable::CsvTable(const std::string         &file,
                     const std::vector<Column> &columns)
    : file(file)
    , stream(open(file))
    , n_columns(columns.size())
  {
    line = header(columns);
    write_line();
  }

  CsvTable::CsvTable(const std::string         &file,
                     const std::vector<Column> &columns,
                     const std::size_t          length)
    : file(file)
    , n_columns(columns.size())
  {
    std::string expected = header(columns), found(expected.size(), ' ');
    expected.back()      = '\n';
    std::ifstream(file, std::ios::binary).read(found.data(), found.size());
    std::error_code error;
    if (found != expected || std::filesystem::file_size(file, error) < length ||
        error)
      throw InputError(
        file +
        " differs from the file that the run has written: it was changed, or "
        "the output parameters request other columns. Restore it, or start "
        "from t = 0.");
    stream = open_output_file(file, std::ios::in | std::ios::out);
    if (!stream)
      throw_cannot_write(file);
    std::filesystem::resize_file(file, length, error);
    if (error || !stream.seekp(0, std::ios::end))
      throw_cannot_write(file);
  }

  std::size_t CsvTable::length() const
  {
    return stream.tellp();
  }

  std::string text_of_cell(const double value)
  {
    return number_text(value, 15);
  }

  void CsvTable::append(const std::vector<double> &row)
  {
    AssertDimension(row.size(), n_columns);

    line.clear();
    for (const double value : row)
      line += text_of_cell(value) + ',';
    write_line();
  }

  void CsvTable::append_text(const std::vector<std::string> &row)
  {
    AssertDimension(row.size(), n_columns);
    line.clear();
    for (const std::string &cell : row)
      line += csv_field(cell) + ',';
    write_line();
  }

  void CsvTable::write_line()
  {
    line.back()           = '\n';
    const auto whole_size = stream.tellp();
    stream.write(line.data(), line.size());
    stream.flush();
    if (stream)
      return;
    const std::string reason_text = reason();
    // The stream would retry to write its buffer.
    stream.close();
    std::error_code ignored;
    std::filesystem::resize_file(file, whole_size, ignored);
    throw ComputationError("Cannot write to " + file + ": " + reason_text +
                           ".\nAll earlier rows are in the file.");
  }

  void write_column_reference(const std::string         &file,
                              const std::vector<Column> &columns)
  {
    std::ofstream stream = open(file);
    stream << "column,unit,meaning\n";
    for (const Column &column : columns)
      stream << csv_field(column.name) << ',' << csv_field(column.unit) << ','
             << csv_field(column.meaning) << '\n';
    stream.close();
    if (!stream)
      throw ComputationError("Cannot write " + file + ": " + reason() + ".");
  }

  namespace
  {
    struct EnergyKindColumn
    {
      EnergyKind  kind;
      std::string name, meaning;
    };

    const std::array<EnergyKindColumn, 6> &kinds()
    {
      static const std::array<EnergyKindColumn, 6> list = {
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

    /** Whether an entry has its own column besides that of its kind. */
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
      for (const EnergyKindColumn &kind : kinds())
        if (kind.kind != EnergyKind::work && ledger.has(kind.kind))
          sum += (sum.empty() ? "" : " + ") + kind.name;
      if (ledger.has(EnergyKind::work))
        sum += " - external";
      return sum +
        " minus its value at the start: zero up to round-off for linear "
        "scenes, "
        "otherwise the error due to the step length";
    }
  } // namespace

  void EnergyRecord::add(const Energies &energies)
  {
    // A run that starts from an equilibrium starts with work already done.
    if (!start)
      start = energies.balance(0);

    latest  = energies;
    balance = energies.balance(*start);
    // This order of arguments preserves NaN.
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
    for (const EnergyKindColumn &kind : kinds())
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
    for (const EnergyKindColumn &kind : kinds())
      if (ledger.has(kind.kind))
        values.push_back(energies.sum(kind.kind));
    for (unsigned int i = 0; i < ledger.entries().size(); ++i)
      if (has_own_column(ledger.entries()[i]))
        values.push_back(energies[i]);
    values.push_back(record.balance);
    return values;
  }

  std::vector<std::pair<std::string, double>>
  dissipated_shares(const Energies &energies)
  {
    std::vector<std::pair<std::string, double>> shares;
    const double                                whole = energies.dissipated();
    const std::vector<EnergyEntry> &causes = energies.ledger().entries();
    for (unsigned int i = 0; i < causes.size() && whole > 0; ++i)
      if (causes[i].kind == EnergyKind::dissipated)
        shares.emplace_back(causes[i].name, energies[i] / whole);
    std::stable_sort(shares.begin(),
                     shares.end(),
                     [](const auto &one, const auto &other) {
                       return one.second > other.second;
                     });
    return shares;
  }

  Json json_of_energies(const EnergyRecord &record)
  {
    Json                      json;
    const std::vector<Column> columns = energy_columns(record.latest.ledger());
    const std::vector<double> values  = energy_values(record);
    for (unsigned int i = 0; i < columns.size(); ++i)
      json[columns[i].name] = values[i];
    for (const auto &[cause, share] : dissipated_shares(record.latest))
      json["dissipated_shares"][cause] = share;
    json["largest"]                  = record.largest_energy;
    json["largest_relative_balance"] = record.relative(record.largest_balance);
    return json;
  }
} // namespace auxfem
