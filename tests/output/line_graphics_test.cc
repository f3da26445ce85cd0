#include <auxfem/output/line_graphics.h>
#include <auxfem/parameters/errors.h>

#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>
#include <support/text_file.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <sys/resource.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string root =
    std::string(AUXFEM_TEST_OUTPUT_DIRECTORY) + "/line_graphics_";

  unsigned int rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  }

  /** An empty folder, on all ranks. */
  std::string fresh_shared_folder(const std::string &name)
  {
    const std::string folder = root + name + "_on_" +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    if (rank() == 0)
      {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
      }
    MPI_Barrier(MPI_COMM_WORLD);
    return folder;
  }


  const std::vector<GraphicsField> fields = {{"displacement", 3, "m"},
                                             {"force", 1, "N"}};

  /**
   * A bent line of three points; value (field component i, point q) is
   * 10 q + i + @p offset.
   */
  void add_bent_line(LineGraphics &graphics, const float offset)
  {
    std::vector<float> values;
    for (unsigned int q = 0; q < 3; ++q)
      for (unsigned int i = 0; i < 4; ++i)
        values.push_back(10 * q + i + offset);
    graphics.add_line({{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0}}, values);
  }

  /** Entries of a .pvd file, whose end must exist. */
  unsigned int files_in_record(const std::string &file)
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(file, tree);
    return tree.get_child("VTKFile.Collection").count("DataSet");
  }

  int n_files(const std::string &folder)
  {
    return std::distance(std::filesystem::directory_iterator(folder),
                         std::filesystem::directory_iterator());
  }

  /**
   * Runs Python code that reads files with VTK's reader; returns 0 on success.
   */
  int python(const std::string &folder, const std::string &code)
  {
    const std::string file = folder + "/check.py";
    std::ofstream(file) << code;
    return std::system((std::string(AUXFEM_PYTHON) + " " + file).c_str());
  }
} // namespace

TEST(LineGraphics, VtkReadsBackWhatWasWritten)
{
  const std::string folder = fresh_shared_folder("read_back");
  GraphicsSeries    series(folder, "solution", MPI_COMM_WORLD);
  for (const double time : {0., 1. / 3})
    {
      LineGraphics graphics(fields);
      // Ranks without anything to draw write files as well.
      if (rank() == 0)
        {
          add_bent_line(graphics, time > 0 ? 0.5 : 0);
          add_bent_line(graphics, 100);
        }
      series.write(graphics, time);
    }

  if (rank() == 0)
    {
      EXPECT_EQ(python(folder, R"(
import os
import xml.etree.ElementTree as xml
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
folder = os.path.dirname(os.path.abspath(__file__))
sets = xml.parse(folder + '/solution.pvd').getroot().findall('.//DataSet')
assert len(sets) == 2
# Twelve digits of the time tell any two steps of a run apart.
assert abs(float(sets[1].get('timestep')) - 1 / 3) < 1e-11, sets[1].attrib
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(folder + '/' + sets[1].get('file'))
reader.Update()
grid = reader.GetOutput()
assert grid.GetNumberOfPoints() == 6 and grid.GetNumberOfCells() == 4
assert grid.GetPoint(1) == (1, 0.5, 0), grid.GetPoint(1)
vectors = grid.GetPointData().GetArray('displacement')
assert vectors.GetNumberOfComponents() == 3
# Written as 32-bit numbers, which hold these exactly.
assert vectors.GetTuple3(2) == (20.5, 21.5, 22.5), vectors.GetTuple3(2)
assert grid.GetPointData().GetArray('force').GetTuple1(4) == 113
)"),
                0);
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(LineGraphics, FilesNameUnits)
{
  LineGraphics graphics(fields);
  add_bent_line(graphics, 0);
  std::ostringstream text;
  graphics.write_vtu(text);
  EXPECT_NE(text.str().find("units=\"N\""), std::string::npos);
}

TEST(LineGraphics, RecordIsWholeAfterEveryFile)
{
  const std::string folder = fresh_shared_folder("record");
  const std::string record = folder + "/connectors.pvd";
  GraphicsSeries    series(folder, "connectors", MPI_COMM_WORLD);
  for (unsigned int i = 0; i < 3; ++i)
    {
      LineGraphics graphics(fields);
      add_bent_line(graphics, i);
      series.write(graphics, i);
      EXPECT_EQ(files_in_record(record), i + 1);
      MPI_Barrier(MPI_COMM_WORLD);
    }
}

TEST(LineGraphics, RecordGrowsInPlace)
{
  const std::string folder = fresh_shared_folder("in_place");
  const std::string record = folder + "/connectors.pvd";
  const std::string link   = folder + "/link.pvd";
  GraphicsSeries    series(folder, "connectors", MPI_COMM_WORLD);
  for (unsigned int i = 0; i < 3; ++i)
    {
      LineGraphics graphics(fields);
      add_bent_line(graphics, i);
      series.write(graphics, i);
      // A rewritten record would not change the hard link.
      if (i == 0 && rank() == 0)
        std::filesystem::create_hard_link(record, link);
      MPI_Barrier(MPI_COMM_WORLD);
    }
  EXPECT_EQ(read_text(link), read_text(record));
}

TEST(LineGraphics, OneRankHasOneFileATime)
{
  const std::string folder = fresh_shared_folder("files");
  GraphicsSeries    series(folder, "solution", MPI_COMM_SELF);
  LineGraphics      graphics(fields);
  add_bent_line(graphics, 0);
  series.write(graphics, 0);
  EXPECT_NE(read_text(folder + "/solution.pvd")
              .find("file=\"solution/solution_00000.vtu\""),
            std::string::npos);
  EXPECT_EQ(n_files(folder + "/solution"), 1);
}

TEST(LineGraphics, FullDiskLeavesAWholeRecord)
{
  const std::string folder = fresh_shared_folder("full");
  GraphicsSeries    series(folder, "solution", MPI_COMM_SELF);

  // Only the record exceeds this limit, in the middle of an entry.
  const auto former_action = std::signal(SIGXFSZ, SIG_IGN);
  rlimit     former{};
  getrlimit(RLIMIT_FSIZE, &former);
  const rlimit limit{5000, former.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  unsigned int n = 0;
  EXPECT_THROW(
    for (; n < 100; ++n) {
      LineGraphics graphics(fields);
      add_bent_line(graphics, 0);
      series.write(graphics, n);
    },
    ComputationError);
  setrlimit(RLIMIT_FSIZE, &former);
  std::signal(SIGXFSZ, former_action);

  EXPECT_GT(n, 10u);
  EXPECT_EQ(files_in_record(folder + "/solution.pvd"), n);
}

TEST(LineGraphics, FolderInTheWayIsRefused)
{
  const std::string folder = fresh_shared_folder("in_the_way");
  if (rank() == 0)
    std::ofstream(folder + "/solution") << "a file";
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_THROW(GraphicsSeries(folder, "solution", MPI_COMM_WORLD), InputError);
}

TEST(LineGraphics, FolderThatVanishesEndsTheRun)
{
  const std::string folder = fresh_shared_folder("vanishes");
  GraphicsSeries    series(folder, "solution", MPI_COMM_WORLD);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0)
    std::filesystem::remove_all(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  LineGraphics graphics(fields);
  add_bent_line(graphics, 0);
  EXPECT_THROW(series.write(graphics, 0), ComputationError);
}

TEST(LineGraphics, NamesOfFieldsArePlain)
{
  EXPECT_EQ(field_name("weak-1_a"), "weak-1_a");
  EXPECT_EQ(field_name("left <&> \"right\""), "left______right_");
}
