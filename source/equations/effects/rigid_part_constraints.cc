#include <auxfem/equations/effects/rigid_part_constraints.h>

#include <algorithm>

namespace auxfem
{
  RigidPartConstraints::RigidPartConstraints(
    const RigidBodies          &bodies,
    const Lattice              &lattice,
    const DofNumbering         &numbering,
    const bool                  large_rotation,
    const dealii::Tensor<1, 3> &gravity)
    : lattice(lattice)
    , numbering(numbering)
    , large_rotation(large_rotation)
  {
    const RigidPartSetting setting{lattice, numbering, large_rotation, gravity};
    if (!bodies.in_plane.empty())
      groups.push_back(make_natural_parts(bodies.in_plane, setting));
    if (!bodies.bars.empty())
      groups.push_back(make_natural_parts(bodies.bars, setting));
    if (!bodies.rotating.empty())
      groups.push_back(make_rotating_parts(bodies.rotating, setting));
    for (const auto &group : groups)
      for (unsigned int i = 0; i < group->n_reported(); ++i)
        reported.emplace_back(group.get(), i);
    std::sort(reported.begin(),
              reported.end(),
              [](const auto &one, const auto &other) {
                return one.first->part(one.second) <
                  other.first->part(other.second);
              });
  }

  bool RigidPartConstraints::is_linear() const
  {
    return !large_rotation;
  }

  void RigidPartConstraints::register_blocks(TangentPattern &pattern)
  {
    for (const auto &group : groups)
      group->register_blocks(pattern);
  }

  void RigidPartConstraints::add_residual(const Evaluation &evaluation,
                                          double           *residual,
                                          EffectResults * /*results*/) const
  {
    for (const auto &group : groups)
      group->add_residual(evaluation, residual, nullptr);
  }

  void RigidPartConstraints::add_tangent(const Evaluation &evaluation,
                                         const EffectResults * /*results*/,
                                         const TangentFactors &factors,
                                         TangentMatrix        &matrix) const
  {
    for (const auto &group : groups)
      group->add_tangent(evaluation, nullptr, factors, matrix);
  }

  void RigidPartConstraints::raise_forces(const Evaluation &evaluation,
                                          const EffectResults * /*results*/,
                                          double *forces) const
  {
    for (const auto &group : groups)
      group->raise_forces(evaluation, nullptr, forces);
  }

  void RigidPartConstraints::find_rates(const State &state, double *rates) const
  {
    for (const auto &group : groups)
      group->find_rates(state, rates);
  }

  double RigidPartConstraints::length() const
  {
    double result = 0;
    for (const auto &group : groups)
      result = std::max(result, group->length());
    return result;
  }

  unsigned int RigidPartConstraints::n_reported() const
  {
    return reported.size();
  }

  unsigned int RigidPartConstraints::part(const unsigned int i) const
  {
    return reported[i].first->part(reported[i].second);
  }

  SpaceVector RigidPartConstraints::rotation(const unsigned int i,
                                             const State       &state) const
  {
    return reported[i].first->rotation(reported[i].second, state);
  }

  PointMotion RigidPartConstraints::motion(const unsigned int      i,
                                           const dealii::Point<3> &point,
                                           const State            &state) const
  {
    return reported[i].first->motion(reported[i].second, point, state);
  }

  RigidPartReport RigidPartConstraints::report(const unsigned int i,
                                               const State       &state) const
  {
    return reported[i].first->report(reported[i].second, state);
  }
} // namespace auxfem
