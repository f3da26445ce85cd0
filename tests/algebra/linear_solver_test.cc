#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/linear_solver.h>
#include <auxfem/parameters/errors.h>

#include <algebra/strut_network.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Blocks are well conditioned, with entries of about one.
  constexpr double solver_round_off = 1e-11;

  SolverParameters with_type(const std::string &type)
  {
    SolverParameters parameters;
    parameters.type = type;
    return parameters;
  }

  /** Expects the solution of the dense equations, ghosts included. */
  void expect_solution(const StrutNetwork &network,
                       LinearSolver       &solver,
                       const Symmetry      symmetry)
  {
    std::vector<double>       x = network.owned(network.right_side());
    const std::vector<double> b = x;
    ASSERT_TRUE(solver.solve(x)) << solver.last_failure();
    const dealii::Vector<double> expected = network.solution(symmetry);
    for (unsigned int i = 0; i < x.size(); ++i)
      EXPECT_NEAR(x[i], expected(network.layout->global(i)), solver_round_off);
    EXPECT_LT(backward_error(*network.matrix, x, b, symmetry), 1e-13);
  }

  /** Networks in the plane and in space with one or two elements per strut. */
  std::vector<NetworkShape> shapes(const unsigned int n_multipliers,
                                   const double       asymmetry)
  {
    std::vector<NetworkShape> all;
    for (const unsigned int n_components : {3, 6})
      for (const unsigned int n_elements : {1, 2})
        {
          NetworkShape shape;
          shape.n_components  = n_components;
          shape.n_elements    = n_elements;
          shape.n_multipliers = n_multipliers;
          shape.asymmetry     = asymmetry;
          all.push_back(shape);
        }
    return all;
  }

  EquationsAtJoints equations(const Symmetry      symmetry,
                              const unsigned long n_unknowns,
                              const unsigned long n_multipliers,
                              const unsigned int  n_ranks)
  {
    EquationsAtJoints chosen;
    chosen.symmetry      = symmetry;
    chosen.n_unknowns    = n_unknowns;
    chosen.n_multipliers = n_multipliers;
    chosen.n_ranks       = n_ranks;
    return chosen;
  }
} // namespace

TEST(LinearSolver, SolvesSymmetricEquations)
{
  for (const std::string type : {"auto", "cholmod", "klu", "mumps"})
    for (const NetworkShape &shape : shapes(0, 0.))
      {
        SCOPED_TRACE(type);
        const StrutNetwork network(shape);
        LinearSolver       solver(with_type(type), *network.matrix);
        ASSERT_EQ(solver.factorize(Exactness::exact),
                  FactorizationOutcome::done);
        EXPECT_EQ(solver.last_failure(), "");
        EXPECT_TRUE(solver.is_exact());
        expect_solution(network, solver, Symmetry::none);
        EXPECT_EQ(solver.n_iterations(), 0u);
        EXPECT_GT(solver.memory(), 0u);
      }
}

TEST(LinearSolver, SolvesWithoutTheEntriesOfTheMatrix)
{
  for (const NetworkShape &shape : shapes(0, 0.1))
    {
      const StrutNetwork network(shape);
      LinearSolver       solver(with_type("auto"), *network.matrix);
      ASSERT_EQ(solver.factorize(Exactness::exact), FactorizationOutcome::done);
      std::vector<double> expected = network.owned(network.right_side()),
                          x        = expected;
      ASSERT_TRUE(solver.solve(expected)) << solver.last_failure();
      network.matrix->release();
      ASSERT_TRUE(solver.solve(x)) << solver.last_failure();
      EXPECT_EQ(x, expected);
    }
}

TEST(LinearSolver, SolvesEquationsWithMultipliers)
{
  for (const std::string type : {"auto", "klu", "mumps"})
    for (const double asymmetry : {0., 0.3})
      for (const NetworkShape &shape : shapes(2, asymmetry))
        {
          SCOPED_TRACE(type);
          const StrutNetwork network(shape);
          LinearSolver       solver(with_type(type), *network.matrix);
          ASSERT_EQ(solver.factorize(Exactness::exact),
                    FactorizationOutcome::done);
          expect_solution(network, solver, Symmetry::none);
        }
}

