#include <auxfem/output/output_folder.h>

#include <gtest/gtest.h>

using namespace auxfem;

TEST(FirstRank, RunsOnOneRank)
{
  unsigned int runs = 0;
  on_first_rank(MPI_COMM_WORLD, [&]() { ++runs; });
  EXPECT_EQ(dealii::Utilities::MPI::sum(runs, MPI_COMM_WORLD), 1u);
}

TEST(FirstRank, FailureReachesAllRanks)
{
  for (int i = 0; i < 2; ++i)
    try
      {
        on_first_rank(MPI_COMM_WORLD,
                      []() { throw InputError("no such folder"); });
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_STREQ(error.what(), "no such folder");
      }
  EXPECT_THROW(on_first_rank(MPI_COMM_WORLD,
                             []() { throw ComputationError("disk full"); }),
               ComputationError);
}
