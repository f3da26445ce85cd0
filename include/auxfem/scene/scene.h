#ifndef auxfem_scene_scene_h
#define auxfem_scene_scene_h

#include <auxfem/algebra/solver_parameters.h>
#include <auxfem/connectors/connector_law.h>
#include <auxfem/elements/section.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/cell.h>
#include <auxfem/mesh/motion_components.h>
#include <auxfem/time/schemes.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * `Sets/NAME`: the user's own set of joints or struts, resolved on the
   * lattice.
   */
  struct SetDefinition
  {
    std::string name;
    /**
     * `joints: ...` or `struts: ...` as written; see mesh/sets.h for the
     * grammar.
     */
    std::string selection;
    std::string path; ///< for messages
  };

  /** `Sections/NAME`: cross-section and material of a set of struts. */
  struct SectionDefinition
  {
    std::string name;
    std::string struts; ///< strut set
    Section     section;
    std::string path;
    /** False: left out, which only a scene without inertia and weight may. */
    bool has_density = true;
  };

  /** `Joints/NAME`: joints at which struts are not rigidly connected. */
  struct JointDefinition
  {
    enum class Type
    {
      hinge,    ///< free to turn; in space about any axis
      revolute, ///< in space: free to turn about one axis
      rotational_spring
    };
    std::string name;
    std::string joints; ///< joint set
    std::string struts; ///< strut set whose ends are released there
    Type        type = Type::hinge;
    /** K' (N m/rad) between a released strut and what it turns against. */
    double stiffness = 0;
    /** Unit vector of a revolute hinge's axis at rest. */
    dealii::Tensor<1, 3> axis;
    std::string          path;
  };

  /** `Rigid parts/NAME`: struts or joints that move as rigid bodies. */
  struct RigidPartDefinition
  {
    std::string name;
    /** Strut set; empty if the part is made of joints. */
    std::string struts;
    /** Joint set of one part; empty if parts are made of struts. */
    std::string joints;
    /** True: every strut is a part of its own; false: struts that meet are one.
     */
    bool   single_struts = false;
    double mass          = 0; ///< of each part (kg)
    /**
     * About axes through the centre of mass along x, y, z at rest (kg m2), in
     * the plane the last alone; empty: from the even spread of mass.
     */
    std::optional<dealii::Tensor<1, 3>> rotary_inertia;
    /** Whether elastic struts at its joints are clamped to it, not hinged. */
    bool        clamps_struts = false;
    std::string path;
  };

  /** `Connectors/NAME`: equal connectors between pairs of joints. */
  struct ConnectorDefinition
  {
    enum class Geometry
    {
      line,     ///< along the current line between the two ends
      direction ///< along a direction fixed in space
    };
    std::string                         name;
    std::shared_ptr<const ConnectorLaw> law;
    /**
     * Pair set of the cell (`in-cell`, `rod`), or `3 5; 7 9`, or `ground:
     * SET`.
     */
    std::string          between;
    Geometry             geometry = Geometry::line;
    dealii::Tensor<1, 3> direction; ///< unit vector for Geometry::direction
    /**
     * For `ground: SET`: the ground point is the joint's place at rest plus
     * this (m).
     */
    dealii::Tensor<1, 3> ground_offset;
    std::string          path;
  };

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

  /** `Supports/NAME`: prescribed motion of a set of joints. */
  struct SupportDefinition
  {
    std::string name;
    std::string joints; ///< joint set
    /** Which components are prescribed, and their course (m, rad). */
    std::array<bool, n_motion_components>         fixed = {};
    std::array<TimeFunction, n_motion_components> motion;
    std::string                                   path;
  };

  /** `Masses/NAME`: a point mass on every joint of a set. */
  struct MassDefinition
  {
    std::string name;
    std::string joints;
    double      mass = 0; ///< kg
    /** About axes along x, y, z at rest (kg m2); in the plane the last alone.
     */
    dealii::Tensor<1, 3> rotary_inertia;
    std::string          path;
  };

  /**
   * `Loads/NAME` of type `joint`: a force and moment on every joint of a set.
   */
  struct JointLoadDefinition
  {
    std::string name;
    std::string joints;
    /** N, N m. */
    std::array<TimeFunction, n_motion_components> components;
    /** Whether force and moment turn with the joint; else they are dead. */
    bool        follows_joint = false;
    std::string path;
  };

  /**
   * `Loads/NAME` of type `line`: a dead force per undeformed length on a set
   * of struts.
   */
  struct LineLoadDefinition
  {
    std::string                 name;
    std::string                 struts;
    std::array<TimeFunction, 3> components; ///< q_x, q_y, q_z (N/m)
    std::string                 path;
  };

  /** `Initial velocities/NAME`: velocity of a set of joints at t = 0. */
  struct InitialVelocityDefinition
  {
    std::string name;
    std::string joints;
    /** m/s, rad/s */
    std::array<double, n_motion_components> velocity = {};
    std::string                             path;
  };

  /** On, off, or decided from the scene. */
  enum class Switch
  {
    automatic,
    on,
    off
  };

  /** `Effects`: what is simulated. */
  struct EffectSwitches
  {
    Switch large_rotation      = Switch::automatic;
    Switch shear_flexibility   = Switch::automatic;
    Switch inertia             = Switch::automatic;
    Switch rotary_inertia      = Switch::automatic;
    Switch connector_viscosity = Switch::automatic;
    Switch strut_damping       = Switch::automatic;
    Switch gravity             = Switch::automatic;
    Switch hinges              = Switch::automatic;
  };

  /** `Time`: scheme and steps. */
  struct TimeParameters
  {
    /** Never empty; see implicit_scheme(). */
    std::shared_ptr<const TimeScheme> scheme = default_time_scheme();
    double end_time      = 1;    ///< s (pseudo time for statics)
    double step          = 0.01; ///< s
    double smallest_step = 0;    ///< s; 0: step / 1024
    /** Energy a step may create, of the largest so far. */
    double energy_error = 0.5;
    /** Start from the static equilibrium under the loads of t = 0. */
    bool static_start = false;

    /** Number of steps to the end time; the last may be shorter. */
    unsigned long n_steps() const
    {
      // A last step of a millionth of a step is round-off of the input.
      return static_cast<unsigned long>(std::ceil(end_time / step - 1e-6));
    }

    /**
     * The scheme as one that advances a State: that of every lattice, and of
     * the reduced cell unless it is one of its own. Throws std::bad_cast if it
     * is.
     */
    const ImplicitScheme &implicit_scheme() const
    {
      return dynamic_cast<const ImplicitScheme &>(*scheme);
    }

    /** Time at the end of step @p n, from the count, never accumulated (s). */
    double time_at(const unsigned long n) const
    {
      return n >= n_steps() ? end_time : n * step;
    }
  };

  /** `Newton`: when a step counts as solved. */
  struct NewtonParameters
  {
    /** Relative to the scene's own force and moment scale. */
    double       tolerance          = 1e-8;
    unsigned int maximum_iterations = 30;
    bool         keep_factorization = true; ///< false: full Newton
    /** A kept factorization must reduce the residual so much an iteration. */
    double kept_reduction = 5;
  };

  /** `Discretization`. */
  struct DiscretizationParameters
  {
    unsigned int order = 3; ///< polynomial order 1..6, in space 1..4
    /** Global refinements: 2^n elements a strut. */
    unsigned int refinements = 0;
  };

  /**
   * `Probes/NAME`: a set of joints or rigid parts whose mean motion goes to
   * history.csv.
   */
  struct ProbeDefinition
  {
    std::string name;
    /**
     * Name of a joint set or a joint selection (see mesh/sets.h), or
     * `rigid: STRUTS` or `rigid: STRUTS @ JOINTS` for the rigid parts of
     * struts.
     */
    std::string selection;
    std::string path;
  };

  /** `Output`. */
  struct OutputParameters
  {
    std::string directory = "output";
    double      graphics_interval =
      0; ///< s between .vtu files; 0: start and end only
    bool         graphics         = true;
    unsigned int history_interval = 1; ///< steps between rows of history.csv
    unsigned int segments = 8; ///< straight pieces an element is drawn with
    /** Whether history.csv has the strains between opposite sides. */
    bool effective_strains = false;
    /** Whether results that are not to be used are a failure. */
    bool                         verdict_fails = true;
    std::vector<ProbeDefinition> probes;
  };

  /** Everything the user asked for, checked value by value, SI throughout. */
  struct Scene
  {
    std::string title;
    Model       model = Model::lattice;
    /** Dimension of space: 2 or 3. */
    unsigned int dimension = 2;
    /** With Model::reduced_cell; its connector is the one in `connectors`. */
    std::optional<ReducedCellDefinition> reduced_cell;
    SceneContext context; ///< directory of the file, constants
    std::string  file;
    /** All files it was read from: `file` with those it includes, tables, the
     * mesh file. */
    std::vector<std::string>    input_files;
    std::shared_ptr<const Cell> cell;
    std::array<unsigned int, 3> n_cells = {{1, 1, 1}};
    /** Nothing is wrong with struts that pass through each other. */
    bool                                   struts_may_cross = false;
    std::vector<SetDefinition>             sets;
    std::vector<SectionDefinition>         sections;
    std::vector<JointDefinition>           joints;
    std::vector<RigidPartDefinition>       rigid_parts;
    std::vector<ConnectorDefinition>       connectors;
    std::vector<SupportDefinition>         supports;
    std::vector<MassDefinition>            masses;
    std::vector<JointLoadDefinition>       joint_loads;
    std::vector<LineLoadDefinition>        line_loads;
    std::vector<InitialVelocityDefinition> initial_velocities;
    dealii::Tensor<1, 3>                   gravity; ///< m/s2
    EffectSwitches                         effects;
    DiscretizationParameters               discretization;
    TimeParameters                         time;
    NewtonParameters                       newton;
    SolverParameters                       solver;
    OutputParameters                       output;
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

  /**
   * Every parameter with default, unit, range and sentence, as shown by
   * --print-parameters.
   */
  std::string describe_all_parameters();

  /** The same as the Markdown page doc/parameters.md. */
  std::string describe_all_parameters_markdown();

  /**
   * The same as JSON for other tools: a list of subsections, each with name,
   * form, meaning and parameters, and the variants of its choice with theirs.
   */
  std::string describe_all_parameters_json();
} // namespace auxfem

#endif
