#ifndef auxfem_scene_analysis_definitions_h
#define auxfem_scene_analysis_definitions_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** `Frequency response`: frequencies and amplitudes of harmonic loads. */
  struct FrequencyResponseDefinition
  {
    double       lowest = 1, highest = 1000; ///< Hz
    unsigned int number         = 200;
    bool         is_logarithmic = true;
    /** Time (s) whose loads are the amplitudes; none: the end time. */
    std::optional<double> load_time;
    /** Whether the lattice vibrates about the static equilibrium under the
     * loads of t = 0, not about rest. */
    bool about_equilibrium = false;

    /** All frequencies in ascending order (Hz). */
    std::vector<double> frequencies() const;
  };

  /** Schema of `Frequency response`. */
  SubsectionSchema frequency_response_schema();

  /** Reads `Frequency response`. Throws InputError for a band without width. */
  FrequencyResponseDefinition
  read_frequency_response(const ParameterValues &values);

  /** `Modes`: natural or buckling modes to be computed. */
  struct ModesDefinition
  {
    unsigned int number = 10;
    /** Whether modes are those about the static equilibrium under the loads of
     * t = 0, not about rest. */
    bool about_equilibrium = false;
    /** Time (s) of the buckling loads; none: the end time. */
    std::optional<double> load_time;
    /** Whether the buckling loads are reversed. */
    bool reversed_loads = false;
    /** Whether damped natural modes are computed, too. */
    bool damped = false;
    /** Number of relaxations (decay without oscillation) to be computed. */
    unsigned int relaxations = 0;
    /** Largest displacement in .vtu files, over the size of the lattice. */
    double amplitude = 0.05;
    /** Number of .vtu files for one period of each mode. */
    unsigned int pictures = 16;
  };

  /** Schema of `Modes`. */
  SubsectionSchema modes_schema();

  /** Reads `Modes`. */
  ModesDefinition read_modes(const ParameterValues &values);

  /** `Path`: step control and end of a path of equilibria. */
  struct PathDefinition
  {
    /** Time (s) of the loads at load factor 1; none: the end time. */
    std::optional<double> load_time;
    /** Whether the path begins with negative load factors. */
    bool reversed_loads = false;
    /** Load factor of the first predictor. */
    double first_increment = 0.01;
    /** Largest distance of a point from the predictor, relative to the
     * displacements and to the largest load factor so far. */
    double resolution = 0.02;
    /** @name Where the path ends */
    ///@{
    double                largest_load_factor = 1;
    std::optional<double> largest_displacement; ///< m
    unsigned int          max_points = 1000;
    ///@}

    /** Bifurcations at which the path changes to the other branch. */
    enum class Branch
    {
      primary,  ///< at none
      stable,   ///< wherever a direction becomes unstable
      numbered, ///< at bifurcation number `branch_number`, counted from 1
    };
    Branch       branch        = Branch::primary;
    unsigned int branch_number = 0;
    /** Whether the new branch is followed against the sense of the mode. */
    bool reverse_branch = false;
    /** Number of points from one .vtu file to the next. */
    unsigned int graphics_interval = 1;
  };

  /** Schema of `Path`. */
  SubsectionSchema path_schema();

  /** Reads `Path`. */
  PathDefinition read_path(const ParameterValues &values);

  /**
   * `Reduced cell`: the star cell of rigid parts and hinges in which a
   * connector carries the load on the upper part to the foundation (Shokri Rad
   * et al., Figs. 2 and 4); see reduced_cell/cell_equations.h.
   */
  struct ReducedCellDefinition
  {
    double       bar_length = 0.5; ///< L1 (m)
    double       angle      = 0;   ///< theta0, at rest (rad)
    double       bar_mass   = 0;   ///< m1 of each of the four bars (kg)
    double       part_mass  = 0;   ///< m2 of upper and lower part each (kg)
    TimeFunction load;             ///< f1 on the upper part, downwards (N)
    std::string  path;             ///< for messages
  };

  /** Schema of `Reduced cell`. */
  SubsectionSchema reduced_cell_schema();

  /** Reads `Reduced cell`. Throws InputError if values contradict each other.
   */
  ReducedCellDefinition read_reduced_cell(ParameterValues &values);
} // namespace auxfem

#endif
