#ifndef auxfem_model_unknown_records_h
#define auxfem_model_unknown_records_h

#include <auxfem/algebra/vector.h>
#include <auxfem/model/global_numbers.h>
#include <auxfem/model/numbering.h>
#include <auxfem/state/checkpoint_archive.h>

#include <string>

namespace auxfem
{
  /** Words for a component of motion, e.g. `vertical displacement` or `rotation
   * about x`. */
  const char *motion_name(unsigned int component, unsigned int dimension);

  /**
   * Words for a local unknown, e.g. `rotation of joint 12 at (0.01, 0.02)`; for
   * nodes inside a strut that strut is named.
   */
  std::string describe(const DofNumbering &numbering, unsigned int unknown);

  /**
   * Words for the owned unknown of largest @p size (by local unknown, of which
   * the owned ones count; rotations made comparable by the caller) over all
   * ranks; the same on every rank. Collective.
   */
  std::string describe_largest(const DofNumbering        &numbering,
                               const std::vector<double> &size);

  /** Why @p joint has no rotation and what to do, as a sentence. */
  std::string why_no_rotation(const DofNumbering &numbering,
                              unsigned int        joint);

  /**
   * Unknowns while they are counted: the rank that claims one first owns it and
   * gives it the next of its own numbers. To be asked in the same order on
   * every rank.
   */
  class UnknownDistribution
  {
  public:
    /** Who owns an unknown (-1: nobody, it does not exist) and its number
     * there. */
    struct Unknown
    {
      int owner = -1, number = -1;
    };
    using Motion = std::array<Unknown, n_motion_components>;

    /** Nothing is claimed yet. */
    UnknownDistribution(const Lattice &lattice,
                        const Ties    &ties,
                        unsigned int   n_ranks);

    /**
     * An end of an elastic strut: the joint's displacement, and its rotation or
     * that of the released end. Claimed by @p rank.
     */
    void assign_end(unsigned int strut,
                    unsigned int end,
                    unsigned int component,
                    int          rank);

    /** First of @p n numbers of @p rank for the inner nodes of a strut. */
    int assign_inner(unsigned int n, int rank);

    /**
     * The displacements of all joints no elastic strut has claimed.
     *
     * @param ranks by strut
     */
    void assign_joints(const std::vector<unsigned int> &ranks);

    /** Own unknowns and multipliers of rigid parts, on the rank of their first
     * joint. */
    void assign_rigid_parts();

    /** Multipliers of hinges, on the rank of the rotation that they guide. */
    void assign_hinges();

    unsigned int n_joints() const
    {
      return joint_unknowns.size();
    }

    /** Number of unknowns of each rank. */
    const std::vector<int> &counts() const
    {
      return count;
    }

    /** By component; of a joint that turns with a rigid part, the part's. */
    Motion joint(unsigned int joint) const;

    /** Rotations of the released ends of elastic struts, by strut and end. */
    const std::map<std::pair<unsigned int, unsigned int>, Motion> &
    released_ends() const
    {
      return released_end_unknowns;
    }

    /** A rigid part's own unknowns, if it has a rotation of its own. */
    struct RigidPartUnknowns
    {
      Motion                    motion;
      std::vector<unsigned int> clamped_joints; ///< in the plane
      std::vector<Unknown>      multipliers;
    };
    const std::vector<RigidPartUnknowns> &rigid_parts() const
    {
      return part_unknowns;
    }

    /** Multipliers of Ties::hinged. */
    const std::vector<std::array<Unknown, 2>> &hinges() const
    {
      return hinge_unknowns;
    }

  private:
    /** Claimed by @p rank if it is new. */
    void assign(Unknown &unknown, int rank);

    /** The rotation that @p rotation_owner has. */
    Motion       &motion_of(const RotationOwner &rotation_owner);
    const Motion &motion_of(const RotationOwner &rotation_owner) const;

    const Lattice                   &lattice;
    const Ties                      &ties;
    const std::vector<RotationOwner> rotation_of_joint;
    std::vector<Motion>              joint_unknowns;
    std::map<std::pair<unsigned int, unsigned int>, Motion>
                                        released_end_unknowns;
    std::vector<RigidPartUnknowns>      part_unknowns;
    std::vector<std::array<Unknown, 2>> hinge_unknowns;
    std::vector<int>                    count;
  };

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
    void keep(const std::string &name,
              const Vector      &values,
              CheckpointData    &records) const;

    /**
     * The values at all local unknowns. Throws InputError if @p records do not
     * have them. Collective.
     */
    Vector values(const std::string &name, const CheckpointData &records) const;

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
