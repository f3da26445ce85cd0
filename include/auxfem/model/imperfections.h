#ifndef auxfem_model_imperfections_h
#define auxfem_model_imperfections_h

#include <auxfem/mesh/imperfection.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * What the imperfections of @p scene add up to on @p lattice, its designed
   * one, but for those that are buckling modes. Throws InputError for
   * expressions and sets that are not understood.
   */
  GeometryOffsets given_offsets(const Scene &scene, const Lattice &lattice);
} // namespace auxfem

#endif
