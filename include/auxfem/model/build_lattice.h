#ifndef auxfem_model_build_lattice_h
#define auxfem_model_build_lattice_h

#include <auxfem/mesh/imperfection.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** Estimated size of a scene. */
  struct SceneSize
  {
    double joints   = 0;
    double struts   = 0;
    double unknowns = 0; ///< without multipliers
    double memory   = 0; ///< estimate over all ranks (bytes)
  };

  /**
   * Estimates the size of @p scene without building its lattice: counts of
   * arrays of one and two cells are extrapolated linearly.
   */
  SceneSize size_of(const Scene &scene);

  /**
   * Note to the user on the size of a large @p scene; empty for small ones.
   * Throws InputError for more unknowns than can be numbered.
   */
  std::string size_text(const Scene &scene);

  /**
   * Builds the lattice of a scene: cells, sets, sections and imperfections.
   * Later section definitions override earlier ones; a strut without section is
   * an InputError.
   * @param offsets precomputed imperfections; nullptr for given_offsets()
   */
  Lattice build_lattice(const Scene           &scene,
                        const GeometryOffsets *offsets = nullptr);

  /** Builds the lattice without imperfections. */
  Lattice designed_lattice(const Scene &scene);

  /**
   * Sum of the random and expression imperfections of @p scene on its designed
   * @p lattice; buckling modes are excluded. Throws InputError for invalid
   * expressions and sets.
   */
  GeometryOffsets given_offsets(const Scene &scene, const Lattice &lattice);
} // namespace auxfem

#endif
