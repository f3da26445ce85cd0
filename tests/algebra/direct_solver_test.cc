#include <auxfem/algebra/direct_solver.h>

#include <algebra/distributed_matrix.h>
#include <gtest/gtest.h>
#include <support/no_more_memory.h>

#include <array>
#include <limits>

using namespace auxfem;
using namespace auxfem::testing_support;

extern "C" void dsyev_(const char *jobz,
                       const char *uplo,
                       const int  *n,
                       double     *a,
                       const int  *lda,
                       double     *w,
                       double     *work,
                       const int  *lwork,
                       int        *info);

namespace
{
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity     = std::numeric_limits<double>::infinity();

  struct Kind
  {
    std::string name;
    std::unique_ptr<DirectSolver> (*make)();
    bool solves_unsymmetric, pivots, has_inertia, counts_zeros;
  };

  const std::array<Kind, 4> kinds = {
    {{"CHOLMOD",
      [] { return make_cholmod(EliminationOrder::minimum_degree); },
      false,
      false,
      true,
      false},
     {"KLU",
      [] { return make_klu(EliminationOrder::nested_dissection); },
      true,
      true,
      false,
      false},
     {"MUMPS on the first rank",
      [] { return make_mumps(MumpsRanks::first); },
      true,
      true,
      true,
      true},
     {"MUMPS",
      [] { return make_mumps(MumpsRanks::all); },
      true,
      true,
      true,
      true}}};

  /** Eigenvalues, ascending. */
  std::vector<double> eigenvalues(const Entries &entries)
  {
    const int           n = entries.size();
    std::vector<double> a(n * n, 0.), values(n), work(10 * n);
    for (int i = 0; i < n; ++i)
      for (const auto &[j, entry] : entries[i])
        a[i + j * n] = entry;
    const int n_work = work.size();
    int       info   = 0;
    dsyev_("N",
           "L",
           &n,
           a.data(),
           &n,
           values.data(),
           work.data(),
           &n_work,
           &info);
    EXPECT_EQ(info, 0);
    return values;
  }

  Inertia inertia_by_eigenvalues(const Entries &entries)
  {
    const std::vector<double> values = eigenvalues(entries);
    const double              zero =
      1e-12 * std::max(std::abs(values.front()), std::abs(values.back()));
    Inertia result;
    for (const double value : values)
      ++(std::abs(value) < zero ? result.zero
           : value < 0          ? result.negative
                                : result.positive);
    return result;
  }

  void expect_inertia(const DirectSolver &solver, const Inertia &expected)
  {
    const auto found = solver.inertia();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->negative, expected.negative);
    EXPECT_EQ(found->zero, expected.zero);
    EXPECT_EQ(found->positive, expected.positive);
  }

  void expect_solution(DirectSolver      &solver,
                       DistributedMatrix &system,
                       const double       tolerance = 1e-12)
  {
    ASSERT_EQ(solver.factorize(system.matrix), FactorizationOutcome::done);
    const std::vector<double> b = system.right_side();
    // Solve twice: the factors must outlast a solution.
    for (unsigned int i = 0; i < 2; ++i)
      {
        std::vector<double> x = b;
        solver.solve(x.data());
        EXPECT_LT(system.residual(x, b), tolerance);
      }
  }

  FactorizationOutcome outcome(const Kind              &kind,
                               const DistributedMatrix &system)
  {
    const auto solver = kind.make();
    const auto result = solver->analyse(system.matrix);
    return result == FactorizationOutcome::done
      ? solver->factorize(system.matrix)
      : result;
  }

  FactorizationOutcome outcome(const Kind &kind, const Entries &entries)
  {
    return outcome(kind, DistributedMatrix(entries));
  }

  Entries definite(const int n, std::mt19937 &random)
  {
    return random_entries(n, 6, 12., random);
  }

  Entries indefinite(const int n, std::mt19937 &random)
  {
    Entries                          entries = random_entries(n, 6, 0., random);
    std::uniform_real_distribution<> entry(-2., 2.);
    for (int i = 0; i < n; ++i)
      add(entries, i, i, entry(random));
    return entries;
  }

  /**
   * Definite matrix with multipliers of constraints on two unknowns each; the
   * multipliers come first.
   */
  Entries
  with_multipliers(const int n, const int n_conditions, std::mt19937 &random)
  {
    const Entries stiffness = definite(n, random);
    Entries       entries(n + n_conditions);
    for (int i = 0; i < n; ++i)
      for (const auto &[j, entry] : stiffness[i])
        entries[n_conditions + i][n_conditions + j] = entry;
    for (int i = 0; i < n_conditions; ++i)
      {
        add(entries, i, i, 0.);
        add(entries, i, n_conditions + 2 * i, 1.);
        add(entries, i, n_conditions + 2 * i + 1, -0.5);
      }
    return entries;
  }

  Entries unsymmetric(const int n, std::mt19937 &random)
  {
    Entries                          entries = random_entries(n, 6, 3., random);
    std::uniform_real_distribution<> factor(-1., 1.);
    for (int i = 0; i < n; ++i)
      for (auto &[j, entry] : entries[i])
        if (j != i)
          entry *= factor(random);
    return entries;
  }
} // namespace

