#include <auxfem/struts/factors.h>
#include <auxfem/struts/taper.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Number of points at which factors are checked in advance. */
    constexpr unsigned int n_checked_points = 101;
  } // namespace

  Taper::Taper(const ParameterValues             &values,
               const Parameter                   &parameter,
               const RegistryEntry<CrossSection> &shape)
    : values(values)
    , shape(shape)
    , position(std::make_unique<double>(0))
    , factors(std::make_unique<const Factors>(
        values,
        Factors::Language{parameter,
                          {{"s", position.get()}},
                          nullptr,
                          "Write DIMENSION: EXPRESSION in s, from 0 at the "
                          "first joint of a strut to 1 at the second, e.g. "
                          "Height: 1 - 0.5 * s"},
        numbers_among(shape.parameters, values, "m")))
  {
    for (unsigned int i = 0; i < factors->names().size(); ++i)
      {
        dimensions.push_back(quantity_of(factors->names()[i], values));
        for (unsigned int k = 0; k < n_checked_points; ++k)
          factor_at(i, double(k) / (n_checked_points - 1));
      }
  }

  Taper::~Taper() = default;

  double Taper::factor_at(const unsigned int i, const double s) const
  {
    *position = s;
    return factors->factor(i, [s] {
      std::ostringstream place;
      place.precision(3);
      place << "at s = " << s;
      return place.str();
    });
  }

  const CrossSection &Taper::shape_at(const double s) const
  {
    const auto found = known.find(s);
    if (found != known.end())
      return found->second;
    ParameterValues there = values;
    for (unsigned int i = 0; i < dimensions.size(); ++i)
      set_quantity(factors->names()[i], dimensions[i] * factor_at(i, s), there);
    return known.emplace(s, *shape.make(there)).first->second;
  }
} // namespace auxfem
