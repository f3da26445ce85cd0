#ifndef auxfem_loads_motion_parameters_h
#define auxfem_loads_motion_parameters_h

#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/motion_components.h>
#include <auxfem/parameters/parameter_values.h>

#include <array>
#include <string>

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
} // namespace auxfem

#endif
