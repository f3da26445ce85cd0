#ifndef auxfem_model_unknown_records_h
#define auxfem_model_unknown_records_h

#include <auxfem/algebra/vector.h>
#include <auxfem/model/global_numbers.h>
#include <auxfem/model/numbering.h>
#include <auxfem/state/checkpoint_archive.h>

#include <string>

namespace auxfem
{
  /**
   * Name of a motion component, e.g. `vertical displacement` or `rotation about
   * x`.
   */
  const char *motion_name(unsigned int component, unsigned int dimension);

  /**
   * Description of a local unknown, e.g. `rotation of joint 12 at (0.01,
   * 0.02)`; inner nodes are named by their strut.
   */
  std::string describe(const DofNumbering &numbering, unsigned int unknown);

  /**
   * Description of the owned unknown with the largest @p size (by local
   * unknown) over all ranks. The caller makes rotations comparable. Equal on
   * all ranks; collective.
   */
  std::string describe_largest(const DofNumbering        &numbering,
                               const std::vector<double> &size);

  /** Sentence for the user: why @p joint has no rotation, and what to do. */
  std::string missing_rotation_reason(const DofNumbering &numbering,
                                      unsigned int        joint);

  /**
   * Assigns unknowns to ranks: the first rank that claims an unknown owns and
   * numbers it. Call in the same order on every rank.
   */
  class UnknownDistribution
  {
  public:
    /** Owner of an unknown (-1 if it does not exist) and its number on that
     * rank. */
    struct Unknown
    {
      int owner = -1, number = -1;
    };
    using Motion = std::array<Unknown, n_motion_components>;

    /** Starts without any claims. */
    UnknownDistribution(const Lattice &lattice,
                        const Ties    &ties,
                        unsigned int   n_ranks);

    /** Claims a component at the end of an elastic strut for @p rank: joint
     * displacement, joint rotation or released rotation. */
    void assign_end(unsigned int strut,
                    unsigned int end,
                    unsigned int component,
                    int          rank);

    /** Claims @p n inner unknowns of a strut for @p rank; returns the first
     * number. */
    int assign_inner(unsigned int n, int rank);

    /**
     * Claims the displacements of joints without elastic struts, and rotations
     * that they have with their images in an infinite lattice.
     *
     * @param ranks owner by strut
     */
    void assign_joints(const std::vector<unsigned int> &ranks);

    /** Claims unknowns and multipliers of rigid parts for the rank of their
     * first joint. */
    void assign_rigid_parts();

    /** Claims multipliers of hinges for the rank of the guided rotation. */
    void assign_hinges();

    /** Claims multipliers of linear relations for the rank of their first
     * joint. */
    void assign_relations();

    unsigned int n_joints() const
    {
      return joint_unknowns.size();
    }

    /** Number of unknowns of each rank. */
    const std::vector<int> &counts() const
    {
      return count;
    }

    /** Unknowns of a joint by component; the rotation may be that of a rigid
     * part. */
    Motion joint(unsigned int joint) const;

    /** Rotations of the released ends of elastic struts, by strut and end. */
    const std::map<std::pair<unsigned int, unsigned int>, Motion> &
    released_ends() const
    {
      return released_end_unknowns;
    }

    /** Unknowns owned by a rigid part with a rotation. */
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

    /** Multipliers of Ties::relations. */
    const std::vector<Unknown> &relations() const
    {
      return relation_unknowns;
    }

  private:
    /** Claims an unowned unknown for @p rank. */
    void assign(Unknown &unknown, int rank);

    /** Unknowns of a rotation. */
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
    std::vector<Unknown>                relation_unknowns;
    std::vector<int>                    count;
  };

  /**
   * Checkpoint records of values at unknowns by serial number, which follows
   * the order of the lattice. Restarts may use a different number of ranks.
   */
  class UnknownRecords
  {
  public:
    /** @param numbering must outlive the object. */
    explicit UnknownRecords(const DofNumbering &numbering);

    /** As above with the ghosts of @p layout, which include those of
     * @p numbering. Both must outlive the object. Collective. */
    UnknownRecords(const DofNumbering &numbering, const UnknownLayout &layout);

    /** Serial number of a local unknown. */
    unsigned int serial_number(const unsigned int local) const
    {
      return serial[local];
    }

    /** Stores the owned entries of @p values. */
    void keep(const std::string &name,
              const Vector      &values,
              CheckpointData    &records) const;

    /** Restores the values at all local unknowns. Throws InputError if
     * @p records lack them. Collective. */
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

    /** As above, for optional values. */
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
