#include <auxfem/contact/effects/contact.h>

#include <verification/result_table.h>
#include <verification/space_run.h>

#include <support/pi.h>
#include <verification/elastica.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Beams that cross in space and touch at a point.

namespace
{
  /** Beams with EI = 1. */
  SceneText round_beams(const double       radius,
                        const std::string &joints,
                        const std::string &struts)
  {
    return static_space_frame(joints, struts)
      .circle("round", radius, {4 / (pi * std::pow(radius, 4)), "", 0})
      .set("Effects/Shear flexibility", "off")
      .set("Newton/Tolerance", 1e-9)
      .mesh(3, 3);
  }

  /** Force (N) along @p component of struts up to @p last on others, half of it
   * by the points of either. */
  double force_on_others(const SceneRun    &run,
                         const unsigned int last,
                         const unsigned int component)
  {
    double force = 0;
    for (const ContactReport &contact :
         run.equations.reporting().strut_contact->contacts(
           run.equations.strut_contact_results(run.results),
           run.state))
      force += (contact.strut <= last ? -1 : 1) * contact.force[component];
    return force;
  }
} // namespace

TEST(ContactCrossing, CantileversShareALoad)
{
  // One along x with a load at its tip, above one along y; each with the force
  // F at the distance a, b from its wall: gap closed where
  // P a^2 (3 L - a) / 6 - F a^3 / 3 - gap EI = F b^3 / 3.
  constexpr double length = 1, a = 0.613, b = 0.551, gap = 1e-4, load = 0.06,
                   radius = 1e-3;
  const std::string above = text(2 * radius + gap);
  SceneRun          run(
    round_beams(radius,
                "0 0 " + above + "; " + text(length) + " 0 " + above + "; " +
                  text(a) + " " + text(-b) + " 0; " + text(a) + " 0.3 0",
                "0 1; 2 3")
      // Faces that hardly give.
      .set("Contact/Stiffness", 100)
      .support("first", "0", "clamp")
      .support("second", "2", "clamp")
      .load("tip", "1", {"0", "0", text(-load) + " * t"}, {"0", "0", "0"})
      .time(1, 0.125));
  ComparisonTable table("Crossing cantilevers in space, small deflections "
                        "(beam theory)");
  run.run([&] {
    const double t = run.state.time;
    if (t != 0.5 && t != 1)
      return;
    const double P     = load * t,
                 force = (P * a * a * (3 * length - a) / 6 - gap) /
      ((a * a * a + b * b * b) / 3);
    const std::string at = label("load (N)", P) + ": ";
    // Slopes are 0.02 at most, of which the square counts. Points of an axis
    // are a quarter of the radius apart, so that the crossing is an eighth
    // beside one at most: the gap is closed later by R / 256.
    const double allowed = 1e-3;
    table.relative(at + "force at the crossing",
                   -force_on_others(run, 0, 2),
                   force,
                   allowed);
    table.relative(at + "moment at the wall of the second",
                   run.reaction("second", first_rotation),
                   force * b,
                   allowed);
    table.relative(at + "deflection of the loaded tip",
                   -run.motion(1, 2),
                   P * length * length * length / 3 -
                     force * a * a * (3 * length - a) / 6,
                   allowed);
    table.relative(at + "deflection of the other tip",
                   -run.motion(3, 2),
                   force * b * b * (3 * (b + 0.3) - b) / 6,
                   allowed);
  });
}

TEST(ContactCrossing, BeamsBendEachOtherFar)
{
  // Both are held in the middle across the force only, so that they bend in
  // their planes.
  const double radius = 0.005, gap = 1e-4, half_distance = radius + gap / 2;
  const std::string up = text(half_distance), down = text(-half_distance);
  const SpaceTexts  free = {{"free", "free", "free"}};
  SceneRun          run(
    round_beams(radius,
                "-1 0 " + up + "; 0 0 " + up + "; 1 0 " + up + "; 0 -1 " +
                  down + "; 0 0 " + down + "; 0 1 " + down,
                "0 1; 1 2; 3 4; 4 5")
      .prescribe("upper ends", "0, 2", {"free", "0", "-t"}, free)
      .prescribe("lower ends", "3, 5", {"0", "free", "t"}, free)
      .prescribe("upper middle", "1", {"0", "0", "free"}, {"0", "0", "0"})
      .prescribe("lower middle", "4", {"0", "0", "free"}, {"0", "0", "0"})
      .time(0.7, 0.025));
  ComparisonTable table("Two crossing beams that bend each other, inextensible "
                        "elastica by shooting");
  // Moment in the middle and half the force.
  std::vector<double> guess = {0.1, 0.1};
  run.run([&] {
    const double t = run.state.time;
    if (std::abs(10 * t - std::round(10 * t)) > 1e-9)
      return;
    const auto half = [](const std::vector<double> &u) {
      return Elastica{1, 0, u[1]}.end({{0, 0, 0, u[0]}});
    };
    guess = shoot(
      [&](const std::vector<double> &u) {
        const auto end = half(u);
        return std::vector<double>{end[1] - (t - gap / 2), end[3]};
      },
      guess);
    const auto        end = half(guess);
    const std::string at  = label("deflection / L", t) + ": ";
    // Faces go in by some 1e-5 L, and beams are extensible by (R / L)^2 / 4
    // times the force, which is 5e-5 at most.
    table.relative(at + "force",
                   run.reaction("lower ends", 2),
                   2 * guess[1],
                   5e-4);
    table.relative(at + "force at the crossing",
                   force_on_others(run, 1, 2),
                   -2 * guess[1],
                   5e-4);
    table.row(at + "end inwards", run.motion(3, 1), 1 - end[0], 1e-4);
    table.row(at + "end inwards, upper", run.motion(0, 0), 1 - end[0], 1e-4);
  });
}
