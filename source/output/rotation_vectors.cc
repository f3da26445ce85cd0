#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/rotation_numbers.h>
#include <auxfem/output/rotation_vectors.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
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

    /** Where the one with @p index is, or would be inserted. */
    template <class Rotations>
    auto find_rotation(Rotations &rotations, const unsigned int index)
    {
      return std::lower_bound(rotations.begin(),
                              rotations.end(),
                              index,
                              [](const auto &rotation, const unsigned int i) {
                                return rotation.index < i;
                              });
    }
  } // namespace

  RotationVectors::RotationVectors(const LatticeModel &model) : model(model)
  {}

  void RotationVectors::choose(const int unknown)
  {
    const unsigned int index = model.numbering.rotations().with(unknown);
    const auto         next  = find_rotation(rotations, index);
    if (next == rotations.end() || next->index != index)
      rotations.insert(next, {index, {}, {}});
  }

  void RotationVectors::follow(const State &state)
  {
    const NodeRotations of_nodes(model.numbering);
    for (Rotation &rotation : rotations)
      {
        const SpaceVector entries =
          of_nodes.values(state.displacement, rotation.index);
        if (state.rotations.empty())
          rotation.vector = entries;
        else
          {
            const Quaternion &now = state.rotations[rotation.index];
            rotation.vector =
              followed(now,
                       rotation.vector +
                         rotated(now, entries - rotation.entries));
          }
        rotation.entries = entries;
      }
  }

  std::vector<unsigned int> RotationVectors::numbers() const
  {
    const std::vector<unsigned int> of_all =
      rotation_numbers(model.lattice, model.numbering);
    std::vector<unsigned int> chosen;
    for (const Rotation &rotation : rotations)
      chosen.push_back(of_all[rotation.index]);
    return chosen;
  }

  void RotationVectors::serialize(const State       &state,
                                  CheckpointArchive &archive)
  {
    std::vector<double> vectors;
    for (const Rotation &rotation : rotations)
      vectors.insert(vectors.end(),
                     rotation.vector.begin_raw(),
                     rotation.vector.end_raw());
    archive.items("output: rotation vectors", numbers(), 3, vectors);
    for (unsigned int i = 0; i < rotations.size(); ++i)
      {
        std::copy_n(vectors.begin() + 3 * i,
                    3,
                    rotations[i].vector.begin_raw());
        rotations[i].entries =
          NodeRotations(model.numbering)
            .values(state.displacement, rotations[i].index);
      }
  }

  double RotationVectors::operator[](const int unknown) const
  {
    const SpatialRotations &all   = model.numbering.rotations();
    const unsigned int      index = all.with(unknown);
    const auto              found = find_rotation(rotations, index);
    Assert(found != rotations.end() && found->index == index,
           dealii::ExcMessage("the rotation was not chosen"));
    return found->vector[all.axis(unknown)];
  }

  double RotationVectors::largest() const
  {
    double angle = 0;
    for (const Rotation &rotation : rotations)
      angle = std::max(angle, rotation.vector.norm());
    return angle;
  }
} // namespace auxfem
