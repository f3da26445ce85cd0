#include <auxfem/parameters/text.h>

#include <support/run_program.h>
#include <support/scene_text.h>

#include <nlohmann/json.hpp>

namespace
{
  using namespace auxfem::testing_support;
  using auxfem::Json;

  constexpr double length = 0.1, height = 0.004, width = 0.01;

  /** A cantilever along x with a force at its end, in two static steps. */
  SceneText cantilever()
  {
    SceneText scene;
    scene.frame("0 0; 0.1 0", "0 1");
    scene.add(
      "Sections/bar",
      "Struts = all | Shape = rectangle | Width = 10 mm | Height = 4 mm "
      "| Young's modulus = 70 GPa | Density = 2700");
    scene.add("Supports/wall",
              "Joints = left | Type = clamp | Moments about = 0.1, 0.2");
    scene.add(
      "Loads/pull",
      "Type = joint | Joints = right | Force x = t | Force y = 0.4 * t");
    scene.set("Effects/Large rotation", "off");
    scene.add("Time", "Scheme = static | End time = 2 | Time step = 1");
    scene.add("Stresses/bar", "Struts = all | Strength = 10 MPa");
    scene.add("Member forces", "Struts = all | Points per element = 3");
    return scene;
  }

  class FiguresProgram : public ProgramTest
  {
  protected:
    Json summary_of(const SceneText &scene)
    {
      write("scene.prm", scene.str());
      const ProgramRun run = run_auxfem({"scene.prm", "--output", "out"});
      EXPECT_EQ(run.exit_code, 0) << run.errors;
      screen = run.output;
      return Json::parse(read_text(path("out/summary.json")));
    }

    std::string screen;
  };

  // sigma = N / A + M / W at the wall, where the shear stress is at the axis.
  TEST_F(FiguresProgram, StressesAreThoseOfTheBeamFormulas)
  {
    const Json   summary = summary_of(cantilever());
    const double stress =
      2 / (width * height) + 0.8 * length * 6 / (width * height * height);
    const Json largest = summary["evaluation"]["stresses"]["bar"];
    EXPECT_NEAR(largest["von_mises"].get<double>(), stress, 1e-6 * stress);
    EXPECT_NEAR(largest["fibre_stress"].get<double>(), stress, 1e-6 * stress);
    EXPECT_EQ(largest["time"], 2);
    EXPECT_EQ(largest["position"], 0);
    EXPECT_NEAR(largest["use"].get<double>(), stress / 10e6, 1e-6);
    expect_contains(screen, {"Largest stress of bar", "of the strength"});
    const Table history(path("out/history.csv"));
    EXPECT_NEAR(history["bar.von_mises"][1], stress / 2, 1e-6 * stress);
    // The load of 2 N along x has an arm of 0.2 m, that along y none.
    EXPECT_NEAR(history["wall.moment"].back(), -2 * 0.2, 1e-9);
  }

  TEST_F(FiguresProgram, MembersHaveTheirSectionForces)
  {
    summary_of(cantilever());
    const Table members(path("out/member_forces.csv"));
    ASSERT_EQ(members.n_rows, 3);
    EXPECT_EQ(members["time"], (std::vector<double>{2, 2, 2}));
    EXPECT_EQ(members["position"], (std::vector<double>{0, 0.5, 1}));
    for (unsigned int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(members["axial_force"][i], 2, 1e-9);
        EXPECT_NEAR(std::abs(members["shear_force"][i]), 0.8, 1e-9);
        EXPECT_NEAR(std::abs(members["bending_moment"][i]),
                    0.8 * length * (1 - i / 2.),
                    1e-9);
      }
  }

  // The last frame has the stresses of the last row.
  TEST_F(FiguresProgram, FramesHaveStresses)
  {
    const Json   summary = summary_of(cantilever());
    const double stress = summary["evaluation"]["stresses"]["bar"]["von_mises"];
    std::string  file;
    for (const auto &entry :
         std::filesystem::directory_iterator(path("out/solution")))
      file = std::max(file, entry.path().string());
    const ProgramRun read =
      run_program({AUXFEM_PYTHON,
                   "-c",
                   "import sys, vtk\n"
                   "r = vtk.vtkXMLUnstructuredGridReader()\n"
                   "r.SetFileName(sys.argv[1])\n"
                   "r.Update()\n"
                   "p = r.GetOutput().GetPointData()\n"
                   "print(p.GetArray('von_mises_stress').GetRange()[1])\n"
                   "print(p.GetArray('fibre_strain').GetRange()[1])\n",
                   file});
    ASSERT_EQ(read.exit_code, 0) << read.errors;
    std::istringstream numbers(read.output);
    double             von_mises = 0, strain = 0;
    numbers >> von_mises >> strain;
    EXPECT_NEAR(von_mises, stress, 1e-5 * stress);
    EXPECT_NEAR(strain, stress / 70e9, 1e-5 * strain);
    EXPECT_TRUE(std::filesystem::exists(path("out/view.py")));
  }

