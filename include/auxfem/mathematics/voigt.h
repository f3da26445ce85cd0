#ifndef auxfem_mathematics_voigt_h
#define auxfem_mathematics_voigt_h

#include <array>
#include <string>

namespace auxfem
{
  /** Number of strain components: 3 in the plane, 6 in space. */
  constexpr unsigned int n_strain_components(const unsigned int dimension)
  {
    return dimension == 2 ? 3 : 6;
  }

  /** Axes of the component @p i of vectors of strains and stresses: 11, 22, 12
   * in the plane, 11, 22, 33, 23, 13, 12 in space (Voigt). */
  constexpr std::array<unsigned int, 2>
  axes_of_component(const unsigned int i, const unsigned int dimension)
  {
    constexpr std::array<std::array<unsigned int, 2>, 3> shears = {
      {{{1, 2}}, {{0, 2}}, {{0, 1}}}};
    return i < dimension ? std::array<unsigned int, 2>{{i, i}}
      : dimension == 2   ? shears[2]
                         : shears[i - 3];
  }

  /** Name of the component @p i, e.g. `12`. */
  inline std::string name_of_component(const unsigned int i,
                                       const unsigned int dimension)
  {
    const auto [a, b] = axes_of_component(i, dimension);
    return std::to_string(a + 1) + std::to_string(b + 1);
  }
} // namespace auxfem

#endif
