#include <auxfem/contact/surface_approach.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** A part of a curve on a part of its way: Bernstein coefficients by way,
     * each a polynomial along the curve. */
    struct Patch
    {
      using Levels = std::array<BernsteinPolynomial, 3>;

      /** In the order of the way; each half begins and ends with whole ones. */
      std::array<Patch, 2> halves_of_way() const
      {
        std::array<Patch, 2> halves = {{*this, *this}};
        const double         middle = (way[0] + way[1]) / 2;
        halves[0].way[1] = halves[1].way[0] = middle;
        for (unsigned int i = 0; i <= levels[0].degree; ++i)
          {
            const double a = levels[0].coefficients[i],
                         b = levels[1].coefficients[i],
                         c = levels[2].coefficients[i], ab = (a + b) / 2,
                         bc = (b + c) / 2, abc = (ab + bc) / 2;
            halves[0].levels[1].coefficients[i] = ab;
            halves[0].levels[2].coefficients[i] = abc;
            halves[1].levels[0].coefficients[i] = abc;
            halves[1].levels[1].coefficients[i] = bc;
          }
        return halves;
      }

      std::array<Patch, 2> halves_of_curve() const
      {
        std::array<Patch, 2> halves = {{*this, *this}};
        const double         middle = (curve[0] + curve[1]) / 2;
        halves[0].curve[1] = halves[1].curve[0] = middle;
        for (unsigned int k = 0; k < levels.size(); ++k)
          {
            const auto of_level = levels[k].halves();
            for (unsigned int i = 0; i < 2; ++i)
              halves[i].levels[k] = of_level[i];
          }
        return halves;
      }

      /** The lowest of the corners, whose coefficients are values. */
      CurvePassage lowest_corner(double &value) const
      {
        CurvePassage lowest{curve[0], way[0]};
        value = levels[0].coefficients[0];
        for (const unsigned int j : {0, 1})
          for (const unsigned int i : {0, 1})
            if (const double here =
                  levels[2 * j].coefficients[i * levels[0].degree];
                here < value)
              {
                value  = here;
                lowest = {curve[i], way[j]};
              }
        return lowest;
      }

      bool is_nowhere_negative() const
      {
        return std::all_of(levels.begin(),
                           levels.end(),
                           [](const BernsteinPolynomial &level) {
                             return level.is_nowhere_negative();
                           });
      }

      /** Whether the level changes more along the curve than on the way. */
      bool is_steeper_along_curve() const
      {
        double along = 0, across = 0;
        for (unsigned int k = 0; k < levels.size(); ++k)
          for (unsigned int i = 0; i <= levels[k].degree; ++i)
            {
              const double here = levels[k].coefficients[i];
              along =
                std::max(along, std::abs(here - levels[k].coefficients[0]));
              across =
                std::max(across, std::abs(here - levels[0].coefficients[i]));
            }
        return along > across;
      }

      Levels                levels;
      std::array<double, 2> curve = {{0, 1}}, way = {{0, 1}};
    };

    std::optional<CurvePassage> find_negative(const Patch &patch)
    {
      // A smaller remainder is round-off.
      constexpr double smallest = 1e-14;
      if (patch.is_nowhere_negative())
        return {};
      double             value;
      const CurvePassage lowest = patch.lowest_corner(value);
      if (value < 0)
        return lowest;
      if ((patch.curve[1] - patch.curve[0]) * (patch.way[1] - patch.way[0]) <
          smallest)
        return {};
      for (const Patch &half : patch.is_steeper_along_curve()
             ? patch.halves_of_curve()
             : patch.halves_of_way())
        if (const auto found = find_negative(half))
          return found;
      return {};
    }
  } // namespace

  std::vector<double>
  parameters_between_levels(const RigidSurface                &surface,
                            const std::vector<ControlPolygon> &curves,
                            const std::vector<double>         &levels)
  {
    std::vector<double> parameters = {0., 1.};
    for (const ControlPolygon &curve : curves)
      for (const double level : levels)
        surface.level(curve, curve, level).add_sign_changes(parameters);
    std::sort(parameters.begin(), parameters.end());
    return parameters;
  }

  std::optional<CurvePassage> find_passage(const RigidSurface   &surface,
                                           const ControlPolygon &from,
                                           const ControlPolygon &to,
                                           const double          distance)
  {
    Patch whole;
    whole.levels = {{surface.level(from, from, distance),
                     surface.level(from, to, distance),
                     surface.level(to, to, distance)}};
    return find_negative(whole);
  }
} // namespace auxfem
