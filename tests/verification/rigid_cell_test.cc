#include <auxfem/rigid/effects/rigid_part_group.h>

#include <gtest/gtest.h>
#include <support/cell_scene.h>
#include <support/run_program.h>
#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  std::string assignment(const std::string &path, const double value)
  {
    std::ostringstream text;
    text << std::setprecision(17) << path << '=' << value;
    return text.str();
  }

  /** Overrides that turn prm/rigid-cell.prm into case @p c. */
  std::vector<std::string> overrides(const CellCase &c)
  {
    return {assignment("Lattice/Bar length", c.bar_length),
            assignment("Lattice/Angle", c.angle),
            assignment("Rigid parts/bars/Mass", c.bar_mass),
            assignment("Rigid parts/upper and lower/Mass", c.part_mass),
            "Loads/impact/Force y=-(" + c.load + ")",
            "Connectors/damper/Law=" + c.law,
            assignment("Connectors/damper/Spring stiffness", c.stiffness),
            assignment("Connectors/damper/Damping coefficient", c.damping),
            assignment("Time/End time", c.end),
            assignment("Time/Time step", c.end / c.n_steps),
            assignment("Newton/Tolerance", c.tolerance),
            "Time/Scheme=" + c.scheme};
  }

  /** The cell of rigid (or other) parts, run by the lattice's time stepper. */
  class LatticeCell
  {
  public:
    explicit LatticeCell(const CellCase    &c,
                         const std::string &file = "rigid-cell.prm",
                         const std::vector<std::string> &more = {})
      : c(c)
      , run(prm_text(file), with(overrides(c), more))
    {}

    unsigned int joint(const std::string &name) const
    {
      return run.lattice.joint_sets.at(name).front();
    }

    /** Angle of the bar from F to A (rad). */
    double angle() const
    {
      const auto d = [&](const unsigned int i) {
        return run.lattice.joints[joint("A")][i] -
          run.lattice.joints[joint("F")][i] + run.motion(joint("A"), i) -
          run.motion(joint("F"), i);
      };
      return std::atan2(d(1), d(0));
    }

    double transmitted() const
    {
      return -run.connector(0, 0).force;
    }

    /** Force joint @p name exerts on the rigid part of strut set @p bar. */
    SpaceVector hinge_force(const std::string &bar,
                            const std::string &name) const
    {
      const RigidPartGroup &parts = *run.equations.reporting().rigid_parts;
      const unsigned int    strut = run.lattice.strut_sets.at(bar).front();
      for (unsigned int i = 0; i < parts.n_reported(); ++i)
        if (parts.part(i) == run.lattice.struts[strut].rigid_part)
          {
            const auto &joints = run.lattice.rigid_parts[parts.part(i)].joints;
            for (unsigned int k = 0; k < joints.size(); ++k)
              if (joints[k] == joint(name))
                return parts.report(i, run.state).forces[k];
          }
      throw std::logic_error("no such bar or joint");
    }

    double acceleration(const std::string &name, const unsigned int i) const
    {
      return (
        *run.state
           .acceleration)[run.model.numbering.joint_unknown(joint(name), i)];
    }

    /** Largest change of a bar's length (m). */
    double drift() const
    {
      double result = 0;
      for (const unsigned int s : run.lattice.strut_sets.at("bars"))
        {
          const auto  &ends = run.lattice.struts[s].joints;
          const double x    = run.lattice.joints[ends[1]][0] -
            run.lattice.joints[ends[0]][0] + run.motion(ends[1], 0) -
            run.motion(ends[0], 0);
          const double y = run.lattice.joints[ends[1]][1] -
            run.lattice.joints[ends[0]][1] + run.motion(ends[1], 1) -
            run.motion(ends[0], 1);
          result = std::max(result, std::abs(std::hypot(x, y) - c.bar_length));
        }
      return result;
    }

    const CellCase c;
    SceneRun       run;

  private:
    static std::vector<std::string> with(std::vector<std::string>        list,
                                         const std::vector<std::string> &more)
    {
      list.insert(list.end(), more.begin(), more.end());
      return list;
    }
  };

  /** Largest differences from the reduced cell, of the largest values. */
  struct Difference
  {
    double theta = 0, f2 = 0;
    double balance = 0; ///< of the work done
    double drift   = 0; ///< m
  };

  Difference difference(LatticeCell                   &cell,
                        const std::vector<CellSample> &reference)
  {
    Difference        result;
    const std::size_t ratio = (cell.c.n_steps) / (reference.size() - 1);
    cell.run.run([&] {
      result.drift = std::max(result.drift, cell.drift());
      if (cell.run.state.step % ratio != 0)
        return;
      const CellSample &sample = reference[cell.run.state.step / ratio];
      result.theta =
        std::max(result.theta, std::abs(cell.angle() - sample.angle));
      result.f2 =
        std::max(result.f2, std::abs(cell.transmitted() - sample.transmitted));
    });
    result.theta /= largest(reference, &CellSample::angle);
    result.f2 /= largest(reference, &CellSample::transmitted);
    result.balance =
      std::abs(cell.run.balance()) / cell.run.state.energies.external();
    return result;
  }

  /** Reference of @p c at 250 times. */
  std::vector<CellSample> reference_of(CellCase c)
  {
    c.scheme  = "arkode";
    c.n_steps = 250;
    return complete_history(c);
  }
} // namespace

