#ifndef auxfem_scene_modes_definition_h
#define auxfem_scene_modes_definition_h

#include <auxfem/parameters/subsection_schema.h>

#include <optional>

namespace auxfem
{
  /** `Modes`: which natural or buckling modes of a lattice are computed, about
   * what. */
  struct ModesDefinition
  {
    unsigned int number = 10;
    /** About the static equilibrium under the loads of t = 0, else about rest.
     */
    bool about_equilibrium = false;
    /** Whose loads make it buckle (s); none: the end time. */
    std::optional<double> load_time;
    /** Whether it buckles under the opposite loads. */
    bool reversed_loads = false;
    /** Whether natural modes with damping are computed, too. */
    bool damped = false;
    /** How many relaxations are computed. */
    unsigned int relaxations = 0;
    /** Largest displacement in the files for ParaView, over the size of the
     * lattice. */
    double amplitude = 0.05;
    /** Pictures of one period of each mode. */
    unsigned int pictures = 16;
  };

  SubsectionSchema modes_schema();

  ModesDefinition read_modes(const ParameterValues &values);
} // namespace auxfem

#endif