TEST(DirectSolver, AllSolveDefiniteMatrices)
{
  std::mt19937         random(1);
  std::vector<Entries> systems = {{{{0, 4.}}}};
  for (const int n : {2, 3, 10, 60, 200})
    systems.push_back(definite(n, random));
  systems.push_back(supported_grid(10, 1e2));
  for (const Entries &entries : systems)
    for (const Kind &kind : kinds)
      {
        SCOPED_TRACE(kind.name + ", " + std::to_string(entries.size()));
        DistributedMatrix system(entries);
        const auto        solver = kind.make();
        ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
        expect_solution(*solver, system);
        if (kind.has_inertia)
          expect_inertia(*solver, {0, 0, entries.size()});
        else
          EXPECT_FALSE(solver->inertia());
        EXPECT_GE(system.layout.sum(solver->memory()), entries.size() * 8.);
      }
}

TEST(DirectSolver, LatticesThatMetisOrdersAreSolved)
{
  const Entries     entries = supported_grid(45, 1e3);
  DistributedMatrix system(entries);
  for (const Kind &kind : kinds)
    {
      SCOPED_TRACE(kind.name);
      const auto solver = kind.make();
      ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
      expect_solution(*solver, system);
      // Less than a tenth of the square.
      EXPECT_LT(system.layout.sum(solver->memory()),
                0.1 * 8 * entries.size() * entries.size());
    }
}

TEST(DirectSolver, InertiaAgreesWithEigenvalues)
{
  std::mt19937 random(2);
  unsigned int n_without_pivoting = 0;
  for (unsigned int trial = 0; trial < 20; ++trial)
    {
      const Entries entries  = trial % 2 == 0
         ? indefinite(20 + 5 * trial, random)
         : with_multipliers(30 + 5 * trial, 3 + trial / 2, random);
      const Inertia expected = inertia_by_eigenvalues(entries);
      ASSERT_EQ(expected.zero, 0u);
      ASSERT_GT(expected.negative, 0u);
      DistributedMatrix system(entries);
      for (const Kind &kind : kinds)
        {
          SCOPED_TRACE(kind.name + ", trial " + std::to_string(trial));
          const auto solver = kind.make();
          ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
          if (!kind.pivots &&
              solver->factorize(system.matrix) ==
                FactorizationOutcome::singular)
            {
              EXPECT_FALSE(solver->inertia());
              continue;
            }
          n_without_pivoting += !kind.pivots;
          expect_solution(*solver, system, kind.pivots ? 1e-11 : 1e-8);
          if (kind.has_inertia)
            expect_inertia(*solver, expected);
        }
    }
  // Without pivoting, most matrices without multipliers are solved.
  EXPECT_GE(n_without_pivoting, 8u);
}

TEST(DirectSolver, ZeroEigenvaluesAreCounted)
{
  for (const int n : {2, 3, 4})
    {
      // Three rigid-body modes and two identical constraints.
      Entries   entries = free_grid(n, 50.);
      const int m       = entries.size();
      entries.resize(m + 2);
      for (int i = m; i < m + 2; ++i)
        {
          add(entries, i, i, 0.);
          add(entries, i, 3, 1.);
          add(entries, i, 7, 1.);
        }
      const Inertia expected = inertia_by_eigenvalues(entries);
      ASSERT_EQ(expected.zero, 3u);
      DistributedMatrix system(entries);
      for (const Kind &kind : kinds)
        {
          SCOPED_TRACE(kind.name + ", " + std::to_string(n));
          const auto solver = kind.make();
          ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
          EXPECT_EQ(solver->factorize(system.matrix),
                    FactorizationOutcome::singular);
          if (kind.counts_zeros)
            expect_inertia(*solver, expected);
          else
            EXPECT_FALSE(solver->inertia());
        }
    }
}

