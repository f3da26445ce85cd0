#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/mass_and_size.h>

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

    /** Relative density in a box of the size @p found.size. */
    std::optional<double> relative_density(const Scene       &scene,
                                           const Lattice     &lattice,
                                           const MassAndSize &found)
    {
      double depth    = 0;
      bool   is_known = true;
      for_each_elastic_strut(scene,
                             lattice,
                             [&](const Strut &,
                                 const SectionDefinition &definition) {
                               const double width =
                                 definition.section.half_thicknesses[0];
                               depth    = std::max(depth, 2 * width);
                               is_known = is_known && width > 0;
                             });
      const double box = found.size[0] * found.size[1] *
        (lattice.dimension == 2 ? depth : found.size[2]);
      if (!is_known || !(box > 0))
        return std::nullopt;
      return found.strut_volume / box;
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
        auto &[name, number] = numbers[definition.number];
        name                 = definition.name;
        ++number;
      });
    if (has_density)
      result.mass = total_mass(scene, lattice);
    if (!lattice.periodicity)
      result.relative_density = relative_density(scene, lattice, result);
    for (const auto &entry : numbers)
      result.struts_of_section.push_back(entry.second);
    return result;
  }
} // namespace auxfem
