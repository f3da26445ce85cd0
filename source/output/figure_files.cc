#include <auxfem/figures/figure_table.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/mass_and_size.h>
#include <auxfem/model/supports.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/figure_files.h>
#include <auxfem/output/member_forces.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace auxfem
{
  namespace
  {
    const std::string figures_file = "evaluation", crush_file = "crush",
                      transmission_file = "transmission",
                      members_file      = MemberForces::table_name;

    std::string table_of(const std::string &name)
    {
      return name + ".csv";
    }

    std::string reference_of(const std::string &name)
    {
      return name + ".units.csv";
    }

    std::vector<std::string> files_of(const std::vector<std::string> &tables)
    {
      std::vector<std::string> files;
      for (const std::string &name : tables)
        for (const std::string &file : {table_of(name), reference_of(name)})
          files.push_back(file);
      return files;
    }

    using Value = std::optional<double>;

    double or_nan(const Value &value)
    {
      return value.value_or(std::numeric_limits<double>::quiet_NaN());
    }

    void write_bodies(const std::vector<BodyFigures> &bodies,
                      const std::string              &folder)
    {
      const std::vector<BodyFigure> &figures = body_figure_columns();
      std::vector<Column> columns = {{"body", "", "plate, support or probe"},
                                     {"axis",
                                      "",
                                      "direction of the components"}};
      for (const BodyFigure &figure : figures)
        columns.push_back(figure.column);
      CsvTable table(folder + table_of(figures_file), columns);
      write_column_reference(folder + reference_of(figures_file), columns);
      for (const BodyFigures &body : bodies)
        {
          std::vector<std::string> row = {body.body, body.axis};
          for (const BodyFigure &figure : figures)
            row.push_back(text_of_cell(or_nan(figure.value(body))));
          table.append_text(row);
        }
    }

    void write_crush(const CrushResult     &crush,
                     const CrushDefinition &definition,
                     const std::string     &folder)
    {
      const std::vector<Column> columns = {
        {"time", "s", "time of the row, or position on a path"},
        {"strain", "1", "nominal strain, positive in compression"},
        {"stress", "Pa", "nominal stress, positive in compression"},
        {"force", "N", "force between lattice and body, along the loading"},
        {"work", "J/m3", "work per volume since the start"},
        {"efficiency",
         "1",
         "work over stress where the strain is the largest so far; else nan"}};
      CsvTable table(folder + table_of(crush_file), columns);
      write_column_reference(folder + reference_of(crush_file), columns);
      const CrushCurve         &curve   = crush.curve;
      const CrushCurve          loading = loading_part(curve);
      const std::vector<double> eta = efficiencies(loading, definition.options);
      std::size_t               next = 0;
      for (std::size_t i = 0; i < curve.strain.size(); ++i)
        {
          const bool is_loading =
            next < eta.size() && curve.strain[i] == loading.strain[next];
          table.append({crush.times[i],
                        curve.strain[i],
                        curve.stress[i],
                        curve.stress[i] * crush.area,
                        curve.work[i],
                        is_loading ? eta[next] : or_nan({})});
          next += is_loading;
        }
    }

    void write_transmission(const Transmission &transmission,
                            const std::string  &folder)
    {
      const std::vector<Column> columns = {
        {"frequency", "Hz", "frequency"},
        {"input", "", "amplitude of the input, in its unit"},
        {"output", "", "amplitude of the output, in its unit"},
        {"ratio",
         "",
         "output over input; nan where the input is below a thousandth of its "
         "largest amplitude"},
        {"phase", "rad", "phase of the output before that of the input"}};
      CsvTable table(folder + table_of(transmission_file), columns);
      write_column_reference(folder + reference_of(transmission_file), columns);
      for (const TransmissionLine &line : transmission.spectrum)
        table.append({line.frequency,
                      std::abs(line.input),
                      std::abs(line.output),
                      line.ratio ? std::abs(*line.ratio) : or_nan({}),
                      line.ratio ? std::arg(*line.ratio) : or_nan({})});
    }
  } // namespace

  std::vector<std::string> figure_files(const Scene &scene)
  {
    const FiguresDefinition &figures = scene.figures;
    std::vector<std::string> tables;
    if (figures.figures)
      tables.push_back(figures_file);
    if (figures.crush)
      tables.push_back(crush_file);
    if (figures.transmission)
      tables.push_back(transmission_file);
    if (figures.member_forces)
      tables.push_back(members_file);
    return files_of(tables);
  }

  std::vector<std::string> all_figure_files()
  {
    return files_of(
      {figures_file, crush_file, transmission_file, members_file});
  }

  std::vector<std::string> names_of_bodies(const Scene &scene)
  {
    std::vector<std::string> names;
    const auto               add = [&names](const auto &definitions) {
      for (const auto &definition : definitions)
        if (std::find(names.begin(), names.end(), definition.name) ==
            names.end())
          names.push_back(definition.name);
    };
    add(scene.plates);
    add(scene.supports);
    add(scene.output.probes);
    return names;
  }

  namespace
  {
    /** Middle of the joints of the support @p name, which may be a plate's. */
    std::array<double, 3> position_of(const std::string &name,
                                      const Scene       &scene,
                                      const Lattice     &lattice)
    {
      std::vector<unsigned int> joints;
      for (const SupportDefinition &support : scene.supports)
        if (support.name == name)
          joints = joints_of(support, lattice, scene.context);
      for (const PlateDefinition &plate : scene.plates)
        if (plate.name == name)
          joints = lattice.joint_sets.at(name);
      std::array<double, 3> position = {};
      for (const unsigned int joint : joints)
        for (unsigned int d = 0; d < 3; ++d)
          position[d] += lattice.joints[joint][d] / joints.size();
      return position;
    }

    /** Mass of the lattice without its plates (kg). */
    Value mass_without_plates(const MassAndSize &whole, const Scene &scene)
    {
      Value mass = whole.mass;
      for (const PlateDefinition &plate : scene.plates)
        if (mass && plate.mass)
          *mass -= plate.mass->mass;
      return mass;
    }
  } // namespace

  CrushGeometry crush_geometry(const Equations &equations)
  {
    const Scene      &scene   = equations.model().plan.scene;
    const Lattice    &lattice = equations.model().lattice;
    const MassAndSize whole   = mass_and_size(scene, lattice);
    CrushGeometry     geometry;
    for (unsigned int i = 0; i < 2; ++i)
      geometry.positions[i] =
        position_of(scene.figures.crush->bodies[i], scene, lattice);
    for (unsigned int d = 0; d < 3; ++d)
      geometry.size[d] = whole.size[d];
    if (lattice.dimension == 2)
      geometry.depth = whole.has_dimensions ? whole.depth : 0;
    geometry.mass = mass_without_plates(whole, scene);
    return geometry;
  }

  void write_figures(const RunFigures  &figures,
                     const Scene       &scene,
                     const std::string &folder)
  {
    if (!figures.bodies.empty())
      write_bodies(figures.bodies, folder + "/");
    if (figures.crush)
      write_crush(*figures.crush, *scene.figures.crush, folder + "/");
    if (figures.transmission)
      write_transmission(*figures.transmission, folder + "/");
  }
} // namespace auxfem
