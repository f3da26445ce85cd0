#include <auxfem/equations/effects/strut_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using SpaceTensor1 = dealii::Tensor<1, 3>;

    /** Largest number of nodes of an axis. */
    constexpr unsigned int max_nodes = 16;

    /** Adds @p factor times the product of two vectors to a square block. */
    void add_product(const double               factor,
                     const std::vector<double> &rows,
                     const std::vector<double> &columns,
                     std::vector<double>       &block)
    {
      const std::size_t n = rows.size();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          block[i * n + j] += factor * rows[i] * columns[j];
    }

    SpaceTensor1 unit(const unsigned int direction)
    {
      SpaceTensor1 result;
      result[direction] = 1;
      return result;
    }
  } // namespace

  StrutContact::StrutContact(const Scene &scene, const LatticeModel &model)
    : model(model)
    , parameters(scene.contact)
    , friction{scene.contact.friction, scene.contact.slip_velocity}
    , dimension(model.lattice.dimension)
    , axes(make_contact_axes(model, scene.contact.stiffness))
    , curves(model, axes)
    , proximity(model, curves)
  {
    for (const ContactAxis &axis : axes)
      thickest = std::max(thickest, axis.half_thickness);
  }

  bool StrutContact::is_linear() const
  {
    return false;
  }

  void StrutContact::register_in(StateLayout &layout)
  {
    contact_entry = layout.energies.enter(contact_energy_entry());
    numerical_entry =
      layout.acceleration ? layout.energies.enter(numerical_energy_entry()) : 0;
    if (friction.coefficient > 0)
      friction_account.register_in(layout);
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

  bool StrutContact::takes_part(const AxisPair &pair) const
  {
    const UnknownLayout &layout = model.numbering.layout();
    for (const unsigned int axis : pair)
      for (const int global : axes[axis].unknowns)
        if (layout.is_owned(layout.local(global)))
          return true;
    return false;
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

  void StrutContact::want_unknowns(std::vector<int> &wanted) const
  {
    for (const AxisPair &pair : proximity.near())
      if (takes_part(pair))
        for (const unsigned int axis : pair)
          wanted.insert(wanted.end(),
                        axes[axis].unknowns.begin(),
                        axes[axis].unknowns.end());
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
    const UnknownLayout &layout = pattern.unknowns().layout;
    coupled.clear();
    local_unknowns.clear();
    for (const AxisPair &pair : proximity.near())
      {
        if (!takes_part(pair))
          continue;
        Coupled of_pair{pair, {}};
        for (const unsigned int axis : pair)
          {
            std::vector<int> &locals = local_unknowns[axis];
            if (locals.empty())
              for (const int global : axes[axis].unknowns)
                locals.push_back(layout.local(global));
            if (axis != pair[0] || of_pair.unknowns.empty())
              of_pair.unknowns.insert(of_pair.unknowns.end(),
                                      locals.begin(),
                                      locals.end());
          }
        const std::size_t block =
          pattern.register_block(of_pair.unknowns.data(),
                                 of_pair.unknowns.size());
        if (coupled.empty())
          first_block = block;
        coupled.push_back(std::move(of_pair));
      }
    find_facing();
  }

  void StrutContact::find_facing()
  {
    std::map<AxisPair, Facing> by_axis_and_strut;
    const auto                 add = [&](const unsigned int axis,
                         const unsigned int other,
                         const unsigned int pair) {
      const unsigned int strut = axes[other].strut;
      Facing            &facing = by_axis_and_strut[{{axis, strut}}];
      facing.axis               = axis;
      facing.strut              = strut;
      facing.targets.push_back({other, pair});
    };
    for (unsigned int i = 0; i < coupled.size(); ++i)
      {
        add(coupled[i].axes[0], coupled[i].axes[1], i);
        if (coupled[i].axes[0] != coupled[i].axes[1])
          add(coupled[i].axes[1], coupled[i].axes[0], i);
      }
    facing.clear();
    for (auto &[key, of_axis] : by_axis_and_strut)
      facing.push_back(std::move(of_axis));
  }

  std::unique_ptr<EffectResults> StrutContact::make_results() const
  {
    return std::make_unique<StrutContactResults>();
  }

  StrutContact::Curves StrutContact::curves_at(const State &state) const
  {
    Curves now;
    for (const auto &[axis, unknowns] : local_unknowns)
      now.emplace(axis,
                  curves.curve(axis,
                               unknowns.data(),
                               state.displacement.data()));
    return now;
  }

  double StrutContact::scale_of(const unsigned int axis,
                                const unsigned int other) const
  {
    return curves.thickness(axis, other);
  }

  double StrutContact::distance(const StrutTouch &touch) const
  {
    return curves.thickness(touch.axis, touch.other) - touch.depth;
  }

  unsigned int StrutContact::n_points(const unsigned int axis) const
  {
    // Crossing struts in space touch along less than their thickness.
    constexpr double       spacing_in_plane = 1, spacing_in_space = 0.25;
    constexpr unsigned int most = 10000;
    const double           h =
      axes[axis].half_thickness > 0 ? axes[axis].half_thickness : thickest;
    const double n =
      std::ceil(axes[axis].length /
                (h * (dimension == 2 ? spacing_in_plane : spacing_in_space)));
    return 1 + std::clamp<double>(n, 4, most);
  }

  double StrutContact::parameter(const unsigned int axis,
                                 const unsigned int point) const
  {
    return double(point) / (n_points(axis) - 1);
  }

  double StrutContact::weight(const unsigned int a,
                              const unsigned int point) const
  {
    const ContactAxis &axis = axes[a];
    const unsigned int n    = n_points(a);
    if (point > 0 && point + 1 < n)
      return axis.length / (n - 1);
    const bool is_end_of_strut = point == 0 ? axis.begin == 0 : axis.end == 1;
    return axis.length / (2 * (n - 1)) +
      (is_end_of_strut ? axis.half_thickness : 0.);
  }

  ContactLaw StrutContact::law(const unsigned int axis,
                               const unsigned int other,
                               const double       weight) const
  {
    const double one = axes[axis].stiffness, two = axes[other].stiffness;
    // The points of the other strut do the other half.
    return {weight / 2 * one * two / (one + two),
            parameters.smoothing * scale_of(axis, other)};
  }

  StrutContact::Nearest StrutContact::nearest(const Facing      &of_axis,
                                              const Curves      &now,
                                              const SpaceVector &point,
                                              const double parameter) const
  {
    Nearest result{{0, 0}, {0, std::numeric_limits<double>::infinity(), false}};
    const auto look = [&](const Facing::Target        &target,
                          const std::array<double, 2> &part) {
      const NearestPoint found =
        nearest_point(now.at(target.axis), point, part[0], part[1]);
      if (found.distance < result.point.distance)
        result = {target, found};
    };
    for (const Facing::Target &target : of_axis.targets)
      if (axes[of_axis.axis].strut == of_axis.strut)
        for (const auto &part :
             curves.parts_apart(of_axis.axis, parameter, target.axis))
          look(target, part);
      else
        look(target, {{0., 1.}});
    return result;
  }

  void StrutContact::find_touching(const Facing              &of_axis,
                                   const Curves              &now,
                                   const unsigned int         begin,
                                   const unsigned int         end,
                                   std::vector<unsigned int> &points) const
  {
    // Distances change by no more than the way along the axis, here with 10 %
    // of stretch.
    constexpr double   stretch = 1.1;
    const unsigned int middle  = (begin + end) / 2;
    const double       at      = parameter(of_axis.axis, middle);
    const double       left =
      nearest(of_axis, now, now.at(of_axis.axis).at(at), at).point.distance -
      curves.thickness(of_axis.axis, of_axis.targets.front().axis);
    if (left < 0)
      points.push_back(middle);
    const double spacing =
      stretch * axes[of_axis.axis].length / (n_points(of_axis.axis) - 1);
    const auto skipped =
      static_cast<unsigned int>(std::min(std::max(left, 0.) / spacing, 1e6));
    if (middle > begin + skipped)
      find_touching(of_axis, now, begin, middle - 1 - skipped, points);
    if (middle + skipped < end)
      find_touching(of_axis, now, middle + 1 + skipped, end, points);
  }

  void StrutContact::touch(const Facing            &of_axis,
                           const Curves            &now,
                           const Evaluation        &evaluation,
                           std::vector<StrutTouch> &points) const
  {
    for (const unsigned int i : touching_points(of_axis, now))
      {
        const double      at    = parameter(of_axis.axis, i);
        const SpaceVector point = now.at(of_axis.axis).at(at);
        const Nearest     found = nearest(of_axis, now, point, at);
        StrutTouch        touch = touch_of(of_axis, found, i);
        const ContactLaw law = this->law(touch.axis, touch.other, touch.weight);
        touch.force          = law.force(touch.depth);
        touch.slope          = law.slope(touch.depth);
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

  std::vector<unsigned int>
  StrutContact::touching_points(const Facing &of_axis, const Curves &now) const
  {
    std::vector<unsigned int> points;
    const unsigned int        last = n_points(of_axis.axis) - 1;
    for (const auto &range :
         curves.free_ranges(of_axis.axis, of_axis.targets.front().axis))
      {
        const auto begin = static_cast<unsigned int>(
                     std::ceil(range[0] * last - 1e-9)),
                   end = static_cast<unsigned int>(
                     std::floor(range[1] * last + 1e-9));
        if (begin <= end)
          find_touching(of_axis, now, begin, end, points);
      }
    std::sort(points.begin(), points.end());
    return points;
  }

  StrutTouch StrutContact::touch_of(const Facing      &of_axis,
                                    const Nearest     &found,
                                    const unsigned int point) const
  {
    StrutTouch touch{found.target.pair,
                     of_axis.axis,
                     found.target.axis,
                     parameter(of_axis.axis, point),
                     weight(of_axis.axis, point),
                     curves.thickness(of_axis.axis, found.target.axis) -
                       found.point.distance,
                     0,
                     0,
                     {},
                     found.point.is_inside};
    return touch;
  }

  void StrutContact::touch_between(const Facing            &of_axis,
                                   const Curves            &before,
                                   const Curves            &now,
                                   const Evaluation        &step,
                                   std::vector<StrutTouch> &points) const
  {
    std::vector<unsigned int>       touching = touching_points(of_axis, now);
    const std::vector<unsigned int> at_start = touching_points(of_axis, before);
    touching.insert(touching.end(), at_start.begin(), at_start.end());
    std::sort(touching.begin(), touching.end());
    touching.erase(std::unique(touching.begin(), touching.end()),
                   touching.end());
    for (const unsigned int i : touching)
      {
        const double      at   = parameter(of_axis.axis, i);
        const SpaceVector from = before.at(of_axis.axis).at(at),
                          to   = now.at(of_axis.axis).at(at);
        const Nearest first    = nearest(of_axis, before, from, at),
                      last     = nearest(of_axis, now, to, at);
        StrutTouch       touch = touch_of(of_axis, last, i);
        const ContactLaw law = this->law(touch.axis, touch.other, touch.weight);
        const double     depth_before =
          curves.thickness(touch.axis, touch.other) - first.point.distance;
        touch.force   = law.mean_force(depth_before, touch.depth);
        touch.slope   = law.mean_slope(depth_before, touch.depth);
        double gained = 0;
        for (const Nearest &nearest : {first, last})
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

  StrutContact::SpaceVector StrutContact::difference(const StrutTouch &touch,
                                                     const Vector &values) const
  {
    SpaceVector             result;
    const std::vector<int> &unknowns = coupled[touch.pair].unknowns;
    for_each_share(touch,
                   touch.opposites.back().parameter,
                   [&](const unsigned int first, const double share) {
                     for (unsigned int c = 0; c < dimension; ++c)
                       result[c] += share * values[unknowns[first + c]];
                   });
    return result;
  }

  template <class Add>
  void StrutContact::for_each_share(const StrutTouch &touch,
                                    const double      opposite,
                                    const Add        &add) const
  {
    double             values[max_nodes];
    const unsigned int of_first =
      axes[coupled[touch.pair].axes[0]].n_nodes() * dimension;
    const auto add_axis =
      [&](const unsigned int axis, const double parameter, const double sign) {
        curves.shape(axis, parameter, values);
        const unsigned int begin =
          axis == coupled[touch.pair].axes[0] ? 0 : of_first;
        for (unsigned int node = 0; node < axes[axis].n_nodes(); ++node)
          add(begin + node * dimension, sign * values[node]);
      };
    add_axis(touch.axis, touch.parameter, 1.);
    add_axis(touch.other, opposite, -1.);
  }

  std::vector<double> StrutContact::gradient(const StrutTouch  &touch,
                                             const double       opposite,
                                             const SpaceVector &vector) const
  {
    std::vector<double> result(coupled[touch.pair].unknowns.size(), 0.);
    for_each_share(touch,
                   opposite,
                   [&](const unsigned int first, const double share) {
                     for (unsigned int c = 0; c < dimension; ++c)
                       result[first + c] += share * vector[c];
                   });
    return result;
  }

  std::vector<double>
  StrutContact::tangent_gradient(const StrutTouch  &touch,
                                 const double       opposite,
                                 const SpaceVector &vector) const
  {
    std::vector<double> result(coupled[touch.pair].unknowns.size(), 0.);
    double              values[max_nodes], slopes[max_nodes];
    curves.shape(touch.other, opposite, values, slopes);
    const unsigned int begin = touch.other == coupled[touch.pair].axes[0]
      ? 0
      : axes[coupled[touch.pair].axes[0]].n_nodes() * dimension;
    for (unsigned int node = 0; node < axes[touch.other].n_nodes(); ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        result[begin + node * dimension + c] += slopes[node] * vector[c];
    return result;
  }

  StrutContact::SpaceVector
  StrutContact::difference_slope(const StrutTouch &touch,
                                 const Vector     &values) const
  {
    double shapes[max_nodes], slopes[max_nodes];
    curves.shape(touch.other, touch.opposites.back().parameter, shapes, slopes);
    const std::vector<int> &unknowns = local_unknowns.at(touch.other);
    SpaceVector             result;
    for (unsigned int node = 0; node < axes[touch.other].n_nodes(); ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        result[c] -= slopes[node] * values[unknowns[node * dimension + c]];
    return result;
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

  void StrutContact::add_residual(const Evaluation &evaluation,
                                  double           *residual,
                                  EffectResults    *results) const
  {
    auto &points = static_cast<StrutContactResults &>(*results).points;
    points.clear();
    if (facing.empty())
      return;
    const Curves now = curves_at(evaluation.to);
    if (evaluation.kind == Evaluation::Kind::between)
      {
        const Curves before = curves_at(evaluation.from);
        for (const Facing &of_axis : facing)
          touch_between(of_axis, before, now, evaluation, points);
      }
    else
      for (const Facing &of_axis : facing)
        touch(of_axis, now, evaluation, points);
    for (const StrutTouch &touch : points)
      {
        const std::vector<int> &unknowns = coupled[touch.pair].unknowns;
        const auto              subtract = [&](const double       opposite,
                                  const SpaceVector &force) {
          for_each_share(touch,
                         opposite,
                         [&](const unsigned int first, const double share) {
                           for (unsigned int c = 0; c < dimension; ++c)
                             residual[unknowns[first + c]] -= share * force[c];
                         });
        };
        for (const StrutTouch::Opposite &opposite : touch.opposites)
          subtract(opposite.parameter,
                   touch.force / touch.opposites.size() * opposite.direction);
        if (touch.friction.scale > 0)
          subtract(touch.opposites.back().parameter, touch.friction.force);
      }
  }

  void StrutContact::add_instant_block(const StrutTouch    &touch,
                                       const AxisCurve     &other,
                                       const double         by_position,
                                       std::vector<double> &block) const
  {
    const StrutTouch::Opposite &opposite = touch.opposites.back();
    const SpaceVector          &n        = opposite.normal;
    const double at = opposite.parameter, distance = opposite.length;
    const std::vector<double> of_normal = gradient(touch, at, n);
    add_product(by_position * (touch.slope + touch.force / distance),
                of_normal,
                of_normal,
                block);
    for (unsigned int c = 0; c < dimension; ++c)
      {
        const std::vector<double> along = gradient(touch, at, unit(c));
        add_product(-by_position * touch.force / distance, along, along, block);
      }
    if (!touch.is_inside)
      return;
    // The nearest point moves along the other axis.
    const std::vector<double> moving  = nearest_change(touch, other);
    const SpaceVector         tangent = other.tangent(at);
    add_product(by_position * touch.force *
                  (tangent * tangent / distance - n * other.bend(at)),
                moving,
                moving,
                block);
  }

  void StrutContact::add_mean_block(const StrutTouch    &touch,
                                    std::vector<double> &block) const
  {
    const StrutTouch::Opposite &last = touch.opposites.back();
    const std::vector<double>   of_depth =
      gradient(touch, last.parameter, last.normal);
    const double part = 1. / touch.opposites.size();
    for (const StrutTouch::Opposite &opposite : touch.opposites)
      {
        const std::vector<double> of_direction =
          gradient(touch, opposite.parameter, opposite.direction);
        add_product(part * touch.slope, of_direction, of_depth, block);
        const double turning = -part * touch.force / opposite.length;
        for (unsigned int c = 0; c < dimension; ++c)
          {
            const std::vector<double> along =
              gradient(touch, opposite.parameter, unit(c));
            add_product(turning, along, along, block);
          }
        add_product(-turning,
                    of_direction,
                    gradient(touch, opposite.parameter, opposite.normal),
                    block);
      }
  }

  std::vector<double> StrutContact::nearest_change(const StrutTouch &touch,
                                                   const AxisCurve &other) const
  {
    const StrutTouch::Opposite &last     = touch.opposites.back();
    const double                distance = this->distance(touch);
    const SpaceVector           tangent  = other.tangent(last.parameter);
    const double                growth =
      tangent * tangent / distance - last.normal * other.bend(last.parameter);
    std::vector<double> change =
      tangent_gradient(touch, last.parameter, last.normal);
    const std::vector<double> along = gradient(touch, last.parameter, tangent);
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] = (change[i] + along[i] / distance) / growth;
    return change;
  }

  void StrutContact::add_friction_block(const StrutTouch     &touch,
                                        const AxisCurve      &other,
                                        const Evaluation     &evaluation,
                                        const TangentFactors &factors,
                                        std::vector<double>  &block) const
  {
    const StrutTouch::Opposite &last   = touch.opposites.back();
    const SpaceVector          &n      = last.normal;
    const FrictionChange        change = friction.change(touch.friction, n);
    const auto                  across = change.by_normal / distance(touch);
    std::vector<double>         moving;
    SpaceVector                 by_moving;
    if (touch.is_inside)
      {
        moving    = nearest_change(touch, other);
        by_moving = factors.stiffness *
          (change.by_velocity *
             sliding_velocity(evaluation,
                              [&](const Vector &u) {
                                return difference_slope(touch, u);
                              }) -
           across * other.tangent(last.parameter));
        // The point that the force acts on moves too.
        add_product(factors.stiffness,
                    tangent_gradient(touch,
                                     last.parameter,
                                     touch.friction.force),
                    moving,
                    block);
      }
    for (unsigned int c = 0; c < dimension; ++c)
      {
        SpaceVector by_motion = factors.damping * change.by_velocity[c] +
          factors.stiffness *
            (across[c] - (across[c] * n) * n -
             touch.slope * change.by_pressure[c] * n);
        std::vector<double> of_force =
          gradient(touch, last.parameter, by_motion);
        for (std::size_t i = 0; i < moving.size(); ++i)
          of_force[i] += by_moving[c] * moving[i];
        add_product(1.,
                    gradient(touch, last.parameter, unit(c)),
                    of_force,
                    block);
      }
  }

  void StrutContact::add_tangent(const Evaluation     &evaluation,
                                 const EffectResults  *results,
                                 const TangentFactors &factors,
                                 TangentMatrix        &matrix) const
  {
    const auto &points =
      static_cast<const StrutContactResults &>(*results).points;
    if (points.empty() || (factors.stiffness == 0 && factors.damping == 0))
      return;
    const bool   is_between = evaluation.kind == Evaluation::Kind::between;
    const Curves now        = curves_at(evaluation.to);
    std::vector<double> block;
    for (const StrutTouch &touch : points)
      {
        const std::size_t n = coupled[touch.pair].unknowns.size();
        block.assign(n * n, 0.);
        if (is_between)
          add_mean_block(touch, block);
        else
          add_instant_block(touch,
                            now.at(touch.other),
                            factors.stiffness,
                            block);
        if (touch.friction.scale > 0)
          add_friction_block(touch,
                             now.at(touch.other),
                             evaluation,
                             is_between
                               ? TangentFactors{1., 1 / evaluation.dt, 0.}
                               : factors,
                             block);
        matrix.add(first_block + touch.pair, block.data());
      }
  }

  void StrutContact::account(const Evaluation & /*evaluation*/,
                             const EffectResults *results,
                             EnergyAccount       &account) const
  {
    for (const StrutTouch &touch :
         static_cast<const StrutContactResults &>(*results).points)
      if (is_owned(touch))
        account.add(
          contact_entry,
          law(touch.axis, touch.other, touch.weight).energy(touch.depth));
  }

  void StrutContact::account_step(const Evaluation    &step,
                                  const EffectResults *results,
                                  EnergyAccount       &account) const
  {
    if (!account.takes_time())
      return;
    const auto &points =
      static_cast<const StrutContactResults &>(*results).points;
    if (step.kind == Evaluation::Kind::between)
      for (const StrutTouch &touch : points)
        if (is_owned(touch))
          account.add_in_step(numerical_entry, touch.missed);
    if (friction.coefficient == 0)
      return;
    std::vector<StrutTouch> at_start;
    if (step.kind == Evaluation::Kind::step)
      {
        State            before  = step.from;
        const Evaluation instant = Evaluation::rates(step.from, before);
        const Curves     then    = curves_at(step.from);
        for (const Facing &of_axis : facing)
          touch(of_axis, then, instant, at_start);
      }
    friction_account.add_step(step,
                              sliding(points, step),
                              sliding(at_start, step),
                              account);
  }

  std::vector<Sliding>
  StrutContact::sliding(const std::vector<StrutTouch> &points,
                        const Evaluation              &step) const
  {
    std::vector<Sliding> result;
    for (const StrutTouch &touch : points)
      if (is_owned(touch))
        result.push_back({touch.friction,
                          difference(touch, step.to.displacement) -
                            difference(touch, step.from.displacement)});
    return result;
  }

  void StrutContact::account_stage(const Evaluation & /*stage*/,
                                   const EffectResults *results,
                                   EnergyAccount       &account) const
  {
    if (friction.coefficient == 0)
      return;
    for (const StrutTouch &touch :
         static_cast<const StrutContactResults &>(*results).points)
      if (is_owned(touch))
        friction_account.add_power(touch.friction, account);
  }

  void StrutContact::raise_forces(const Evaluation & /*evaluation*/,
                                  const EffectResults *results,
                                  double              *forces) const
  {
    for (const StrutTouch &touch :
         static_cast<const StrutContactResults &>(*results).points)
      for (const int unknown : coupled[touch.pair].unknowns)
        raise(forces, unknown, touch.force);
  }

  void StrutContact::raise_uncertain_forces(const Evaluation & /*evaluation*/,
                                            const EffectResults *results,
                                            const double largest_displacement,
                                            const double /*largest_rotation*/,
                                            double *forces) const
  {
    for (const StrutTouch &touch :
         static_cast<const StrutContactResults &>(*results).points)
      for (const int unknown : coupled[touch.pair].unknowns)
        raise(forces,
              unknown,
              touch.force + touch.slope * largest_displacement);
  }

  bool StrutContact::may_touch() const
  {
    return proximity.may_touch();
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
    for (const StrutTouch &touch :
         static_cast<const StrutContactResults &>(results).points)
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
           touch.depth,
           touch.depth / scale_of(touch.axis, touch.other)});
      }
    return all;
  }
} // namespace auxfem
