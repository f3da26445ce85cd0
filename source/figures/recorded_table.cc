#include <auxfem/figures/recorded_table.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Fields of a line, which are in quotes if they contain commas. */
    std::vector<std::string> fields_of(const std::string &line)
    {
      std::vector<std::string> fields(1);
      bool                     quoted = false;
      for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '"')
          {
            const bool is_text =
              quoted && i + 1 < line.size() && line[i + 1] == '"';
            if (is_text)
              fields.back() += line[++i];
            else
              quoted = !quoted;
          }
        else if (line[i] == ',' && !quoted)
          fields.emplace_back();
        else if (line[i] != '\r')
          fields.back() += line[i];
      return fields;
    }

    double number_in(const char *begin, const char *end)
    {
      double value = 0;
      if (std::from_chars(begin, end, value).ptr != end || begin == end)
        return std::numeric_limits<double>::quiet_NaN();
      return value;
    }

    /** Appends the numbers of @p line; whether there is one for each column. */
    bool append_row(const std::string                &line,
                    std::vector<std::vector<double>> &columns)
    {
      std::vector<double> row;
      row.reserve(columns.size());
      const char *begin = line.data(), *const end = begin + line.size();
      while (true)
        {
          const char *const comma = std::find(begin, end, ',');
          row.push_back(number_in(begin, comma));
          if (comma == end)
            break;
          begin = comma + 1;
        }
      if (row.size() != columns.size())
        return false;
      for (std::size_t i = 0; i < row.size(); ++i)
        columns[i].push_back(row[i]);
      return true;
    }
  } // namespace

  const std::vector<double> *RecordedTable::find(const std::string &name) const
  {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? nullptr : &columns[found - names.begin()];
  }

  RecordedHistory RecordedTable::history(const std::string &name) const
  {
    const std::vector<double> *const values = find(name);
    if (values == nullptr)
      throw InputError("history.csv has no column \"" + name +
                       "\". Allowed: " + joined(names, 60));
    return {columns[0], *values};
  }

  RecordedTable read_table(const std::string &file)
  {
    RecordedTable table;
    std::ifstream stream(file);
    std::string   line;
    if (!std::getline(stream, line))
      return table;
    table.names = fields_of(line);
    table.columns.resize(table.names.size());
    while (std::getline(stream, line))
      if (stream.eof() || !append_row(line, table.columns))
        break;
    return table;
  }
} // namespace auxfem
