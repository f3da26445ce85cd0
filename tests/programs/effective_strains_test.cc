#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;

  /** Effective strains of lattices between their sides. */
  class EffectiveStrainsProgram : public ProgramTest
  {};

  /** A frame pushed down and spread; in the middle it is pressed most. */
  const std::string square = R"(
subsection Sections
  subsection bar
    set Shape           = circle
    set Radius          = 5 mm
    set Young's modulus = 1 GPa
  end
end
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 2 0; 2 1; 0 1
  set Struts = 0 1; 1 2; 2 3; 3 0
end
subsection Supports
  subsection floor
    set Joints = bottom
    set Type   = roller x
  end
  subsection press
    set Joints         = top
    set Type           = prescribed
    set Displacement x = free
    set Displacement y = -0.02 * sin(pi * t)
  end
  subsection middle
    set Joints         = left
    set Type           = prescribed
    set Displacement x = -0.01 * t
  end
  subsection spread
    set Joints         = right
    set Type           = prescribed
    set Displacement x = 0.03 * t
  end
end
subsection Time
  set Scheme    = static
  set End time  = 1
  set Time step = 0.25
end
subsection Output
  set Graphics          = false
  set Effective strains = true
end
)";

  TEST_F(EffectiveStrainsProgram, AreColumnsAndALastLine)
  {
    write("scene.prm", square);
    const ProgramRun run = run_auxfem({"scene.prm", "--output", "out"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Table table = history();
    ASSERT_EQ(table.n_rows, 5u);
    for (unsigned int i = 0; i < 5; ++i)
      {
        const double t = table["time"][i];
        EXPECT_NEAR(table["strain.x"][i], 0.04 * t / 2, 1e-15);
        EXPECT_NEAR(table["strain.y"][i], -0.02 * std::sin(M_PI * t), 1e-15);
      }
    // Pressed most at t = 0.5: -0.01 / -0.02.
    expect_contains(
      run.output,
      {"Effective Poisson's ratio -strain.x/strain.y = 0.5 at the "
       "largest |strain.y|, strain.y = -0.02\n"});
    EXPECT_NEAR(std::stod(summary("poissons_ratio_x")), 0.5, 1e-12);
    EXPECT_EQ(read_text(path("out/summary.json")).find("poissons_ratio_z"),
              std::string::npos);
  }



  TEST_F(EffectiveStrainsProgram, AreNotThereUnlessAskedFor)
  {
    write("scene.prm", square);
    const ProgramRun run = run_auxfem({"scene.prm",
                                       "--output",
                                       "out",
                                       "--set",
                                       "Output/Effective strains=false"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_without(run.output, {"Poisson"});
    const Words names = history().names;
    EXPECT_EQ(std::count(names.begin(), names.end(), "strain.x"), 0);
    expect_without(read_text(path("out/summary.json")), {"poisson"});
  }



  TEST_F(EffectiveStrainsProgram, AreRefusedForTheReducedCell)
  {
    write("scene.prm", R"(
set Model = reduced cell
subsection Reduced cell
  set Angle    = 30
  set Bar mass = 0.1
  set Load     = 1
end
subsection Connectors
  subsection damper
    set Law                 = kelvin-voigt
    set Spring stiffness    = 20 kN/m
    set Damping coefficient = 50 N s/m
  end
end
subsection Output
  set Effective strains = true
end
)");
    const ProgramRun run = run_auxfem({"scene.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors,
                    {"Output/Effective strains = true", "reduced cell"});
  }


  /** A body-centred cubic cell of round struts, pressed along z between planes
   * of symmetry. */
  const std::string cubic_cell = R"(
set Dimension = 3
subsection Lattice
  set Cell   = frame
  set Joints = 0 0 0; 5 mm 0 0; 0 5 mm 0; 5 mm 5 mm 0; 0 0 5 mm; \
               5 mm 0 5 mm; 0 5 mm 5 mm; 5 mm 5 mm 5 mm; 2.5 mm 2.5 mm 2.5 mm
  set Struts = 0 8; 1 8; 2 8; 3 8; 4 8; 5 8; 6 8; 7 8
end
subsection Sections
  subsection rod
    set Shape           = circle
    set Radius          = 0.25 mm
    set Young's modulus = 110 GPa
  end
end
subsection Supports
  subsection corners
    set Joints     = 0 1 2 3 4 5 6 7
    set Type       = prescribed
    set Rotation x = 0
    set Rotation y = 0
    set Rotation z = 0
  end
  subsection left
    set Joints         = left
    set Type           = prescribed
    set Displacement x = 0
  end
  subsection bottom
    set Joints         = bottom
    set Type           = prescribed
    set Displacement y = 0
  end
  subsection back
    set Joints         = back
    set Type           = prescribed
    set Displacement z = 0
  end
  subsection press
    set Joints         = front
    set Type           = prescribed
    set Displacement z = -5e-6 * t
  end
end
subsection Effects
  set Large rotation    = off
  set Shear flexibility = off
end
subsection Time
  set Scheme    = static
  set End time  = 1
  set Time step = 1
end
subsection Output
  set Graphics          = false
  set Effective strains = true
end
)";

  TEST_F(EffectiveStrainsProgram, AreRatiosForTheAxisThatIsLoaded)
  {
    write("scene.prm", cubic_cell);
    const ProgramRun run = run_auxfem({"scene.prm", "--output", "out"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    // Struts of length l that do not turn at their ends, with the stiffnesses
    // EA / l along and 12 EI / l^3 across, of which the latter is r part.
    const double r  = 3 * 0.25 * 0.25 / (0.75 * 5 * 5);
    const double nu = (1 - r) / (2 + r);
    EXPECT_NEAR(std::stod(summary("poissons_ratio_x")), nu, 1e-9);
    EXPECT_NEAR(std::stod(summary("poissons_ratio_y")), nu, 1e-9);
    expect_contains(run.output,
                    {"-strain.x/strain.z = 0.4925", "strain.z = -0.001"});
  }
} // namespace
