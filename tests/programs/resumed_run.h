#ifndef auxfem_tests_programs_resumed_run_h
#define auxfem_tests_programs_resumed_run_h

#include <support/run_program.h>

namespace auxfem
{
  namespace testing_support
  {
    /** Runs that end early and are gone on with, in `out`, beside one that is
     * not, in `whole`. */
    class ResumedRun : public ProgramTest
    {
    protected:
      ResumedRun()
      {
        // Takes some tenths of a second.
        write("scene.prm",
              replaced(replaced(replaced(data_text("star.prm"),
                                         "set End time  = 1 ms",
                                         "set End time  = " + end),
                                "set Time step = 20 us",
                                "set Time step = 0.0000152587890625"),
                       "set Force y = -4e3 * t",
                       "set Force y = -0.3 * sin(1000 * t)") +
                // A decision would depend on the end time.
                "subsection Effects\n  set Large rotation = on\nend\n");
      }

      /** 5 / 2^8, 2 / 2^8 and 3 / 2^8 s: 2^-16 s, the step, divides them
       * without round-off. */
      inline static const std::string end = "0.01953125", early = "0.0078125",
                                      later = "0.01171875";

      /** Arguments of a run into `out`. */
      static Words begin()
      {
        return {"scene.prm", "--output", "out"};
      }

      static Words go_on(const Words &further = {})
      {
        Words words = {"--resume", "out"};
        words.insert(words.end(), further.begin(), further.end());
        return words;
      }

      /** Runs auxfem on @p n_ranks, of which the last is killed at @p seconds
       * after a checkpoint. */
      ProgramRun killed(const Words       &arguments,
                        const unsigned int n_ranks,
                        const std::string &seconds) const
      {
        std::string command = "'" AUXFEM_EXECUTABLE "'";
        for (const std::string &argument : arguments)
          command += " '" + argument + "'";
        write("start.sh",
              "[ ${OMPI_COMM_WORLD_RANK:-0} = " + std::to_string(n_ranks - 1) +
                " ] && echo $$ > pid\nexec " + command + "\n");
        // Open MPI would leave the others two seconds to come to an end.
        const std::string launcher = n_ranks == 1
          ? std::string("sh")
          : "OMPI_MCA_odls_base_sigkill_timeout=0 " AUXFEM_MPIRUN " -n " +
            std::to_string(n_ranks) + " sh";
        return run_program(
          {"sh",
           "-c",
           "mkdir -p out; touch mark; " + launcher +
             " start.sh & run=$!; while kill -0 $run 2>/dev/null && ! find out "
             "-name 'checkpoint_?' -newer mark | grep -q .; do sleep 0.01; done; "
             "sleep " +
             seconds + "; kill -9 $(cat pid); wait $run"});
      }

      bool has_checkpoint() const
      {
        return std::filesystem::exists(path("out/checkpoint_a"));
      }

      /** Kills a run on so many ranks some times, and lets it come to its end.
       */
      void kill_and_go_on(const unsigned int n_ranks) const
      {
        unsigned int n_killed = 0;
        Words        words    = begin();
        // A third of what the run takes where it is quick.
        for (const char *seconds : {"0", "0.03", "0.01", "0.05", "0.02"})
          {
            // It takes long to start and to end several ranks.
            if (n_ranks > 1 && n_killed == 2)
              break;
            n_killed += killed(words, n_ranks, seconds).exit_code != 0 ? 1 : 0;
            words = go_on();
          }
        const ProgramRun run = n_ranks == 1 ? start_auxfem(go_on())
                                            : run_auxfem_on(n_ranks, go_on());
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        EXPECT_EQ(n_killed, n_ranks > 1 ? 2u : 5u);
      }

      /** Starts a run that gets a signal after some rows. */
      void end_by_signal() const
      {
        const ProgramRun ended = run_program(
          {"sh",
           "-c",
           "'" AUXFEM_EXECUTABLE
           "' scene.prm --output out & run=$!; until [ -e "
           "out/checkpoint_a ] && [ $(wc -l < out/history.csv) -gt 5 ]; do sleep "
           "0.01; done; kill -TERM $run; wait $run"});
        ASSERT_EQ(ended.exit_code, 128 + 15);
        expect_contains(ended.output, {"auxfem --resume out"});
      }

      void expect_that_of_the_whole_run(
        const Words &files  = {"history.csv", "solution.pvd"},
        const Words &counts = {"steps",
                               "newton_iterations",
                               "factorizations"}) const
      {
        // Not compared as texts, which would fill the screen.
        for (const std::string &file : files)
          EXPECT_TRUE(read_text(path("out/") + file) ==
                      read_text(path("whole/") + file))
            << file;
        for (const std::string &name : counts)
          EXPECT_EQ(summary(name), summary(name, "whole")) << name;
        EXPECT_EQ(summary("exit_state"), "completed");
      }

      /** Equal except for round-off and Newton's residual: a run to
       * another end, or on other ranks, has its checkpoints at other steps. */
      void expect_about_that_of_the_whole_run() const
      {
        expect_that_of_the_whole_run({}, {"steps"});
        const Table whole_run = history("whole"), resumed = history();
        ASSERT_EQ(whole_run.n_rows, resumed.n_rows);
        for (const std::string name :
             {"top.uy", "top.vy", "apex.phi", "strain"})
          for (unsigned int i = 0; i < whole_run.n_rows; ++i)
            EXPECT_NEAR(whole_run[name][i],
                        resumed[name][i],
                        1e-7 * largest_size(whole_run[name]))
              << name;
      }
    };

    /** Resumed paths of equilibria, which buckle on their way. */
    class ResumedPath : public ResumedRun
    {
    protected:
      ResumedPath()
      {
        write("scene.prm",
              replaced(replaced(replaced(prm_text("path.prm"),
                                         "set Cells x       = 5",
                                         "set Cells x       = 2"),
                                "set Cells y       = 4",
                                "set Cells y       = 2"),
                       "set Largest displacement = 25 mm",
                       "set Resolution = 1e-4\n set Largest displacement = " +
                         end));
      }

      inline static const std::string end = "12 mm", early = "2 mm";

      void expect_that_of_the_whole_path() const
      {
        expect_that_of_the_whole_run({"history.csv",
                                      "solution.pvd",
                                      "singular_points.csv",
                                      "singular_solution.pvd"});
        for (const char *name : {"arc_length", "load_factor"})
          EXPECT_EQ(summary(name), summary(name, "whole")) << name;
        EXPECT_EQ(count_lines(read_text(path("out/singular_points.csv"))), 2u);
      }

      void run_whole(const unsigned int n_ranks) const
      {
        const Words words = {"scene.prm", "--output", "whole"};
        ASSERT_EQ((n_ranks == 1 ? run_auxfem(words)
                                : run_auxfem_on(n_ranks, words))
                    .exit_code,
                  0);
      }
    };
  } // namespace testing_support
} // namespace auxfem

#endif
