#include <auxfem/parameters/errors.h>
#include <auxfem/state/checkpoint_archive.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace auxfem
{
  namespace
  {
    /** The item of records of the whole run. */
    const std::vector<unsigned int> the_run = {0};

    [[noreturn]] void throw_missing_record(const std::string &record)
    {
      throw InputError("The checkpoint has no " + record +
                       ": it was written by another scene or another version "
                       "of auxfem. Resume with those, or start from t = 0.");
    }
  } // namespace

  std::size_t RecordLayout::keep(const std::string               &name,
                                 const std::vector<unsigned int> &items,
                                 const unsigned int values_per_item)
  {
    const std::size_t first = n_values();
    records.push_back({name, items, values_per_item, first});
    return first;
  }

  std::size_t RecordLayout::n_values() const
  {
    return records.empty() ? 0
                           : records.back().first +
        records.back().items.size() * records.back().values_per_item;
  }

  void CheckpointData::keep(const std::string        &name,
                            std::vector<unsigned int> items,
                            const unsigned int        values_per_item,
                            std::vector<double>       values)
  {
    Assert(values.size() == items.size() * values_per_item,
           dealii::ExcInternalError());
    records.push_back(
      {name, std::move(items), values_per_item, std::move(values)});
  }

  void CheckpointData::keep(const std::string &name, std::vector<double> values)
  {
    const unsigned int n = values.size();
    keep(name, the_run, n, std::move(values));
  }

  const CheckpointData::CheckpointRecord &
  CheckpointData::find(const std::string &name) const
  {
    const auto record = std::find_if(records.begin(),
                                     records.end(),
                                     [&](const CheckpointRecord &record) {
                                       return record.name == name;
                                     });
    if (record == records.end())
      throw_missing_record('"' + name + '"');
    return *record;
  }

  void CheckpointData::add(const CheckpointData &others)
  {
    for (const CheckpointRecord &other : others.records)
      if (!has(other.name))
        keep(other.name, {}, other.values_per_item, {});
    for (CheckpointRecord &record : records)
      if (others.has(record.name) &&
          others.values_per_item(record.name) == record.values_per_item)
        {
          const std::set<unsigned int> known(record.items.begin(),
                                             record.items.end());
          std::vector<unsigned int>    more;
          for (const unsigned int item : others.items(record.name))
            if (known.count(item) == 0)
              more.push_back(item);
          const std::vector<double> added =
            others.values(record.name, more, record.values_per_item);
          record.items.insert(record.items.end(), more.begin(), more.end());
          record.values.insert(record.values.end(), added.begin(), added.end());
        }
  }

  bool CheckpointData::has(const std::string &name) const
  {
    return std::any_of(records.begin(),
                       records.end(),
                       [&](const CheckpointRecord &record) {
                         return record.name == name;
                       });
  }

  std::vector<double>
  CheckpointData::values(const std::string               &name,
                         const std::vector<unsigned int> &items,
                         const unsigned int               values_per_item) const
  {
    const CheckpointRecord &record = find(name);
    if (record.values_per_item != values_per_item)
      throw_missing_record('"' + name + "\" with " +
                           std::to_string(values_per_item) + " values each");
    std::map<unsigned int, std::size_t> positions;
    for (std::size_t i = 0; i < record.items.size(); ++i)
      positions[record.items[i]] = i * values_per_item;
    std::vector<double> result;
    result.reserve(items.size() * values_per_item);
    for (const unsigned int item : items)
      {
        const auto position = positions.find(item);
        if (position == positions.end())
          throw_missing_record('"' + name + "\" of item " +
                               std::to_string(item));
        const auto begin = record.values.begin() + position->second;
        result.insert(result.end(), begin, begin + values_per_item);
      }
    return result;
  }

  std::vector<double> CheckpointData::values(const std::string &name,
                                             const unsigned int n) const
  {
    return values(name, the_run, n);
  }

  void CheckpointData::keep_text(const std::string &name,
                                 const std::string &text)
  {
    keep(name, std::vector<double>(text.begin(), text.end()));
  }

  std::string CheckpointData::text(const std::string &name) const
  {
    const std::vector<double> characters =
      values(name, find(name).values_per_item);
    return {characters.begin(), characters.end()};
  }

  void CheckpointArchive::list(const std::string   &name,
                               std::vector<double> &values)
  {
    // A record needs at least one value, so the length comes first.
    if (is_saving())
      {
        std::vector<double> with_length = {double(values.size())};
        with_length.insert(with_length.end(), values.begin(), values.end());
        written->keep(name, std::move(with_length));
        return;
      }
    values = read.values(name, read.values_per_item(name));
    values.erase(values.begin());
  }

  void CheckpointArchive::text(const std::string &name, std::string &text)
  {
    if (is_saving())
      written->keep_text(name, text);
    else
      text = read.text(name);
  }

  void CheckpointArchive::sums(const std::string   &name,
                               std::vector<double> &values)
  {
    if (is_saving())
      {
        values = layout.sum(values);
        written->keep(name, values);
      }
    else
      values = read.values(name, values.size());
    if (layout.rank() > 0)
      values.assign(values.size(), 0.);
  }

  void CheckpointArchive::items(const std::string               &name,
                                const std::vector<unsigned int> &items,
                                const unsigned int   values_per_item,
                                std::vector<double> &values)
  {
    if (is_saving())
      written->keep(name, items, values_per_item, values);
    else
      values = read.values(name, items, values_per_item);
  }
} // namespace auxfem
