#include <auxfem/equations/effects/connector_forces.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/static.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  ConnectorResults::ConnectorResults(const unsigned int n_connectors)
    : motion(n_connectors)
    , response(n_connectors)
    , direction(n_connectors)
    , velocity_difference(n_connectors)
    , current_length(n_connectors)
  {}

  ConnectorForces::ConnectorForces(const ConnectorDefinition    &definition,
                                   const std::vector<JointPair> &pairs,
                                   const Lattice                &lattice,
                                   const DofNumbering           &numbering,
                                   const bool                    large_rotation)
    : group_name(definition.name)
    , law(definition.law)
    , follows_line(definition.geometry == ConnectorDefinition::Geometry::line &&
                   large_rotation)
    , ground_offset(definition.ground_offset)
    , lattice(lattice)
  {
    for (unsigned int number = 0; number < pairs.size(); ++number)
      {
        Ends ends = make_ends(definition, pairs[number], numbering);
        if (std::none_of(ends.unknowns.begin(),
                         ends.unknowns.end(),
                         [&](const int u) {
                           return numbering.layout().is_owned(u);
                         }))
          continue;
        ends.number = number;
        if (ends.owned)
          owned.push_back(connectors.size());
        connectors.push_back(ends);
      }
  }

  ConnectorForces::Ends
  ConnectorForces::make_ends(const ConnectorDefinition &definition,
                             const JointPair           &pair,
                             const DofNumbering        &numbering) const
  {
    using Geometry = ConnectorDefinition::Geometry;
    Ends ends;
    ends.first_joint  = pair.first;
    ends.second_joint = pair.second;
    ends.cell         = pair.cell;
    for (unsigned int i = 0; i < 6; ++i)
      {
        const unsigned int joint = i < 3 ? pair.first : pair.second;
        ends.unknowns[i] =
          joint == invalid_index ? -1 : numbering.joint_unknown(joint, i % 3);
      }
    ends.owned       = numbering.layout().is_owned(ends.unknowns[0]);
    ends.span        = pair.second == invalid_index
             ? ground_offset
             : lattice.joints[pair.second] - lattice.joints[pair.first];
    ends.rest_length = ends.span.norm();
    if (ends.rest_length == 0 && definition.geometry == Geometry::line)
      throw InputError(
        definition.path + ": the connector at joint " +
        std::to_string(pair.first) +
        " has length zero, so no line leads along it. Give `Geometry = "
        "direction` with a `Direction`, or a `Ground offset`.");
    ends.direction = definition.geometry == Geometry::direction
      ? definition.direction
      : ends.span / ends.rest_length;
    return ends;
  }

  bool ConnectorForces::is_linear() const
  {
    return !follows_line && law->is_linear();
  }

  void ConnectorForces::register_in(StateLayout &layout)
  {
    std::vector<unsigned int> numbers;
    numbers.reserve(connectors.size());
    for (const Ends &ends : connectors)
      numbers.push_back(ends.number);
    if (law->n_history() > 0)
      {
        first_history = layout.history.keep(group_name + ": internal variables",
                                            numbers,
                                            law->n_history());
        layout.integrated.emplace_back(first_history,
                                       layout.history.n_values());
      }
    stored_entry = layout.energies.enter(stored_energy_entry());
    if (!law->is_viscous())
      return;
    layout.velocity  = true;
    first_dissipated = layout.history.keep(group_name + ": dissipated energy",
                                           numbers,
                                           /*values_per_item=*/1);
    dissipated_entry =
      layout.energies.enter({EnergyKind::dissipated,
                             group_name + ".dissipated",
                             "energy lost in the connectors since the start"});
    numerical_entry = layout.energies.enter(numerical_energy_entry());
  }

  void ConnectorForces::register_blocks(TangentPattern &pattern)
  {
    first_block = pattern.register_blocks(connectors, &Ends::unknowns);
  }

  std::unique_ptr<EffectResults> ConnectorForces::make_results() const
  {
    return std::make_unique<ConnectorResults>(connectors.size());
  }

  dealii::Tensor<1, 3> ConnectorForces::difference(const Ends   &ends,
                                                   const double *values)
  {
    dealii::Tensor<1, 3> result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] =
        (ends.unknowns[3 + c] >= 0 ? values[ends.unknowns[3 + c]] : 0.) -
        (ends.unknowns[c] >= 0 ? values[ends.unknowns[c]] : 0.);
    return result;
  }

  double ConnectorForces::extension(const Ends                 &ends,
                                    const dealii::Tensor<1, 3> &du) const
  {
    if (!follows_line)
      return ends.direction * du;
    // L^2 - L0^2 = du.(2 span + du): no difference of nearly equal lengths.
    return du * (2. * ends.span + du) /
      ((ends.span + du).norm() + ends.rest_length);
  }

  void ConnectorForces::find_motion(const Evaluation &evaluation,
                                    ConnectorResults &results) const
  {
    const bool    is_between = evaluation.kind == Evaluation::Kind::between;
    const double *before     = evaluation.from.displacement.data();
    const double *u          = evaluation.to.displacement.data();
    const double *v =
      evaluation.to.velocity ? evaluation.to.velocity->data() : nullptr;
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const Ends                &ends      = connectors[i];
        const dealii::Tensor<1, 3> du_before = difference(ends, before),
                                   du        = difference(ends, u),
                                   line      = ends.span + du;
        ConnectorMotion &motion              = results.motion[i];
        motion.previous_extension            = extension(ends, du_before);
        motion.extension                     = extension(ends, du);
        motion.dt                            = evaluation.dt;
        results.current_length[i]            = line.norm();
        results.direction[i] =
          follows_line ? line / results.current_length[i] : ends.direction;
        // L1^2 - L0^2 over L0 + L1: the extension in the step is the product of
        // this with the relative motion.
        if (is_between && follows_line)
          {
            const dealii::Tensor<1, 3> line_before = ends.span + du_before;
            results.direction[i]                   = (line_before + line) /
              (line_before.norm() + results.current_length[i]);
          }
        if (ends_meet(i, results.current_length[i]))
          for (unsigned int c = 0; c < 3; ++c)
            results.direction[i][c] = std::numeric_limits<double>::quiet_NaN();
        if (v != nullptr)
          results.velocity_difference[i] = difference(ends, v);
        motion.rate = rate(i, evaluation, results);
      }
  }

  double ConnectorForces::rate(const unsigned int      i,
                               const Evaluation       &evaluation,
                               const ConnectorResults &results) const
  {
    const ConnectorMotion &motion = results.motion[i];
    const double increment = motion.extension - motion.previous_extension;
    if (evaluation.kind == Evaluation::Kind::between)
      return increment / evaluation.dt;
    if (evaluation.kind != Evaluation::Kind::static_step)
      return results.direction[i] * results.velocity_difference[i];
    // Without inertia velocities are differences over steps in which the line
    // turns; those of the extension do not see the rotation.
    const BackwardDifference difference_in(evaluation.from, evaluation.dt);
    double                   rate = difference_in.now * increment;
    if (const auto &before = evaluation.from.before)
      rate -= difference_in.before *
        (motion.previous_extension -
         extension(connectors[i],
                   difference(connectors[i], before->displacement.data())));
    return rate;
  }

  VanishingConnector ConnectorForces::shortest(const Evaluation    &step,
                                               const EffectResults &results,
                                               const double         least) const
  {
    VanishingConnector found{least, invalid_index};
    if (!follows_line)
      return found;
    const auto &of_group = static_cast<const ConnectorResults &>(results);
    for (const unsigned int i : owned)
      {
        const Ends &ends = connectors[i];
        const bool  is_turned_round =
          (ends.span + difference(ends, step.from.displacement.data())) *
            (ends.span + difference(ends, step.to.displacement.data())) <
          0;
        const double part =
          is_turned_round ? 0. : of_group.current_length[i] / ends.rest_length;
        if (part < found.part)
          found = {part, ends.first_joint};
      }
    return found;
  }

  ConnectorMotion ConnectorForces::motion_at(const Ends  &ends,
                                             const State &state,
                                             const double extension) const
  {
    const dealii::Tensor<1, 3> line =
      ends.span + difference(ends, state.displacement.data());
    const double rate = (follows_line ? line / line.norm() : ends.direction) *
      difference(ends, state.velocity->data());
    return {extension, rate, extension, 0};
  }

  void ConnectorForces::find_response(const Evaluation &evaluation,
                                      ConnectorResults &results) const
  {
    double *const internal = evaluation.to.history.data() + first_history;
    if (evaluation.kind == Evaluation::Kind::between)
      {
        law->evaluate_mean(connectors.size(),
                           results.motion.data(),
                           evaluation.from.history.data() + first_history,
                           internal,
                           results.response.data());
        return;
      }
    if (evaluation.kind == Evaluation::Kind::stage)
      {
        law->evaluate_stage(connectors.size(),
                            results.motion.data(),
                            evaluation.from.history.data() + first_history,
                            internal,
                            results.response.data());
        return;
      }
    if (evaluation.kind != Evaluation::Kind::equilibrium)
      {
        law->evaluate(connectors.size(),
                      results.motion.data(),
                      evaluation.from.history.data() + first_history,
                      internal,
                      results.response.data());
        return;
      }
    for (unsigned int i = 0; i < connectors.size(); ++i)
      results.response[i] = law->relaxed(results.motion[i].extension);
    std::fill(internal, internal + connectors.size() * law->n_history(), 0.);
  }

  void ConnectorForces::add_residual(const Evaluation &evaluation,
                                     double           *residual,
                                     EffectResults    *results) const
  {
    auto &of_group = static_cast<ConnectorResults &>(*results);
    find_motion(evaluation, of_group);
    find_response(evaluation, of_group);
    for (unsigned int i = 0; i < connectors.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double force =
            of_group.response[i].force * of_group.direction[i][c];
          if (connectors[i].unknowns[c] >= 0)
            residual[connectors[i].unknowns[c]] -= force;
          if (connectors[i].unknowns[3 + c] >= 0)
            residual[connectors[i].unknowns[3 + c]] += force;
        }
  }

  void ConnectorForces::add_tangent(const Evaluation     &evaluation,
                                    const EffectResults  *results,
                                    const TangentFactors &factors,
                                    TangentMatrix        &matrix) const
  {
    if (factors.stiffness == 0 && factors.damping == 0)
      return;
    const auto &of_group = static_cast<const ConnectorResults &>(*results);
    if (evaluation.kind == Evaluation::Kind::between)
      {
        add_mean_tangent(evaluation, of_group, matrix);
        return;
      }
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const auto  &n = of_group.direction[i];
        const double along =
          factors.stiffness * of_group.response[i].stiffness +
          factors.damping * of_group.response[i].damping;
        // D: derivative of the force on the second end by the relative motion.
        double D[3][3];
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            D[a][b] = along * n[a] * n[b];
        if (follows_line)
          {
            // The line turns with the ends: force and rate change direction.
            const double rotating =
              factors.stiffness / of_group.current_length[i];
            for (unsigned int a = 0; a < 3; ++a)
              for (unsigned int b = 0; b < 3; ++b)
                {
                  const double across = (a == b ? 1. : 0.) - n[a] * n[b];
                  D[a][b] += rotating * of_group.response[i].force * across;
                  if (evaluation.kind == Evaluation::Kind::static_step)
                    continue;
                  const double rate_by_position =
                    of_group.velocity_difference[i][b] -
                    of_group.motion[i].rate * n[b];
                  D[a][b] += rotating * of_group.response[i].damping * n[a] *
                    rate_by_position;
                }
          }
        add_block(i, D, matrix);
      }
  }

  void ConnectorForces::add_geometric_tangent(const ForceChange &change,
                                              const unsigned int effect,
                                              TangentMatrix     &matrix) const
  {
    if (!follows_line)
      return;
    const auto of_group = [effect](const EvaluationResults &results) {
      return static_cast<const ConnectorResults *>(
        results.of_effects[effect].get());
    };
    const ConnectorResults *const        now    = of_group(change.at_state),
                                  *const before = of_group(change.at_from),
                                  *const after  = of_group(change.at_to);
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const auto  &n     = now->direction[i];
        const double force = change.factor *
          (after->response[i].force - before->response[i].force);
        double D[3][3];
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            D[a][b] = force / now->current_length[i] *
              ((a == b ? 1. : 0.) - n[a] * n[b]);
        add_block(i, D, matrix);
      }
  }

  void ConnectorForces::add_mean_tangent(const Evaluation       &evaluation,
                                         const ConnectorResults &results,
                                         TangentMatrix          &matrix) const
  {
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const ConnectorResponse   &response = results.response[i];
        const dealii::Tensor<1, 3> e        = results.direction[i];
        dealii::Tensor<1, 3>       now      = e;
        double                     rotating = 0;
        if (follows_line)
          {
            const Ends &ends = connectors[i];
            now              = (ends.span +
                   difference(ends, evaluation.to.displacement.data())) /
              results.current_length[i];
            const double length_before =
              (ends.span +
               difference(ends, evaluation.from.displacement.data()))
                .norm();
            rotating =
              response.force / (length_before + results.current_length[i]);
          }
        double D[3][3];
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            D[a][b] = response.stiffness * e[a] * now[b] +
              rotating * ((a == b ? 1. : 0.) - e[a] * now[b]);
        add_block(i, D, matrix);
      }
  }

  void ConnectorForces::add_block(const unsigned int i,
                                  const double (&by_motion)[3][3],
                                  TangentMatrix &matrix) const
  {
    double block[36];
    for (unsigned int a = 0; a < 6; ++a)
      for (unsigned int b = 0; b < 6; ++b)
        block[6 * a + b] =
          ((a < 3) == (b < 3) ? 1 : -1) * by_motion[a % 3][b % 3];
    matrix.add(first_block + i, block);
  }

  void ConnectorForces::add_relaxation_times(const Unknowns      &unknowns,
                                             std::vector<double> &times) const
  {
    const std::vector<double> of_law = law->relaxation_times();
    for (const unsigned int i : owned)
      {
        const auto &ends = connectors[i].unknowns;
        if (std::any_of(ends.begin(), ends.end(), [&](const int unknown) {
              return unknown >= 0 &&
                unknowns.kinds[unknown] != UnknownKind::prescribed;
            }))
          times.insert(times.end(), of_law.begin(), of_law.end());
      }
  }

  void ConnectorForces::add_viscous_stiffness(const Evaluation & /*evaluation*/,
                                              const EffectResults *results,
                                              const std::complex<double> s,
                                              TangentMatrix             &real,
                                              TangentMatrix &imaginary) const
  {
    if (!law->is_viscous())
      return;
    const auto &of_group = static_cast<const ConnectorResults &>(*results);
    const std::complex<double> stiffness =
      law->dynamic_stiffness(s) - law->long_time_stiffness();
    for (unsigned int i = 0; i < connectors.size(); ++i)
      for (const auto &[value, matrix] :
           {std::pair(stiffness.real(), &real),
            std::pair(stiffness.imag(), &imaginary)})
        {
          const auto &n = of_group.direction[i];
          double      D[3][3];
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              D[a][b] = value * n[a] * n[b];
          add_block(i, D, *matrix);
        }
  }

  void ConnectorForces::account(const Evaluation    &evaluation,
                                const EffectResults *results,
                                EnergyAccount       &account) const
  {
    std::vector<double> rates(law->n_history());
    for (const unsigned int i : owned)
      account.add(stored_entry,
                  continuous(i, evaluation.to, *results, rates.data()).stored);
  }

  ContinuousResponse ConnectorForces::continuous(const unsigned int   i,
                                                 const State         &state,
                                                 const EffectResults &results,
                                                 double *internal_rates) const
  {
    const ConnectorMotion &motion =
      static_cast<const ConnectorResults &>(results).motion[i];
    return law->continuous(motion.extension,
                           motion.rate,
                           state.history.data() + first_history +
                             i * law->n_history(),
                           internal_rates);
  }

  void ConnectorForces::account_step(const Evaluation    &step,
                                     const EffectResults *results,
                                     EnergyAccount       &account) const
  {
    if (!law->is_viscous())
      return;
    const auto &of_group = static_cast<const ConnectorResults &>(*results);
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const std::size_t     at = first_history + i * law->n_history();
        const ConnectorEnergy energy =
          law->energy(of_group.motion[i],
                      step.from.history.data() + at,
                      step.to.history.data() + at);
        step.to.history[first_dissipated + i] =
          step.from.history[first_dissipated + i] + energy.dissipated;
        if (!connectors[i].owned)
          continue;
        account.add_in_step(dissipated_entry, energy.dissipated);
        // Between two states the mean force does what is stored and lost.
        if (account.takes_time() && step.kind != Evaluation::Kind::between)
          account.add_in_step(numerical_entry,
                              taken(i, step, of_group, energy));
      }
  }

  void ConnectorForces::account_stage(const Evaluation    &stage,
                                      const EffectResults *results,
                                      EnergyAccount       &account) const
  {
    if (!law->is_viscous())
      return;
    std::vector<double> rates(law->n_history());
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const double power =
          continuous(i, stage.to, *results, rates.data()).lost_power;
        stage.to.history[first_dissipated + i] =
          stage.from.history[first_dissipated + i] + stage.weight * power;
        if (connectors[i].owned)
          account.add_power(dissipated_entry, power);
      }
  }

  void ConnectorForces::find_internal_rates(const State         &state,
                                            const EffectResults *results,
                                            double              *rates) const
  {
    if (law->n_history() > 0)
      for (unsigned int i = 0; i < connectors.size(); ++i)
        continuous(i,
                   state,
                   *results,
                   rates + first_history + i * law->n_history());
  }

  double ConnectorForces::taken(const unsigned int      i,
                                const Evaluation       &step,
                                const ConnectorResults &results,
                                const ConnectorEnergy  &energy) const
  {
    const Ends           &ends = connectors[i];
    const ConnectorMotion start =
      motion_at(ends, step.from, results.motion[i].previous_extension);
    const double *committed =
      step.from.history.data() + first_history + i * law->n_history();
    std::vector<double> internal(law->n_history());
    ConnectorResponse   before;
    law->evaluate(1, &start, committed, internal.data(), &before);
    const double stored_before =
      law->energy(start, committed, committed).stored;
    return (before.force + results.response[i].force) / 2 *
      (results.motion[i].extension - start.extension) -
      (energy.stored - stored_before) - energy.dissipated;
  }

  void ConnectorForces::raise_forces(const Evaluation & /*evaluation*/,
                                     const EffectResults *results,
                                     double              *forces) const
  {
    const auto &of_group = static_cast<const ConnectorResults &>(*results);
    for (unsigned int i = 0; i < connectors.size(); ++i)
      for (const int unknown : connectors[i].unknowns)
        raise(forces, unknown, std::abs(of_group.response[i].force));
  }

  void
  ConnectorForces::raise_uncertain_forces(const Evaluation & /*evaluation*/,
                                          const EffectResults *results,
                                          const double largest_displacement,
                                          const double /*largest_rotation*/,
                                          double *forces) const
  {
    const auto &of_group = static_cast<const ConnectorResults &>(*results);
    for (unsigned int i = 0; i < connectors.size(); ++i)
      for (const int unknown : connectors[i].unknowns)
        raise(forces,
              unknown,
              of_group.response[i].stiffness * largest_displacement);
  }

  bool ConnectorForces::ends_meet(const unsigned int i,
                                  const double       length) const
  {
    // Of a shorter line the direction is round-off.
    constexpr double digits = 1e-12;
    return follows_line && length <= digits * connectors[i].rest_length;
  }

  std::string
  ConnectorForces::why_not_finite(const Evaluation    &evaluation,
                                  const EffectResults *results) const
  {
    const auto &of_group = static_cast<const ConnectorResults &>(*results);
    for (unsigned int i = 0; i < connectors.size(); ++i)
      if (ends_meet(i, of_group.current_length[i]))
        {
          const Ends        &ends = connectors[i];
          std::ostringstream words;
          words << "the ends of the connector \"" << group_name
                << "\" between joint " << ends.first_joint << " and "
                << (ends.second_joint == invalid_index
                      ? "the ground"
                      : "joint " + std::to_string(ends.second_joint))
                << " meet at t = " << evaluation.to.time
                << " s, so no line leads along it";
          return words.str();
        }
    return "";
  }

  ConnectorReport ConnectorForces::report(const unsigned int   i,
                                          const State         &state,
                                          const EffectResults *results) const
  {
    const auto &of_group    = static_cast<const ConnectorResults &>(*results);
    const unsigned int c    = owned[i];
    const Ends        &ends = connectors[c];
    ConnectorReport    report;
    report.ends[0] = lattice.joints[ends.first_joint];
    report.ends[1] = report.ends[0] + ends.span;
    for (unsigned int k = 0; k < 6; ++k)
      if (ends.unknowns[k] >= 0)
        report.displacements[k / 3][k % 3] =
          state.displacement[ends.unknowns[k]];
    report.force     = of_group.response[c].force;
    report.extension = of_group.motion[c].extension;
    report.dissipated =
      law->is_viscous() ? state.history[first_dissipated + c] : 0.;
    report.cell = ends.cell;
    return report;
  }
} // namespace auxfem
