#ifndef auxfem_time_checkpoint_archive_h
#define auxfem_time_checkpoint_archive_h

#include <auxfem/time/largest_in_time.h>
#include <auxfem/time/records.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Saves what a run remembers beside its State, or restores it. A class has
   * one function `serialize(archive)` for both directions, which names its
   * members once. All functions are collective.
   */
  class CheckpointArchive
  {
  public:
    /** Saves into @p records. Both must outlive the object.
     * @param layout knows the ranks */
    static CheckpointArchive saving(Records             &records,
                                    const UnknownLayout &layout)
    {
      return {&records, records, layout};
    }

    /** Restores from @p records, which other ranks may have saved. */
    static CheckpointArchive restoring(const Records       &records,
                                       const UnknownLayout &layout)
    {
      return {nullptr, records, layout};
    }

    bool is_saving() const
    {
      return written != nullptr;
    }

    /** Whether there is a record; for what not every run has. */
    bool has(const std::string &name) const
    {
      return read.has(name);
    }

    /**
     * Numbers, flags and optional numbers that are the same on all ranks.
     * Throws InputError if they cannot be restored, as all functions below.
     */
    template <class... Values>
    void values(const std::string &name, Values &...values)
    {
      Numbers numbers;
      if (is_saving())
        {
          (numbers.put(values), ...);
          written->keep(name, numbers.list);
          return;
        }
      numbers.list = read.values(name, (Numbers::count(values) + ...));
      (numbers.get(values), ...);
    }

    /**
     * Sums, of which each rank has its part. Afterwards the first rank has the
     * whole sum, also in the run that goes on: so both have equal digits.
     */
    template <class... Values>
    void sums(const std::string &name, Values &...values)
    {
      std::vector<double> totals{values...};
      sums(name, totals);
      std::size_t next = 0;
      ((values = totals[next++]), ...);
    }

    /** As sums(), of any number. */
    void sums(const std::string &name, std::vector<double> &values);

    /** The largest values of all ranks, in time. */
    template <class... Largest>
    void largest(const std::string &name, Largest &...largest)
    {
      if (is_saving())
        ((largest = largest.of_all_ranks(layout)), ...);
      values(name, largest...);
    }

    /** A list of any length, the same on all ranks. */
    void list(const std::string &name, std::vector<double> &values);

    void text(const std::string &name, std::string &text);

    /** Values by @p items of this rank, see Record. */
    void items(const std::string               &name,
               const std::vector<unsigned int> &items,
               unsigned int                     values_per_item,
               std::vector<double>             &values);

    /** @name The records, for other forms. */
    ///@{
    /** Only if is_saving(). */
    Records &to() const
    {
      return *written;
    }

    const Records &from() const
    {
      return read;
    }
    ///@}

  private:
    /** Values as a list of numbers. */
    struct Numbers
    {
      std::vector<double> list;
      std::size_t         next = 0;

      template <class Value>
      static constexpr unsigned int count(const Value & /*value*/)
      {
        return 1;
      }
      static constexpr unsigned int count(const std::optional<double> & /*v*/)
      {
        return 2;
      }
      static constexpr unsigned int count(const LargestInTime & /*v*/)
      {
        return 2;
      }

      template <class Value>
      void put(const Value &value)
      {
        list.push_back(static_cast<double>(value));
      }
      void put(const std::optional<double> &value)
      {
        list.insert(list.end(), {value ? 1. : 0., value.value_or(0.)});
      }
      void put(const LargestInTime &largest)
      {
        list.insert(list.end(), {largest.value, largest.time});
      }

      template <class Value>
      void get(Value &value)
      {
        value = static_cast<Value>(list[next++]);
      }
      void get(std::optional<double> &value)
      {
        value = list[next] != 0 ? std::optional(list[next + 1]) : std::nullopt;
        next += 2;
      }
      void get(LargestInTime &largest)
      {
        largest = {list[next], list[next + 1]};
        next += 2;
      }
    };

    CheckpointArchive(Records *const       written,
                      const Records       &read,
                      const UnknownLayout &layout)
      : written(written)
      , read(read)
      , layout(layout)
    {}

    Records *const       written; ///< nullptr while restoring
    const Records       &read;
    const UnknownLayout &layout;
  };
} // namespace auxfem

#endif
