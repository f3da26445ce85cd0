#include <auxfem/analysis/sampling_schedule.h>
#include <auxfem/analysis/small_displacement_limit.h>
#include <auxfem/equations/effects/contact.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Compression (SmallDisplacementError) of all struts by which nothing
     * buckles: that of a thousand struts in a row. */
    constexpr double no_compression = 1e-6;

    /**
     * Multiple of a motion outside the envelope that is computed first.
     * @tuned judgement
     */
    constexpr double far_ahead = 4;

    /** Motions inside the envelope that are computed in a run. */
    constexpr double n_regular_checks = 4;

    /**
     * Known error of a motion inside the envelope, over the allowed one, up
     * to which it is not computed.
     * @tuned judgement: a motion of another shape may have a larger error
     */
    constexpr double little_error = 0.3;

    /** Multiples of the static answer that the decision is made for: in
     * dynamics the overshoot of a sudden load, in statics room for round-off.
     */
    constexpr double dynamic_factor = 2, static_factor = 1.01;

    /** A vibration goes four amplitudes while it turns by 2 pi. */
    constexpr double radians_of_way = dealii::numbers::PI / 2;
  } // namespace

  SmallDisplacementLimit::SmallDisplacementLimit(const Equations &small,
                                                 const Equations &exact)
    : plan(exact.model().plan)
    , layout(small.unknowns().layout)
    , has_inertia(small.model().plan.simulated.inertia)
    , estimator(small, exact, plan.effects.tolerance)
    , estimate(small)
  {
    envelope.compressions.resize(estimate.struts().size());
    if (const auto *const contact = exact.reporting().strut_contact)
      detector = contact->first_contact_detector();
  }

  LargeRotationError SmallDisplacementLimit::check_static_answer()
  {
    const std::optional<State> answer = estimator.static_answer();
    if (!answer)
      return {};
    const double factor = has_inertia ? dynamic_factor : static_factor;
    Vector       motion = answer->displacement;
    scale(factor, motion);
    const LargeRotationError found = estimator.at(motion);
    const double             size  = estimator.size(answer->displacement);
    if (found.reason(plan.effects.tolerance).empty())
      extend(factor,
             size,
             estimate.at(*answer),
             found.relative * factor * size);
    return found;
  }

  bool
  SmallDisplacementLimit::is_inside(const double                  size,
                                    const SmallDisplacementError &motion) const
  {
    if (!(size <= envelope.size && motion.total() <= envelope.total &&
          motion.compression <= envelope.compression))
      return false;
    bool mine = true;
    for (std::size_t i = 0; i < envelope.compressions.size() && mine; ++i)
      mine = motion.compressions[i] <=
        std::max(envelope.compressions[i], noticeable_part);
    return layout.largest(mine ? 0. : 1.) == 0;
  }

  void SmallDisplacementLimit::extend(const double                  factor,
                                      const double                  size,
                                      const SmallDisplacementError &motion,
                                      const double                  error)
  {
    envelope = {factor * size,
                factor * motion.total(),
                factor * std::max(motion.compression, no_compression),
                motion.compressions,
                error};
    for (double &compression : envelope.compressions)
      compression *= factor;
  }

  void SmallDisplacementLimit::check(const Evaluation &step)
  {
    const State &state = step.to;
    std::string  why;
    if (const auto struts =
          detector ? detector->find(step.from, state) : std::nullopt)
      why = "struts " + std::to_string((*struts)[0]) + " and " +
        std::to_string((*struts)[1]) + " touch";
    else if (++n_steps >= SamplingSchedule::longest_period || !has_inertia ||
             state.time >= plan.time.end_time)
      {
        n_steps = 0;
        why     = reason(state);
      }
    if (why.empty())
      return;
    std::ostringstream text;
    text << why << " (t = " << state.time << " s)";
    throw BeyondSmallDisplacements(text.str());
  }

  std::string SmallDisplacementLimit::reason(const State &state)
  {
    if (has_inertia)
      way += (state.time - sampled) * estimator.size(*state.velocity);
    sampled                             = state.time;
    const double size                   = estimator.size(state.displacement);
    largest_size                        = std::max(largest_size, size);
    const SmallDisplacementError motion = estimate.at(state);
    const double                 known =
      size > 0 ? envelope.error * std::pow(size / envelope.size, 2) : 0.;
    std::string why;
    if (!is_inside(size, motion))
      {
        why = compute(far_ahead, state, size, motion);
        if (!why.empty())
          why = compute(growth_between_checks, state, size, motion);
      }
    else if (state.time - computed < plan.time.end_time / n_regular_checks ||
             known <= little_error * plan.effects.tolerance * largest_size)
      largest_error = std::max(largest_error, known);
    else
      why = compute(growth_between_checks, state, size, motion);
    if (why.empty() && error() > plan.effects.tolerance)
      why = small_displacement_error_text(error()) +
        ", as vibrations get out of phase";
    return why;
  }

  std::string
  SmallDisplacementLimit::compute(const double                  factor,
                                  const State                  &state,
                                  const double                  size,
                                  const SmallDisplacementError &motion)
  {
    Vector multiple = state.displacement;
    scale(factor, multiple);
    LargeRotationError found = estimator.at(multiple);
    found.relative *= size / largest_size;
    std::string why = found.reason(plan.effects.tolerance);
    if (!why.empty())
      return why;
    computed = state.time;
    largest_error =
      std::max(largest_error, found.relative * largest_size / factor);
    if (factor * size >= envelope.size || !is_inside(size, motion))
      extend(factor, size, motion, found.relative * factor * largest_size);
    return "";
  }

  double SmallDisplacementLimit::error() const
  {
    if (largest_size == 0)
      return 0;
    const double turns = std::max(0., way / largest_size - 1) * radians_of_way;
    return (1 + turns / 2) * largest_error / largest_size;
  }

  void SmallDisplacementLimit::serialize(CheckpointArchive &archive)
  {
    archive.values("limit of small displacements",
                   largest_error,
                   largest_size,
                   way,
                   sampled,
                   computed,
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
