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
   * Values of the same kind that outlive a step. Their items are named by
   * numbers that are the same on any number of ranks, so that a run can be
   * resumed on another.
   */
  struct Record
  {
    /** Who keeps it and what it is, e.g. `damper: internal variables`. */
    std::string name;
    /** Numbers of the items kept on this rank, in order. */
    std::vector<unsigned int> items;
    unsigned int              values_per_item = 1;
    /** Index of the first value among those of all records. */
    std::size_t first = 0;
  };

  /** Which records there are and where their values lie. */
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

    /** Values of all records. */
    std::size_t n_values() const;

  private:
    std::vector<Record> records;
  };

  /**
   * Records with their values: what a run that is resumed gets back beside the
   * State. Who remembers something from one step to the next keeps it here when
   * a checkpoint is taken, under a name of its own.
   */
  class CheckpointData
  {
  public:
    /** Adds a record of @p items with @p values, item by item. */
    void keep(const std::string        &name,
              std::vector<unsigned int> items,
              unsigned int              values_per_item,
              std::vector<double>       values);

    /** Adds a record of the run as a whole, the same on all ranks. */
    void keep(const std::string &name, std::vector<double> values);

    /** Adds a record of the run as a whole, a text, the same on all ranks. */
    void keep_text(const std::string &name, const std::string &text);

    bool has(const std::string &name) const;

    /** Adds what @p others have beside it: records, and items of records. */
    void add(const CheckpointData &others);

    /** Items of a record. Throws InputError if there is no such record. */
    const std::vector<unsigned int> &items(const std::string &name) const
    {
      return find(name).items;
    }

    /**
     * The values of @p items in a record, which may have others beside them and
     * in another order. Throws InputError if it does not have them.
     */
    std::vector<double> values(const std::string               &name,
                               const std::vector<unsigned int> &items,
                               unsigned int values_per_item) const;

    /**
     * The @p n values of a record of the run as a whole. Throws InputError if
     * there is no such record.
     */
    std::vector<double> values(const std::string &name, unsigned int n) const;

    /** What keep_text() has kept. Throws InputError if there is no such record.
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

    /** Writes what load() reads, and lets go of each record as soon as it is
     * saved. */
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
   * Saves what a run remembers beside its State, or restores it. A class has
   * one function `serialize(archive)` for both directions, which names its
   * members once. All functions are collective.
   */
  class CheckpointArchive
  {
  public:
    /** Saves into @p records. Both must outlive the object.
     * @param layout knows the ranks */
    static CheckpointArchive saving(CheckpointData      &records,
                                    const UnknownLayout &layout)
    {
      return {&records, records, layout};
    }

    /** Restores from @p records, which other ranks may have saved. */
    static CheckpointArchive restoring(const CheckpointData &records,
                                       const UnknownLayout  &layout)
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
        ((largest = largest.over_all_ranks(layout)), ...);
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
