#ifndef auxfem_model_numbering_h
#define auxfem_model_numbering_h

#include <auxfem/algebra/unknowns.h>
#include <auxfem/model/global_numbers.h>

#include <array>
#include <vector>

namespace auxfem
{
  /**
   * Spatial rotations on this rank, each with three unknowns: spins about x, y,
   * z. Empty in the plane.
   */
  class SpatialRotations
  {
  public:
    explicit SpatialRotations(unsigned int n_local_unknowns);

    /** Adds the rotation with these local unknowns unless it is already present
     * or absent from this rank (-1). */
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

    /** Index of the rotation that contains a local unknown; -1 if none. */
    int with(const unsigned int unknown) const
    {
      return rotation_index[unknown];
    }

    /** Axis (0 to 2) of the spin at a local unknown. */
    unsigned int axis(unsigned int unknown) const;

  private:
    std::vector<std::array<int, 3>> rotations;
    std::vector<int>                rotation_index;
  };

  /**
   * Numbering of the unknowns of a lattice: displacements and rotations (spins
   * in space) at every node. Strut ends at a joint share its displacements, and
   * its rotation unless released. Joints of rigid struts alone have no
   * rotation; in space they use that of the rigid part. Rotating rigid parts
   * own their motion, and each constraint adds a Lagrange multiplier.
   *
   * Every rank that owns an unknown of an element or rigid part stores it, so
   * owned rows are complete without communication.
   */
  class DofNumbering
  {
  public:
    /** An element stored on this rank. */
    struct Element
    {
      StrutInterval interval;
      unsigned int  order; ///< polynomial
      /** Whether this rank accounts for its energy and writes it to files. */
      bool is_owned;
    };

    /** Consecutive elements [begin, end) of one order and one section law. */
    struct Group
    {
      unsigned int order;
      unsigned int begin, end;
      unsigned int law = 0; ///< LatticeModel::laws
    };

    /**
     * @param lattice must outlive the object
     * @param laws number of the law by section; without it all have the first
     *
     * Collective.
     */
    DofNumbering(const Lattice                   &lattice,
                 const StrutPartition            &partition,
                 const Ties                      &ties,
                 MPI_Comm                         communicator,
                 const std::vector<unsigned int> &laws = {});

    DofNumbering(const DofNumbering &)            = delete;
    DofNumbering &operator=(const DofNumbering &) = delete;

    const Lattice &lattice() const
    {
      return base_lattice;
    }

    /** Division into elements, by strut. */
    const std::vector<StrutDivision> &divisions() const
    {
      return strut_divisions;
    }

    /** Unknowns per node: 3 in the plane, 6 in space. */
    unsigned int n_components() const
    {
      return node_components.size();
    }

    /** Motion components of nodes: 0, 1, 5 in the plane, all in space. */
    const std::vector<unsigned int> &components() const
    {
      return node_components;
    }

    /** Distribution of all unknowns, including prescribed ones, over the
     * ranks. */
    const UnknownLayout &layout() const
    {
      return unknown_data.layout;
    }

    /** Kinds of the unknowns. */
    const Unknowns &unknowns() const
    {
      return unknown_data;
    }

    /** Unknowns of rigid parts and hinges. */
    const ConstraintUnknowns &constraints() const
    {
      return constraint_unknowns;
    }

    /** Spatial rotations. */
    const SpatialRotations &rotations() const
    {
      return spatial_rotations;
    }

    /** Elements on this rank by ascending order and law; those of a strut are
     * consecutive. */
    const std::vector<Element> &elements() const
    {
      return element_list;
    }

    /** Element groups, one per order and law used in the lattice; empty groups
     * have no elements on this rank. */
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

    /** Number of element @p e in the lattice, independent of the ranks. */
    unsigned int number_in_lattice(const unsigned int e) const
    {
      const StrutInterval &interval = element_list[e].interval;
      return first_element_of_strut[interval.strut] + interval.number();
    }

    /** Number of unknowns of element @p e. */
    unsigned int n_element_unknowns(const unsigned int e) const
    {
      return first_number[e + 1] - first_number[e];
    }

    /** Local number of a joint unknown; -1 if it does not exist or is not on
     * this rank. */
    int joint_unknown(const unsigned int joint,
                      const unsigned int component) const
    {
      return layout().local(numbers.joints[joint][component]);
    }

    /** Whether a joint has this unknown; equal on all ranks. */
    bool joint_has(const unsigned int joint, const unsigned int component) const
    {
      return numbers.joints[joint][component] >= 0;
    }

    /** Local number of a rotation component at a strut end; -1 if not on this
     * rank. */
    int end_rotation(unsigned int strut,
                     unsigned int end,
                     unsigned int component = rotation_z) const;

    /** Local number of a rotation component; -1 for the ground or if not on
     * this rank. */
    int rotation_unknown(const RotationOwner &rotation_owner,
                         unsigned int         component) const;

    /** Global numbers, equal on all ranks. */
    const GlobalNumbers &global() const
    {
      return numbers;
    }

  private:
    /** Ghosts, elements and rigid parts of a rank, in the order found. */
    struct LocalSubset
    {
      unsigned int     n_owned = 0;
      std::vector<int> ghosts;
      /** Global numbers of all elements, and the offset of each element. */
      std::vector<int>          numbers;
      std::vector<std::size_t>  elements;
      std::vector<unsigned int> rigid_parts;
    };

    LocalSubset find_local_subset(const StrutPartition            &partition,
                                  const Ties                      &ties,
                                  unsigned int                     rank,
                                  const std::vector<unsigned int> &laws);

    /** Elastic struts that may have an unknown owned by this rank. */
    std::vector<unsigned int> find_struts(const StrutPartition &partition,
                                          unsigned int          rank) const;

    void sort_elements(LocalSubset                     &subset,
                       const std::vector<unsigned int> &laws);
    void localize_elements();
    void mark_unknowns();
    void mark(int unknown, unsigned int node, unsigned int component);
    void mark_constraints();
    void mark_prescribed(const std::vector<JointMotion> &motions);
    void find_rotations();

    const Lattice                   &base_lattice;
    const std::vector<StrutDivision> strut_divisions;
    /** Number in the lattice, by strut. */
    const std::vector<unsigned int> first_element_of_strut;
    const std::vector<unsigned int> node_components;
    GlobalNumbers                   numbers;
    std::vector<Element>            element_list;
    std::vector<Group>              element_groups;
    LocalSubset                     local_subset; ///< emptied after set-up
    std::vector<int>                element_numbers;
    /** Offset of each element and the end of the list. */
    std::vector<std::size_t> first_number;
    Unknowns                 unknown_data;
    ConstraintUnknowns       constraint_unknowns;
    SpatialRotations         spatial_rotations;
  };

  /**
   * Partition-independent number of each of DofNumbering::rotations(): by rigid
   * part, else joint, else strut end or inner node. Empty in the plane.
   */
  std::vector<unsigned int> rotation_numbers(const Lattice      &lattice,
                                             const DofNumbering &numbering);
} // namespace auxfem

#endif
