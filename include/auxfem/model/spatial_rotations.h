#ifndef auxfem_model_spatial_rotations_h
#define auxfem_model_spatial_rotations_h

#include <array>
#include <vector>

namespace auxfem
{
  /**
   * The rotations in space kept on this rank, each with three unknowns: its
   * spins about x, y, z. None in the plane.
   */
  class SpatialRotations
  {
  public:
    explicit SpatialRotations(unsigned int n_local_unknowns);

    /** Adds the rotation with these local unknowns, unless it is there or they
     * are not (-1). */
    void add(const std::array<int, 3> &spins);

    unsigned int size() const
    {
      return rotations.size();
    }

    /** Local numbers of the spins of rotation @p i. */
    const std::array<int, 3> &operator[](const unsigned int i) const
    {
      return rotations[i];
    }

    std::vector<std::array<int, 3>>::const_iterator begin() const
    {
      return rotations.begin();
    }

    std::vector<std::array<int, 3>>::const_iterator end() const
    {
      return rotations.end();
    }

    /** Index of the rotation that a local unknown is a spin of; -1: none. */
    int with(const unsigned int unknown) const
    {
      return of_unknown[unknown];
    }

    /** Axis, 0 to 2, about which a local unknown is the spin. */
    unsigned int axis(unsigned int unknown) const;

  private:
    std::vector<std::array<int, 3>> rotations;
    std::vector<int>                of_unknown;
  };
} // namespace auxfem

#endif
