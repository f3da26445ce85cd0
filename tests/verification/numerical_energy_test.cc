#include <auxfem/time/alpha_family.h>

#include <support/energy_amount.h>
#include <support/scene_run.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// What time schemes take from the motion beside what damping takes, and whether
// the ledger closes with it.

namespace
{
  Scheme newmark_of(const std::string &beta, const std::string &gamma)
  {
    return {"Newmark " + beta + ", " + gamma,
            "  set Scheme = newmark\n  set Newmark beta = " + beta +
              "\n  set Newmark gamma = " + gamma + "\n"};
  }

  const Scheme energy_momentum = {"energy-momentum",
                                  "  set Scheme = energy-momentum\n"},
               in_statics      = {"static", "  set Scheme = static\n"};

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
  std::string frame_scene(const Scheme      &scheme,
                          const double       dt,
                          const double       end,
                          const std::string &section,
                          const std::string &base,
                          const std::string &further)
  {
    return R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 1 0.2; 1.6 1
  set Struts = 0 1; 1 2
end
subsection Sections
  subsection band
    set Shape           = rectangle
    set Width           = 0.1
    set Height          = 0.05
    set Young's modulus = 2e6
    set Poisson's ratio = 0.3
    set Density         = 900
)" + section +
      R"(
  end
end
subsection Supports
  subsection base
    set Joints = 0
)" + base +
      R"(
  end
end
subsection Masses
  subsection tip
    set Joints = 2
    set Mass   = 2
    set Rotary inertia = 0.05
  end
end
subsection Discretization
  set Order = 2
end
subsection Newton
  set Tolerance = 1e-14
end
subsection Time
)" + scheme.steps(dt, end) +
      "end\n" + further;
  }

  const std::string held   = "    set Type = clamp\n",
                    moving = "    set Type = prescribed\n"
                             "    set Displacement x = 0.02 * sin(5 * t)^3\n"
                             "    set Displacement y = 0.03 * t\n"
                             "    set Rotation z = 0.05 * (1 - cos(4 * t))\n",
                    pushed = R"(
subsection Loads
  subsection push
    set Joints   = 2
    set Force x  = 8 * sin(9 * t)
    set Moment z = 1.5 * t
  end
end
)",
                    stiffness_damping =
                      "    set Stiffness-proportional damping = 0.01\n",
                    mass_damping = "    set Mass-proportional damping = 0.7\n";

  std::string connector(const std::string &law)
  {
    return "subsection Connectors\n  subsection link\n"
           "    set Between = ground: 2\n    set Ground offset = 1 -0.5\n" +
      law + "  end\nend\n";
  }

  /** What a scene has beside the frame. */
  struct Feature
  {
    std::string name, section, base, further;
  };

  std::vector<Feature> features()
  {
    const std::string spring = "    set Spring stiffness = 90\n",
                      damper = "    set Damping coefficient = 4\n",
                      rest   = "    set Long-time stiffness = 30\n";
    return {
      {"load", "", held, pushed},
      {"load that jumps",
       "",
       held,
       R"(
subsection Loads
  subsection push
    set Joints  = 2
    set Force x = if(t < 0.51, 3, -8)
  end
end
)"},
      {"damping by stiffness", stiffness_damping, held, pushed},
      {"damping by mass", mass_damping, held, pushed},
      {"moving support", "", moving, pushed},
      {"moving support, damped",
       stiffness_damping + mass_damping,
       moving,
       pushed},
      {"spring", "", held, connector("    set Law = spring\n" + spring)},
      {"dashpot", "", held, connector("    set Law = dashpot\n" + damper)},
      {"kelvin-voigt",
       "",
       held,
       connector("    set Law = kelvin-voigt\n" + spring + damper)},
      {"maxwell",
       "",
       held,
       connector("    set Law = maxwell\n" + spring + damper)},
      {"standard-linear-solid",
       "",
       held,
       connector("    set Law = standard-linear-solid\n" + rest + spring +
                 damper)},
      {"generalized-maxwell",
       "",
       moving,
       connector("    set Law = generalized-maxwell\n" + rest +
                 "    set Stiffnesses = 50, 80\n"
                 "    set Relaxation times = 0.02, 3\n")}};
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
            feature.further.find("Loads") != std::string::npos;
          SceneRun     run(frame_scene(scheme,
                                   0.02,
                                   1.2,
                                   feature.section,
                                   feature.base,
                                   feature.further + (is_pushed ? "" : pushed)),
                       {"Effects/Large rotation=off",
                            "Time/Largest energy error=1e30"});
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
      SceneRun run(
        one_mass_scene("    set Law = spring\n    set Spring stiffness = 3",
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
    SceneRun run(R"(
subsection Lattice
  set Cell = frame
  set Joints = 0 0; 1 0
  set Struts = 0 1
end
subsection Sections
  subsection bar
    set Shape = rectangle
    set Width = 20 mm
    set Height = 10 mm
    set Young's modulus = 70 GPa
    set Density = 2700
    set Stiffness-proportional damping = 50 us
  end
end
subsection Supports
  subsection base
    set Joints = 0
    set Type = prescribed
    set Displacement x = 0
    set Displacement y = 0.5*t
    set Rotation z = 0
  end
end
subsection Time
)" + scheme.steps(dt, 0.05) +
                   "end\n",
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
}

TEST(NumericalEnergy, AtLargeRotationsTheBalanceIsOfSecondOrder)
{
  const auto error_of = [](const Scheme &scheme, const double dt) {
    SceneRun run(frame_scene(scheme,
                             dt,
                             1,
                             stiffness_damping + mass_damping,
                             "    set Type = prescribed\n"
                             "    set Displacement x = 0.1 * sin(3 * t)^3\n"
                             "    set Displacement y = 0\n"
                             "    set Rotation z = 0.8 * sin(2 * t)^3\n",
                             R"(
subsection Connectors
  subsection link
    set Between = ground: 2
    set Ground offset = 1 -0.5
    set Law = standard-linear-solid
    set Long-time stiffness = 30
    set Spring stiffness = 90
    set Damping coefficient = 4
  end
end
subsection Loads
  subsection push
    set Joints  = 2
    set Force y = -60 * sin(3 * t)^3
  end
end
)"));
    double   error = 0, turned = 0;
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
    SceneRun run(frame_scene(in_statics,
                             dt,
                             1,
                             "",
                             "    set Type = prescribed\n"
                             "    set Displacement x = 0.1 * t^2\n"
                             "    set Displacement y = 0\n"
                             "    set Rotation z = 0.3 * t\n",
                             R"(
subsection Loads
  subsection push
    set Joints   = 2
    set Force x  = 4 * sin(3 * t)
    set Moment z = 1.5 * t
  end
end
)"));
    return relative_error(run);
  };
  const double coarse = error_of(0.0125), fine = error_of(0.00625);
  EXPECT_LT(coarse, 1e-2);
  ComparisonTable table(
    "Order of the balance of a static path, steps of 0.0125 "
    "and 0.00625");
  table.row("frame", std::log2(coarse / fine), 3, 0.2);
}
