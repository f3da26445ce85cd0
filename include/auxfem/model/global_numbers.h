#ifndef auxfem_model_global_numbers_h
#define auxfem_model_global_numbers_h

#include <auxfem/mesh/motion_components.h>
#include <auxfem/mesh/strut_interval.h>
#include <auxfem/mesh/strut_partition.h>
#include <auxfem/model/ties.h>

#include <map>

namespace auxfem
{
  class UnknownDistribution;

  /**
   * Global numbers of the unknowns of a lattice, the same on every rank; each
   * rank owns a contiguous range. -1: there is no such unknown.
   */
  struct GlobalNumbers
  {
    /** By component of motion. */
    using OfMotion = std::array<int, n_motion_components>;

    struct OfRigidPart
    {
      std::vector<unsigned int> clamped_joints; ///< in the plane
      /** Displacement of its centre of mass and rotation, if they are unknowns
       * of its own. */
      OfMotion         motion;
      std::vector<int> multipliers;
    };

    struct OfHinge
    {
      unsigned int       joint;
      std::array<int, 2> multipliers;
    };

    /** @param components of motion that nodes have */
    GlobalNumbers(const Lattice                   &lattice,
                  const StrutPartition            &partition,
                  const std::vector<unsigned int> &components,
                  const Ties                      &ties,
                  unsigned int                     n_ranks);

    std::vector<OfMotion> joints;
    /** Rotations of the released ends of elastic struts, by strut and end. */
    std::map<std::pair<unsigned int, unsigned int>, OfMotion> released_ends;
    std::vector<OfRigidPart>                                  rigid_parts;
    std::vector<OfHinge>                                      hinges;
    /**
     * Of each strut the first of its nodes, if those of all struts are numbered
     * one after the other, and the end of the last; joints count anew at each
     * strut.
     */
    std::vector<std::size_t> first_nodes;
    /** Of each elastic strut the first number of its inner nodes, element by
     * element, each with all its components. */
    std::vector<int> first_inner;
    /** Numbers owned by rank r: [first_owned[r], first_owned[r + 1]). */
    std::vector<int> first_owned;

    bool owns(const unsigned int rank, const int number) const
    {
      return number >= first_owned[rank] && number < first_owned[rank + 1];
    }

    /** Of the rotation of the end of an elastic strut, released or not, as
     * rotation(). */
    const OfMotion &end_rotation(const Lattice &lattice,
                                 unsigned int   strut,
                                 unsigned int   end) const;

    /**
     * Adds to @p result those of the nodes of an element of @p order, in the
     * order of FE_Q, each with all components that nodes have.
     */
    void add_element(const Lattice       &lattice,
                     const StrutInterval &element,
                     unsigned int         order,
                     std::vector<int>    &result) const;

    /** Of a rotation; components below first_rotation are -1. */
    OfMotion rotation(const RotationOwner &rotation_owner) const;

    /** Of all unknowns that the constraints of a rigid part couple. */
    std::vector<int> of_rigid_part(const Lattice &lattice,
                                   unsigned int   rigid_part) const;

    /** Joint that multiplier @p number of a rigid part holds to the others. */
    unsigned int constrained_joint(const Lattice &lattice,
                                   unsigned int   rigid_part,
                                   unsigned int   number) const;

    /**
     * Of unknowns that act on each other through rotational springs and hinges,
     * each with the multipliers.
     */
    std::vector<std::vector<int>> coupled(const Ties &ties) const;

  private:
    void take(const UnknownDistribution &distribution);

    std::vector<unsigned int> components; ///< of motion that nodes have
  };
} // namespace auxfem

#endif
