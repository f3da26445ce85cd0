#include <auxfem/equations/displaced_state.h>
#include <auxfem/equations/node_rotations.h>

namespace auxfem
{
  State displaced(const State        &state,
                  const DofNumbering &numbering,
                  const Vector       &shape,
                  const double        factor)
  {
    const NodeRotations rotations(numbering);
    State               moved = state;
    Vector              added = shape;
    scale(factor, added);
    for (unsigned int i = 0; i < moved.rotations.size(); ++i)
      moved.rotations[i] = normalized(exponential(rotations.values(added, i)) *
                                      moved.rotations[i]);
    rotations.make_material(moved, added);
    add_multiple(1., added, moved.displacement);
    return moved;
  }
} // namespace auxfem
