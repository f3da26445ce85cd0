#ifndef auxfem_mesh_lattice_h
#define auxfem_mesh_lattice_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Many lists of indices, stored one behind the other (compressed rows). */
  class IndexLists
  {
  public:
    IndexLists() = default;

    /**
     * @param n_lists number of lists
     * @param for_each_entry takes a function and calls it with a list number
     * and an index for each entry, in the same order each time
     */
    template <class ForEachEntry>
    IndexLists(const std::size_t n_lists, const ForEachEntry &for_each_entry)
      : first(n_lists + 2, 0)
    {
      // Counts are shifted by one list: filling then moves each start to its
      // final position.
      for_each_entry(
        [this](const std::size_t list, unsigned int) { ++first[list + 2]; });
      std::partial_sum(first.begin(), first.end(), first.begin());
      entries.resize(first.back());
      for_each_entry([this](const std::size_t list, const unsigned int index) {
        entries[first[list + 1]++] = index;
      });
    }

    /** The list number @p list, in the order of its entries. */
    dealii::ArrayView<const unsigned int>
    operator[](const std::size_t list) const
    {
      return {entries.data() + first[list], first[list + 1] - first[list]};
    }

  private:
    std::vector<unsigned int> first, entries;
  };

  /** Joint or strut number written in @p text: digits, maybe with blanks around
   * them. Nothing for any other text or a number too large for an index. */
  std::optional<unsigned int> read_index(const std::string &text);

  /**
   * Number of components of motion and load at a joint: displacements or forces
   * along x, y, z, then rotations or moments about them. Planar scenes use 0, 1
   * and 5 only.
   */
  constexpr unsigned int n_motion_components = 6;

  /** The only component of rotation and moment in the plane. */
  constexpr unsigned int rotation_z = 5;

  /** The first component of rotation and moment. */
  constexpr unsigned int first_rotation = 3;

  /** Whether planar scenes have the component @p c of motion and load. */
  constexpr bool is_in_plane(const unsigned int c)
  {
    return c < 2 || c == rotation_z;
  }

  /** Marks "no joint", "no strut": an index that no list has. */
  constexpr unsigned int invalid_index =
    std::numeric_limits<unsigned int>::max();

  /**
   * A strut: a beam between two joints, straight or (sagitta != 0) a circular
   * arc.
   */
  struct Strut
  {
    /** Indices of the two end joints into Lattice::joints. */
    std::array<unsigned int, 2> joints;

    /**
     * Rise of the arc's middle over the chord (m), positive to the left of the
     * direction joints[0] -> joints[1] seen against `normal`, that is along
     * normal x chord; 0 for a straight strut.
     */
    double sagitta = 0;

    /**
     * Unit normal of an arc's plane. It must not be parallel to the chord, but
     * need not be perpendicular to it: the arc rises along normal x chord.
     * Unused by straight struts.
     */
    dealii::Tensor<1, 3> normal = dealii::Point<3>(0, 0, 1);

    /** Number of the unit cell (i + nx * (j + ny * k)) the strut belongs to. */
    unsigned int cell = 0;

    /**
     * Index into the scene's sections, filled from the strut sets. A rigid
     * strut takes its thickness from the section and may have none
     * (invalid_index).
     */
    unsigned int section = 0;

    /** Index into Lattice::rigid_parts; invalid_index for an elastic strut. */
    unsigned int rigid_part = invalid_index;

    /** Whether the strut belongs to a rigid part and has no finite elements. */
    bool is_rigid() const
    {
      return rigid_part != invalid_index;
    }
  };

  /** Joints that move as one rigid body, and its rigid struts, if any. */
  struct RigidPart
  {
    /**
     * At least two joints. The first two, chosen far apart, are the base that
     * the positions of all others are relative to.
     */
    std::vector<unsigned int> joints;

    /** Rigid struts of the part. */
    std::vector<unsigned int> struts;

    /** Whether elastic struts are clamped to the part, not hinged. */
    bool clamps_struts = false;

    double mass = 0; ///< kg

    /** Position at rest (m). */
    dealii::Point<3> centre_of_mass;

    /** Inertia tensor about the centre of mass (kg m2), in the global frame at
     * rest. Planar scenes use its last entry only. */
    dealii::Tensor<2, 3> rotary_inertia;

    /** In space: whether the part has a rotation of its own. A part without one
     * is a bar: all of it lies on one line. */
    bool has_rotation = false;

    /** Index into the scene's rigid part definitions. */
    unsigned int definition = 0;

    /** Number of the unit cell of its first strut, for output. */
    unsigned int cell = 0;
  };

  /** Two joints a connector may link; the second may be the ground. */
  struct JointPair
  {
    unsigned int first;
    unsigned int second; ///< invalid_index: the ground
    /** Number of the unit cell the pair belongs to, for output. */
    unsigned int cell = 0;
  };

  struct Periodicity;

  /**
   * The structure as a graph in space: joints, struts, joint pairs for
   * connectors, and named sets of all three. Plain data without finite
   * elements, made by make_array().
   */
  struct Lattice
  {
    /** Dimension of space: 2, with z = 0 everywhere, or 3. */
    unsigned int dimension = 2;

    /** Positions at rest (m). */
    std::vector<dealii::Point<3>> joints;

    /** Number of rigid plates. The last joints are their reference points: they
     * belong to no other set and do not count for the lattice's size. */
    unsigned int n_plates = 0;

    /** Period of an infinite lattice; nullptr: the lattice ends at its joints.
     */
    std::shared_ptr<const Periodicity> periodicity;

    /** @name In an infinite lattice */
    ///@{
    /** Number of joints that are images of others, behind these. */
    unsigned int n_images = 0;
    /** Number of joints that stand for the axes of the mean deformation. They
     * come behind all others. The displacement of that of axis d is the
     * derivative of the mean displacement along d times
     * Periodicity::length(). */
    unsigned int n_axes = 0;
    ///@}

    std::vector<Strut> struts;

    /** Filled from the scene's rigid part definitions. */
    std::vector<RigidPart> rigid_parts;

    /** Sorted joint indices by set name; `all`, `bottom`, `top`, ... */
    std::map<std::string, std::vector<unsigned int>> joint_sets;

    /** Sorted strut indices by set name; `all`, `edges`, `stubs`, ... */
    std::map<std::string, std::vector<unsigned int>> strut_sets;

    /** Joint pairs for connectors by set name, e.g. `in-cell`, `rod`. A set of
     * pairs across neighbouring cells may be empty. */
    std::map<std::string, std::vector<JointPair>> pair_sets;

    /** Number of unit cells. */
    unsigned int n_cells = 1;

    /** Sentences that tell the user how the cell was made. */
    std::vector<std::string> notes;

    /** The lattice before imperfections, for selections by position; nullptr
     * without imperfections. */
    std::shared_ptr<const Lattice> as_designed;

    /** Number of joints other than those of plates and axes. */
    unsigned int n_structural_joints() const
    {
      return joints.size() - n_plates - n_axes;
    }

    /** Whether a joint is an image of another one. */
    bool is_image(const unsigned int joint) const
    {
      return joint < n_structural_joints() &&
        joint >= n_structural_joints() - n_images;
    }

    /** The joint of the axis @p d of the mean deformation. */
    unsigned int joint_of_axis(const unsigned int d) const
    {
      return n_structural_joints() + n_plates + d;
    }

    /** Reference joint of plate number @p plate, in the order of the scene. */
    unsigned int joint_of_plate(const unsigned int plate) const
    {
      return n_structural_joints() + plate;
    }

    /** Number of struts that belong to no rigid part. */
    unsigned int n_elastic_struts() const;

    /** Length of a strut along its axis (m), the arc length for an arc. */
    double length(const Strut &strut) const;

    /** Quadrature points on the undeformed axis of @p strut (m) with weights of
     * sum 1, for quantities spread evenly along it. */
    std::vector<std::pair<dealii::Point<3>, double>>
    uniform_points(const Strut &strut) const;

    /** Centroid of the undeformed axis of @p strut (m). */
    dealii::Point<3> centroid(const Strut &strut) const;

    /**
     * Position (m) and unit tangent of the undeformed axis of @p strut at
     * @p s in [0,1], a fraction of its length.
     */
    void axis(const Strut          &strut,
              double                s,
              dealii::Point<3>     &position,
              dealii::Tensor<1, 3> &tangent) const;
  };
} // namespace auxfem

#endif
