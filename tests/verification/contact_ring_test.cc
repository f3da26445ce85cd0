#include <auxfem/contact/effects/contact.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <support/pi.h>
#include <verification/elastica.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Rings whose two sides meet: inextensible elastica by shooting, with a point
// force at the middle once they touch.

namespace
{
  constexpr double ring_thickness = 0.02;

  /** A ring R = EI = 1 of four arcs, symmetric about both axes. Joint 1 is its
   * top, joint 3 its bottom. */
  SceneText ring()
  {
    const double width =
      12. / (1e9 * ring_thickness * ring_thickness * ring_thickness);
    const std::string rise = text(std::sqrt(0.5) - 1);
    return static_frame("1 0; 0 1; -1 0; 0 -1",
                        "0 1 " + rise + "; 1 2 " + rise + "; 2 3 " + rise +
                          "; 3 0 " + rise)
      .rectangle("ring", width, ring_thickness, {1e9})
      .set("Effects/Shear flexibility", "off")
      .prescribe("sides", "0, 2", {"free", "0", "0"})
      .prescribe("top and bottom", "1, 3", {"0", "free", "0"})
      .mesh(3, 3)
      .set("Newton/Tolerance", 1e-9);
  }

  /** Force (N) of the two halves on each other. */
  double force_between_sides(const SceneRun &run)
  {
    double force = 0;
    // Half of it by the points of either.
    for (const ContactReport &contact :
         run.equations.reporting().strut_contact->contacts(
           run.equations.strut_contact_results(run.results),
           run.state))
      force += std::abs(contact.force[1]);
    return force;
  }

  /** A quarter of the ring from its top to its side. */
  struct Quarter
  {
    double contact; ///< force of one half on the other
    double flat;    ///< length along which a quarter lies on the other one
    double top;     ///< height of the top
    double side;    ///< distance of the side from the middle
  };

  /** The end of a quarter that begins behind its @p flat part. */
  Elastica::Point end_of_quarter(const double load,
                                 const double contact,
                                 const double flat,
                                 const double moment)
  {
    return Elastica{pi / 2 - flat, 0, -contact / 2, -load, -1}.end(
      {{flat, 0, 0, moment}});
  }

  /** Not touching, with @p guess the moment at the top. */
  Quarter free_quarter(const double load, double &guess)
  {
    guess = shoot(
      [&](const std::vector<double> &u) {
        return std::vector<double>{end_of_quarter(load, 0, 0, u[0])[2] +
                                   pi / 2};
      },
      {guess})[0];
    const auto end = end_of_quarter(load, 0, 0, guess);
    return {0, 0, -end[1], end[0]};
  }

  /** Touching at its top. */
  Quarter touching_quarter(const double load)
  {
    const auto u = shoot(
      [&](const std::vector<double> &u) {
        const auto end = end_of_quarter(load, u[0], 0, u[1]);
        return std::vector<double>{end[2] + pi / 2,
                                   end[1] + ring_thickness / 2};
      },
      {0, 2});
    // With less, a part of the ring would lie flat.
    EXPECT_GT(u[1], 1);
    return {u[0],
            0,
            ring_thickness / 2,
            end_of_quarter(load, u[0], 0, u[1])[0]};
  }

  /** Lying on the other half along a part, straight. @p guess of the force
   * where it lifts off and of the length of the part, for loads above. */
  Quarter flat_quarter(const double load, std::vector<double> &guess)
  {
    guess = shoot(
      [&](const std::vector<double> &u) {
        const auto end = end_of_quarter(load, u[0], u[1], 1);
        return std::vector<double>{end[2] + pi / 2,
                                   end[1] + ring_thickness / 2};
      },
      guess);
    EXPECT_GT(guess[1], 0);
    return {guess[0] + 2 * load * guess[1],
            guess[1],
            ring_thickness / 2,
            end_of_quarter(load, guess[0], guess[1], 1)[0]};
  }

  /** The load at which both sides meet. */
  double load_of_first_contact()
  {
    return shoot(
      [](const std::vector<double> &u) {
        const auto end = end_of_quarter(u[0], 0, 0, u[1]);
        return std::vector<double>{end[2] + pi / 2,
                                   end[1] + ring_thickness / 2};
      },
      {5, 1.9})[0];
  }
} // namespace

