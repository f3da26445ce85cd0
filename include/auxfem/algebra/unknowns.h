#ifndef auxfem_algebra_unknowns_h
#define auxfem_algebra_unknowns_h

#include <auxfem/algebra/unknown_layout.h>

#include <deal.II/base/point.h>

#include <memory>
#include <optional>

namespace auxfem
{
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
   * What linear algebra knows of the unknowns of a structure beside how they
   * act on each other: which are prescribed, which lie inside a strut and can
   * be condensed there, which belong to one joint. All ghosts included.
   */
  struct Unknowns
  {
    explicit Unknowns(const UnknownLayout &layout);

    UnknownLayout layout;
    /** By local unknown. */
    std::vector<UnknownKind> kinds;
    /** Whether a local unknown is a rotation, prescribed or not. */
    std::vector<bool> is_rotation;
    /** Strut that a local unknown lies inside of; none at joints. */
    std::vector<std::optional<unsigned int>> strut;
    /**
     * Of local unknowns not inside struts: the joint they belong to, of
     * multipliers one that they constrain. The numbers are the same on all
     * ranks.
     */
    std::vector<unsigned int> joint;
    /**
     * Component of motion, 0 to 5, of local unknowns not inside struts;
     * meaningless for multipliers.
     */
    std::vector<unsigned char> component;
    /** Positions of joints, then of other things that `joint` names (m). */
    std::shared_ptr<const std::vector<dealii::Point<3>>> positions;
    /** Components of motion that nodes have: 0, 1, 5 in the plane, else all. */
    std::vector<unsigned int> components;
    /** Ties moments to forces (m). */
    double length = 1;

    /**
     * Keeps copies of further unknowns of other ranks. Returns whether any rank
     * has gained one. Collective.
     */
    bool add_ghosts(const std::vector<int> &globals);

    /**
     * What the local unknown @p i is divided by to be compared with others:
     * 1/length for rotations, measured in length times radian, else 1.
     */
    double unit(const unsigned int i) const
    {
      return is_rotation[i] ? 1 / length : 1.;
    }

    OwnedRows owned_rows() const;

    /**
     * Number of displacements and rotations that are not prescribed, over all
     * ranks. Collective.
     */
    unsigned int n_free() const;

    /** Number of unknowns of a kind, over all ranks. Collective. */
    unsigned long n_of(UnknownKind kind) const;
  };
} // namespace auxfem

#endif
