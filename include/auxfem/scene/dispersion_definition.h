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
    bool                    damped      = false;

    /** All wave vectors of the path, in order. */
    std::vector<WaveVector> points_of_path() const;
  };

  /** Wave vectors of a grid of @p n along each reciprocal vector, over half the
   * zone: the other half has the same waves. */
  std::vector<DispersionDefinition::WaveVector>
  wave_vectors_of_zone(unsigned int n, unsigned int dimension);

  /** Schema of `Dispersion`. */
  SubsectionSchema dispersion_schema();

  /** Reads `Dispersion`. Throws InputError for a path that is none. */
  DispersionDefinition read_dispersion(ParameterValues &values);
} // namespace auxfem

#endif
