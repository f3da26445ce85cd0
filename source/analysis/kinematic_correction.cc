#include <auxfem/algebra/row_sums.h>
#include <auxfem/analysis/kinematic_correction.h>
#include <auxfem/equations/prescribed_motion.h>
#include <auxfem/model/unknown_names.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/step_ends.h>

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
    constexpr unsigned int most_iterations = 8;

    /** No correction is found, nor needed to know, beyond (rad). */
    constexpr double small_angle = 0.15;

    /** The error is wanted to a tenth of itself, or a hundredth of what is
     * allowed. */
    constexpr double accuracy = 0.1, accuracy_of_tolerance = 0.01;

    /** Of the change by the iteration before, with a factorization that still
     * serves; with that at rest of the one before the last: a bent strut seems
     * to be stretched, which is made good one iteration later. */
    constexpr double kept_reduction = 0.3, reduction_at_rest = 0.1;

    /** What is stable at so many times a motion is trusted to be so up to so
     * many. */
    constexpr double ahead = 8, trusted = 4;

    /** By what a motion is larger than those before for a look between others,
     * and for its stability to be looked at where that is not known ahead. */
    constexpr double larger = 1.25;

    /** Part of what is allowed: below it an error is little, and which it is
     * taken for at least. */
    constexpr double little = 0.3, least_known = 0.01;

    /** A vibration goes four amplitudes while it turns by 2 pi. */
    constexpr double radians_of_way = dealii::numbers::PI / 2;

    /** Root mean square (m), as KinematicCorrection. */
    double size_of(const LatticeModel &model, const Vector &motion)
    {
      const OwnedRows          &rows   = model.rows;
      const double              length = model.mean_strut_length;
      const std::vector<double> all    = model.numbering.layout().sum(
        {sum_of_squares(motion.data(), rows.free_translations) +
              length * length * sum_of_squares(motion.data(), rows.free_rotations),
            double(rows.free_translations.size() + rows.free_rotations.size())});
      return all[1] > 0 ? std::sqrt(all[0] / all[1]) : 0;
    }

    Evaluation
    equilibrium_at(const TimeLimit &time, const State &before, State &now)
    {
      now.time               = time.time;
      Evaluation evaluation  = Evaluation::equilibrium(before, now);
      evaluation.event_at_to = time;
      return evaluation;
    }

    const std::string correction_record = "error of small displacements",
                      error_record      = correction_record + ", by unknown";

    /** Times at which loads are looked at. */
    std::vector<TimeLimit> times_of_loads(const Scene &scene)
    {
      constexpr unsigned int n_times = 4, n_events = 8;
      std::vector<TimeLimit> times;
      for (unsigned int i = 1; i <= n_times; ++i)
        times.push_back({scene.time.end_time * i / n_times, TimeSide::before});
      const std::vector<StepEnd> ends = step_ends(scene);
      for (std::size_t i = 0; i < ends.size() && i < n_events; ++i)
        if (ends[i].time < scene.time.end_time)
          for (const TimeSide side : {TimeSide::before, TimeSide::after})
            times.push_back({ends[i].time, side});
      return times;
    }
  } // namespace

  KinematicCorrection::KinematicCorrection(const Scene   &scene,
                                           TangentSolver &exact)
    : scene(scene)
    , has_follower_loads(std::any_of(scene.joint_loads.begin(),
                                     scene.joint_loads.end(),
                                     [](const JointLoadDefinition &load) {
                                       return load.follows_joint;
                                     }))
    , solver(exact)
    , rotations(exact.model().numbering)
    , inertia(scene.time.scheme->is_dynamic()
                ? std::pow(2 / scene.time.end_time, 2)
                : 0.)
    , stiffness(exact, inertia)
    , of_exact(scene, exact.equations())
    , stable(of_exact, exact.model().numbering.layout())
  {
    begin_anew();
  }

  void KinematicCorrection::begin_anew()
  {
    const Equations &equations = solver.equations();
    worst                      = {};
    error.assign(solver.model().numbering.layout().n_local(), 0.);
    watches.clear();
    if (equations.reporting().struts.empty())
      return;
    watches.push_back(make_strain_watch(equations));
    if (!scene.lattice.struts_may_cross)
      watches.push_back(make_crossing_watch(scene, equations));
    const State beginning = equations.initial_state();
    for (const auto &watch : watches)
      watch->start(beginning);
  }

  State KinematicCorrection::exact_state(const State &motion,
                                         const double times) const
  {
    State exact        = stiffness.at_rest();
    exact.time         = motion.time;
    exact.path         = motion.path;
    exact.displacement = motion.displacement;
    exact.velocity     = motion.velocity;
    exact.acceleration = motion.acceleration;
    // Springs between large rotations have internal variables that those
    // between small ones lack; they follow from the rotations.
    copy_common(
      (small != nullptr ? *small : solver.equations()).layout().history,
      motion.history,
      solver.equations().layout().history,
      exact.history);
    // It goes with the square of the motion.
    add_multiple(times, error, exact.displacement);
    if (exact.acceleration)
      add_multiple(times * inertia, error, *exact.acceleration);
    scale(times, exact.displacement);
    scale(times, exact.history);
    for (std::optional<Vector> *rates : {&exact.velocity, &exact.acceleration})
      if (*rates)
        scale(times, **rates);
    for (unsigned int i = 0; i < exact.rotations.size(); ++i)
      exact.rotations[i] = exponential(rotations.values(exact.displacement, i));
    for (std::optional<Vector> *rates : {&exact.velocity, &exact.acceleration})
      if (*rates)
        rotations.make_material(exact, **rates);
    return exact;
  }

  template <class EvaluationOf>
  void KinematicCorrection::find(const State        &motion,
                                 const EvaluationOf &evaluation_of,
                                 const Vector       &left)
  {
    const LatticeModel &model = solver.model();
    const double        size  = size_of(model, motion.displacement);
    worst.largest_motion      = std::max(worst.largest_motion, size);
    worst.largest_rotation =
      std::max(worst.largest_rotation,
               auxfem::largest_motion(model, motion.displacement).second);
    if (!(worst.largest_rotation < small_angle))
      return;
    const Vector guess = error;
    bool         found = stiffness.take_that_of_rest() &&
      converge(motion, size, evaluation_of, left);
    if (!found)
      {
        error = guess;
        stiffness.forget();
        found = converge(motion, size, evaluation_of, left);
      }
    worst.largest_error =
      std::max(worst.largest_error,
               found ? size_of(model, error)
                     : std::numeric_limits<double>::infinity());
  }

  template <class EvaluationOf>
  bool KinematicCorrection::converge(const State        &motion,
                                     const double        size,
                                     const EvaluationOf &evaluation_of,
                                     const Vector       &left)
  {
    const LatticeModel &model      = solver.model();
    const bool          is_of_rest = stiffness.is_of_rest();
    EvaluationResults   results    = solver.equations().make_results();
    // Of the error, in the last iteration and the one before it.
    double last = std::numeric_limits<double>::infinity(), before_last = last;
    for (unsigned int i = 0; i < most_iterations; ++i)
      {
        State            exact      = exact_state(motion, 1);
        const State      start      = exact;
        const Evaluation evaluation = evaluation_of(start, exact);
        solver.residual(evaluation, results);
        Vector change = right_side(exact, left);
        if ((!is_of_rest && !stiffness.is_of_another() &&
             !stiffness.factorize(evaluation, results)) ||
            !solver.solve(change))
          return false;
        add_multiple(1., change, error);
        const double size_of_change = size_of(model, change);
        if (size_of_change <=
            std::max(accuracy * size_of(model, error),
                     accuracy_of_tolerance * scene.effects.tolerance * size))
          {
            for (const auto &watch : watches)
              watch->step(evaluation, results, solver);
            judge_stability(motion, size, of_exact.at(exact), evaluation_of);
            return true;
          }
        if (is_of_rest && !(size_of_change <= reduction_at_rest * before_last))
          return false;
        if (!is_of_rest && !(size_of_change <= kept_reduction * last))
          stiffness.forget();
        before_last = std::exchange(last, size_of_change);
      }
    return false;
  }

  template <class EvaluationOf>
  void KinematicCorrection::judge_stability(const State &motion,
                                            const double size,
                                            const SmallDisplacementError &now,
                                            const EvaluationOf &evaluation_of)
  {
    if (stable.have(size, now))
      return;
    const auto is_positive = [&](const double times) {
      State       exact = exact_state(motion, times);
      const State start = exact;
      return stiffness.is_positive(evaluation_of(start, exact));
    };
    double until = trusted;
    // The stiffness of follower loads is that of the loads of the moment.
    std::optional<bool> positive =
      has_follower_loads ? std::nullopt : is_positive(ahead);
    if (!positive.value_or(false))
      {
        until    = larger;
        positive = is_positive(1);
      }
    worst.unstable = worst.unstable || !positive.value_or(true);
    stable.trust(until, size, now);
  }

  Vector KinematicCorrection::right_side(const State  &exact,
                                         const Vector &left) const
  {
    const DofNumbering &numbering = solver.model().numbering;
    Vector              values(exact.displacement.size(), 0.);
    for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
      if (numbering.unknowns().kinds[i] != UnknownKind::prescribed)
        values[i] = left[i] - exact.residual[i];
    return values;
  }

  void KinematicCorrection::look_at_loads()
  {
    TimeLimit             largest{};
    std::optional<Vector> motion;
    double                size = 0;
    for (const TimeLimit &time : times_of_loads(scene))
      {
        std::optional<Vector> candidate = linear_answer(time);
        const double          of_candidate =
          candidate ? size_of(solver.model(), *candidate) : 0.;
        if (!(of_candidate > size))
          continue;
        size    = of_candidate;
        largest = time;
        std::swap(motion, candidate);
      }
    if (!motion)
      return;
    State small        = stiffness.at_rest();
    small.displacement = *motion;
    if (small.acceleration)
      add_multiple(inertia, *motion, *small.acceleration);
    find(
      small,
      [&largest](const State &before, State &now) {
        return equilibrium_at(largest, before, now);
      },
      Vector(motion->size(), 0.));
    stiffness.end_look();
  }

  std::optional<Vector>
  KinematicCorrection::linear_answer(const TimeLimit &time)
  {
    const State       rest       = stiffness.at_rest();
    State             loaded     = rest;
    EvaluationResults results    = solver.equations().make_results();
    const Evaluation  evaluation = equilibrium_at(time, rest, loaded);
    Vector            motion(loaded.displacement.size(), 0.);
    try
      {
        solver.residual(evaluation, results);
        find_right_side(solver.model(), evaluation, motion.data());
      }
    catch (const ComputationError &)
      {
        // A load that is no number: the run will tell when it gets there.
        return {};
      }
    if (!stiffness.take_that_of_rest() || !solver.solve(motion))
      return {};
    return motion;
  }

  void KinematicCorrection::begin(const Equations &small)
  {
    begin_anew();
    this->small = &small;
    estimate.emplace(scene, small);
  }

  bool KinematicCorrection::asks_for_look(const State &state)
  {
    if (++n_steps < SmallDisplacementEstimate::distance_in_motion &&
        state.velocity)
      return false;
    n_steps = 0;
    add_way(state);
    const SmallDisplacementError &now = estimate_at(state);
    if (size_of_motion == 0)
      return now.total() > little * scene.effects.tolerance ||
        now.compression > StableMotions::little_compression;
    const double size = size_of(solver.model(), state.displacement);
    return !stable.have(size, now) ||
      (growth(size, now) > larger && !is_known_little(size, now));
  }

  double KinematicCorrection::growth(const double                  size,
                                     const SmallDisplacementError &now) const
  {
    return std::max({1.,
                     size / worst.largest_motion,
                     now.total() <= estimated ? 1. : now.total() / estimated});
  }

  bool
  KinematicCorrection::is_known_little(const double                  size,
                                       const SmallDisplacementError &now) const
  {
    const double tolerance = scene.effects.tolerance;
    return std::max(relative(), least_known * tolerance) * growth(size, now) <=
      little * tolerance;
  }

  void KinematicCorrection::look_at(const State &state)
  {
    const auto evaluation_of = [](const State &before, State &now) {
      return now.velocity ? Evaluation::rates(before, now)
                          : Evaluation::equilibrium(before, now);
    };
    add_way(state);
    const double size = size_of(solver.model(), state.displacement);
    const SmallDisplacementError &now = estimate_at(state);
    if (size_of_motion > 0 && stable.have(size, now) &&
        is_known_little(size, now))
      return;
    estimated = std::max(estimated, now.total());
    Vector left;
    {
      State             linear  = state;
      EvaluationResults results = small->make_results();
      small->residual(evaluation_of(state, linear), results);
      left = std::move(linear.residual);
    }
    grow_error(size);
    find(state, evaluation_of, left);
    stiffness.end_look();
  }

  void KinematicCorrection::add_way(const State &state)
  {
    if (state.velocity)
      way += (state.time - time) * size_of(solver.model(), *state.velocity);
    time = state.time;
  }

  const SmallDisplacementError &
  KinematicCorrection::estimate_at(const State &state)
  {
    if (!known_estimate || known_estimate->first != state.time)
      known_estimate.emplace(state.time, estimate->at(state));
    return known_estimate->second;
  }

  void KinematicCorrection::grow_error(const double size)
  {
    // It goes with the square of the motion at least.
    const double part = size_of_motion > 0
      ? std::min(1., std::pow(size / size_of_motion, 2))
      : 0.;
    scale(part, error);
    size_of_motion = size;
  }

  double KinematicCorrection::relative() const
  {
    if (worst.largest_error == 0)
      return 0;
    const double turns = inertia > 0
      ? std::max(0., way / worst.largest_motion - 1) * radians_of_way
      : 0.;
    return (1 + turns / 2) * worst.largest_error / worst.largest_motion;
  }

  std::string KinematicCorrection::why_exact(const double allowed) const
  {
    std::ostringstream why;
    why.precision(2);
    if (!(worst.largest_rotation * worst.largest_rotation / 2 <= allowed))
      why << "rotations reach " << worst.largest_rotation << " rad";
    else if (!std::isfinite(worst.largest_error))
      why << "no equilibrium of exact kinematics is near";
    else if (relative() > allowed)
      why << "small displacements are wrong by " << relative() << ", most the "
          << location();
    else if (worst.unstable)
      why << "a stiffness is not positive";
    else
      for (const auto &watch : watches)
        for (const Finding &finding : watch->findings())
          return finding.text;
    return why.str();
  }

  void KinematicCorrection::save(Records &records) const
  {
    records.keep(correction_record,
                 {worst.largest_error,
                  worst.largest_motion,
                  worst.largest_rotation,
                  size_of_motion,
                  way,
                  time,
                  worst.unstable ? 1. : 0.,
                  estimated,
                  double(n_steps)});
    stable.save(records);
    UnknownRecords(solver.model().numbering).keep(error_record, error, records);
    stiffness.save(records);
    Records of_watches;
    for (const auto &watch : watches)
      watch->save(of_watches);
    records.keep_all(correction_record, std::move(of_watches));
  }

  void KinematicCorrection::resume(const Records &records)
  {
    const std::vector<double> values = records.values(correction_record, 9);
    worst.largest_error              = values[0];
    worst.largest_motion             = values[1];
    worst.largest_rotation           = values[2];
    size_of_motion                   = values[3];
    way                              = values[4];
    time                             = values[5];
    worst.unstable                   = values[6] != 0;
    estimated                        = values[7];
    n_steps                          = values[8];
    stable.resume(records);
    error =
      UnknownRecords(solver.model().numbering).values(error_record, records);
    stiffness.resume(records);
    const Records of_watches = records.all_of(correction_record);
    for (const auto &watch : watches)
      watch->resume(of_watches);
  }

  std::string KinematicCorrection::location() const
  {
    const DofNumbering &numbering = solver.model().numbering;
    std::vector<double> sizes(numbering.layout().n_owned());
    for (unsigned int i = 0; i < sizes.size(); ++i)
      sizes[i] = std::abs(error[i]) *
        (numbering.unknowns().is_rotation[i] ? solver.model().mean_strut_length
                                             : 1.);
    return describe_largest(numbering, sizes);
  }
} // namespace auxfem
