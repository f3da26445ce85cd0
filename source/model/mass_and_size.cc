#include <auxfem/mesh/periodic_array.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/mass_and_size.h>
#include <auxfem/scene/infinite_lattice.h>

#include <algorithm>
#include <map>

namespace auxfem
{
  namespace
  {
    /** Volume of a strut (m3). */
    double
    volume(const Section &section, const Strut &strut, const Lattice &lattice)
    {
      const double length = lattice.length(strut);
      if (!section.taper)
        return section.area * length;
      // Simpson's rule, exact for factors of up to third degree in total.
      return (section.at(0).area + 4 * section.at(0.5).area +
              section.at(1).area) /
        6 * length;
    }

    /** Calls @p visit with each elastic strut and its section. */
    template <class Visit>
    void for_each_elastic_strut(const Scene   &scene,
                                const Lattice &lattice,
                                const Visit   &visit)
    {
      for (const Strut &strut : lattice.struts)
        if (!strut.is_rigid())
          visit(strut, scene.sections[strut.section]);
    }

    /** Volume of the period, or of the box of the joints (m3). */
    double volume_around(const Scene       &scene,
                         const Lattice     &lattice,
                         const MassAndSize &found)
    {
      if (lattice.periodicity)
        return lattice.periodicity->volume() * depth_of_continuum(scene);
      return found.size[0] * found.size[1] *
        (lattice.dimension == 2 ? found.depth : found.size[2]);
    }
  } // namespace

  double total_mass(const Scene &scene, const Lattice &lattice)
  {
    double mass = 0;
    for_each_elastic_strut(scene,
                           lattice,
                           [&](const Strut             &strut,
                               const SectionDefinition &definition) {
                             mass += definition.section.density *
                               volume(definition.section, strut, lattice);
                           });
    for (const RigidPart &part : lattice.rigid_parts)
      mass += part.mass;
    for (const MassDefinition &point : scene.masses)
      for (const unsigned int joint : joints_of(point, lattice, scene.context))
        mass += lattice.is_image(joint) ? 0 : point.mass;
    return mass;
  }

  MassAndSize mass_and_size(const Scene &scene, const Lattice &lattice)
  {
    MassAndSize result;
    const auto  box = bounding_box(lattice);
    result.size     = box[1] - box[0];
    std::map<unsigned int, std::pair<std::string, unsigned int>> numbers;
    bool has_density = true;
    for_each_elastic_strut(
      scene,
      lattice,
      [&](const Strut &strut, const SectionDefinition &definition) {
        has_density = has_density && definition.has_density;
        result.strut_volume += volume(definition.section, strut, lattice);
        const double width    = 2 * definition.section.half_thicknesses[0];
        result.depth          = std::max(result.depth, width);
        result.has_dimensions = result.has_dimensions && width > 0;
        auto &[name, number]  = numbers[definition.number];
        name                  = definition.name;
        ++number;
      });
    if (has_density)
      result.mass = total_mass(scene, lattice);
    const double around = volume_around(scene, lattice, result);
    if (result.has_dimensions && around > 0)
      result.relative_density = result.strut_volume / around;
    for (const auto &entry : numbers)
      result.struts_of_section.push_back(entry.second);
    return result;
  }
} // namespace auxfem
