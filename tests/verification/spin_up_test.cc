#include <support/scene_run.h>
#include <verification/comparison_table.h>
#include <verification/frame_text.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A beam turned about its root from rest to 6 rad/s in 15 s (Simo & Vu-Quoc
// 1988): EA = 2.8e7, GA = 1e7, EI = 1.4e4, rho A = 1.2, rho I = 6e-4, L = 10.

namespace
{
  std::string spin_up(const unsigned int refinements, const double dt, const double end)
  {
    return R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 10 0
  set Struts = 0 1
end
subsection Sections
  subsection blade
    set Shape                 = given
    set Area                  = 1
    set Shear area            = 10/14
    set Second moment of area = 5e-4
    set Young's modulus       = 2.8e7
    set Poisson's ratio       = 0
    set Density               = 1.2
  end
end
subsection Supports
  subsection hub
    set Joints         = 0
    set Type           = prescribed
    set Displacement x = 0
    set Displacement y = 0
    set Rotation = if(t < 15, 6/15*(t^2/2+(15/(2*pi))^2*(cos(2*pi*t/15)-1)), 6*t-45)
  end
end
subsection Discretization
  set Order              = 4
  set Global refinements = )" +
      std::to_string(refinements) + R"(
end
subsection Time
  set End time  = )" +
      text(end) + R"(
  set Time step = )" +
      text(dt) + R"(
end
)";
  }

  /** Motion of the tip seen from the turning root. */
  struct TipMotion
  {
    double axial, transverse, rotation;
  };

  TipMotion tip(const SceneRun &run)
  {
    const double L = 10, psi = run.motion(0, 2);
    const double x = L + run.motion(1, 0), y = run.motion(1, 1);
    return {x * std::cos(psi) + y * std::sin(psi) - L,
            y * std::cos(psi) - x * std::sin(psi),
            run.motion(1, 2) - psi};
  }

  struct Moment
  {
    double    time;
    TipMotion tip;
  };
} // namespace

TEST(SpinUp, FollowsTheReferenceAndStretchesAsTheClosedForm)
{
  // Explicit Runge-Kutta on 20 to 160 two-node elements, extrapolated; its
  // uncertainty is 1e-6 along and 5e-6 across, the rotation goes with 5e-6 / L
  // times 1.4.
  const std::vector<Moment> expected = {
    {2.5, {-0.001323, -0.151284, -0.020621}},
    {5, {-0.012655, -0.468476, -0.063717}},
    {6.5, {-0.018603, -0.569948, -0.076919}},
    {7.5, {-0.017742, -0.559083, -0.074779}},
    {10, {-0.007072, -0.362815, -0.047237}},
    {12.5, {-0.000222, -0.112696, -0.014435}},
    {15, {0.000514, 0.001304, 0.000168}}};

  const double    dt = 2.5e-3;
  SceneRun        run(spin_up(1, dt, 20));
  ComparisonTable table("Spin-up of a flexible beam, tip in the turning frame "
                        "(m, rad)");
  auto            moment         = expected.begin();
  double          sum            = 0;
  unsigned int    n_steady_steps = 0;
  run.run([&] {
    const double t = run.state.time;
    if (moment != expected.end() && t > moment->time - dt / 2)
      {
        const TipMotion now = tip(run);
        // Half a unit of the last digit on top of the uncertainty.
        table.row(label("along, t", t), now.axial, moment->tip.axial, 1.5e-6);
        table.row(label("across, t", t),
                  now.transverse,
                  moment->tip.transverse,
                  5.5e-6);
        table.row(label("rotation, t", t),
                  now.rotation,
                  moment->tip.rotation,
                  1.5e-6);
        ++moment;
      }
    if (t > 15)
      {
        sum += tip(run).axial;
        ++n_steady_steps;
      }
  });
  EXPECT_EQ(moment, expected.end());

  // Steady rotation: extension tan(kL)/k - L, k = w sqrt(rho A / EA). The
  // remaining oscillation of 3.4e-3 across shortens the beam by about
  // 0.6 (3.4e-3)^2 / L = 7e-7 at most.
  const double k = 6 * std::sqrt(1.2 / 2.8e7);
  table.row("mean extension, t > 15",
            sum / n_steady_steps,
            std::tan(10 * k) / k - 10,
            7e-7);
}
