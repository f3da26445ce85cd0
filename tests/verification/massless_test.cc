#include <support/scene_run.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Unknowns without mass follow from equilibrium.

namespace
{
  /** A mass of 1 kg at joint 0, thrown with 1 m/s, @p near from it to joint 1,
   * which has no mass, and 300 N/m from there to the ground. */
  std::string series(const std::string &near, const std::string &scheme)
  {
    return R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 1 0; 0 -1; 1 -1
  set Struts = 2 3
end
subsection Sections
  subsection idle
    set Shape           = circle
    set Radius          = 1e-3
    set Young's modulus = 1
    set Density         = 1
  end
end
subsection Supports
  subsection idle
    set Joints = 2, 3
    set Type   = clamp
  end
  subsection guide
    set Joints = 0, 1
    set Type   = roller x
  end
end
subsection Connectors
  subsection near
    set Between = 0 1
)" + near +
      R"(
  end
  subsection far
    set Between          = ground: 1
    set Geometry         = direction
    set Direction        = 1 0
    set Law              = spring
    set Spring stiffness = 300
  end
end
subsection Effects
  set Large rotation = off
end
subsection Newton
  set Tolerance = 1e-13
end
subsection Time
  set Scheme    = )" +
      scheme + R"(
  set End time  = 2
  set Time step = 0.01
end
)" + mass_and_velocity(1, 1);
  }

  const std::string spring_law = "    set Law = spring\n"
                                 "    set Spring stiffness = 100\n";
} // namespace

TEST(Massless, AJointBetweenTwoSpringsIsInEquilibrium)
{
  for (const char *scheme : {"newmark", "hht\n  set HHT alpha = 0"})
    {
      // In series 75 N/m; the same scheme for both.
      SceneRun both(series(spring_law, scheme)),
        one(one_mass_scene("    set Law = spring\n"
                           "    set Spring stiffness = 75\n",
                           std::string("  set Scheme = ") + scheme +
                             "\n  set End time = 2\n  set Time step = 0.01\n",
                           mass_and_velocity(1, 1)));
      for (unsigned int step = 1; step <= 200; ++step)
        {
          both.advance();
          one.advance();
          EXPECT_NEAR(both.motion(0, 0), one.motion(0, 0), 1e-12);
          EXPECT_NEAR(both.motion(1, 0), both.motion(0, 0) / 4, 1e-12);
          // Differences over the last steps, a period being 73 of them.
          if (step > 1)
            {
              EXPECT_NEAR(both.velocity(1, 0), both.velocity(0, 0) / 4, 2e-3);
            }
        }
    }
}

namespace
{
  /** A clamped beam of two struts without density, a mass at the middle joint
   * and a force at the end. */
  std::string massless_beam(const std::string &scheme)
  {
    return R"(
subsection Lattice
  set Cell = frame
  set Joints = 0 0; 1 0; 2 0
  set Struts = 0 1; 1 2
end
subsection Sections
  subsection s
    set Shape = given
    set Area = 0.01
    set Shear area = 0.01
    set Second moment of area = 2e-06
    set Young's modulus = 1e6
    set Poisson's ratio = 0
    set Density = 0
  end
end
subsection Supports
  subsection c
    set Joints = 0
    set Type = clamp
  end
end
subsection Loads
  subsection p
    set Joints = 2
    set Force y = 0.5*min(t,1)
  end
end
subsection Masses
  subsection m
    set Joints = 1
    set Mass = 0.1 kg
  end
end
subsection Discretization
  set Order = 3
  set Global refinements = 2
end
subsection Time
  set Scheme = )" +
      scheme + R"(
  set End time = 2
  set Time step = 0.01
end
)";
  }
} // namespace

TEST(Massless, StrutsWithLargeRotationsMoveWithAFewIterationsAStep)
{
  SceneRun newmark(massless_beam("newmark")),
    damped(massless_beam("generalized-alpha"));
  newmark.run();
  damped.run();
  EXPECT_EQ(newmark.work().retries, 0u);
  EXPECT_LT(newmark.work().iterations, 10 * newmark.work().steps);
  // Both are of second order, 126 steps a period.
  for (unsigned int c = 0; c < 2; ++c)
    EXPECT_NEAR(newmark.motion(2, c), damped.motion(2, c), 5e-3);
  EXPECT_GT(newmark.motion(2, 1), 0.3);
}

TEST(Massless, DashpotsOnMasslessJointsAreRefusedByUndampedSchemes)
{
  const std::string dashpot = "    set Law = dashpot\n"
                              "    set Damping coefficient = 2\n";
  expect_parts(input_error_of(
                 [&] { SceneRun run(series(dashpot, "newmark")); }),
               {"horizontal displacement of joint 1",
                "has no inertia",
                "Masses",
                "Law = maxwell",
                "generalized-alpha"});
  EXPECT_EQ(input_error_of(
              [&] { SceneRun run(series(dashpot, "generalized-alpha")); }),
            "");
}
