#ifndef auxfem_mesh_cells_star_h
#define auxfem_mesh_cells_star_h

#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/registry.h>

#include <string>

namespace auxfem
{
  /** Opening angle of a symmetric star cell and lengths that follow from it. */
  struct OpeningAngle
  {
    std::string cell;             ///< name of the cell, for messages
    double      value;            ///< theta0 (rad)
    double      strut_length;     ///< L (m)
    double      vertex_distance;  ///< b, centre to re-entrant vertices (m)
    std::string distance_formula; ///< formula of b, for messages
    std::string lower_limit;      ///< theta0 at which b = 0, for messages
    /** Sentence on smaller angles, after a blank; may be empty. */
    std::string advice;
  };

  /**
   * Throws InputError, naming the cell and the violated inequality, unless the
   * re-entrant vertices stay apart (b > 0) and the angle is at most 90 deg.
   */
  void check_opening_angle(const OpeningAngle &angle,
                           const SceneContext &context);

  /**
   * Dimensions (m) of a planar star, symmetric to both axes. Tips lie at
   * (+-half_width, +-half_height), re-entrant vertices at
   * (+-(half_width - side_depth), 0) and (0, +-(half_height - top_depth)).
   * Stubs lead outwards from these along the axes.
   */
  struct StarShape
  {
    double half_width;
    double half_height;
    double side_depth;      ///< of the notches at the left and right side
    double top_depth;       ///< of the notches at top and bottom
    double horizontal_stub; ///< length; 0: no stubs at the sides
    double vertical_stub;   ///< length; 0: no stubs at top and bottom
  };

  /**
   * Builds the cell of @p shape; its notches must not cross.
   *
   * - Joints: 0..3 the tips, counterclockwise from the upper right one; 4..7
   * the re-entrant vertices right, top, left, bottom; then the stub ends in
   * that order. Joint sets `tips`, `notches`.
   * - Struts: 8 `edges` from each tip to the two vertices next to it; `stubs`.
   * - Ports: the stub ends, or the vertices where there are no stubs.
   * - Pairs: `in-cell` (upper to lower vertex), `in-cell x` (left to right
   *   vertex), `rod` (upper vertex to lower port).
   * - Period: the distance of opposite ports; none along a direction in which
   *   the tips would reach past those of the next cell.
   */
  UnitCell build_star(const StarShape &shape);

  /** Makes a Cell of @p shape, which the caller has checked. */
  std::unique_ptr<Cell> make_star_cell(const StarShape &shape);
} // namespace auxfem

#endif
