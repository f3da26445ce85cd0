#ifndef auxfem_model_numbering_h
#define auxfem_model_numbering_h

#include <auxfem/algebra/unknowns.h>
#include <auxfem/mesh/motion_components.h>
#include <auxfem/mesh/strut_mesh.h>

#include <Epetra_Import.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <array>
#include <map>
#include <memory>

namespace auxfem
{
  /** Words for a component of motion, e.g. `vertical displacement` or `rotation
   * about x`. */
  const char *motion_in_words(unsigned int component, unsigned int dimension);

  /** Something with a rotation, or the ground, which has none. */
  struct Turning
  {
    enum class What
    {
      ground,
      joint,     ///< with the struts that are rigidly connected there
      strut_end, ///< released from its joint
      rigid_part ///< in space, RigidPart::has_rotation
    };
    What what = What::ground;
    /** Of the joint, strut or rigid part. */
    unsigned int index = 0;
    unsigned int end   = 0; ///< of the strut

    bool operator==(const Turning &other) const
    {
      return what == other.what && index == other.index && end == other.end;
    }
  };

  /** Two rotations at one joint that are coupled by a spring or a hinge. */
  struct TurningPair
  {
    unsigned int joint;
    Turning      base, end;
  };

  /** A component of the motion of a joint. */
  struct JointMotion
  {
    unsigned int joint, component;
  };

  /** What is released, tied and prescribed beyond the rigid joints. */
  struct Ties
  {
    /**
     * For every strut: whether the rotation of its first, second end is free
     * of the joint.
     */
    std::vector<std::array<bool, 2>> released;

    /** Pairs of joints whose motions act on each other through a connector. */
    std::vector<JointPair> connected;

    /** Rotations coupled by springs. */
    std::vector<TurningPair> sprung;

    /** Rotations coupled by revolute hinges, with two conditions each. */
    std::vector<TurningPair> hinged;

    /** Motions that supports prescribe; joints need not have them all. */
    std::vector<JointMotion> prescribed;
  };

  /**
   * For each joint what gives it its rotation: the joint itself, if an elastic
   * strut that is not released ends there; in space a rigid part that clamps
   * these struts, or the only rigid part with a rotation, if no such strut ends
   * there; else nothing (ground).
   * @param released as Ties::released.
   */
  std::vector<Turning>
  joint_rotations(const Lattice                          &lattice,
                  const std::vector<std::array<bool, 2>> &released);

  class ClaimedUnknowns;

  /** Owned rows apart by what is measured and by whether they are free. */
  struct OwnedRows
  {
    std::vector<int> free_translations, free_rotations, prescribed_translations,
      prescribed_rotations, multipliers;
  };

  /**
   * Numbering of the unknowns of a lattice: at every node u_x, u_y and the
   * rotation in the plane, u_x, u_y, u_z and the spins about x, y, z in space.
   * The ends of all struts at a joint share its displacements, those not
   * released also its rotation, so a joint is one set of unknowns and no
   * constraint equation is needed. Joints at which only rigid struts end have
   * no rotation, in space that of the rigid part. Rigid parts that turn in
   * space have the displacement of their centre of mass and a rotation of their
   * own. The conditions of rigid parts and of revolute hinges add a Lagrange
   * multiplier each.
   *
   * Each rank owns a contiguous range of global numbers and stores ("local")
   * its owned unknowns first, then the ghosts that its elements and connectors
   * touch. Elements and rigid parts are kept on every rank that owns one of
   * their unknowns, so owned rows of residual and tangent are complete without
   * communication.
   */
  class DofNumbering
  {
  public:
    /** An element kept on this rank. */
    struct Element
    {
      StrutMesh::Place place;
      /** Rank that counts the element's energy and writes it to files. */
      unsigned int owner;
    };

    DofNumbering(const Lattice   &lattice,
                 const StrutMesh &mesh,
                 unsigned int     order,
                 const Ties      &ties,
                 MPI_Comm         communicator);

    unsigned int order() const;

    /** Unknowns a node: 3 in the plane, 6 in space. */
    unsigned int n_components() const;

    /** The components of motion that nodes have: 0, 1, 5 in the plane, else
     * all. */
    const std::vector<unsigned int> &components() const;

