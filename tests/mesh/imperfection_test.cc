#include <auxfem/mesh/imperfection.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

namespace
{
  /** Strut 0 straight from (0, 0) to (2, 0), strut 1 an arc from there on. */
  Lattice two_struts()
  {
    Lattice lattice;
    lattice.joints = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}};
    Strut straight, arc;
    straight.joints = {{0, 1}};
    arc.joints      = {{1, 2}};
    arc.sagitta     = 0.5;
    lattice.struts  = {straight, arc};
    return lattice;
  }

  dealii::Point<3> middle_of_strut(const Lattice     &lattice,
                                   const unsigned int strut)
  {
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> tangent;
    lattice.axis(lattice.struts[strut], 0.5, position, tangent);
    return position;
  }
} // namespace

TEST(Imperfection, StrutsThatMoveAsAWholeKeepTheirShape)
{
  Lattice         lattice = two_struts();
  GeometryOffsets offsets(lattice);
  offsets.joints = {dealii::Point<3>(0, 0.1, 0),
                    dealii::Point<3>(0.1, 0.3, 0),
                    dealii::Point<3>(0.1, 0.3, 0)};
  for (unsigned int i = 0; i < 2; ++i)
    offsets.middles[i] = offsets.mean_of_ends(lattice.struts[i]);
  disturb(offsets, lattice);
  EXPECT_EQ(lattice.struts[0].sagitta, 0.);
  EXPECT_EQ(lattice.struts[1].sagitta, 0.5);
  EXPECT_EQ(lattice.joints[1][1], 0.3);
  ASSERT_TRUE(lattice.as_designed);
  EXPECT_EQ(lattice.as_designed->joints[1][1], 0.);
}

TEST(Imperfection, MiddlesThatMoveBendStruts)
{
  for (const double bow : {0.05, -0.2})
    {
      Lattice         lattice = two_struts();
      GeometryOffsets offsets(lattice);
      offsets.joints[1] = dealii::Point<3>(0, 0.1, 0);
      // Offsets along the strut do not bend it.
      offsets.middles[0] = dealii::Point<3>(0.01, 0.05 + bow, 0);
      offsets.middles[1] = dealii::Point<3>(0, 0.05 + bow, 0);
      disturb(offsets, lattice);
      EXPECT_NEAR(middle_of_strut(lattice, 0)[1], 0.05 + bow, 1e-3);
      EXPECT_NEAR(middle_of_strut(lattice, 1)[1], 0.55 + bow, 2e-3);
      EXPECT_NEAR(lattice.struts[0].normal[2], 1., 1e-15);
      EXPECT_DOUBLE_EQ(offsets.largest(),
                       std::max(0.1, offsets.middles[0].norm()));
    }
}

TEST(Imperfection, StrutsInSpaceBendToAnySide)
{
  Lattice lattice   = two_struts();
  lattice.dimension = 3;
  GeometryOffsets offsets(lattice);
  offsets.middles[0] = dealii::Point<3>(0, 0.03, -0.04);
  disturb(offsets, lattice);
  const dealii::Point<3> now = middle_of_strut(lattice, 0);
  EXPECT_NEAR(now[0], 1, 1e-14);
  EXPECT_NEAR(now[1], 0.03, 1e-14);
  EXPECT_NEAR(now[2], -0.04, 1e-14);
}
