#include <support/graphics_series.h>
#include <support/scene_text.h>

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

  /** A damped steel bar of 1 m and 10 mm, clamped at its left end. */
  SceneText damped_bar()
  {
    return SceneText()
      .set("Analysis", "frequency response")
      .frame("0 0; 1 0", "0 1")
      .rectangle("steel", "10 mm", "10 mm", {"210 GPa", 7850})
      .set("Sections/steel/Mass-proportional damping", 2)
      .set("Frequency response/Spacing", "linear")
      .time(1, 1);
  }

  TEST_F(FrequencyResponseProgram, ElementsMeetTheToleranceByDefault)
  {
    write("bar.prm",
          damped_bar()
            .support("A", "0", "clamp")
            .prescribe("B", "1", {"0", "0", "0"})
            .set("Frequency response/Lowest frequency", 50)
            .set("Frequency response/Highest frequency", 60)
            .set("Frequency response/Number", 101)
            .set("Loads/q/Type", "line")
            .set("Loads/q/Struts", "all")
            .set("Loads/q/Force per length y", 1));
    const ProgramRun run =
      run_auxfem({path("bar.prm"), "--output", path("out")});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output, {"Verdict: sound", "errors of the elements"});
    const Table  table(path("out/frequency_response.csv"));
    unsigned int highest = 0;
    for (unsigned int i = 0; i < table.n_rows; ++i)
      if (table["A.ry.amplitude"][i] > table["A.ry.amplitude"][highest])
        highest = i;
    // (4.73)^2 / (2 pi) sqrt(EI / rho A) = 53.2 Hz, less for shear and rotary
    // inertia.
    EXPECT_NEAR(table["frequency"][highest], 53.15, 0.11);
  }

  TEST_F(FrequencyResponseProgram, ConstantMotionsAreAmplitudes)
  {
    std::vector<double> amplitudes;
    for (const char *motion : {"1 mm", "0.001 * t"})
      {
        write("bar.prm",
              damped_bar()
                .prescribe("A", "0", {"0", motion, "0"})
                .set("Frequency response/Lowest frequency", 5)
                .set("Frequency response/Highest frequency", 6)
                .set("Frequency response/Number", 2)
                .probe("end", "1"));
        const ProgramRun run =
          run_auxfem({path("bar.prm"), "--output", path("out"), "--force"});
        ASSERT_EQ(run.exit_code, 0) << run.errors;
        amplitudes.push_back(
          Table(path("out/frequency_response.csv"))["end.uy.amplitude"][0]);
      }
    EXPECT_GT(amplitudes[0], 1e-3);
    EXPECT_NEAR(amplitudes[0], amplitudes[1], 1e-9 * amplitudes[1]);
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
