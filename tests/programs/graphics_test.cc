#include <programs/single_precision.h>
#include <support/graphics_series.h>

#include <array>

namespace
{
  using namespace auxfem::testing_support;

  /** The arch beside a post of tests/data, read back as ParaView does. */
  class GraphicsProgram : public ProgramTest
  {
  protected:
    void run_arch(const Words &overrides = {}) const
    {
      write("arch.prm", data_text("arch.prm"));
      Words arguments = {"arch.prm", "--output", "out"};
      arguments.insert(arguments.end(), overrides.begin(), overrides.end());
      const ProgramRun run = run_auxfem(arguments);
      if (run.exit_code != 0)
        throw std::runtime_error(run.errors);
    }

    GraphicsSeries series(const std::string &name) const
    {
      return {path("out/" + name + ".pvd"), path("vtk_" + name)};
    }
  };

  TEST_F(GraphicsProgram, HistoryHasTheColumnsOfTheScene)
  {
    run_arch();
    const Table table = history();
    EXPECT_EQ(table.names, (Words{"time",           "knee.ux",
                                  "knee.uy",        "knee.phi",
                                  "knee.vx",        "knee.vy",
                                  "knee.ax",        "knee.ay",
                                  "tip.ux",         "tip.uy",
                                  "tip.phi",        "tip.vx",
                                  "tip.vy",         "tip.ax",
                                  "tip.ay",         "foot.rx",
                                  "foot.ry",        "foot.m",
                                  "tie.force",      "tie.extension",
                                  "anchors.force",  "anchors.extension",
                                  "kinetic",        "strain",
                                  "stored",         "dissipated",
                                  "external",       "numerical",
                                  "tie.dissipated", "anchors.dissipated",
                                  "contact",        "push.load_work",
                                  "balance"}));
    ASSERT_EQ(table.n_rows, 41u);
    for (unsigned int i = 0; i < table.n_rows; ++i)
      {
        EXPECT_NEAR(table["time"][i], i * 5e-3, 1e-15);
        // No strut is damped.
        EXPECT_NEAR(table["dissipated"][i],
                    table["tie.dissipated"][i] + table["anchors.dissipated"][i],
                    1e-12 * table["dissipated"].back());
        // No support moves.
        EXPECT_EQ(table["external"][i], table["push.load_work"][i]);
        // Written with 15 digits, balance is the sum of the others.
        EXPECT_NEAR(table["balance"][i],
                    table["kinetic"][i] + table["strain"][i] +
                      table["stored"][i] + table["dissipated"][i] +
                      table["numerical"][i] - table["external"][i],
                    1e-13 * table["external"].back());
      }
    EXPECT_GT(table["dissipated"].back(), 0);

    const std::string units = read_text(path("out/history.units.csv"));
    for (const std::string &name : table.names)
      expect_contains(units, {"\n" + name + ","});
  }



  TEST_F(GraphicsProgram, HistoryOfAStaticSceneHasNoVelocities)
  {
    run_arch({"--set", "Time/Scheme=static", "--set", "Time/End time=50 ms"});
    for (const std::string &name : history().names)
      EXPECT_TRUE(name.find(".v") == std::string::npos) << name;

    const Words fields = series("solution").points[0].names;
    EXPECT_EQ(std::count(fields.begin(), fields.end(), "velocity.0"), 0);
  }



