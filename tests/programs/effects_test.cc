#include <support/run_program.h>

#include <nlohmann/json.hpp>

namespace
{
  using namespace auxfem::testing_support;

  /** The lists of simulated and omitted effects that a run prints. */
  class EffectsProgram : public ProgramTest
  {
  protected:
    /** Reasons by name of the effect, of the two lists on the screen. */
    struct Lists
    {
      std::map<std::string, std::string> simulated, left_out;
    };

    static Lists read_lists(const std::string &text)
    {
      Lists                               lists;
      std::map<std::string, std::string> *list = nullptr;
      std::istringstream                  stream(text);
      std::smatch                         match;
      for (std::string line; std::getline(stream, line);)
        if (line == "Simulated")
          list = &lists.simulated;
        else if (line == "Left out")
          list = &lists.left_out;
        else if (line.empty())
          list = nullptr;
        else if (list &&
                 std::regex_match(line, match, std::regex("  (.*?\\S)  +(.*)")))
          (*list)[match[1]] = match[2];
      return lists;
    }

    Lists check(const Words       &overrides,
                const std::string &text = data_text("star.prm")) const
    {
      write("scene.prm", text);
      Words arguments = {"--check", "scene.prm"};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      const ProgramRun run = run_auxfem(arguments);
      EXPECT_EQ(run.exit_code, 0) << run.errors;
      return read_lists(run.output);
    }

    Table run(const std::string &name, const Words &overrides) const
    {
      write("scene.prm", data_text("star.prm"));
      Words arguments = {"scene.prm",
                         "--output",
                         name,
                         "--set",
                         "Output/Graphics=false"};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      const ProgramRun run = run_auxfem(arguments);
      EXPECT_EQ(run.exit_code, 0) << run.errors;
      return history(name);
    }
  };

  TEST_F(EffectsProgram, AutoFollowsTheScene)
  {
    const Lists lists = check({});
    EXPECT_EQ(
      lists.simulated,
      (std::map<std::string, std::string>{
        {"large rotation",
         "twice the static answer to the loads: rotations reach 0.23 rad"},
        {"shear flexibility", "0.35 % of the bending compliance, above 0.1 %"},
        {"inertia", "time scheme newmark"},
        {"contact", "struts may touch: forces where they are near"},
        {"rotary inertia",
         "0.016 % of the highest frequency that steps resolve, below "
         "0.1 %, but leaving it out saves nothing"},
        {"connector viscosity",
         "5 % of the connectors' stiffness, above 0.1 %"}}));
    EXPECT_EQ(lists.left_out,
              (std::map<std::string, std::string>{
                {"strut damping", "no section has damping"},
                {"strut relaxation", "no material relaxes"},
                {"plasticity", "no material yields"},
                {"gravity", "no acceleration given"},
                {"hinges", "no strut ends are released"},
                {"rigid parts", "no struts or joints are rigid"}}));
  }



  TEST_F(EffectsProgram, WhatASceneAddsIsSimulated)
  {
    const Lists lists =
      check({"Gravity/Acceleration y=-9.81",
             "Joints/loose/Joints=tips",
             "Rigid parts/plate/Joints=top",
             "Rigid parts/plate/Mass=1 g",
             "Sections/steel/Stiffness-proportional damping=1 us",
             "Plates/floor/Shape=plane",
             "Plates/floor/Position=0 -1",
             "Plates/floor/Normal=0 1"});
    EXPECT_EQ(lists.simulated.size(), 10u);
    EXPECT_EQ(lists.left_out,
              (std::map<std::string, std::string>{
                {"strut relaxation", "no material relaxes"},
                {"plasticity", "no material yields"}}));
    EXPECT_EQ(lists.simulated.at("gravity"),
              "0.18 % of the loads, above 0.1 %");
    EXPECT_EQ(lists.simulated.at("rigid parts"), "rigid struts or joints");
    EXPECT_EQ(lists.simulated.at("hinges"), "joints with released struts");
    EXPECT_EQ(lists.simulated.at("strut damping"),
              "0.1 % of the struts' forces, above 0.1 %");
  }



  TEST_F(EffectsProgram, StaticsAndElasticConnectorsLeaveOutTheirEffects)
  {
    const Lists lists =
      check({"Time/Scheme=static", "Connectors/damper/Law=spring"},
            replaced(data_text("star.prm"),
                     "set Damping coefficient",
                     "# set Damping coefficient"));
    EXPECT_EQ(lists.left_out.at("inertia"), "time scheme static");
    EXPECT_EQ(lists.left_out.at("rotary inertia"), "no inertia");
    EXPECT_EQ(lists.left_out.at("connector viscosity"),
              "no connector has a dashpot");
  }



