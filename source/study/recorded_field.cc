#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/equations/equations.h>
#include <auxfem/study/recorded_field.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int n_strains = 6, n_velocities = 3;

    using Element = RecordedField::Element;

    template <class Points>
    std::vector<double> joined_values(const Points &points)
    {
      std::vector<double> values;
      for (const auto &point : points)
        values.insert(values.end(), point.begin(), point.end());
      return values;
    }

    /** Serializes elements to numbers, for MPI and files. */
    std::vector<double> flat(const std::vector<Element> &elements)
    {
      std::vector<double> numbers;
      for (const Element &element : elements)
        {
          numbers.insert(numbers.end(),
                         {double(element.strut),
                          element.begin,
                          element.end,
                          element.length,
                          double(element.strains.size()),
                          double(element.velocities.size())});
          for (const std::vector<double> &values :
               {element.strains, element.velocities})
            numbers.insert(numbers.end(), values.begin(), values.end());
        }
      return numbers;
    }

    void add_elements(const std::vector<double> &numbers,
                      std::vector<Element>      &elements)
    {
      for (auto number = numbers.begin(); number != numbers.end();)
        {
          Element           element{static_cast<unsigned int>(number[0]),
                          number[1],
                          number[2],
                          number[3],
                          {},
                          {}};
          const std::size_t n_strain_values   = number[4],
                            n_velocity_values = number[5];
          number += 6;
          element.strains.assign(number, number + n_strain_values);
          number += n_strain_values;
          element.velocities.assign(number, number + n_velocity_values);
          number += n_velocity_values;
          elements.push_back(std::move(element));
        }
    }

    /** Cache of Gauss rules on [0, 1]. */
    class GaussRules
    {
    public:
      const dealii::QGauss<1> &with_points(const unsigned int n)
      {
        return rules.try_emplace(n, n).first->second;
      }

    private:
      std::map<unsigned int, dealii::QGauss<1>> rules;
    };

    /**
     * Appends @p factor times the interpolation of @p values at @p x in [0, 1].
     * There are @p n_values values at each point of @p gauss.
     */
    void add_values_at(const double               x,
                       const dealii::QGauss<1>   &gauss,
                       const std::vector<double> &values,
                       const unsigned int         n_values,
                       const double               factor,
                       std::vector<double>       &result)
    {
      std::vector<double> sum(n_values, 0);
      for (unsigned int i = 0; i < gauss.size(); ++i)
        {
          double lagrange = factor;
          for (unsigned int j = 0; j < gauss.size(); ++j)
            if (j != i)
              lagrange *= (x - gauss.point(j)[0]) /
                (gauss.point(i)[0] - gauss.point(j)[0]);
          for (unsigned int k = 0; k < n_values; ++k)
            sum[k] += lagrange * values[i * n_values + k];
        }
      result.insert(result.end(), sum.begin(), sum.end());
    }
  } // namespace

  unsigned int RecordedField::Element::n_points() const
  {
    return strains.size() / n_strains;
  }

  RecordedField field_of(const Equations &equations,
                         const Solution  &solution,
                         const MPI_Comm   communicator)
  {
    const DofNumbering  &numbering = equations.model().numbering;
    const Lattice       &lattice   = equations.model().lattice;
    std::vector<Element> local_elements;
    for (const StrutGroup &struts : equations.reporting().struts)
      for (unsigned int e = struts.forces->elements().begin;
           e < struts.forces->elements().end;
           ++e)
        {
          const DofNumbering::Element &element  = numbering.elements()[e];
          const StrutInterval         &interval = element.interval;
          if (!element.is_owned)
            continue;
          const ScaledMotion motion =
            struts.forces->scaled_motion(solution.state, e);
          local_elements.push_back(
            {interval.strut,
             interval.begin,
             interval.end,
             lattice.length(lattice.struts[interval.strut]) *
               (interval.end - interval.begin),
             joined_values(motion.strains),
             joined_values(motion.velocities)});
        }
    RecordedField field;
    add_elements(gather_over_ranks(flat(local_elements), communicator),
                 field.elements);
    std::sort(field.elements.begin(),
              field.elements.end(),
              [](const Element &one, const Element &other) {
                return std::tie(one.strut, one.begin) <
                  std::tie(other.strut, other.begin);
              });
    return field;
  }

  Json json_of(const RecordedField &field)
  {
    return flat(field.elements);
  }

  RecordedField recorded_field_of(const Json &json)
  {
    RecordedField field;
    add_elements(json.get<std::vector<double>>(), field.elements);
    return field;
  }

  std::vector<FieldPoint> integration_points(const RecordedField &field)
  {
    std::vector<FieldPoint> points;
    GaussRules              rules;
    for (const Element &element : field.elements)
      {
        // Squares of velocities have the order 2 n.
        const dealii::QGauss<1> &gauss =
          rules.with_points(element.n_points() + 1);
        for (unsigned int q = 0; q < gauss.size(); ++q)
          points.push_back(
            {element.strut,
             element.begin + gauss.point(q)[0] * (element.end - element.begin),
             gauss.weight(q) * element.length});
      }
    return points;
  }

  std::vector<double> energy_roots(const RecordedField           &field,
                                   const std::vector<FieldPoint> &points,
                                   const bool with_velocities)
  {
    std::vector<double> roots;
    GaussRules          rules;
    auto                element = field.elements.begin();
    for (const FieldPoint &point : points)
      {
        // Gauss points lie inside the elements.
        while (std::tie(element->strut, element->end) <
               std::tie(point.strut, point.fraction))
          {
            ++element;
            Assert(element != field.elements.end(), dealii::ExcInternalError());
          }
        const unsigned int n = element->n_points();
        const double       x =
          (point.fraction - element->begin) / (element->end - element->begin);
        const double factor = std::sqrt(point.weight / 2);
        add_values_at(x,
                      rules.with_points(n),
                      element->strains,
                      n_strains,
                      factor,
                      roots);
        if (!with_velocities)
          continue;
        if (element->velocities.empty())
          roots.resize(roots.size() + n_velocities, 0);
        else
          add_values_at(x,
                        rules.with_points(n + 1),
                        element->velocities,
                        n_velocities,
                        factor,
                        roots);
      }
    return roots;
  }
} // namespace auxfem