  TEST_F(GraphicsProgram, AllFieldsAreThereAtAllTimes)
  {
    run_arch();
    const GraphicsSeries solution = series("solution");
    const GraphicsSeries links    = series("connectors");
    ASSERT_EQ(solution.datasets.n_rows, 5u);
    ASSERT_EQ(links.datasets.n_rows, 5u);
    for (unsigned int i = 0; i < 5; ++i)
      {
        EXPECT_NEAR(solution.datasets["time"][i], 0.05 * i, 1e-6);
        EXPECT_NEAR(links.datasets["time"][i], 0.05 * i, 1e-6);
        EXPECT_EQ(solution.points[i].names,
                  (Words{"x",
                         "y",
                         "z",
                         "displacement.0",
                         "displacement.1",
                         "displacement.2",
                         "velocity.0",
                         "velocity.1",
                         "velocity.2",
                         "rotation",
                         "axial_force",
                         "shear_force",
                         "bending_moment",
                         "strain_energy_density",
                         "axial_stress",
                         "bending_stress",
                         "fibre_stress",
                         "shear_stress",
                         "von_mises_stress",
                         "fibre_strain",
                         "radius",
                         "strut",
                         "cell",
                         "section",
                         "mpi_rank",
                         "set_curved_part"}));
        EXPECT_EQ(links.points[i].names,
                  (Words{"x",
                         "y",
                         "z",
                         "displacement.0",
                         "displacement.1",
                         "displacement.2",
                         "force",
                         "extension",
                         "dissipated_energy",
                         "group",
                         "cell"}));
        // 2 struts of 4 elements drawn in 5 pieces; 3 connectors
        EXPECT_EQ(solution.segments[i].n_rows, 40u);
        EXPECT_EQ(links.segments[i].n_rows, 3u);
      }

    const Table &points = solution.points.back();
    for (unsigned int i = 0; i < points.n_rows; ++i)
      {
        const bool is_arch = points["strut"][i] == 0;
        EXPECT_EQ(points["section"][i], is_arch ? 0 : 1);
        EXPECT_EQ(points["set_curved_part"][i], is_arch ? 1 : 0);
        EXPECT_EQ(points["cell"][i], 0);
        EXPECT_EQ(points["mpi_rank"][i], 0);
        // half the rectangle's height, the tube's outer radius
        EXPECT_NEAR(points["radius"][i],
                    is_arch ? 10e-3 : 15e-3,
                    single_precision * 15e-3);
        EXPECT_EQ(points["z"][i], 0);
        EXPECT_EQ(points["displacement.2"][i], 0);
        EXPECT_EQ(points["velocity.2"][i], 0);
      }
  }



  TEST_F(GraphicsProgram, JointsMoveAsInTheHistory)
  {
    run_arch();
    const Table                              table    = history();
    const GraphicsSeries                     solution = series("solution");
    const std::map<std::string, std::string> columns  = {
       {"displacement.0", "ux"},
       {"displacement.1", "uy"},
       {"rotation", "phi"},
       {"velocity.0", "vx"},
       {"velocity.1", "vy"}};
    for (unsigned int i = 0; i < solution.datasets.n_rows; ++i)
      {
        const Table       &points = solution.points[i];
        const unsigned int row =
          row_at_time(table, solution.datasets["time"][i]);
        const auto knee = rows_at(points, 2, 0), tip = rows_at(points, 2, 1);
        ASSERT_EQ(knee.size(), 2u) << "both struts end there";
        ASSERT_EQ(tip.size(), 1u);
        for (const auto &[field, column] : columns)
          for (const auto &[probe, rows] :
               {std::make_pair("knee", knee), std::make_pair("tip", tip)})
            for (const unsigned int point : rows)
              {
                const double value =
                  table[std::string(probe) + "." + column][row];
                EXPECT_NEAR(points[field][point],
                            value,
                            single_precision * std::abs(value))
                  << field;
              }
      }
    EXPECT_GT(table.largest("tip.phi"), 0.05) << "nothing has moved";
  }