TEST(DirectSolver, UnsymmetricMatricesAreSolved)
{
  std::mt19937 random(3);
  for (const int n : {2, 7, 50, 300})
    {
      DistributedMatrix system(unsymmetric(n, random), false);
      for (const Kind &kind : kinds)
        if (kind.solves_unsymmetric)
          {
            SCOPED_TRACE(kind.name + ", " + std::to_string(n));
            const auto solver = kind.make();
            ASSERT_EQ(solver->analyse(system.matrix),
                      FactorizationOutcome::done);
            expect_solution(*solver, system);
            EXPECT_FALSE(solver->inertia());
          }
    }
}

TEST(DirectSolver, FreeLatticesAreSingular)
{
  for (const int n : {2, 5, 12, 60})
    for (const double slenderness : {1., 1e2, 1e4})
      {
        const DistributedMatrix system(free_grid(n, slenderness));
        for (const Kind &kind : kinds)
          {
            SCOPED_TRACE(kind.name + ", " + std::to_string(n) +
                         ", slenderness " + std::to_string(slenderness));
            EXPECT_EQ(outcome(kind, system), FactorizationOutcome::singular);
          }
      }
}

TEST(DirectSolver, SlenderSupportedLatticesAreNotSingular)
{
  for (const int n : {2, 5, 12})
    for (const double slenderness : {1., 1e2, 1e4})
      for (const Kind &kind : kinds)
        {
          SCOPED_TRACE(kind.name + ", " + std::to_string(n) + ", slenderness " +
                       std::to_string(slenderness));
          EXPECT_EQ(outcome(kind, supported_grid(n, slenderness)),
                    FactorizationOutcome::done);
        }
}

TEST(DirectSolver, ARowOfZerosIsSingular)
{
  std::mt19937 random(4);
  Entries      entries = definite(20, random);
  for (auto &[j, entry] : entries[7])
    entry = entries[j][7] = 0;
  for (const Kind &kind : kinds)
    {
      SCOPED_TRACE(kind.name);
      EXPECT_EQ(outcome(kind, entries), FactorizationOutcome::singular);
      EXPECT_EQ(outcome(kind, {{{0, 0.}}}), FactorizationOutcome::singular);
    }
}

TEST(DirectSolver, UnitsDoNotMatter)
{
  std::mt19937 random(5);
  Entries      entries = with_multipliers(60, 5, random);
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (auto &[j, entry] : entries[i])
      entry *=
        std::pow(10., 7. * std::cos(i)) * std::pow(10., 7. * std::cos(j));
  DistributedMatrix system(entries);
  for (const Kind &kind : kinds)
    if (kind.pivots)
      {
        SCOPED_TRACE(kind.name);
        const auto solver = kind.make();
        ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
        EXPECT_EQ(solver->factorize(system.matrix), FactorizationOutcome::done);
        if (kind.has_inertia)
          expect_inertia(*solver, {5, 0, 60});
      }
}

TEST(DirectSolver, WithoutPivotingTinyPivotsAreRefused)
{
  for (const double tiny : {0., 1e-30, 1e-12, 1e-9})
    {
      const Entries entries = {{{0, tiny}, {1, 1.}}, {{0, 1.}, {1, tiny}}};
      for (const Kind &kind : kinds)
        {
          SCOPED_TRACE(kind.name + ", " + std::to_string(tiny));
          EXPECT_EQ(outcome(kind, entries),
                    kind.pivots ? FactorizationOutcome::done
                                : FactorizationOutcome::singular);
        }
    }
}

