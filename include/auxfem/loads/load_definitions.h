#ifndef auxfem_loads_load_definitions_h
#define auxfem_loads_load_definitions_h

#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/motion_components.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <variant>

namespace auxfem
{
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