  TEST_F(EffectsProgram, WhatIsSwitchedOffIsLeftOutAsSet)
  {
    const Lists lists = check({"Effects/Large rotation=off",
                               "Effects/Shear flexibility=off",
                               "Effects/Rotary inertia=off",
                               "Effects/Connector viscosity=off",
                               "Gravity/Acceleration y=-9.81",
                               "Effects/Gravity=off"});
    EXPECT_EQ(lists.simulated.size(), 1u);
    EXPECT_EQ(lists.simulated.count("inertia"), 1u);
    for (const char *name : {"large rotation",
                             "shear flexibility",
                             "rotary inertia",
                             "connector viscosity",
                             "gravity"})
      EXPECT_EQ(lists.left_out.at(name).rfind("as set", 0), 0u) << name;
  }



  TEST_F(EffectsProgram, WhatIsBelowTheToleranceIsLeftOutIfThatSaves)
  {
    const Words slow   = {"Sections/steel/Stiffness-proportional damping=1 us"};
    Words       linear = slow;
    linear.emplace_back("Effects/Large rotation=off");
    linear.emplace_back("Effects/Tolerance=1 %");
    EXPECT_EQ(check(linear).simulated.at("strut damping"),
              "0.1 % of the struts' forces, below 1 %, but it matters where "
              "struts swing");
    Words still = linear;
    still.emplace_back("Time/Scheme=static");
    EXPECT_EQ(check(still).left_out.at("strut damping"),
              "0.1 % of the struts' forces, below 1 %");
    linear.back() = "Effects/Tolerance=0.01 %";
    EXPECT_EQ(check(linear).simulated.at("strut damping"),
              "0.1 % of the struts' forces, above 0.01 %");

    Words bent = slow;
    bent.emplace_back("Effects/Tolerance=1 %");
    EXPECT_EQ(check(bent).simulated.at("strut damping"),
              "0.1 % of the struts' forces, below 1 %, but it matters where "
              "struts snap");
  }



  TEST_F(EffectsProgram, TheSummaryHasNumbersAndVerdicts)
  {
    run("all", {"Time/End time=0.2 ms"});
    std::map<std::string, nlohmann::json> effects;
    const auto                            summary =
      nlohmann::json::parse(read_text(path("all/summary.json")));
    for (const nlohmann::json &effect : summary.at("effects"))
      effects[effect.at("name")] = effect;
    EXPECT_EQ(effects.size(), 12u);
    const nlohmann::json &rotary = effects.at("rotary inertia");
    EXPECT_TRUE(rotary.at("on").get<bool>());
    EXPECT_EQ(rotary.at("verdict"), "not called for");
    EXPECT_EQ(rotary.at("tolerance"), 1e-3);
    EXPECT_GT(rotary.at("change"), 1e-4);
    EXPECT_LT(rotary.at("change"), 1e-3);
    EXPECT_EQ(effects.at("shear flexibility").at("verdict"), "called for");
    EXPECT_EQ(effects.at("gravity").count("change"), 0u);
    EXPECT_FALSE(effects.at("gravity").at("on").get<bool>());
  }



  TEST_F(EffectsProgram, EverySwitchChangesTheResult)
  {
    const Words  scene  = {"Time/End time=0.2 ms",
                           "Gravity/Acceleration y=-9.81",
                           "Sections/steel/Stiffness-proportional damping=1 us",
                           "Joints/loose/Joints=tips",
                           "Output/Exit code by verdict=false",
                           "Plates/press/Shape=plane",
                           "Plates/press/Position=0 41.19 mm",
                           "Plates/press/Normal=0 -1",
                           "Plates/press/Displacement y=-2 * t"};
    const double motion = run("all", scene)["top.uy"].back();
    for (const char *name : {"Large rotation",
                             "Shear flexibility",
                             "Rotary inertia",
                             "Connector viscosity",
                             "Strut damping",
                             "Gravity",
                             "Hinges",
                             "Contact"})
      {
        Words overrides = scene;
        overrides.push_back("Effects/" + std::string(name) + "=off");
        // far above the round-off of the same computation twice
        EXPECT_GT(std::abs(run("less", overrides)["top.uy"].back() - motion),
                  1e-9 * std::abs(motion))
          << name;
      }
  }



  TEST_F(EffectsProgram, ALinearSceneIsFactorizedOnce)
  {
    const Words linear = {"Effects/Large rotation=off",
                          "Loads/hit/Force y=-4 * t",
                          "Connectors/damper/Geometry=direction",
                          "Connectors/damper/Direction=0 1"};
    const Table once   = run("once", linear);
    EXPECT_EQ(summary("factorizations", "once"), "1");
    EXPECT_EQ(summary("newton_iterations", "once"), "50");

    Words twice = linear;
    twice.push_back("Loads/hit/Force y=-8 * t");
    const Table doubled = run("twice", twice);
    for (const char *name : {"top.uy", "top.vy", "foundation.ry"})
      // Every step is solved to 1e-8 of the forces.
      EXPECT_NEAR(doubled[name].back(),
                  2 * once[name].back(),
                  1e-7 * doubled.largest(name));
  }
} // namespace
