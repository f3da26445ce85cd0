#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/equations/equations.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/study/recorded_history.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** Polynomial through consecutive values, by Neville's algorithm. */
    class Polynomial
    {
    public:
      /** Interpolates at most @p n values, centred at number @p middle. */
      Polynomial(const RecordedHistory &history,
                 const std::size_t      middle,
                 const std::size_t      n)
        : history(history)
        , count(std::min(n, history.times.size()))
        , first(std::min(middle - std::min(middle, count / 2),
                         history.times.size() - count))
      {}

      double operator()(const double time) const
      {
        std::vector<double> value(history.values.begin() + first,
                                  history.values.begin() + first + count);
        const double *const t = history.times.data() + first;
        for (std::size_t level = 1; level < count; ++level)
          for (std::size_t i = 0; i + level < count; ++i)
            value[i] = ((time - t[i + level]) * value[i] +
                        (t[i] - time) * value[i + 1]) /
              (t[i] - t[i + level]);
        return value[0];
      }

    private:
      const RecordedHistory &history;
      const std::size_t      count, first;
    };
  } // namespace

  double value_at(const RecordedHistory &history, const double time)
  {
    const std::vector<double> &times = history.times;
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    const std::size_t next =
      std::min<std::size_t>(after - times.begin(), times.size() - 1);
    const std::size_t nearest =
      next > 0 && time - times[next - 1] < times[next] - time ? next - 1 : next;
    if (std::abs(times[nearest] - time) <=
        round_off * (times.back() - times.front()))
      return history.values[nearest];
    return Polynomial(history, nearest, 5)(time);
  }

  Maximum maximum_of(const RecordedHistory &history)
  {
    const std::size_t largest =
      std::max_element(history.values.begin(), history.values.end()) -
      history.values.begin();
    const Maximum recorded{history.times[largest], history.values[largest]};
    if (largest == 0 || largest + 1 == history.times.size())
      return recorded;
    const Polynomial polynomial(history, largest, 5);
    const auto [time, depth] = boost::math::tools::brent_find_minima(
      [&polynomial](const double t) { return -polynomial(t); },
      history.times[largest - 1],
      history.times[largest + 1],
      std::numeric_limits<double>::digits / 2);
    return -depth > recorded.value ? Maximum{time, -depth} : recorded;
  }

  double integral_of(const RecordedHistory &history)
  {
    // Two Gauss points are exact for cubic polynomials.
    const double point = std::sqrt(1. / 3.);
    double       sum   = 0;
    for (std::size_t i = 1; i < history.times.size(); ++i)
      {
        const double     half   = (history.times[i] - history.times[i - 1]) / 2;
        const double     middle = history.times[i] - half;
        const Polynomial polynomial(history, i, 4);
        sum += half *
          (polynomial(middle - half * point) +
           polynomial(middle + half * point));
      }
    return sum;
  }

  RecordedHistory negative(RecordedHistory history)
  {
    for (double &value : history.values)
      value = -value;
    return history;
  }

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
