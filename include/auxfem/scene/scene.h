#ifndef auxfem_scene_scene_h
#define auxfem_scene_scene_h

#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/connectors/connector_definition.h>
#include <auxfem/contact/plate_definition.h>
#include <auxfem/joints/joint_definition.h>
#include <auxfem/loads/load_definitions.h>
#include <auxfem/mesh/imperfection.h>
#include <auxfem/mesh/lattice_definition.h>
#include <auxfem/rigid/rigid_part.h>
#include <auxfem/scene/analysis_definitions.h>
#include <auxfem/scene/general_parameters.h>
#include <auxfem/scene/study_definition.h>
#include <auxfem/struts/discretization_parameters.h>
#include <auxfem/struts/section.h>
#include <auxfem/time/schemes/time_parameters.h>

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

  /** A subsection of the parameter file and the place of its values. */
  struct SceneSubsection
  {
    SubsectionSchema schema;

    /**
     * Puts the values of one such subsection into the scene. Throws InputError
     * if they contradict each other.
     */
    void (*read)(ParameterValues &values, Scene &scene);
  };

  /** All subsections, in the order in which they are read and described. */
  const std::vector<SceneSubsection> &scene_subsections();

  /** Their schemas, for the reference. */
  std::vector<SubsectionSchema> scene_schemas();

  /**
   * Adds the subsections of the file that no schema allows, and those that
   * serve other models than @p model, to @p mistakes.
   */
  void check_subsection_names(const ParameterSubsection &root,
                              Model                      model,
                              Mistakes                  &mistakes);

  /** Adds contradictions between subsections of @p scene to @p mistakes. */
  void check_consistency(const Scene &scene, Mistakes &mistakes);
} // namespace auxfem

#endif
