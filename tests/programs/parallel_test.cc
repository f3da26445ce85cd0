#include <programs/one_message.h>
#include <support/graphics_series.h>

namespace
{
  using namespace auxfem::testing_support;

  /** Whole runs on two ranks. */
  class ParallelProgram : public ProgramTest
  {
  protected:
    /** All columns of two histories agree to 1e-10 of the largest value. */
    static void expect_same(const Table &one, const Table &two)
    {
      ASSERT_EQ(one.names, two.names);
      ASSERT_EQ(one.n_rows, two.n_rows);
      for (const std::string &name : one.names)
        {
          // The balance is a small difference of energies.
          const double scale =
            one.largest(name == "balance" ? "external" : name);
          for (unsigned int i = 0; i < one.n_rows; ++i)
            EXPECT_NEAR(one[name][i], two[name][i], 1e-10 * scale)
              << name << " in row " << i;
        }
    }

    /** A push from the side, so that no column is zero by symmetry. */
    const Words lopsided = {"scene.prm",
                            "--set",
                            "Loads/hit/Force x=1e3 * t",
                            "--set",
                            "Loads/hit/Moment z=0.5 * t"};

    Words with(Words words, const Words &more) const
    {
      words.insert(words.end(), more.begin(), more.end());
      return words;
    }
  };

  TEST_F(ParallelProgram, TwoRanksComputeWhatOneDoes)
  {
    write("scene.prm", data_text("star.prm"));
    const ProgramRun one = run_auxfem(with(lopsided, {"--output", "one"}));
    const ProgramRun two =
      run_auxfem_on(2, with(lopsided, {"--output", "two"}));
    ASSERT_EQ(one.exit_code, 0) << one.errors;
    ASSERT_EQ(two.exit_code, 0) << two.errors;
    EXPECT_EQ(count(two.output, "Completed at t ="), 1u);
    expect_same(history("one"), history("two"));
    EXPECT_EQ(summary("ranks", "two"), "2");
    for (const char *key : {"elements",
                            "connectors",
                            "unknowns",
                            "free_unknowns",
                            "steps",
                            "newton_iterations"})
      EXPECT_EQ(summary(key, "one"), summary(key, "two")) << key;
  }



  TEST_F(ParallelProgram, RigidPartsAndHingesInSpaceMoveAsOnOneRank)
  {
    write("scene.prm", data_text("space-parts.prm"));
    const ProgramRun one = run_auxfem({"scene.prm", "--output", "one"});
    const ProgramRun two = run_auxfem_on(2, {"scene.prm", "--output", "two"});
    ASSERT_EQ(one.exit_code, 0) << one.errors;
    ASSERT_EQ(two.exit_code, 0) << two.errors;
    expect_same(history("one"), history("two"));
    // The body turns about every axis.
    for (const char *column : {"body.phi_x", "body.phi_y", "body.phi_z"})
      EXPECT_GT(history("one").largest(column), 1e-4) << column;
    EXPECT_EQ(summary("ranks", "two"), "2");
  }

  TEST_F(ParallelProgram, TwoRanksComputeStaticsAsOneDoes)
  {
    write("scene.prm", data_text("star.prm"));
    const Words arguments = with(lopsided,
                                 {"--set",
                                  "Time/Scheme=static",
                                  "--set",
                                  "Time/End time=0.2 ms",
                                  "--set",
                                  "Newton/Factorization=every iteration"});
    ASSERT_EQ(run_auxfem(with(arguments, {"--output", "one"})).exit_code, 0);
    ASSERT_EQ(run_auxfem_on(2, with(arguments, {"--output", "two"})).exit_code,
              0);
    const Table table = history("one");
    EXPECT_EQ(table.columns.count("kinetic"), 0u) << "nothing is in motion";
    expect_same(table, history("two"));
  }



  TEST_F(ParallelProgram, TwoRanksMoveRigidPartsAsOneDoes)
  {
    write("scene.prm", data_text("star.prm") + R"(
subsection Rigid parts
  subsection stubs
    set Struts         = stubs
    set Mass           = 0.02 g
    set Elastic struts = clamped
  end
end
)");
    const Words      arguments = {"scene.prm",
                                  "--set",
                                  "Loads/hit/Force x=1e3 * t",
                                  "--set",
                                  "Time/Scheme=generalized-alpha",
                                  "--set",
                                  "Supports/foundation/Type=pin",
                                  "--set",
                                  "Probes/stubs=rigid: stubs @ notches"};
    const ProgramRun one = run_auxfem(with(arguments, {"--output", "one"}));
    const ProgramRun two =
      run_auxfem_on(2, with(arguments, {"--output", "two"}));
    ASSERT_EQ(one.exit_code, 0) << one.errors;
    ASSERT_EQ(two.exit_code, 0) << two.errors;
    EXPECT_GT(history("one").largest("stubs.fx"), 0);
    expect_same(history("one"), history("two"));
    const GraphicsSeries parts_one(path("one/rigid_parts.pvd"),
                                   path("vtk_one"));
    const GraphicsSeries parts_two(path("two/rigid_parts.pvd"),
                                   path("vtk_two"));
    EXPECT_EQ(parts_one.datasets["segments"], parts_two.datasets["segments"]);
  }



