#ifndef auxfem_mesh_designed_array_h
#define auxfem_mesh_designed_array_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/lattice_definition.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * The array of cells that @p definition describes, with the user's @p sets:
   * without sections, rigid parts, imperfections and plates. Throws InputError
   * for sets that select nothing or whose names are taken.
   */
  Lattice make_designed_array(const LatticeDefinition          &definition,
                              const std::vector<SetDefinition> &sets,
                              const SceneContext               &context);

  /**
   * Throws InputError unless @p name can name a new set of @p lattice.
   * @param path of the parameter that names the set
   */
  void check_set_name(const std::string &name,
                      const std::string &path,
                      const Lattice     &lattice);
} // namespace auxfem

#endif
