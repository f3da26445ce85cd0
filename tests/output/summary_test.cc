#include <auxfem/output/overview.h>
#include <auxfem/output/summary.h>
#include <auxfem/version.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

using namespace auxfem;

TEST(Summary, JsonContainsCounts)
{
  Scene scene;
  scene.file               = "a \"quoted\" name.prm";
  scene.connectors         = std::vector<ConnectorDefinition>(2);
  scene.connectors[0].name = "damper";
  scene.connectors[1].name = "rod";
  Summary summary;
  summary.counts.unknowns          = 1234;
  summary.totals.iterations        = 3000000000; // more than 31 bits hold
  summary.totals.retries           = 7;
  summary.resources.wall.factorize = 0.125;
  summary.resources.start          = {0.25, 0.5, 0.75};
  summary.resources.largest_memory = 5000000000;
  summary.largest_rotation         = 1.5;
  summary.exit_state               = "no convergence:\nsecond line";
  EnergyLedger       ledger;
  const unsigned int stored  = ledger.enter(stored_energy_entry()),
                     kinetic = ledger.enter(kinetic_energy_entry());
  Energies energies(std::make_shared<const EnergyLedger>(ledger));
  energies[stored]  = 3;
  energies[kinetic] = 1;
  summary.energies.add(energies);

  const Json json = Json::parse(summary_json(scene, summary));
  EXPECT_EQ(json.at("version"), version);
  EXPECT_EQ(json.at("file"), scene.file);
  EXPECT_EQ(json.at("exit_state"), summary.exit_state);
  EXPECT_EQ(json.at("counts").at("unknowns"), 1234u);
  EXPECT_EQ(json.at("work").at("newton_iterations"), 3000000000u);
  EXPECT_EQ(json.at("work").at("retries"), 7u);
  EXPECT_EQ(json.at("wall_seconds").at("factorize"), 0.125);
  EXPECT_EQ(json.at("wall_seconds").at("program_start"), 0.25);
  EXPECT_EQ(json.at("wall_seconds").at("mpi_start"), 0.5);
  EXPECT_EQ(json.at("cpu_seconds_of_start"), 0.75);
  EXPECT_EQ(json.at("peak_memory_bytes").at("largest_rank"), 5000000000u);
  EXPECT_EQ(json.at("energies_joule").at("stored"), 3);
  EXPECT_EQ(json.at("energies_joule").at("kinetic"), 1);
  EXPECT_FALSE(json.at("energies_joule").contains("strain"));
  EXPECT_EQ(json.at("largest_rotation_radian"), 1.5);
  EXPECT_EQ(json.at("connector_groups").back(), "rod");
}

TEST(Summary, OverviewListsSimulatedAndOmittedEffects)
{
  Scene scene;
  scene.file                 = "lattice.prm";
  scene.title                = "A lattice";
  scene.discretization.order = 3;
  Counts counts;
  counts.joints = 96;
  const std::string text =
    overview_text(scene,
                  counts,
                  {{"gravity", false, "it is zero"},
                   {"inertia", true, "a dynamic scheme"},
                   {"hinges", false, "no joint has any"}},
                  {"The table ends.", "The struts are thick."});
  EXPECT_NE(text.find("lattice.prm: A lattice\n"), std::string::npos);
  EXPECT_NE(text.find("Joints                96\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nSimulated\n  inertia  a dynamic scheme\n"),
            std::string::npos);
  EXPECT_NE(text.find("\nLeft out\n  gravity  it is zero\n"
                      "  hinges   no joint has any"),
            std::string::npos);
  EXPECT_NE(text.find("\nNote\n  The table ends.\n"
                      "\nNote\n  The struts are thick."),
            std::string::npos);
  EXPECT_NE(text.back(), '\n');
}

TEST(Summary, OverviewListsElementsOfStruts)
{
  const auto text_of = [](const Counts &counts) {
    return overview_text(Scene(), counts, {}, {});
  };
  Counts counts;
  counts.elements           = 12;
  counts.struts_of_division = {{{3, 2}, 6}};
  EXPECT_NE(text_of(counts).find("12 of order 3\n"), std::string::npos);
  counts.struts_of_division = {{{2, 2}, 1}, {{3, 2}, 5}};
  EXPECT_NE(text_of(counts).find("12: 1 struts of order 2, 5 of order 3\n"),
            std::string::npos);
  counts.struts_of_division = {{{2, 1}, 1}, {{3, 1}, 4}, {{3, 7}, 1}};
  EXPECT_NE(text_of(counts).find("12: 1 struts of order 2, 4 of order 3, 1 of "
                                 "order 3 with 7 elements\n"),
            std::string::npos)
    << text_of(counts);

  Summary summary;
  summary.counts  = counts;
  const Json json = Json::parse(summary_json(Scene(), summary)).at("counts");
  EXPECT_EQ(json.at("struts_of_order"), Json({{"2", 1}, {"3", 5}}));
  EXPECT_EQ(json.at("struts_of_n_elements"), Json({{"1", 5}, {"7", 1}}));
}

TEST(Summary, OverviewHasNoEmptyList)
{
  const std::string text =
    overview_text(Scene(),
                  Counts(),
                  {{"inertia", true, "a dynamic scheme"}},
                  {});
  EXPECT_EQ(text.find("Left out"), std::string::npos);
}

TEST(Summary, ReportsPoissonsRatiosOfLateralAxes)
{
  Summary      summary;
  const double strains[] = {0.25, -0.5, 1};
  EXPECT_EQ(closing_text(summary, "out").find("Poisson"), std::string::npos);
  summary.strain.add(2, {0, 1, 2}, strains);
  EXPECT_NE(closing_text(summary, "out")
              .find("\nEffective Poisson's ratio -strain.x/strain.y = 0.5, "
                    "-strain.z/strain.y = 2 at the largest |strain.y|, "
                    "strain.y = -0.5\n"),
            std::string::npos)
    << closing_text(summary, "out");

  const Json  json   = Json::parse(summary_json(Scene(), summary));
  const Json &strain = json.at("largest_effective_strain");
  EXPECT_EQ(strain.at("time"), 2);
  EXPECT_EQ(strain.at("z"), 1);
  EXPECT_EQ(strain.at("poissons_ratio_x"), 0.5);
  EXPECT_EQ(strain.at("poissons_ratio_z"), 2);
}

TEST(Summary, ResourcesAreThoseOfTheProcess)
{
  PhaseTimes wall;
  wall.solve = 2;
  const Resources resources =
    gather_resources({5, 7, 0.5}, 3, wall, MPI_COMM_WORLD);
  EXPECT_EQ(resources.wall_seconds, 3);
  EXPECT_EQ(resources.wall.solve, 2);
  EXPECT_EQ(resources.start.program, 5);
  EXPECT_EQ(resources.start.mpi, 7);
  EXPECT_EQ(resources.start.cpu, 0.5);
  EXPECT_GT(resources.cpu_seconds, 0);
  // A process with deal.II uses between a megabyte and a terabyte.
  EXPECT_GT(resources.largest_memory, 1ul << 20);
  EXPECT_LT(resources.largest_memory, 1ul << 40);
  EXPECT_GE(resources.memory, resources.largest_memory);
}
