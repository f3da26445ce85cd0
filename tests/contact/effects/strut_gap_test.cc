#include <auxfem/contact/effects/strut_gap.h>
#include <auxfem/mathematics/rotation.h>

#include <contact/effects/sampled_distance.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <algorithm>
#include <random>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Axes of a frame of struts 0.1 thick, one element each; on one rank. */
  struct Axes
  {
    Axes(const unsigned int dimension,
         const std::string &joints,
         const std::string &struts,
         const unsigned int refinements = 0)
      : setup(SceneText()
                .dimension(dimension)
                .frame(joints, struts)
                .rectangle("bar", thickness, thickness, {1, 1, 0})
                .mesh(3, refinements)
                .str(),
              {},
              MPI_COMM_SELF)
      , list(make_contact_axes(setup.model, 1))
      , curves(setup.model, list)
      , gap(curves)
    {}

    std::vector<double> rest() const
    {
      return std::vector<double>(setup.dofs().layout().n_global(), 0.);
    }

    std::array<AxisCurve, 2> at(const std::vector<double> &u) const
    {
      return {{curve(0, u), curve(1, u)}};
    }

    AxisCurve curve(const unsigned int axis, const std::vector<double> &u) const
    {
      return curves.curve(axis, list[axis].unknowns.data(), u.data());
    }

    /** Moves the nodes of an axis at random by up to @p size. */
    template <class Generator>
    void bend(const unsigned int   axis,
              const double         size,
              Generator           &generator,
              std::vector<double> &u) const
    {
      for (const int unknown : list[axis].unknowns)
        u[unknown] +=
          std::uniform_real_distribution<double>(-size, size)(generator);
    }

    void move(const unsigned int   axis,
              const SpaceVector   &way,
              std::vector<double> &u) const
    {
      const unsigned int dimension = setup.lattice.dimension;
      for (std::size_t i = 0; i < list[axis].unknowns.size(); ++i)
        u[list[axis].unknowns[i]] += way[i % dimension];
    }

    /** Gap of the ranges that may touch (m), by dense sampling. */
    double sampled_gap(const std::array<AxisCurve, 2> &now) const
    {
      double least = 1e9;
      for (unsigned int one = 0; one < 2; ++one)
        for (const auto &range : curves.free_ranges(one, 1 - one))
          least = sampled_distance(60, now[one], range, now[1 - one], least);
      return least - thickness;
    }

    static constexpr double   thickness = 0.1;
    static constexpr AxisPair pair      = {{0, 1}};
    EquationsOnRanks          setup;
    std::vector<ContactAxis>  list;
    StrutCurves               curves;
    StrutGap                  gap;
  };

  /** Displacements at a fraction of the path. */
  std::vector<double> on_the_way(const std::vector<double> &from,
                                 const std::vector<double> &to,
                                 const double               part)
  {
    std::vector<double> u = from;
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += part * (to[i] - from[i]);
    return u;
  }

  /** Two crossing struts, apart by twice their thickness. */
  Axes crossing_axes(const unsigned int dimension)
  {
    return dimension == 3
      ? Axes(3, "-1 0 0.2; 1 0 0.2; 0 -1 0; 0 1 0", "0 1; 2 3")
      : Axes(2, "-1 0.2; 1 0.2; -0.8 0; 1.2 0", "0 1; 2 3");
  }
} // namespace

TEST(StrutGap, StraightPathsThroughEachOtherAreDetected)
{
  // Paths as long as the bound of the search.
  for (const unsigned int dimension : {2u, 3u})
    for (const double way : {0.21, 0.3, 0.4, 0.5, 0.7, 1., 3., 30.})
      {
        SCOPED_TRACE(way);
        const Axes          axes = crossing_axes(dimension);
        std::vector<double> to   = axes.rest();
        SpaceVector         down;
        down[dimension - 1] = -way / 2;
        axes.move(0, down, to);
        axes.move(1, -down, to);
        for (const double least : {0., -0.05})
          EXPECT_TRUE(axes.gap.falls_below(Axes::pair,
                                           axes.at(axes.rest()),
                                           axes.at(to),
                                           least));
        // Vertical and lateral motions.
        EXPECT_FALSE(
          axes.gap.falls_below(Axes::pair, axes.at(to), axes.at(to), -10));
        std::vector<double> away = axes.rest();
        axes.move(1, down, away);
        EXPECT_FALSE(axes.gap.falls_below(Axes::pair,
                                          axes.at(axes.rest()),
                                          axes.at(away),
                                          0));
      }
}