TEST(LinearSolver, SymmetricPartOnlyWhereItIsAllowedAndNear)
{
  for (const std::string type : {"auto", "mumps"})
    for (const NetworkShape &shape : shapes(0, 0.3))
      {
        SCOPED_TRACE(type);
        const StrutNetwork network(shape);
        LinearSolver       solver(with_type(type), *network.matrix);
        ASSERT_EQ(solver.factorize(Exactness::approximate),
                  FactorizationOutcome::done);
        EXPECT_TRUE(solver.is_exact());
        expect_solution(network, solver, Symmetry::none);
      }
  for (const std::string type : {"auto", "mumps"})
    for (const NetworkShape &shape : shapes(0, 1e-6))
      {
        SCOPED_TRACE(type);
        const StrutNetwork network(shape);
        LinearSolver       solver(with_type(type), *network.matrix);
        ASSERT_EQ(solver.factorize(Exactness::approximate),
                  FactorizationOutcome::done);
        EXPECT_FALSE(solver.is_exact());
        EXPECT_FALSE(solver.determinant_sign());
        EXPECT_TRUE(solver.inertia());
        expect_solution(network, solver, Symmetry::enforced);
        ASSERT_EQ(solver.factorize(Exactness::exact),
                  FactorizationOutcome::done);
        EXPECT_TRUE(solver.is_exact());
        EXPECT_FALSE(solver.inertia());
        expect_solution(network, solver, Symmetry::none);
      }
  // A symmetric matrix is its symmetric part.
  const StrutNetwork symmetric;
  LinearSolver       solver(with_type("auto"), *symmetric.matrix);
  ASSERT_EQ(solver.factorize(Exactness::approximate),
            FactorizationOutcome::done);
  EXPECT_TRUE(solver.is_exact());
}

TEST(LinearSolver, CholmodIsSymmetricAndKluExact)
{
  NetworkShape shape;
  shape.asymmetry = 0.3;
  const StrutNetwork network(shape);
  LinearSolver       cholmod(with_type("cholmod"), *network.matrix);
  ASSERT_EQ(cholmod.factorize(Exactness::exact), FactorizationOutcome::done);
  EXPECT_FALSE(cholmod.is_exact());
  // KLU does not gain from symmetry.
  LinearSolver klu(with_type("klu"), *network.matrix);
  ASSERT_EQ(klu.factorize(Exactness::approximate), FactorizationOutcome::done);
  EXPECT_TRUE(klu.is_exact());
}

TEST(LinearSolver, CountsEigenvaluesOfAllFreeUnknowns)
{
  for (const std::string type : {"auto", "mumps", "gmres"})
    for (const double shift : {0., 1., 1.2})
      for (NetworkShape shape : shapes(2, 0.))
        {
          SCOPED_TRACE(type + ", shift " + std::to_string(shift));
          // The diagonal is about the number of an element's unknowns.
          shape.shift = shift * 3 * shape.n_components;
          const StrutNetwork network(shape);
          LinearSolver       solver(with_type(type), *network.matrix);
          ASSERT_EQ(solver.factorize(Exactness::exact),
                    FactorizationOutcome::done);
          const DenseMatrix free =
            network.dense_part([](const StrutNetwork::Unknown &unknown) {
              return unknown.kind != UnknownKind::prescribed;
            });
          const unsigned long n_negative = n_negative_eigenvalues(free);
          // One per constraint if the rest is definite.
          EXPECT_EQ(n_negative == 2, shift == 0);
          const std::optional<NegativeModes> modes = solver.negative_modes();
          ASSERT_TRUE(modes);
          EXPECT_EQ(modes->n > 0, n_negative > 2);
          EXPECT_LE(modes->n, n_negative - 2);
          if (type == "gmres")
            continue;
          EXPECT_EQ(modes->n, n_negative - 2);
          EXPECT_FALSE(modes->is_lower_bound);
          const std::optional<Inertia> inertia = solver.inertia();
          ASSERT_TRUE(inertia);
          EXPECT_EQ(inertia->negative, n_negative);
          EXPECT_EQ(inertia->zero, 0u);
          EXPECT_EQ(inertia->positive, free.m() - n_negative);
        }
}

