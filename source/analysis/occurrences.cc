#include <auxfem/algebra/shared_work.h>
#include <auxfem/analysis/occurrences.h>

#include <vector>

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
  } // namespace

  void Occurrences::add(const Occurrence &occurrence)
  {
    if (!first)
      first = occurrence;
    if (!largest || occurrence.size > largest->size)
      largest = occurrence;
  }

  std::optional<Occurrence>
  Occurrences::first_of_all(const MPI_Comm communicator) const
  {
    return of_all(first,
                  communicator,
                  [](const Occurrence &one, const Occurrence &other) {
                    return one.time < other.time ||
                      (one.time == other.time && one.size > other.size);
                  });
  }

  std::optional<Occurrence>
  Occurrences::largest_of_all(const MPI_Comm communicator) const
  {
    return of_all(largest,
                  communicator,
                  [](const Occurrence &one, const Occurrence &other) {
                    return one.size > other.size;
                  });
  }

  void Occurrences::save(Records           &records,
                         const std::string &name,
                         const MPI_Comm     communicator) const
  {
    records.keep(name + ": first", values_of(first_of_all(communicator)));
    records.keep(name + ": largest", values_of(largest_of_all(communicator)));
  }

  void Occurrences::resume(const Records &records, const std::string &name)
  {
    first   = occurrence_of(records.values(name + ": first", n_values));
    largest = occurrence_of(records.values(name + ": largest", n_values));
  }
} // namespace auxfem
