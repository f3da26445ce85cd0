#include <auxfem/figures/crush_curve.h>
#include <auxfem/figures/run_figures.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

namespace
{
  /** A piecewise linear curve with a peak, a plateau and densification. */
  CrushCurve staircase()
  {
    const std::vector<double> stress =
      {1.1, 1.15, 1.2, 1.18, 1.22, 1.26, 1.3, 1.36, 1.5, 1.8, 2.4, 3.6, 6};
    CrushCurve curve;
    curve.add(0, 0);
    curve.add(0.02, 1);
    curve.add(0.04, 1.6);
    curve.add(0.06, 1.3);
    for (std::size_t i = 0; i < stress.size(); ++i)
      curve.add(0.1 + 0.05 * i, stress[i]);
    return curve;
  }

  CrushOptions plateau(const double begin, const double end)
  {
    CrushOptions options;
    options.plateau_begin = begin;
    options.plateau_end   = end;
    return options;
  }
} // namespace

// Values by hand and by another program.
TEST(CrushCurve, HasThePlateauOfTheStandard)
{
  const CrushFigures by_30 = crush_figures(staircase(), plateau(0.2, 0.3));
  EXPECT_NEAR(*by_30.plateau_stress, 1.1951485, 1e-7);
  EXPECT_NEAR(*by_30.plateau_end, 0.50894884, 1e-8);
  EXPECT_NEAR(*by_30.work_to_plateau_end, 0.62516351, 1e-8);
  EXPECT_NEAR(*by_30.efficiency_at_plateau_end, 0.76771408, 1e-8);
  const CrushFigures by_40 = crush_figures(staircase(), plateau(0.2, 0.4));
  EXPECT_NEAR(*by_40.plateau_stress, 1.2276119, 1e-7);
  EXPECT_NEAR(*by_40.plateau_end, 0.51598259, 1e-8);
  EXPECT_NEAR(*by_40.work_to_plateau_end, 0.63624021, 1e-8);
  EXPECT_NEAR(*by_40.efficiency_at_plateau_end, 0.77066580, 1e-8);
}

TEST(CrushCurve, FindsTheOnsetOfDensification)
{
  const CrushFigures figures = crush_figures(staircase(), {});
  EXPECT_NEAR(*figures.densification_strain, 0.5, 1e-12);
  EXPECT_NEAR(*figures.efficiency, 0.40766667, 1e-8);
  EXPECT_NEAR(*figures.work_to_densification, 0.6115, 1e-12);
  EXPECT_NEAR(*figures.ideality, 0.81533333, 1e-8);
  EXPECT_NEAR(*figures.plateau_stress_by_energy, 1.223, 1e-12);
  EXPECT_NEAR(*figures.crush_force_efficiency, 0.764375, 1e-12);
  EXPECT_EQ(figures.peak_stress, 1.6);
  CrushOptions from_yield;
  from_yield.yield_strain    = 0.04;
  const CrushFigures yielded = crush_figures(staircase(), from_yield);
  EXPECT_NEAR(*yielded.densification_strain, 0.5, 1e-12);
  EXPECT_NEAR(*yielded.efficiency, 0.38366667, 1e-8);
  EXPECT_NEAR(*yielded.plateau_stress_by_energy, 1.2510870, 1e-7);
}

// s = 1 + 10 e^9, whose efficiency is largest where e^9 = (70 - sqrt(4860)) /
// 20.
TEST(CrushCurve, FindsTheOnsetOfASmoothCurve)
{
  CrushCurve curve;
  const int  n = 20000;
  for (int i = 0; i <= n; ++i)
    {
      const double strain = 0.8 * i / n;
      curve.add(strain, 1 + 10 * std::pow(strain, 9));
    }
  const CrushFigures figures = crush_figures(curve, {});
  EXPECT_NEAR(*figures.densification_strain, 0.62386107, 4e-5);
  EXPECT_NEAR(*figures.efficiency, 0.55355089, 1e-7);
  EXPECT_NEAR(*figures.work_to_densification, 0.63279164, 5e-5);
  EXPECT_NEAR(*figures.ideality, 0.88729833, 5e-5);
}

TEST(CrushCurve, IsNotDensifiedWhileTheEfficiencyGrows)
{
  CrushCurve curve;
  for (int i = 0; i <= 30; ++i)
    curve.add(i / 100., 2);
  const CrushFigures figures = crush_figures(curve, {});
  EXPECT_FALSE(figures.densification_strain);
  EXPECT_FALSE(figures.plateau_stress);
  EXPECT_EQ(figures.peak_stress, 2);
  EXPECT_NEAR(figures.work_to_largest, 0.6, 1e-12);
}

// Loading to 0.2, back to 0.1 at half the stress, on to 0.3: the loop counts in
// the work, unloading at the end gives it back.
TEST(CrushCurve, CountsLoopsInTheWork)
{
  CrushCurve curve;
  for (const auto &[strain, stress] :
       std::vector<std::pair<double, double>>{{0, 1},
                                              {0.2, 1},
                                              {0.2, 0.5},
                                              {0.1, 0.5},
                                              {0.1, 1},
                                              {0.3, 1},
                                              {0.3, 0.5},
                                              {0.25, 0.5}})
    curve.add(strain, stress);
  const CrushFigures figures = crush_figures(curve, {});
  EXPECT_NEAR(figures.work_to_largest, 0.2 - 0.05 + 0.2, 1e-12);
  EXPECT_NEAR(figures.work_at_end, 0.35 - 0.025, 1e-12);
  EXPECT_EQ(loading_part(curve).strain, (std::vector<double>{0, 0.2, 0.3}));
}

// A plate above comes down on a support below: force on the plate and reaction
// of the support have opposite columns and give one curve.
TEST(CrushCurve, RelatesForcesToTheLattice)
{
  RecordedTable table;
  table.names   = {"time", "press.uy", "press.fy", "table.ry"};
  table.columns = {{0, 1, 2, 3},
                   {0, -0.01, -0.02, -0.03},
                   {0, 0, 6, 12},
                   {0, 0, 6, 12}};
  CrushGeometry geometry;
  geometry.positions = {{{{0, 0.1, 0}}, {{0, 0, 0}}}};
  geometry.size      = {{0.2, 0.1, 0}};
  geometry.depth     = 0.03;
  geometry.mass      = 0.5;
  CrushDefinition definition;
  definition.bodies = {{"press", "table"}};
  const auto found  = crush_result(definition, geometry, table);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->axis, "y");
  EXPECT_DOUBLE_EQ(found->area, 0.006);
  EXPECT_EQ(found->height, 0.1);
  // Strain begins at the last row without force.
  EXPECT_EQ(found->curve.strain.size(), 3);
  EXPECT_NEAR(found->curve.strain.back(), 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(found->curve.stress.back(), 2000);
  EXPECT_NEAR(found->energy(found->figures.work_to_largest), 0.12, 1e-12);
  EXPECT_NEAR(*found->specific_energy(found->figures.work_to_largest),
              0.24,
              1e-12);
  definition.bodies     = {{"table", "press"}};
  const auto from_below = crush_result(definition, geometry, table);
  geometry.positions    = {{{{0, 0, 0}}, {{0, 0.1, 0}}}};
  const auto swapped    = crush_result(definition, geometry, table);
  EXPECT_EQ(swapped->curve.stress, found->curve.stress);
  EXPECT_EQ(swapped->curve.strain, found->curve.strain);
  geometry.depth = 0;
  EXPECT_FALSE(crush_result(definition, geometry, table));
}
