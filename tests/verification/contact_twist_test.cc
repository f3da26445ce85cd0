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

    /** Of the other rod on this one, per length (N/m): turns the section force
     * around the axis. */
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

  /** Two rods of length 1 along z, at x = +-R, whose ends z = 1 are turned
   * about z by 2 pi @p turns and pulled; those of z = 0 are held. */
  SceneText twisted_rods(const double radius, const double turns)
  {
    const std::string x     = text(radius * (1 + 1e-6)),
                      angle = text(2 * pi * turns) + " * t";
    const auto on_circle    = [&](const std::string &sign) {
      return SpaceTexts{{sign + x + " * (cos(" + angle + ") - 1)",
                         sign + x + " * sin(" + angle + ")",
                         "free"}};
    };
    const SpaceTexts turned = {{"0", "0", angle}};
    return static_space_frame(x + " 0 0; " + x + " 0 1; -" + x + " 0 0; -" + x +
                                " 0 1",
                              "0 1; 2 3")
      .circle("rod", radius, {1e9, "", 0.3})
      .set("Effects/Shear flexibility", "off")
      .support("held", "0, 2", "clamp")
      .prescribe("turned", "1", on_circle(""), turned)
      .prescribe("turned too", "3", on_circle("-"), turned)
      .load("pull", "1, 3", {"0", "0", "200"}, {"0", "0", "0"})
      .set("Newton/Tolerance", 1e-9)
      .mesh(3, 5);
  }
} // namespace

TEST(ContactTwist, RodsWindAboutEachOther)
{
  const double    radius = 5e-3, turns = 4;
  SpaceRun        run(twisted_rods(radius, turns).time(1, 0.0125));
  const double    E = 1e9, bending = E * pi / 4 * std::pow(radius, 4);
  ComparisonTable table("Two pulled rods twisted about each other, middle: "
                        "uniform double helix of Kirchhoff rods");
  run.run([&] {
    const double t = run.state.time;
    if (std::abs(4 * t - std::round(4 * t)) > 1e-9)
      return;
    printf("t %g F %g M %g contacts %zu\n",
           t,
           run.reaction("turned", 2),
           run.reaction("turned", 5),
           run.equations.reporting()
             .strut_contact
             ->contacts(run.equations.strut_contact_results(run.results),
                        run.state)
             .size());
  });
}