TEST(ContactRing, SidesMeetUnderLoadsTowardsTheMiddle)
{
  SceneRun            run(ring()
                 .add("Loads/upper half",
                      "Type = line | Struts = 0, 1 | Force per length y = -t")
                 .add("Loads/lower half",
                      "Type = line | Struts = 2, 3 | Force per length y = t")
                 .time(14, 0.125));
  ComparisonTable     table("Ring under dead loads w per length towards its "
                            "middle, thickness 0.02 R, sides in contact, "
                            "inextensible elastica by shooting");
  const double        first  = load_of_first_contact();
  double              moment = 0, load_of_contact = 0;
  std::vector<double> lift_off = {7.7, 0};
  // Load and height of the top in the last steps without contact.
  std::array<std::array<double, 2>, 2> last{};
  unsigned int                         n_free = 0, n_touching = 0, n_flat = 0;
  run.run([&] {
    const double load = run.state.time, contact = force_between_sides(run),
                 top = 1 + run.motion(1, 1);
    if (contact == 0)
      last = {{last[1], {{load, top}}}};
    else if (load_of_contact == 0)
      load_of_contact = last[1][0] +
        (last[1][0] - last[0][0]) * (last[1][1] - ring_thickness / 2) /
          (last[0][1] - last[1][1]);
    if (std::abs(load / 2 - std::round(load / 2)) > 1e-9)
      return;
    const bool is_free = load<first, is_flat = load> 9.9;
    (is_free ? n_free : is_flat ? n_flat : n_touching) += 1;
    const Quarter     exact = is_free ? free_quarter(load, moment)
          : is_flat                   ? flat_quarter(load, lift_off)
                                      : touching_quarter(load);
    const std::string at    = label("w R^3 / EI", load) + ": ";
    // The ring is extensible by (t / R)^2 / 12 = 3e-5 of 1 / w, and a contact
    // force goes into the faces along about t / 2.
    table.row(at + "height of the top / R", top, exact.top, 1e-4);
    table.row(at + "side / R", 1 + run.motion(0, 0), exact.side, 1e-4);
    if (!is_free)
      table.relative(at + "force between the sides, R^2 / EI",
                     contact,
                     exact.contact,
                     1e-3);
  });
  // From the last two steps: the slope changes by a thousandth in one.
  table.relative("load of the first contact", load_of_contact, first, 5e-4);
  EXPECT_GE(std::min({n_free, n_touching, n_flat}), 2u);
}

TEST(ContactRing, RoundBodiesPressItTogether)
{
  const double     radius = 0.2;
  const SceneValue place(1 + ring_thickness / 2 + radius);
  const auto       body = [&](const std::string &sign) {
    return "Shape = sphere | Radius = " + text(radius) + " | Position = 0 " +
      sign + place.words + " | Displacement y = " + (sign.empty() ? "-" : "") +
      "1 * (0.98 * min(t, 1) + 0.0102 * max(t - 1, 0))";
  };
  SceneRun        run(ring()
                 .add("Plates/upper", body(""))
                 .add("Plates/lower", body("-"))
                 .time(2, 0.01));
  ComparisonTable table("Ring pressed together by two round bodies, thickness "
                        "0.02 R, inextensible elastica by shooting");
  // Force and moment at the top; the ring pushes back.
  std::vector<double> guess  = {-0.5, 0.1};
  unsigned int        n_free = 0, n_touching = 0;
  run.run([&] {
    const double at_time = run.state.time, top = 1 + run.motion(1, 1);
    guess = shoot(
      [&](const std::vector<double> &u) {
        const auto end = end_of_quarter(0, u[0], 0, u[1]);
        return std::vector<double>{end[2] + pi / 2, end[1] + top};
      },
      guess);
    const double exact = -guess[0], contact = force_between_sides(run),
                 force = run.equations.reporting()
                           .plates
                           ->reports(run.equations.plate_results(run.results),
                                     run.state)[0]
                           .force[1];
    if (contact == 0 &&
        (at_time > 1 || std::abs(5 * at_time - std::round(5 * at_time)) > 1e-9))
      return;
    (contact > 0 ? n_touching : n_free) += 1;
    const std::string at = label("top at y / R", top) + ": ";
    // As above.
    table.relative(at +
                     "force of the bodies less that between the sides, "
                     "R^2 / EI",
                   force - contact,
                   exact,
                   5e-4);
    if (contact > 0)
      {
        EXPECT_GT(contact, exact);
      }
    table.row(at + "side / R",
              1 + run.motion(0, 0),
              end_of_quarter(0, guess[0], 0, guess[1])[0],
              1e-4);
  });
  EXPECT_GE(n_free, 2u);
  EXPECT_GE(n_touching, 2u);
}
