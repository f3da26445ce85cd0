#ifndef auxfem_output_shape_amplitude_h
#define auxfem_output_shape_amplitude_h

#include <auxfem/equations/equations.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * By what the shape of a mode, of all local unknowns, is multiplied to be
   * seen in pictures of @p scene: ModesDefinition::amplitude (m per shape).
   * Collective.
   */
  double shape_amplitude(const Scene     &scene,
                         const Equations &equations,
                         const Vector    &shape);
} // namespace auxfem

#endif
