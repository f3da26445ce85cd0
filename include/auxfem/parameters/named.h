#ifndef auxfem_parameters_named_h
#define auxfem_parameters_named_h

#include <algorithm>
#include <string>
#include <vector>

/**
 * @file
 * Lists of things that have a name: parameters, variants, lines of a registry.
 */
namespace auxfem
{
  /** The first item of @p list with that @p name, or nullptr. */
  template <class List>
  auto find_by_name(List &list, const std::string &name)
  {
    const auto found =
      std::find_if(list.begin(), list.end(), [&name](const auto &item) {
        return item.name == name;
      });
    return found == list.end() ? nullptr : &*found;
  }

  /** The names of all items of @p list. */
  template <class Named>
  std::vector<std::string> names_of(const std::vector<Named> &list)
  {
    std::vector<std::string> names;
    for (const Named &item : list)
      names.push_back(item.name);
    return names;
  }
} // namespace auxfem

#endif