  TEST_F(GraphicsProgram, ACurvedStrutIsDrawnAlongItsArc)
  {
    run_arch();
    const Table points   = series("solution").points[0];
    const Table segments = series("solution").segments[0];

    // Chord 2, rise 0.8 below it: R = (1 + 0.8^2) / (2 * 0.8).
    const double radius = 1.025, centre = radius - 0.8;
    double       length = 0;
    unsigned int pieces = 0;
    for (unsigned int i = 0; i < segments.n_rows; ++i)
      {
        const unsigned int a = segments["first"][i], b = segments["second"][i];
        ASSERT_EQ(points["strut"][a], points["strut"][b]);
        if (points["strut"][a] != 0)
          continue;
        ++pieces;
        length += std::hypot(points["x"][b] - points["x"][a],
                             points["y"][b] - points["y"][a]);
        for (const unsigned int end : {a, b})
          EXPECT_NEAR(std::hypot(points["x"][end] - 1,
                                 points["y"][end] - centre),
                      radius,
                      3 * single_precision);
      }
    ASSERT_EQ(pieces, 20u);

    // A polygon of equal pieces; the error is that of 20 rounded differences.
    const double half_angle = std::asin(1 / radius);
    EXPECT_NEAR(length,
                20 * 2 * radius * std::sin(half_angle / 20),
                20 * 2 * single_precision);
  }



  TEST_F(GraphicsProgram, StrainEnergyDensitySumsUpToTheStrainEnergy)
  {
    run_arch();
    const GraphicsSeries solution = series("solution");
    const Table          points   = solution.points.back();
    const Table          segments = solution.segments.back();
    double               energy   = 0;
    for (unsigned int i = 0; i < segments.n_rows; ++i)
      {
        const unsigned int a = segments["first"][i], b = segments["second"][i];
        energy += (points["strain_energy_density"][a] +
                   points["strain_energy_density"][b]) /
          2 *
          std::hypot(points["x"][b] - points["x"][a],
                     points["y"][b] - points["y"][a]);
      }
    // The trapezoidal rule with 5 pieces an element, in which the density is
    // about a parabola: within 1 / (2 * 5^2) of its variation.
    const double strain = history()["strain"].back();
    EXPECT_NEAR(energy, strain, 0.02 * strain);
  }



  TEST_F(GraphicsProgram, ConnectorsSumUpToTheHistory)
  {
    run_arch();
    const Table                              table   = history();
    const GraphicsSeries                     links   = series("connectors");
    const std::map<std::string, std::string> columns = {
      {"force", "force"},
      {"extension", "extension"},
      {"dissipated_energy", "dissipated"}};
    for (unsigned int i = 0; i < links.datasets.n_rows; ++i)
      {
        const Table       &points   = links.points[i];
        const Table       &segments = links.segments[i];
        const unsigned int row = row_at_time(table, links.datasets["time"][i]);
        for (const auto &[field, column] : columns)
          {
            std::array<double, 2> sums{}, sizes{};
            for (unsigned int s = 0; s < segments.n_rows; ++s)
              {
                const unsigned int a     = segments["first"][s];
                const unsigned int b     = segments["second"][s];
                const unsigned int group = points["group"][a];
                ASSERT_LT(group, 2u);
                EXPECT_EQ(points[field][a], points[field][b]);
                sums[group] += points[field][a];
                sizes[group] += std::abs(points[field][a]);
              }
            EXPECT_NEAR(sums[0],
                        table["tie." + column][row],
                        single_precision * sizes[0]);
            EXPECT_NEAR(sums[1],
                        table["anchors." + column][row],
                        single_precision * sizes[1]);
          }
      }
    EXPECT_GT(table.largest("tie.force"), 1);
    EXPECT_GT(table.largest("anchors.force"), 1);

    // The extension is the change of the distance between the drawn ends.
    const Table &points = links.points.back();
    for (unsigned int s = 0; s < 3; ++s)
      {
        const unsigned int a = links.segments.back()["first"][s];
        const unsigned int b = links.segments.back()["second"][s];
        const double       x = points["x"][b] - points["x"][a];
        const double       y = points["y"][b] - points["y"][a];
        const double       u =
          points["displacement.0"][b] - points["displacement.0"][a];
        const double v =
          points["displacement.1"][b] - points["displacement.1"][a];
        EXPECT_NEAR(std::hypot(x + u, y + v) - std::hypot(x, y),
                    points["extension"][a],
                    10 * single_precision);
      }
  }



