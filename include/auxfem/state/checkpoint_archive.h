#ifndef auxfem_state_checkpoint_archive_h
#define auxfem_state_checkpoint_archive_h

#include <auxfem/state/energies.h>

#include <boost/serialization/split_member.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Layout of values of one kind that persist between steps. Item numbers do
   * not depend on the number of ranks, so a run can resume on another number.
   */
  struct Record
  {
    /** Owner and contents, for instance `damper: internal variables`. */
    std::string name;
    /** Numbers of the items on this rank, in order. */
    std::vector<unsigned int> items;
    unsigned int              values_per_item = 1;
    /** Index of the first value among the values of all records. */
    std::size_t first = 0;
  };

  /** List of records and positions of their values. */
  class RecordLayout
  {
  public:
    /** Adds a record; returns the index of its first value. */
    std::size_t keep(const std::string               &name,
                     const std::vector<unsigned int> &items,
                     unsigned int                     values_per_item);

    const std::vector<Record> &list() const
    {
      return records;
    }

    /** Number of values of all records. */
    std::size_t n_values() const;

  private:
    std::vector<Record> records;
  };

  /**
   * Contents of a checkpoint beside the State: named records with their
   * values. Every class that keeps data between steps has a record of its own.
   */
  class CheckpointData
  {
  public:
    /** Adds a record of @p items with @p values, item by item. */
    void keep(const std::string        &name,
              std::vector<unsigned int> items,
              unsigned int              values_per_item,
              std::vector<double>       values);

    /** Adds a record of the whole run, equal on all ranks. */
    void keep(const std::string &name, std::vector<double> values);

    /** Adds a text record of the whole run, equal on all ranks. */
    void keep_text(const std::string &name, const std::string &text);

    bool has(const std::string &name) const;

    /** Adds the records, and items of records, that only @p others have. */
    void add(const CheckpointData &others);

    /** Items of a record. Throws InputError if there is no such record. */
    const std::vector<unsigned int> &items(const std::string &name) const
    {
      return find(name).items;
    }

    /**
     * Values of @p items in a record, which may have more items in another
     * order. Throws InputError if an item is missing.
     */
    std::vector<double> values(const std::string               &name,
                               const std::vector<unsigned int> &items,
                               unsigned int values_per_item) const;

    /**
     * The @p n values of a record of the whole run. Throws InputError if there
     * is no such record.
     */
    std::vector<double> values(const std::string &name, unsigned int n) const;

    /**
     * Text of a record added by keep_text(). Throws InputError if there is no
     * such record.
     */
    std::string text(const std::string &name) const;

    /** Values of each item of a record. Throws InputError if there is no such
     * record. */
    unsigned int values_per_item(const std::string &name) const
    {
      return find(name).values_per_item;
    }

    template <class Archive>
    void save(Archive &archive, const unsigned int /*version*/) const
    {
      archive << records.size();
      for (const CheckpointRecord &record : records)
        record.save(archive);
    }

    /** Writes the format of load() and frees each record once written. */
    template <class Archive>
    void move_to(Archive &archive)
    {
      archive << records.size();
      for (CheckpointRecord &record : records)
        {
          record.save(archive);
          record = {};
        }
      records.clear();
    }

    template <class Archive>
    void load(Archive &archive, const unsigned int /*version*/)
    {
      std::size_t n_records = 0;
      archive >> n_records;
      records.resize(n_records);
      for (CheckpointRecord &record : records)
        archive >> record.name >> record.items >> record.values_per_item >>
          record.values;
    }

    BOOST_SERIALIZATION_SPLIT_MEMBER()

  private:
    struct CheckpointRecord
    {
      std::string               name;
      std::vector<unsigned int> items;
      unsigned int              values_per_item = 1;
      std::vector<double>       values; ///< item by item

      template <class Archive>
      void save(Archive &archive) const
      {
        archive << name << items << values_per_item << values;
      }
    };

    const CheckpointRecord &find(const std::string &name) const;

    std::vector<CheckpointRecord> records;
  };

  /**
   * Saves or restores the data of a run beside its State. Each class has one
   * function `serialize(archive)` for both directions, which lists its members
   * once. All functions are collective.
   */
  class CheckpointArchive
  {
  public:
    /**
     * Saves into @p records. Both arguments must outlive the object.
     * @param layout gives the ranks
     */
    static CheckpointArchive saving(CheckpointData      &records,
                                    const UnknownLayout &layout)
    {
      return {&records, records, layout};
    }

    /** Restores from @p records, which may come from other ranks. */
    static CheckpointArchive restoring(const CheckpointData &records,
                                       const UnknownLayout  &layout)
    {
      return {nullptr, records, layout};
    }

    bool is_saving() const
    {
      return written != nullptr;
    }

    /** Whether a record exists; for data that only some runs have. */
    bool has(const std::string &name) const
    {
      return read.has(name);
    }

    /**
     * Numbers, flags and optional numbers, equal on all ranks. Throws
     * InputError if they cannot be restored, like all functions below.
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
     * Sums that are distributed over ranks. Saving moves the total to the
     * first rank, also in the current run, so that both runs have equal
     * digits.
     */
    template <class... Values>
    void sums(const std::string &name, Values &...values)
    {
      std::vector<double> totals{values...};
      sums(name, totals);
      std::size_t next = 0;
      ((values = totals[next++]), ...);
    }

    /** As sums(), for any number of values. */
    void sums(const std::string &name, std::vector<double> &values);

    /** Largest values over all ranks, with their times. */
    template <class... Largest>
    void largest(const std::string &name, Largest &...largest)
    {
      if (is_saving())
        ((largest = largest.gather_over_ranks(layout)), ...);
      values(name, largest...);
    }

    /** List of any length, equal on all ranks. */
    void list(const std::string &name, std::vector<double> &values);

    void text(const std::string &name, std::string &text);

    /** Values of @p items of this rank, see Record. */
    void items(const std::string               &name,
               const std::vector<unsigned int> &items,
               unsigned int                     values_per_item,
               std::vector<double>             &values);

    /** @name Direct access to the records. */
    ///@{
    /** Requires is_saving(). */
    CheckpointData &to() const
    {
      return *written;
    }

    const CheckpointData &from() const
    {
      return read;
    }
    ///@}

  private:
    /** Conversion of values to a list of numbers. */
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

    CheckpointArchive(CheckpointData *const written,
                      const CheckpointData &read,
                      const UnknownLayout  &layout)
      : written(written)
      , read(read)
      , layout(layout)
    {}

    CheckpointData *const written; ///< nullptr while restoring
    const CheckpointData &read;
    const UnknownLayout  &layout;
  };
} // namespace auxfem

#endif