TEST(RigidCellVerification, ConvergesToTheReducedEquations)
{
  ResultTable table(
    "Cell of rigid parts by newmark, largest differences from "
    "the reduced equations by arkode, of the largest value",
    {"case", "steps", "theta", "f2", "orders", "balance", "drift (m)"});
  for (const unsigned int number : {1, 4, 5, 8})
    {
      CellCase                      c         = table_case(number);
      const std::vector<CellSample> reference = reference_of(c);
      c.scheme                                = "newmark";
      Difference before;
      for (const unsigned int n_steps : {250, 500, 1000, 2000, 20000})
        {
          c.n_steps = n_steps;
          LatticeCell      cell(c);
          const Difference now = difference(cell, reference);
          std::string      orders;
          const bool       is_doubled = n_steps > 250 && n_steps < 20000;
          if (is_doubled)
            {
              const double theta_order = std::log2(before.theta / now.theta),
                           f2_order    = std::log2(before.f2 / now.f2);
              orders =
                formatted("%.2f", theta_order) + formatted("; %.2f", f2_order);
              EXPECT_NEAR(theta_order, 2, 0.1) << "case " << number;
              EXPECT_NEAR(f2_order, 2, 0.1) << "case " << number;
            }
          table.row({std::to_string(number),
                     std::to_string(n_steps),
                     formatted("%.2e", now.theta),
                     formatted("%.2e", now.f2),
                     orders,
                     formatted("%.2e", now.balance),
                     formatted("%.2e", now.drift)});
          // Some roundings of coordinates of up to 0.6 m.
          EXPECT_LT(now.drift, 1e-14 * std::sqrt(n_steps));
          before = now;
        }
      EXPECT_LT(before.theta, 1e-6) << "case " << number;
      EXPECT_LT(before.f2, 1e-6) << "case " << number;
      EXPECT_LT(before.balance, 1e-8) << "case " << number;
    }
}

TEST(RigidCellVerification, HingeForcesBalanceTheParts)
{
  CellCase c = table_case(1);
  c.scheme   = "generalized-alpha";
  LatticeCell cell(c);
  cell.run.run([&] {
    const SpaceVector F  = cell.hinge_force("bar AF", "F"),
                      A1 = cell.hinge_force("bar AF", "A"),
                      A2 = cell.hinge_force("bar AB", "A"),
                      B  = cell.hinge_force("bar AB", "B");
    const double f2 = cell.transmitted(), t = cell.run.state.time;
    const double f1 = 2e7 * t * t * t;
    // Round-off of the constraints in accelerations: 1e-16 m / dt^2, a few
    // times, on 0.3 kg.
    const double allowed = 1e-6;
    // Action and reaction in A; lower and upper part (Eqs. 17 and 14).
    EXPECT_NEAR(A1[0], -A2[0], allowed);
    EXPECT_NEAR(A1[1], -A2[1], allowed);
    EXPECT_NEAR(c.part_mass * cell.acceleration("q", 1), -2 * F[1], allowed);
    EXPECT_NEAR(c.part_mass * cell.acceleration("n", 1),
                f2 - f1 - 2 * B[1],
                allowed);
    // The bar AB turns about its middle (Eq. 11, third row).
    const double theta = cell.angle(), half = c.bar_length / 2;
    const double turning = c.bar_mass * c.bar_length / 12 *
      ((cell.acceleration("B", 0) - cell.acceleration("A", 0)) *
         -std::sin(theta) +
       (cell.acceleration("B", 1) - cell.acceleration("A", 1)) *
         -std::cos(theta));
    const SpaceVector across = B - A2;
    EXPECT_NEAR(half *
                  (across[0] * -std::sin(theta) + across[1] * -std::cos(theta)),
                turning,
                allowed);
  });
}

