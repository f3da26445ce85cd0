#include <auxfem/mesh/cells/entries.h>
#include <auxfem/mesh/cells/star_shape.h>
#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const Quantity strut_length{"Strut length",
                                "10 mm",
                                "m",
                                Range::positive(),
                                "Length L of all 12 struts of the cell."};

    const Quantity opening_angle{
      "Opening angle",
      "60 deg",
      "deg",
      Range::positive(),
      "Angle theta0 of the upper and lower edges to the horizontal through the "
      "side vertices; more than 45 deg and at most 90 deg."};

    void declare_star(dealii::ParameterHandler &prm)
    {
      declare(prm, strut_length);
      declare(prm, opening_angle);
    }

    [[noreturn]] void refuse(const SceneContext &context,
                             const double        angle,
                             const std::string  &reason)
    {
      std::ostringstream text;
      text << context.path << ": the cell 'star' cannot have an opening angle "
           << "theta0 = " << angle * 180. / dealii::numbers::PI << " deg. "
           << reason
           << " Set 'Opening angle' to more than 45 deg and at most 90 deg.";
      throw InputError(text.str());
    }

    void check_angle(const double        length,
                     const double        angle,
                     const SceneContext &context)
    {
      // Angles come from degrees: equality holds up to round-off only.
      const double round_off = 1e-12;
      const double distance  = length * (std::sin(angle) - std::cos(angle));
      if (angle > dealii::numbers::PI_2 + round_off)
        refuse(context,
               angle,
               "Above 90 deg the vertices between the tips point outwards: "
               "theta0 <= 90 deg fails.");
      if (distance <= round_off * length)
        {
          std::ostringstream reason;
          reason << "Its notches would cross in the centre: b = L (sin(theta0) "
                 << "- cos(theta0)) > 0 fails with b = " << distance
                 << " m for L = " << length << " m.";
          refuse(context,
                 angle,
                 reason.str() +
                   " For flatter edges choose the cell 'general "
                   "star', whose half width must only exceed "
                   "L cos(theta0).");
        }
    }

    std::unique_ptr<Cell> make_star(dealii::ParameterHandler &prm,
                                    const SceneContext       &context)
    {
      const double length = get(prm, strut_length);
      const double angle  = get(prm, opening_angle);
      check_angle(length, angle, context);

      const double tip   = length * std::sin(angle);
      const double depth = length * std::cos(angle);
      return make_star_cell({tip, tip, depth, depth, length, length});
    }
  } // namespace

  RegistryEntry<Cell> star_cell_entry()
  {
    return {"star",
            "Symmetric star of 12 struts of equal length: 8 edges between 4 "
            "tips and 4 re-entrant vertices, 4 stubs to the neighbour cells.",
            &declare_star,
            &make_star};
  }
} // namespace auxfem
