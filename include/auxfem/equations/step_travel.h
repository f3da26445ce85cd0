#ifndef auxfem_equations_step_travel_h
#define auxfem_equations_step_travel_h

#include <auxfem/elements/cayley_rotation.h>
#include <auxfem/equations/node_rotations.h>

namespace auxfem
{
  /**
   * How far unknowns move in a step between two states, as forces and moments
   * in the residual see it: large rotations by Cayley's measure.
   */
  class StepTravel
  {
  public:
    /** The arguments must outlive the object. */
    StepTravel(const Evaluation &step, const DofNumbering &numbering)
      : step(step)
      , u0(step.from.displacement.data())
      , u1(step.to.displacement.data())
      , has_plane_rotations(!step.to.plane_rotations->empty())
      , numbering(numbering)
      , rotations(numbering)
    {}

    /** What a force or moment on @p unknown does work on (m, rad). */
    double of(const int unknown) const
    {
      if (const int i = space_rotation(unknown); i >= 0)
        return rotations.spatial_increment(
                 step,
                 i)[numbering.rotations().axis(unknown)] /
          angle_per_cayley_rotation(turn_of(i));
      const double moved = u1[unknown] - u0[unknown];
      return is_plane_rotation(unknown) ? cayley_rotation(moved) : moved;
    }

    /** Increment of @p unknown over what of() says. */
    double increment_per_travel(const int unknown) const
    {
      if (const int i = space_rotation(unknown); i >= 0)
        return angle_per_cayley_rotation(turn_of(i));
      return is_plane_rotation(unknown)
        ? angle_per_cayley_rotation(u1[unknown] - u0[unknown])
        : 1.;
    }

  private:
    bool is_plane_rotation(const int unknown) const
    {
      return has_plane_rotations && numbering.unknowns().is_rotation[unknown];
    }

    /** The large rotation in space of which @p unknown is part, or -1. */
    int space_rotation(const int unknown) const
    {
      return step.to.rotations.empty() ? -1
                                       : numbering.rotations().with(unknown);
    }

    /** Angle of rotation @p i in the step (rad). */
    double turn_of(const unsigned int i) const
    {
      return rotations.material_increment(step, i).norm();
    }

    const Evaluation   &step;
    const double       *u0, *u1;
    const bool          has_plane_rotations;
    const DofNumbering &numbering;
    const NodeRotations rotations;
  };
} // namespace auxfem

#endif
