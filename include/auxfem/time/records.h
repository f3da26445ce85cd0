#ifndef auxfem_time_records_h
#define auxfem_time_records_h

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

    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &name &items &values_per_item &first;
    }
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

    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &records;
    }

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
    /** Adds a record of @p items with @p new_values, item by item. */
    void keep(const std::string               &name,
              const std::vector<unsigned int> &items,
              unsigned int                     values_per_item,
              const std::vector<double>       &new_values);

    /** Adds a record of the run as a whole, the same on all ranks. */
    void keep(const std::string &name, const std::vector<double> &new_values);

    /** Adds a record of the run as a whole, a text, the same on all ranks. */
    void keep_text(const std::string &name, const std::string &text);

    bool has(const std::string &name) const;

    /** Adds what @p others have beside it: records, and items of records. */
    void add(const Records &others);

    /** Adds all of @p others, of somebody of whom there may be several. */
    void keep_all(const std::string &owner, const Records &others);

    /** What keep_all() has kept. */
    Records all_of(const std::string &owner) const;

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
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &layout &all_values;
    }

  private:
    const Record &find(const std::string &name) const;

    RecordLayout        layout;
    std::vector<double> all_values;
  };
} // namespace auxfem

#endif
