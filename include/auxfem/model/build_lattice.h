#ifndef auxfem_model_build_lattice_h
#define auxfem_model_build_lattice_h

#include <auxfem/mesh/imperfection.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** Size of a scene, which may be too large to be set up. */
  struct SceneSize
  {
    double joints   = 0;
    double struts   = 0;
    double unknowns = 0; ///< without multipliers
    double memory   = 0; ///< about, on all ranks (bytes)
  };

  /**
   * Size of @p scene, found without making its lattice: the counts are those of
   * arrays of one and two cells, continued linearly in each direction.
   */
  SceneSize size_of(const Scene &scene);

  /**
   * Lines on the size of @p scene for the user if it takes a second or more to
   * be set up, else empty. Throws InputError for one with more joints, struts
   * or unknowns than can be numbered.
   */
  std::string size_text(const Scene &scene);

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

  /**
   * What the imperfections of @p scene add up to on @p lattice, its designed
   * one, but for those that are buckling modes. Throws InputError for
   * expressions and sets that are not understood.
   */
  GeometryOffsets given_offsets(const Scene &scene, const Lattice &lattice);
} // namespace auxfem

#endif
