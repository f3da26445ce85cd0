#include <auxfem/equations/node_rotations.h>
#include <auxfem/output/history.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/mpi.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/energy_amount.h>
#include <support/scene_text.h>

#include <algorithm>
#include <map>
#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Four joints in a row, three struts; enough for two ranks. */
  const SceneText lattice_text =
    SceneText()
      .frame("0 0; 1 0; 2 0; 3 0", "0 1; 1 2; 2 3")
      .circle("band", "5 mm", {"70 GPa", "2700 kg/m3", 0.3})
      .support("wall", "0, 3", "clamp")
      .connector("damper",
                 "kelvin-voigt",
                 "Spring stiffness = 200 N/m | "
                 "Damping coefficient = 5 N s/m | Between = 0 1; 1 2")
      .time("1 s", "0.1 s", "newmark");

  /** The row of @p solution by column. */
  std::map<std::string, double> row_of(History        &history,
                                       const Solution &solution)
  {
    const std::vector<Column> &columns = history.columns();
    const std::vector<double> &values  = history.values(solution);
    EXPECT_EQ(columns.size(), values.size());
    std::map<std::string, double> row;
    for (std::size_t i = 0; i < std::min(columns.size(), values.size()); ++i)
      row[columns[i].name] = values[i];
    return row;
  }

  /** Gives component @p c of joint j the value @p value(j) in @p vector. */
  template <typename Function>
  void set_joints(Vector             &vector,
                  const LatticeModel &model,
                  const unsigned int  c,
                  const Function     &value)
  {
    for (unsigned int j = 0; j < model.lattice.joints.size(); ++j)
      {
        const int unknown = model.numbering.joint_unknown(j, c);
        if (unknown >= 0)
          vector[unknown] = value(j);
      }
  }
} // namespace

TEST(History, RowHoldsMeansOfProbesAndSumsOfSupportsAndConnectors)
{
  const EquationsOnRanks scene_equations(
    SceneText(lattice_text)
      .probe("middle", "1, 2")
      .add("Loads/push", "Joints = 1 | Force x = 1"),
    {"Sections/band/Stiffness-proportional damping=0.1"});
  const LatticeModel &model = scene_equations.model;
  History             history(scene_equations.scene,
                  scene_equations.equations,
                  MPI_COMM_WORLD);

  const State from = scene_equations.equations.initial_state();
  Solution    solution{from, scene_equations.equations.make_results()};
  State      &to = solution.state;
  to.time        = 0.25;
  set_joints(to.displacement, model, 0, [](const unsigned int j) {
    return 0.25 * j;
  });
  set_joints(to.displacement, model, rotation_z, [](const unsigned int j) {
    return 0.125 - 0.5 * j;
  });
  set_joints(*to.velocity, model, 1, [](const unsigned int j) {
    return 1. * j;
  });
  const Evaluation step = Evaluation::step(from, to, 0.25);
  scene_equations.equations.residual(step, solution.results);
  // Known numbers replace the true residual, also in free rows.
  for (unsigned int i = 0; i < 3; ++i)
    set_joints(to.residual,
               model,
               model.numbering.components()[i],
               [i](const unsigned int j) { return 10. * (i + 1) + j; });
  for (const auto &[entry, amount] : {std::pair("kinetic", 1),
                                      std::pair("strain", 2),
                                      std::pair("stored", 4),
                                      std::pair("damper.dissipated", 3),
                                      std::pair("strut_damping_dissipated", 5),
                                      std::pair("push.load_work", 16)})
    energy_amount(to.energies, entry) = amount;

  std::map<std::string, double> row = row_of(history, solution);
  // All inputs have few binary digits: sums and means of them are exact.
  EXPECT_EQ(row["time"], 0.25);
  EXPECT_EQ(row["middle.ux"], 0.375);
  EXPECT_EQ(row["middle.uy"], 0);
  EXPECT_EQ(row["middle.phi"], -0.625);
  EXPECT_EQ(row["middle.vx"], 0);
  EXPECT_EQ(row["middle.vy"], 1.5);
  EXPECT_EQ(row["wall.rx"], 10 + 13);
  EXPECT_EQ(row["wall.ry"], 20 + 23);
  EXPECT_EQ(row["wall.m"], 30 + 33);
  // Both connectors lie along x, are 0.25 m longer and have no rate along their
  // line (the joints move along y): 2 * 200 N/m * 0.25 m. A few roundings.
  EXPECT_NEAR(row["damper.extension"], 0.5, 1e-14);
  EXPECT_NEAR(row["damper.force"], 100, 1e-11);
  EXPECT_EQ(row["damper.dissipated"], 3);
  EXPECT_EQ(row["strut_damping_dissipated"], 5);
  EXPECT_EQ(row["push.load_work"], 16);
  EXPECT_EQ(row["kinetic"], 1);
  EXPECT_EQ(row["strain"], 2);
  EXPECT_EQ(row["stored"], 4);
  EXPECT_EQ(row["dissipated"], 8);
  EXPECT_EQ(row["external"], 16);
  // The balance starts from the first row.
  EXPECT_EQ(row["balance"], 0);
  // Joint 3 rotates most; only its rank knows.
  EXPECT_EQ(dealii::Utilities::MPI::max(history.largest_rotation(),
                                        MPI_COMM_WORLD),
            1.375);
}

