#ifndef auxfem_scene_reduced_cell_definition_h
#define auxfem_scene_reduced_cell_definition_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/subsection_schema.h>

#include <string>

namespace auxfem
{
  /**
   * `Reduced cell`: the star cell of rigid parts and hinges in which a
   * connector carries the load on the upper part to the foundation (Shokri Rad
   * et al., Figs. 2 and 4). See reduced_cell/cell_equations.h.
   */
  struct ReducedCellDefinition
  {
    double       bar_length = 0.5; ///< L1 (m)
    double       angle      = 0;   ///< theta0, at rest (rad)
    double       bar_mass   = 0;   ///< m1, of each of the four bars (kg)
    double       part_mass  = 0;   ///< m2, of upper and lower part each (kg)
    TimeFunction load;             ///< f1, pushes the upper part down (N)
    std::string  path;
  };

  /** `Reduced cell`. */
  SubsectionSchema reduced_cell_schema();

  /** The values of that subsection. Throws InputError if they contradict each
   * other. */
  ReducedCellDefinition read_reduced_cell(ParameterValues &values);
} // namespace auxfem

#endif
