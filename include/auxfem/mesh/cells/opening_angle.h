#ifndef auxfem_mesh_cells_opening_angle_h
#define auxfem_mesh_cells_opening_angle_h

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
} // namespace auxfem

#endif
