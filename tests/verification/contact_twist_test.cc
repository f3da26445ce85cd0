#include <auxfem/contact/effects/contact.h>
#include <auxfem/struts/effects/struts.h>

#include <verification/result_table.h>
#include <verification/space_run.h>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Two rods side by side that are twisted about their common axis into a double
// helix, pulled: in the middle a uniform one by Kirchhoff's rods.

namespace
{
  /** A rod of a uniform helix: its section force and moment are constant but
   * for turning with it. */
  struct HelixOfRod
  {
    double bending, torsion; ///< EI, and the moment along the axis of the rod
    double radius;           ///< of its axis (m)
    double inclination;      ///< of the tangent against the axis of the helix
    double pull;             ///< force along that axis (N)

    double curvature() const
    {
      return std::pow(std::sin(inclination), 2) / radius;
    }

    /** Section force around the axis (N): so that the moment, which turns with
     * the binormal and the tangent, is in equilibrium. */
    double force_around() const
    {
      const double geometric_torsion =
        std::sin(inclination) * std::cos(inclination) / radius;
      return (std::sin(inclination) * pull -
              curvature() * (torsion - bending * geometric_torsion)) /
        std::cos(inclination);
    }

    /** Force of the other rod on this one, per length (N/m). It turns the
     * section force around the axis. */
    double contact_force() const
    {
      return force_around() * std::sin(inclination) / radius;
    }

    /** About the axis of the helix (N m). */
    double moment() const
    {
      return bending * curvature() * std::sin(inclination) +
        torsion * std::cos(inclination) + radius * force_around();
    }
  };

  /** Two rods of length 0.5 m along z, at x = +-R, whose ends at the top are
   * turned about z by 2 pi @p turns and pulled; those at the bottom are held. */
  SceneText twisted_rods(const double radius,
                         const double modulus,
                         const double pull,
                         const double turns)
  {
    const std::string x     = text(radius * (1 + 1e-6)),
                      angle = text(2 * pi * turns) + " * t";
    const auto on_circle    = [&](const std::string &at) {
      return SpaceTexts{{at + " * (cos(" + angle + ") - 1)",
                         at + " * sin(" + angle + ")",
                         "free"}};
    };
    const SpaceTexts turned = {{"0", "0", angle}}, none = {{"0", "0", "0"}};
    return static_space_frame(x + " 0 0; " + x + " 0 0.5; -" + x + " 0 0; -" +
                                x + " 0 0.5",
                              "0 1; 2 3")
      .circle("rod", radius, {modulus, "", 0.3})
      .set("Effects/Shear flexibility", "off")
      .support("held", "0, 2", "clamp")
      .prescribe("turned", "1", on_circle(x), turned)
      .prescribe("turned too", "3", on_circle("-" + x), turned)
      .load("pull", "1, 3", {{"0", "0", text(pull)}}, none)
      .set("Newton/Tolerance", 1e-8)
      .mesh(3, 4);
  }

  /** Measured shape of the rods in the middle eighth of their length. */
  struct MiddleOfRods
  {
    explicit MiddleOfRods(const SpaceRun &run)
    {
      constexpr double low = 7. / 16, high = 9. / 16;
      double           length = 0, turn = 0, rise = 0;
      unsigned int     n = 0;
      for (const StrutGroup &group : run.equations.reporting().struts)
        for (unsigned int e = group.forces->elements().begin;
             e < group.forces->elements().end;
             ++e)
          {
            const auto &element = run.model.numbering.elements()[e].interval;
            if (element.strut != 0 || element.begin < low - 1e-9 ||
                element.end > high + 1e-9)
              continue;
            const auto line = group.forces->axis(run.state.displacement, e, 9);
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
              {
                const auto &a = line[i], &b = line[i + 1];
                length += (b - a).norm();
                turn += std::atan2(a[0] * b[1] - a[1] * b[0],
                                   a[0] * b[0] + a[1] * b[1]);
                rise += b[2] - a[2];
                radius += std::hypot(a[0], a[1]);
                ++n;
              }
          }
      radius /= n;
      inclination = std::atan(radius * turn / rise);
      // Half of it by the points of either.
      for (const ContactReport &contact :
           run.equations.reporting().strut_contact->contacts(
             run.equations.strut_contact_results(run.results),
             run.state))
        // An eighth of the radius aside it begins and ends between points.
        if (const double at = (contact.rest[2] - 0.625e-3) / 0.5;
            at > low && at < high)
          contact_force += contact.force.norm() / length;
    }

    double radius = 0, inclination = 0;
    double contact_force = 0; ///< per length (N/m)
  };
} // namespace

TEST(ContactTwist, RodsWindAboutEachOther)
{
  const double radius = 5e-3, turns = 2, E = 1e9, pull = 400,
               area = pi * radius * radius;
  SpaceRun        run(twisted_rods(radius, E, pull, turns).time(1, 0.05));
  ComparisonTable table("Two pulled rods twisted about each other, in the "
                        "middle: uniform double helix of Kirchhoff's rods");
  run.run([&] {
    const double t = run.state.time;
    if (std::abs(2 * t - std::round(2 * t)) > 1e-9)
      return;
    const MiddleOfRods middle(run);
    const std::string  at = label("turns", turns * t) + ": ";
    // The moment along the axis of a rod is the same all along it, and that at
    // its end, which points along z. Curvature is per length at rest.
    const HelixOfRod  helix{E * area * radius * radius / 4 *
                             (1 + pull / (E * area)),
                           run.moment("turned")[2],
                           middle.radius,
                           middle.inclination,
                           pull};
    const SpaceVector end = run.position(1), force = run.force("turned");
    // Faces in series of the stiffness EA / (2 R^2) each, by the parabola with
    // which forces begin, up to a hundredth of the radius of both.
    const double stiffness   = E * area / (4 * radius * radius),
                 penetration = std::sqrt(2 * 0.02 * radius *
                                         helix.contact_force() / stiffness);
    EXPECT_LT(penetration, 0.02 * radius);
    // The disturbance of the ends fades as exp(-z / sqrt(EI / N)): to two
    // thousandths where the middle begins.
    table.row(at + "radius of the helix (m)",
              middle.radius,
              radius - penetration / 2,
              1e-4 * radius);
    table.relative(at + "contact force per length (N/m)",
                   middle.contact_force,
                   helix.contact_force(),
                   5e-3);
    table.relative(at + "moment of a rod about the axis (N m)",
                   run.moment("turned")[2] + end[0] * force[1] -
                     end[1] * force[0],
                   helix.moment(),
                   1e-3);
  });
}
