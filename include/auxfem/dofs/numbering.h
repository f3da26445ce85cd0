#ifndef auxfem_dofs_numbering_h
#define auxfem_dofs_numbering_h

#include <auxfem/mesh/motion_components.h>
#include <auxfem/mesh/strut_mesh.h>

#include <Epetra_Import.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <array>
#include <memory>

namespace auxfem
{
  /** Words for a component of motion, e.g. `vertical displacement` or `rotation
   * about x`. */
  const char *motion_in_words(unsigned int component, unsigned int dimension);

  /** What is released and tied beyond the rigid joints. */
  struct Ties
  {
    /**
     * For every strut: whether the rotation of its first, second end is free
     * of the joint.
     */
    std::vector<std::array<bool, 2>> released;

    /** Pairs of joints whose motions act on each other through a connector. */
    std::vector<JointPair> connected;

    /** Joints where springs couple the rotations of released strut ends. */
    std::vector<unsigned int> sprung_joints;
  };

  /** Kinds of unknowns, measured apart in convergence tests. */
  enum class UnknownKind : unsigned char
  {
    translation,
    rotation,
    prescribed,
    multiplier
  };

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
   * no rotation. The conditions of rigid parts add a Lagrange multiplier
   * each.
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

    /**
     * Local number of a multiplier of a rigid part: 0 for the distance of the
     * base joints; 2 k - 3 and 2 k - 2 for joint k = 2, 3, ... of the part;
     * then one for each of its clamped joints. -1 if not on this rank.
     */
    int multiplier(unsigned int rigid_part, unsigned int number) const;

    /** Number of multipliers of a rigid part; the same on every rank. */
    unsigned int n_multipliers(unsigned int rigid_part) const;

    /** Joints whose rotation is tied to that of a rigid part. */
    const std::vector<unsigned int> &
    clamped_joints(unsigned int rigid_part) const;

    /** Rigid parts kept on this rank, with all their unknowns. */
    const std::vector<unsigned int> &rigid_parts() const;

    /** Local numbers of the multipliers kept on this rank. */
    const std::vector<int> &multipliers() const;

    /** Number of multipliers of all rigid parts. */
    unsigned int n_multipliers() const;

    /** Kind of a local unknown; prescribed once prescribe() was called for it.
     */
    UnknownKind kind(unsigned int local) const;

    /** Marks a local unknown as prescribed. */
    void prescribe(unsigned int local);

    /** The owned rows by kind; to be asked for once all unknowns are
     * prescribed. */
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
    void number_unknowns(const StrutMesh &mesh, const Ties &ties);
    void collect_local(const StrutMesh &mesh, const Ties &ties);
    /** Global numbers of all unknowns of a rigid part, its multipliers too. */
    std::vector<int> rigid_part_numbers(unsigned int rigid_part) const;
    void             index_rigid_parts();
    /** Groups the local spins into rotations. */
    void index_rotations(const std::vector<std::vector<int>> &coupled);
    /** Global numbers of all rotations at each of the sprung joints. */
    std::vector<std::vector<int>> coupled_rotations(const Ties &ties) const;

    /** Global numbers by component of motion; -1: does not exist. */
    using MotionNumbers = std::array<int, n_motion_components>;

    const Lattice                  &lattice;
    const unsigned int              polynomial_order;
    const std::vector<unsigned int> node_components;
    Epetra_MpiComm                  comm;

    std::vector<MotionNumbers> joint_numbers;
    /** Rotations at both ends of each strut; displacements are left out. */
    std::vector<std::array<MotionNumbers, 2>> end_rotation_numbers;
    /** A rigid part's clamped joints and global numbers of multipliers. */
    struct RigidPartUnknowns
    {
      std::vector<unsigned int> clamped_joints;
      std::vector<int>          multipliers;
    };
    std::vector<RigidPartUnknowns> of_rigid_part;
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
