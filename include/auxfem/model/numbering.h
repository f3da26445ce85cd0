#ifndef auxfem_model_numbering_h
#define auxfem_model_numbering_h

#include <auxfem/algebra/unknowns.h>
#include <auxfem/model/global_numbers.h>

#include <array>
#include <vector>

namespace auxfem
{
  /**
   * The rotations in space kept on this rank, each with three unknowns: its
   * spins about x, y, z. None in the plane.
   */
  class SpatialRotations
  {
  public:
    explicit SpatialRotations(unsigned int n_local_unknowns);

    /** Adds the rotation with these local unknowns, unless it is there or they
     * are not (-1). */
    void add(const std::array<int, 3> &spins);

    unsigned int size() const
    {
      return rotations.size();
    }

    /** Local numbers of the spins of rotation @p i. */
    const std::array<int, 3> &operator[](const unsigned int i) const
    {
      return rotations[i];
    }

    std::vector<std::array<int, 3>>::const_iterator begin() const
    {
      return rotations.begin();
    }

    std::vector<std::array<int, 3>>::const_iterator end() const
    {
      return rotations.end();
    }

    /** Index of the rotation that a local unknown is a spin of; -1: none. */
    int with(const unsigned int unknown) const
    {
      return rotation_index[unknown];
    }

    /** Axis, 0 to 2, about which a local unknown is the spin. */
    unsigned int axis(unsigned int unknown) const;

  private:
    std::vector<std::array<int, 3>> rotations;
    std::vector<int>                rotation_index;
  };

  /**
   * Numbering of the unknowns of a lattice: at every node u_x, u_y and the
   * rotation in the plane, u_x, u_y, u_z and the spins about x, y, z in space.
   * The ends of all struts at a joint share its displacements, those not
   * released also its rotation, so a joint is one set of unknowns and no
   * constraint equation is needed. Joints at which only rigid struts end have
   * no rotation, in space that of the rigid part. Rigid parts that turn in
   * space have the displacement of their centre of mass and a rotation of their
   * own. The constraints of rigid parts and of revolute hinges add a Lagrange
   * multiplier each.
   *
   * Elements and rigid parts are kept on every rank that owns one of their
   * unknowns, so owned rows of residual and tangent are complete without
   * communication.
   */
  class DofNumbering
  {
  public:
    /** An element kept on this rank. */
    struct Element
    {
      StrutInterval interval;
      unsigned int  order; ///< polynomial
      /** Whether this rank counts its energy and writes it to files. */
      bool is_owned;
    };

    /** Elements of one order, which are kept one after the other: [begin, end).
     */
    struct Group
    {
      unsigned int order;
      unsigned int begin, end;
    };

    /** @param lattice must outlive the object. Collective. */
    DofNumbering(const Lattice        &lattice,
                 const StrutPartition &partition,
                 const Ties           &ties,
                 MPI_Comm              communicator);

    DofNumbering(const DofNumbering &)            = delete;
    DofNumbering &operator=(const DofNumbering &) = delete;

    const Lattice &lattice() const
    {
      return base_lattice;
    }

    /** The elements of the struts, by strut. */
    const std::vector<StrutDivision> &divisions() const
    {
      return strut_divisions;
    }

    /** Unknowns a node: 3 in the plane, 6 in space. */
    unsigned int n_components() const
    {
      return node_components.size();
    }

    /** The components of motion that nodes have: 0, 1, 5 in the plane, else
     * all. */
    const std::vector<unsigned int> &components() const
    {
      return node_components;
    }

    /** How the unknowns, prescribed ones included, are spread over the ranks.
     */
    const UnknownLayout &layout() const
    {
      return unknown_data.layout;
    }

    /** What kinds of unknowns they are. */
    const Unknowns &unknowns() const
    {
      return unknown_data;
    }

    /** Unknowns of rigid parts and hinges. */
    const ConstraintUnknowns &constraints() const
    {
      return constraint_unknowns;
    }