TEST(DirectSolver, NonFiniteEntriesAreDetectedOnAllRanks)
{
  std::mt19937  random(6);
  const Entries good = definite(30, random);
  for (const double value : {not_a_number, infinity, -infinity})
    for (const int row : {0, 29})
      {
        DistributedMatrix system(good), bad(good);
        // On one rank only.
        if (const int local = bad.layout.local(row); bad.layout.is_owned(local))
          bad.matrix.entries[bad.matrix.first[local]] = value;
        for (const Kind &kind : kinds)
          {
            SCOPED_TRACE(kind.name);
            const auto solver = kind.make();
            ASSERT_EQ(solver->analyse(bad.matrix), FactorizationOutcome::done);
            EXPECT_EQ(solver->factorize(bad.matrix),
                      FactorizationOutcome::not_finite);
            expect_solution(*solver, system);
          }
      }
}

TEST(DirectSolver, RanksMayHaveNoRows)
{
  std::mt19937      random(7);
  DistributedMatrix system(definite(30, random),
                           true,
                           Spread::not_on_last_rank);
  DistributedMatrix one({{{0, 4.}}}), none({});
  for (const Kind &kind : kinds)
    {
      SCOPED_TRACE(kind.name);
      const auto solver = kind.make();
      ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
      expect_solution(*solver, system);
      ASSERT_EQ(solver->analyse(one.matrix), FactorizationOutcome::done);
      expect_solution(*solver, one);
      ASSERT_EQ(solver->analyse(none.matrix), FactorizationOutcome::done);
      expect_solution(*solver, none);
      if (kind.has_inertia)
        expect_inertia(*solver, {0, 0, 0});
    }
}

TEST(DirectSolver, FactorizesNewEntriesAndPatterns)
{
  std::mt19937  random(8);
  const Entries entries = indefinite(40, random);
  const Entries other   = definite(55, random);
  for (const Kind &kind : kinds)
    {
      SCOPED_TRACE(kind.name);
      const auto        solver = kind.make();
      DistributedMatrix system(definite(40, random));
      ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
      expect_solution(*solver, system);
      // Old pivots must not be kept if they are inaccurate.
      for (const double factor : {1., 1e-3, 1e-6, -1., 1e6})
        {
          for (unsigned int row = 0; row < system.layout.n_owned(); ++row)
            for (std::size_t i = system.matrix.first[row];
                 i < system.matrix.first[row + 1];
                 ++i)
              if (system.matrix.columns[i] == static_cast<int>(row))
                system.matrix.entries[i] *= factor;
          if (kind.pivots)
            expect_solution(*solver, system, 1e-11);
        }
      // A singular matrix must not affect the next one.
      const std::vector<double> before = system.matrix.entries;
      std::fill(system.matrix.entries.begin(), system.matrix.entries.end(), 0.);
      EXPECT_EQ(solver->factorize(system.matrix),
                FactorizationOutcome::singular);
      system.matrix.entries = before;
      if (kind.pivots)
        expect_solution(*solver, system, 1e-11);

      DistributedMatrix other_system(other);
      ASSERT_EQ(solver->analyse(other_system.matrix),
                FactorizationOutcome::done);
      expect_solution(*solver, other_system);
    }
}

TEST(DirectSolver, LackOfMemoryIsReported)
{
#ifdef AUXFEM_SANITIZERS
  GTEST_SKIP() << "The address sanitizer takes all addresses there are.";
#endif
  DistributedMatrix system(supported_grid(25, 10.));
  const auto        without_memory_on = [&](const unsigned int rank,
                                     const auto        &action) {
    std::unique_ptr<NoMoreMemory> no_more_memory;
    if (system.layout.rank() == rank)
      no_more_memory = std::make_unique<NoMoreMemory>();
    return action();
  };
  for (const Kind &kind : kinds)
    for (const unsigned int rank : {0u, system.layout.n_ranks() - 1})
      {
        SCOPED_TRACE(kind.name + ", rank " + std::to_string(rank));
        const auto solver   = kind.make();
        const auto analysis = without_memory_on(rank, [&] {
          return solver->analyse(system.matrix);
        });
        EXPECT_EQ(analysis, FactorizationOutcome::out_of_memory);
        ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
        // Only MUMPS has factors on other ranks than the first.
        const auto factorization =
          without_memory_on(kind.name == "MUMPS" ? rank : 0,
                            [&] { return solver->factorize(system.matrix); });
        EXPECT_EQ(factorization, FactorizationOutcome::out_of_memory);
        ASSERT_EQ(solver->analyse(system.matrix), FactorizationOutcome::done);
        expect_solution(*solver, system);
      }
}
