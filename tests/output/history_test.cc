#include <auxfem/model/build_lattice.h>
#include <auxfem/output/history.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

using namespace auxfem;

namespace
{
  /** Four joints in a row, three struts; enough for two ranks. */
  const std::string lattice_text = R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 1 0; 2 0; 3 0
  set Struts = 0 1; 1 2; 2 3
end
subsection Sections
  subsection band
    set Shape           = circle
    set Radius          = 5 mm
    set Young's modulus = 70 GPa
    set Poisson's ratio = 0.3
    set Density         = 2700 kg/m3
  end
end
subsection Supports
  subsection wall
    set Joints = 0, 3
    set Type   = clamp
  end
end
subsection Connectors
  subsection damper
    set Law                 = kelvin-voigt
    set Spring stiffness    = 200 N/m
    set Damping coefficient = 5 N s/m
    set Between             = 0 1; 1 2
  end
end
subsection Time
  set Scheme    = newmark
  set End time  = 1 s
  set Time step = 0.1 s
end
)";

  std::string fresh_folder(const std::string &name)
  {
    const std::string folder = std::string(AUXFEM_TEST_OUTPUT_DIRECTORY) +
      "/history_" + name + "_on_" +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
      }
    MPI_Barrier(MPI_COMM_WORLD);
    return folder;
  }

  std::vector<std::string> split(const std::string &line)
  {
    std::istringstream       stream(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(stream, field, ',');)
      fields.push_back(field);
    return fields;
  }

  /** Values of the last row of history.csv by column. */
  std::map<std::string, double> last_row(const std::string &folder)
  {
    std::ifstream stream(folder + "/history.csv");
    std::string   header, line, last;
    std::getline(stream, header);
    while (std::getline(stream, line))
      last = line;
    const std::vector<std::string> names = split(header), values = split(last);
    EXPECT_EQ(names.size(), values.size());
    std::map<std::string, double> row;
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i)
      row[names[i]] = std::stod(values[i]);
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
  const Scene       scene   = read_scene_from_text(lattice_text +
                                             "subsection Probes\n"
                                                     "  set middle = 1, 2\n"
                                                     "end\n",
                                           "history_test");
  const Lattice     lattice = build_lattice(scene);
  System            system(scene, lattice, MPI_COMM_WORLD);
  const std::string folder = fresh_folder("row");
  History           history(scene, system, folder, MPI_COMM_WORLD);

  const State from = system.initial_state();
  State       to   = from;
  to.time          = 0.25;
  set_joints(to.displacement, system, 0, [](const unsigned int j) {
    return 0.25 * j;
  });
  set_joints(to.displacement, system, rotation_z, [](const unsigned int j) {
    return 0.125 - 0.5 * j;
  });
  set_joints(*to.velocity, system, 1, [](const unsigned int j) {
    return 1. * j;
  });
  const Evaluation step = Evaluation::step(from, to, 0.25);
  system.residual(step);
  // Known numbers in place of the true residual, free rows included.
  for (unsigned int i = 0; i < 3; ++i)
    set_joints(to.residual,
               system,
               model.numbering.components()[i],
               [i](const unsigned int j) { return 10. * (i + 1) + j; });
  to.energies = {1, 2, 4, 8, 16};
  history.write(to);

  std::map<std::string, double> row = last_row(folder);
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
  EXPECT_EQ(row["damper.dissipated"], 0);
  EXPECT_EQ(row["kinetic"], 1);
  EXPECT_EQ(row["strain"], 2);
  EXPECT_EQ(row["stored"], 4);
  EXPECT_EQ(row["dissipated"], 8);
  EXPECT_EQ(row["external"], 16);
  // The first row is what the balance starts from.
  EXPECT_EQ(row["balance"], 0);
  // Joint 3 turns most; known to its rank only.
  EXPECT_EQ(dealii::Utilities::MPI::max(history.largest_rotation(),
                                        MPI_COMM_WORLD),
            1.375);
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(History, RowInSpaceHasThreeOfEach)
{
  const Scene scene =
    read_scene_from_text("set Dimension = 3\n" + lattice_text +
                           "subsection Probes\n"
                           "  set middle = 1, 2\n"
                           "end\n"
                           "subsection Output\n"
                           "  set Effective strains = true\n"
                           "end\n",
                         "history_test");
  const Lattice     lattice = build_lattice(scene);
  System            system(scene, lattice, MPI_COMM_WORLD);
  const std::string folder = fresh_folder("space");
  History           history(scene, system, folder, MPI_COMM_WORLD);

  const State from = system.initial_state();
  State       to   = from;
  for (const unsigned int c : {0, 2})
    set_joints(to.displacement, system, c, [c](const unsigned int j) {
      return 0.25 * (j + c);
    });
  // Joint j turns by 2 j + 3 about (0.6, 0, -0.8): 5 and 7 in the middle.
  for (const auto &[c, along] : {std::pair(3u, 0.6), std::pair(5u, -0.8)})
    set_joints(to.displacement, system, c, [&](const unsigned int j) {
      return along * (2 * j + 3);
    });
  set_joints(*to.velocity, system, 2, [](const unsigned int j) {
    return 1. * j;
  });
  const Evaluation step = Evaluation::step(from, to, 0.25);
  system.rotations().follow(step);
  system.residual(step);
  for (unsigned int c = 0; c < n_motion_components; ++c)
    set_joints(to.residual, system, c, [c](const unsigned int j) {
      return 10. * (c + 1) + j;
    });
  history.write(to);

  std::map<std::string, double> row = last_row(folder);
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
  EXPECT_NEAR(dealii::Utilities::MPI::max(history.largest_rotation(),
                                          MPI_COMM_WORLD),
              9,
              1e-13);
  EXPECT_FALSE(history.largest_strain().along(0)) << "there is none along y";
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(History, EveryColumnHasAUnit)
{
  const Scene       scene = read_scene_from_text(lattice_text, "history_test");
  const Lattice     lattice = build_lattice(scene);
  System            system(scene, lattice, MPI_COMM_WORLD);
  const std::string folder = fresh_folder("units");
  History           history(scene, system, folder, MPI_COMM_WORLD);

  std::ifstream table(folder + "/history.csv"),
    reference(folder + "/history.units.csv");
  std::string header, line;
  std::getline(table, header);
  std::getline(reference, line);
  EXPECT_EQ(line, "column,unit,meaning");
  for (const std::string &name : split(header))
    {
      std::getline(reference, line);
      const std::vector<std::string> fields = split(line);
      ASSERT_GE(fields.size(), 3u);
      EXPECT_EQ(fields[0], name);
      EXPECT_FALSE(fields[1].empty());
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(History, ProbeOnNothingIsRefused)
{
  const Scene       scene   = read_scene_from_text(lattice_text +
                                             "subsection Probes\n"
                                                     "  set lost = 17\n"
                                                     "end\n",
                                           "history_test");
  const Lattice     lattice = build_lattice(scene);
  System            system(scene, lattice, MPI_COMM_WORLD);
  const std::string folder = fresh_folder("lost");
  try
    {
      History history(scene, system, folder, MPI_COMM_WORLD);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("Probes/lost"),
                std::string::npos);
    }
}
