#ifndef auxfem_loads_load_definitions_h
#define auxfem_loads_load_definitions_h

#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/parameter_values.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <variant>

/**
 * @file
 * Parameters that come once for each axis or component of motion and load, and
 * functions of time.
 */
namespace auxfem
{
  /** Whether component @p c of motion and load is there in the plane. */
  constexpr bool is_in_plane(const unsigned int c)
  {
    return c < 2 || c == rotation_z;
  }

  /**
   * @p parameter for component @p c: its name followed by the axis, its sentence
   * (without full stop) by the direction and, where it is so, that it needs
   * space.
   */
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

  /** @p parameter for the axes x, y, z; see for_component(). */
  template <class Typed>
  std::array<Typed, 3> for_axes(const Typed &parameter)
  {
    return {{for_component(parameter, 0),
             for_component(parameter, 1),
             for_component(parameter, 2)}};
  }

  /**
   * @p translation along x, y, z and @p rotation about them; see
   * for_component().
   */
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

  /**
   * The function of time in @p parameter. The file name of a table becomes an
   * absolute one in @p values.
   */
  TimeFunction read_time_function(ParameterValues      &values,
                                  const TimeExpression &parameter);

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

  /** `Supports`. */
  SubsectionSchema supports_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  SupportDefinition read_support(ParameterValues &values);

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

  /** `Masses`. */
  SubsectionSchema masses_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  MassDefinition read_mass(ParameterValues &values);

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

  /** `Loads`. */
  SubsectionSchema loads_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  std::variant<JointLoadDefinition, LineLoadDefinition>
  read_load(ParameterValues &values);

  /** `Gravity`: the acceleration of free fall. */
  struct GravityDefinition
  {
    std::array<TimeFunction, 3> acceleration; ///< along x, y, z (m/s2)

    /** Whether there is none at any time. */
    bool is_zero() const;

    /** Those components that change in time. */
    std::vector<TimeFunction> courses() const;
  };

  /** `Gravity`. */
  SubsectionSchema gravity_schema();

  /** Its values. */
  GravityDefinition read_gravity(ParameterValues &values);

  /** `Initial velocities/NAME`: velocity of a set of joints at t = 0. */
  struct InitialVelocityDefinition
  {
    std::string name;
    std::string joints;
    /** m/s, rad/s */
    std::array<double, n_motion_components> velocity = {};
    std::string                             path;
  };

  /** `Initial velocities`. */
  SubsectionSchema initial_velocities_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  InitialVelocityDefinition read_initial_velocity(ParameterValues &values);
} // namespace auxfem

#endif