    /** Global number of unknowns, prescribed ones included. */
    unsigned int n_unknowns() const;

    unsigned int n_owned() const;
    unsigned int n_local() const;
    unsigned int rank() const;
    unsigned int n_ranks() const;

    const Epetra_MpiComm &communicator() const;

    /** Rows this rank owns; global numbers. */
    const Epetra_Map &owned_map() const;

    /** Owned rows, then ghosts. The same as owned_map() on one rank. */
    const Epetra_Map &local_map() const;

    /** Brings owned values to the ghosts of other ranks. */
    const Epetra_Import &importer() const;

    /** Elements kept on this rank. */
    const std::vector<Element> &elements() const;

    bool is_owned(const Element &element) const;

    /** Whether a local unknown is this rank's own; false for -1. */
    bool is_owned(int local) const;

    /** Whether a local unknown is a rotation, prescribed or not. */
    bool is_rotation(unsigned int local) const;

    /**
     * Local numbers of the (order + 1) * n_components() unknowns of element @p e,
     * node by node in the node order of FE_Q (both ends, then the inner nodes).
     */
    const int *element_unknowns(unsigned int e) const;

    /**
     * Local number of a joint's unknown, by component of motion; -1 if it does
     * not exist (in the plane, or all struts released) or is not kept on this
     * rank.
     */
    int joint_unknown(unsigned int joint, unsigned int component) const;

    /** Whether a joint has this unknown at all, known on every rank. */
    bool joint_has(unsigned int joint, unsigned int component) const;

    /**
     * Whether a rigid part and no elastic strut that is not released ends at
     * @p joint: it has no rotation of its own.
     */
    bool is_rigid_joint(unsigned int joint) const;

    /** Why @p joint has no rotation and what to do, as a sentence. */
    std::string why_no_rotation(unsigned int joint) const;

    /**
     * Local number of a component of the rotation of a strut's end, released
     * or not; -1 if not on this rank.
     */
    int end_rotation(unsigned int strut,
                     unsigned int end,
                     unsigned int component = rotation_z) const;

    /**
     * The rotations kept on this rank, in space: local numbers of their spins
     * about x, y, z. Empty in the plane.
     */
    const std::vector<std::array<int, 3>> &spatial_rotations() const;

    /** Index into spatial_rotations() of that which a local unknown is part of;
     * -1: none. */
    int spatial_rotation(unsigned int local) const;

    /** Axis, 0 to 2, about which a local unknown with a spatial_rotation() is
     * the spin. */
    unsigned int spin_axis(unsigned int local) const;

    /** Local number of a component of a rotation; -1: ground, or not on this
     * rank. */
    int rotation_unknown(const Turning &turning, unsigned int component) const;

    /**
     * Number of a joint's unknown that is the same for joints that share it,
     * the same on every rank; -1 if there is none.
     */
    int global_number(unsigned int joint, unsigned int component) const;

    /**
     * Local number of an unknown of a rigid part's own,
     * RigidPart::has_rotation: displacement of its centre of mass, rotation. -1
     * if not on this rank.
     */
    int rigid_part_unknown(unsigned int rigid_part,
                           unsigned int component) const;

    /**
     * Local number of a multiplier of a rigid part: of one with a rotation of
     * its own 3 k + c for component c of joint k. Of others 0 for the distance
     * of the base joints, then d for each joint k = 2, 3, ... of the part in d
     * dimensions; then, in the plane, one for each of its clamped joints. -1 if
     * not on this rank.
     */
    int multiplier(unsigned int rigid_part, unsigned int number) const;

    /** Number of multipliers of a rigid part; the same on every rank. */
    unsigned int n_multipliers(unsigned int rigid_part) const;

    /**
     * Local number of multiplier @p number (0, 1) of a pair of Ties::hinged; -1
     * if not on this rank.
     */
    int hinge_multiplier(unsigned int hinge, unsigned int number) const;

    /** In the plane: joints whose rotation is tied to that of a rigid part. */
    const std::vector<unsigned int> &
    clamped_joints(unsigned int rigid_part) const;

