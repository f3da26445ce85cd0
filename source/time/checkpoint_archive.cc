#include <auxfem/time/checkpoint_archive.h>

namespace auxfem
{
  void CheckpointArchive::list(const std::string   &name,
                               std::vector<double> &values)
  {
    // A record has one value at least: the length comes first.
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
