#ifndef auxfem_tests_mesh_cell_from_text_h
#define auxfem_tests_mesh_cell_from_text_h

#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/errors.h>

#include <stdexcept>
#include <string>

namespace auxfem
{
  /**
   * Makes the registered cell @p name from parameter lines as a user writes
   * them in a file in @p directory.
   */
  inline std::unique_ptr<Cell>
  cell_from_text(const std::string &name,
                 const std::string &text,
                 const std::string &directory = ".")
  {
    for (const auto &entry : cell_registry())
      if (entry.name == name)
        {
          dealii::ParameterHandler prm;
          entry.declare(prm);
          prm.parse_input_from_string(text);
          SceneContext context;
          context.path      = "Lattice";
          context.directory = directory;
          return entry.make(prm, context);
        }
    throw std::logic_error("no cell " + name);
  }

  /** The message of the InputError that @p action throws; empty if none. */
  template <class Action>
  std::string input_error_of(const Action &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  inline bool contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace auxfem

#endif
