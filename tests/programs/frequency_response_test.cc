#include <support/graphics_series.h>

namespace
{
  using namespace auxfem::testing_support;

  class FrequencyResponseProgram : public ProgramTest
  {
  protected:
    ProgramRun run_response(const Words &overrides = {}) const
    {
      return run_shipped("frequency-response.prm", overrides);
    }
  };

  TEST_F(FrequencyResponseProgram, LeavesAmplitudesAndPhases)
  {
    const ProgramRun run =
      run_response({"Frequency response/Lowest frequency=60 Hz",
                    "Frequency response/Highest frequency=90 Hz",
                    "Frequency response/Number=31",
                    "Frequency response/Spacing=linear"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Table table(path("out/frequency_response.csv"));
    ASSERT_EQ(table.n_rows, 31u);
    unsigned int highest = 0;
    for (unsigned int i = 0; i < table.n_rows; ++i)
      {
        EXPECT_NEAR(table["frequency"][i], 60. + i, 1e-9);
        EXPECT_LT(table["residual"][i], 1e-6);
        if (table["top.ux.amplitude"][i] > table["top.ux.amplitude"][highest])
          highest = i;
      }
    // Near the first natural frequency, with the phase of a resonance.
    EXPECT_NEAR(table["frequency"][highest], 77, 1.1);
    EXPECT_GT(table["top.ux.amplitude"][highest], 20e-4);
    EXPECT_GT(table["top.ux.phase"][0], -0.1);
    EXPECT_LT(table["top.ux.phase"].back(), -3);
    EXPECT_NE(run.output.find("top.ux"), std::string::npos);
  }

  TEST_F(FrequencyResponseProgram, StaticsAndEmptyBandsAreRefused)
  {
    const ProgramRun statics = run_response({"Time/Scheme=static"});
    EXPECT_EQ(statics.exit_code, 1);
    EXPECT_NE(statics.errors.find("needs inertia"), std::string::npos)
      << statics.errors;
    const ProgramRun band =
      run_response({"Frequency response/Highest frequency=10 Hz"});
    EXPECT_EQ(band.exit_code, 1);
    EXPECT_NE(band.errors.find("above Lowest frequency"), std::string::npos)
      << band.errors;
  }
} // namespace
