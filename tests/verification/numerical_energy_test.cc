#include <auxfem/time/schemes/alpha_family.h>

#include <support/energy_amount.h>
#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Energy that time schemes take from the motion beside damping, and the balance
// of the ledger with it.

namespace
{
  Scheme newmark_of(const std::string &beta, const std::string &gamma)
  {
    return {"Newmark " + beta + ", " + gamma,
            "Scheme = newmark | Newmark beta = " + beta +
              " | Newmark gamma = " + gamma};
  }

  const Scheme energy_momentum = {"energy-momentum",
                                  "Scheme = energy-momentum"},
               in_statics      = {"static", "Scheme = static"};

  std::vector<Scheme> all_schemes()
  {
    return {newmark(),
            newmark_of("0.3025", "0.6"),
            newmark_of("0.5", "0.5"),
            hht("-0.05"),
            hht("-0.3"),
            generalized_alpha("1"),
            generalized_alpha("0.8"),
            generalized_alpha("0"),
            energy_momentum,
            in_statics};
  }

  /** A bent frame on a support, with a mass on its end. */
  SceneText frame_scene(const Scheme      &scheme,
                        const double       dt,
                        const double       end,
                        const std::string &section,
                        const std::string &base,
                        const SceneText   &further = {})
  {
    return SceneText()
      .frame("0 0; 1 0.2; 1.6 1", "0 1; 1 2")
      .rectangle("band", 0.1, 0.05, {2e6, 900, 0.3})
      .add("Sections/band", section)
      .add("Supports/base", "Joints = 0 | " + base)
      .mass("tip", "2", 2, 0.05)
      .mesh(2)
      .set("Newton/Tolerance", 1e-14)
      .add("Time", scheme.steps(dt, end))
      .add(further);
  }

  const std::string
    held   = "Type = clamp",
    moving = "Type = prescribed | Displacement x = 0.02 * sin(5 * t)^3 | "
             "Displacement y = 0.03 * t | "
             "Rotation z = 0.05 * (1 - cos(4 * t))",
    stiffness_damping = "Stiffness-proportional damping = 0.01",
    mass_damping      = "Mass-proportional damping = 0.7";

  const SceneText pushed = SceneText().add(
    "Loads/push",
    "Joints = 2 | Force x = 8 * sin(9 * t) | Moment z = 1.5 * t");

  SceneText connector(const std::string &law)
  {
    return SceneText().add("Connectors/link",
                           "Between = ground: 2 | Ground offset = 1 -0.5 | " +
                             law);
  }

  /** Parts of a scene beside the frame. */
  struct Feature
  {
    std::string name, section, base;
    SceneText   further;
  };

  std::vector<Feature> features()
  {
    const std::string spring = "Spring stiffness = 90",
                      damper = "Damping coefficient = 4",
                      rest   = "Long-time stiffness = 30";
    return {{"load", "", held, pushed},
            {"load that jumps",
             "",
             held,
             SceneText().add("Loads/push",
                             "Joints = 2 | Force x = if(t < 0.51, 3, -8)")},
            {"damping by stiffness", stiffness_damping, held, pushed},
            {"damping by mass", mass_damping, held, pushed},
            {"moving support", "", moving, pushed},
            {"moving support, damped",
             stiffness_damping + " | " + mass_damping,
             moving,
             pushed},
            {"spring", "", held, connector("Law = spring | " + spring)},
            {"dashpot", "", held, connector("Law = dashpot | " + damper)},
            {"kelvin-voigt",
             "",
             held,
             connector("Law = kelvin-voigt | " + spring + " | " + damper)},
            {"maxwell",
             "",
             held,
             connector("Law = maxwell | " + spring + " | " + damper)},
            {"standard-linear-solid",
             "",
             held,
             connector("Law = standard-linear-solid | " + rest + " | " +
                       spring + " | " + damper)},
            {"generalized-maxwell",
             "",
             moving,
             connector(
               "Law = generalized-maxwell | " + rest +
               " | Stiffnesses = 50, 80 | Relaxation times = 0.02, 3")}};
  }