    /** The rotations in space. */
    const SpatialRotations &rotations() const
    {
      return spatial_rotations;
    }

    /** Elements kept on this rank by ascending order, those of a strut one
     * after the other. */
    const std::vector<Element> &elements() const
    {
      return element_list;
    }

    /**
     * The elements by order: a group for every order that an elastic strut of
     * the lattice has, empty if none of them is kept on this rank.
     */
    const std::vector<Group> &groups() const
    {
      return element_groups;
    }

    /**
     * Local numbers of the unknowns of element @p e, n_components() at each of
     * its order + 1 nodes, in the node order of FE_Q (both ends, then the inner
     * nodes).
     */
    const int *element_unknowns(const unsigned int e) const
    {
      return element_numbers.data() + first_number[e];
    }

    /** Number of unknowns of element @p e. */
    unsigned int n_element_unknowns(const unsigned int e) const
    {
      return first_number[e + 1] - first_number[e];
    }

    /**
     * Local number of a joint's unknown, by component of motion; -1 if it does
     * not exist (in the plane, or all struts released) or is not kept on this
     * rank.
     */
    int joint_unknown(const unsigned int joint,
                      const unsigned int component) const
    {
      return layout().local(numbers.joints[joint][component]);
    }

    /** Whether a joint has this unknown at all, known on every rank. */
    bool joint_has(const unsigned int joint, const unsigned int component) const
    {
      return numbers.joints[joint][component] >= 0;
    }

    /**
     * Local number of a component of the rotation of a strut's end, released
     * or not; -1 if not on this rank.
     */
    int end_rotation(unsigned int strut,
                     unsigned int end,
                     unsigned int component = rotation_z) const;

    /** Local number of a component of a rotation; -1: ground, or not on this
     * rank. */
    int rotation_unknown(const RotationOwner &rotation_owner,
                         unsigned int         component) const;

    /** The numbers that are the same on every rank. */
    const GlobalNumbers &global() const
    {
      return numbers;
    }

  private:
    /** Marks in order what each rank keeps of the unknowns of others. */
    struct LocalSubset
    {
      unsigned int     n_owned = 0;
      std::vector<int> ghosts;
      /** Of all elements as they are found, and where those of each begin. */
      std::vector<int>          numbers;
      std::vector<std::size_t>  elements;
      std::vector<unsigned int> rigid_parts;
    };

    LocalSubset find_local_subset(const StrutPartition &partition,
                                  const Ties           &ties,
                                  unsigned int          rank);

    /** Elastic struts that may have an unknown of this rank. */
    std::vector<unsigned int> find_struts(const StrutPartition &partition,
                                          unsigned int          rank) const;

    void sort_elements(LocalSubset &subset);
    void localize_elements();
    void mark_unknowns();
    void mark(int unknown, unsigned int node, unsigned int component);
    void mark_constraints();
    void mark_prescribed(const std::vector<JointMotion> &motions);
    void find_rotations();

    const Lattice                   &base_lattice;
    const std::vector<StrutDivision> strut_divisions;
    const std::vector<unsigned int>  node_components;
    GlobalNumbers                    numbers;
    std::vector<Element>             element_list;
    std::vector<Group>               element_groups;
    LocalSubset                      local_subset; ///< emptied after set-up
    std::vector<int>                 element_numbers;
    /** Of each element, and the end of the last. */
    std::vector<std::size_t> first_number;
    Unknowns                 unknown_data;
    ConstraintUnknowns       constraint_unknowns;
    SpatialRotations         spatial_rotations;
  };

  /**
   * A number for each of DofNumbering::spatial_rotations() that names the same
   * rotation on any number of ranks: that of the rigid part that has it, else
   * of the joint, else of the end or the node inside a strut. None in the
   * plane.
   */
  std::vector<unsigned int> rotation_numbers(const Lattice      &lattice,
                                             const DofNumbering &numbering);
} // namespace auxfem

#endif