  // A body of 2 kg thrown at a spring-like column: half a period of contact.
  TEST_F(FiguresProgram, ABodyThatReboundsHasItsFigures)
  {
    SceneText scene;
    scene.frame("0 0; 0 0.1", "0 1");
    scene.add("Sections/column",
              "Struts = all | Shape = rectangle | Width = 10 mm | Height = 10 "
              "mm | Young's modulus = 20 MPa | Density = 1");
    scene.add("Supports/floor", "Joints = bottom | Type = clamp");
    scene.add(
      "Supports/guide",
      "Joints = top | Type = prescribed | Displacement x = 0 | Rotation "
      "z = 0");
    scene.add("Masses/body", "Joints = top | Mass = 2");
    scene.add("Initial velocities/throw", "Joints = top | Velocity y = -0.1");
    scene.add("Probes", "body = top");
    scene.set("Columns/double force", "2 * floor.ry [N]");
    scene.add("Transmission",
              "Input = floor.ry | Output = double force | Largest frequency = "
              "100 Hz");
    scene.set("Effects/Large rotation", "off");
    scene.set("Discretization/Order", 1);
    scene.add("Time", "End time = 31.4159265 ms | Time step = 20 us");
    const Json summary = summary_of(scene);
    // k = E A / l = 20 kN/m, w = 100 / s, half a period pi / w.
    const Json body  = summary["evaluation"]["bodies"]["body"]["y"];
    const Json floor = summary["evaluation"]["bodies"]["floor"]["y"];
    EXPECT_NEAR(body["rebound_velocity"].get<double>(), 0.1, 1e-4);
    EXPECT_NEAR(body["restitution"].get<double>(), 1, 1e-3);
    EXPECT_NEAR(body["stroke"].get<double>(), -1e-3, 1e-6);
    EXPECT_NEAR(body["peak_acceleration_g"].get<double>(), 10 / 9.80665, 1e-3);
    EXPECT_NEAR(floor["peak_force"].get<double>(), 20, 0.02);
    EXPECT_NEAR(floor["peak_force_time"].get<double>(), 0.0157, 1e-4);
    EXPECT_NEAR(floor["impulse"].get<double>(), 0.4, 1e-3);
    EXPECT_NEAR(summary["evaluation"]["transmission"]["peak_ratio"], 2, 1e-12);
    EXPECT_NEAR(summary["energies_joule"]["largest"].get<double>(), 0.01, 1e-4);
    const Table bodies(path("out/evaluation.csv"));
    EXPECT_EQ(bodies.n_rows, 2);
    expect_contains(screen,
                    {"Figures, CFC 1000", "body y", "Transmitted: 2 of"});
  }

  TEST_F(FiguresProgram, FilesOfFormerEvaluationsGo)
  {
    SceneText scene = cantilever();
    scene.set("Time/Time step", 0.25);
    scene.add("Transmission", "Input = wall.rx | Output = wall.ry");
    summary_of(scene);
    EXPECT_TRUE(std::filesystem::exists(path("out/transmission.csv")));
    scene.remove("Transmission").remove("Member forces");
    summary_of(scene);
    EXPECT_FALSE(std::filesystem::exists(path("out/transmission.csv")));
    EXPECT_FALSE(std::filesystem::exists(path("out/member_forces.csv")));
  }

  TEST_F(FiguresProgram, MistakesKeepTheResultsOfAnEarlierRun)
  {
    summary_of(cantilever());
    const auto message_for = [&](const std::string &mistake) {
      const ProgramRun run =
        run_auxfem({"scene.prm", "--output", "out", "--set", mistake});
      EXPECT_EQ(run.exit_code, 1) << mistake;
      EXPECT_TRUE(std::filesystem::exists(path("out/history.csv"))) << mistake;
      return run.errors;
    };
    expect_contains(message_for("Columns/a=wall.rz + 1"), {"wall.rx"});
    expect_contains(message_for("Columns/a=wall.rx [mm]"), {"not SI"});
    expect_contains(message_for("Crush curve/Bodies=wall, press"),
                    {"\"press\" is no plate or support"});
    expect_contains(message_for("Stresses/bar/Struts=nowhere"), {"nowhere"});
    expect_contains(message_for("Member forces/Struts=nowhere"), {"nowhere"});
    const ProgramRun run = run_auxfem({"scene.prm",
                                       "--output",
                                       "out",
                                       "--set",
                                       "Transmission/Input=a",
                                       "--set",
                                       "Transmission/Output=wall.rx"});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors, {"Transmission/Input = a", "wall.ry"});
  }

  TEST_F(FiguresProgram, TellsQuantitiesOfTheScene)
  {
    SceneText scene = cantilever();
    scene.set("Quantities/push", "wall.rx at 2 s");
    scene.set("Quantities/late", "time of minimum of wall.rx");
    const Json found = summary_of(scene).at("quantities");
    EXPECT_NEAR(found.at("push").get<double>(), -2, 1e-9);
    EXPECT_EQ(found.at("late"), 2);
    expect_contains(screen, {"Quantity push: -2 N", "Quantity late: 2 s"});
    write("scene.prm", scene.set("Quantities/push", "wall.fx at 2 s").str());
    const ProgramRun refused = run_auxfem({"scene.prm", "--output", "out"});
    EXPECT_EQ(refused.exit_code, 1);
    expect_contains(refused.errors,
                    {"Quantities/push", "no column \"wall.fx\""});
  }
} // namespace
