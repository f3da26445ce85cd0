#include <auxfem/struts/section_stresses.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Turns moments and shear forces so that M_3 has all of the moment. */
    void turn_into_bending_plane(std::array<double, 6> &forces)
    {
      const double moment = std::hypot(forces[4], forces[5]);
      if (moment == 0)
        {
          forces[1] = std::hypot(forces[1], forces[2]);
          forces[2] = 0;
          return;
        }
      const double c = forces[5] / moment, s = forces[4] / moment;
      const double shear_2 = forces[1], shear_3 = forces[2];
      forces[1] = c * shear_2 - s * shear_3;
      forces[2] = s * shear_2 + c * shear_3;
      forces[4] = 0;
      forces[5] = moment;
    }

    Stresses without_shape(const std::array<double, 6> &forces,
                           const double                 area)
    {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      Stresses         stresses;
      stresses.axial        = forces[0] / area;
      const auto or_unknown = [&](const bool is_zero) {
        return is_zero ? 0. : unknown;
      };
      stresses.bending = or_unknown(forces[4] == 0 && forces[5] == 0);
      stresses.shear   = or_unknown(forces[1] == 0 && forces[2] == 0);
      stresses.torsion = or_unknown(forces[3] == 0);
      stresses.fibre   = stresses.axial + stresses.bending;
      stresses.von_mises =
        std::abs(stresses.fibre) + stresses.shear + stresses.torsion;
      return stresses;
    }
  } // namespace

  SectionStresses::SectionStresses(const CrossSection &section,
                                   const unsigned int  dimension)
    : area(section.area)
    , second_moment_2(section.second_moment_2)
    , second_moment_3(section.second_moment_3)
  {
    if (section.make_stress_points)
      stress_points = section.make_stress_points(dimension);
  }

  Stresses SectionStresses::at(std::array<double, 6> forces) const
  {
    if (!has_shape())
      return without_shape(forces, area);
    if (stress_points.is_axisymmetric)
      turn_into_bending_plane(forces);
    const auto [N, Q_2, Q_3, T, M_2, M_3] = forces;
    Stresses largest;
    largest.axial    = N / area;
    double von_mises = 0, shear = 0, torsion = 0;
    for (const StressPoint &point : stress_points.points)
      {
        const double bending =
          M_2 * point.z / second_moment_2 - M_3 * point.y / second_moment_3;
        const double fibre  = largest.axial + bending;
        double       square = 0, shear_square = 0, torsion_square = 0;
        for (unsigned int d = 0; d < 2; ++d)
          {
            const double by_shear =
              Q_2 * point.by_shear_2[d] + Q_3 * point.by_shear_3[d];
            const double by_torque = T * point.by_torque[d];
            shear_square += by_shear * by_shear;
            torsion_square += by_torque * by_torque;
            square += (by_shear + by_torque) * (by_shear + by_torque);
          }
        largest.bending = std::max(largest.bending, std::abs(bending));
        if (std::abs(fibre) > std::abs(largest.fibre))
          largest.fibre = fibre;
        shear     = std::max(shear, shear_square);
        torsion   = std::max(torsion, torsion_square);
        von_mises = std::max(von_mises, fibre * fibre + 3 * square);
      }
    largest.shear     = std::sqrt(shear);
    largest.torsion   = std::sqrt(torsion);
    largest.von_mises = std::sqrt(von_mises);
    return largest;
  }
} // namespace auxfem
