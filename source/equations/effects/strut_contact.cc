#include <auxfem/equations/effects/strut_contact.h>

#include <set>
#include <sstream>

namespace auxfem
{
  StrutContact::StrutContact(const Scene &scene, const LatticeModel &model)
    : ContactEffect(scene, model)
    , curves(model, axes)
    , points_of_axes(curves, dimension)
    , proximity(model, curves)
  {}

  std::vector<int> StrutContact::unknowns_of(const AxisPair &pair) const
  {
    std::vector<int> unknowns = axes[pair[0]].unknowns;
    if (pair[1] != pair[0])
      unknowns.insert(unknowns.end(),
                      axes[pair[1]].unknowns.begin(),
                      axes[pair[1]].unknowns.end());
    return unknowns;
  }

  void StrutContact::register_in(StateLayout &layout)
  {
    ContactEffect::register_in(layout);
    numerical_entry =
      layout.acceleration ? layout.energies.enter(numerical_energy_entry()) : 0;
  }

  const std::vector<double> &
  StrutContact::of_all_ranks(const Vector        &values,
                             std::vector<double> &room) const
  {
    const UnknownLayout &layout = model.numbering.layout();
    if (layout.n_ranks() == 1)
      return values;
    std::vector<int> counts, firsts;
    for (unsigned int rank = 0; rank < layout.n_ranks(); ++rank)
      {
        firsts.push_back(layout.first_of(rank));
        counts.push_back(layout.first_of(rank + 1) - layout.first_of(rank));
      }
    room.resize(layout.n_global());
    MPI_Allgatherv(values.data(),
                   layout.n_owned(),
                   MPI_DOUBLE,
                   room.data(),
                   counts.data(),
                   firsts.data(),
                   MPI_DOUBLE,
                   layout.communicator());
    return room;
  }

  bool StrutContact::update_couplings(const State      &accepted,
                                      std::vector<int> &wanted)
  {
    std::vector<double> room;
    if (!proximity.follow(of_all_ranks(accepted.displacement, room)))
      return false;
    want_unknowns(wanted);
    return true;
  }

  void StrutContact::save(Records &records) const
  {
    proximity.save(records);
  }

  bool StrutContact::resume(const Records &records, std::vector<int> &wanted)
  {
    proximity.resume(records);
    want_unknowns(wanted);
    return true;
  }

  void StrutContact::register_blocks(TangentPattern &pattern)
  {
    ContactEffect::register_blocks(pattern);
    std::vector<AxisPair> pairs;
    local_unknowns.clear();
    for (const Coupled &of_pair : coupled)
      {
        pairs.push_back(of_pair.pair);
        auto first = of_pair.unknowns.begin();
        for (const unsigned int axis : of_pair.pair)
          {
            if (first == of_pair.unknowns.end())
              break; // An axis with itself.
            const auto end = first + axes[axis].unknowns.size();
            local_unknowns.try_emplace(axis, first, end);
            first = end;
          }
      }
    facing = points_of_axes.facing_struts(pairs);
  }

  NearCurves StrutContact::curves_at(const State &state) const
  {
    NearCurves now;
    for (const auto &[axis, unknowns] : local_unknowns)
      now.emplace(axis,
                  curves.curve(axis,
                               unknowns.data(),
                               state.displacement.data()));
    return now;
  }

  ContactLaw StrutContact::law_at(const StrutTouch &touch) const
  {
    const double one   = axes[touch.axis].stiffness,
                 other = axes[touch.other].stiffness;
    // The points of the other strut do the other half.
    return {touch.weight / 2 * one * other / (one + other),
            parameters.smoothing * curves.thickness(touch.axis, touch.other)};
  }

  Penetration StrutContact::penetration(const StrutTouch &touch) const
  {
    return {touch.depth / curves.thickness(touch.axis, touch.other),
            axes[touch.axis].strut,
            axes[touch.other].strut};
  }

