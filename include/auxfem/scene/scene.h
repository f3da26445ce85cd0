#ifndef auxfem_scene_scene_h
#define auxfem_scene_scene_h

#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/connectors/connector_definition.h>
#include <auxfem/contact/plate_definition.h>
#include <auxfem/figures/figures_definition.h>
#include <auxfem/joints/constraint_definition.h>
#include <auxfem/joints/joint_definition.h>
#include <auxfem/loads/load_definitions.h>
#include <auxfem/mesh/imperfection.h>
#include <auxfem/mesh/lattice_definition.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/rigid/rigid_part.h>
#include <auxfem/scene/analysis_definitions.h>
#include <auxfem/scene/dispersion_definition.h>
#include <auxfem/scene/general_parameters.h>
#include <auxfem/scene/mean_deformation.h>
#include <auxfem/scene/optimization_definition.h>
#include <auxfem/scene/study_definition.h>
#include <auxfem/scene/sweep_definition.h>
#include <auxfem/struts/discretization_parameters.h>
#include <auxfem/struts/section.h>
#include <auxfem/time/schemes/time_parameters.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Contents of a parameter file, checked, in SI units. */
  struct Scene
  {
    std::string title;
    Analysis    analysis = Analysis::simulation;
    /** Cell of Model::reduced_cell; `connectors` has its connector. */
    std::optional<ReducedCellDefinition> reduced_cell;
    /** Model, dimension of space, directory of the file, constants. */
    SceneContext context;
    std::string  file;
    /** All files read: `file` with its includes, tables, the mesh file. */
    std::vector<std::string>               input_files;
    LatticeDefinition                      lattice;
    std::vector<SetDefinition>             sets;
    std::vector<ImperfectionDefinition>    imperfections;
    std::vector<MaterialDefinition>        materials;
    std::vector<SectionDefinition>         sections;
    std::vector<JointDefinition>           joints;
    std::vector<RigidPartDefinition>       rigid_parts;
    std::vector<ConnectorDefinition>       connectors;
    std::vector<ConstraintDefinition>      constraints;
    std::vector<SupportDefinition>         supports;
    std::vector<MassDefinition>            masses;
    std::vector<JointLoadDefinition>       joint_loads;
    std::vector<LineLoadDefinition>        line_loads;
    std::vector<PressureDefinition>        pressures;
    std::vector<InitialStrainDefinition>   initial_strains;
    std::vector<InitialVelocityDefinition> initial_velocities;
    AccelerationDefinition                 gravity;
    AccelerationDefinition                 base_motion;
    /** Plates; their supports, masses and initial velocities are also among
     * those of the scene. */
    std::vector<PlateDefinition> plates;
    ContactParameters            contact;
    EffectSwitches               effects;
    DiscretizationParameters     discretization;
    TimeParameters               time;
    NewtonParameters             newton;
    SolverParameters             solver;
    OutputParameters             output;
    FiguresDefinition            figures;
    ModesDefinition              modes;
    PathDefinition               path;
    FrequencyResponseDefinition  frequency_response;
    MeanDeformation              mean_deformation;
    DispersionDefinition         dispersion;
    StudyDefinition              study;
    SweepDefinition              sweep;
    OptimizationDefinition       optimization;
    /** The parameters as given, before sections inherit: cases with other
     * values are scenes of these. */
    std::shared_ptr<const ParameterSubsection> given_parameters;
    /** Contents of parameters.prm: all parameters with the values used. */
    std::string all_parameters;
    /** Those of all_parameters that are not at their defaults, as a parameter
     * file. */
    std::string changed_parameters;
  };

  /**
   * Reads @p file, applies @p overrides (`Subsection/Parameter=value`) and
   * checks the scene. One InputError reports all mistakes, each with its place,
   * the value, the allowed values and advice.
   */
  Scene read_scene(const std::string              &file,
                   const std::vector<std::string> &overrides = {});

  /** As read_scene(), from @p text; messages call the file @p name. */
  Scene read_scene_from_text(const std::string              &text,
                             const std::string              &name,
                             const std::vector<std::string> &overrides = {});

  /** A case of the sweep or optimization of @p scene: its analysis with @p
   * overrides. Throws InputError as read_scene(). */
  Scene scene_of_case(const Scene                    &scene,
                      const std::vector<std::string> &overrides);

  /** A subsection of the parameter file and the function that reads it. */
  struct SceneSubsection
  {
    SubsectionSchema schema;

    /** Puts the values of one such subsection into the scene. Throws InputError
     * if they contradict each other. */
    void (*read)(ParameterValues &values, Scene &scene);
  };

  /** All subsections, in the order in which they are read and described. */
  const std::vector<SceneSubsection> &scene_subsections();

  /** Schemas of scene_subsections(). */
  std::vector<SubsectionSchema> scene_schemas();

  /** Adds unknown subsections of the file, and those that @p model does not
   * use, to @p mistakes. */
  void check_subsection_names(const ParameterSubsection &root,
                              Model                      model,
                              Mistakes                  &mistakes);

  /** Whether inertia plays no part; paths and buckling are static with any
   * scheme. */
  bool is_static(const Scene &scene);

  /** Adds what the materials of @p scene cannot do there to @p mistakes. */
  void check_materials(const Scene &scene, Mistakes &mistakes);

  /** Adds what the connectors of @p scene cannot do there to @p mistakes. */
  void check_connectors(const Scene &scene, Mistakes &mistakes);

  /** Adds what Design variables and Optimization of @p scene lack to @p
   * mistakes. */
  void check_optimization(const Scene &scene, Mistakes &mistakes);

  /** Adds contradictions between subsections of @p scene to @p mistakes. */
  void check_consistency(const Scene &scene, Mistakes &mistakes);
} // namespace auxfem

#endif
