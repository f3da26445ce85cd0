#include <auxfem/mesh/position_function.h>
#include <auxfem/model/plate_placement.h>
#include <auxfem/parameters/errors.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Number of parts of a strut that are searched for the nearest point. */
    constexpr unsigned int n_parts = 16;

    /** Half thickness of a strut (m), of a tapered one the largest. */
    double half_thickness(const Section &section, const unsigned int dimension)
    {
      double largest = 0;
      for (unsigned int i = 0; i <= (section.taper ? n_parts : 0); ++i)
        largest = std::max(
          largest,
          section.at(double(i) / n_parts).contact_half_thickness(dimension));
      return largest;
    }

    /** The point of the struts' faces nearest to a plate. */
    struct NearestFace
    {
      double               gap = std::numeric_limits<double>::infinity(); ///< m
      dealii::Tensor<1, 3> normal; ///< out of the plate
    };

    class Placement
    {
    public:
      Placement(const PlateDefinition &plate,
                const Scene           &scene,
                const Lattice         &lattice)
        : surface(*plate.surface)
        , lattice(lattice)
      {
        for (const Strut &strut : lattice.struts)
          margins.push_back(
            strut.section == invalid_index
              ? 0.
              : half_thickness(scene.sections[strut.section].section,
                               lattice.dimension) *
                (strut.sagitta == 0 ? 1 : 1.001));
      }

      NearestFace nearest_face(const dealii::Point<3> &plate) const
      {
        NearestFace nearest;
        for (unsigned int i = 0; i < lattice.struts.size(); ++i)
          {
            const Strut &strut  = lattice.struts[i];
            const double length = lattice.length(strut);
            const double middle =
              surface.distance(point(strut, 0.5) - plate) - margins[i];
            if (middle - length / 2 > nearest.gap)
              continue;
            const auto [s, distance] = nearest_point(strut, plate);
            if (distance - margins[i] < nearest.gap)
              nearest = {distance - margins[i],
                         surface.at(point(strut, s) - plate).normal};
          }
        return nearest;
      }

    private:
      dealii::Point<3> point(const Strut &strut, const double s) const
      {
        dealii::Point<3>     position;
        dealii::Tensor<1, 3> tangent;
        lattice.axis(strut, s, position, tangent);
        return position;
      }

      /** Place on a strut and distance (m) of its nearest point. */
      std::pair<double, double>
      nearest_point(const Strut &strut, const dealii::Point<3> &plate) const
      {
        const auto distance = [&](const double s) {
          return surface.distance(point(strut, s) - plate);
        };
        std::pair<double, double> best = {0., distance(0)};
        for (unsigned int i = 1; i <= n_parts; ++i)
          if (const double s = double(i) / n_parts, here = distance(s);
              here < best.second)
            best = {s, here};
        constexpr int half_the_digits = 26;
        const auto    minimum         = boost::math::tools::brent_find_minima(
          distance,
          std::max(0., best.first - 1. / n_parts),
          std::min(1., best.first + 1. / n_parts),
          half_the_digits);
        return minimum.second < best.second ? minimum : best;
      }

      const RigidSurface &surface;
      const Lattice      &lattice;
      std::vector<double> margins; ///< half thickness of each strut (m)
    };
  } // namespace

  dealii::Point<3> position_of_plate(const PlateDefinition &plate,
                                     const Scene           &scene,
                                     const Lattice         &lattice)
  {
    if (!plate.gap)
      return plate.position;
    const Placement placement(plate, scene, lattice);
    const auto      box       = bounding_box(lattice);
    const double    precision = 1e-12 * box[0].distance(box[1]);
    // A plane arrives at once, a ball with each step nearer.
    constexpr unsigned int max_moves = 200;
    dealii::Point<3>       position  = plate.position;
    for (unsigned int i = 0; i < max_moves; ++i)
      {
        const NearestFace nearest = placement.nearest_face(position);
        if (std::abs(nearest.gap - *plate.gap) <= precision)
          return position;
        position += (nearest.gap - *plate.gap) * nearest.normal;
      }
    throw InputError(plate.path +
                     "/Gap: moving the body from its Position towards the "
                     "nearest strut does not lead to this gap. Give a Position "
                     "outside of the lattice.");
  }
} // namespace auxfem
