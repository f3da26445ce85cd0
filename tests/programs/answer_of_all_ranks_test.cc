#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>
#include <programs/one_message.h>

namespace
{
  using namespace auxfem::testing_support;

  /**
   * The program inside the ranks of this test, which start once for all of its
   * runs; each rank has a folder of its own.
   */
  class AnswerOfAllRanks : public ProgramTest
  {
  protected:
    AnswerOfAllRanks()
      : ProgramTest(".of_rank_" +
                    std::to_string(
                      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)))
    {}

    /** The output of all ranks together, and the exit code of this one. */
    ProgramRun run_on_all_ranks(const Words &arguments) const
    {
      const ProgramRun mine = run_auxfem(arguments);
      ProgramRun       all  = {mine.exit_code, "", ""};
      for (const auto &[output, errors] :
           dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD,
                                              std::pair(mine.output,
                                                        mine.errors)))
        {
          all.output += output;
          all.errors += errors;
        }
      return all;
    }
  };

  TEST_F(AnswerOfAllRanks, CheckCountsTheWhole)
  {
    write("scene.prm", data_text("star.prm"));
    const ProgramRun run =
      run_on_all_ranks({"--check", "scene.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const std::string ranks =
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    for (const std::string &pattern : Words{"Joints +44\n",
                                            "Struts +48\n",
                                            "Elements +48 of order 3\n",
                                            "Connectors +4\n",
                                            "Unknowns +420, 414 of them free\n",
                                            "MPI ranks +" + ranks + "\n"})
      EXPECT_TRUE(std::regex_search(run.output, std::regex(pattern)))
        << pattern << run.output;
    EXPECT_EQ(count(run.output, "MPI ranks"), 1u);
  }



  TEST_F(AnswerOfAllRanks, IsGivenOnce)
  {
    EXPECT_EQ(count(run_on_all_ranks({"--version"}).output, "auxfem "), 1u);
    EXPECT_EQ(count(run_on_all_ranks({"--help"}).output, "Usage:"), 1u);
  }



  TEST_F(AnswerOfAllRanks, BadInputIsRefusedOnce)
  {
    write("scene.prm", data_text("star.prm"));
    write("file", "");
    expect_one_message(run_on_all_ranks({"lost.prm"}),
                       1,
                       "\"lost.prm\" cannot be opened");
    expect_one_message(run_on_all_ranks({"scene.prm", "--set", "Time/Tiem=1"}),
                       1,
                       "Time/Tiem: unknown parameter");
    expect_one_message(run_on_all_ranks({"scene.prm",
                                         "--set",
                                         "Connectors/damper/Between=3 500"}),
                       1,
                       "there is no joint 500");
    expect_one_message(run_on_all_ranks({"scene.prm", "--output", "file/out"}),
                       1,
                       "cannot be used");
    expect_one_message(run_on_all_ranks({"scene.prm",
                                         "--set",
                                         "Time/Scheme=static",
                                         "--set",
                                         "Supports/foundation/Type=roller x"}),
                       1,
                       "horizontal displacement of joint");
  }



  TEST_F(AnswerOfAllRanks, StepsThatDoNotConvergeEndAll)
  {
    write("scene.prm", data_text("star.prm"));
    expect_one_message(run_on_all_ranks(
                         {"scene.prm",
                          "--set",
                          "Output/Graphics=false",
                          "--set",
                          "Loads/hit/Force y=if(t < 81e-6, 0, -50)",
                          "--set",
                          "Newton/Maximum iterations=1",
                          "--set",
                          "Time/Smallest time step=5 us"}),
                       2,
                       "did not converge");
  }



  TEST_F(AnswerOfAllRanks, AFollowerLoadThatEndsOnOneRankEndsAll)
  {
    write("scene.prm", data_text("star.prm"));
    expect_one_message(run_on_all_ranks(
                         {"scene.prm",
                          "--set",
                          "Output/Graphics=false",
                          "--set",
                          "Time/Scheme=energy-momentum",
                          "--set",
                          "Loads/hit/Joints=nearest: 0, 0.04",
                          "--set",
                          "Loads/hit/Direction=follows the joint",
                          "--set",
                          "Loads/hit/Force y=-8 * sqrt(0.31e-3 - t)"}),
                       2,
                       "not a finite number at t = 0.0003");
  }



  TEST_F(AnswerOfAllRanks, RefusesALineLoadBesideARigidArc)
  {
    write("scene.prm", R"(
set Dimension = 3
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 1 0; 2 0; 3 0
  set Struts = 0 1; 1 2 0.3; 2 3 -0.3
end
subsection Sections
  subsection rod
    set Shape           = circle
    set Radius          = 10 mm
    set Young's modulus = 70 GPa
    set Density         = 2700 kg/m3
  end
end
subsection Rigid parts
  subsection arc
    set Struts         = 1, 2
    set Mass           = 1 kg
    set Elastic struts = clamped
  end
end
subsection Supports
  subsection clamp
    set Joints = 0
  end
end
subsection Loads
  subsection wind
    set Type               = line
    set Struts             = 1
    set Force per length z = 1
  end
end
)");
    expect_one_message(run_on_all_ranks({"scene.prm"}),
                       1,
                       "a line load on a rigid arc");
  }
} // namespace