  void StrutContact::touch(const FacingStrut       &of_axis,
                           const NearCurves        &now,
                           const Evaluation        &evaluation,
                           std::vector<StrutTouch> &points) const
  {
    for (const auto &[i, found] : points_of_axes.touching(of_axis, now))
      {
        const SpaceVector point =
          now.at(of_axis.axis).at(points_of_axes.parameter(of_axis.axis, i));
        StrutTouch       touch = touch_of(of_axis, found, i);
        const ContactLaw law   = law_at(touch);
        touch.force            = law.force(touch.depth);
        touch.slope            = law.slope(touch.depth);
        const SpaceVector away =
          point - now.at(touch.other).at(found.point.parameter);
        const SpaceVector normal = away / found.point.distance;
        touch.opposites          = {
                   {found.point.parameter, normal, normal, found.point.distance}};
        if (friction.coefficient > 0 &&
            evaluation.kind != Evaluation::Kind::equilibrium)
          rub(evaluation, touch);
        points.push_back(touch);
      }
  }

  StrutTouch StrutContact::touch_of(const FacingStrut    &of_axis,
                                    const NearestOfStrut &found,
                                    const unsigned int    point) const
  {
    const unsigned int axis = of_axis.axis, other = found.target.axis;
    const double depth = curves.thickness(axis, other) - found.point.distance;
    return {{found.target.pair, axis, depth},
            other,
            points_of_axes.parameter(axis, point),
            points_of_axes.weight(axis, point),
            found.point.distance,
            found.point.is_inside};
  }

  void StrutContact::touch_between(const FacingStrut       &of_axis,
                                   const NearCurves        &before,
                                   const NearCurves        &now,
                                   const Evaluation        &step,
                                   std::vector<StrutTouch> &points) const
  {
    std::set<unsigned int> touching;
    for (const NearCurves *const curves_then : {&before, &now})
      for (const TouchingPoint &point :
           points_of_axes.touching(of_axis, *curves_then))
        touching.insert(point.point);
    for (const unsigned int i : touching)
      {
        const double      at       = points_of_axes.parameter(of_axis.axis, i);
        const SpaceVector from     = before.at(of_axis.axis).at(at),
                          to       = now.at(of_axis.axis).at(at);
        const NearestOfStrut first = points_of_axes.nearest(of_axis,
                                                            before,
                                                            from,
                                                            at),
                             last =
                               points_of_axes.nearest(of_axis, now, to, at);
        StrutTouch       touch = touch_of(of_axis, last, i);
        const ContactLaw law   = law_at(touch);
        const double     depth_before =
          curves.thickness(touch.axis, touch.other) - first.point.distance;
        touch.force   = law.mean_force(depth_before, touch.depth);
        touch.slope   = law.mean_slope(depth_before, touch.depth);
        double gained = 0;
        for (const NearestOfStrut &nearest : {first, last})
          {
            // The nearest points of both states may lie on two elements: then
            // that of the end stands for both.
            const double      parameter = nearest.target.axis == touch.other
                   ? nearest.point.parameter
                   : last.point.parameter;
            const SpaceVector q0 = from - before.at(touch.other).at(parameter),
                              q1 = to - now.at(touch.other).at(parameter);
            const double sum     = q0.norm() + q1.norm();
            touch.opposites.push_back(
              {parameter, (q0 + q1) / sum, q1 / q1.norm(), sum});
            gained += (q1.norm() - q0.norm()) / 2;
          }
        touch.missed = -touch.force *
          (gained - (last.point.distance - first.point.distance));
        if (friction.coefficient > 0)
          rub(step, touch);
        points.push_back(touch);
      }
  }

  StrutTouchMotion StrutContact::motion_of(const StrutTouch &touch) const
  {
    const Coupled &of_pair = coupled[touch.pair];
    return {curves, dimension, touch, of_pair.pair, of_pair.unknowns};
  }

  void StrutContact::rub(const Evaluation &evaluation, StrutTouch &touch) const
  {
    touch.friction =
      friction.force(sliding_velocity(evaluation,
                                      [&](const Vector &u) {
                                        return difference(touch, u);
                                      }),
                     touch.opposites.back().normal,
                     touch.force);
  }

  std::vector<StrutTouch>
  StrutContact::touching(const Evaluation &evaluation) const
  {
    std::vector<StrutTouch> points;
    if (facing.empty())
      return points;
    const NearCurves now = curves_at(evaluation.to);
    if (evaluation.kind == Evaluation::Kind::between)
      {
        const NearCurves before = curves_at(evaluation.from);
        for (const FacingStrut &of_axis : facing)
          touch_between(of_axis, before, now, evaluation, points);
      }
    else
      for (const FacingStrut &of_axis : facing)
        touch(of_axis, now, evaluation, points);
    return points;
  }

