#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/rotation_numbers.h>
#include <auxfem/output/rotation_vectors.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const std::string rotation_vectors_record = "history: rotation vectors";

    /** Further away (rad) a rotation vector would be a leap in the output. */
    constexpr double nearest_leap = 1;

    /**
     * The rotation vector nearest to @p expected. Where a body has turned
     * often about an axis that is now tilted, all of them are far away: what is
     * expected stands, which counts the turns.
     */
    SpaceVector followed(const Quaternion  &rotation,
                         const SpaceVector &expected)
    {
      const SpaceVector nearest = rotation_vector_near(rotation, expected);
      return (nearest - expected).norm() < nearest_leap ? nearest : expected;
    }
  } // namespace

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
          vector = followed(state.rotations[i],
                            vector +
                              rotated(state.rotations[i],
                                      entries - rotations[i].entries));
        rotations[i].entries = entries;
      }
  }

  void RotationVectors::save(Records &records) const
  {
    std::vector<double> vectors;
    for (const Rotation &rotation : rotations)
      vectors.insert(vectors.end(),
                     rotation.vector.begin_raw(),
                     rotation.vector.end_raw());
    records.keep(rotation_vectors_record,
                 rotation_numbers(model.lattice, model.numbering),
                 3,
                 vectors);
  }

  void RotationVectors::resume(const State &state, const Records &records)
  {
    const std::vector<double> vectors =
      records.values(rotation_vectors_record,
                     rotation_numbers(model.lattice, model.numbering),
                     3);
    for (unsigned int i = 0; i < rotations.size(); ++i)
      {
        for (unsigned int c = 0; c < 3; ++c)
          rotations[i].vector[c] = vectors[3 * i + c];
        rotations[i].entries =
          NodeRotations(model.numbering).values(state.displacement, i);
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
