#include <auxfem/algebra/shared_work.h>
#include <auxfem/analysis/run_statistics.h>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int n_values = 5;

    /** Whether there is one, then what it is. */
    std::vector<double> values_of(const std::optional<Occurrence> &occurrence)
    {
      if (!occurrence)
        return std::vector<double>(n_values, 0.);
      return {1.,
              occurrence->size,
              occurrence->time,
              double(occurrence->number),
              double(occurrence->group)};
    }

    std::optional<Occurrence> occurrence_of(const std::vector<double> &values)
    {
      if (values[0] == 0)
        return std::nullopt;
      return Occurrence{values[1],
                        values[2],
                        static_cast<unsigned int>(values[3]),
                        static_cast<unsigned int>(values[4])};
    }

    /** The one of all ranks that comes before each other. */
    template <class ComesBefore>
    std::optional<Occurrence> of_all(const std::optional<Occurrence> &mine,
                                     const MPI_Comm     communicator,
                                     const ComesBefore &comes_before)
    {
      std::optional<Occurrence> best;
      const std::vector<double> all =
        of_all_ranks(values_of(mine), communicator);
      for (auto values = all.begin(); values < all.end(); values += n_values)
        if (const auto other = occurrence_of({values, values + n_values});
            other && (!best || comes_before(*other, *best)))
          best = other;
      return best;
    }

    std::string record_of(const std::string &entry)
    {
      return "watch: " + entry;
    }
  } // namespace

  void Occurrences::add(const Occurrence &occurrence)
  {
    if (!first_one)
      first_one = occurrence;
    if (!largest_one || occurrence.size > largest_one->size)
      largest_one = occurrence;
  }

  std::optional<Occurrence> Occurrences::first() const
  {
    return of_all(first_one,
                  communicator,
                  [](const Occurrence &one, const Occurrence &other) {
                    return one.time < other.time ||
                      (one.time == other.time && one.size > other.size);
                  });
  }

  std::optional<Occurrence> Occurrences::largest() const
  {
    return of_all(largest_one,
                  communicator,
                  [](const Occurrence &one, const Occurrence &other) {
                    return one.size > other.size;
                  });
  }

  void Occurrences::serialize(const std::string &name,
                              CheckpointArchive &archive)
  {
    for (const auto &[which, of_all] :
         {std::pair(&first_one, &Occurrences::first),
          {&largest_one, &Occurrences::largest}})
      {
        std::vector<double> values =
          values_of(archive.is_saving() ? (this->*of_all)() : std::nullopt);
        archive.list(name + (which == &first_one ? ": first" : ": largest"),
                     values);
        *which = occurrence_of(values);
      }
  }

  void RunStatistics::serialize(CheckpointArchive &archive)
  {
    for (auto &[name, number] : numbers)
      archive.values(record_of(name), number);
    for (auto &[name, largest] : maxima)
      archive.values(record_of(name), largest);
    for (auto &[name, occurrences] : all_occurrences)
      occurrences.serialize(record_of(name), archive);
    for (auto &[name, list] : lists)
      archive.list(record_of(name), list);
    for (auto &[name, text] : texts)
      archive.text(record_of(name), text);
  }
} // namespace auxfem
