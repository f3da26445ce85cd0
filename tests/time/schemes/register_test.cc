#include <auxfem/parameters/errors.h>
#include <auxfem/time/schemes/alpha_family.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <gtest/gtest.h>
#include <support/parameter_values.h>

#include <set>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  /** The scheme @p name with the parameter lines of a user. */
  std::unique_ptr<TimeScheme> make_scheme(const std::string &name,
                                          const std::string &text = "")
  {
    const TimeSchemeEntry &entry = time_scheme_entry(name);
    SceneContext           context;
    context.path           = "Time";
    ParameterValues values = values_from_text(entry.parameters, text, context);
    return entry.make(values);
  }

  const AlphaFamily::Coefficients &coefficients(const TimeScheme &scheme)
  {
    return dynamic_cast<const AlphaFamily &>(scheme).coefficients();
  }

  void expect_equal(const AlphaFamily::Coefficients &a,
                    const AlphaFamily::Coefficients &b)
  {
    EXPECT_EQ(a.alpha_m, b.alpha_m);
    EXPECT_EQ(a.alpha_f, b.alpha_f);
    EXPECT_EQ(a.beta, b.beta);
    EXPECT_EQ(a.gamma, b.gamma);
  }
} // namespace

TEST(TimeSchemes, EachIsNamedAsInTheTableAndFitsItsModels)
{
  std::set<std::string> names;
  for (const TimeSchemeEntry &entry : time_scheme_registry())
    {
      EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " twice";
      EXPECT_FALSE(entry.models.empty()) << entry.name;
      const std::unique_ptr<TimeScheme> scheme = make_scheme(entry.name);
      EXPECT_EQ(scheme->name(), entry.name);
      if (entry.serves(Model::lattice))
        {
          EXPECT_NE(dynamic_cast<ImplicitScheme *>(scheme.get()), nullptr)
            << entry.name;
        }
      // Without inertia the angle of the cell is undetermined.
      if (!scheme->is_dynamic())
        {
          EXPECT_FALSE(entry.serves(Model::reduced_cell)) << entry.name;
        }
    }
}

TEST(TimeSchemes, TheDefaultIsAverageAcceleration)
{
  EXPECT_EQ(default_time_scheme()->name(), "newmark");
  expect_equal(coefficients(*default_time_scheme()),
               AlphaFamily::newmark(0.25, 0.5));
}

TEST(TimeSchemes, ParametersBecomeCoefficients)
{
  expect_equal(coefficients(*make_scheme("newmark",
                                         "set Newmark beta = 0.36\n"
                                         "set Newmark gamma = 0.7")),
               AlphaFamily::newmark(0.36, 0.7));
  expect_equal(coefficients(*make_scheme("hht")), AlphaFamily::hht(-0.05));
  expect_equal(coefficients(*make_scheme("hht", "set HHT alpha = -0.1")),
               AlphaFamily::hht(-0.1));
  expect_equal(coefficients(*make_scheme("generalized-alpha")),
               AlphaFamily::generalized_alpha(0.8));
  expect_equal(coefficients(*make_scheme("generalized-alpha",
                                         "set Spectral radius = 0.5")),
               AlphaFamily::generalized_alpha(0.5));
}

TEST(TimeSchemes, UnstableParametersOfNewmarkAreRefused)
{
  const std::string message =
    input_error_of([] { make_scheme("newmark", "set Newmark beta = 0.2"); });
  EXPECT_EQ(message,
            "Time/Newmark beta = 0.2 and Time/Newmark gamma = 0.5 are not "
            "unconditionally stable, which needs 2 beta >= gamma >= 1/2. Use "
            "e.g. beta = 0.25 and gamma = 0.5");
}

TEST(TimeSchemes,
     RungeKuttaAndWeaklyDampedGeneralizedAlphaAreNotedForRigidParts)
{
  for (const TimeSchemeEntry &entry : time_scheme_registry())
    EXPECT_EQ(make_scheme(entry.name)->note_on_rigid_parts().has_value(),
              entry.name == "esdirk")
      << entry.name;
  EXPECT_FALSE(make_scheme("generalized-alpha", "set Spectral radius = 0.9")
                 ->note_on_rigid_parts());
  EXPECT_TRUE(make_scheme("generalized-alpha", "set Spectral radius = 0.91")
                ->note_on_rigid_parts());
}
