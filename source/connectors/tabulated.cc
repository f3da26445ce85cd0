#include <auxfem/connectors/elastic_law.h>

#include <limits>

namespace auxfem
{
  namespace
  {
    const QuantityList table_extensions{
      "Extensions",
      "",
      "m",
      Range::any(),
      2,
      std::numeric_limits<unsigned int>::max(),
      "Extensions of the table, rising."};

    const QuantityList table_forces{
      "Forces",
      "",
      "N",
      Range::any(),
      2,
      std::numeric_limits<unsigned int>::max(),
      "Force at each extension, linear in between; the first and the last line "
      "of the table continue beyond it."};

    std::vector<PiecewiseLinearCurve::Point>
    read_force_table(const ParameterValues &values)
    {
      const std::vector<double> u = values[table_extensions];
      const std::vector<double> f = values[table_forces];
      if (u.size() != f.size())
        values.refuse("'" + table_extensions.name + "' has " +
                      std::to_string(u.size()) + " values, '" +
                      table_forces.name + "' has " + std::to_string(f.size()) +
                      ". Each extension needs one force: give lists of equal "
                      "length");
      std::vector<PiecewiseLinearCurve::Point> points;
      for (std::size_t i = 0; i < u.size(); ++i)
        {
          if (i > 0 && !(u[i] > u[i - 1]))
            values.refuse(table_extensions,
                          "extensions must rise, but number " +
                            std::to_string(i + 1) +
                            " does not. Sort the table by extension");
          points.emplace_back(u[i], f[i]);
        }
      return points;
    }

    /** Stiffness of the line from point @p i to the next. */
    double
    line_stiffness(const std::vector<PiecewiseLinearCurve::Point> &points,
                   const std::size_t                               i)
    {
      return (points[i + 1].second - points[i].second) /
        (points[i + 1].first - points[i].first);
    }

    std::unique_ptr<ConnectorLaw> make_tabulated(ParameterValues &values)
    {
      const auto points = read_force_table(values);
      return make_elastic_law(std::make_shared<PiecewiseLinearCurve>(
                                points,
                                line_stiffness(points, 0),
                                line_stiffness(points, points.size() - 2)),
                              {values[parallel_damping()]});
    }
  } // namespace

  RegistryEntry<ConnectorLaw> tabulated_entry()
  {
    return {"tabulated",
            "Elastic force by a table of extensions and forces, linear in "
            "between.",
            {table_extensions, table_forces, parallel_damping()},
            make_tabulated};
  }
} // namespace auxfem