  /** Largest error of the balance over the largest amount in the ledger. */
  double relative_error(SceneRun &run)
  {
    double error = 0, largest = 0;
    run.run([&] {
      error = std::max(error, std::abs(run.balance()));
      for (const double amount : run.state.energies.amounts())
        largest = std::max(largest, std::abs(amount));
    });
    return error / largest;
  }
} // namespace

TEST(NumericalEnergy, LinearScenesBalanceToRoundOff)
{
  ComparisonTable table("Linear frame, 60 steps, largest error of the balance "
                        "over the largest energy, of all features");
  for (const Scheme &scheme : all_schemes())
    {
      double largest = 0;
      for (const Feature &feature : features())
        {
          const bool is_pushed =
            feature.further.str().find("Loads") != std::string::npos;
          SceneRun run(
            frame_scene(scheme,
                        0.02,
                        1.2,
                        feature.section,
                        feature.base,
                        feature.further + (is_pushed ? SceneText() : pushed)),
            {"Effects/Large rotation=off", "Time/Largest energy error=1e30"});
          const double error = relative_error(run);
          // Round-off of 60 steps, in each of which forces of stiff strains
          // are multiplied by small increments.
          EXPECT_LT(error, 1e-13) << scheme.name << ", " << feature.name;
          largest = std::max(largest, error);
        }
      table.row(scheme.name, largest, 0, 1e-13);
    }
}

// The energy identity of the alpha family, from the motion of one mass.
TEST(NumericalEnergy, IsThatOfTheIdentityOfTheScheme)
{
  struct Member
  {
    Scheme                    scheme;
    AlphaFamily::Coefficients c;
  };
  const double              m = 2, dt = 0.4;
  const std::vector<Member> members = {
    {newmark(), AlphaFamily::newmark(0.25, 0.5)},
    {newmark_of("0.3025", "0.6"), AlphaFamily::newmark(0.3025, 0.6)},
    {hht("-0.1"), AlphaFamily::hht(-0.1)},
    {generalized_alpha("0.8"), AlphaFamily::generalized_alpha(0.8)},
    {generalized_alpha("0"), AlphaFamily::generalized_alpha(0)}};
  ComparisonTable table("Energy taken from one mass by the scheme, 50 steps");
  for (const Member &member : members)
    {
      SceneRun  run(one_mass_scene("Law = spring | Spring stiffness = 3",
                                  member.scheme.steps(dt, 50 * dt),
                                  mass_and_velocity(m, 1)));
      const int i     = run.model.numbering.joint_unknown(0, 0);
      double    taken = 0;
      struct Motion
      {
        double u, v, a, force;
      };
      const auto motion = [&]() -> Motion {
        const State &s = run.state;
        return {s.displacement[i],
                (*s.velocity)[i],
                s.algorithmic_acceleration ? (*s.algorithmic_acceleration)[i]
                                           : (*s.acceleration)[i],
                -3 * s.displacement[i]};
      };
      Motion before = motion();
      run.run([&] {
        const Motion                     now = motion();
        const AlphaFamily::Coefficients &c   = member.c;
        const double du = now.u - before.u, da = now.a - before.a,
                     df = now.force - before.force;
        taken += -(0.5 - c.alpha_f) * du * df -
          (c.gamma - 1 + c.alpha_m) * m * du * da +
          dt * dt * (c.beta - c.gamma / 2) * m *
            ((now.a * now.a - before.a * before.a) / 2 +
             (c.gamma - 0.5) * da * da);
        before = now;
      });
      table.row(member.scheme.name,
                run.state.energies.numerical(),
                taken,
                1e-12);
      EXPECT_NEAR(run.initial_balance - run.state.energies.total(),
                  taken,
                  1e-12);
    }
}

