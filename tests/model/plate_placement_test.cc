#include <auxfem/model/build_lattice.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A beam of 1 m along x, 20 mm high, under a body. */
  SceneText beam_under(const std::string &plate)
  {
    return frame_scene("0 0; 1 0", "0 1")
      .rectangle("bar", "10 mm", "20 mm", {1, 1})
      .add("Plates/body", plate);
  }

  dealii::Point<3> placed(const SceneText &scene)
  {
    return build_lattice(read_scene_from_text(scene.str(), "test.prm"))
      .joints.back();
  }
} // namespace

TEST(PlatePlacement, PlanesComeAlongTheirNormal)
{
  const std::string plate = "Position = 0.3 5 | Normal = 0 -1";
  EXPECT_EQ(placed(beam_under(plate)), dealii::Point<3>(0.3, 5, 0));
  for (const auto &[gap, y] :
       std::vector<std::pair<std::string, double>>{{"0", 0.01},
                                                   {"5 mm", 0.015}})
    EXPECT_LT(placed(beam_under(plate + " | Gap = " + gap))
                .distance(dealii::Point<3>(0.3, y, 0)),
              1e-12);
  // From within the lattice, too.
  EXPECT_LT(placed(beam_under("Position = 0 -2 | Normal = 0 -1 | Gap = 0"))
              .distance(dealii::Point<3>(0, 0.01, 0)),
            1e-12);
}

TEST(PlatePlacement, BallsComeToTheNearestStrut)
{
  const std::string ball = "Shape = sphere | Radius = 0.5 | Gap = 0 | ";
  EXPECT_LT(placed(beam_under(ball + "Position = 0.3 5"))
              .distance(dealii::Point<3>(0.3, 0.51, 0)),
            1e-6);
  // Beside the beam they come to its end.
  const dealii::Point<3> beside = placed(beam_under(ball + "Position = 4 4"));
  EXPECT_NEAR(beside.distance(dealii::Point<3>(1, 0, 0)), 0.51, 1e-12);
  EXPECT_NEAR(beside[0] - 1, 0.51 * 3 / 5, 1e-12);
}

TEST(PlatePlacement, ImperfectLatticesAreTouched)
{
  const SceneText scene =
    beam_under("Position = 0 5 | Normal = 0 -1 | Gap = 0")
      .add("Imperfections/dent",
           "Type = expression | Displacement y = 0.1 * x");
  EXPECT_NEAR(placed(scene)[1], 0.11, 1e-12);
}
