#include <support/scene_text.h>
#include <verification/result_table.h>

#include <verification/label.h>
#include <verification/momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// The flying spaghetti of Simo & Vu-Quoc (1986), its planar part: a free beam
// from A = (6, 0) to B = (0, 8) with EA = GA = 1e4, EI = 100, rho A = 1,
// rho I = 10; for 2.5 s a force of 8 along x and a moment of -80 act on A.

namespace
{
  /**
   * The rotary inertia of 10 a length is far above that of any section of these
   * stiffnesses: the section brings 0.01, masses on the joints the rest.
   */
  SceneText
  spaghetti(const unsigned int n_struts, const double dt, const double end)
  {
    std::string joints, struts;
    for (unsigned int i = 0; i <= n_struts; ++i)
      {
        const double s = double(i) / n_struts;
        joints += (i > 0 ? "; " : "") + text(6 * (1 - s)) + " " + text(8 * s);
        if (i > 0)
          struts += (i > 1 ? "; " : "") + std::to_string(i - 1) + " " +
            std::to_string(i);
      }
    const std::string last = std::to_string(n_struts);
    const double      lump = 9.99 * 10 / n_struts;
    // A step ends at the jump, so the trapezoidal impulse is exact.
    const std::string pulse = "if(t < 2.5, 1, 0)";
    return SceneText()
      .frame(joints, struts)
      .given("pasta", {1, 2, 0.01}, {1e4, 1, 0})
      .mass("ends", "0, " + last, 0, lump / 2)
      .mass("between", "y > ymin + 1e-6 && y < ymax - 1e-6", 0, lump)
      .add("Loads/throw",
           "Joints = 0 | Force x = 8 * " + pulse + " | Moment z = -80 * " +
             pulse)
      .mesh(2)
      .time(end, dt);
  }

  struct PlaneMoment
  {
    double time;
    double u[3][2]; ///< displacements of A, the middle, B
    double kinetic, strain;
  };
} // namespace

TEST(FlyingBeam, FollowsTheReferenceAndKeepsItsMomenta)
{
  // Explicit Runge-Kutta on 20 to 160 two-node elements.
  const std::vector<PlaneMoment> expected = {
    {2.5, {{-1.037, 4.476}, {3.902, -0.773}, {3.583, -1.888}}, 175.7, 203.8},
    {4, {{2.055, 8.051}, {4.432, -0.885}, {11.223, -4.631}}, 278.1, 101.4},
    {5, {{3.784, 8.203}, {8.727, -0.351}, {8.075, -6.242}}, 297.4, 82.1},
    {7.5, {{10.270, -0.282}, {11.520, 0.056}, {17.239, 0.253}}, 321.3, 58.2},
    {10, {{16.970, 6.412}, {16.112, -0.201}, {21.325, -4.391}}, 202.8, 176.7},
    {15, {{23.064, 6.610}, {27.110, -1.663}, {33.935, -2.765}}, 265.0, 114.5}};

  const unsigned int n_struts = 160;
  const double       dt       = 0.005;
  SceneRun           run(spaghetti(n_struts, dt, 15));
  MomentumMeter      momenta(run);
  ComparisonTable    table("Planar flying spaghetti (Simo & Vu-Quoc 1986)");

  auto   moment          = expected.begin();
  double smallest_moment = 0, largest_moment = 0;
  double smallest_energy = 0, largest_energy = 0;
  run.run([&] {
    const double  t   = run.state.time;
    const Momenta now = momenta();
    // The impulse of the force, none along y: to round-off, as the scheme is
    // linear in momentum and internal forces cancel in every iterate.
    EXPECT_NEAR(now.x, 8 * std::min(t, 2.5), 1e-11) << t;
    EXPECT_NEAR(now.y, 0, 1e-11) << t;
    if (t > 2.5 + dt / 2)
      {
        const double energy = run.state.energies.total();
        if (largest_energy == 0)
          {
            smallest_moment = largest_moment = now.moment;
            smallest_energy = largest_energy = energy;
          }
        smallest_moment = std::min(smallest_moment, now.moment);
        largest_moment  = std::max(largest_moment, now.moment);
        smallest_energy = std::min(smallest_energy, energy);
        largest_energy  = std::max(largest_energy, energy);
      }
    if (moment == expected.end() || t < moment->time - dt / 2)
      return;
    const unsigned int joints[3] = {0, n_struts / 2, n_struts};
    const char        *names[3]  = {"A", "middle", "B"};
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int c = 0; c < 2; ++c)
        // The stated uncertainty of the reference; half the number of struts
        // changes ours by 7e-3 at t = 15, half the step by 1e-3.
        table.row(
          label(std::string(names[j]) + (c == 0 ? ".ux" : ".uy") + ", t", t),
          run.motion(joints[j], c),
          moment->u[j][c],
          8e-3);
    // Waves from the jumps of the load run to and fro between both.
    const Energies &energies = run.state.energies;
    table.row(label("kinetic energy, t", t),
              energies.kinetic(),
              moment->kinetic,
              1);
    table.row(label("strain energy, t", t),
              energies.strain(),
              moment->strain,
              1);
    ++moment;
  });
  EXPECT_EQ(moment, expected.end());

  // 160 elements of the reference give 3e-3 less than its extrapolation; the
  // scheme does not conserve exactly: 3.6e-3 with this step, 0.9e-3 with half.
  table.row("smallest moment of momentum, t > 2.5",
            smallest_moment,
            -229.518,
            4e-3);
  table.row("largest moment of momentum, t > 2.5",
            largest_moment,
            -229.518,
            4e-3);
  // The uncertainty of the reference (first order in h, by the jumps).
  table.row("smallest energy, t > 2.5", smallest_energy, 379.6, 0.2);
  table.row("largest energy, t > 2.5", largest_energy, 379.6, 0.2);
}
