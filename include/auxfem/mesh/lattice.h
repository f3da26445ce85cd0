#ifndef auxfem_mesh_lattice_h
#define auxfem_mesh_lattice_h

#include <deal.II/base/point.h>

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace auxfem
{
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
     * direction joints[0] -> joints[1] in the x-y plane; 0 for a straight
     * strut.
     */
    double sagitta = 0;

    /** Number of the unit cell (i + nx * (j + ny * k)) the strut belongs to. */
    unsigned int cell = 0;

    /** Index into the scene's sections; filled from the strut sets. */
    unsigned int section = 0;
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
   * by a cell generator; knows nothing of finite elements. Planar scenes have z
   * = 0.
   */
  struct Lattice
  {
    /** Positions at rest (m). */
    std::vector<dealii::Point<3>> joints;

    std::vector<Strut> struts;

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

    /** Length of a strut along its axis (m), the arc length for an arc. */
    double length(const Strut &strut) const;

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
