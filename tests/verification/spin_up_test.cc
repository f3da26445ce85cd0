#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/round_beam.h>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A beam turned about its root from rest to 6 rad/s in 15 s (Simo & Vu-Quoc
// 1988): EA = 2.8e7, GA = 1e7, EI = 1.4e4, rho A = 1.2, rho I = 6e-4, L = 10.

namespace
{
  SceneText spin_up(const double dt, const double end)
  {
    return SceneText()
      .frame("0 0; 10 0", "0 1")
      .add("Sections/blade",
           "Shape = given | Area = 1 | Shear area = 10/14 | "
           "Second moment of area = 5e-4 | Young's modulus = 2.8e7 | "
           "Poisson's ratio = 0 | Density = 1.2")
      .add("Supports/hub",
           "Joints = 0 | Type = prescribed | Displacement x = 0 | "
           "Displacement y = 0 | "
           "Rotation z = if(t < 15, "
           "6/15*(t^2/2+(15/(2*pi))^2*(cos(2*pi*t/15)-1)), 6*t-45)")
      .mesh(4, 1)
      .time(end, dt);
  }

  /** Motion of the tip seen from the turning root. */
  struct TipMotion
  {
    double axial, transverse, rotation;
  };

  TipMotion tip(const SceneRun &run)
  {
    const double L = 10, psi = run.motion(0, rotation_z);
    const double x = L + run.motion(1, 0), y = run.motion(1, 1);
    return {x * std::cos(psi) + y * std::sin(psi) - L,
            y * std::cos(psi) - x * std::sin(psi),
            run.motion(1, rotation_z) - psi};
  }

  struct SpinMoment
  {
    double    time;
    TipMotion tip;
  };

  /**
   * Explicit Runge-Kutta on 20 to 160 two-node elements, extrapolated; its
   * uncertainty is 1e-6 along and 5e-6 across.
   */
  const std::vector<SpinMoment> expected = {
    {2.5, {-0.001323, -0.151284, -0.020621}},
    {5, {-0.012655, -0.468476, -0.063717}},
    {6.5, {-0.018603, -0.569948, -0.076919}},
    {7.5, {-0.017742, -0.559083, -0.074779}},
    {10, {-0.007072, -0.362815, -0.047237}},
    {12.5, {-0.000222, -0.112696, -0.014435}},
    {15, {0.000514, 0.001304, 0.000168}}};

  struct SpinUpHistory
  {
    std::vector<TipMotion> at_moments;
    double                 steady_extension = 0; ///< mean over 15 s < t < 20 s
  };

  SpinUpHistory run_spin_up(const double dt)
  {
    SceneRun      run(spin_up(dt, 20));
    SpinUpHistory course;
    unsigned      n_steady_steps = 0;
    run.run([&] {
      const double       t = run.state.time;
      const unsigned int n = course.at_moments.size();
      if (n < expected.size() && t > expected[n].time - dt / 2)
        course.at_moments.push_back(tip(run));
      if (t > 15)
        {
          course.steady_extension += tip(run).axial;
          ++n_steady_steps;
        }
    });
    course.steady_extension /= n_steady_steps;
    return course;
  }
} // namespace

TEST(SpinUp, FollowsTheReferenceAndStretchesAsTheClosedForm)
{
  const SpinUpHistory coarse = run_spin_up(2.5e-3), fine = run_spin_up(1.25e-3);
  ComparisonTable table("Spin-up of a flexible beam (Simo & Vu-Quoc 1988), tip "
                        "in the turning frame (m, rad), extrapolated from "
                        "steps of 2.5 and 1.25 ms");
  ASSERT_EQ(fine.at_moments.size(), expected.size());
  for (unsigned int i = 0; i < expected.size(); ++i)
    {
      const TipMotion &c = coarse.at_moments[i], &f = fine.at_moments[i],
                      &reference = expected[i].tip;
      const double t             = expected[i].time;
      // The uncertainties with half a unit of the last digit; a rotation goes
      // with 1.4 / L of a displacement.
      table.row(label("along, t", t),
                extrapolated(c.axial, f.axial),
                reference.axial,
                1.5e-6);
      table.row(label("across, t", t),
                extrapolated(c.transverse, f.transverse),
                reference.transverse,
                5.5e-6);
      table.row(label("rotation, t", t),
                extrapolated(c.rotation, f.rotation),
                reference.rotation,
                1.2e-6);
    }

  // Steady rotation: extension tan(kL)/k - L, k = w sqrt(rho A / EA). The
  // remaining oscillation of 3.4e-3 across shortens the beam by about
  // 0.6 (3.4e-3)^2 / L = 7e-7 at most.
  const double k = 6 * std::sqrt(1.2 / 2.8e7);
  table.row("mean extension, t > 15",
            fine.steady_extension,
            std::tan(10 * k) / k - 10,
            7e-7);
}
