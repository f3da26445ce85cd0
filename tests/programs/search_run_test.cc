#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;

  class SearchRun : public ProgramTest
  {};

  TEST_F(SearchRun, ShowsItsProgressBeforeThatOfTheRun)
  {
    write("scene.prm", data_text("arch.prm"));
    const ProgramRun run = run_auxfem(
      {"scene.prm", "--set", "Discretization/Order=auto", "--output", "out"});
    EXPECT_EQ(run.exit_code, 0) << run.output << run.errors;
    const std::size_t search   = run.output.find("Search for the elements"),
                      progress = run.output.find("  t "),
                      overview = run.output.find("Joints");
    ASSERT_NE(search, std::string::npos) << run.output;
    EXPECT_LT(search, progress);
    EXPECT_LT(progress, overview);
  }
} // namespace