TEST(RigidCellVerification, HingeForcesAreSmoothAtTinySteps)
{
  // Round-off in the constraints, 1e-17 m, is 1e-5 m/s2 when divided by dt^2;
  // kept from step to step it would alternate and add up.
  for (const char *scheme : {"newmark", "generalized-alpha"})
    {
      CellCase c = table_case(1);
      c.scheme   = scheme;
      c.end      = 0.01;
      c.n_steps  = 5000;
      LatticeCell cell(c);
      double      before = 0, last = 0, largest_jump = 0;
      cell.run.run([&] {
        const double now = cell.hinge_force("bar AB", "B")[1];
        if (cell.run.state.step > 2)
          largest_jump =
            std::max(largest_jump, std::abs(now - 2 * last + before));
        before = last;
        last   = now;
      });
      std::cout << scheme << ": second difference of the force at B "
                << largest_jump << " N\n";
      // With generalized-alpha of spectral radius 1 it is 1.4e-2.
      EXPECT_LT(largest_jump, 1e-5) << scheme;
    }
}

TEST(RigidCellVerification, MasslessBarsLeaveAOneMassOscillator)
{
  CellCase c = table_case(4);
  c.scheme   = "newmark";
  c.bar_mass = 0;
  c.n_steps  = 4000;
  c.end      = 0.02;
  LatticeCell cell(c);
  // m2 y'' + C y' + K y = -s t, from rest.
  const double K = c.stiffness, C = c.damping, m = c.part_mass, s = 5e4;
  const double delta = C / (2 * m), omega = std::sqrt(K / m - delta * delta);
  const double a = s * C / (K * K), b = (s / K - delta * a) / -omega;
  double       worst = 0;
  cell.run.run([&] {
    const double t = cell.run.state.time;
    const double y = a - s / K * t -
      std::exp(-delta * t) *
        (a * std::cos(omega * t) + b * std::sin(omega * t));
    worst = std::max(worst, std::abs(cell.run.motion(cell.joint("n"), 1) - y));
    EXPECT_NEAR(cell.run.motion(cell.joint("q"), 1), 0, 1e-12);
  });
  // (omega dt)^2 / 12 of the amplitude, 2e-7 of 0.05 m.
  EXPECT_LT(worst, 2e-8);
}

namespace
{
  /** prm/rigid-cell.prm with elastic bars, hinged at both ends. */
  std::string text_with_elastic_bars()
  {
    std::string       text     = prm_text("rigid-cell.prm");
    const std::string bars     = R"(  subsection bars
    set Struts = bars
    set Parts  = single struts
    set Mass   = 0.1 kg
  end
)";
    const std::size_t position = text.find(bars);
    if (position == std::string::npos)
      throw std::logic_error("prm/rigid-cell.prm has changed");
    text.erase(position, bars.size());
    // Bars of 0.1 kg over 0.5 m.
    return text.substr(0, text.find("subsection Probes")) +
      SceneText()
        .given("bars", {1e-4, 1e-4, 1e-7}, {1e10, 2000})
        .add("Sections/bars", "Struts = bars | Drawing radius = 1e-2")
        .hinge("hinges", "A + B + C + D + E + F", "bars")
        .set("Effects/Rotary inertia", "off")
        .str();
  }
} // namespace

TEST(RigidCellVerification, ElasticBarsConvergeToRigidOnes)
{
  const std::string scheme = "Time/Scheme=generalized-alpha";
  SceneRun          rigid(prm_text("rigid-cell.prm"), {scheme});
  rigid.run();
  const unsigned int n = rigid.lattice.joint_sets.at("n").front(),
                     q = rigid.lattice.joint_sets.at("q").front();
  const double Y1 = rigid.motion(n, 1), Y2 = rigid.motion(q, 1);

  ResultTable table(
    "Cell with elastic bars, differences from rigid ones at 50 ms",
    {"EA (N)", "Y1 off (m)", "Y2 off (m)", "order"});
  double before = 0;
  for (const double E : {1e10, 1e11, 1e12, 1e13})
    {
      SceneRun elastic(text_with_elastic_bars(),
                       {scheme,
                        assignment("Sections/bars/Young's modulus", E)});
      elastic.run();
      const double off1  = std::abs(elastic.motion(n, 1) - Y1),
                   off2  = std::abs(elastic.motion(q, 1) - Y2);
      const double off   = std::hypot(off1, off2);
      const double order = before > 0 ? std::log10(before / off) : 0;
      table.row({formatted("%g", E * 1e-4),
                 formatted("%.3g", off1),
                 formatted("%.3g", off2),
                 before > 0 ? formatted("%.3f", order) : ""});
      if (before > 0)
        {
          EXPECT_NEAR(order, 1, 0.1) << "E = " << E;
        }
      before = off;
    }
  EXPECT_LT(before, 1e-7);
}

