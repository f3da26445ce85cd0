#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/linear_solver_method.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>
#include <support/beam_lattice.h>

#include <limits>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SolverParameters accurate()
  {
    SolverParameters parameters;
    parameters.tolerance = 1e-13;
    return parameters;
  }

  /** Owned rows of the solution by a dense factorization of all of A. */
  std::vector<double> dense_solution(const BeamSystem          &system,
                                     const std::vector<double> &b)
  {
    const UnknownLayout &layout = *system.layout;
    const unsigned int   n      = layout.n_global();
    std::vector<double>  entries(n * n, 0.), right_side(n, 0.);
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      {
        const SparseMatrix &A = *system.matrix;
        for (std::size_t i = A.first[row]; i < A.first[row + 1]; ++i)
          entries[layout.global(row) * n + layout.global(A.columns[i])] =
            A.entries[i];
        right_side[layout.global(row)] = b[row];
      }
    entries    = layout.sum(entries);
    right_side = layout.sum(right_side);
    dealii::LAPACKFullMatrix<double> matrix(n);
    dealii::Vector<double>           x(right_side.begin(), right_side.end());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        matrix(i, j) = entries[i * n + j];
    matrix.compute_lu_factorization();
    matrix.solve(x);
    std::vector<double> owned(layout.n_owned());
    for (unsigned int row = 0; row < owned.size(); ++row)
      owned[row] = x[layout.global(row)];
    return owned;
  }

  unsigned long n_negative_by_mumps(const BeamSystem &system)
  {
    const std::unique_ptr<DirectSolver> mumps = make_mumps(MumpsRanks::all);
    EXPECT_EQ(mumps->analyse(*system.matrix), FactorizationOutcome::done);
    EXPECT_EQ(mumps->factorize(*system.matrix), FactorizationOutcome::done);
    return mumps->inertia()->negative;
  }

  /** Factorizes and solves; expects success. */
  std::vector<double> solve(LinearSolverMethod        &solver,
                            const BeamSystem          &system,
                            const std::vector<double> &b)
  {
    std::vector<double> x = b;
    EXPECT_EQ(solver.factorize(*system.matrix), FactorizationOutcome::done);
    EXPECT_EQ(solver.solve(x.data()), "");
    return x;
  }

  void expect_dense_solution(const BeamSystem &system)
  {
    const std::unique_ptr<LinearSolverMethod> solver =
      make_iterative_solver(accurate());
    solver->analyse(*system.matrix, *system.unknowns);
    const std::vector<double> b = system.loads(), x = solve(*solver, system, b),
                              exact = dense_solution(system, b);
    EXPECT_LT(system.residual(x, b), 1e-12);
    for (const UnknownKind kind :
         {UnknownKind::translation, UnknownKind::rotation})
      {
        double error = 0, largest = 0;
        for (unsigned int i = 0; i < x.size(); ++i)
          if (system.unknowns->kinds[i] == kind)
            {
              error   = std::max(error, std::abs(x[i] - exact[i]));
              largest = std::max(largest, std::abs(exact[i]));
            }
        // Condition: bending of these struts is 7500 times softer than
        // extension, and of the lattice 100 times softer still.
        EXPECT_LE(system.layout->largest(error),
                  1e-9 * system.layout->largest(largest))
          << static_cast<int>(kind);
      }
  }

  const BeamLattice plane = star_lattice(2, {{3, 2, 1}});
  const BeamLattice space = star_lattice(3, {{2, 1, 1}});

  /**
   * Cells per side in the plane above which elimination leaves more unknowns
   * than multigrid solves directly, on one to four ranks.
   */
  constexpr unsigned int n_for_two_levels = 45;

  unsigned int n_ranks()
  {
    return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }
} // namespace

TEST(IterativeSolver, SmallLatticesAreSolvedAsByADenseFactorization)
{
  expect_dense_solution(BeamSystem(2, plane));
  expect_dense_solution(BeamSystem(3, space));
}

TEST(IterativeSolver, UnsymmetricMatrices)
{
  BeamOptions options;
  options.follower = 3.;
  expect_dense_solution(BeamSystem(2, plane, options));
  expect_dense_solution(BeamSystem(3, space, options));
}

TEST(IterativeSolver, IterationsOfStaticLatticesAreFew)
{
  // Slender joints stay at boundaries between ranks.
  const unsigned int most = n_ranks() == 1 ? 60 : 250;
  for (const auto &[dimension, n] :
       {std::make_pair(2u, n_for_two_levels), {3u, 5u}})
    {
      const BeamSystem system(dimension, star_lattice(dimension, {{n, n, n}}));
      const std::unique_ptr<LinearSolverMethod> solver =
        make_iterative_solver({});
      solver->analyse(*system.matrix, *system.unknowns);
      const std::vector<double> b = system.loads(),
                                x = solve(*solver, system, b);
      EXPECT_LE(solver->n_iterations(), most);
      EXPECT_GE(solver->n_iterations(), 1u);
      // The tolerance is relative to the right-hand side, which is far smaller
      // than the terms of a row.
      EXPECT_LT(system.residual(x, b), 1e-9);
    }
}

TEST(IterativeSolver, IncompleteFactorizationServesShortSteps)
{
  BeamOptions options;
  options.inertia = 1e6;
  for (const double follower : {0., 3.})
    {
      options.follower = follower;
      const BeamSystem system(2, star_lattice(2, {{16, 16, 1}}), options);
      SolverParameters parameters;
      parameters.preconditioner = "ilu";
      const std::unique_ptr<LinearSolverMethod> solver =
        make_iterative_solver(parameters);
      solver->analyse(*system.matrix, *system.unknowns);
      const std::vector<double> b = system.loads(),
                                x = solve(*solver, system, b);
      EXPECT_LE(solver->n_iterations(), 30u);
      EXPECT_LT(system.residual(x, b), 1e-8);
    }
}

