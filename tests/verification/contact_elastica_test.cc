#include <auxfem/contact/effects/contact.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <limits>

#include <support/pi.h>
#include <verification/elastica.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Strips that bend far and lie partly on a rigid plane: elastica by shooting
// from where they lift off.

namespace
{
  constexpr double strip_thickness = 0.005;

  /** A strip of length 1 and EI = 1 between joint 0 and joint 1 above the plane
   * y = 0 of axes that touch it. */
  SceneText strip_on_plane(const std::string &joints)
  {
    const double width =
      12. / (1e9 * strip_thickness * strip_thickness * strip_thickness);
    return static_frame(joints, "0 1")
      .rectangle("strip", width, strip_thickness, {1e9})
      .set("Effects/Shear flexibility", "off")
      .add("Plates/plane",
           "Shape = plane | Normal = 0 1 | Position = 0 " +
             text(-strip_thickness / 2))
      .set("Newton/Tolerance", 1e-9)
      .mesh(3, 5);
  }

  /** Contacts with the plane. */
  std::vector<ContactReport> contacts(const SceneRun &run)
  {
    return run.equations.reporting()
      .plates->contacts(run.equations.plate_results(run.results), run.state);
  }

  /** Along the plane (m). */
  double place(const ContactReport &contact)
  {
    return contact.rest[0] + contact.displacement[0];
  }

  /** Whether a scene of even steps is at a multiple of @p period. */
  bool is_multiple(const double time, const double period)
  {
    return std::abs(time - period * std::round(time / period)) < 1e-9;
  }

  /** A strip with a part that lies on the plane, and one that is free. */
  struct Lying
  {
    double free_length, force; ///< of the plane where the strip lifts off
    double angle;              ///< there: zero if some of it lies
    Elastica::Point end;       ///< with the strip's other end at x = 0

    /** Where it lifts off, with @p end_x the place of the held end. */
    double lift_off(const double end_x) const
    {
      return end_x - end[0];
    }
  };

  /** The strip pressed on the plane by a clamp at @p height, at @p inclination,
   * touching with its tip or lying on a part. */
  Lying pressed_strip(const double height, const double inclination)
  {
    const auto free_part = [](const double length, const double force) {
      return Elastica{length, 0, -force};
    };
    // From the tip, whose direction is unknown.
    const std::vector<double> tip = shoot(
      [&](const std::vector<double> &u) {
        const auto end = free_part(1, u[1]).end({{0, 0, u[0], 0}});
        return std::vector<double>{end[1] - height, end[2] - inclination};
      },
      {inclination / 2, 1});
    if (tip[0] >= 0)
      return {1, tip[1], tip[0], free_part(1, tip[1]).end({{0, 0, tip[0], 0}})};
    const std::vector<double> part = shoot(
      [&](const std::vector<double> &u) {
        const auto end = free_part(u[0], u[1]).end({{0, 0, 0, 0}});
        return std::vector<double>{end[1] - height, end[2] - inclination};
      },
      {std::min(1., 3 * height), 0.2 / (height * height)});
    return {part[0],
            part[1],
            0,
            free_part(part[0], part[1]).end({{0, 0, 0, 0}})};
  }
} // namespace

TEST(ContactElastica, ClampedStripIsPressedOnAPlane)
{
  const double inclination = pi / 3, height = std::sin(inclination),
               x = std::cos(inclination);
  SceneRun        run(strip_on_plane("0 0; " + text(x) + " " + text(height))
                 .prescribe("clamp", "1", {"0", "-t", "0"})
                 .time(0.75, 0.0125));
  ComparisonTable table(
    "Clamped strip pressed on a rigid plane, at 60 degrees, "
    "inextensible elastica by shooting");
  unsigned int n_tip = 0, n_flat = 0;
  run.run([&] {
    const double down = run.state.time;
    if (!is_multiple(down, 0.15))
      return;
    const Lying       exact = pressed_strip(height - down, inclination);
    const bool        lies  = exact.free_length < 1;
    const std::string at    = label("approach / L", down) + ": ";
    (lies ? n_flat : n_tip) += 1;
    double force = 0, first_moment = 0;
    for (const ContactReport &contact : contacts(run))
      {
        force += contact.force[1];
        first_moment += contact.force[1] * place(contact);
      }
    // The strip is extensible by (t / L)^2 / 12, and a point force goes into
    // the faces along about t / 2 to both sides, t being 5e-3 L; what lifts off
    // is 0.3 L at least.
    const double allowed = 5e-4;
    table.relative(at + "force", force, exact.force, allowed);
    table.relative(at + "moment at the clamp",
                   run.reaction("clamp", rotation_z),
                   exact.end[3],
                   allowed);
    if (lies)
      table.row(at + "lift-off, x / L",
                first_moment / force,
                exact.lift_off(x),
                strip_thickness / 10);
    table.row(at + "tip, x / L",
              run.motion(0, 0),
              exact.lift_off(x) - (1 - exact.free_length),
              2e-5);
  });
  EXPECT_GE(n_tip, 2u);
  EXPECT_GE(n_flat, 2u);
}

TEST(ContactElastica, HeavyStripIsLiftedHigh)
{
  const double weight = 125;
  SceneRun     run(
    strip_on_plane("0 0; 1 0")
      // Without weight nothing else would hold the strip.
      .prescribe("other end", "0", {"free", "0", "free"})
      .prescribe("lift", "1", {"0", "if(t < 1, 0, t - 1)", "free"})
      .add("Loads/weight",
           "Type = line | Struts = all | Force per length y = " +
             text(-weight) + " * min(t, 1)")
      // The force on what has just been lifted grows with the fourth root of
      // the height: its work in a first step is not that of its mean.
      .set("Time/Largest energy error", 2)
      .time(1.4, 0.0125));
  ComparisonTable table(
    "Heavy strip lifted high off a plane, w L^3 / EI = 125, "
    "inextensible elastica by shooting");
  std::vector<double> guess = {0.3, 20};
  run.run([&] {
    const double height = run.state.time - 1;
    if (height < 0.05 || !is_multiple(height, 0.1))
      return;
    const auto free_part = [&](const std::vector<double> &u) {
      return Elastica{u[0], 0, -u[1], -weight}.end({{0, 0, 0, 0}});
    };
    guess = shoot(
      [&](const std::vector<double> &u) {
        const auto end = free_part(u);
        return std::vector<double>{end[1] - height, end[3]};
      },
      guess);
    const double      length = guess[0];
    const auto        end    = free_part(guess);
    const std::string at     = label("height / L", height) + ": ";
    double            last   = -std::numeric_limits<double>::infinity();
    for (const ContactReport &contact : contacts(run))
      last = std::max(last, place(contact));
    // As above.
    table.relative(at + "force",
                   run.reaction("lift", 1),
                   weight * length - guess[1],
                   5e-4);
    table.row(at + "angle of the end", run.motion(1, rotation_z), end[2], 2e-4);
    // The force where it lifts off is spread over 1.5 t to both sides, as of a
    // beam on a soft ground, and points are t apart at most.
    table.row(at + "lift-off, x / L", last, 1 - end[0], 2.5 * strip_thickness);
    table.row(at + "other end, x / L", run.motion(0, 0), length - end[0], 1e-4);
  });
}
