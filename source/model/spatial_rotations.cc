#include <auxfem/model/spatial_rotations.h>

#include <algorithm>

namespace auxfem
{
  SpatialRotations::SpatialRotations(const unsigned int n_local_unknowns)
    : of_unknown(n_local_unknowns, -1)
  {}

  void SpatialRotations::add(const std::array<int, 3> &spins)
  {
    if (spins[0] < 0 || of_unknown[spins[0]] >= 0)
      return;
    for (const int spin : spins)
      of_unknown[spin] = rotations.size();
    rotations.push_back(spins);
  }

  unsigned int SpatialRotations::axis(const unsigned int unknown) const
  {
    const std::array<int, 3> &spins = rotations[of_unknown[unknown]];
    return std::find(spins.begin(), spins.end(), static_cast<int>(unknown)) -
      spins.begin();
  }
} // namespace auxfem
