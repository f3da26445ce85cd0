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
     * serves. */
    constexpr double kept_reduction = 0.3;

    /** Of the error, by which it may still change for its stiffness to tell
     * whether a state is stable. */
    constexpr double near = 0.5;

    /** Looks are for motions that are larger than all before by a quarter,
     * unless little is missing. */
    constexpr double larger = 1.25, little = 0.3;

    /** Part of what is allowed that an error is taken for at least. */
    constexpr double least_known = 0.01;

    /** A vibration goes four amplitudes while it turns by 2 pi. */
    constexpr double radians_of_way = dealii::numbers::PI / 2;

    /** Root mean square (m), as KinematicCorrection. */
    double size_of(const LatticeModel &model, const Vector &motion)
    {
      const OwnedRows &rows   = model.rows;
      const double     length = model.mean_strut_length;
      double           sum    = 0;
      for (const int i : rows.free_translations)
        sum += motion[i] * motion[i];
      for (const int i : rows.free_rotations)
        sum += std::pow(length * motion[i], 2);
      const std::vector<double> all = model.numbering.layout().sum(
        {sum,
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
                      error_record      = correction_record + ", by unknown",
                      stiffness_record  = correction_record + ", stiffness";

    /** Times at which loads are looked at. */
    std::vector<TimeLimit> times_of_loads(const Scene &scene)
    {
      constexpr unsigned int n_times = 4, n_events = 8;
      std::vector<TimeLimit> times;
      for (unsigned int i = 1; i <= n_times; ++i)
        times.push_back({scene.time.end_time * i / n_times, TimeSide::before});
      const std::vector<StepEnd> ends = step_ends(scene);
      for (std::size_t i = 0; i < ends.size() && i < n_events; ++i)
        for (const TimeSide side : {TimeSide::before, TimeSide::after})
          times.push_back({ends[i].time, side});
      return times;
    }
  } // namespace

  KinematicCorrection::KinematicCorrection(const Scene   &scene,
                                           TangentSolver &exact)
    : scene(scene)
    , solver(exact)
    , rotations(exact.model().numbering)
    , inertia(scene.time.scheme->is_dynamic()
                ? std::pow(2 / scene.time.end_time, 2)
                : 0.)
    , error(exact.model().numbering.layout().n_local(), 0.)
  {
    const Equations &equations = exact.equations();
    if (!equations.reporting().struts.empty())
      {
        watches.push_back(make_strain_watch(equations));
        if (!scene.lattice.struts_may_cross)
          watches.push_back(make_crossing_watch(scene, equations));
      }
    if (watches.empty())
      return;
    const State beginning = equations.initial_state();
    for (const auto &watch : watches)
      watch->start(beginning);
  }

  State KinematicCorrection::at_rest() const
  {
    State rest = solver.equations().initial_state();
    for (std::optional<Vector> *rates : {&rest.velocity, &rest.acceleration})
      if (*rates)
        (*rates)->assign((*rates)->size(), 0.);
    return rest;
  }

  State KinematicCorrection::exact_state(const State &motion) const
  {
    State exact        = at_rest();
    exact.time         = motion.time;
    exact.path         = motion.path;
    exact.displacement = motion.displacement;
    exact.velocity     = motion.velocity;
    exact.acceleration = motion.acceleration;
    exact.history      = motion.history;
    add_multiple(1., error, exact.displacement);
    if (exact.acceleration)
      add_multiple(inertia, error, *exact.acceleration);
    for (unsigned int i = 0; i < exact.rotations.size(); ++i)
      exact.rotations[i] = exponential(rotations.values(exact.displacement, i));
    for (std::optional<Vector> *rates : {&exact.velocity, &exact.acceleration})
      if (*rates)
        rotations.make_material(exact, **rates);
    return exact;
  }

  bool KinematicCorrection::factorize(const Evaluation        &evaluation,
                                      const EvaluationResults &results)
  {
    solver.assemble(evaluation, results, {1., 0., inertia});
    // The symmetric part serves as well, for less, and has an inertia.
    is_factorized = solver.factorize(Exactness::approximate);
    return is_factorized;
  }

  template <class EvaluationOf>
  void KinematicCorrection::find(const State        &motion,
                                 const EvaluationOf &evaluation_of,
                                 const Vector       &left)
  {
    const LatticeModel &model  = solver.model();
    const double        size   = size_of(model, motion.displacement);
    double              before = std::numeric_limits<double>::infinity();
    // Since the factorization; that of a state at rest is far away.
    double            way_of_error = std::numeric_limits<double>::infinity();
    EvaluationResults results      = solver.equations().make_results();
    largest_motion                 = std::max(largest_motion, size);
    largest_rotation =
      std::max(largest_rotation,
               auxfem::largest_motion(model, motion.displacement).second);
    if (!(largest_rotation < small_angle))
      return;
    for (unsigned int i = 0; i < most_iterations; ++i)
      {
        State            exact      = exact_state(motion);
        const State      start      = exact;
        const Evaluation evaluation = evaluation_of(start, exact);
        solver.residual(evaluation, results);
        Vector change = right_side(exact, left);
        if (!is_factorized)
          {
            way_of_error = 0;
            if (!factorize(evaluation, results))
              break;
          }
        if (!solver.solve(change))
          break;
        add_multiple(1., change, error);
        const double size_of_change = size_of(model, change),
                     size_of_error  = size_of(model, error);
        way_of_error += size_of_change;
        if (size_of_change <=
            std::max(accuracy * size_of_error,
                     accuracy_of_tolerance * scene.effects.tolerance * size))
          {
            largest_error = std::max(largest_error, size_of_error);
            judge(evaluation, results, way_of_error <= near * size_of_error);
            return;
          }
        if (!(size_of_change <= kept_reduction * before))
          is_factorized = false;
        before = size_of_change;
      }
    is_factorized = false;
    largest_error = std::numeric_limits<double>::infinity();
  }

  void KinematicCorrection::judge(const Evaluation        &evaluation,
                                  const EvaluationResults &results,
                                  const bool               is_factorized_near)
  {
    for (const auto &watch : watches)
      watch->step(evaluation, results, solver);
    const auto on_the_way =
      is_factorized_near ? solver.new_negative_modes() : std::nullopt;
    if ((on_the_way && on_the_way->n == 0) || !factorize(evaluation, results))
      return;
    if (const auto modes = solver.new_negative_modes())
      unstable = unstable || modes->n > 0;
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
    State small        = at_rest();
    small.displacement = *motion;
    if (small.acceleration)
      add_multiple(inertia, *motion, *small.acceleration);
    find(
      small,
      [&largest](const State &before, State &now) {
        return equilibrium_at(largest, before, now);
      },
      Vector(motion->size(), 0.));
    forget_tangent();
  }

  std::optional<Vector>
  KinematicCorrection::linear_answer(const TimeLimit &time)
  {
    const State       rest       = at_rest();
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
    if ((!is_factorized && !factorize(evaluation, results)) ||
        !solver.solve(motion))
      return {};
    return motion;
  }

  void KinematicCorrection::begin(const Equations &small)
  {
    this->small = &small;
    estimate.emplace(scene, small);
  }

  bool KinematicCorrection::asks_for_look(const State &state)
  {
    if (++n_steps < SmallDisplacementEstimate::distance_in_motion &&
        state.velocity)
      return false;
    n_steps              = 0;
    const double allowed = little * scene.effects.tolerance,
                 now     = estimate->at(state).total();
    if (estimated == 0)
      return now > allowed;
    return now > larger * estimated &&
      std::max(relative(), least_known * scene.effects.tolerance) * now >
      allowed * estimated;
  }

  void KinematicCorrection::look_at(const State &state)
  {
    const auto evaluation_of = [](const State &before, State &now) {
      return now.velocity ? Evaluation::rates(before, now)
                          : Evaluation::equilibrium(before, now);
    };
    if (state.velocity)
      way += (state.time - time) * size_of(solver.model(), *state.velocity);
    time              = state.time;
    const double size = size_of(solver.model(), state.displacement),
                 now  = estimate->at(state).total();
    if (size <= larger * size_of_motion && now <= larger * estimated &&
        relative() <= little * scene.effects.tolerance)
      return;
    estimated = std::max(estimated, now);
    Vector left;
    {
      State             linear  = state;
      EvaluationResults results = small->make_results();
      small->residual(evaluation_of(state, linear), results);
      left = std::move(linear.residual);
    }
    grow_error(size);
    find(state, evaluation_of, left);
    forget_tangent();
  }

  void KinematicCorrection::forget_tangent()
  {
    is_factorized = false;
    solver.matrix().release();
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
    if (largest_error == 0)
      return 0;
    const double turns = inertia > 0
      ? std::max(0., way / largest_motion - 1) * radians_of_way
      : 0.;
    return (1 + turns / 2) * largest_error / largest_motion;
  }

  std::string KinematicCorrection::why_exact(const double allowed) const
  {
    std::ostringstream why;
    why.precision(2);
    if (!(largest_rotation * largest_rotation / 2 <= allowed))
      why << "rotations reach " << largest_rotation << " rad";
    else if (!std::isfinite(largest_error))
      why << "no equilibrium of exact kinematics is near";
    else if (relative() > allowed)
      why << "small displacements are wrong by " << relative() << ", most the "
          << location();
    else if (unstable)
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
                 {largest_error,
                  largest_motion,
                  largest_rotation,
                  size_of_motion,
                  way,
                  time,
                  unstable ? 1. : 0.,
                  estimated,
                  double(n_steps)});
    UnknownRecords(solver.model().numbering).keep(error_record, error, records);
    solver.save(stiffness_record, /*with_factorization=*/false, records);
    Records of_watches;
    for (const auto &watch : watches)
      watch->save(of_watches);
    records.keep_all(correction_record, std::move(of_watches));
  }

  void KinematicCorrection::resume(const Records &records)
  {
    const std::vector<double> values = records.values(correction_record, 9);
    largest_error                    = values[0];
    largest_motion                   = values[1];
    largest_rotation                 = values[2];
    size_of_motion                   = values[3];
    way                              = values[4];
    time                             = values[5];
    unstable                         = values[6] != 0;
    estimated                        = values[7];
    n_steps                          = values[8];
    error =
      UnknownRecords(solver.model().numbering).values(error_record, records);
    solver.resume(stiffness_record, records);
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
