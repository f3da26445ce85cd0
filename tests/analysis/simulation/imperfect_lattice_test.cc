#include <auxfem/analysis/simulation/imperfect_lattice.h>

#include <gtest/gtest.h>
#include <support/followed_path.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A pinned column of 1 m and four struts under half of Euler's load pi^2. */
  SceneText pinned_column()
  {
    return static_frame("0 0; 0.25 0; 0.5 0; 0.75 0; 1 0", "0 1; 1 2; 2 3; 3 4")
      .section({1e5, 1e5, 1})
      .support("hinge", "0", "pin")
      .support("roller", "4", "roller x")
      .load("press", "4", {text(-pi * pi / 2) + " * t", "0", "0"})
      .mesh(3)
      .time(1, 1);
  }

  SceneText bent_by_mode(const double amplitude)
  {
    SceneText scene = pinned_column();
    scene.set("Imperfections/bow/Type", "buckling mode");
    return scene.set("Imperfections/bow/Amplitude", amplitude);
  }

  Lattice imperfect_one(const SceneText &scene,
                        const MPI_Comm   communicator = MPI_COMM_SELF)
  {
    return imperfect_lattice(read_scene_from_text(scene.str(), "test.prm"),
                             communicator);
  }

  double middle_deflection(const SceneText &scene)
  {
    return FollowedPath(scene.str(), {"Path/Resolution=0.005"})
      .points.back()
      .motions[2][1];
  }
} // namespace

TEST(ImperfectLattice, AColumnHasTheShapeOfItsMode)
{
  const double  amplitude = -2e-3;
  const Lattice lattice   = imperfect_one(bent_by_mode(amplitude));
  const double  sign      = lattice.joints[2][1] < 0 ? -1 : 1;
  for (unsigned int i = 0; i < 5; ++i)
    EXPECT_NEAR(lattice.joints[i][1],
                sign * std::abs(amplitude) * std::sin(pi * i / 4),
                1e-8);
  for (unsigned int i = 0; i < 4; ++i)
    {
      dealii::Point<3>     middle;
      dealii::Tensor<1, 3> tangent;
      lattice.axis(lattice.struts[i], 0.5, middle, tangent);
      EXPECT_NEAR(middle[1],
                  sign * std::abs(amplitude) * std::sin(pi * (2. * i + 1) / 8),
                  1e-6);
    }
  // The opposite sign bows to the opposite side.
  EXPECT_NEAR(imperfect_one(bent_by_mode(-amplitude)).joints[2][1],
              -lattice.joints[2][1],
              1e-12);
}

// A bow a sin(pi x) grows by a P / (P_E - P) (e.g. Timoshenko & Gere 1961,
// sec. 1.12), which is a under half of Euler's load.
TEST(ImperfectLattice, ABowGrowsAsThatOfAColumn)
{
  const double amplitude = 1e-4;
  EXPECT_NEAR(std::abs(middle_deflection(bent_by_mode(amplitude))),
              amplitude,
              2e-3 * amplitude);
  SceneText by_expression = pinned_column();
  by_expression.set("Imperfections/bow/Type", "expression");
  by_expression.set("Imperfections/bow/Displacement y",
                    text(amplitude) + " * sin(pi * x)");
  EXPECT_NEAR(middle_deflection(by_expression), amplitude, 2e-3 * amplitude);
  // Two imperfections double the bow.
  SceneText twice = bent_by_mode(amplitude);
  twice.set("Imperfections/more/Type", "buckling mode");
  twice.set("Imperfections/more/Amplitude", amplitude);
  EXPECT_NEAR(std::abs(middle_deflection(twice)),
              2 * amplitude,
              4e-3 * amplitude);
}

TEST(ImperfectLatticeOnRanks, IsTheSame)
{
  const Lattice alone    = imperfect_one(bent_by_mode(1e-3)),
                together = imperfect_one(bent_by_mode(1e-3), MPI_COMM_WORLD);
  for (unsigned int i = 0; i < alone.joints.size(); ++i)
    EXPECT_LT(alone.joints[i].distance(together.joints[i]), 1e-10);
}

TEST(ImperfectLattice, RefusesModesOfAStructureThatCannotBuckle)
{
  const std::string message = input_error_of(
    [] { imperfect_one(bent_by_mode(1e-3).set("Loads/press/Force x", "0")); });
  expect_parts(message, {"Imperfections/bow", "no load", "Time of the loads"});
  EXPECT_FALSE(contains(message, "Analysis"));
}

TEST(ImperfectLattice, RefusesMissingModes)
{
  expect_parts(input_error_of([] {
                 imperfect_one(
                   bent_by_mode(1e-3).set("Imperfections/bow/Mode", 900));
               }),
               {"Imperfections/bow/Mode = 900", "only"});
}
