#ifndef auxfem_scene_scene_h
#define auxfem_scene_scene_h

#include <auxfem/algebra/solver_parameters.h>
#include <auxfem/connectors/connector_definition.h>
#include <auxfem/contact/contact_parameters.h>
#include <auxfem/contact/plate_definition.h>
#include <auxfem/elements/discretization_parameters.h>
#include <auxfem/elements/section_definition.h>
#include <auxfem/loads/load_definitions.h>
#include <auxfem/loads/support_definition.h>
#include <auxfem/mesh/imperfection_definition.h>
#include <auxfem/mesh/joint_definition.h>
#include <auxfem/mesh/lattice_definition.h>
#include <auxfem/mesh/rigid_part_definition.h>
#include <auxfem/mesh/set_definition.h>
#include <auxfem/scene/effect_switches.h>
#include <auxfem/scene/frequency_response_definition.h>
#include <auxfem/scene/general_parameters.h>
#include <auxfem/scene/modes_definition.h>
#include <auxfem/scene/output_parameters.h>
#include <auxfem/scene/path_definition.h>
#include <auxfem/scene/reduced_cell_definition.h>
#include <auxfem/scene/study_definition.h>
#include <auxfem/time/time_parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Everything the user asked for, checked value by value, SI throughout. */
  struct Scene
  {
    std::string title;
    Analysis    analysis = Analysis::simulation;
    /** With Model::reduced_cell; its connector is the one in `connectors`. */
    std::optional<ReducedCellDefinition> reduced_cell;
    /** Model, dimension of space, directory of the file, constants. */
    SceneContext context;
    std::string  file;
    /** All files it was read from: `file` with those it includes, tables, the
     * mesh file. */
    std::vector<std::string>               input_files;
    LatticeDefinition                      lattice;
    std::vector<SetDefinition>             sets;
    std::vector<ImperfectionDefinition>    imperfections;
    std::vector<SectionDefinition>         sections;
    std::vector<JointDefinition>           joints;
    std::vector<RigidPartDefinition>       rigid_parts;
    std::vector<ConnectorDefinition>       connectors;
    std::vector<SupportDefinition>         supports;
    std::vector<MassDefinition>            masses;
    std::vector<JointLoadDefinition>       joint_loads;
    std::vector<LineLoadDefinition>        line_loads;
    std::vector<InitialVelocityDefinition> initial_velocities;
    GravityDefinition                      gravity;
    /** What holds, moves and loads their joints is among `supports`, `masses`
     * and `initial_velocities`. */
    std::vector<PlateDefinition> plates;
    ContactParameters            contact;
    EffectSwitches               effects;
    DiscretizationParameters     discretization;
    TimeParameters               time;
    NewtonParameters             newton;
    SolverParameters             solver;
    OutputParameters             output;
    ModesDefinition              modes;
    PathDefinition               path;
    FrequencyResponseDefinition  frequency_response;
    StudyDefinition              study;
    /** All parameters with the values used, in .prm syntax, for parameters.prm.
     */
    std::string all_parameters;
  };

  /**
   * Reads @p file, applies @p overrides (`Subsection/Parameter=value`), and
   * checks it. All mistakes found are reported in one InputError, each with
   * file, line or parameter path, the value found, what is allowed and what to
   * do.
   */
  Scene read_scene(const std::string              &file,
                   const std::vector<std::string> &overrides = {});

  /** As read_scene(), from text already in memory; @p name stands for the file in messages. */
  Scene read_scene_from_text(const std::string              &text,
                             const std::string              &name,
                             const std::vector<std::string> &overrides = {});
} // namespace auxfem

#endif
