#ifndef auxfem_equations_step_travel_h
#define auxfem_equations_step_travel_h

#include <auxfem/elements/cayley_turn.h>
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
      , turns(!step.to.plane_rotations->empty())
      , numbering(numbering)
    {}

    /** What a force or moment on @p unknown does work on (m, rad). */
    double of(const int unknown) const
    {
      const double moved = u1[unknown] - u0[unknown];
      return is_turn(unknown) ? cayley_turn(moved) : moved;
    }

    /** Increment of @p unknown over what of() says. */
    double increment_per_travel(const int unknown) const
    {
      return is_turn(unknown) ? angle_per_cayley_turn(u1[unknown] - u0[unknown])
                              : 1.;
    }

  private:
    bool is_turn(const int unknown) const
    {
      return turns && numbering.unknowns().is_rotation[unknown];
    }

    const double       *u0, *u1;
    const bool          turns;
    const DofNumbering &numbering;
  };
} // namespace auxfem

#endif
