#include <auxfem/equations/node_rotations.h>
#include <auxfem/output/rotation_vectors.h>

#include <algorithm>

namespace auxfem
{
  RotationVectors::RotationVectors(const LatticeModel &model)
    : model(model)
    , rotations(model.numbering.rotations().size())
  {}

  void RotationVectors::follow(const State &state)
  {
    for (unsigned int i = 0; i < rotations.size(); ++i)
      {
        const SpaceVector entries =
          NodeRotations(model.numbering).values(state.displacement, i);
        SpaceVector &vector = rotations[i].vector;
        if (state.rotations.empty())
          vector = entries;
        else
          vector =
            rotation_vector_near(state.rotations[i],
                                 vector +
                                   rotated(state.rotations[i],
                                           entries - rotations[i].entries));
        rotations[i].entries = entries;
      }
  }

  double RotationVectors::operator[](const int unknown) const
  {
    const DofNumbering &numbering = model.numbering;
    return rotations[numbering.rotations().with(unknown)]
      .vector[numbering.rotations().axis(unknown)];
  }

  double RotationVectors::largest() const
  {
    double angle = 0;
    for (const Rotation &rotation : rotations)
      angle = std::max(angle, rotation.vector.norm());
    return angle;
  }
} // namespace auxfem
