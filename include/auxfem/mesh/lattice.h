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
  /** Many lists of indices, one behind the other in memory. */
  class IndexLists
  {
  public:
    IndexLists() = default;

    /**
     * @param n_lists number of lists
     * @param for_each_entry calls what it is given with the number of a list
     * and an index for it, for each entry; the same each time
     */
    template <class ForEachEntry>
    IndexLists(const std::size_t n_lists, const ForEachEntry &for_each_entry)
      : first(n_lists + 2, 0)
    {
      // Counted one place ahead, so that places are the first ones when all
      // are filled.
      for_each_entry(
        [this](const std::size_t list, unsigned int) { ++first[list + 2]; });
      std::partial_sum(first.begin(), first.end(), first.begin());
      entries.resize(first.back());
      for_each_entry([this](const std::size_t list, const unsigned int index) {
        entries[first[list + 1]++] = index;
      });
    }

    /** A list, in the order in which it was given. */
    dealii::ArrayView<const unsigned int>
    operator[](const std::size_t list) const
    {
      return {entries.data() + first[list], first[list + 1] - first[list]};
    }

  private:
    std::vector<unsigned int> first, entries;
  };

  /**
   * The joint or strut number @p text stands for: digits only, blanks around
   * them allowed; nothing for any other text and for numbers too large to be
   * an index.
   */
  std::optional<unsigned int> read_index(const std::string &text);

  /**
   * Number of components of motion and load at a joint: three displacements or
   * forces along x, y, z, three rotations or moments about them. In the plane
   * only 0, 1 and 5 are used.
   */
  constexpr unsigned int n_motion_components = 6;

  /** The component of rotation and moment that there is in the plane. */
  constexpr unsigned int rotation_z = 5;

  /** The first component of rotation and moment. */
  constexpr unsigned int first_rotation = 3;

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
     * Unit normal of the plane an arc lies in. Not parallel to the chord, but
     * need not be perpendicular to it: the arc rises along normal x chord
     * whatever the angle between them. Without meaning for a straight strut.
     */
    dealii::Tensor<1, 3> normal = dealii::Point<3>(0, 0, 1);

    /** Number of the unit cell (i + nx * (j + ny * k)) the strut belongs to. */
    unsigned int cell = 0;

    /**
     * Index into the scene's sections; filled from the strut sets. A rigid
     * strut may have none (invalid_index); it has the thickness of its section.
     */
    unsigned int section = 0;

    /** Index into Lattice::rigid_parts; invalid_index for an elastic strut. */
    unsigned int rigid_part = invalid_index;

    /** Whether the strut belongs to a rigid part, so is no finite element. */
    bool is_rigid() const
    {
      return rigid_part != invalid_index;
    }
  };

  /**
   * Joints that move as one rigid body, and the rigid struts it is made of, if
   * any.
   */
  struct RigidPart
  {
    /**
     * At least two. The first two are the base, chosen far apart; the positions
     * of all others are given relative to them.
     */
    std::vector<unsigned int> joints;

    /** Rigid struts of the part. */
    std::vector<unsigned int> struts;

    /** Whether elastic struts at its joints are clamped to it, not hinged. */
    bool clamps_struts = false;

    double mass = 0; ///< kg

    /** At rest (m). */
    dealii::Point<3> centre_of_mass;

    /**
     * Tensor of inertia about the centre of mass (kg m2), in the global frame
     * at rest. The plane needs its last entry alone.
     */
    dealii::Tensor<2, 3> rotary_inertia;

    /**
     * In space: whether the part has a rotation of its own. Else it is a bar:
     * all of it lies on one line, about which it has no rotation.
     */
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
    /** invalid_index: the ground. */
    unsigned int second;
    /** Number of the unit cell the pair belongs to, for output. */
    unsigned int cell = 0;
  };

  /**
   * The structure as a graph in space: joints, struts between them, pairs of
   * joints meant for connectors, and named sets of all three. Plain data, made
   * by a cell generator; knows nothing of finite elements.
   */
  struct Lattice
  {
    /** Dimension of space: 2, with z = 0 everywhere, or 3. */
    unsigned int dimension = 2;

    /** Positions at rest (m). */
    std::vector<dealii::Point<3>> joints;

    /** The last joints are points of reference of rigid plates: they belong to
     * no set but their own, and have no part in the size of the lattice. */
    unsigned int n_plates = 0;

    std::vector<Strut> struts;

    /** Filled from the scene's rigid part definitions. */
    std::vector<RigidPart> rigid_parts;

    /** Sorted joint indices by set name; `all`, `bottom`, `top`, ... */
    std::map<std::string, std::vector<unsigned int>> joint_sets;

    /** Sorted strut indices by set name; `all`, `edges`, `stubs`, ... */
    std::map<std::string, std::vector<unsigned int>> strut_sets;

    /**
     * Pairs offered by the cell for connectors, e.g. `in-cell`, `rod`. A set of
     * pairs across neighbouring cells is empty where there are none.
     */
    std::map<std::string, std::vector<JointPair>> pair_sets;

    /** Number of unit cells. */
    unsigned int n_cells = 1;

    /** Sentences for the user on how the cell was made. */
    std::vector<std::string> notes;

    /** The same without its imperfections, for whoever selects by position;
     * nullptr: there are none. */
    std::shared_ptr<const Lattice> as_designed;

    /** Number of joints without those of plates. */
    unsigned int n_structural_joints() const
    {
      return joints.size() - n_plates;
    }

    /** Joint of a plate, in the order of the scene. */
    unsigned int joint_of_plate(const unsigned int plate) const
    {
      return n_structural_joints() + plate;
    }

    /** Number of struts that are no part of a rigid body. */
    unsigned int n_elastic_struts() const;

    /** Length of a strut along its axis (m), the arc length for an arc. */
    double length(const Strut &strut) const;

    /**
     * Points on the undeformed axis of @p strut (m) with weights of sum 1 that
     * stand for something spread evenly along it, up to its second moments.
     */
    std::vector<std::pair<dealii::Point<3>, double>>
    even_points(const Strut &strut) const;

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
