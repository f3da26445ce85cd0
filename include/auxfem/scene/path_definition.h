#ifndef auxfem_scene_path_definition_h
#define auxfem_scene_path_definition_h

#include <auxfem/parameters/subsection_schema.h>

#include <optional>

namespace auxfem
{
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
} // namespace auxfem

#endif
