#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>
#include <support/cell_scene.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Words = std::vector<std::string>;

  /** The message for case 1 with @p overrides, followed by @p text. */
  std::string message_for(const Words &overrides, const std::string &text = "")
  {
    CellCase c;
    c.scheme = "newmark";
    return input_error_of([&] {
      read_scene_from_text(cell_text(c) + text, "cell.prm", overrides);
    });
  }

} // namespace

TEST(ReducedCellScene, IsRead)
{
  CellCase c;
  c.angle           = 60;
  const Scene scene = cell_scene(c);
  ASSERT_EQ(scene.context.model, Model::reduced_cell);
  ASSERT_TRUE(scene.reduced_cell);
  EXPECT_DOUBLE_EQ(scene.reduced_cell->bar_length, 0.5);
  EXPECT_DOUBLE_EQ(scene.reduced_cell->angle, M_PI / 3);
  EXPECT_DOUBLE_EQ(scene.reduced_cell->bar_mass, 0.1);
  EXPECT_DOUBLE_EQ(scene.reduced_cell->load.value(0.1), 2e4);
  EXPECT_EQ(scene.connectors.size(), 1u);
  EXPECT_EQ(scene.lattice.cell, nullptr);
}

TEST(ReducedCellScene, PartMassIsThreeBars)
{
  const Scene scene = read_scene_from_text(cell_text(CellCase()),
                                           "cell.prm",
                                           {"Reduced cell/Part mass=auto"});
  EXPECT_DOUBLE_EQ(scene.reduced_cell->part_mass, 0.3);
}

TEST(ReducedCellMistakes, TheSceneItselfHasNone)
{
  EXPECT_EQ(message_for({}), "");
  EXPECT_EQ(message_for({"Reduced cell/Bar mass=0"}), "");
  EXPECT_EQ(message_for({"Reduced cell/Part mass=0"}), "");
}

TEST(ReducedCellMistakes, Values)
{
  for (const std::string angle : {"0", "90 deg", "-10", "120"})
    expect_parts(message_for({"Reduced cell/Angle=" + angle}),
                 {"Reduced cell/Angle = " + angle, "> 0 and < 90"});
  expect_parts(message_for({"Reduced cell/Bar length=0"}),
               {"Reduced cell/Bar length", "> 0"});
  expect_parts(message_for({"Reduced cell/Bar mass=-1"}),
               {"Reduced cell/Bar mass", ">= 0"});
  expect_parts(message_for({"Reduced cell/Load=2 kg"}),
               {"Reduced cell/Load = 2 kg"});
  expect_parts(message_for(
                 {"Reduced cell/Bar mass=0", "Reduced cell/Part mass=0"}),
               {"cell.prm:2", "nothing resists acceleration"});
}

TEST(ReducedCellMistakes, ConnectorsThatCreateEnergyOrHaveNoForce)
{
  for (const std::string law : {"kelvin-voigt", "maxwell"})
    for (const std::string stiffness : {"0", "-1"})
      expect_parts(message_for(
                     {"Connectors/connector/Law=" + law,
                      "Connectors/connector/Spring stiffness=" + stiffness}),
                   {"Connectors/connector/Spring stiffness = " + stiffness,
                    "a number > 0 in N/m",
                    "Meaning: Stiffness of the spring"});
  for (const std::string law : {"kelvin-voigt", "maxwell"})
    expect_parts(message_for({"Connectors/connector/Law=" + law,
                              "Connectors/connector/Damping coefficient=-1"}),
                 {"Damping coefficient = -1",
                  "a number >= 0 in N s/m",
                  "below 0 it would create energy"});
}

TEST(ReducedCellMistakes, ThePlaceOfTheConnectorIsFixed)
{
  for (const std::string entry : {"Between=rod",
                                  "Geometry=direction",
                                  "Direction=0 1",
                                  "Ground offset=0 1"})
    expect_parts(message_for({"Connectors/connector/" + entry}),
                 {"Connectors/connector/" + entry.substr(0, entry.find('=')) +
                    " = ",
                  "between the upper part and the rod",
                  "Remove " + entry.substr(0, entry.find('='))});
}

TEST(ReducedCellMistakes, ExactlyOneConnector)
{
  expect_parts(message_for({"Connectors/other/Law=spring",
                            "Connectors/other/Spring stiffness=1"}),
               {"Connectors has 2 groups", "exactly one"});
  std::string text = cell_text(CellCase());
  text.erase(text.find("subsection Connectors"),
             text.find("subsection Time") - text.find("subsection Connectors"));
  try
    {
      read_scene_from_text(text, "cell.prm");
      ADD_FAILURE();
    }
  catch (const InputError &error)
    {
      expect_parts(error.what(), {"Connectors has 0 groups"});
    }
}

TEST(ReducedCellMistakes, SubsectionsOfTheOtherModel)
{
  const std::string text = cell_text(CellCase());
  const std::string line =
    std::to_string(1 + std::count(text.begin(), text.end(), '\n'));
  for (const std::string name : {"Lattice",
                                 "Sets",
                                 "Sections",
                                 "Supports",
                                 "Loads",
                                 "Effects",
                                 "Discretization",
                                 "Solver",
                                 "Probes"})
    expect_parts(message_for({}, "subsection " + name + "\nend\n"),
                 {"cell.prm:" + line + ": subsection \"" + name +
                    "\" has no meaning with Model = reduced cell",
                  "Remove it",
                  "Allowed here: Reduced cell, Connectors, Time, Newton, "
                  "Output"});
  expect_parts(message_for({"Model=lattice"}),
               {"cell.prm:2: subsection \"Reduced cell\" has no meaning with "
                "Model = lattice"});
}

TEST(ReducedCellMistakes, AModelThatIsNoneHidesNothingElse)
{
  const std::string message = message_for({"Model=reduced cel"});
  expect_parts(message, {"Model = reduced cel", "did you mean"});
  EXPECT_EQ(message.find("Lattice"), std::string::npos) << message;
}

TEST(ReducedCellMistakes, SchemesOfTheOtherModel)
{
  expect_parts(message_for({"Time/Scheme=static"}),
               {"Time/Scheme = static", "mechanism", "Scheme = newmark"});
  for (const std::string scheme :
       {"central difference", "as printed", "arkode"})
    try
      {
        read_scene_from_text("subsection Lattice\n set Cell = star\nend\n"
                             "subsection Time\n set Scheme = " +
                               scheme + "\nend\n",
                             "lattice.prm");
        ADD_FAILURE() << scheme;
      }
    catch (const InputError &error)
      {
        expect_parts(error.what(),
                     {"Time/Scheme = " + scheme +
                      " integrates the reduced cell only"});
      }
}

TEST(ReducedCellMistakes, FeaturesOfLatticesOnly)
{
  expect_parts(message_for({"Time/Start from=static equilibrium"}),
               {"Start from = static equilibrium", "starts from rest"});
  expect_parts(message_for({"Time/Smallest time step=1e-6"}),
               {"Smallest time step", "never repeated"});
}
