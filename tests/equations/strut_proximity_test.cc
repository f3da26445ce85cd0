#include <auxfem/equations/strut_proximity.h>

#include <equations/equations_on_ranks.h>
#include <equations/sampled_distance.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <random>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A star lattice; on one rank, and thin, unless asked for otherwise. */
  struct Stars
  {
    explicit Stars(const MPI_Comm     communicator = MPI_COMM_SELF,
                   const unsigned int n_cells      = 3,
                   const std::string &angle        = "60 deg",
                   const std::string &thickness    = "0.05")
      : of_scene(SceneText()
                   .add("Lattice", "Cell = star | Strut length = 1")
                   .set("Lattice/Opening angle", angle)
                   .set("Lattice/Cells x", n_cells)
                   .set("Lattice/Cells y", n_cells)
                   .rectangle("strip", "1", thickness, {"1", 1, 0})
                   .set("Lattice/Struts may cross", "true")
                   .mesh(2)
                   .str(),
                 {},
                 communicator)
      , axes(make_contact_axes(of_scene.model, 1))
      , curves(of_scene.model, axes)
      , overlaps(find_overlaps(curves, of_scene.model.numbering.layout()))
      , proximity(of_scene.model, curves, overlaps)
    {}

    AxisCurve curve(const unsigned int axis, const std::vector<double> &u) const
    {
      return curves.curve(axis, axes[axis].unknowns.data(), u.data());
    }

    /** Whether two axes touch, by many points of both. */
    bool touch(const AxisPair &pair, const std::vector<double> &u) const
    {
      const double thickness = curves.thickness(pair[0], pair[1]);
      return sampled_distance(30,
                              curve(pair[0], u),
                              {{0., 1.}},
                              curve(pair[1], u),
                              thickness) < thickness;
    }

    EquationsOnRanks                of_scene;
    std::vector<ContactAxis>        axes;
    StrutCurves                     curves;
    const std::vector<StrutOverlap> overlaps;
    StrutProximity                  proximity;
  };
} // namespace

TEST(StrutProximity, AllThatTouchAreNearHoweverTheLatticeMoves)
{
  Stars               stars;
  std::mt19937        generator(3);
  std::vector<double> u(stars.of_scene.dofs().layout().n_global(), 0.),
    velocity(u.size());
  for (double &value : velocity)
    value = std::uniform_real_distribution<double>(-0.03, 0.03)(generator);
  unsigned int n_touching = 0;
  for (unsigned int step = 0; step < 20; ++step)
    {
      stars.proximity.follow(u);
      const auto &near = stars.proximity.near();
      for (unsigned int a = 0; a < stars.axes.size(); ++a)
        for (unsigned int b = a + 1; b < stars.axes.size(); ++b)
          {
            const AxisPair pair{{a, b}};
            if (stars.curves.are_neighbours(a, b) || !stars.touch(pair, u))
              continue;
            ++n_touching;
            EXPECT_TRUE(std::binary_search(near.begin(), near.end(), pair))
              << "step " << step << ", axes " << a << " and " << b;
          }
      for (std::size_t i = 0; i < u.size(); ++i)
        u[i] += velocity[i];
    }
  EXPECT_GT(n_touching, 20u);
}

TEST(StrutProximity, WhatPassesThroughInOneStepIsSeen)
{
  Stars                     stars;
  const std::vector<double> rest(stars.of_scene.dofs().layout().n_global(), 0.);
  stars.proximity.follow(rest);
  EXPECT_TRUE(stars.proximity.near().empty());
  EXPECT_FALSE(stars.proximity.first_too_near(rest, rest, 0.5));
  // All moves on far; nothing comes nearer to anything.
  std::vector<double> moved = rest;
  for (const ContactAxis &axis : stars.axes)
    for (std::size_t i = 0; i < axis.unknowns.size(); i += 2)
      moved[axis.unknowns[i]] = 50;
  EXPECT_FALSE(stars.proximity.first_too_near(rest, moved, 0.5));
  // One strut alone goes through the others, to the other side of them.
  std::vector<double> thrown = rest;
  const ContactAxis  &axis   = stars.axes.front();
  for (std::size_t i = 0; i < axis.unknowns.size(); i += 2)
    thrown[axis.unknowns[i]] = 50;
  EXPECT_TRUE(stars.proximity.first_too_near(rest, thrown, 0.5));
}

TEST(StrutProximityOnRanks, SharedLooksFindWhatOneRankFinds)
{
  // So flat and thick that struts overlap at rest.
  Stars shared(MPI_COMM_WORLD, 8, "50 deg", "0.2"),
    alone(MPI_COMM_SELF, 8, "50 deg", "0.2");
  ASSERT_GT(alone.curves.connected().size(), 1000u);
  EXPECT_FALSE(alone.overlaps.empty());
  ASSERT_EQ(shared.overlaps.size(), alone.overlaps.size());
  for (std::size_t i = 0; i < alone.overlaps.size(); ++i)
    {
      const StrutOverlap &one = shared.overlaps[i], &two = alone.overlaps[i];
      EXPECT_EQ(one.struts, two.struts);
      EXPECT_EQ(one.is_passing, two.is_passing);
    }
  for (const double size : {0., 0.05, 0.2})
    {
      for (Stars *stars : {&shared, &alone})
        {
          // The same of each axis on any number of ranks.
          std::mt19937        generator(5);
          std::vector<double> u(stars->of_scene.dofs().layout().n_global(), 0.);
          for (const ContactAxis &axis : stars->axes)
            for (const int number : axis.unknowns)
              u[number] =
                std::uniform_real_distribution<double>(-size, size)(generator);
          stars->proximity.follow(u);
        }
      EXPECT_EQ(shared.proximity.near(), alone.proximity.near());
      EXPECT_EQ(shared.proximity.may_touch(), alone.proximity.may_touch());
    }
  EXPECT_GT(alone.proximity.near().size(), 20u);
}