TEST(History, RowInSpaceHasThreeOfEach)
{
  const EquationsOnRanks scene_equations(
    SceneText(lattice_text)
      .dimension(3)
      .probe("middle", "1, 2")
      .set("Output/Effective strains", "true"));
  const LatticeModel &model = scene_equations.model;
  History             history(scene_equations.scene,
                  scene_equations.equations,
                  MPI_COMM_WORLD);

  const State from = scene_equations.equations.initial_state();
  Solution    solution{from, scene_equations.equations.make_results()};
  State      &to = solution.state;
  for (const unsigned int c : {0, 2})
    set_joints(to.displacement, model, c, [c](const unsigned int j) {
      return 0.25 * (j + c);
    });
  // Joint j rotates by 2 j + 3 about (0.6, 0, -0.8): 5 and 7 in the middle.
  for (const auto &[c, along] : {std::pair(3u, 0.6), std::pair(5u, -0.8)})
    set_joints(to.displacement, model, c, [axis = along](const unsigned int j) {
      return axis * (2 * j + 3);
    });
  set_joints(*to.velocity, model, 2, [](const unsigned int j) {
    return 1. * j;
  });
  const Evaluation step = Evaluation::step(from, to, 0.25);
  NodeRotations(model.numbering).follow(step);
  scene_equations.equations.residual(step, solution.results);
  for (unsigned int c = 0; c < n_motion_components; ++c)
    set_joints(to.residual, model, c, [c](const unsigned int j) {
      return 10. * (c + 1) + j;
    });

  std::map<std::string, double> row = row_of(history, solution);
  EXPECT_EQ(row["middle.ux"], 0.375);
  EXPECT_EQ(row["middle.uy"], 0);
  EXPECT_EQ(row["middle.uz"], 0.875);
  // A few roundings in the sines of half angles of a turn and more.
  EXPECT_NEAR(row["middle.phi_x"], 6 * 0.6, 1e-13);
  EXPECT_NEAR(row["middle.phi_y"], 0, 1e-13);
  EXPECT_NEAR(row["middle.phi_z"], 6 * -0.8, 1e-13);
  EXPECT_EQ(row["middle.vx"], 0);
  EXPECT_EQ(row["middle.vy"], 0);
  EXPECT_EQ(row["middle.vz"], 1.5);
  EXPECT_EQ(row["wall.rx"], 10 + 13);
  EXPECT_EQ(row["wall.ry"], 20 + 23);
  EXPECT_EQ(row["wall.rz"], 30 + 33);
  EXPECT_EQ(row["wall.mx"], 40 + 43);
  EXPECT_EQ(row["wall.my"], 50 + 53);
  EXPECT_EQ(row["wall.mz"], 60 + 63);
  for (const char *name : {"middle.phi", "wall.m", "strain.y", "strain.z"})
    EXPECT_EQ(row.count(name), 0u) << name;
  // 0.75 m more at the right end of the row than at the left, 3 m away.
  EXPECT_EQ(row["strain.x"], 0.25);
  // Joint 2 has the largest: beyond half a revolution only probes count.
  EXPECT_NEAR(dealii::Utilities::MPI::max(history.largest_rotation(),
                                          MPI_COMM_WORLD),
              7,
              1e-13);
  EXPECT_FALSE(history.largest_strain().along(0)) << "there is none along y";
}

TEST(History, EveryColumnHasAUnit)
{
  const EquationsOnRanks scene_equations(lattice_text);
  const History          history(scene_equations.scene,
                        scene_equations.equations,
                        MPI_COMM_WORLD);
  std::set<std::string>  names;
  for (const Column &column : history.columns())
    {
      EXPECT_TRUE(names.insert(column.name).second) << column.name << " twice";
      EXPECT_FALSE(column.unit.empty()) << column.name;
      EXPECT_FALSE(column.meaning.empty()) << column.name;
    }
  EXPECT_EQ(history.columns().front().name, "time");
  EXPECT_EQ(names.count("damper.force"), 1u);
}

TEST(History, ProbeWithoutJointsIsRejected)
{
  const EquationsOnRanks scene_equations(
    SceneText(lattice_text).probe("lost", "17"));
  try
    {
      History history(scene_equations.scene,
                      scene_equations.equations,
                      MPI_COMM_WORLD);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("Probes/lost"),
                std::string::npos);
    }
}
