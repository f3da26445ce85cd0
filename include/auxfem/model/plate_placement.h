#ifndef auxfem_model_plate_placement_h
#define auxfem_model_plate_placement_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * Position of the reference point of @p plate at rest (m): as given, or with
   * a PlateDefinition::gap moved along the normal at the nearest strut until
   * the gap is that large. Arcs keep a thousandth of their half thickness
   * more, because elements follow them approximately. Throws InputError if
   * there is no such position near the given one.
   */
  dealii::Point<3> position_of_plate(const PlateDefinition &plate,
                                     const Scene           &scene,
                                     const Lattice         &lattice);
} // namespace auxfem

#endif