TEST(StrutGap, FallsBelowDetectsContactWithinAStep)
{
  constexpr double thickness = Axes::thickness;
  std::mt19937     generator(5);
  for (const unsigned int dimension : {2u, 3u})
    {
      const Axes   axes      = crossing_axes(dimension);
      unsigned int n_through = 0, n_past = 0;
      for (unsigned int i = 0; i < 100; ++i)
        {
          std::vector<double> from = axes.rest(), to;
          for (const unsigned int axis : {0u, 1u})
            axes.bend(axis, 0.02, generator, from);
          to = from;
          SpaceVector way;
          for (unsigned int c = 0; c < dimension; ++c)
            way[c] =
              std::uniform_real_distribution<double>(-0.8, 0.8)(generator);
          axes.move(0, way, to);
          for (const unsigned int axis : {0u, 1u})
            axes.bend(axis, 0.1, generator, to);
          const auto   begin = axes.at(from), end = axes.at(to);
          const double least = least_value(
            200,
            longest_way(begin[0], end[0]) + longest_way(begin[1], end[1]),
            [&](const double part) {
              return axes.sampled_gap(axes.at(on_the_way(from, to, part)));
            },
            1e9);
          const bool found = axes.gap.falls_below(Axes::pair, begin, end, 0);
          // The tolerance is a twentieth of the thickness in both directions.
          if (least < -0.06 * thickness)
            {
              ++n_through;
              EXPECT_TRUE(found) << "gap " << least;
            }
          else if (least > 0.06 * thickness)
            {
              ++n_past;
              EXPECT_FALSE(found) << "gap " << least;
            }
        }
      EXPECT_GT(n_through, 10u);
      EXPECT_GT(n_past, 10u);
    }
}

TEST(StrutGap, RotationsWithinTheMarginCauseNoContact)
{
  std::mt19937 generator(7);
  const auto   number = [&](const double low, const double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  for (const unsigned int dimension : {2u, 3u})
    for (unsigned int i = 0; i < 200; ++i)
      {
        // Two struts of different length at an angle.
        const double      angle = number(0.3, 3), length = number(0.7, 1.5);
        const std::string z = dimension == 3 ? " 0" : "";
        const Axes        axes(dimension,
                        "0 0" + z + "; 1 0" + z + "; " +
                          text(length * std::cos(angle)) + " " +
                          text(length * std::sin(angle)) + z,
                        "0 1; 0 2");
        const double      least = number(0, 0.2);
        const auto        now   = axes.at(axes.rest());
        const double      left =
          axes.gap.rotation_margin(Axes::pair, now[0], now[1], least);
        if (axes.sampled_gap(now) > 0.5 * Axes::thickness)
          {
            EXPECT_GT(left, 0.01);
          }
        // Directly towards each other, then at random.
        std::vector<double> closed = axes.rest(), bent = axes.rest();
        for (const unsigned int axis : {0u, 1u})
          {
            const std::vector<int> &unknowns = axes.list[axis].unknowns;
            const double            sign     = axis == 0 ? left : -left;
            for (std::size_t k = 0; k < unknowns.size(); k += dimension)
              {
                const unsigned int node = k / dimension;
                // The end nodes are the first ones.
                const double      at    = node == 0 ? 0.
                          : node == 1               ? 1.
                          : node == 2               ? 0.276393202250021
                                                    : 0.723606797749979;
                const SpaceVector arm   = axes.curve(axis, axes.rest()).at(at);
                closed[unknowns[k]]     = -sign * arm[1];
                closed[unknowns[k + 1]] = sign * arm[0];
              }
            axes.bend(axis, 1, generator, bent);
            for (unsigned int c = 0; c < dimension; ++c)
              bent[unknowns[c]] = 0;
            std::vector<double> motion;
            for (const int unknown : unknowns)
              motion.push_back(bent[unknown]);
            const double turned =
              axes.curves.axis_rotation(axis, motion.data());
            for (const int unknown : unknowns)
              if (bent[unknown] != 0)
                bent[unknown] *= left / turned;
          }
        for (const auto &u : {closed, bent})
          EXPECT_GE(axes.sampled_gap(axes.at(u)),
                    std::min(least * Axes::thickness, axes.sampled_gap(now)) -
                      1e-12)
            << "by " << left << " rad of " << angle;
      }
}
