#include <auxfem/mesh/position_text.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/model/imperfections.h>
#include <auxfem/model/rigid_parts.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** @param path of what gives a set this name. */
    void check_name(const std::string &name,
                    const std::string &path,
                    const Lattice     &lattice)
    {
      // Else a selection could not tell the name from a list or a condition.
      const bool starts_well =
        !name.empty() && std::isalpha(static_cast<unsigned char>(name[0]));
      const bool is_plain =
        std::all_of(name.begin(), name.end(), [](const unsigned char letter) {
          return std::isalnum(letter) ||
            std::string(" _-.").find(letter) != std::string::npos;
        });
      if (!starts_well || !is_plain)
        throw InputError(
          path + ": \"" + name +
          "\" cannot name a set. Begin with a letter and go on "
          "with letters, digits, blanks, \"_\", \"-\" or \".\".");

      const char *kind = lattice.joint_sets.count(name) ? "joints"
        : lattice.strut_sets.count(name)                ? "struts"
        : lattice.pair_sets.count(name)                 ? "joint pairs"
                                                        : nullptr;
      if (kind)
        throw InputError(path + ": the lattice has a set of " + kind +
                         " named \"" + name +
                         "\" already. Choose another name.");
    }

    void add_set(const SetDefinition &definition,
                 const SceneContext  &context,
                 Lattice             &lattice)
    {
      check_name(definition.name, definition.path, lattice);
      const std::string &text  = definition.selection;
      const auto         colon = text.find(':');
      const std::string  kind  = dealii::Utilities::trim(text.substr(0, colon));
      const std::string  members =
        colon == std::string::npos ? "" : text.substr(colon + 1);
      if (colon != std::string::npos && kind == "joints")
        lattice.joint_sets[definition.name] =
          select_joints(lattice, members, context, definition.path);
      else if (colon != std::string::npos && kind == "struts")
        lattice.strut_sets[definition.name] =
          select_struts(lattice, members, context, definition.path);
      else
        throw InputError(definition.path + ": \"" + text +
                         "\" does not say what it selects. Begin with "
                         "\"joints:\" or \"struts:\", for example \"joints: "
                         "y > ymax - 1e-6\".");
    }

    void assign_sections(const Scene &scene, Lattice &lattice)
    {
      for (auto &strut : lattice.struts)
        strut.section = invalid_index;
      for (unsigned int i = 0; i < scene.sections.size(); ++i)
        {
          const SectionDefinition &definition = scene.sections[i];
          for (const unsigned int strut : select_struts(lattice,
                                                        definition.struts,
                                                        scene.context,
                                                        definition.path))
            lattice.struts[strut].section = i;
        }
    }

    std::string describe(const unsigned int number,
                         const Lattice     &lattice,
                         const unsigned int dimension)
    {
      const Strut         &strut = lattice.struts[number];
      dealii::Point<3>     middle;
      dealii::Tensor<1, 3> tangent;
      lattice.axis(strut, 0.5, middle, tangent);
      std::ostringstream text;
      text << "Strut " << number << " (joints " << strut.joints[0] << " and "
           << strut.joints[1] << ", middle at "
           << position_text(middle, dimension);
      for (const auto &[name, members] : lattice.strut_sets)
        if (name != "all" &&
            std::binary_search(members.begin(), members.end(), number))
          text << ", in the set \"" << name << "\"";
      text << ')';
      return text.str();
    }

    void check_sections(const Lattice &lattice, const unsigned int dimension)
    {
      const auto has_none = [](const Strut &strut) {
        return strut.section == invalid_index && !strut.is_rigid();
      };
      const auto n_bare =
        std::count_if(lattice.struts.begin(), lattice.struts.end(), has_none);
      if (n_bare == 0)
        return;
      const auto first =
        std::find_if(lattice.struts.begin(), lattice.struts.end(), has_none) -
        lattice.struts.begin();
      throw InputError(
        "Sections: " + describe(first, lattice, dimension) +
        (n_bare > 1 ? " and " + std::to_string(n_bare - 1) + " more have"
                    : " has") +
        " no section. Add a section whose struts include them (\"all\" means "
        "every strut), or make them Rigid parts.");
    }

    void add_plate(const PlateDefinition &plate, Lattice &lattice)
    {
      check_name(plate.name, plate.path, lattice);
      lattice.joint_sets[plate.name] = {
        static_cast<unsigned int>(lattice.joints.size())};
      lattice.joints.push_back(plate.position);
      ++lattice.n_plates;
    }
    /** @param disturb_if_asked gives the designed lattice its imperfections */
    template <class Disturb>
    Lattice build(const Scene &scene, const Disturb &disturb_if_asked)
    {
      Lattice lattice =
        make_array(scene.lattice.cell->build(), scene.lattice.n_cells);
      lattice.dimension = scene.context.dimension;
      for (const auto &definition : scene.sets)
        add_set(definition, scene.context, lattice);
      assign_sections(scene, lattice);
      disturb_if_asked(lattice);
      make_rigid_parts(scene, lattice);
      check_sections(lattice, scene.context.dimension);
      for (const PlateDefinition &plate : scene.plates)
        add_plate(plate, lattice);
      return lattice;
    }
  } // namespace

  Lattice build_lattice(const Scene                 &scene,
                        const GeometryOffsets *const offsets)
  {
    return build(scene, [&](Lattice &lattice) {
      if (!scene.imperfections.empty())
        disturb(offsets != nullptr ? *offsets : given_offsets(scene, lattice),
                lattice);
    });
  }

  Lattice designed_lattice(const Scene &scene)
  {
    return build(scene, [](const Lattice &) {});
  }
} // namespace auxfem
