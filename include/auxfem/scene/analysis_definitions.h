#ifndef auxfem_scene_analysis_definitions_h
#define auxfem_scene_analysis_definitions_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** `Frequency response`: at which frequencies harmonic loads are answered. */
  struct FrequencyResponseDefinition
  {
    double       lowest = 1, highest = 1000; ///< Hz
    unsigned int number         = 200;
    bool         is_logarithmic = true;
    /** Amplitudes are the loads of this time (s); none: the end time. */
    std::optional<double> load_time;
    /** About the static equilibrium under the loads of t = 0, else about rest.
     */
    bool about_equilibrium = false;

    /** All of them, rising (Hz). */
    std::vector<double> frequencies() const;
  };

  SubsectionSchema frequency_response_schema();

  /** Throws InputError for a band without width. */
  FrequencyResponseDefinition
  read_frequency_response(const ParameterValues &values);

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

  /** `Path`: how a path of equilibria is followed, and where it ends. */
  struct PathDefinition
  {
    /** The load factor 1 stands for the loads of this time (s); none: the end
     * time. */
    std::optional<double> load_time;
    /** Whether it begins with negative load factors. */
    bool reversed_loads = false;
    /** Load factor that the tangent at the start takes to the first point. */
    double first_increment = 0.01;
    /** How far a point may lie off the tangent at the point before, as a part
     * of the way and of the largest load factor so far. */
    double resolution = 0.02;
    /** @name Where the path ends. */
    ///@{
    double                largest_load_factor = 1;
    std::optional<double> largest_displacement; ///< m
    unsigned int          most_points = 1000;
    ///@}

    /** At which bifurcations the path leaves the branch it came on. */
    enum class Branch
    {
      primary,  ///< at none
      stable,   ///< wherever a direction becomes unstable
      numbered, ///< at bifurcation number `branch_number`, counted from 1
    };
    Branch       branch        = Branch::primary;
    unsigned int branch_number = 0;
    /** Whether it leaves against the sense of the mode. */
    bool opposite_side = false;
    /** Points from one picture for ParaView to the next. */
    unsigned int graphics_interval = 1;
  };

  SubsectionSchema path_schema();

  PathDefinition read_path(const ParameterValues &values);

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
