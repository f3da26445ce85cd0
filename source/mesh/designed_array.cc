#include <auxfem/mesh/array_changes.h>
#include <auxfem/mesh/designed_array.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>

namespace auxfem
{
  void check_set_name(const std::string &name,
                      const std::string &path,
                      const Lattice     &lattice)
  {
    // Selections must distinguish names from lists and conditions.
    const bool starts_well =
      !name.empty() && std::isalpha(static_cast<unsigned char>(name[0]));
    const bool is_plain =
      std::all_of(name.begin(), name.end(), [](const unsigned char letter) {
        return std::isalnum(letter) ||
          std::string(" _-.").find(letter) != std::string::npos;
      });
    if (!starts_well || !is_plain)
      throw InputError(path + ": \"" + name +
                       "\" cannot name a set. Begin with a letter and go on "
                       "with letters, digits, blanks, \"_\", \"-\" or \".\".");

    const char *kind = lattice.joint_sets.count(name) ? "joints"
      : lattice.strut_sets.count(name)                ? "struts"
      : lattice.pair_sets.count(name)                 ? "joint pairs"
                                                      : nullptr;
    if (kind)
      throw InputError(path + ": the lattice has a set of " + kind +
                       " named \"" + name + "\" already. Choose another name.");
  }

  namespace
  {
    void add_set(const SetDefinition &definition,
                 const SceneContext  &context,
                 Lattice             &lattice)
    {
      check_set_name(definition.name, definition.path, lattice);
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
  } // namespace

  Lattice make_designed_array(const LatticeDefinition          &definition,
                              const std::vector<SetDefinition> &sets,
                              const SceneContext               &context)
  {
    if (definition.is_infinite)
      {
        PeriodicArray array = make_periodic_array(definition.cell->build(),
                                                  definition.n_cells,
                                                  context.dimension);
        for (const SetDefinition &set : sets)
          add_set(set, context, array.lattice);
        array.lattice.n_images = array.periodicity.images.size();
        array.lattice.periodicity =
          std::make_shared<const Periodicity>(std::move(array.periodicity));
        return array.lattice;
      }
    SceneContext lattice_context = context;
    lattice_context.path         = "Lattice";
    Lattice lattice   = make_array_in_region(definition.cell->build(),
                                           definition.n_cells,
                                           definition.changes.region,
                                           lattice_context);
    lattice.dimension = context.dimension;
    change_array(definition.changes, lattice_context, lattice);
    for (const SetDefinition &set : sets)
      add_set(set, context, lattice);
    return lattice;
  }
} // namespace auxfem