TEST(LinearSolver, ComputesTheSignOfTheDeterminant)
{
  for (const std::string type : {"auto", "klu", "mumps"})
    {
      unsigned int n_of_sign[2] = {};
      for (const double asymmetry : {0., 0.8})
        for (const double shift : {0., 0.8, 0.9, 1., 1.1, 1.2})
          for (const unsigned int n_multipliers : {0, 1, 2})
            for (NetworkShape shape : shapes(n_multipliers, asymmetry))
              {
                shape.shift = shift * 3 * shape.n_components;
                const StrutNetwork network(shape);
                LinearSolver       solver(with_type(type), *network.matrix);
                ASSERT_EQ(solver.factorize(Exactness::exact),
                          FactorizationOutcome::done);
                dealii::LAPACKFullMatrix<double> dense(network.n_unknowns());
                dense = network.dense();
                dense.compute_lu_factorization();
                const int sign = dense.determinant() < 0 ? -1 : 1;
                ++n_of_sign[sign < 0 ? 0 : 1];
                EXPECT_EQ(solver.determinant_sign(), sign)
                  << type << ' ' << asymmetry << ' ' << shift << ' '
                  << n_multipliers;
              }
      EXPECT_GT(n_of_sign[0], 20u);
      EXPECT_GT(n_of_sign[1], 20u);
    }
}

TEST(LinearSolver, UsesThePresentPattern)
{
  for (const std::string type : {"cholmod", "klu", "mumps"})
    {
      StrutNetwork network;
      LinearSolver solver(with_type(type), *network.matrix);
      solver.factorize(Exactness::exact);
      const int twice[2] = {3, 4};
      network.pattern->register_block(twice, 2);
      network.fill();
      ASSERT_EQ(solver.factorize(Exactness::exact), FactorizationOutcome::done);
      expect_solution(network, solver, Symmetry::none);
    }
}

TEST(LinearSolver, DistinguishesSingularFromNonFiniteMatrices)
{
  for (const std::string type : {"auto", "klu", "mumps"})
    for (const unsigned int order : {1, 2})
      {
        SCOPED_TRACE(type);
        NetworkShape shape;
        shape.order = order;
        StrutNetwork network(shape);
        LinearSolver solver(with_type(type), *network.matrix);
        network.matrix->reset();
        EXPECT_EQ(solver.factorize(Exactness::exact),
                  FactorizationOutcome::singular);
        EXPECT_NE(solver.last_failure().find("singular"), std::string::npos);
        EXPECT_EQ(solver.last_failure().find("the inside of strut") !=
                    std::string::npos,
                  order == 2);
        EXPECT_FALSE(solver.inertia());
        EXPECT_FALSE(solver.determinant_sign());
        network.fill();
        network.matrix->add_to_diagonal(
          std::vector<double>(network.layout->n_owned(),
                              std::numeric_limits<double>::quiet_NaN()));
        EXPECT_EQ(solver.factorize(Exactness::exact),
                  FactorizationOutcome::not_finite);
        EXPECT_NE(solver.last_failure().find("not finite"), std::string::npos);
        // The failure must leave no trace.
        network.fill();
        ASSERT_EQ(solver.factorize(Exactness::exact),
                  FactorizationOutcome::done);
        expect_solution(network, solver, Symmetry::none);
      }
}

TEST(LinearSolver, ANonFiniteRightSideGivesANonFiniteSolution)
{
  const StrutNetwork network;
  LinearSolver       solver(with_type("auto"), *network.matrix);
  ASSERT_EQ(solver.factorize(Exactness::exact), FactorizationOutcome::done);
  std::vector<double> x(network.layout->n_local(),
                        std::numeric_limits<double>::quiet_NaN());
  solver.solve(x);
  for (const double value : x)
    EXPECT_FALSE(std::isfinite(value));
}