  TEST_F(GraphicsProgram, CanBeSwitchedOff)
  {
    run_arch({"--set", "Output/Graphics=false"});
    EXPECT_EQ(history().n_rows, 41u);
    for (const char *name :
         {"out/solution.pvd", "out/solution", "out/connectors.pvd"})
      EXPECT_FALSE(std::filesystem::exists(path(name))) << name;
  }



  TEST_F(GraphicsProgram, RigidPartsAreThereWithTheirForces)
  {
    // A half circle hinged at its left end, hanging by a bar of 2 kg at the
    // other; the two fall.
    write("scene.prm", R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 2 0; 2 -1
  set Struts = 0 1 -1; 1 2
end
subsection Rigid parts
  subsection parts
    set Struts = all
    set Parts  = single struts
    set Mass   = 2 kg
  end
end
subsection Supports
  subsection hinge
    set Joints = 0
    set Type   = pin
  end
end
subsection Gravity
  set Acceleration y = -9.81
end
subsection Time
  set Scheme    = generalized-alpha
  set End time  = 0.1
  set Time step = 5 ms
end
subsection Probes
  set bow = rigid: 0 @ 0
  set tip = 1
end
subsection Output
  set Graphics interval   = 50 ms
  set Segments per element = 6
end
)");
    const ProgramRun run = run_auxfem({"scene.prm", "--output", "out"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(path("out/solution.pvd")));
    const GraphicsSeries parts = series("rigid_parts");
    const Table          table = history();
    ASSERT_EQ(parts.datasets.n_rows, 3u);
    for (unsigned int i = 0; i < 3; ++i)
      {
        const Table &points = parts.points[i];
        EXPECT_EQ(points.names,
                  (Words{"x",
                         "y",
                         "z",
                         "displacement.0",
                         "displacement.1",
                         "displacement.2",
                         "velocity.0",
                         "velocity.1",
                         "velocity.2",
                         "force.0",
                         "force.1",
                         "force.2",
                         "rotation",
                         "part",
                         "definition",
                         "cell"}));
        // The bow in six pieces, the bar in one.
        EXPECT_EQ(points.n_rows, 9u);
        EXPECT_EQ(parts.segments[i].n_rows, 7u);

        const unsigned int row = row_at_time(table, parts.datasets["time"][i]);
        const auto         at_hinge = rows_at(points, 0, 0),
                   at_knee          = rows_at(points, 2, 0);
        ASSERT_EQ(at_hinge.size(), 1u);
        ASSERT_EQ(at_knee.size(), 2u);
        const double weight = 2 * 9.81;
        for (const auto &[field, column] :
             {std::pair("force.0", "bow.fx"), std::pair("force.1", "bow.fy")})
          EXPECT_NEAR(points[field][at_hinge[0]],
                      table[column][row],
                      single_precision * weight);
        EXPECT_NEAR(points["rotation"][at_hinge[0]],
                    table["bow.phi"][row],
                    single_precision);
        // Action and reaction in the knee; the bar is above it in the list.
        for (const char *field : {"force.0", "force.1"})
          EXPECT_NEAR(points[field][at_knee[0]],
                      -points[field][at_knee[1]],
                      single_precision * weight);
        for (const unsigned int knee : at_knee)
          EXPECT_NEAR(points["displacement.1"][knee],
                      table["tip.uy"][row],
                      single_precision);

        // The arc stays one: its points keep their distance from its middle,
        // which moves with the chord.
        const double ux = table["tip.ux"][row] / 2,
                     uy = table["tip.uy"][row] / 2;
        for (unsigned int k = 0; k < points.n_rows; ++k)
          if (points["part"][k] == 0)
            {
              EXPECT_NEAR(std::hypot(points["x"][k] +
                                       points["displacement.0"][k] - 1 - ux,
                                     points["y"][k] +
                                       points["displacement.1"][k] - uy),
                          1,
                          1e-6);
            }
      }
    EXPECT_LT(table["bow.phi"].back(), -0.01);
  }
} // namespace
