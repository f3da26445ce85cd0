#include <auxfem/struts/fibres.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

TEST(Fibres, KeepAreaAndMoments)
{
  using Kind                 = SectionShape::Kind;
  const FibreNumbers numbers = {7, 3, 8, 5};
  for (const SectionShape &shape : {SectionShape{Kind::rectangle, 0},
                                    SectionShape{Kind::circle, 0},
                                    SectionShape{Kind::tube, 0.8}})
    for (const bool in_space : {false, true})
      {
        double area = 0, moment = 0, other = 0, mixed = 0, static_moment = 0;
        for (const Fibre &fibre : in_space ? space_fibres(shape, numbers)
                                           : plane_fibres(shape, numbers))
          {
            EXPECT_GT(fibre.weight, 0);
            area += fibre.weight;
            moment += fibre.weight * fibre.arm_3 * fibre.arm_3;
            other += fibre.weight * fibre.arm_2 * fibre.arm_2;
            mixed += fibre.weight * fibre.arm_2 * fibre.arm_3;
            static_moment += fibre.weight * (fibre.arm_3 + fibre.arm_2);
          }
        EXPECT_NEAR(area, 1, 1e-15);
        EXPECT_NEAR(moment, 1, 1e-15);
        EXPECT_NEAR(other, in_space ? 1 : 0, 1e-15);
        EXPECT_NEAR(mixed, 0, 1e-15);
        EXPECT_NEAR(static_moment, 0, 1e-15);
      }
}

// Plastic moments over those of the outermost fibre at yield: 1.5 of
// rectangles, 16 / (3 pi) of circles, 4 / pi of thin tubes.
TEST(Fibres, HavePlasticMoments)
{
  using Kind                 = SectionShape::Kind;
  const double       pi      = std::acos(-1.);
  const FibreNumbers numbers = {16, 4, 16, 8};
  const auto         moment  = [](const std::vector<Fibre> &fibres) {
    double sum = 0;
    for (const Fibre &fibre : fibres)
      sum += fibre.weight * std::abs(fibre.arm_3);
    return sum;
  };
  const SectionShape tube = {Kind::tube, 0.99};
  const double thin = 4 / (3 * pi) * (1 - std::pow(.99, 3)) / (1 - .99 * .99) /
    std::sqrt((1 + .99 * .99) / 4);
  EXPECT_NEAR(moment(plane_fibres({Kind::rectangle, 0}, numbers)),
              std::sqrt(3.) / 2,
              0.003);
  EXPECT_NEAR(moment(plane_fibres({Kind::circle, 0}, numbers)),
              8 / (3 * pi),
              0.004);
  EXPECT_NEAR(moment(plane_fibres(tube, numbers)), thin, 0.003);
  EXPECT_NEAR(moment(space_fibres({Kind::rectangle, 0}, numbers)),
              std::sqrt(3.) / 2,
              0.012);
  EXPECT_NEAR(moment(space_fibres({Kind::circle, 0}, numbers)),
              8 / (3 * pi),
              0.013);
  EXPECT_NEAR(moment(space_fibres(tube, numbers)), thin, 0.013);
}