TEST(LinearSolverChoice, DependsOnTheEquations)
{
  const auto chosen = [](const EquationsAtJoints &at_joints) {
    const LinearSolverChoice choice =
      choose_linear_solver(SolverParameters(), at_joints);
    EXPECT_NE(choice.reason, "");
    return choice.type;
  };
  const Symmetry given = Symmetry::given, none = Symmetry::none;
  EXPECT_EQ(chosen(equations(given, 1000, 0, 1)), LinearSolverType::cholmod);
  EXPECT_EQ(chosen(equations(Symmetry::enforced, 1000, 0, 1)),
            LinearSolverType::cholmod);
  EXPECT_EQ(chosen(equations(given, 900000, 0, 1)), LinearSolverType::cholmod);
  EXPECT_EQ(chosen(equations(given, 1000, 0, 4)), LinearSolverType::cholmod);
  EXPECT_EQ(chosen(equations(given, 900000, 0, 4)), LinearSolverType::mumps);
  EXPECT_EQ(chosen(equations(given, 1000, 3, 1)), LinearSolverType::klu);
  EXPECT_EQ(chosen(equations(given, 50000, 3, 1)), LinearSolverType::mumps);
  EXPECT_EQ(chosen(equations(none, 1000, 3, 1)), LinearSolverType::klu);
  EXPECT_EQ(chosen(equations(none, 50000, 0, 1)), LinearSolverType::klu);
  EXPECT_EQ(chosen(equations(none, 900000, 0, 1)), LinearSolverType::mumps);
  const auto in_space = [&](const Symmetry      symmetry,
                            const unsigned long n_unknowns) {
    EquationsAtJoints space_equations = equations(symmetry, n_unknowns, 0, 1);
    space_equations.n_components      = 6;
    return chosen(space_equations);
  };
  EXPECT_EQ(in_space(given, 20000), LinearSolverType::cholmod);
  EXPECT_EQ(in_space(given, 50000), LinearSolverType::mumps);
  EXPECT_EQ(in_space(none, 5000), LinearSolverType::klu);
  EXPECT_EQ(in_space(none, 20000), LinearSolverType::mumps);
  EXPECT_EQ(in_space(given, 5000000), LinearSolverType::iterative);

  SolverParameters with_inertia;
  with_inertia.needs_inertia = true;
  EquationsAtJoints many     = equations(given, 5000000, 0, 1);
  many.n_components          = 6;
  EXPECT_EQ(choose_linear_solver(with_inertia, many).type,
            LinearSolverType::mumps);
}

TEST(LinearSolverChoice, MumpsHasAllRanksWhereThatIsQuicker)
{
  const auto ranks = [](const unsigned long n_unknowns,
                        const unsigned int  n_components) {
    EquationsAtJoints some = equations(Symmetry::given, n_unknowns, 0, 2);
    some.n_components      = n_components;
    return choose_mumps_ranks(some);
  };
  EXPECT_EQ(ranks(30000, 3), MumpsRanks::first);
  EXPECT_EQ(ranks(200000, 3), MumpsRanks::all);
  EXPECT_EQ(ranks(3000, 6), MumpsRanks::first);
  EXPECT_EQ(ranks(7000, 6), MumpsRanks::all);
}

TEST(LinearSolverChoice, ObeysTheUser)
{
  const EquationsAtJoints some = equations(Symmetry::given, 1000, 0, 1);
  EXPECT_EQ(choose_linear_solver(with_type("klu"), some).type,
            LinearSolverType::klu);
  EXPECT_EQ(choose_linear_solver(with_type("mumps"), some).type,
            LinearSolverType::mumps);
  EXPECT_EQ(choose_linear_solver(with_type("cholmod"), some).type,
            LinearSolverType::cholmod);
  EXPECT_EQ(choose_linear_solver(with_type("gmres"), some).type,
            LinearSolverType::iterative);
  EXPECT_EQ(choose_linear_solver(with_type("gmres"),
                                 equations(Symmetry::given, 1000, 7, 1))
              .type,
            LinearSolverType::mumps);
  try
    {
      choose_linear_solver(with_type("cholmod"),
                           equations(Symmetry::given, 1000, 7, 1));
      ADD_FAILURE();
    }
  catch (const InputError &error)
    {
      const std::string words = error.what();
      EXPECT_NE(words.find("Solver/Type = cholmod"), std::string::npos);
      EXPECT_NE(words.find("the 7 constraints"), std::string::npos);
      EXPECT_NE(words.find("`mumps`"), std::string::npos);
    }
}
