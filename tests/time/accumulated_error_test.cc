#include <auxfem/time/step_error.h>

#include <gtest/gtest.h>

using namespace auxfem;

TEST(AccumulatedError, AddsUpErrorsOfLargeMotions)
{
  AccumulatedError error;
  for (unsigned int i = 0; i < 10; ++i)
    error.add({0.1, 0.1, LocalError::Oscillation{3., 100.}});
  EXPECT_NEAR(error.total(), 1, 1e-12);
}

TEST(AccumulatedError, ErrorOfVibrationsIsAtMostTwiceTheAmplitude)
{
  AccumulatedError error;
  for (unsigned int i = 0; i < 1000; ++i)
    error.add({0.1, 1e-4, LocalError::Oscillation{1e6, 0.2}});
  EXPECT_NEAR(error.total(), 1000 * 1e-4 + 2 * 0.2, 1e-12);
  // Another frequency has a bound of its own.
  for (unsigned int i = 0; i < 1000; ++i)
    error.add({0.1, 1e-4, LocalError::Oscillation{1e3, 0.3}});
  EXPECT_NEAR(error.total(), 2000 * 1e-4 + 2 * (0.2 + 0.3), 1e-12);
}

TEST(AccumulatedError, HasNoBoundWithoutAKnownOscillation)
{
  AccumulatedError error;
  for (unsigned int i = 0; i < 10; ++i)
    error.add({0.1, 0.});
  EXPECT_NEAR(error.total(), 1, 1e-12);
}

TEST(AccumulatedError, IsRestored)
{
  AccumulatedError error, restored;
  error.add({0.1, 0.01});
  error.add({0.2, 0.01, LocalError::Oscillation{10., 0.01}});
  const UnknownLayout layout(MPI_COMM_SELF, 1, {});
  CheckpointData      records;
  CheckpointArchive   saving = CheckpointArchive::saving(records, layout);
  error.serialize("error", saving);
  CheckpointArchive restoring = CheckpointArchive::restoring(records, layout);
  restored.serialize("error", restoring);
  for (AccumulatedError *const each : {&error, &restored})
    each->add({0.2, 0.01, LocalError::Oscillation{10., 0.03}});
  EXPECT_EQ(error.total(), restored.total());
}
