#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/singular_point_files.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Largest extension of the lattice along an axis (m). */
    double extension(const Lattice &lattice)
    {
      const auto [lower, upper] = bounding_box(lattice);
      double largest            = 0;
      for (unsigned int d = 0; d < 3; ++d)
        largest = std::max(largest, upper[d] - lower[d]);
      return largest;
    }
  } // namespace

  double shape_amplitude(const Scene     &scene,
                         const Equations &equations,
                         const Vector    &shape)
  {
    const LatticeModel &model   = equations.model();
    const double        largest = model.numbering.layout().largest(
      largest_size(shape.data(), model.rows.free_translations));
    return largest > 0
      ? scene.modes.amplitude * extension(model.lattice) / largest
      : 1.;
  }

  namespace
  {
    const std::string series_prefix = "singular_",
                      table_name    = "singular_points.csv",
                      files_record = "output: singular points, length of their "
                                     "table";

    const std::vector<Column> singular_columns = {
      {"number", "", "number along the path"},
      {"kind", "", "limit point or bifurcation"},
      {"load_factor", "1", "load factor at the point"},
      {"arc_length", "m", "arc length at the point, as in history.csv"},
      {"multiplicity", "", "number of eigenvalues that change their sign"},
      {"negative_before",
       "",
       "negative eigenvalues of the stiffness before the point; nan: unknown"},
      {"negative_after", "", "negative eigenvalues after the point"},
      {"determinant_before",
       "",
       "sign of the determinant of the stiffness before the point, 1 if "
       "stable; nan: unknown"},
      {"determinant_after", "", "sign of the determinant after the point"},
      {"part_of_loads",
       "",
       "cosine of the angle between the loads and the null vector of the "
       "transposed stiffness: 0 at bifurcations up to round-off; nan: "
       "unknown"}};

    template <class Number>
    std::string count_text(const std::optional<Number> &count)
    {
      return count ? std::to_string(*count) : "nan";
    }
  } // namespace

  FolderContents path_contents()
  {
    FolderContents contents{{table_name, "singular_points.units.csv"}, {}};
    for (const char *series : {"solution", "rigid_parts", "connectors"})
      contents.series.push_back(series_prefix + series);
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
    if (point.before.n_negative && point.after.n_negative)
      text << "; negative eigenvalues: " << *point.before.n_negative
           << " before, " << *point.after.n_negative << " after";
    else if (point.before.determinant_sign && point.after.determinant_sign)
      text << "; sign of the determinant: " << *point.before.determinant_sign
           << " before, " << *point.after.determinant_sign << " after";
    return text.str();
  }

  SingularPointFiles::SingularPointFiles(
    const Scene          &scene,
    const Equations      &equations,
    const MPI_Comm        communicator,
    const CheckpointData *restart_checkpoint)
    : scene(scene)
    , equations(equations)
    , communicator(communicator)
  {
    const std::string  &folder = scene.output.directory;
    std::vector<double> restored_values;
    if (restart_checkpoint != nullptr)
      {
        restored_values = restart_checkpoint->values(files_record, 2);
        n_written       = restored_values[0];
      }
    on_first_rank(communicator, [&]() {
      const std::string name = folder + "/" + table_name;
      if (restart_checkpoint != nullptr)
        table.emplace(name, singular_columns, restored_values[1]);
      else
        table.emplace(name, singular_columns);
      write_column_reference(folder + "/singular_points.units.csv",
                             singular_columns);
    });
    if (scene.output.graphics)
      graphics.emplace(scene, equations, folder, communicator, series_prefix);
  }

  void SingularPointFiles::write(const State &at, const SingularPoint &point)
  {
    ++n_written;
    on_first_rank(communicator, [&]() {
      table->append_text(
        {std::to_string(n_written),
         text_of(point.kind),
         text_of_cell(at.path->load_factor),
         text_of_cell(at.time),
         std::to_string(point.multiplicity()),
         count_text(point.before.n_negative),
         count_text(point.after.n_negative),
         count_text(point.before.determinant_sign),
         count_text(point.after.determinant_sign),
         point.load_projection ? text_of_cell(*point.load_projection) : "nan"});
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

  void SingularPointFiles::serialize(CheckpointArchive &archive)
  {
    double length = table ? table->length() : 0;
    archive.values(files_record, n_written, length);
    if (graphics)
      graphics->serialize(archive);
  }

  std::vector<std::string> SingularPointFiles::files() const
  {
    std::vector<std::string> names = {table_name};
    if (n_written > 0)
      for (const std::string &name : series())
        names.push_back(name + ".pvd");
    return names;
  }

  std::vector<std::string> SingularPointFiles::series() const
  {
    return graphics ? graphics->series() : std::vector<std::string>();
  }
} // namespace auxfem
