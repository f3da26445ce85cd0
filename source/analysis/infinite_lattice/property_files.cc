#include <auxfem/analysis/infinite_lattice/property_files.h>
#include <auxfem/mathematics/voigt.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/line_graphics.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    using Direction = ElasticConstants::Direction;

    constexpr double degree = dealii::numbers::PI / 180;

    /** Angles between directions in the files (degrees). */
    constexpr unsigned int plane_step = 1, space_step = 5;

    Direction axis(const unsigned int d)
    {
      Direction unit;
      unit[d] = 1;
      return unit;
    }

    /** Direction by its angles to z and, about z, to x (degrees). */
    Direction direction_at(const double to_z, const double to_x)
    {
      // Exact along the axes, so that symmetric lattices have symmetric values.
      const auto sine = [](const double angle) {
        return std::abs(std::sin(angle * degree)) < 1e-15
          ? 0.
          : std::sin(angle * degree);
      };
      return dealii::Point<3>(sine(to_z) * sine(to_x + 90),
                              sine(to_z) * sine(to_x),
                              sine(to_z + 90));
    }

    void write_stiffness(const ElasticConstants &elastic,
                         const std::string      &file)
    {
      const unsigned int  n = elastic.stiffness().m();
      std::vector<Column> columns;
      for (unsigned int j = 0; j < n; ++j)
        columns.push_back({"C_" + name_of_component(j, elastic.dimension()),
                           "Pa",
                           "stiffness"});
      CsvTable table(file, columns);
      for (unsigned int i = 0; i < n; ++i)
        {
          std::vector<double> row;
          for (unsigned int j = 0; j < n; ++j)
            row.push_back(elastic.stiffness()(i, j));
          table.append(row);
        }
    }

    void write_directions_in_plane(const ElasticConstants &elastic,
                                   const std::string      &file)
    {
      CsvTable table(file,
                     {{"angle", "deg", "from x to the direction"},
                      {"youngs_modulus", "Pa", "along the direction"},
                      {"poissons_ratio", "1", "across it"},
                      {"shear_modulus", "Pa", "between it and its normal"}});
      for (unsigned int angle = 0; angle <= 180; angle += plane_step)
        {
          const Direction n = direction_at(90, angle);
          table.append({double(angle),
                        elastic.youngs_modulus(n),
                        elastic.poissons_ratios(n)[0],
                        elastic.shear_moduli(n)[0]});
        }
    }

    void write_directions_in_space(const ElasticConstants &elastic,
                                   const std::string      &file)
    {
      CsvTable table(file,
                     {{"angle_to_z", "deg", "of the direction"},
                      {"angle_to_x", "deg", "of its projection, about z"},
                      {"youngs_modulus", "Pa", "along the direction"},
                      {"least_poissons_ratio", "1", "across it"},
                      {"largest_poissons_ratio", "1", "across it"},
                      {"least_shear_modulus", "Pa", "across it"},
                      {"largest_shear_modulus", "Pa", "across it"}});
      for (unsigned int to_z = 0; to_z <= 180; to_z += space_step)
        for (unsigned int to_x = 0; to_x < 360; to_x += space_step)
          {
            const Direction n           = direction_at(to_z, to_x);
            const auto [nu, largest_nu] = elastic.poissons_ratios(n);
            const auto [G, largest_G]   = elastic.shear_moduli(n);
            table.append({double(to_z),
                          double(to_x),
                          elastic.youngs_modulus(n),
                          nu,
                          largest_nu,
                          G,
                          largest_G});
          }
    }

    /** Adds a closed curve of points whose distance from the origin is Young's
     * modulus over @p largest. */
    void add_curve(const ElasticConstants       &elastic,
                   const std::vector<Direction> &directions,
                   const double                  largest,
                   LineGraphics                 &graphics)
    {
      std::vector<dealii::Point<3>> points;
      std::vector<float>            values;
      for (const Direction &n : directions)
        {
          const double modulus = elastic.youngs_modulus(n);
          points.emplace_back(modulus / largest * n);
          values.push_back(modulus);
          for (const double value : elastic.poissons_ratios(n))
            values.push_back(value);
        }
      graphics.add_line(points, values);
    }

    void write_modulus(const ElasticConstants &elastic, const std::string &file)
    {
      LineGraphics                        graphics({{"youngs_modulus", 1, "Pa"},
                                                    {"least_poissons_ratio", 1, ""},
                                                    {"largest_poissons_ratio", 1, ""}});
      std::vector<std::vector<Direction>> curves;
      const bool                          is_planar = elastic.dimension() == 2;
      for (unsigned int to_z = is_planar ? 90 : space_step; to_z < 180;
           to_z += is_planar ? 90 : space_step)
        {
          curves.emplace_back();
          for (unsigned int to_x = 0; to_x <= 360; ++to_x)
            curves.back().push_back(direction_at(to_z, to_x));
        }
      for (unsigned int to_x = 0; to_x < 180 && !is_planar; to_x += space_step)
        {
          curves.emplace_back();
          for (unsigned int to_z = 0; to_z <= 360; ++to_z)
            curves.back().push_back(direction_at(to_z, to_x));
        }
      double largest = 0;
      for (const auto &curve : curves)
        for (const Direction &n : curve)
          largest = std::max(largest, elastic.youngs_modulus(n));
      for (const auto &curve : curves)
        add_curve(elastic, curve, largest, graphics);
      if (!graphics.write_file(file))
        throw ComputationError("Cannot write " + file + ".");
    }

    /** Name and value of each constant along the axes of the scene. */
    std::vector<std::pair<std::string, double>>
    constants_along_axes(const ElasticConstants &elastic)
    {
      std::vector<std::pair<std::string, double>> constants;
      const unsigned int                          d = elastic.dimension();
      for (unsigned int i = 0; i < d; ++i)
        constants.emplace_back("E" + std::to_string(i + 1),
                               elastic.youngs_modulus(axis(i)));
      for (unsigned int i = 0; i < d; ++i)
        for (unsigned int j = 0; j < d; ++j)
          if (i != j)
            constants.emplace_back("nu" + std::to_string(i + 1) +
                                     std::to_string(j + 1),
                                   elastic.poissons_ratio(axis(i), axis(j)));
      for (unsigned int i = 0; i < d; ++i)
        for (unsigned int j = i + 1; j < d; ++j)
          constants.emplace_back("G" + std::to_string(i + 1) +
                                   std::to_string(j + 1),
                                 elastic.shear_modulus(axis(i), axis(j)));
      constants.emplace_back("K", elastic.bulk_modulus());
      return constants;
    }
  } // namespace

  FolderContents effective_property_contents()
  {
    return {{"stiffness.csv",
             "directions.csv",
             "modulus.vtu",
             "moduli.csv",
             "moduli.units.csv"},
            {}};
  }

  void write_effective_properties(const EffectiveProperties &properties,
                                  const std::string         &folder)
  {
    const ElasticConstants &elastic = properties.elastic;
    write_stiffness(elastic, folder + "/stiffness.csv");
    if (!elastic.compliance())
      return;
    if (elastic.dimension() == 2)
      write_directions_in_plane(elastic, folder + "/directions.csv");
    else
      write_directions_in_space(elastic, folder + "/directions.csv");
    write_modulus(elastic, folder + "/modulus.vtu");
  }

  std::string text_of(const EffectiveProperties &properties)
  {
    const ElasticConstants &elastic = properties.elastic;
    const unsigned int      n       = elastic.stiffness().m();
    std::ostringstream      text;
    text.precision(6);
    text << "\nThe infinite lattice as a continuum";
    if (elastic.dimension() == 2)
      text << " of depth " << properties.depth << " m";
    text << '\n';
    if (properties.relative_density)
      text << "  relative density " << *properties.relative_density << '\n';
    if (properties.density)
      text << "  density          " << *properties.density << " kg/m3\n";
    text << "  stiffness (Pa), components";
    for (unsigned int i = 0; i < n; ++i)
      text << ' ' << name_of_component(i, elastic.dimension());
    text << '\n';
    const double largest = elastic.stiffness().linfty_norm();
    for (unsigned int i = 0; i < n; ++i)
      {
        text << "   ";
        for (unsigned int j = 0; j < n; ++j)
          {
            const double value = elastic.stiffness()(i, j);
            text << ' ' << std::setw(13)
                 << (std::abs(value) < 1e-12 * largest ? 0. : value);
          }
        text << '\n';
      }
    if (!elastic.compliance())
      return text.str() +
        "  The lattice has a mechanism: moduli of uniaxial stress are zero.";
    for (const auto &[name, value] : constants_along_axes(elastic))
      text << "  " << std::left << std::setw(5) << name << std::right
           << std::setw(13) << value << (name[0] == 'n' ? "" : " Pa") << '\n';
    text << "  The stiffness differs from the nearest isotropic one by "
         << percentage_text(elastic.anisotropy());
    return text.str();
  }

  Json json_of(const EffectiveProperties &properties)
  {
    const ElasticConstants &elastic = properties.elastic;
    Json                    json;
    for (unsigned int i = 0; i < elastic.stiffness().m(); ++i)
      {
        Json row = Json::array();
        for (unsigned int j = 0; j < elastic.stiffness().m(); ++j)
          row.push_back(elastic.stiffness()(i, j));
        json["stiffness_pascal"].push_back(row);
      }
    if (properties.density)
      json["density"] = *properties.density;
    if (elastic.dimension() == 2)
      json["depth_metre"] = properties.depth;
    if (elastic.compliance())
      for (const auto &[name, value] : constants_along_axes(elastic))
        json["constants"][name] = value;
    json["anisotropy"] = elastic.anisotropy();
    return {{"effective_properties", json}};
  }
} // namespace auxfem
