#include <auxfem/output/effective_strains.h>
#include <auxfem/output/response_files.h>
#include <auxfem/scene/mean_deformation.h>

namespace auxfem
{
  namespace
  {
    void add_components(const std::string   &name,
                        const std::string   &unit,
                        const std::string   &meaning,
                        const unsigned int   dimension,
                        std::vector<Column> &columns)
    {
      for (unsigned int i = 0; i < dimension; ++i)
        for (unsigned int j = 0; j < dimension; ++j)
          columns.push_back({name + component_name(i, j), unit, meaning});
    }
  } // namespace

  FolderContents response_contents()
  {
    return {{"response.csv",
             "response.units.csv",
             "stability.csv",
             "stability.units.csv"},
            {}};
  }

  std::vector<Column> response_columns(const unsigned int dimension)
  {
    std::vector<Column> columns = {{"time", "s", "time"}};
    add_components("strain_",
                   "1",
                   "mean derivative of the displacement",
                   dimension,
                   columns);
    for (unsigned int i = 0; i < dimension; ++i)
      columns.push_back({"modulus_" + axis_name(i),
                         "Pa",
                         "derivative of the nominal stress along " +
                           axis_name(i) + " by the strain along " +
                           axis_name(i) +
                           ", with the other stresses constant where strains "
                           "are not held; nan with yielding or viscous parts"});
    for (unsigned int i = 0; i < dimension; ++i)
      for (unsigned int j = 0; j < dimension; ++j)
        if (i != j)
          {
            columns.push_back({"poisson_" + component_name(i, j),
                               "1",
                               "negative derivative of the strain along " +
                                 axis_name(j) + " by that along " +
                                 axis_name(i) + ", as the modulus"});
            columns.push_back({"secant_poisson_" + component_name(i, j),
                               "1",
                               "negative strain along " + axis_name(j) +
                                 " over that along " + axis_name(i)});
          }
    columns.push_back({"long_wave_stiffness",
                       "1",
                       "least stiffness against waves far longer than the "
                       "period over that at the start; unstable below 0"});
    for (unsigned int d = 0; d < dimension; ++d)
      columns.push_back({"long_wave_" + axis_name(d),
                         "1",
                         "direction of the least stable long wave"});
    columns.push_back(
      {"wave_stiffness",
       "1",
       "least stiffness, over the wave vectors, against a wave "
       "over that at the start; unstable below 0; nan if struts "
       "of different periods touch"});
    for (unsigned int d = 0; d < dimension; ++d)
      columns.push_back({"wave_" + std::to_string(d + 1),
                         "1",
                         "part of the reciprocal vector of that wave"});
    return columns;
  }

  std::vector<Column> stability_columns(const unsigned int dimension)
  {
    std::vector<Column> columns = {
      {"kind",
       "",
       "long wave: far longer than the period; wave: of the wave vector; strut: "
       "between joints"},
      {"time", "s", "time of the loss of stability"}};
    for (unsigned int d = 0; d < dimension; ++d)
      columns.push_back({"wave_" + std::to_string(d + 1),
                         "1",
                         "direction of a long wave; parts of the reciprocal "
                         "vectors of other waves"});
    add_components("strain_",
                   "1",
                   "mean derivative of the displacement",
                   dimension,
                   columns);
    add_components("stress_", "Pa", "mean nominal stress", dimension, columns);
    return columns;
  }
} // namespace auxfem