  void StrutContact::add_residual(const Evaluation &evaluation,
                                  double           *residual,
                                  EffectResults    *results) const
  {
    auto &points = static_cast<Results &>(*results).points;
    points       = touching(evaluation);
    for (const StrutTouch &touch : points)
      {
        const StrutTouchMotion motion = motion_of(touch);
        for (const StrutTouch::Opposite &opposite : touch.opposites)
          motion.add_force(opposite.parameter,
                           -touch.force / touch.opposites.size() *
                             opposite.direction,
                           residual);
        if (touch.friction.scale > 0)
          motion.add_force(touch.opposites.back().parameter,
                           -touch.friction.force,
                           residual);
      }
  }

  void StrutContact::account_step(const Evaluation    &step,
                                  const EffectResults *results,
                                  EnergyAccount       &account) const
  {
    ContactEffect::account_step(step, results, account);
    if (step.kind == Evaluation::Kind::between && account.takes_time())
      for (const StrutTouch &touch : points_of(results))
        if (is_owned(touch))
          account.add_in_step(numerical_entry, touch.missed);
  }

  void StrutContact::raise_forces(const Evaluation & /*evaluation*/,
                                  const EffectResults *results,
                                  double              *forces) const
  {
    for (const StrutTouch &touch : points_of(results))
      for (const int unknown : coupled[touch.pair].unknowns)
        raise(forces, unknown, touch.force);
  }

  void StrutContact::raise_uncertain_forces(const Evaluation & /*evaluation*/,
                                            const EffectResults *results,
                                            const double largest_displacement,
                                            const double /*largest_rotation*/,
                                            double *forces) const
  {
    for (const StrutTouch &touch : points_of(results))
      for (const int unknown : coupled[touch.pair].unknowns)
        raise(forces,
              unknown,
              touch.force + touch.slope * largest_displacement);
  }

  std::optional<std::array<unsigned int, 2>>
  StrutContact::first_too_near(const State &from,
                               const State &to,
                               const double allowed) const
  {
    std::vector<double> before, after;
    const auto          found =
      proximity.first_too_near(of_all_ranks(from.displacement, before),
                               of_all_ranks(to.displacement, after),
                               allowed);
    if (!found)
      return {};
    return {{{axes[(*found)[0]].strut, axes[(*found)[1]].strut}}};
  }

  std::optional<std::array<unsigned int, 2>>
  StrutContact::first_to_touch(const State &from, const State &to) const
  {
    return first_too_near(from, to, /*allowed=*/0);
  }

  std::string StrutContact::why_not_acceptable(const Evaluation &step) const
  {
    const auto found =
      first_too_near(step.from, step.to, parameters.largest_penetration);
    if (!found)
      return "";
    std::ostringstream why;
    why << "strut " << (*found)[0] << " and strut " << (*found)[1]
        << " would go into each other deeper than Contact/Largest penetration "
           "allows";
    return why.str();
  }

  std::vector<StrutContactReport>
  StrutContact::contacts(const EffectResults &results, const State &state) const
  {
    std::vector<StrutContactReport> all;
    for (const StrutTouch &touch : points_of(&results))
      {
        if (!is_owned(touch) || touch.depth <= 0)
          continue;
        SpaceVector force = touch.friction.force;
        for (const StrutTouch::Opposite &opposite : touch.opposites)
          force += touch.force / touch.opposites.size() * opposite.direction;
        const SpaceVector now = curves
                                  .curve(touch.axis,
                                         local_unknowns.at(touch.axis).data(),
                                         state.displacement.data())
                                  .at(touch.parameter);
        const SpaceVector rest = curves.at_rest(touch.axis).at(touch.parameter);
        all.push_back(
          {axes[touch.axis].strut,
           axes[touch.other].strut,
           dealii::Point<3>(rest),
           now - rest,
           axes[touch.axis].half_thickness * touch.opposites.back().normal,
           force,
           touch.depth});
      }
    return all;
  }
} // namespace auxfem
