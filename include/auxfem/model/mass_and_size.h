#ifndef auxfem_model_mass_and_size_h
#define auxfem_model_mass_and_size_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/scene.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** Mass and size of a lattice. */
  struct MassAndSize
  {
    /** Extent of the joints along x, y, z (m). */
    dealii::Tensor<1, 3> size;
    /** Mass of struts, rigid parts and point masses (kg); none if a section has
     * no density. */
    std::optional<double> mass;
    /** Volume of elastic struts (m3). */
    double strut_volume = 0;
    /** Width of the widest section (m); 0 if none has dimensions. */
    double depth = 0;
    /** Whether all sections have dimensions. */
    bool has_dimensions = true;
    /** strut_volume over that of the box of the joints or, in an infinite
     * lattice, of the period; in the plane of the depth of the widest section.
     * None if the box is flat or a section has no dimensions. */
    std::optional<double> relative_density;
    /** Number of elastic struts by section as in the file; sections without
     * struts are left out. */
    std::vector<std::pair<std::string, unsigned int>> struts_of_section;
  };

  MassAndSize mass_and_size(const Scene &scene, const Lattice &lattice);

  /** MassAndSize::mass, without density as 0. */
  double total_mass(const Scene &scene, const Lattice &lattice);
} // namespace auxfem

#endif