    /** Rigid parts kept on this rank, with all their unknowns. */
    const std::vector<unsigned int> &rigid_parts() const;

    /** Local numbers of the multipliers kept on this rank. */
    const std::vector<int> &multipliers() const;

    /** Number of all multipliers, over all ranks. */
    unsigned int n_multipliers() const;

    /** Kind of a local unknown. */
    UnknownKind kind(unsigned int local) const;

    /** The owned rows by kind. */
    OwnedRows owned_rows() const;

    /**
     * Number of displacements and rotations that are not prescribed, over all
     * ranks.
     */
    unsigned int n_free() const;

    /**
     * Words for a local unknown, e.g. `rotation of joint 12 at (0.01, 0.02)`;
     * for nodes inside a strut that strut is named.
     */
    std::string describe(unsigned int local) const;

    /**
     * Words for the owned unknown of largest @p size (n_owned entries, rotations
     * made comparable by the caller) over all ranks; the same on every rank.
     */
    std::string describe_largest(const std::vector<double> &size) const;

  private:
    /** Global numbers by component of motion; -1: does not exist. */
    using MotionNumbers = std::array<int, n_motion_components>;

    void number_unknowns(const StrutMesh &mesh, const Ties &ties);
    void take_numbers(const ClaimedUnknowns &claimed);
    void collect_local(const StrutMesh &mesh, const Ties &ties);
    /** Global numbers of a rotation, components below first_rotation -1. */
    MotionNumbers rotation_numbers(const Turning &turning) const;
    /** Global numbers of all unknowns of a rigid part, its multipliers too. */
    std::vector<int> rigid_part_numbers(unsigned int rigid_part) const;
    /**
     * Global numbers of unknowns that act on each other beyond elements: of
     * rigid parts, and of coupled rotations with their multipliers.
     */
    std::vector<std::vector<int>> coupled_numbers(const Ties &ties) const;
    void                          index_multipliers();
    void                          mark_rotations();
    void mark_prescribed(const std::vector<JointMotion> &motions);
    /** Groups the local spins into rotations. */
    void index_rotations();
    /** Words for an unknown of a rigid part or a hinge; empty for others. */
    std::string describe_condition(int global) const;

    const Lattice                  &lattice;
    const unsigned int              polynomial_order;
    const std::vector<unsigned int> node_components;
    Epetra_MpiComm                  comm;
    const std::vector<bool>         is_of_rigid_part; ///< by joint

    std::vector<MotionNumbers> joint_numbers;
    /** Rotations of the released ends of elastic struts, by strut and end. */
    std::map<std::pair<unsigned int, unsigned int>, MotionNumbers>
      released_end_numbers;
    /** A rigid part's clamped joints and global numbers of its own unknowns. */
    struct RigidPartUnknowns
    {
      std::vector<unsigned int> clamped_joints;
      MotionNumbers             motion;
      std::vector<int>          multipliers;
    };
    std::vector<RigidPartUnknowns> of_rigid_part;
    /** A revolute hinge's joint and global numbers of multipliers. */
    struct HingeUnknowns
    {
      unsigned int       joint;
      std::array<int, 2> multipliers;
    };
    std::vector<HingeUnknowns> of_hinge;
    /** Rigid parts and multipliers kept on this rank. */
    std::vector<unsigned int> kept_rigid_parts;
    std::vector<int>          kept_multipliers;
    /**
     * Global numbers of all elements' unknowns, in the order of active cells;
     * emptied after set-up.
     */
    std::vector<int> cell_numbers;
    /** Global numbers owned by rank r: [first_owned[r], first_owned[r+1]). */
    std::vector<int> first_owned;

    std::unique_ptr<Epetra_Map>    owned;
    std::unique_ptr<Epetra_Map>    local;
    std::unique_ptr<Epetra_Import> import;

    std::vector<Element>     element_list;
    std::vector<int>         element_numbers;
    std::vector<UnknownKind> kinds;
    std::vector<bool>        rotations;

    std::vector<std::array<int, 3>> rotations_in_space;
    /** Index into it by local unknown; empty in the plane. */
    std::vector<int> rotation_of_unknown;
  };
} // namespace auxfem

#endif
