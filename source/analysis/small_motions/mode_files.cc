#include <auxfem/analysis/small_motions/mode_files.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/singular_point_files.h>
#include <auxfem/output/vtu_writer.h>
#include <auxfem/parameters/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;

    constexpr unsigned int max_modes = 1000;

    /** Names of tables. */
    const std::string natural_table = "modes", complex_table = "complex_modes",
                      buckling_table   = "buckling",
                      relaxation_table = "relaxations";

    using Rows = std::vector<std::vector<double>>;

    /** Writes a table and its column reference. */
    void write_table(const std::string         &folder,
                     const std::string         &name,
                     const std::vector<Column> &columns,
                     const Rows                &rows)
    {
      CsvTable table(folder + '/' + name + ".csv", columns);
      for (const std::vector<double> &row : rows)
        table.append(row);
      write_column_reference(folder + '/' + name + ".units.csv", columns);
    }

    std::string prefix(const unsigned int number)
    {
      return "mode_" + std::to_string(number) + "_";
    }

    const Column mesh_error_column = {
      "mesh_error",
      "1",
      "discretization error by comparison with finer elements, relative to the "
      "frequency or factor; nan: unknown"};

    const std::vector<Column> buckling_columns = {
      {"mode", "", "number, by increasing factor"},
      {"factor", "1", "factor of the loads at which the lattice buckles"},
      {"residual", "1", "relative residual of the equilibrium equations"},
      mesh_error_column};

    const std::vector<Column> relaxation_columns = {
      {"relaxation", "", "number, the slowest first"},
      {"time", "s", "relaxation time, of decay to 1/e"},
      {"rate", "1/s", "1 / time"},
      {"residual", "1", "relative residual of the equations of motion"}};

    const std::vector<Column> complex_columns = {
      {"mode", "", "number, by increasing magnitude of the eigenvalue"},
      {"frequency", "Hz", "frequency; 0 if the mode does not oscillate"},
      {"angular_frequency", "rad/s", "frequency times 2 pi"},
      {"growth_rate",
       "1/s",
       "rate r of growth as exp(r t); positive: flutter, or divergence without "
       "oscillation"},
      {"damping_ratio",
       "1",
       "damping over critical damping; negative if the mode grows"},
      {"residual", "1", "relative residual of the equations of motion"},
      mesh_error_column};

    std::vector<Column> natural_columns()
    {
      std::vector<Column> all = {
        {"mode", "", "number, by increasing frequency"},
        {"frequency", "Hz", "natural frequency; 0 for an unstable mode"},
        {"angular_frequency", "rad/s", "frequency times 2 pi"},
        {"period", "s", "1 / frequency; inf without stiffness"},
        {"eigenvalue",
         "1/s2",
         "square of the angular frequency; negative for an unstable mode"},
        {"growth_rate",
         "1/s",
         "rate r of an unstable mode, which grows as exp(r t)"},
        {"residual", "1", "relative residual of the equations of motion"},
        {"damped_frequency",
         "Hz",
         "frequency with damping; nan: not requested or not found"},
        {"damping_ratio", "1", "damping over critical damping"}};
      for (const char *axis : {"x", "y", "z"})
        {
          all.push_back(
            {std::string("participation_") + axis,
             "kg^1/2",
             "product of the mode, of modal mass 1 kg, and the inertia of a "
             "unit translation"});
          all.push_back({std::string("effective_mass_") + axis,
                         "kg",
                         "square of the participation"});
        }
      all.push_back(mesh_error_column);
      return all;
    }

    std::vector<double> row(const NaturalMode &mode, const unsigned int number)
    {
      constexpr double    nan       = std::numeric_limits<double>::quiet_NaN();
      const double        frequency = mode.angular_frequency() / (2 * PI);
      std::vector<double> values    = {double(number),
                                       frequency,
                                       mode.angular_frequency(),
                                       1 / frequency,
                                       mode.eigenvalue,
                                       mode.growth_rate(),
                                       mode.residual,
                                       nan,
                                       nan};
      if (mode.damped)
        {
          values[7] = mode.damped->angular_frequency / (2 * PI);
          values[8] = mode.damped->ratio();
        }
      for (const double participation : mode.participation)
        {
          values.push_back(participation);
          values.push_back(participation * participation);
        }
      values.push_back(mode.mesh_error);
      return values;
    }

    /**
     * @p real times the real part plus @p imaginary times the imaginary part.
     */
    Vector
    shape_at(const ModePicture &mode, const double real, const double imaginary)
    {
      Vector shape = mode.shape;
      scale(real, shape);
      if (mode.imaginary != nullptr)
        for (std::size_t i = 0; i < shape.size(); ++i)
          shape[i] += imaginary * (*mode.imaginary)[i];
      return shape;
    }

    void set_velocity(const Vector &shape, const double factor, State &state)
    {
      if (!state.velocity)
        return;
      *state.velocity = shape;
      scale(factor, *state.velocity);
    }
  } // namespace

  FolderContents mode_contents()
  {
    FolderContents contents;
    for (const std::string &table :
         {natural_table, complex_table, buckling_table, relaxation_table})
      for (const char *ending : {".csv", ".units.csv"})
        contents.files.push_back(table + ending);
    for (unsigned int number = 1; number <= max_modes; ++number)
      for (const char *series : {"solution", "rigid_parts", "connectors"})
        contents.series.push_back(prefix(number) + series);
    return contents;
  }

  void write_mode_table(const NaturalModes &found, const std::string &folder)
  {
    Rows rows;
    for (unsigned int i = 0; i < found.modes.size(); ++i)
      rows.push_back(row(found.modes[i], i + 1));
    write_table(folder, natural_table, natural_columns(), rows);
  }

  void write_mode_table(const ComplexModes &found, const std::string &folder)
  {
    Rows rows;
    for (unsigned int i = 0; i < found.modes.size(); ++i)
      {
        const ComplexMode &mode = found.modes[i];
        rows.push_back({double(i + 1),
                        mode.s.imag() / (2 * PI),
                        mode.s.imag(),
                        mode.s.real(),
                        mode.ratio(),
                        mode.residual,
                        mode.mesh_error});
      }
    write_table(folder, complex_table, complex_columns, rows);
  }

  void write_mode_table(const BucklingModes &found, const std::string &folder)
  {
    Rows rows;
    for (unsigned int i = 0; i < found.modes.size(); ++i)
      rows.push_back({double(i + 1),
                      found.modes[i].factor,
                      found.modes[i].residual,
                      found.modes[i].mesh_error});
    write_table(folder, buckling_table, buckling_columns, rows);
  }

  std::string mode_table_text(const ComplexModes &found)
  {
    std::ostringstream text;
    text << "  mode   frequency   growth rate   damping ratio    residual  "
            "mesh error\n"
         << "                Hz           1/s";
    for (unsigned int i = 0; i < found.modes.size(); ++i)
      {
        const ComplexMode &mode = found.modes[i];
        text << '\n'
             << std::setw(6) << i + 1 << std::defaultfloat
             << std::setprecision(6) << std::setw(12)
             << mode.s.imag() / (2 * PI) << std::setprecision(4)
             << std::setw(14) << rounded_text(mode.s.real(), 4) << std::setw(16)
             << rounded_text(mode.ratio(), 4) << std::scientific
             << std::setprecision(1) << std::setw(12) << mode.residual
             << std::setw(12) << mode.mesh_error;
        if (mode.grows())
          text << (mode.swings() ? "   flutter" : "   divergence");
      }
    return text.str();
  }

  void write_mode_table(const Relaxations &found, const std::string &folder)
  {
    Rows rows;
    for (unsigned int i = 0; i < found.size(); ++i)
      rows.push_back(
        {double(i + 1), found[i].time(), found[i].rate, found[i].residual});
    write_table(folder, relaxation_table, relaxation_columns, rows);
  }

  std::string mode_table_text(const Relaxations &found)
  {
    std::ostringstream text;
    text << "  relaxation        time    residual\n"
         << "                       s";
    for (unsigned int i = 0; i < found.size(); ++i)
      text << '\n'
           << std::setw(12) << i + 1 << std::defaultfloat
           << std::setprecision(6) << std::setw(12) << found[i].time()
           << std::scientific << std::setprecision(1) << std::setw(12)
           << found[i].residual;
    return text.str();
  }

  std::string mode_table_text(const BucklingModes &found)
  {
    std::ostringstream text;
    text << "  mode   factor of loads    residual  mesh error";
    for (unsigned int i = 0; i < found.modes.size(); ++i)
      text << '\n'
           << std::setw(6) << i + 1 << std::defaultfloat << std::setprecision(8)
           << std::setw(18) << found.modes[i].factor << std::scientific
           << std::setprecision(1) << std::setw(12) << found.modes[i].residual
           << std::setw(12) << found.modes[i].mesh_error;
    return text.str();
  }

  std::string mode_table_text(const NaturalModes &found,
                              const unsigned int  dimension)
  {
    const bool         is_damped = std::any_of(found.modes.begin(),
                                       found.modes.end(),
                                       [](const NaturalMode &mode) {
                                         return mode.damped.has_value();
                                       });
    std::ostringstream text;
    text
      << "  mode   frequency      period    residual  mesh error   effective "
         "mass along "
      << (dimension == 2 ? "x, y" : "x, y, z") << '\n'
      << "                Hz           s                            kg";
    for (unsigned int i = 0; i < found.modes.size(); ++i)
      {
        const NaturalMode &mode      = found.modes[i];
        const double       frequency = mode.angular_frequency() / (2 * PI);
        text << '\n' << std::setw(6) << i + 1;
        if (mode.eigenvalue < 0)
          text << "  grows as exp(" << std::setprecision(4)
               << mode.growth_rate() << " t)";
        else
          text << std::setprecision(6) << std::setw(12) << frequency
               << std::setprecision(4) << std::setw(12) << 1 / frequency;
        text << std::setprecision(1) << std::scientific << std::setw(12)
             << mode.residual << std::setw(12) << mode.mesh_error << "   ";
        for (unsigned int d = 0; d < dimension; ++d)
          text << ' ' << std::setprecision(2) << std::setw(10)
               << std::pow(mode.participation[d], 2);
        text << std::defaultfloat;
        if (mode.damped)
          text << std::setprecision(6) << "   damped "
               << mode.damped->angular_frequency / (2 * PI) << " Hz, ratio "
               << rounded_text(mode.damped->ratio());
        else if (is_damped && mode.eigenvalue > 0)
          text << "   no damped one found";
      }
    return text.str();
  }

  Json json_of(const NaturalModes &found)
  {
    Json modes = Json::array();
    for (const NaturalMode &mode : found.modes)
      {
        modes.push_back(
          {{"eigenvalue", mode.eigenvalue},
           {"frequency_hertz", mode.angular_frequency() / (2 * PI)},
           {"growth_rate", mode.growth_rate()},
           {"residual", mode.residual},
           {"mesh_error", mode.mesh_error},
           {"participation", mode.participation}});
        if (mode.damped)
          modes.back()["damped"] = {{"frequency_hertz",
                                     mode.damped->angular_frequency / (2 * PI)},
                                    {"ratio", mode.damped->ratio()}};
      }
    return modes;
  }

  Json json_of(const ComplexModes &found)
  {
    Json modes = Json::array();
    for (const ComplexMode &mode : found.modes)
      modes.push_back({{"frequency_hertz", mode.s.imag() / (2 * PI)},
                       {"growth_rate", mode.s.real()},
                       {"damping_ratio", mode.ratio()},
                       {"grows", mode.grows()},
                       {"residual", mode.residual},
                       {"mesh_error", mode.mesh_error}});
    return modes;
  }

  Json json_of(const Relaxations &found)
  {
    Json all = Json::array();
    for (const Relaxation &relaxation : found)
      all.push_back(
        {{"time", relaxation.time()}, {"residual", relaxation.residual}});
    return all;
  }

  Json json_of(const BucklingModes &found)
  {
    Json modes = Json::array();
    for (const BucklingMode &mode : found.modes)
      modes.push_back({{"factor", mode.factor},
                       {"residual", mode.residual},
                       {"mesh_error", mode.mesh_error}});
    return modes;
  }

  std::vector<std::string> write_mode_pictures(const LatticeRun  &run,
                                               const ModePicture &mode,
                                               const unsigned int number)
  {
    const Equations &equations = run.equations;
    VtuWriter        writer(run.scene,
                     equations,
                     run.scene.output.directory,
                     equations.unknowns().layout.communicator(),
                     prefix(number));
    const double     factor = shape_amplitude(run.scene, equations, mode.shape);
    for (unsigned int i = 0; i < run.scene.modes.pictures; ++i)
      {
        const double part  = double(i) / run.scene.modes.pictures,
                     phase = 2 * PI * part;
        State before =
          displaced(run.solution.state,
                    run.model.numbering,
                    shape_at(mode, std::cos(phase), -std::sin(phase)),
                    factor);
        set_velocity(shape_at(mode, -std::sin(phase), -std::cos(phase)),
                     factor * mode.angular_frequency,
                     before);
        Solution solution{before, equations.make_results()};
        equations.residual(Evaluation::equilibrium(before, solution.state),
                           solution.results);
        solution.state.time = part;
        writer.write_struts(solution.state);
        writer.write_rigid_parts(solution.state);
        writer.write_connectors(solution);
      }
    return writer.series();
  }
} // namespace auxfem
