#ifndef auxfem_tests_study_report_cells_h
#define auxfem_tests_study_report_cells_h

#include <auxfem/study/study.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Text of @p scene as a study with additional lines; see SceneText. */
    inline StudyReport study_of(const std::string              &scene,
                                const std::vector<std::string> &overrides)
    {
      std::vector<std::string> all = {"Analysis=study"};
      all.insert(all.end(), overrides.begin(), overrides.end());
      return compute_study(read_scene_from_text(scene, "study.prm", all),
                           MPI_COMM_WORLD);
    }

    inline std::size_t column_number(const StudyReport &report,
                                     const std::string &name)
    {
      for (std::size_t i = 0; i < report.columns.size(); ++i)
        if (report.columns[i].name == name)
          return i;
      throw std::runtime_error("The report has no column " + name);
    }

    /** The cells of column @p name in the rows that have @p cell in column
     * @p of. */
    inline std::vector<std::string> cells_where(const StudyReport &report,
                                                const std::string &name,
                                                const std::string &of,
                                                const std::string &cell)
    {
      std::vector<std::string> cells;
      for (const std::vector<std::string> &row : report.rows)
        if (row[column_number(report, of)] == cell)
          cells.push_back(row[column_number(report, name)]);
      return cells;
    }

    /** The last number in cells_where(), of runs that have one. */
    inline double last_number_where(const StudyReport &report,
                                    const std::string &name,
                                    const std::string &of,
                                    const std::string &cell)
    {
      std::vector<std::string> cells = cells_where(report, name, of, cell);
      cells.erase(std::remove(cells.begin(), cells.end(), ""), cells.end());
      if (cells.empty())
        throw std::runtime_error("No number in column " + name);
      return std::stod(cells.back());
    }
  } // namespace testing_support
} // namespace auxfem

#endif