namespace
{
  /** Sum of mass times vertical acceleration over all rigid parts (N). */
  double vertical_inertia(const SceneRun &run)
  {
    double sum = 0;
    for (const RigidPart &part : run.lattice.rigid_parts)
      {
        const NaturalPosition centre =
          natural_position<2>(run.lattice.joints[part.joints[0]],
                              run.lattice.joints[part.joints[1]],
                              part.centre_of_mass);
        const std::array<double, 4> shares = shape<2>(centre, 1);
        for (unsigned int i = 0; i < 4; ++i)
          sum += part.mass * shares[i] *
            (*run.state.acceleration)
              [run.model.numbering.joint_unknown(part.joints[i / 2], i % 2)];
      }
    return sum;
  }
} // namespace

TEST(RigidArrayVerification, SupportsAndLoadsBalanceTheInertiaOfAllParts)
{
  SceneRun run(prm_text("rigid-array.prm"));
  // Upper part, lower part and rod of 12 cells, less the 4 rods on the ground.
  EXPECT_EQ(run.model.numbering.unknowns().n_free() -
              run.model.numbering.constraints().n_multipliers(),
            32u);
  run.run([&] {
    const double t = run.state.time, f1 = 2500 * std::pow(t / 0.05, 3);
    // Two columns in the middle, two flanks with half the load.
    EXPECT_NEAR(run.reaction("foundation", 1) - 3 * f1,
                vertical_inertia(run),
                1e-6 * (1 + f1));
  });
  EXPECT_LT(std::abs(run.balance()), 1e-6 * run.state.energies.external());
}

TEST(RigidArrayVerification, IsOfSecondOrderInTime)
{
  const auto top_at_end = [](const unsigned int n_steps) {
    SceneRun run(prm_text("rigid-array.prm"),
                 {assignment("Time/Time step", 0.05 / n_steps),
                  "Newton/Tolerance=1e-11"});
    run.run();
    return run.motion(run.lattice.joint_sets.at("middle").front(), 1);
  };
  const double coarse = top_at_end(250), middle = top_at_end(500),
               fine = top_at_end(1000);
  const double order =
    std::log2(std::abs(coarse - middle) / std::abs(middle - fine));
  std::cout << "order of the middle column's displacement: " << order << '\n';
  EXPECT_NEAR(order, 2, 0.1);
}

TEST(ElasticCellVerification, ThickStripsComeDownAsOneMass)
{
  // Ten times the height, a tenth of the density: the masses stay. The limit
  // is a mass of 1 kg on K = 20 kN/m, C = 50 N s/m under 2e7 t^3.
  SceneRun     run(prm_text("elastic-cell.prm"),
               {"Sections/bars/Height=40 mm",
                    "Sections/upper and lower/Height=40 mm",
                    "Sections/bars/Density=250",
                    "Sections/upper and lower/Density=299.27"});
  const double K = 20e3, C = 50, a = 2e7;
  // Particular solution of y'' + C y' + K y = a t^3 by comparing powers of t.
  const double c3 = a / K, c2 = -3 * C * c3 / K,
               c1 = -(6 * c3 + 2 * C * c2) / K, c0 = -(2 * c2 + C * c1) / K;
  const double delta = C / 2, omega = std::sqrt(K - delta * delta);
  const double A = -c0, B = (delta * A - c1) / omega;
  double       worst = 0, largest = 0;
  run.run([&] {
    const double t = run.state.time, decay = std::exp(-delta * t);
    const double y = c0 + t * (c1 + t * (c2 + t * c3)) +
      decay * (A * std::cos(omega * t) + B * std::sin(omega * t));
    const double v = c1 + t * (2 * c2 + 3 * t * c3) +
      decay *
        ((omega * B - delta * A) * std::cos(omega * t) -
         (omega * A + delta * B) * std::sin(omega * t));
    const double f2  = K * y + C * v;
    const double now = -run.connector(0, 0).force;
    worst            = std::max(worst, std::abs(now - f2));
    largest          = std::max(largest, f2);
  });
  std::cout << "f2 of 40 mm strips, off by " << worst << " of " << largest
            << " N\n";
  EXPECT_LT(worst, 1e-3 * largest);
}

TEST(ElasticCellVerification, ThinStripsBendAsTheDocumentationHasIt)
{
  SceneRun run(prm_text("elastic-cell.prm"));
  run.run();
  EXPECT_NEAR(-run.connector(0, 0).force, 2369.93, 0.5);
}
