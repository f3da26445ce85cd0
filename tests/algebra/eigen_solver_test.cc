#include <auxfem/algebra/eigen_solver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;

namespace
{
  /**
   * Unknowns in pairs with K = [k_i, 1; 1, 2] and M = [1, 0; 0, 0]: each pair
   * has the eigenvalue k_i - 1/2 with the vector (1, -1/2). The second and
   * third eigenvalues are equal.
   */
  class Pairs
  {
  public:
    static constexpr unsigned int n_pairs = 100;

    explicit Pairs(const MPI_Comm communicator)
      : layout(communicator, n_owned(communicator), {})
    {}

    static double stiffness(const unsigned int pair)
    {
      return 0.5 + (pair == 2 ? 2. : pair + 1.);
    }

    ShiftedEigenproblem problem(const double shift)
    {
      return {layout,
              shift,
              [this](const double *x, double *y) {
                for (unsigned int i = 0; i < layout.n_owned(); i += 2)
                  {
                    y[i]     = x[i];
                    y[i + 1] = 0;
                  }
              },
              [this, shift](double *x) {
                for (unsigned int i = 0; i < layout.n_owned(); i += 2)
                  {
                    const double k = stiffness(layout.global(i) / 2) - shift,
                                 a = x[i], b = x[i + 1], d = 2 * k - 1;
                    x[i]     = (2 * a - b) / d;
                    x[i + 1] = (k * b - a) / d;
                  }
                return true;
              },
              n_pairs};
    }

    const UnknownLayout layout;

  private:
    /** Number of owned unknowns, in whole pairs. */
    static unsigned int n_owned(const MPI_Comm communicator)
    {
      const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(
                           communicator),
                         rank = dealii::Utilities::MPI::this_mpi_process(
                           communicator);
      return 2 * (n_pairs * (rank + 1) / n_ranks - n_pairs * rank / n_ranks);
    }
  };

  using Method = Eigenpairs (*)(const ShiftedEigenproblem &, unsigned int);

  class EigenSolver : public ::testing::TestWithParam<Method>
  {};
} // namespace

TEST_P(EigenSolver, FindsTheNearestToTheShift)
{
  for (const double shift : {-0.1, 10.2})
    {
      Pairs            pairs(MPI_COMM_WORLD);
      const Eigenpairs found = GetParam()(pairs.problem(shift), 6);
      EXPECT_EQ(found.failure_reason, "");
      ASSERT_EQ(found.pairs.size(), 6u);
      std::vector<double> values;
      for (const Eigenpair &pair : found.pairs)
        {
          values.push_back(pair.value);
          for (unsigned int i = 0; i < pair.vector.size(); i += 2)
            EXPECT_NEAR(pair.vector[i + 1], -pair.vector[i] / 2, 1e-10);
        }
      std::sort(values.begin(), values.end());
      const std::vector<double> exact = shift < 0
        ? std::vector<double>{1, 2, 2, 4, 5, 6}
        : std::vector<double>{8, 9, 10, 11, 12, 13};
      for (unsigned int i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(values[i], exact[i], 1e-10);
    }
}

TEST_P(EigenSolver, ReportsAFailedSolution)
{
  Pairs               pairs(MPI_COMM_WORLD);
  ShiftedEigenproblem problem = pairs.problem(-0.1);
  problem.solve               = [](double               */*x*/) { return false; };
  EXPECT_EQ(GetParam()(problem, 6).failure_reason, "a linear solution failed");
}

INSTANTIATE_TEST_SUITE_P(Methods,
                         EigenSolver,
                         ::testing::Values(&krylov_eigenpairs,
                                           &dense_eigenpairs));

TEST(NearestEigenpairs, AreSortedAndOfUnitLength)
{
  Pairs            pairs(MPI_COMM_WORLD);
  const Eigenpairs found = nearest_eigenpairs(pairs.problem(10.2), 5);
  ASSERT_EQ(found.pairs.size(), 5u);
  for (unsigned int i = 0; i < 5; ++i)
    {
      EXPECT_NEAR(found.pairs[i].value, 8 + i, 1e-10);
      double square = 0;
      for (unsigned int k = 0; k < found.pairs[i].vector.size(); k += 2)
        square += std::pow(found.pairs[i].vector[k], 2);
      EXPECT_NEAR(pairs.layout.sum(square), 1, 1e-12);
    }
}

TEST(SymmetricEigenvalues, AreAscending)
{
  // Eigenvalues of the chain with fixed ends: 2 - 2 cos(j pi / (n + 1)).
  constexpr unsigned int     n = 7;
  dealii::FullMatrix<double> chain(n, n);
  for (unsigned int i = 0; i < n; ++i)
    {
      chain(i, i) = 2;
      if (i > 0)
        chain(i, i - 1) = chain(i - 1, i) = -1;
    }
  const std::vector<double> values = symmetric_eigenvalues(chain);
  ASSERT_EQ(values.size(), n);
  for (unsigned int j = 1; j <= n; ++j)
    EXPECT_NEAR(values[j - 1],
                2 - 2 * std::cos(j * std::acos(-1.) / (n + 1)),
                1e-14);
}
