#include <auxfem/mesh/cells/opening_angle.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    [[noreturn]] void refuse(const OpeningAngle &angle,
                             const SceneContext &context,
                             const std::string  &reason)
    {
      std::ostringstream text;
      text << context.path << ": the cell '" << angle.cell
           << "' cannot have an opening angle "
           << "theta0 = " << angle.value * 180. / dealii::numbers::PI
           << " deg. " << reason << " Set 'Opening angle' to more than "
           << angle.lower_limit << " and at most 90 deg.";
      throw InputError(text.str());
    }
  } // namespace

  void check_opening_angle(const OpeningAngle &angle,
                           const SceneContext &context)
  {
    // Angles come from degrees: equality holds up to round-off only.
    if (angle.value > dealii::numbers::PI_2 + round_off)
      refuse(angle,
             context,
             "Above 90 deg the vertices between the tips point outwards: "
             "theta0 <= 90 deg fails.");
    if (angle.vertex_distance <= round_off * angle.strut_length)
      {
        std::ostringstream reason;
        reason << "Its notches would cross in the centre: b = "
               << angle.distance_formula
               << " > 0 fails with b = " << angle.vertex_distance
               << " m for L = " << angle.strut_length << " m." << angle.advice;
        refuse(angle, context, reason.str());
      }
  }
} // namespace auxfem
