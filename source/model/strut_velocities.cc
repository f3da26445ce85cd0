#include <auxfem/model/strut_velocities.h>

namespace auxfem
{
  namespace
  {
    SpaceVector part(const JointVelocity &velocity, const unsigned int first)
    {
      return SpaceVector(
        {velocity[first], velocity[first + 1], velocity[first + 2]});
    }

    /** Share of the spin about @p axis, a unit vector. */
    SpaceVector along(const SpaceVector &axis, const SpaceVector &spin)
    {
      return (axis * spin) * axis;
    }
  } // namespace

  StrutVelocities::StrutVelocities(const std::array<MovingEnd, 2> &ends)
    : begin(ends[0].position)
    , chord(ends[1].position - ends[0].position)
    , velocity(part(ends[0].velocity, 0))
  {
    const double      length = chord.norm();
    const SpaceVector axis   = chord / length,
                      apart  = part(ends[1].velocity, 0) - velocity;
    const std::array<SpaceVector, 2> spins = {
      {part(ends[0].velocity, first_rotation),
       part(ends[1].velocity, first_rotation)}};
    // Where one end is free to twist, all of the strut follows the other.
    const SpaceVector about_axis = ends[0].is_released == ends[1].is_released
      ? (spins[0] + spins[1]) / 2.
      : spins[ends[0].is_released ? 1 : 0];
    angular_velocity =
      dealii::cross_product_3d(axis, apart) / length + along(axis, about_axis);
    lengthening = along(axis, apart);
    for (unsigned int i = 0; i < 2; ++i)
      if (!ends[i].is_released)
        {
          const SpaceVector against = spins[i] - angular_velocity;
          twist[i]                  = along(axis, against);
          bending[i]                = against - twist[i];
        }
    // No moment at an end that is free: the slope of a propped beam.
    for (unsigned int i = 0; i < 2; ++i)
      if (ends[i].is_released)
        {
          bending[i] =
            ends[1 - i].is_released ? SpaceVector() : -0.5 * bending[1 - i];
          twist[i] = twist[1 - i];
        }
  }

  JointVelocity StrutVelocities::at(const double            fraction,
                                    const dealii::Point<3> &position) const
  {
    const double      s = fraction, rest = 1 - fraction;
    const SpaceVector deflection = s * rest * rest * bending[0] -
      s * s * rest * bending[1],
                      slope = rest * (1 - 3 * s) * bending[0] +
      s * (3 * s - 2) * bending[1] + rest * twist[0] + s * twist[1];
    const SpaceVector from_begin = position - begin;
    const SpaceVector moving     = velocity +
      dealii::cross_product_3d(angular_velocity, from_begin) + s * lengthening +
      dealii::cross_product_3d(deflection, chord) +
      dealii::cross_product_3d(slope, from_begin - s * chord);
    const SpaceVector spin = angular_velocity + slope;
    JointVelocity     result;
    for (unsigned int c = 0; c < 3; ++c)
      {
        result[c]                  = moving[c];
        result[first_rotation + c] = spin[c];
      }
    return result;
  }
} // namespace auxfem
