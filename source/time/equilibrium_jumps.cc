#include <auxfem/model/unknown_records.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/time/equilibrium_jumps.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Distance of an equilibrium from the tangent's prediction, over the
     * prediction or the last step, above which it may be a jump.
     * @tuned judgement: the last long steps before a limit point reach it and
     *   are halved
     */
    constexpr double largest_deviation = 2;

    /**
     * The same for the first step, which has no previous one. A path of
     * constant curvature reaches it after turning by about one radian.
     */
    constexpr double largest_first_deviation = 0.5;

    /** Part of the total motion below which a deviation is no jump. */
    constexpr double negligible_motion = 1e-3;

    /**
     * Part of the scene's step at which a motion that has not shrunk is a
     * jump.
     * @tuned judgement: a connected motion has shrunk to a quarter or less
     *   there
     */
    constexpr double shortest_part = 1. / 64;

    /**
     * Smallest ratio of motions that indicates a jump, for steps whose lengths
     * have this @p ratio. On a connected path motions shrink at least with its
     * square root, as at a limit point.
     */
    double unshrunk_motion(const double ratio)
    {
      return std::cbrt(ratio);
    }

    /** Part of the prediction in half a step above which the loads jump. */
    constexpr double unshrunk_prediction = 0.75;
  } // namespace

  EquilibriumJumps::EquilibriumJumps(const LatticeModel &model) : model(model)
  {}

  std::string EquilibriumJumps::rejection_reason(const Evaluation &step,
                                                 const Vector     &predicted,
                                                 const bool changes_stability)
  {
    candidate.reset();
    const auto largest = [this](const Vector &vector) {
      return largest_motion(model, vector).first;
    };
    const State &from   = step.from;
    Vector       motion = step.to.displacement;
    add_multiple(-1., from.displacement, motion);
    const double size = largest(motion), predicted_size = largest(predicted);
    Vector       difference = motion;
    add_multiple(-1., predicted, difference);
    const double deviation = largest(difference);
    double       expected  = predicted_size;
    if (from.before)
      {
        Vector before = from.displacement;
        add_multiple(-1., from.before->displacement, before);
        expected =
          std::min(expected, step.dt / from.before->dt * largest(before));
      }
    const bool is_notable =
      deviation > negligible_motion * largest(step.to.displacement);
    const bool is_far = is_notable && deviation > largest_deviation * expected;
    const bool is_first_and_far = is_notable && !from.before &&
      deviation > largest_first_deviation * expected;
    if (!is_far && !is_first_and_far && !changes_stability)
      return "";
    const bool follows_load_jump = last_rejected &&
      last_rejected->time == from.time &&
      predicted_size > unshrunk_prediction * last_rejected->predicted;
    // A jump can only be judged against a longer step.
    const bool is_shortest = largest_rejected &&
      step.dt <= (1 + 1e-9) * shortest_part * model.plan.time.step;
    if (!allows_jumps && !is_shortest && !follows_load_jump)
      {
        if (!largest_rejected || size > largest_rejected->size)
          largest_rejected = {step.dt, size};
        last_rejected = {from.time, predicted_size};
        if (is_far)
          rejected_end = step.to;
        return is_far || is_first_and_far
          ? "the equilibrium lies far from the predicted one"
          : "the stability changes within the step";
      }
    const auto is_unshrunk = [&]() {
      return size > largest_rejected->size *
        unshrunk_motion(step.dt / largest_rejected->dt);
    };
    if (is_far && !follows_load_jump && (allows_jumps || is_unshrunk()))
      {
        std::vector<double> sizes(model.numbering.layout().n_owned(), 0.);
        for (unsigned int i = 0; i < sizes.size(); ++i)
          if (!model.numbering.unknowns().is_rotation[i])
            sizes[i] = std::abs(motion[i]);
        candidate = {from.time,
                     step.to.time,
                     size,
                     describe_largest(model.numbering, sizes)};
      }
    return "";
  }

  bool EquilibriumJumps::allow_jumps()
  {
    if (!rejected_end || allows_jumps)
      return false;
    allows_jumps = true;
    return true;
  }

  double EquilibriumJumps::target(const double time) const
  {
    return allows_jumps && rejected_end ? std::min(time, rejected_end->time)
                                        : time;
  }

  bool EquilibriumJumps::extrapolate(const Evaluation    &step,
                                     const NodeRotations &rotations,
                                     Vector              &increment) const
  {
    if (!allows_jumps || !rejected_end || rejected_end->time != step.to.time)
      return false;
    increment = rejected_end->displacement;
    add_multiple(-1., step.to.displacement, increment);
    for (unsigned int i = 0; i < rejected_end->rotations.size(); ++i)
      rotations.set_values(rotation_vector(rejected_end->rotations[i] *
                                           conjugate(step.to.rotations[i])),
                           i,
                           increment);
    rotations.rotate(step, increment);
    return true;
  }

  void EquilibriumJumps::step(const Evaluation & /*step*/,
                              const EvaluationResults & /*results*/,
                              TangentSolver & /*solver*/)
  {
    if (allows_jumps)
      rejected_end.reset();
    if (!candidate)
      return;
    ++n_jumps;
    if (!first)
      first = candidate;
  }

  std::vector<Finding> EquilibriumJumps::findings() const
  {
    if (!first)
      return {};
    std::ostringstream text;
    text.precision(3);
    const std::string loads = load_values_text(model.plan, first->time);
    text << "The equilibrium jumps between t = " << first->time << " s and "
         << first->end << " s" << (loads.empty() ? "" : " (" + loads + ")")
         << " by " << first->size << " m, largest at the " << first->location;
    if (n_jumps > 1)
      text << ", and " << n_jumps - 1 << " more times later";
    text
      << ". No shorter step follows a connected path: it ends in a limit "
         "point (snap-through), and the new equilibrium is one of several. "
         "Compute with inertia, prescribe a motion in place of the force, or "
         "follow the path with `Analysis = static path`.";
    return {{Verdict::doubtful, text.str(), first->time, first->location}};
  }

  void EquilibriumJumps::serialize(CheckpointArchive &archive)
  {
    Jump jump = first.value_or(Jump());
    archive.values("equilibrium jumps",
                   n_jumps,
                   jump.time,
                   jump.end,
                   jump.size);
    archive.text("equilibrium jumps: location", jump.location);
    if (n_jumps > 0)
      first = jump;
  }
} // namespace auxfem
