#include <auxfem/equations/displaced_state.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/shape_amplitude.h>
#include <auxfem/output/singular_point_files.h>

#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string prefix = "singular_";

    const std::vector<Column> singular_columns = {
      {"number", "", "in the order of the path"},
      {"kind", "", "limit point or bifurcation"},
      {"load_factor", "1", "there"},
      {"arc_length", "m", "there, as in history.csv"},
      {"multiplicity", "", "eigenvalues that change their sign"},
      {"negative_before",
       "",
       "negative eigenvalues of the stiffness before the point; nan: not known"},
      {"negative_after", "", "those after it"}};

    std::string number_text(const double value)
    {
      std::ostringstream text;
      text.precision(15);
      text << value;
      return text.str();
    }

    std::string count_text(const std::optional<unsigned long> &count)
    {
      return count ? std::to_string(*count) : "nan";
    }
  } // namespace

  FolderContents path_contents()
  {
    FolderContents contents{{"singular_points.csv",
                             "singular_points.units.csv"},
                            {}};
    for (const char *series : {"solution", "rigid_parts", "connectors"})
      contents.series.push_back(prefix + series);
    return contents;
  }

  std::string text_of(const SingularPoint::Kind kind)
  {
    return kind == SingularPoint::Kind::limit ? "limit point" : "bifurcation";
  }

  std::string text_of(const State         &at,
                      const SingularPoint &point,
                      const unsigned int   number)
  {
    std::ostringstream text;
    text.precision(10);
    text << "  " << number << ": " << text_of(point.kind) << " at load factor "
         << at.path->load_factor;
    if (point.multiplicity() > 1)
      text << ", " << point.multiplicity() << " directions at once";
    if (point.n_negative_before && point.n_negative_after)
      text << "; negative eigenvalues: " << *point.n_negative_before
           << " before, " << *point.n_negative_after << " after";
    return text.str();
  }

  SingularPointFiles::SingularPointFiles(const Scene     &scene,
                                         const Equations &equations,
                                         const MPI_Comm   communicator)
    : scene(scene)
    , equations(equations)
    , communicator(communicator)
  {
    const std::string &folder = scene.output.directory;
    on_first_rank(communicator, [&]() {
      table.emplace(folder + "/singular_points.csv", singular_columns);
      write_column_reference(folder + "/singular_points.units.csv",
                             singular_columns);
    });
    if (scene.output.graphics)
      graphics.emplace(scene, equations, folder, communicator, prefix);
  }

  void SingularPointFiles::write(const State &at, const SingularPoint &point)
  {
    ++n_written;
    on_first_rank(communicator, [&]() {
      table->append_text({std::to_string(n_written),
                          text_of(point.kind),
                          number_text(at.path->load_factor),
                          number_text(at.time),
                          std::to_string(point.multiplicity()),
                          count_text(point.n_negative_before),
                          count_text(point.n_negative_after)});
    });
    if (!graphics || point.null_vector.empty())
      return;
    const State before =
      displaced(at,
                equations.model().numbering,
                point.null_vector,
                shape_amplitude(scene, equations, point.null_vector));
    Solution solution{before, equations.make_results()};
    equations.residual(Evaluation::equilibrium(before, solution.state),
                       solution.results);
    solution.state.time = n_written;
    graphics->write_struts(solution.state);
    graphics->write_rigid_parts(solution.state);
    graphics->write_connectors(solution);
  }

  unsigned int SingularPointFiles::number() const
  {
    return n_written;
  }

  std::vector<std::string> SingularPointFiles::series() const
  {
    return graphics ? graphics->series() : std::vector<std::string>();
  }
} // namespace auxfem
