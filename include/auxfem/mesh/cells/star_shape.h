#ifndef auxfem_mesh_cells_star_shape_h
#define auxfem_mesh_cells_star_shape_h

#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/registry.h>

#include <string>

namespace auxfem
{
  /** The opening angle of a symmetric star cell and what follows from it. */
  struct OpeningAngle
  {
    std::string cell;             ///< name of the cell, for messages
    double      value;            ///< theta0 (rad)
    double      strut_length;     ///< L (m)
    double      vertex_distance;  ///< b, centre to re-entrant vertices (m)
    std::string distance_formula; ///< b in formula signs
    std::string lower_limit;      ///< of theta0, where b = 0, in words
    /** Advice for smaller angles, a sentence after a blank; may be empty. */
    std::string advice;
  };

  /**
   * Throws InputError naming the cell and the inequality that fails unless the
   * re-entrant vertices of a star stay apart (b > 0) and the angle is at most
   * 90 deg.
   */
  void check_opening_angle(const OpeningAngle &angle,
                           const SceneContext &context);

  /**
   * Measures (m) of a planar star about its centre, symmetric to both axes:
   * tips at (+-half_width, +-half_height), re-entrant vertices at
   * (+-(half_width - side_depth), 0) and (0, +-(half_height - top_depth)),
   * stubs from these outwards along the axes.
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
   * Builds the cell of @p shape, which must have notches that do not cross.
   *
   * Joints: 0..3 the tips, counterclockwise from the upper right one; 4..7 the
   * re-entrant vertices right, top, left, bottom; then, in that order, the stub
   * ends. Struts: 8 `edges`, each tip to the two vertices next to it; the
   * `stubs`. Joint sets `tips`, `notches`. The ports are the stub ends, or the
   * vertices where there are no stubs.
   *
   * Pairs: `in-cell` (upper to lower vertex), `in-cell x` (left to right
   * vertex), `rod` (upper vertex to the lower port, which is the upper stub end
   * of the cell below or stands on the foundation).
   *
   * The period is the distance between opposite ports. There is none along a
   * direction in which the tips would reach past those of the next cell.
   */
  UnitCell build_star(const StarShape &shape);

  /** A star as a cell. @p shape has been checked by the caller. */
  std::unique_ptr<Cell> make_star_cell(const StarShape &shape);
} // namespace auxfem

#endif
