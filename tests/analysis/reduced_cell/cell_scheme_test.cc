#include <auxfem/analysis/reduced_cell/cell_run.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>
#include <support/cell_scene.h>

#include <cmath>
#include <map>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  std::vector<std::string> schemes()
  {
    std::vector<std::string> names;
    for (const TimeSchemeEntry &entry : time_scheme_registry())
      if (entry.serves(Model::reduced_cell))
        names.push_back(entry.name);
    return names;
  }

  CellHistory history_of(CellCase c, const std::string &scheme)
  {
    c.scheme = scheme;
    return compute_history(cell_scene(c));
  }
} // namespace

TEST(CellSchemes, EveryRegisteredSchemeIsAccepted)
{
  CellCase c;
  c.n_steps = 10;
  for (const std::string &scheme : schemes())
    {
      const CellHistory history = history_of(c, scheme);
      EXPECT_EQ(history.exit_state, "completed") << scheme;
      EXPECT_EQ(history.samples.size(), 11u) << scheme;
      EXPECT_EQ(history.samples.back().time, 0.05) << scheme;
    }
}

TEST(CellSchemes, StartAtRest)
{
  for (const std::string &scheme : schemes())
    {
      const CellSample first = history_of(CellCase(), scheme).samples[0];
      EXPECT_EQ(first.time, 0);
      EXPECT_DOUBLE_EQ(first.angle, M_PI / 6);
      EXPECT_EQ(first.lower_rise, 0);
      EXPECT_EQ(first.upper_rise, 0);
      EXPECT_EQ(first.transmitted, 0);
      EXPECT_EQ(first.energies.total(), 0);
    }
}

TEST(CellSchemes, WorkWithEveryLawExceptSome)
{
  /** Lines of the laws without the parameters K and C of the case. */
  const std::map<std::string, std::string> lines = {
    {"spring", ""},
    {"dashpot", ""},
    {"kelvin-voigt", ""},
    {"maxwell", ""},
    {"standard-linear-solid", "  set Long-time stiffness = 5e3\n"},
    {"generalized-maxwell",
     "  set Stiffnesses = 2e4, 5e3\n"
     "  set Relaxation times = 2.5e-3, 0.1\n"},
    {"cubic", "  set Cubic stiffness = 1e8\n"},
    {"friction-slider", "  set Slip force = 100\n"}};
  for (const std::string &scheme : schemes())
    for (const auto &[law, connector_lines] : lines)
      {
        CellCase c;
        c.law                     = law;
        c.n_steps                 = 2000;
        c.connector_lines         = connector_lines;
        const CellHistory history = history_of(c, scheme);
        if (scheme == "as printed" && !connector_lines.empty())
          EXPECT_NE(history.exit_state.find("Kelvin-Voigt and Maxwell"),
                    std::string::npos);
        else if (scheme == "arkode" && law == "friction-slider")
          EXPECT_NE(history.exit_state.find("friction"), std::string::npos);
        else
          EXPECT_EQ(history.exit_state, "completed") << scheme << law;
      }
}

TEST(CellSchemes, LastStepMayBeShorter)
{
  CellCase    c;
  std::string text = cell_text(c);
  for (const std::string &scheme : schemes())
    {
      const Scene       scene   = read_scene_from_text(text,
                                               "cell.prm",
                                               {"Time/Time step=0.3 ms",
                                                        "Time/Scheme=" + scheme});
      const CellHistory history = compute_history(scene);
      const bool        needs_equal =
        scheme == "central difference" || scheme == "as printed";
      if (needs_equal)
        EXPECT_NE(history.exit_state.find("needs equal steps"),
                  std::string::npos);
      else
        {
          ASSERT_EQ(history.exit_state, "completed");
          EXPECT_EQ(history.samples.back().time, 0.05);
          // 2400 N, and six times the step of the case
          EXPECT_NEAR(history.samples.back().transmitted, 2378.0025, 0.01);
        }
    }
}

TEST(CellSchemes, NewtonWithoutIterationsFails)
{
  CellCase c;
  c.scheme                  = "newmark";
  c.n_steps                 = 10;
  const Scene       scene   = read_scene_from_text(cell_text(c),
                                           "cell.prm",
                                           {"Newton/Maximum iterations=1"});
  const CellHistory history = compute_history(scene);
  EXPECT_NE(history.exit_state.find("has not converged in 1 iterations"),
            std::string::npos);
  EXPECT_LT(history.samples.size(), 11u);
}

// The number of iterations shows a wrong tangent, because Newton's method
// converges quadratically.
TEST(CellSchemes, NewtonConvergesFast)
{
  for (const std::string law : {"kelvin-voigt", "maxwell"})
    {
      CellCase c;
      c.law              = law;
      c.scheme           = "newmark";
      c.load             = "5e4*t";
      c.n_steps          = 20;
      const Scene scene  = cell_scene(c);
      const auto  scheme = make_cell_scheme(scene);
      scheme->start();
      for (unsigned int i = 0; i < 20; ++i)
        scheme->advance();
      EXPECT_LE(scheme->work(), 20u * 6) << law;
    }
}

TEST(CellSchemes, ComparisonContinuesAfterFailures)
{
  CellCase c;
  c.law                                 = "standard-linear-solid";
  c.connector_lines                     = "  set Long-time stiffness = 5e3\n";
  c.n_steps                             = 500;
  const std::vector<ComparisonRow> rows = compare_schemes(cell_scene(c));
  ASSERT_EQ(rows.size(), schemes().size());
  for (const ComparisonRow &row : rows)
    {
      EXPECT_EQ(row.name, "cell");
      const bool fails = row.scheme == "as printed";
      EXPECT_EQ(row.exit_state == "completed", !fails);
      EXPECT_EQ(std::isnan(row.angle), fails);
      if (!fails)
        {
          EXPECT_LT(row.transmitted_difference, 1e-4) << row.scheme;
        }
    }
  EXPECT_EQ(rows.front().scheme, "arkode");
  EXPECT_EQ(rows.front().angle_difference, 0);
}

// A nearly zero dashpot is too stiff for the reference, whose few samples must
// not count as agreement.
TEST(CellSchemes, WithoutAReferenceThereAreNoDifferences)
{
  CellCase c = table_case(5);
  c.damping  = 1e-9;
  c.n_steps  = 10;
  for (const ComparisonRow &row : compare_schemes(cell_scene(c)))
    {
      EXPECT_EQ(row.exit_state == "completed", row.scheme != "arkode")
        << row.scheme;
      EXPECT_TRUE(std::isnan(row.angle_difference)) << row.scheme;
      EXPECT_TRUE(std::isnan(row.transmitted_difference)) << row.scheme;
    }
}
