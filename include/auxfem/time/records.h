#ifndef auxfem_time_records_h
#define auxfem_time_records_h

#include <boost/serialization/split_member.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstddef>
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
  class Records
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
    void add(const Records &others);

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
      for (const KeptRecord &record : records)
        record.save(archive);
    }

    /** Writes what load() reads, and lets go of each record as soon as it is
     * saved. */
    template <class Archive>
    void move_to(Archive &archive)
    {
      archive << records.size();
      for (KeptRecord &record : records)
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
      for (KeptRecord &record : records)
        archive >> record.name >> record.items >> record.values_per_item >>
          record.values;
    }

    BOOST_SERIALIZATION_SPLIT_MEMBER()

  private:
    struct KeptRecord
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

    const KeptRecord &find(const std::string &name) const;

    std::vector<KeptRecord> records;
  };
} // namespace auxfem

#endif
