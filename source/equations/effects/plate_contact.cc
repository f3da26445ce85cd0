#include <auxfem/equations/effects/plate_contact.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using Vector3 = dealii::Tensor<1, 3>;
    using Tensor  = dealii::Tensor<2, 3>;

    const std::string near_record = "plates: struts near them";

    std::vector<int> local_numbers(const std::vector<int> &globals,
                                   const UnknownLayout    &layout)
    {
      std::vector<int> locals;
      for (const int global : globals)
        locals.push_back(layout.local(global));
      return locals;
    }
  } // namespace

  PlateContact::PlateContact(const Scene &scene, const LatticeModel &model)
    : model(model)
    , parameters(scene.contact)
    , friction{scene.contact.friction, scene.contact.slip_velocity}
    , step_length(model.simulated.inertia ? scene.time.step : 0.)
    , dimension(model.lattice.dimension)
    , axes(make_contact_axes(model, scene.contact.stiffness))
    , points_of_axes(make_contact_points(model.lattice, axes))
  {
    const UnknownLayout &layout = model.numbering.layout();
    for (unsigned int i = 0; i < scene.plates.size(); ++i)
      {
        const GlobalNumbers::OfMotion &of_joint =
          model.numbering.global().joints[model.lattice.joint_of_plate(i)];
        plates.push_back(
          {&scene.plates[i],
           std::vector<int>(of_joint.begin(), of_joint.begin() + dimension)});
      }
    for (const ContactAxis &axis : axes)
      {
        thickest = std::max(thickest, axis.half_thickness);
        owned_unknowns.push_back(axis.is_owned
                                   ? local_numbers(axis.unknowns, layout)
                                   : std::vector<int>());
      }
    for (const auto &unknowns : owned_unknowns)
      displacements.insert(displacements.end(),
                           unknowns.begin(),
                           unknowns.end());
    for (const Plate &plate : plates)
      for (const int global : plate.unknowns)
        if (const int unknown = layout.local(global); layout.is_owned(unknown))
          displacements.push_back(unknown);
    std::sort(displacements.begin(), displacements.end());
    displacements.erase(std::unique(displacements.begin(), displacements.end()),
                        displacements.end());
    refuse_plates_in_struts();
  }

  void PlateContact::refuse_plates_in_struts() const
  {
    // Those that touch at rest may do so by round-off.
    constexpr double tolerance = 1e-6;
    for (const ContactAxis &axis : axes)
      if (axis.stiffness == 0)
        throw InputError(
          "Plates: strut " + std::to_string(axis.strut) +
          " has no thickness that could touch a plate, since its section is "
          "given by its stiffnesses, or it is rigid and there is no section. "
          "Give the section by its shape (`Shape = rectangle`, `circle`, "
          "`tube`), or remove the plates.");
    for (const Plate &plate : plates)
      {
        const ContactAxis *deepest = nullptr;
        double             depth   = 0;
        for (unsigned int a = 0; a < axes.size(); ++a)
          for (const dealii::Point<3> &point : points_of_axes[a].rest)
            {
              const ContactAxis &axis = axes[a];
              const double       here = axis.half_thickness -
                plate.definition->surface->distance(point -
                                                    plate.definition->position);
              if (here >
                  std::max(depth, tolerance * (axis.half_thickness + thickest)))
                {
                  deepest = &axis;
                  depth   = here;
                }
            }
        if (deepest == nullptr)
          continue;
        std::ostringstream message;
        message << plate.definition->path << ": at rest strut "
                << deepest->strut << " reaches " << depth
                << " m into it, half its thickness (" << deepest->half_thickness
                << " m) included, and no strut deeper. Move the plate by its "
                   "Position, or turn its Normal round if the lattice lies "
                   "behind it.";
        throw InputError(message.str());
      }
  }

  bool PlateContact::is_linear() const
  {
    return false;
  }

  void PlateContact::register_in(StateLayout &layout)
  {
    contact_entry = layout.energies.enter(contact_energy_entry());
    if (friction.coefficient > 0)
      friction_account.register_in(layout);
  }

  std::vector<Vector3> PlateContact::plate_values(const Vector &values) const
  {
    const UnknownLayout &layout = model.numbering.layout();
    std::vector<double>  mine(3 * plates.size(), 0.);
    for (unsigned int i = 0; i < plates.size(); ++i)
      for (unsigned int c = 0; c < dimension; ++c)
        if (const int u = layout.local(plates[i].unknowns[c]);
            layout.is_owned(u))
          mine[3 * i + c] = values[u];
    const std::vector<double> all = layout.sum(mine);
    std::vector<Vector3>      result;
    for (unsigned int i = 0; i < plates.size(); ++i)
      result.push_back(Vector3({all[3 * i], all[3 * i + 1], all[3 * i + 2]}));
    return result;
  }

  double PlateContact::least_gap(const unsigned int a,
                                 const unsigned int p,
                                 const Vector      &displacement,
                                 const Vector3     &of_plate) const
  {
    const ContactAxis     &axis = axes[a];
    std::array<Vector3, 2> ends = {{axis.ends[0], axis.ends[1]}};
    for (unsigned int end = 0; end < 2; ++end)
      for (unsigned int c = 0; c < dimension; ++c)
        ends[end][c] += displacement[owned_unknowns[a][end * dimension + c]];
    // No point of a line is farther from the middle between its ends than half
    // its length, here that at rest with 10 % of uneven stretch, or what the
    // ends are apart.
    const double reach =
      0.55 * std::max(axis.length, (ends[1] - ends[0]).norm());
    const PlateDefinition &plate = *plates[p].definition;
    return plate.surface->distance((ends[0] + ends[1]) / 2 - plate.position -
                                   of_plate) -
      reach - axis.half_thickness;
  }

  double PlateContact::largest_motion(const unsigned int a,
                                      const Vector      &increment,
                                      const Vector3     &of_plate) const
  {
    const std::vector<int> &unknowns = owned_unknowns[a];
    double                  largest  = 0;
    for (std::size_t node = 0; node < unknowns.size(); node += dimension)
      {
        double square = 0;
        for (unsigned int c = 0; c < dimension; ++c)
          square += std::pow(increment[unknowns[node + c]] - of_plate[c], 2);
        largest = std::max(largest, square);
      }
    return std::sqrt(largest);
  }

  double PlateContact::largest_displacement(const Vector &values) const
  {
    double largest = 0;
    for (const int unknown : displacements)
      largest = std::max(largest, std::abs(values[unknown]));
    return std::sqrt(dimension) * largest;
  }

  double PlateContact::largest_displacement(const Vector &values,
                                            const Vector &from) const
  {
    double largest = 0;
    for (const int unknown : displacements)
      largest = std::max(largest, std::abs(values[unknown] - from[unknown]));
    return std::sqrt(dimension) * largest;
  }

  bool PlateContact::are_clear(const Vector &now,
                               const double  further,
                               const double  margin) const
  {
    if (!near.empty() || !last_search)
      return false;
    // The gap of least_gap() changes by at most 3.1 times the largest motion
    // of nodes and plates, and a relative motion is at most twice that.
    constexpr double most = 4;
    const double     motion =
      largest_displacement(now, last_search->displacement) + further;
    return last_search->clearance >
      margin + most * model.numbering.layout().largest(motion);
  }

  std::vector<PlateContact::Near> PlateContact::find_near(const State &accepted)
  {
    // What will come near in the next step counts too, and twice as much; what
    // is near stays so until it is twice as far away, as the pattern of the
    // tangent is made anew with each change.
    constexpr double steps = 2, leaving = 2;
    Vector           motion;
    if (step_length > 0)
      {
        motion = *accepted.velocity;
        scale(step_length, motion);
      }
    else if (accepted.before)
      {
        motion = accepted.displacement;
        add_multiple(-1, accepted.before->displacement, motion);
      }
    const std::vector<Vector3> places  = plate_values(accepted.displacement),
                               motions = motion.empty()
      ? std::vector<Vector3>(plates.size())
      : plate_values(motion);
    std::vector<Near> mine;
    double            clearance = std::numeric_limits<double>::infinity();
    for (unsigned int a = 0; a < axes.size(); ++a)
      if (axes[a].is_owned)
        for (unsigned int p = 0; p < plates.size(); ++p)
          {
            double margin = least_margin();
            if (!motion.empty())
              margin += steps * largest_motion(a, motion, motions[p]);
            if (std::binary_search(near.begin(), near.end(), Near{a, p}))
              margin *= leaving;
            const double gap =
              least_gap(a, p, accepted.displacement, places[p]);
            clearance = std::min(clearance, gap);
            if (gap < margin)
              mine.push_back({a, p});
          }
    const UnknownLayout &layout = model.numbering.layout();
    last_search = Search{accepted.displacement, -layout.largest(-clearance)};
    if (layout.n_ranks() == 1)
      return mine;
    std::vector<Near> all;
    for (const auto &part :
         dealii::Utilities::MPI::all_gather(layout.communicator(), mine))
      all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end());
    return all;
  }

  bool PlateContact::takes_part(const Near &pair) const
  {
    const UnknownLayout &layout  = model.numbering.layout();
    const auto           is_mine = [&layout](const int global) {
      return layout.is_owned(layout.local(global));
    };
    const auto &of_axis  = axes[pair.axis].unknowns;
    const auto &of_plate = plates[pair.plate].unknowns;
    return std::any_of(of_axis.begin(), of_axis.end(), is_mine) ||
      std::any_of(of_plate.begin(), of_plate.end(), is_mine);
  }

  bool PlateContact::update_couplings(const State      &accepted,
                                      std::vector<int> &wanted)
  {
    const double next_way = step_length > 0
      ? step_length * largest_displacement(*accepted.velocity)
      : accepted.before ? largest_displacement(accepted.displacement,
                                               accepted.before->displacement)
                        : 0;
    if (are_clear(accepted.displacement, next_way, least_margin()))
      return false;
    std::vector<Near> now = find_near(accepted);
    if (now == near)
      return false;
    near = std::move(now);
    want_unknowns(wanted);
    return true;
  }

  void PlateContact::save(Records &records) const
  {
    std::vector<double> pairs = {double(near.size())};
    for (const Near &pair : near)
      {
        pairs.push_back(pair.axis);
        pairs.push_back(pair.plate);
      }
    records.keep(near_record, pairs);
  }

  bool PlateContact::resume(const Records &records, std::vector<int> &wanted)
  {
    const std::vector<double> pairs =
      records.values(near_record, records.values_per_item(near_record));
    near.clear();
    for (std::size_t i = 1; i < pairs.size(); i += 2)
      near.push_back({static_cast<unsigned int>(pairs[i]),
                      static_cast<unsigned int>(pairs[i + 1])});
    want_unknowns(wanted);
    return true;
  }

  void PlateContact::want_unknowns(std::vector<int> &wanted) const
  {
    for (const Near &pair : near)
      if (takes_part(pair))
        for (const std::vector<int> *unknowns :
             {&axes[pair.axis].unknowns, &plates[pair.plate].unknowns})
          wanted.insert(wanted.end(), unknowns->begin(), unknowns->end());
  }

  void PlateContact::register_blocks(TangentPattern &pattern)
  {
    coupled.clear();
    for (const Near &pair : near)
      if (takes_part(pair))
        {
          std::vector<int> globals = axes[pair.axis].unknowns;
          globals.insert(globals.end(),
                         plates[pair.plate].unknowns.begin(),
                         plates[pair.plate].unknowns.end());
          coupled.push_back(
            {pair, local_numbers(globals, pattern.unknowns().layout)});
          const std::size_t block =
            pattern.register_block(coupled.back().unknowns.data(),
                                   globals.size());
          if (coupled.size() == 1)
            first_block = block;
        }
  }

  std::unique_ptr<EffectResults> PlateContact::make_results() const
  {
    return std::make_unique<PlateContactResults>();
  }

  ContactLaw PlateContact::law(const unsigned int axis,
                               const unsigned int point) const
  {
    return {axes[axis].stiffness * points_of_axes[axis].weights[point],
            parameters.smoothing * thickness_of(axes[axis])};
  }

  double PlateContact::thickness_of(const ContactAxis &axis) const
  {
    return axis.half_thickness > 0 ? axis.half_thickness : thickest;
  }

  Vector3 PlateContact::difference(const Coupled     &pair,
                                   const unsigned int point,
                                   const Vector      &values) const
  {
    Vector3 result =
      points_of_axes[pair.near.axis].displacement(point,
                                                  dimension,
                                                  pair.unknowns.data(),
                                                  values.data());
    const std::size_t of_plate = axes[pair.near.axis].n_nodes() * dimension;
    for (unsigned int c = 0; c < dimension; ++c)
      result[c] -= values[pair.unknowns[of_plate + c]];
    return result;
  }

  Vector3 PlateContact::position(const Coupled     &pair,
                                 const unsigned int point,
                                 const Vector      &displacement) const
  {
    return points_of_axes[pair.near.axis].rest[point] -
      plates[pair.near.plate].definition->position +
      difference(pair, point, displacement);
  }

  void PlateContact::press(const Coupled              &pair,
                           const Evaluation           &evaluation,
                           const unsigned int          block,
                           std::vector<TouchingPoint> &points) const
  {
    const bool is_between       = evaluation.kind == Evaluation::Kind::between;
    const ContactAxis  &axis    = axes[pair.near.axis];
    const RigidSurface &surface = *plates[pair.near.plate].definition->surface;
    for (unsigned int i = 0; i < points_of_axes[pair.near.axis].size(); ++i)
      {
        const Vector3 to    = position(pair, i, evaluation.to.displacement);
        const double  depth = axis.half_thickness - surface.distance(to);
        Vector3       from;
        double        depth_before = depth;
        if (is_between)
          {
            from         = position(pair, i, evaluation.from.displacement);
            depth_before = axis.half_thickness - surface.distance(from);
          }
        if (depth <= 0 && depth_before <= 0)
          continue;
        const SurfaceDistance now = surface.at(to);
        const ContactLaw      law = this->law(pair.near.axis, i);
        TouchingPoint touching{block, pair.near.axis, i, pair.near.plate};
        touching.depth = depth;
        touching.now   = now.normal;
        if (is_between)
          {
            const MeanDistance mean = surface.between(from, to);
            touching.force          = law.mean_force(depth_before, depth);
            touching.slope          = law.mean_slope(depth_before, depth);
            touching.normal         = mean.direction;
            touching.turning        = mean.change;
          }
        else
          {
            touching.force   = law.force(depth);
            touching.slope   = law.slope(depth);
            touching.normal  = now.normal;
            touching.turning = now.curvature;
          }
        if (friction.coefficient > 0 &&
            evaluation.kind != Evaluation::Kind::equilibrium)
          touching.friction =
            friction.force(sliding_velocity(evaluation,
                                            [&](const Vector &u) {
                                              return difference(pair, i, u);
                                            }),
                           touching.normal / touching.normal.norm(),
                           touching.force);
        points.push_back(touching);
      }
  }

  template <class Add>
  void PlateContact::add_to_unknowns(const TouchingPoint &touching,
                                     const Add           &add) const
  {
    const ContactAxis      &axis     = axes[touching.axis];
    const std::vector<int> &unknowns = coupled[touching.pair].unknowns;
    for (unsigned int node = 0; node <= axis.n_nodes(); ++node)
      {
        const double share = node < axis.n_nodes()
          ? (*points_of_axes[touching.axis].shape)(touching.point, node)
          : -1.;
        for (unsigned int c = 0; c < dimension; ++c)
          add(unknowns[node * dimension + c], c, share);
      }
  }

  void PlateContact::add_residual(const Evaluation &evaluation,
                                  double           *residual,
                                  EffectResults    *results) const
  {
    auto &points = static_cast<PlateContactResults &>(*results).points;
    points.clear();
    for (unsigned int i = 0; i < coupled.size(); ++i)
      press(coupled[i], evaluation, i, points);
    for (const TouchingPoint &touching : points)
      {
        const Vector3 force =
          touching.force * touching.normal + touching.friction.force;
        add_to_unknowns(touching,
                        [&](const int          unknown,
                            const unsigned int component,
                            const double       share) {
                          residual[unknown] -= share * force[component];
                        });
      }
  }

  dealii::Tensor<2, 3>
  PlateContact::stiffness_of(const TouchingPoint &touching,
                             const double         by_position,
                             const double         by_velocity) const
  {
    const Tensor of_pressure =
      touching.slope * dealii::outer_product(touching.normal, touching.now) -
      touching.force * touching.turning;
    if (touching.friction.scale == 0)
      return by_position * of_pressure;

    const double         length    = touching.normal.norm();
    const Vector3        n         = touching.normal / length;
    const FrictionChange change    = friction.change(touching.friction, n);
    const Tensor         of_normal = touching.turning / length -
      dealii::outer_product(n, n * touching.turning) / length;
    return by_velocity * change.by_velocity +
      by_position *
      (of_pressure + change.by_normal * of_normal -
       touching.slope *
         dealii::outer_product(change.by_pressure, touching.now));
  }

  void PlateContact::add_tangent(const Evaluation     &evaluation,
                                 const EffectResults  *results,
                                 const TangentFactors &factors,
                                 TangentMatrix        &matrix) const
  {
    if (factors.stiffness == 0 && factors.damping == 0)
      return;
    const bool   is_between  = evaluation.kind == Evaluation::Kind::between;
    const double by_position = is_between ? 1. : factors.stiffness,
                 by_velocity =
                   is_between ? 1. / evaluation.dt : factors.damping;
    std::vector<double> block;
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(*results).points)
      {
        const dealii::Tensor<2, 3> of_point =
          stiffness_of(touching, by_position, by_velocity);
        const std::size_t n = coupled[touching.pair].unknowns.size();
        block.assign(n * n, 0.);
        std::size_t row = 0;
        add_to_unknowns(
          touching,
          [&](const int, const unsigned int a, const double of_row) {
            std::size_t column = row * n;
            add_to_unknowns(
              touching,
              [&](const int, const unsigned int b, const double of_column) {
                block[column++] = of_row * of_column * of_point[a][b];
              });
            ++row;
          });
        matrix.add(first_block + touching.pair, block.data());
      }
  }

  bool PlateContact::is_owned(const TouchingPoint &touching) const
  {
    return axes[touching.axis].is_owned;
  }

  void PlateContact::account(const Evaluation & /*evaluation*/,
                             const EffectResults *results,
                             EnergyAccount       &account) const
  {
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(*results).points)
      if (is_owned(touching))
        account.add(contact_entry,
                    law(touching.axis, touching.point).energy(touching.depth));
  }

  void PlateContact::account_step(const Evaluation    &step,
                                  const EffectResults *results,
                                  EnergyAccount       &account) const
  {
    if (friction.coefficient == 0 || !account.takes_time())
      return;
    std::vector<TouchingPoint> at_start;
    if (step.kind == Evaluation::Kind::step)
      {
        State            before  = step.from;
        const Evaluation instant = Evaluation::rates(step.from, before);
        for (unsigned int i = 0; i < coupled.size(); ++i)
          press(coupled[i], instant, i, at_start);
      }
    const auto &at_end =
      static_cast<const PlateContactResults &>(*results).points;
    friction_account.add_step(step,
                              sliding(at_end, step),
                              sliding(at_start, step),
                              account);
  }

  std::vector<Sliding>
  PlateContact::sliding(const std::vector<TouchingPoint> &points,
                        const Evaluation                 &step) const
  {
    std::vector<Sliding> result;
    for (const TouchingPoint &touching : points)
      if (is_owned(touching))
        {
          const Coupled &pair = coupled[touching.pair];
          result.push_back(
            {touching.friction,
             difference(pair, touching.point, step.to.displacement) -
               difference(pair, touching.point, step.from.displacement)});
        }
    return result;
  }

  void PlateContact::account_stage(const Evaluation & /*stage*/,
                                   const EffectResults *results,
                                   EnergyAccount       &account) const
  {
    if (friction.coefficient == 0)
      return;
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(*results).points)
      if (is_owned(touching))
        friction_account.add_power(touching.friction, account);
  }

  void PlateContact::raise_forces(const Evaluation & /*evaluation*/,
                                  const EffectResults *results,
                                  double              *forces) const
  {
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(*results).points)
      add_to_unknowns(touching,
                      [&](const int unknown,
                          const unsigned int /*component*/,
                          const double share) {
                        raise(forces,
                              unknown,
                              std::abs(share) * touching.force);
                      });
  }

  void PlateContact::raise_uncertain_forces(const Evaluation    &evaluation,
                                            const EffectResults *results,
                                            const double largest_displacement,
                                            const double /*largest_rotation*/,
                                            double *forces) const
  {
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(*results).points)
      {
        // Depths are differences of positions, and where they are round-off
        // themselves the stiffness is none that can be told.
        const double length = largest_displacement +
          position(coupled[touching.pair],
                   touching.point,
                   evaluation.to.displacement)
            .norm();
        const double slope =
          law(touching.axis, touching.point)
            .slope(touching.depth +
                   std::numeric_limits<double>::epsilon() * length);
        add_to_unknowns(touching,
                        [&](const int unknown,
                            const unsigned int /*component*/,
                            const double share) {
                          raise(forces,
                                unknown,
                                std::abs(share) *
                                  (touching.force +
                                   std::max(slope, touching.slope) * length));
                        });
      }
  }

  bool PlateContact::may_touch() const
  {
    return !near.empty();
  }

  std::string PlateContact::why_not_acceptable(const Evaluation &step) const
  {
    if (are_clear(step.to.displacement,
                  largest_displacement(step.to.displacement,
                                       step.from.displacement),
                  0))
      return "";
    Vector increment = step.to.displacement;
    add_multiple(-1, step.from.displacement, increment);
    const std::vector<Vector3> places  = plate_values(step.to.displacement),
                               motions = plate_values(increment);
    for (unsigned int a = 0; a < axes.size(); ++a)
      if (axes[a].is_owned)
        for (unsigned int p = 0; p < plates.size(); ++p)
          // Between its nodes an axis may move by more than they.
          if (least_gap(a, p, step.to.displacement, places[p]) <
              2 * largest_motion(a, increment, motions[p]))
            if (const std::string why =
                  why_too_deep(a, p, step, places[p], places[p] - motions[p]);
                !why.empty())
              return why;
    return "";
  }

  std::string PlateContact::why_too_deep(const unsigned int a,
                                         const unsigned int p,
                                         const Evaluation  &step,
                                         const Vector3     &place,
                                         const Vector3     &place_before) const
  {
    const ContactAxis     &axis  = axes[a];
    const PlateDefinition &plate = *plates[p].definition;
    const bool             is_coupled =
      std::binary_search(near.begin(), near.end(), Near{a, p});
    const double allowed =
      is_coupled ? parameters.largest_penetration * thickness_of(axis) : 0.;
    const auto at =
      [&](const unsigned int i, const State &state, const Vector3 &of_plate) {
        return points_of_axes[a].rest[i] - plate.position - of_plate +
          points_of_axes[a].displacement(i,
                                         dimension,
                                         owned_unknowns[a].data(),
                                         state.displacement.data());
      };
    for (unsigned int i = 0; i < points_of_axes[a].size(); ++i)
      {
        const double depth = axis.half_thickness -
          plate.surface->least_distance(at(i, step.from, place_before),
                                        at(i, step.to, place));
        if (depth <= allowed)
          continue;
        std::ostringstream why;
        why << "strut " << axis.strut << " would go " << depth
            << " m into the plate \"" << plate.name << '"';
        if (is_coupled)
          why << ", more than Contact/Largest penetration allows";
        return why.str();
      }
    return "";
  }

  unsigned int PlateContact::n_plates() const
  {
    return plates.size();
  }

  const std::string &PlateContact::name(const unsigned int plate) const
  {
    return plates[plate].definition->name;
  }

  std::vector<PlateReport> PlateContact::reports(const EffectResults &results,
                                                 const State &state) const
  {
    const std::vector<Vector3> displacements = plate_values(state.displacement);
    std::vector<double>        forces(3 * plates.size(), 0.);
    std::vector<double>        penetrations(plates.size(), 0.);
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(results).points)
      if (is_owned(touching))
        {
          const Vector3 force =
            touching.force * touching.normal + touching.friction.force;
          for (unsigned int c = 0; c < 3; ++c)
            forces[3 * touching.plate + c] -= force[c];
          double &largest = penetrations[touching.plate];
          largest         = std::max(largest, penetration(touching));
        }
    const UnknownLayout &layout = model.numbering.layout();
    forces                      = layout.sum(forces);
    std::vector<PlateReport> of_plates;
    for (unsigned int i = 0; i < plates.size(); ++i)
      of_plates.push_back(
        {displacements[i],
         Vector3({forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]}),
         layout.largest(penetrations[i])});
    return of_plates;
  }

  std::optional<DeepestContact>
  PlateContact::deepest(const EffectResults &results) const
  {
    std::optional<DeepestContact> found;
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(results).points)
      if (const ContactAxis &axis = axes[touching.axis]; axis.is_owned)
        if (const double part = penetration(touching);
            part > (found ? found->part : 0.))
          found = {part, axis.strut, touching.plate};
    return found;
  }

  double PlateContact::penetration(const TouchingPoint &touching) const
  {
    return touching.depth / (2 * thickness_of(axes[touching.axis]));
  }

  std::vector<ContactReport>
  PlateContact::contacts(const EffectResults &results, const State &state) const
  {
    std::vector<ContactReport> all;
    for (const TouchingPoint &touching :
         static_cast<const PlateContactResults &>(results).points)
      if (const ContactAxis &axis = axes[touching.axis];
          is_owned(touching) && touching.depth > 0)
        all.push_back(
          {axis.strut,
           touching.plate,
           points_of_axes[touching.axis].rest[touching.point],
           points_of_axes[touching.axis].displacement(
             touching.point,
             dimension,
             owned_unknowns[touching.axis].data(),
             state.displacement.data()),
           thickness_of(axis) * touching.now,
           touching.force * touching.normal + touching.friction.force,
           touching.depth});
    return all;
  }

  std::vector<std::vector<dealii::Point<3>>>
  PlateContact::outline(const unsigned int plate, const double size) const
  {
    const PlateDefinition &definition = *plates[plate].definition;
    std::vector<std::vector<dealii::Point<3>>> lines;
    for (const auto &line : definition.surface->outline(size, dimension))
      {
        lines.emplace_back();
        for (const Vector3 &point : line)
          lines.back().push_back(definition.position + point);
      }
    return lines;
  }
} // namespace auxfem
