#include <auxfem/contact/effects/strut_proximity.h>

#include <contact/effects/sampled_distance.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <random>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A star lattice, by default thin and on one rank. */
  struct Stars
  {
    explicit Stars(const MPI_Comm     communicator = MPI_COMM_SELF,
                   const unsigned int n_cells      = 3,
                   const std::string &angle        = "60 deg",
                   const std::string &thickness    = "0.05")
      : setup(SceneText()
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
      , axes(make_contact_axes(setup.model, 1))
      , curves(setup.model, axes)
      , proximity(setup.model, curves)
    {}

    AxisCurve curve(const unsigned int axis, const std::vector<double> &u) const
    {
      return curves.curve(axis, axes[axis].unknowns.data(), u.data());
    }

    /** Whether two axes touch, by dense sampling. */
    bool touch(const AxisPair &pair, const std::vector<double> &u) const
    {
      const double thickness = curves.thickness(pair[0], pair[1]);
      return sampled_distance(30,
                              curve(pair[0], u),
                              {{0., 1.}},
                              curve(pair[1], u),
                              thickness) < thickness;
    }

    EquationsOnRanks         setup;
    std::vector<ContactAxis> axes;
    StrutCurves              curves;
    StrutProximity           proximity;
  };
} // namespace

TEST(StrutProximity, TouchingPairsAreNearForAnyMotion)
{
  Stars               stars;
  std::mt19937        generator(3);
  std::vector<double> u(stars.setup.dofs().layout().n_global(), 0.),
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

TEST(StrutProximity, StrutsThatPassEachOtherAtRestAreNeverNear)
{
  for (const bool pass : {true, false})
    {
      const EquationsOnRanks         setup(SceneText()
                                     .frame(std::string(
                                              "0 0; 1 0; 0.5 0.5; 0.5 ") +
                                              (pass ? "-0.5" : "0.018"),
                                            "0 1; 2 3")
                                     .set("Lattice/Struts may cross", "true")
                                     .rectangle("strip", 0.02, 0.02, {1, 1, 0})
                                     .mesh(2),
                                   {},
                                   MPI_COMM_SELF);
      const std::vector<ContactAxis> axes = make_contact_axes(setup.model, 1);
      const StrutCurves              curves(setup.model, axes);
      StrutProximity                 proximity(setup.model, curves);
      ASSERT_EQ(proximity.overlaps().size(), 1u);
      EXPECT_EQ(proximity.overlaps()[0].is_passing, pass);
      std::vector<double> u(setup.dofs().layout().n_global(), 0.);
      // Among the first candidates, and after a rebuild of the list.
      for (const double moved : {0., 0.01, 1.})
        {
          for (const ContactAxis &axis : axes)
            for (std::size_t i = 0; i < axis.unknowns.size(); i += 2)
              u[axis.unknowns[i]] = moved;
          proximity.follow(u);
          EXPECT_EQ(proximity.near().size(), pass ? 0u : 1u);
        }
    }
}

TEST(StrutProximity, AStrutThatPassesThroughInOneStepIsDetected)
{
  Stars                     stars;
  const std::vector<double> rest(stars.setup.dofs().layout().n_global(), 0.);
  stars.proximity.follow(rest);
  EXPECT_TRUE(stars.proximity.near().empty());
  EXPECT_FALSE(stars.proximity.first_excessive_approach(rest, rest, 0.5));
  // A large rigid motion changes no distance.
  std::vector<double> moved = rest;
  for (const ContactAxis &axis : stars.axes)
    for (std::size_t i = 0; i < axis.unknowns.size(); i += 2)
      moved[axis.unknowns[i]] = 50;
  EXPECT_FALSE(stars.proximity.first_excessive_approach(rest, moved, 0.5));
  // One strut passes through the others.
  std::vector<double> thrown = rest;
  const ContactAxis  &axis   = stars.axes.front();
  for (std::size_t i = 0; i < axis.unknowns.size(); i += 2)
    thrown[axis.unknowns[i]] = 50;
  EXPECT_TRUE(stars.proximity.first_excessive_approach(rest, thrown, 0.5));
}

TEST(StrutProximityOnRanks, SharedChecksMatchOneRank)
{
  // The cells are so flat and thick that struts overlap at rest.
  Stars shared(MPI_COMM_WORLD, 8, "50 deg", "0.2"),
    alone(MPI_COMM_SELF, 8, "50 deg", "0.2");
  ASSERT_GT(alone.curves.connected().size(), 1000u);
  const std::vector<StrutOverlap> &overlaps_on_ranks =
                                    shared.proximity.overlaps(),
                                  &overlaps_alone = alone.proximity.overlaps();
  EXPECT_FALSE(overlaps_alone.empty());
  ASSERT_EQ(overlaps_on_ranks.size(), overlaps_alone.size());
  for (std::size_t i = 0; i < overlaps_alone.size(); ++i)
    {
      const StrutOverlap &one = overlaps_on_ranks[i], &two = overlaps_alone[i];
      EXPECT_EQ(one.struts, two.struts);
      EXPECT_EQ(one.is_passing, two.is_passing);
    }
  for (const double size : {0., 0.05, 0.2})
    {
      for (Stars *stars : {&shared, &alone})
        {
          // Motion of each axis, equal on any number of ranks.
          std::mt19937        generator(5);
          std::vector<double> u(stars->setup.dofs().layout().n_global(), 0.);
          for (const ContactAxis &axis : stars->axes)
            for (const int number : axis.unknowns)
              u[number] =
                std::uniform_real_distribution<double>(-size, size)(generator);
          stars->proximity.follow(u);
        }
      EXPECT_EQ(shared.proximity.near(), alone.proximity.near());
      EXPECT_EQ(shared.proximity.has_contact_candidates(),
                alone.proximity.has_contact_candidates());
    }
  EXPECT_GT(alone.proximity.near().size(), 20u);
}
