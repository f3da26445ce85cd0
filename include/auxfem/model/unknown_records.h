#ifndef auxfem_model_unknown_records_h
#define auxfem_model_unknown_records_h

#include <auxfem/algebra/vector.h>
#include <auxfem/model/numbering.h>
#include <auxfem/time/checkpoint_archive.h>

namespace auxfem
{
  /**
   * Records of values at unknowns, under serial numbers, which follow the order
   * of the lattice's parts, whatever rank owns an unknown. So what some ranks
   * have kept others find, also if they are more or fewer.
   */
  class UnknownRecords
  {
  public:
    /** @param numbering must outlive the object. */
    explicit UnknownRecords(const DofNumbering &numbering);

    /** With the ghosts of @p layout, which has at least those of @p numbering.
     * Both must outlive the object. Collective. */
    UnknownRecords(const DofNumbering &numbering, const UnknownLayout &layout);

    /** Serial number of a local unknown. */
    unsigned int serial_number(const unsigned int local) const
    {
      return serial[local];
    }

    /** Keeps the owned ones of @p values at local unknowns. */
    void
    keep(const std::string &name, const Vector &values, Records &records) const;

    /**
     * The values at all local unknowns. Throws InputError if @p records do not
     * have them. Collective.
     */
    Vector values(const std::string &name, const Records &records) const;

    /** Saves or restores @p values at all local unknowns. Collective. */
    void serialize(const std::string &name,
                   Vector            &values,
                   CheckpointArchive &archive) const
    {
      if (archive.is_saving())
        keep(name, values, archive.to());
      else
        values = this->values(name, archive.from());
    }

    /** The same of values that need not be there. */
    void serialize(const std::string     &name,
                   std::optional<Vector> &values,
                   CheckpointArchive     &archive) const
    {
      if (archive.is_saving() ? !values.has_value() : !archive.has(name))
        return values.reset();
      if (!values)
        values.emplace();
      serialize(name, *values, archive);
    }

  private:
    std::vector<unsigned int> owned() const
    {
      return {serial.begin(), serial.begin() + layout.n_owned()};
    }

    const UnknownLayout            &layout;
    const std::vector<unsigned int> serial; ///< numbers, of local unknowns
  };
} // namespace auxfem

#endif
