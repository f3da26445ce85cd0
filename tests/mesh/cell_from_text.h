#ifndef auxfem_tests_mesh_cell_from_text_h
#define auxfem_tests_mesh_cell_from_text_h

#include <auxfem/mesh/cell.h>

#include <support/parameter_values.h>

#include <stdexcept>
#include <string>

#include <support/messages.h>

namespace auxfem
{
  /**
   * Makes the registered cell @p name from parameter lines as a user writes
   * them in a file in @p directory.
   */
  inline std::unique_ptr<Cell>
  cell_from_text(const std::string &name,
                 const std::string &text,
                 const std::string &directory = ".",
                 const unsigned int dimension = 2)
  {
    for (const auto &entry : cell_registry())
      if (entry.name == name)
        {
          SceneContext context;
          context.path      = "Lattice";
          context.directory = directory;
          context.dimension = dimension;
          ParameterValues values =
            values_from_text(entry.parameters, text, context);
          return entry.make(values);
        }
    throw std::logic_error("no cell " + name);
  }

  /** @p nx x @p ny star cells as they are without parameters. */
  inline Lattice array_of_stars(const unsigned int nx, const unsigned int ny)
  {
    return make_array(cell_from_text("star", "")->build(), {{nx, ny, 1}});
  }
} // namespace auxfem

#endif