  TEST_F(ParallelProgram, GraphicsOfTwoRanksAreWhole)
  {
    write("scene.prm", data_text("star.prm"));
    const Words arguments = with(lopsided, {"--set", "Time/End time=0.4 ms"});
    ASSERT_EQ(run_auxfem(with(arguments, {"--output", "one"})).exit_code, 0);
    ASSERT_EQ(run_auxfem_on(2, with(arguments, {"--output", "two"})).exit_code,
              0);
    for (const std::string name : {"solution", "connectors"})
      {
        const GraphicsSeries one(path("one/" + name + ".pvd"),
                                 path("vtk_one_" + name));
        const GraphicsSeries two(path("two/" + name + ".pvd"),
                                 path("vtk_two_" + name));
        ASSERT_EQ(one.datasets["time"], two.datasets["time"]);
        ASSERT_EQ(one.datasets.n_rows, 3u);
        for (unsigned int i = 0; i < 3; ++i)
          {
            EXPECT_EQ(two.datasets["pieces"][i], 2);
            EXPECT_EQ(one.datasets["segments"][i], two.datasets["segments"][i]);
            EXPECT_EQ(one.points[i].names, two.points[i].names);

            // Sums do not depend on the order of the pieces. Two values that
            // differ by round-off may differ by single precision, 6e-8.
            for (const std::string &field : one.points[i].names)
              if (field != "mpi_rank")
                {
                  double sum = 0, size = 0, other_sum = 0;
                  for (const double value : one.points[i][field])
                    {
                      sum += value;
                      size += std::abs(value);
                    }
                  for (const double value : two.points[i][field])
                    other_sum += value;
                  EXPECT_NEAR(sum, other_sum, 1e-7 * size) << field;
                }
          }
        if (name == "solution")
          {
            const std::vector<double> &ranks = two.points.back()["mpi_rank"];
            const auto n_first  = std::count(ranks.begin(), ranks.end(), 0.);
            const auto n_second = std::count(ranks.begin(), ranks.end(), 1.);
            EXPECT_GT(n_first, 0);
            EXPECT_GT(n_second, 0);
            EXPECT_EQ(std::size_t(n_first + n_second), ranks.size());
          }
      }
  }



  TEST_F(ParallelProgram, MoreRanksThanStrutsAreRefused)
  {
    write("scene.prm", data_text("arch.prm"));
    expect_one_message(run_auxfem_on(3, {"scene.prm"}),
                       1,
                       "3 MPI ranks, but the lattice has only 2 struts");
  }



  TEST_F(ParallelProgram, FailuresEndAllRanks)
  {
    write("scene.prm", data_text("star.prm"));
    // Only one rank has the loaded joint.
    expect_one_message(
      run_auxfem_on(2,
                    {"scene.prm",
                     "--output",
                     "out",
                     "--set",
                     "Loads/hit/Joints=nearest: 0, 0.04",
                     "--set",
                     "Loads/hit/Force y=-8 * sqrt(0.31e-3 - t)"}),
      2,
      "not a finite number at t = 0.0003");
    EXPECT_EQ(history().n_rows, 16u);
    expect_contains(summary("exit_state"), {"not a finite number"});
    EXPECT_EQ(
      GraphicsSeries(path("out/solution.pvd"), path("vtk")).datasets.n_rows,
      3u);
  }



  TEST_F(ParallelProgram, ARankMayHaveNoUnknowns)
  {
    write("scene.prm", R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 1 0; 0.5 1
  set Struts = 0 1; 1 2; 2 0
end
subsection Sections
  subsection rod
    set Shape           = circle
    set Radius          = 10 mm
    set Young's modulus = 70 GPa
  end
end
subsection Discretization
  set Order = 1
end
subsection Supports
  subsection foundation
    set Joints = 0, 1
  end
end
subsection Loads
  subsection push
    set Joints  = 2
    set Force x = 100
  end
end
subsection Time
  set Scheme    = static
  set Time step = 1 s
end
subsection Probes
  set top = 2
end
)");
    const ProgramRun one = run_auxfem({"scene.prm", "--output", "one"});
    const ProgramRun three =
      run_auxfem_on(3, {"scene.prm", "--output", "three"});
    ASSERT_EQ(one.exit_code, 0) << one.errors;
    ASSERT_EQ(three.exit_code, 0) << three.errors;
    expect_same(history("one"), history("three"));
  }
} // namespace
