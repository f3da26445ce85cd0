#ifndef auxfem_equations_step_travel_h
#define auxfem_equations_step_travel_h

#include <auxfem/elements/cayley_rotation.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/model/numbering.h>

namespace auxfem
{
  /**
   * How far unknowns move in a step between two states, as forces and moments
   * in the residual see it: large rotations in the plane by Cayley's measure.
   */
  class StepTravel
  {
  public:
    /** The arguments must outlive the object. */
    StepTravel(const Evaluation &step, const DofNumbering &numbering)
      : u0(step.from.displacement.data())
      , u1(step.to.displacement.data())
      , has_plane_rotations(!step.to.plane_rotations->empty())
      , numbering(numbering)
    {}

    /** What a force or moment on @p unknown does work on (m, rad). */
    double of(const int unknown) const
    {
      const double moved = u1[unknown] - u0[unknown];
      return is_plane_rotation(unknown) ? cayley_rotation(moved) : moved;
    }

    /** Increment of @p unknown over what of() says. */
    double increment_per_travel(const int unknown) const
    {
      return is_plane_rotation(unknown)
        ? angle_per_cayley_rotation(u1[unknown] - u0[unknown])
        : 1.;
    }

  private:
    bool is_plane_rotation(const int unknown) const
    {
      return has_plane_rotations && numbering.unknowns().is_rotation[unknown];
    }

    const double       *u0, *u1;
    const bool          has_plane_rotations;
    const DofNumbering &numbering;
  };
} // namespace auxfem

#endif
