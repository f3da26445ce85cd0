#ifndef auxfem_model_scene_size_h
#define auxfem_model_scene_size_h

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
} // namespace auxfem

#endif
