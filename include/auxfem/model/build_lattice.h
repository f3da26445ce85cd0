#ifndef auxfem_model_build_lattice_h
#define auxfem_model_build_lattice_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * Builds the scene's lattice: the array, the user's sets, a section for every
   * strut (later definitions win; a strut without section is an InputError
   * naming it).
   */
  Lattice build_lattice(const Scene &scene);
} // namespace auxfem

#endif