TEST(IterativeSolver, IndefiniteMatrices)
{
  // Compressed beyond buckling in many modes.
  BeamOptions options;
  options.tension = -3.;
  const BeamSystem system(2, star_lattice(2, {{12, 12, 1}}), options);
  const std::unique_ptr<LinearSolverMethod> solver = make_iterative_solver({});
  solver->analyse(*system.matrix, *system.unknowns);
  const std::vector<double> b = system.loads(), x = solve(*solver, system, b);
  EXPECT_LT(system.residual(x, b), 1e-9);
}

TEST(IterativeSolver, DistinguishesStableFromUnstable)
{
  struct Loads
  {
    unsigned int dimension, n_cells;
    /** Tensions of struts slightly below and above the buckling load. */
    double before, after;
  };
  for (const Loads &loads :
       {Loads{2, n_for_two_levels, -.372, -.374}, Loads{3, 5, -.0952, -.0957}})
    for (const double tension : {loads.before, loads.after})
      {
        SCOPED_TRACE(tension);
        const unsigned int n       = loads.n_cells;
        const BeamLattice  lattice = star_lattice(loads.dimension, {{n, n, n}});
        BeamOptions        options;
        options.tension = tension;
        const BeamSystem    system(loads.dimension, lattice, options);
        const unsigned long n_negative = n_negative_by_mumps(system);
        EXPECT_EQ(n_negative > 0, tension == loads.after);

        const std::unique_ptr<LinearSolverMethod> solver =
          make_iterative_solver({});
        solver->analyse(*system.matrix, *system.unknowns);
        ASSERT_EQ(solver->factorize(*system.matrix),
                  FactorizationOutcome::done);
        const auto at_least = solver->n_negative_at_least();
        ASSERT_TRUE(at_least);
        EXPECT_EQ(*at_least > 0, n_negative > 0);
        EXPECT_LE(*at_least, n_negative);
      }
}

TEST(IterativeSolver, UnknownStability)
{
  BeamOptions options;
  options.follower = 3.;
  const BeamSystem unsymmetric(2, plane, options);
  const BeamSystem symmetric(2, star_lattice(2, {{24, 24, 1}}));
  SolverParameters incomplete;
  incomplete.preconditioner = "ilu";
  for (const auto &[system, parameters] :
       {std::make_pair(&unsymmetric, SolverParameters()),
        {&symmetric, incomplete}})
    {
      const std::unique_ptr<LinearSolverMethod> solver =
        make_iterative_solver(parameters);
      solver->analyse(*system->matrix, *system->unknowns);
      ASSERT_EQ(solver->factorize(*system->matrix), FactorizationOutcome::done);
      EXPECT_FALSE(solver->n_negative_at_least());
    }
}

TEST(IterativeSolver, OneAnalysisServesChangingEntries)
{
  BeamSystem                                system(2, plane);
  const std::unique_ptr<LinearSolverMethod> solver =
    make_iterative_solver(accurate());
  solver->analyse(*system.matrix, *system.unknowns);
  const std::vector<double> b = system.loads(), x = solve(*solver, system, b);
  for (double &entry : system.matrix->entries)
    entry *= 4;
  const std::vector<double> y    = solve(*solver, system, b);
  double                    size = 0;
  for (const double value : x)
    size = std::max(size, std::abs(value));
  for (unsigned int i = 0; i < x.size(); ++i)
    if (system.unknowns->kinds[i] == UnknownKind::translation)
      {
        EXPECT_NEAR(y[i], x[i] / 4, 1e-9 * size);
      }
}

TEST(IterativeSolver, BadMatricesAreReported)
{
  BeamSystem                                system(2, plane);
  const std::unique_ptr<LinearSolverMethod> solver = make_iterative_solver({});
  solver->analyse(*system.matrix, *system.unknowns);
  if (system.layout->rank() == 0)
    system.matrix->entries[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solver->factorize(*system.matrix),
            FactorizationOutcome::not_finite);

  std::fill(system.matrix->entries.begin(), system.matrix->entries.end(), 0.);
  EXPECT_EQ(solver->factorize(*system.matrix), FactorizationOutcome::singular);
}

TEST(IterativeSolver, FailuresAreReported)
{
  const BeamSystem system(
    2,
    star_lattice(2, {{n_for_two_levels, n_for_two_levels, 1}}));
  SolverParameters parameters;
  parameters.maximum_iterations = 3;
  const std::unique_ptr<LinearSolverMethod> solver =
    make_iterative_solver(parameters);
  solver->analyse(*system.matrix, *system.unknowns);
  ASSERT_EQ(solver->factorize(*system.matrix), FactorizationOutcome::done);
  std::vector<double> x      = system.loads();
  std::string         reason = solver->solve(x.data());
  EXPECT_NE(reason.find("in 3 iterations"), std::string::npos) << reason;
  EXPECT_NE(reason.find("Maximum iterations = 3"), std::string::npos) << reason;

  x[x.size() / 2] = std::numeric_limits<double>::infinity();
  reason          = solver->solve(x.data());
  EXPECT_NE(reason.find("not finite"), std::string::npos) << reason;
}

TEST(JointElimination, CompressedStrutsMakeNegativeEigenvalues)
{
  BeamOptions options;
  options.tension = -100.;
  const BeamSystem system(2, plane, options);
  JointElimination elimination(*system.matrix, *system.unknowns);
  ASSERT_TRUE(elimination.factorize(*system.matrix));
  EXPECT_GT(system.layout->sum(elimination.n_negative()), 0.);
}
