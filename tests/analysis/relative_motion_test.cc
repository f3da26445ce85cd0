#include <auxfem/analysis/relative_motion.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A row of 40 struts of 1 m along x, 4 m to a cell. */
  std::string row_of_struts()
  {
    std::string joints, struts;
    for (unsigned int i = 0; i <= 40; ++i)
      joints += (i > 0 ? "; " : "") + text(i) + " 0";
    for (unsigned int i = 0; i < 40; ++i)
      struts += (i > 0 ? "; " : "") + text(i) + " " + text(i + 1);
    return SceneText()
      .frame(joints, struts)
      .circle("rod", 0.01, {1e9, 1000, 0.3})
      .mesh(1)
      .support("foot", "0", "clamp")
      .time(1, 1, "static")
      .str();
  }

  /** Of all local nodes, by their place at rest: u(x), and v(x) across. */
  template <class Along, class Across>
  Vector
  displacement_of(const LatticeModel &model, const Along &u, const Across &v)
  {
    const DofNumbering &numbering = model.numbering;
    Vector              displacement(numbering.layout().n_local(), 0.);
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      {
        const Strut &strut =
          model.lattice.struts[numbering.elements()[e].interval.strut];
        for (unsigned int a = 0; a < 2; ++a)
          {
            const double x        = model.lattice.joints[strut.joints[a]][0];
            const int   *node     = numbering.element_unknowns(e) + 3 * a;
            displacement[node[0]] = u(x);
            displacement[node[1]] = v(x);
          }
      }
    return displacement;
  }

  double nothing(const double /*x*/)
  {
    return 0;
  }

  class RelativeMotionOfARow : public ::testing::TestWithParam<bool>
  {
  protected:
    RelativeMotionOfARow()
      : on_ranks(row_of_struts(),
                 {},
                 GetParam() ? MPI_COMM_WORLD : MPI_COMM_SELF)
      , model(on_ranks.equations.model())
      , motion(model)
    {
      motion.start(displacement_of(model, nothing, nothing));
    }

    EquationsOnRanks    on_ranks;
    const LatticeModel &model;
    RelativeMotion      motion;
  };
} // namespace

TEST_P(RelativeMotionOfARow, IsNoneOfARigidTranslation)
{
  const auto far = [](double) { return 7.; };
  EXPECT_NEAR(motion.largest(displacement_of(model, far, far)), 0, 1e-14);
}

TEST_P(RelativeMotionOfARow, IsThatOfAJointThatMovesAlone)
{
  const auto kicked = [](const double x) { return x == 17 ? 0.4 : 0.; };
  EXPECT_NEAR(motion.largest(displacement_of(model, nothing, kicked)),
              0.4,
              1e-14);
  const auto aside = [](const double x) { return x == 17 ? 0.3 : 0.; };
  EXPECT_NEAR(motion.largest(displacement_of(model, aside, kicked)),
              0.5,
              1e-14);
}

TEST_P(RelativeMotionOfARow, OfAStretchIsThatOfThreeCells)
{
  const auto   stretch = [](const double x) { return 0.01 * x; };
  const double largest =
    motion.largest(displacement_of(model, stretch, nothing));
  // Elements reach out of the cells to which their middles belong.
  EXPECT_GE(largest, 0.01 * 12);
  EXPECT_LE(largest, 0.01 * 14);
}

TEST_P(RelativeMotionOfARow, CountsFromTheStartOnOnly)
{
  const auto bent = [](const double x) { return 0.1 * std::sin(x); };
  const auto more = [&](const double x) {
    return bent(x) + (x == 3 ? 0.2 : 0);
  };
  motion.start(displacement_of(model, nothing, bent));
  EXPECT_NEAR(motion.largest(displacement_of(model, nothing, more)),
              0.2,
              1e-14);
  Records        records;
  RelativeMotion resumed(model);
  motion.save("motion", records);
  resumed.resume("motion", records);
  EXPECT_EQ(resumed.largest(displacement_of(model, nothing, more)),
            motion.largest(displacement_of(model, nothing, more)));
}

INSTANTIATE_TEST_SUITE_P(Ranks, RelativeMotionOfARow, ::testing::Bool());
