#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/scene/dispersion_definition.h>

#include <deal.II/base/utilities.h>

namespace auxfem
{
  namespace
  {
    const Text path = {
      "Path",
      "auto",
      "Corners of the path of wave vectors, as parts of the reciprocal vectors "
      "of the period, separated by semicolons, e.g. 0 0; 1/2 0; 1/2 1/2; 0 0. "
      "auto: these, in space 0 0 0; 1/2 0 0; 1/2 1/2 0; 0 0 0; 1/2 1/2 1/2."};
    const Integer points = {
      "Points",
      20,
      1,
      10000,
      "Number of steps from one corner of the path to the next."};
    const Integer bands       = {"Bands",
                                 8,
                                 1,
                                 1000,
                                 "Number of waves for each wave vector, from the "
                                       "lowest frequency."};
    const Integer zone_points = {
      "Zone points",
      8,
      0,
      1000,
      "Number of wave vectors along each reciprocal vector at which band gaps "
      "are looked for besides the path; 0: on the path alone."};

    const Boolean damped_waves = {
      "Damped",
      false,
      "Whether waves have the damping of connectors and struts: frequencies are "
      "those of damped oscillations, dispersion.csv also has their decay, and "
      "no group velocities."};

    using WaveVector = DispersionDefinition::WaveVector;

    WaveVector read_corner(const std::string     &text,
                           const ParameterValues &values)
    {
      const std::vector<std::string> words = split_words(text);
      const unsigned int             d     = values.context.dimension;
      if (words.size() != d)
        values.refuse(path,
                      "\"" + text + "\" has " + std::to_string(words.size()) +
                        " numbers. Give " + std::to_string(d) +
                        " for each corner, e.g. " +
                        (d == 2 ? "1/2 0" : "1/2 0 0"));
      WaveVector corner = {{0, 0, 0}};
      for (unsigned int i = 0; i < d; ++i)
        try
          {
            corner[i] = constant_value(words[i], values.context.constants);
          }
        catch (const InputError &error)
          {
            values.refuse(path, error.what());
          }
      return corner;
    }
  } // namespace

  std::vector<WaveVector> DispersionDefinition::points_of_path() const
  {
    std::vector<WaveVector> all = {path.front()};
    for (std::size_t leg = 1; leg < path.size(); ++leg)
      for (unsigned int i = 1; i <= points; ++i)
        {
          WaveVector at{};
          for (unsigned int d = 0; d < 3; ++d)
            at[d] =
              path[leg - 1][d] + (path[leg][d] - path[leg - 1][d]) * i / points;
          all.push_back(at);
        }
    return all;
  }

  std::vector<WaveVector> wave_vectors_of_zone(const unsigned int n_points,
                                               const unsigned int dimension)
  {
    std::vector<WaveVector> all;
    const int n = n_points, depth = dimension == 3 ? n : std::min(n, 1);
    for (int i = 0; 2 * i <= n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < depth; ++k)
          all.push_back({{double(i) / n, double(j) / n, double(k) / n}});
    return all;
  }

  SubsectionSchema dispersion_schema()
  {
    return {"Dispersion",
            SubsectionSchema::Form::fixed,
            "With Analysis = dispersion: waves of the infinite lattice.",
            {path, points, bands, zone_points, damped_waves}};
  }

  DispersionDefinition read_dispersion(ParameterValues &values)
  {
    DispersionDefinition dispersion;
    std::string          corners = values[path];
    if (values.is_default(path))
      corners = values.context.dimension == 2
        ? "0 0; 1/2 0; 1/2 1/2; 0 0"
        : "0 0 0; 1/2 0 0; 1/2 1/2 0; 0 0 0; 1/2 1/2 1/2";
    for (const std::string &corner :
         dealii::Utilities::split_string_list(corners, ';'))
      dispersion.path.push_back(read_corner(corner, values));
    if (dispersion.path.size() < 2)
      values.refuse(path, "it has one corner. Give at least two");
    dispersion.points      = values[points];
    dispersion.bands       = values[bands];
    dispersion.zone_points = values[zone_points];
    dispersion.damped      = values[damped_waves];
    return dispersion;
  }
} // namespace auxfem
