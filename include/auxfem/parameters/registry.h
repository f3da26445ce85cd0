#ifndef auxfem_parameters_registry_h
#define auxfem_parameters_registry_h

#include <auxfem/parameters/parameter_values.h>
#include <auxfem/parameters/subsection_schema.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

/**
 * @file
 * Lists of named items: parameters, variants, registry entries.
 */
namespace auxfem
{
  /** First item of @p list with that @p name, or nullptr. */
  template <class List>
  auto find_by_name(List &list, const std::string &name)
  {
    const auto found =
      std::find_if(list.begin(), list.end(), [&name](const auto &item) {
        return item.name == name;
      });
    return found == list.end() ? nullptr : &*found;
  }

  /** Names of all items of @p list. */
  template <class Named>
  std::vector<std::string> names_of(const std::vector<Named> &list)
  {
    std::vector<std::string> names;
    for (const Named &item : list)
      names.push_back(item.name);
    return names;
  }

  /**
   * One choice in a table of kinds (connector laws, cells, time schemes). The
   * parameter reference in doc/ is generated from these tables.
   */
  template <class Product>
  struct RegistryEntry
  {
    /** The word the user writes, e.g. `kelvin-voigt`. */
    std::string name;

    /** One sentence for the parameter reference. */
    std::string description;

    /** Parameters of this choice. */
    Parameters parameters;

    /**
     * Creates the object. Throws InputError for values that contradict each
     * other.
     */
    std::unique_ptr<Product> (*make)(ParameterValues &values);
  };

  template <class Product>
  using Registry = std::vector<RegistryEntry<Product>>;

  /** Entry of @p table with the name @p name, which must exist. */
  template <class Entry>
  const Entry &find_entry(const std::vector<Entry> &table,
                          const std::string        &name)
  {
    return *find_by_name(table, name);
  }

  /** Choices of @p registry as variants of a subsection. */
  template <class Product>
  std::vector<SubsectionVariant> variants_of(const Registry<Product> &registry)
  {
    std::vector<SubsectionVariant> variants;
    for (const RegistryEntry<Product> &entry : registry)
      variants.push_back({entry.name, entry.description, entry.parameters});
    return variants;
  }
} // namespace auxfem

#endif
