#ifndef auxfem_tests_support_graphics_series_h
#define auxfem_tests_support_graphics_series_h

#include <support/run_program.h>

namespace auxfem
{
  namespace testing_support
  {
    /** A .pvd file with all it names, as VTK reads it. */
    class GraphicsSeries
    {
    public:
      /**
       * Reads @p pvd, or a single .vtu, by read_vtu.py, which leaves its tables in @p folder.
       * Throws std::runtime_error with the words of VTK if that fails.
       */
      GraphicsSeries(const std::string &pvd, const std::string &folder)
        : datasets(read(pvd, folder))
      {
        for (unsigned int i = 0; i < datasets.n_rows; ++i)
          {
            const std::string file = folder + "/" + std::to_string(i);
            points.emplace_back(file + ".points.csv");
            segments.emplace_back(file + ".segments.csv");
          }
      }

      /** number, time, points, segments, pieces of each data set. */
      Table datasets;

      /** For each data set: x, y, z and all fields of its points. */
      std::vector<Table> points;

      /** For each data set: first, second, rows of the points. */
      std::vector<Table> segments;

    private:
      static Table read(const std::string &pvd, const std::string &folder)
      {
        std::filesystem::create_directories(folder);
        const std::string messages = folder + "/messages.txt";
        const std::string script =
          std::string(AUXFEM_TEST_DATA_DIRECTORY) + "/../support/read_vtu.py";
        const std::string command = "'" AUXFEM_PYTHON "' '" + script + "' '" +
          pvd + "' '" + folder + "' >'" + messages + "' 2>&1";
        if (std::system(command.c_str()) != 0)
          throw std::runtime_error(read_text(messages));
        return Table(folder + "/datasets.csv");
      }
    };

    /** The rows of @p points at the position (@p x, @p y). */
    inline std::vector<unsigned int>
    rows_at(const Table &points, const double x, const double y)
    {
      // Positions are written with seven digits.
      const double tolerance = 1e-6 * (std::abs(x) + std::abs(y) + 1e-3);

      std::vector<unsigned int> rows;
      for (unsigned int i = 0; i < points.n_rows; ++i)
        if (std::hypot(points["x"][i] - x, points["y"][i] - y) < tolerance)
          rows.push_back(i);
      return rows;
    }

    /** The row of @p table with @p time. */
    inline unsigned int row_at_time(const Table &table, const double time)
    {
      for (unsigned int i = 0; i < table.n_rows; ++i)
        if (std::abs(table["time"][i] - time) <= 1e-5 * time)
          return i;
      throw std::runtime_error("There is no row for t = " +
                               std::to_string(time));
    }
  } // namespace testing_support
} // namespace auxfem

#endif
