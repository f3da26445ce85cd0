#ifndef auxfem_model_build_lattice_h
#define auxfem_model_build_lattice_h

#include <auxfem/mesh/imperfection.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * Builds the scene's lattice: the array, the user's sets, a section for every
   * strut (later definitions win; a strut without section is an InputError
   * naming it), and its imperfections.
   * @param offsets all of these, if they have been found already; nullptr:
   *   given_offsets()
   */
  Lattice build_lattice(const Scene           &scene,
                        const GeometryOffsets *offsets = nullptr);

  /** The same without imperfections. */
  Lattice designed_lattice(const Scene &scene);
} // namespace auxfem

#endif
