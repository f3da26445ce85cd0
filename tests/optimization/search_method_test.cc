#include <auxfem/optimization/search_method.h>
#include <auxfem/parameters/registry.h>

#include <gtest/gtest.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  OptimizationDefinition problem(const unsigned int              n_variables,
                                 const std::vector<std::string> &methods)
  {
    OptimizationDefinition optimization;
    optimization.variables.resize(n_variables);
    optimization.methods = methods;
    return optimization;
  }

  std::string automatic(const unsigned int n, const bool has_constraints)
  {
    return chosen_methods(problem(n, {}), has_constraints).at(0).name;
  }
} // namespace

TEST(SearchMethods, AreChosenByTheProblem)
{
  EXPECT_EQ(automatic(1, false), "COBYLA");
  EXPECT_EQ(automatic(2, false), "BOBYQA");
  EXPECT_EQ(automatic(2, true), "COBYLA");
  const auto two = chosen_methods(problem(2, {"DIRECT-L", "Subplex"}), false);
  EXPECT_EQ(names_of(two), (std::vector<std::string>{"DIRECT-L", "Subplex"}));
  EXPECT_TRUE(two[0].is_global);
  EXPECT_FALSE(two[1].is_global);
}

TEST(SearchMethods, UnknownOnesAreRefused)
{
  const auto refusal = [](const unsigned int n, const std::string &name) {
    return input_error_of([&]() { chosen_methods(problem(n, {name}), false); });
  };
  expect_parts(refusal(2, "COBILA"),
               {"Optimization/Method", "COBILA", "COBYLA", "SLSQP"});
  expect_parts(refusal(1, "BOBYQA"), {"BOBYQA", "at least 2", "COBYLA"});
}

// The sentence of Optimization/Method lists them.
TEST(SearchMethods, AreAllInTheReference)
{
  for (const Parameter &parameter : optimization_schema().parameters)
    if (parameter.name == "Method")
      {
        for (const SearchMethod &method : search_methods())
          EXPECT_TRUE(contains(parameter.sentence, method.name)) << method.name;
      }
}

// A paraboloid, with the minimum at (0.7, 0.4), or at (0.5, 0.4) if the first
// variable is limited.
TEST(SearchMethods, FindTheMinimumWithAndWithoutConstraints)
{
  const auto objective =
    [](const std::vector<double> &x, std::vector<double> &gradient, void *) {
      const double a = x[0] - 0.7, b = x[1] - 0.4;
      if (!gradient.empty())
        gradient = {2 * a, 6 * b};
      return a * a + 3 * b * b;
    };
  const auto limit =
    [](const std::vector<double> &x, std::vector<double> &gradient, void *) {
      if (!gradient.empty())
        gradient = {1, 0};
      return x[0] - 0.5;
    };
  for (const SearchMethod &method : search_methods())
    for (const bool has_constraints : {false, true})
      {
        nlopt::opt optimizer =
          make_optimizer(method, 2, {0.2, 1e-6}, has_constraints);
        optimizer.set_min_objective(+objective, nullptr);
        if (has_constraints)
          optimizer.add_inequality_constraint(+limit, nullptr, 1e-6);
        optimizer.set_maxeval(3000);
        std::vector<double> x = {0.1, 0.9};
        double              value;
        optimizer.optimize(x, value);
        const double tolerance = method.is_global ? 0.02 : 1e-3;
        EXPECT_NEAR(x[0], has_constraints ? 0.5 : 0.7, tolerance)
          << method.name;
        EXPECT_NEAR(x[1], 0.4, tolerance) << method.name;
      }
}