// The support of a damped beam starts with a speed: the scheme's velocities
// ring, the strains hardly.
TEST(NumericalEnergy, ADampedBeamOnASupportThatStartsWithASpeed)
{
  const auto run_of = [](const Scheme &scheme, const double dt) {
    SceneRun run(SceneText()
                   .frame("0 0; 1 0", "0 1")
                   .rectangle("bar", "20 mm", "10 mm", {"70 GPa", 2700})
                   .set("Sections/bar/Stiffness-proportional damping", "50 us")
                   .add("Supports/base",
                        "Joints = 0 | Type = prescribed | Displacement x = 0 | "
                        "Displacement y = 0.5*t | Rotation z = 0")
                   .add("Time", scheme.steps(dt, 0.05)),
                 {"Time/Largest energy error=1e30"});
    run.run();
    return run.state.energies;
  };
  const double    reference = run_of(energy_momentum, 5e-6).dissipated();
  ComparisonTable table("Lost by the beam by 50 ms (J), steps of 100 us");
  for (const Scheme &scheme : {newmark(), energy_momentum})
    {
      const Energies energies = run_of(scheme, 1e-4);
      table.relative(scheme.name, energies.dissipated(), reference, 1e-3);
      EXPECT_NEAR(energies.numerical(), 0, 1e-6 * reference);
    }
  // From the acceleration at the start, which is that of the damping force of a
  // velocity that jumps, these schemes make displacements: they give the energy
  // that is lost with them.
  for (const Scheme &scheme : {hht("-0.05"), generalized_alpha("0.8")})
    {
      const Energies energies = run_of(scheme, 1e-4);
      EXPECT_LT(energies.numerical(), 0);
      table.relative(scheme.name + ", with numerical",
                     energies.dissipated() + energies.numerical(),
                     reference,
                     1e-3);
    }
  // The power of damping at the stages is far from its mean, the motion is not.
  for (const std::string order : {"3", "4", "5"})
    {
      const std::string name = "esdirk of order " + order;
      const Energies    energies =
        run_of({name, "Scheme = esdirk | Order of esdirk = " + order}, 1e-4);
      EXPECT_GT(std::abs(energies.numerical()), 0.1 * reference) << name;
      EXPECT_NEAR(energies.balance(0.), 0, 1e-3 * reference) << name;
      table.relative(name + ", with numerical",
                     energies.dissipated() + energies.numerical(),
                     reference,
                     1e-3);
    }
}

TEST(NumericalEnergy, AtLargeRotationsTheBalanceIsOfSecondOrder)
{
  const auto error_of = [](const Scheme &scheme, const double dt) {
    SceneRun run(
      frame_scene(scheme,
                  dt,
                  1,
                  stiffness_damping + " | " + mass_damping,
                  "Type = prescribed | Displacement x = 0.1 * sin(3 * t)^3 | "
                  "Displacement y = 0 | Rotation z = 0.8 * sin(2 * t)^3")
        .add(
          connector("Law = standard-linear-solid | Long-time stiffness = 30 | "
                    "Spring stiffness = 90 | Damping coefficient = 4"))
        .add("Loads/push", "Joints = 2 | Force y = -60 * sin(3 * t)^3"));
    double error = 0, turned = 0;
    run.run([&] {
      error  = std::max(error, std::abs(run.balance()));
      turned = std::max(turned, std::abs(run.motion(2, rotation_z)));
    });
    EXPECT_GT(turned, 0.5);
    return error / run.state.largest_energy;
  };
  ComparisonTable table("Order of the balance, frame at large rotations");
  for (const Scheme &scheme :
       {newmark(), hht("-0.05"), generalized_alpha("0.8")})
    {
      const double coarse = error_of(scheme, 5e-3),
                   fine   = error_of(scheme, 2.5e-3);
      std::cout << scheme.name << ": " << coarse << ", " << fine << '\n';
      EXPECT_GT(coarse, 1e-9)
        << "a nonlinear scene is not closed by definition";
      table.row(scheme.name, std::log2(coarse / fine), 2, 0.2);
    }
}

TEST(NumericalEnergy, OfAnElasticStaticPathTheBalanceIsOfThirdOrder)
{
  const auto error_of = [](const double dt) {
    SceneRun run(
      frame_scene(in_statics,
                  dt,
                  1,
                  "",
                  "Type = prescribed | Displacement x = 0.1 * t^2 | "
                  "Displacement y = 0 | Rotation z = 0.3 * t")
        .add("Loads/push",
             "Joints = 2 | Force x = 4 * sin(3 * t) | Moment z = 1.5 * t"));
    return relative_error(run);
  };
  const double coarse = error_of(0.0125), fine = error_of(0.00625);
  EXPECT_LT(coarse, 1e-2);
  ComparisonTable table(
    "Order of the balance of a static path, steps of 0.0125 "
    "and 0.00625");
  table.row("frame", std::log2(coarse / fine), 3, 0.2);
}
