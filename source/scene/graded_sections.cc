#include <auxfem/mesh/designed_array.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/scene/graded_sections.h>

#include <algorithm>
#include <deque>
#include <map>

namespace auxfem
{
  void assign_sections(const Scene &scene, Lattice &lattice)
  {
    for (Strut &strut : lattice.struts)
      strut.section = invalid_index;
    for (unsigned int i = 0; i < scene.sections.size(); ++i)
      {
        const SectionDefinition &definition = scene.sections[i];
        if (!definition.graded_struts.empty())
          continue;
        for (const unsigned int strut : select_struts(lattice,
                                                      definition.struts,
                                                      scene.context,
                                                      definition.path))
          lattice.struts[strut].section = i;
      }
    for (unsigned int i = 0; i < scene.sections.size(); ++i)
      for (const unsigned int strut : scene.sections[i].graded_struts)
        lattice.struts[strut].section = i;
  }

  namespace
  {
    /** The sections that one section with a grading becomes. */
    class GradedVariants
    {
    public:
      explicit GradedVariants(const SectionDefinition &section)
        : section(section)
      {}

      void add(const StrutPlace &place)
      {
        const std::vector<double> factors = section.grading->factors_at(place);
        auto                      found   = by_factors.find(factors);
        if (found == by_factors.end())
          {
            found = by_factors.emplace(factors, variants.size()).first;
            variants.push_back(section.grading->with_factors(factors, section));
            variants.back().grading = nullptr;
          }
        variants[found->second].graded_struts.push_back(place.strut);
      }

      /** Puts the first in the place of the section, the others behind all. */
      void move_to(const unsigned int              place,
                   std::vector<SectionDefinition> &sections)
      {
        if (variants.empty())
          return;
        sections[place] = std::move(variants.front());
        sections.reserve(sections.size() + variants.size());
        std::move(variants.begin() + 1,
                  variants.end(),
                  std::back_inserter(sections));
      }

    private:
      const SectionDefinition                     section;
      std::map<std::vector<double>, unsigned int> by_factors;
      /** A deque, as there may be one for each strut. */
      std::deque<SectionDefinition> variants;
    };
  } // namespace

  void grade_sections(Scene &scene)
  {
    std::map<unsigned int, GradedVariants> graded;
    for (unsigned int i = 0; i < scene.sections.size(); ++i)
      if (scene.sections[i].grading)
        graded.emplace(i, scene.sections[i]);
    if (graded.empty())
      return;
    Lattice lattice =
      make_designed_array(scene.lattice, scene.sets, scene.context);
    assign_sections(scene, lattice);
    for (auto &entry : graded)
      scene.sections[entry.first].grading->set_bounds(bounding_box(lattice));
    for (unsigned int i = 0; i < lattice.struts.size(); ++i)
      {
        const Strut &strut = lattice.struts[i];
        const auto   found = graded.find(strut.section);
        if (found == graded.end())
          continue;
        dealii::Point<3>     middle;
        dealii::Tensor<1, 3> tangent;
        lattice.axis(strut, 0.5, middle, tangent);
        found->second.add({middle[0], middle[1], middle[2], i, strut.cell});
      }
    for (auto &[place, variants] : graded)
      variants.move_to(place, scene.sections);
  }
} // namespace auxfem
