#include <auxfem/contact/effects/contact.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/small_displacement_limit.h>
#include <auxfem/time/watch.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace auxfem
{
  namespace
  {
    SimulatedEffects with_large_rotation(SimulatedEffects simulated)
    {
      simulated.large_rotation = true;
      return simulated;
    }
  } // namespace

  struct SecondOrderEffect::Exact
  {
    Exact(const LatticeModel &small_model, Work &work)
      : model(small_model, with_large_rotation(small_model.plan.simulated))
      , equations(model)
      , solver(equations, model.plan.solver, work)
    {}

    /**
     * Factorizes K + K_g under the forces of @p motion; false if it is
     * singular.
     */
    bool factorize_under(const Vector &motion)
    {
      State rest = state_at_rest();
      // Constraints add terms linear in their forces.
      for (const int i : model.numbering.constraints().multipliers())
        rest.displacement[i] = motion[i];
      const EvaluationResults at_rest     = assemble(rest);
      const auto [displacement, rotation] = largest_motion(model, motion);
      const double size =
        std::max(rotation, displacement / model.mean_strut_length);
      if (size > 0)
        {
          const double part   = finite_difference_step / size;
          State        before = displaced(rest, model.numbering, motion, -part),
                after         = displaced(rest, model.numbering, motion, part);
          const EvaluationResults results_before = results_at(before),
                                  at_after       = results_at(after);
          equations.add_geometric_tangent({rest,
                                           before,
                                           after,
                                           at_rest,
                                           results_before,
                                           at_after,
                                           1 / (2 * part)},
                                          solver.matrix());
        }
      // Only the symmetric part has an inertia; the rest are balanced moments.
      return solver.factorize(Exactness::approximate);
    }

    /** Factorizes K; false if it is singular. */
    bool factorize_at_rest()
    {
      State rest = state_at_rest();
      assemble(rest);
      return solver.factorize(Exactness::approximate);
    }

    const LatticeModel model;
    Equations          equations;
    TangentSolver      solver;

  private:
    State state_at_rest() const
    {
      State rest = equations.initial_state();
      for (std::optional<Vector> *rates : {&rest.velocity, &rest.acceleration})
        if (*rates)
          (*rates)->assign((*rates)->size(), 0.);
      return rest;
    }

    /** Assembles the stiffness without that of forces. */
    EvaluationResults assemble(State &rest)
    {
      EvaluationResults results = results_at(rest);
      solver.assemble(Evaluation::equilibrium(rest, rest), results, {1, 0, 0});
      return results;
    }

    EvaluationResults results_at(State &at)
    {
      EvaluationResults results = equations.make_results();
      const State       before  = at;
      solver.residual(Evaluation::equilibrium(before, at), results);
      return results;
    }
  };

  SecondOrderEffect::SecondOrderEffect(const Equations &equations)
    : equations(equations)
  {}

  SecondOrderEffect::~SecondOrderEffect() = default;

  Work SecondOrderEffect::collect_effort()
  {
    return std::exchange(effort, Work());
  }

  const Equations *SecondOrderEffect::exact_equations()
  {
    if (is_impossible)
      return nullptr;
    try
      {
        if (!exact)
          exact = std::make_unique<Exact>(equations.model(), effort);
      }
    catch (const std::runtime_error &)
      {
        // Large rotations do not allow some supports.
        is_impossible = true;
        return nullptr;
      }
    return &exact->equations;
  }

  std::optional<SecondOrderChange>
  SecondOrderEffect::at(const State &state, const Vector &forces_by_turning)
  {
    if (exact_equations() == nullptr)
      return {};
    SecondOrderChange result;
    try
      {
        if (exact->factorize_under(state.displacement))
          if (const auto negative = exact->solver.new_negative_modes())
            result.is_unstable = negative->n > 0;
        if (result.is_unstable.value_or(true) && !exact->factorize_at_rest())
          return {};
      }
    catch (const std::runtime_error &)
      {
        // Loads are not finite at rest.
        is_impossible = true;
        return {};
      }
    const std::optional<double> relative =
      relative_change(state, forces_by_turning);
    if (!relative)
      return {};
    result.relative = *relative;
    return result;
  }

  std::optional<double> SecondOrderEffect::relative_change(const State  &state,
                                                           const Vector &forces)
  {
    const double largest =
                   largest_motion(equations.model(), state.displacement).first,
                 elastic = state.energies.strain() + state.energies.stored();
    if (largest == 0 || !(elastic > 0))
      return {};
    const Unknowns &unknowns = equations.unknowns();
    Vector          change(forces.size(), 0.);
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      if (unknowns.kinds[i] != UnknownKind::prescribed)
        change[i] = -forces[i];
    if (!exact->solver.solve(change))
      return {};
    double twice_energy = 0;
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      twice_energy -= forces[i] * change[i];
    twice_energy = std::max(0., unknowns.layout.sum(twice_energy));
    return std::max(largest_motion(equations.model(), change).first / largest,
                    std::sqrt(twice_energy / (2 * elastic)));
  }

  namespace
  {
    /**
     * Compression (SmallDisplacementError) of all struts below which nothing
     * buckles, as for a thousand struts in a row.
     */
    constexpr double negligible_compression = 1e-6;

    /**
     * Factor by which a motion outside the envelope is first enlarged.
     * @tuned judgement
     */
    constexpr double first_enlargement = 4;

    /** Number of motions inside the envelope that a run checks. */
    constexpr double n_regular_checks = 4;

    /**
     * Known error inside the envelope, over the allowed one, below which no
     * new check is needed.
     * @tuned judgement: a motion of another shape may have a larger error
     */
    constexpr double small_error_fraction = 0.3;

    /**
     * Multiples of the static response that the decision is based on: in
     * dynamics the overshoot of a sudden load, in statics a margin for
     * round-off.
     */
    constexpr double dynamic_factor = 2, static_factor = 1.01;

    /** The path of a vibration is four amplitudes in a phase of 2 pi. */
    constexpr double phase_per_path_length = dealii::numbers::PI / 2;
  } // namespace

  SmallDisplacementLimit::SmallDisplacementLimit(const Equations &small,
                                                 const Equations &exact)
    : plan(exact.model().plan)
    , small(small)
    , layout(small.unknowns().layout)
    , has_inertia(small.model().plan.simulated.inertia)
    , estimator(small, exact, plan.effects.tolerance)
    , estimate(small)
  {
    envelope.compressions.resize(estimate.struts().size());
    if (const auto *const contact = exact.reporting().strut_contact)
      detector = contact->first_contact_detector();
    if (small.model().plan.simulated.plasticity)
      return;
    for (const Section &section : exact.model().sections)
      yield_limits.push_back({section.yields()
                                ? *section.law->yield_strain()
                                : std::numeric_limits<double>::infinity(),
                              section.outer_fibres});
  }

  LargeRotationError SmallDisplacementLimit::check_static_answer()
  {
    const std::optional<State> answer = estimator.static_answer();
    if (!answer)
      return {};
    const double factor = has_inertia ? dynamic_factor : static_factor;
    Vector       motion = answer->displacement;
    scale(factor, motion);
    const LargeRotationError estimated = estimator.at(motion);
    const double             size      = estimator.size(answer->displacement);
    if (estimated.reason(plan.effects.tolerance).empty())
      extend(factor,
             size,
             estimate.at(*answer),
             estimated.relative * factor * size);
    return estimated;
  }

  bool SmallDisplacementLimit::envelope_contains(
    const double                  size,
    const SmallDisplacementError &motion) const
  {
    if (!(size <= envelope.size && motion.total() <= envelope.total &&
          motion.compression <= envelope.compression))
      return false;
    bool mine = true;
    for (std::size_t i = 0; i < envelope.compressions.size() && mine; ++i)
      mine = motion.compressions[i] <=
        std::max(envelope.compressions[i], noticeable_fraction);
    return layout.largest(mine ? 0. : 1.) == 0;
  }

  void SmallDisplacementLimit::extend(const double                  factor,
                                      const double                  size,
                                      const SmallDisplacementError &motion,
                                      const double                  error)
  {
    envelope = {factor * size,
                factor * motion.total(),
                factor * std::max(motion.compression, negligible_compression),
                motion.compressions,
                error};
    for (double &compression : envelope.compressions)
      compression *= factor;
  }

  std::string
  SmallDisplacementLimit::yielding(const State             &state,
                                   const EvaluationResults &results) const
  {
    if (yield_limits.empty())
      return "";
    double largest = 1;
    for (const StrutGroup &group : small.reporting().struts)
      largest =
        std::max(largest,
                 group.forces
                   ->largest_strain(state,
                                    *results.effect_caches[group.effect],
                                    yield_limits,
                                    largest)
                   .ratio);
    largest = layout.largest(largest);
    if (!(largest > 1))
      return "";
    std::ostringstream text;
    text.precision(3);
    text << "a strut yields: its strain is " << largest
         << " times that at yield";
    return text.str();
  }

  void SmallDisplacementLimit::check(const Evaluation        &step,
                                     const EvaluationResults &results)
  {
    const State &state = step.to;
    std::string  reason_text;
    if (const auto struts =
          detector ? detector->find(step.from, state) : std::nullopt)
      reason_text = "struts " + std::to_string((*struts)[0]) + " and " +
        std::to_string((*struts)[1]) + " touch";
    else if (++n_steps >= SamplingSchedule::longest_period || !has_inertia ||
             state.time >= plan.time.end_time)
      {
        n_steps     = 0;
        reason_text = reason(state);
      }
    if (reason_text.empty())
      reason_text = yielding(state, results);
    if (reason_text.empty())
      return;
    std::ostringstream text;
    text << reason_text << " (t = " << state.time << " s)";
    throw SmallDisplacementLimitExceeded(text.str());
  }

  std::string SmallDisplacementLimit::reason(const State &state)
  {
    if (has_inertia)
      path_length +=
        (state.time - sampled_time) * estimator.size(*state.velocity);
    sampled_time                        = state.time;
    const double size                   = estimator.size(state.displacement);
    largest_size                        = std::max(largest_size, size);
    const SmallDisplacementError motion = estimate.at(state);
    const double                 known =
      size > 0 ? envelope.error * std::pow(size / envelope.size, 2) : 0.;
    std::string reason_text;
    if (!envelope_contains(size, motion))
      {
        reason_text = compute(first_enlargement, state, size, motion);
        if (!reason_text.empty())
          reason_text = compute(growth_between_checks, state, size, motion);
      }
    else if (state.time - last_error_time <
               plan.time.end_time / n_regular_checks ||
             known <=
               small_error_fraction * plan.effects.tolerance * largest_size)
      largest_error = std::max(largest_error, known);
    else
      reason_text = compute(growth_between_checks, state, size, motion);
    if (reason_text.empty() && error() > plan.effects.tolerance)
      reason_text = small_displacement_error_text(error()) +
        ", as vibrations get out of phase";
    return reason_text;
  }

  std::string
  SmallDisplacementLimit::compute(const double                  factor,
                                  const State                  &state,
                                  const double                  size,
                                  const SmallDisplacementError &motion)
  {
    Vector multiple = state.displacement;
    scale(factor, multiple);
    LargeRotationError estimated = estimator.at(multiple);
    estimated.relative *= size / largest_size;
    std::string reason_text = estimated.reason(plan.effects.tolerance);
    if (!reason_text.empty())
      return reason_text;
    last_error_time = state.time;
    largest_error =
      std::max(largest_error, estimated.relative * largest_size / factor);
    if (factor * size >= envelope.size || !envelope_contains(size, motion))
      extend(factor, size, motion, estimated.relative * factor * largest_size);
    return "";
  }

  double SmallDisplacementLimit::error() const
  {
    if (largest_size == 0)
      return 0;
    const double phase =
      std::max(0., path_length / largest_size - 1) * phase_per_path_length;
    return (1 + phase / 2) * largest_error / largest_size;
  }

  void SmallDisplacementLimit::serialize(CheckpointArchive &archive)
  {
    archive.values("limit of small displacements",
                   largest_error,
                   largest_size,
                   path_length,
                   sampled_time,
                   last_error_time,
                   n_steps,
                   envelope.size,
                   envelope.total,
                   envelope.compression,
                   envelope.error);
    archive.items("limit of small displacements by strut",
                  estimate.struts(),
                  1,
                  envelope.compressions);
  }
} // namespace auxfem
