#ifndef auxfem_loads_load_definitions_h
#define auxfem_loads_load_definitions_h

#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/parameters/parameter_values.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>

/**
 * @file
 * Supports, masses, loads, gravity and initial velocities of the parameter
 * file.
 */
namespace auxfem
{
  /** The @p parameter of component @p c: appends the axis to its name, the
   * direction to its sentence, which has no full stop. */
  template <class Typed>
  Typed for_component(Typed parameter, const unsigned int c)
  {
    const std::string axis(1, "xyz"[c % 3]);
    parameter.name += " " + axis;
    parameter.sentence += (c < 3 ? " along " : " about ") + axis;
    if (c == rotation_z)
      parameter.sentence += ", counterclockwise seen from its positive side";
    parameter.sentence += is_in_plane(c) ? "." : "; with Dimension = 3 only.";
    return parameter;
  }

  /** The @p parameter for the axes x, y, z; see for_component(). */
  template <class Typed>
  std::array<Typed, 3> for_axes(const Typed &parameter)
  {
    return {{for_component(parameter, 0),
             for_component(parameter, 1),
             for_component(parameter, 2)}};
  }

  /** Parameters for @p translation along x, y, z and @p rotation about them; see
   * for_component(). */
  template <class Typed>
  std::array<Typed, n_motion_components>
  for_components(const Typed &translation, const Typed &rotation)
  {
    return {{for_component(translation, 0),
             for_component(translation, 1),
             for_component(translation, 2),
             for_component(rotation, 3),
             for_component(rotation, 4),
             for_component(rotation, 5)}};
  }

  /** Reads the function of time in @p parameter. Makes the file name of a table
   * absolute in @p values. */
  TimeFunction read_time_function(ParameterValues      &values,
                                  const TimeExpression &parameter);

  /** `Supports/NAME`: prescribed motion of a set of joints. */
  struct SupportDefinition
  {
    std::string name;
    std::string joints; ///< joint set
    /** Prescribed components, and their time histories (m, rad). */
    std::array<bool, n_motion_components>         fixed = {};
    std::array<TimeFunction, n_motion_components> motion;
    /** Point about which its moment is recorded (m); empty: not recorded. */
    std::optional<dealii::Point<3>> moment_point;
    std::string                     path; ///< for messages
  };

  /** Schema of `Supports`. */
  SubsectionSchema supports_schema();

  /** Reads `Supports/NAME`. Throws InputError if values contradict each other.
   */
  SupportDefinition read_support(ParameterValues &values);

  /** `Masses/NAME`: a point mass on every joint of a set. */
  struct MassDefinition
  {
    std::string name;
    std::string joints;
    double      mass = 0; ///< kg
    /** Moments of inertia about x, y, z at rest (kg m2); planar scenes use the
     * last only. */
    dealii::Tensor<1, 3> rotary_inertia;
    std::string          path; ///< for messages
  };

  /** Schema of `Masses`. */
  SubsectionSchema masses_schema();

  /** Reads `Masses/NAME`. Throws InputError if values contradict each other. */
  MassDefinition read_mass(ParameterValues &values);

  /**
   * `Loads/NAME` of type `joint`: a force and moment on every joint of a set.
   */
  struct JointLoadDefinition
  {
    std::string                                   name;
    std::string                                   joints;
    std::array<TimeFunction, n_motion_components> components; ///< N, N m
    std::string distribution = "1"; ///< factor, see load_distribution()
    /** Whether force and moment turn with the joint (follower loads). */
    bool        follows_joint = false;
    std::string path; ///< for messages

    bool is_zero() const
    {
      return std::all_of(components.begin(),
                         components.end(),
                         [](const TimeFunction &component) {
                           return component.is_zero();
                         });
    }
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
    std::string distribution = "1";         ///< factor, see load_distribution()
    std::string path;                       ///< for messages
  };

  /** `Loads/NAME` of type `pressure`, in the plane: a force per current length
   * normal to a set of struts. */
  struct PressureDefinition
  {
    std::string  name;
    std::string  struts;
    TimeFunction pressure;           ///< to the left (N/m)
    std::string  distribution = "1"; ///< factor, see load_distribution()
    std::string  path;               ///< for messages
  };

  /**
   * `Loads/NAME` of type `temperature` or `pretension`: strains that the struts
   * of a set would take on if they were free.
   */
  struct InitialStrainDefinition
  {
    /** A load causes strain in one of these ways. */
    enum class Cause
    {
      temperature, ///< change since rest (K)
      gradient_2,  ///< of the temperature along axis 2 (K/m)
      gradient_3,  ///< along axis 3 (K/m)
      pretension   ///< axial force of struts held at both ends (N)
    };
    std::string  name;
    std::string  struts;
    Cause        cause = Cause::temperature;
    TimeFunction history;            ///< K, K/m or N
    std::string  distribution = "1"; ///< factor, see load_distribution()
    std::string  path;               ///< for messages
  };

  /** The factor by position (m) that @p definition of `Loads/NAME` gives. Throws
   * InputError if it is not an expression of x, y, z. */
  template <class Definition>
  PositionFunction load_distribution(const Definition   &definition,
                                     const Lattice      &lattice,
                                     const SceneContext &context)
  {
    return {definition.distribution,
            "factor",
            "For instance Distribution = x / xmax.",
            lattice,
            context,
            definition.path + "/Distribution"};
  }

  /** Schema of `Loads`. */
  SubsectionSchema loads_schema();

  /** Reads `Loads/NAME`. Throws InputError if values contradict each other. */
  std::variant<JointLoadDefinition,
               LineLoadDefinition,
               PressureDefinition,
               std::vector<InitialStrainDefinition>>
  read_load(ParameterValues &values);

  /** Acceleration that loads all masses: `Gravity`, that of free fall, or `Base
   * motion`, that of the frame in which supports are given. */
  struct AccelerationDefinition
  {
    std::array<TimeFunction, 3> acceleration; ///< along x, y, z (m/s2)

    /** Whether the acceleration is zero at all times. */
    bool is_zero() const;

    /** Components that change in time. */
    std::vector<TimeFunction> varying_components() const;
  };

  /** Schema of `Gravity`. */
  SubsectionSchema gravity_schema();

  /** Reads `Gravity`. */
  AccelerationDefinition read_gravity(ParameterValues &values);

  /** Schema of `Base motion`. */
  SubsectionSchema base_motion_schema();

  /** Reads `Base motion`. */
  AccelerationDefinition read_base_motion(ParameterValues &values);

  /** `Initial velocities/NAME`: velocity of a set of joints at t = 0. */
  struct InitialVelocityDefinition
  {
    std::string                             name;
    std::string                             joints;
    std::array<double, n_motion_components> velocity = {}; ///< m/s, rad/s
    std::string                             path;          ///< for messages
  };

  /** Schema of `Initial velocities`. */
  SubsectionSchema initial_velocities_schema();

  /** Reads `Initial velocities/NAME`. Throws InputError if values contradict
   * each other. */
  InitialVelocityDefinition read_initial_velocity(ParameterValues &values);
} // namespace auxfem

#endif
