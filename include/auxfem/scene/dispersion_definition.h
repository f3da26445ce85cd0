#ifndef auxfem_scene_dispersion_definition_h
#define auxfem_scene_dispersion_definition_h

#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** `Dispersion`: waves of an infinite lattice to be computed. */
  struct DispersionDefinition
  {
    /** A wave vector as parts of the reciprocal vectors of the period. */
    using WaveVector = std::array<double, 3>;

    /** Corners of the path. */
    std::vector<WaveVector> path;
    unsigned int            points      = 20; ///< on each leg of the path
    unsigned int            bands       = 8;
    unsigned int            zone_points = 8; ///< along each reciprocal vector

    /** All wave vectors of the path, in order. */
    std::vector<WaveVector> points_of_path() const;

    /** Wave vectors of a grid over half the zone; the other half has the same
     * waves. */
    std::vector<WaveVector> points_of_zone(unsigned int dimension) const;
  };

  /** Schema of `Dispersion`. */
  SubsectionSchema dispersion_schema();

  /** Reads `Dispersion`. Throws InputError for a path that is none. */
  DispersionDefinition read_dispersion(ParameterValues &values);
} // namespace auxfem

#endif
