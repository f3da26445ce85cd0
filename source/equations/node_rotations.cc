#include <auxfem/equations/node_rotations.h>
#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/parameters/numerical_limits.h>

namespace auxfem
{
  NodeRotations::NodeRotations(const DofNumbering &numbering)
    : numbering(numbering)
  {}

  void NodeRotations::follow(const Evaluation &evaluation) const
  {
    for (unsigned int i = 0; i < evaluation.to.rotations.size(); ++i)
      evaluation.to.rotations[i] =
        normalized(evaluation.from.rotations[i] *
                   exponential(material_increment(evaluation, i)));
  }

  void NodeRotations::rotate(const Evaluation &evaluation,
                             Vector           &increment) const
  {
    // For a tiny spin the difference of two rotation vectors loses all digits,
    // which division by dt^2 would amplify; the quadratic terms are round-off.
    for (unsigned int i = 0; i < evaluation.to.rotations.size(); ++i)
      {
        const SpaceVector spin     = values(increment, i);
        Quaternion       &rotation = evaluation.to.rotations[i];
        const SpaceVector before   = material_increment(evaluation, i),
                          material = rotated(conjugate(rotation), spin);
        rotation                   = normalized(exponential(spin) * rotation);
        set_values(spin.norm() < sqrt_round_off
                     ? inverse_tangent_operator(before) * material
                     : rotation_vector_near(
                         conjugate(evaluation.from.rotations[i]) * rotation,
                         before + material) -
                       before,
                   i,
                   increment);
      }
  }

  void NodeRotations::make_material(const State &state, Vector &vector) const
  {
    for (unsigned int i = 0; i < state.rotations.size(); ++i)
      set_values(rotated(conjugate(state.rotations[i]), values(vector, i)),
                 i,
                 vector);
  }

  SpaceVector NodeRotations::spatial_increment(const Evaluation  &evaluation,
                                               const unsigned int i) const
  {
    return rotated(evaluation.from.rotations[i],
                   material_increment(evaluation, i));
  }

  double NodeRotations::spatial_rate(const State &state,
                                     const int    unknown) const
  {
    const int i = numbering.rotations().with(unknown);
    if (i < 0 || state.rotations.empty())
      return (*state.velocity)[unknown];
    return rotated(state.rotations[i],
                   values(*state.velocity,
                          i))[numbering.rotations().axis(unknown)];
  }

  SpaceVector NodeRotations::material_increment(const Evaluation  &evaluation,
                                                const unsigned int i) const
  {
    return values(evaluation.to.displacement, i) -
      values(evaluation.from.displacement, i);
  }

  void NodeRotations::set_material_increment(const Evaluation  &evaluation,
                                             const unsigned int i,
                                             const SpaceVector &increment) const
  {
    set_values(values(evaluation.from.displacement, i) + increment,
               i,
               evaluation.to.displacement);
  }

  SpaceTensor NodeRotations::increment_by_spin(const Evaluation  &evaluation,
                                               const unsigned int i) const
  {
    if (evaluation.kind == Evaluation::Kind::discrete_gradient)
      return transpose(rotated(evaluation.to.rotations[i],
                               transpose(cayley_spin_derivative(cayley_rotation(
                                 material_increment(evaluation, i))))));
    // T^-1 P^T is the transpose of P T^-T.
    return transpose(rotated(evaluation.to.rotations[i],
                             transpose(inverse_tangent_operator(
                               material_increment(evaluation, i)))));
  }

  SpaceVector NodeRotations::values(const Vector      &vector,
                                    const unsigned int i) const
  {
    return vector_at(vector.data(), numbering.rotations()[i].data());
  }

  void NodeRotations::set_values(const SpaceVector &values,
                                 const unsigned int i,
                                 Vector            &vector) const
  {
    const std::array<int, 3> &spins = numbering.rotations()[i];
    for (unsigned int c = 0; c < 3; ++c)
      vector[spins[c]] = values[c];
  }

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
