#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/state/state.h>
#include <auxfem/time/consistent_rates.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace auxfem
{
  ConsistentRates::ConsistentRates(TangentSolver &solver)
    : solver(solver)
    , model(solver.model())
    , results(solver.equations().make_results())
  {}

  State ConsistentRates::start(State &state, const double dt)
  {
    state.acceleration->assign(state.acceleration->size(), 0.);
    State      before  = state;
    Evaluation instant = Evaluation::consistent_rates(before, state);
    // A load that is switched on at t = 0 acts from t = 0 on.
    instant.event_at_to = {0., TimeSide::after};
    prescribe_motion(model, instant);
    copy_fixed_support_velocities(model, state, before);
    solver.residual(instant, results);
    if (!prepare_mass(instant))
      prepare_substitute_mass(instant, dt);
    std::vector<double> rates;
    refuse_strain(before, find_rates(before, rates));
    apply_impulses(instant, dt);
    find_accelerations(instant);
    if (state.algorithmic_acceleration)
      *state.algorithmic_acceleration = *state.acceleration;
    solver.residual(instant, results);
    return before;
  }

  void ConsistentRates::clear_massless_accelerations(State &state) const
  {
    if (!state.is_massless)
      return;
    for (std::optional<Vector> *accelerations :
         {&state.acceleration, &state.algorithmic_acceleration})
      if (*accelerations)
        for (unsigned int i = 0; i < state.is_massless->size(); ++i)
          if ((*state.is_massless)[i] != 0)
            (**accelerations)[i] = 0;
  }

  void ConsistentRates::keep_massless(State &state)
  {
    if (!is_singular)
      return;
    const State      before = state;
    const Evaluation now    = Evaluation::consistent_rates(before, state);
    solver.residual(now, results);
    solver.assemble(now, results, {0., 0., 1.});
    std::vector<double> kinds = empty_rows();
    if (!is_set_on_any_rank(kinds))
      return;
    mark_damped(kinds, now);
    state.is_massless.emplace(state.displacement.size(), 0.);
    std::copy(kinds.begin(), kinds.end(), state.is_massless->begin());
    solver.equations().unknowns().layout.update_ghosts(
      state.is_massless->data());
    clear_massless_accelerations(state);
  }

  void ConsistentRates::mark_damped(std::vector<double> &kinds,
                                    const Evaluation    &now)
  {
    solver.assemble(now, results, {0., 1., 0.});
    const std::vector<double> is_undamped = empty_rows();
    std::vector<double>       refused(kinds.size(), 0.);
    for (unsigned int i = 0; i < kinds.size(); ++i)
      if (kinds[i] == massless && is_undamped[i] == 0)
        {
          kinds[i] = massless_and_damped;
          if (!model.numbering.unknowns().is_rotation[i])
            refused[i] = 1;
        }
    if (is_set_on_any_rank(refused))
      throw InputError(
        "The " + describe_largest(model.numbering, refused) +
        " has no inertia, but a dashpot or damping acts on it: its velocity "
        "is not determined by a scheme without numerical damping. Give the "
        "joint a mass (Masses) or its struts a Density; put a spring and a "
        "dashpot in series into one connector (Law = maxwell); or use Scheme = "
        "generalized-alpha.");
  }

  void ConsistentRates::restore(const Evaluation &step)
  {
    if (is_singular)
      return;
    const State before  = step.to;
    Evaluation  instant = Evaluation::consistent_rates(before, step.to);
    instant.event_at_to = step.event_at_to;
    solver.residual(instant, results);
    if (!prepare_mass(instant))
      return;
    apply_impulses(instant, step.dt);
    find_accelerations(instant);
  }

  State ConsistentRates::update_after_jump(State       &state,
                                           const double event,
                                           const double dt)
  {
    const State before  = state;
    Evaluation  instant = Evaluation::consistent_rates(before, state);
    instant.event_at_to = {event, TimeSide::after};
    prescribe_motion(model, instant);
    solver.residual(instant, results);
    if (!prepare_mass(instant))
      prepare_substitute_mass(instant, dt);
    apply_impulses(instant, dt);
    find_accelerations(instant);
    if (state.algorithmic_acceleration)
      *state.algorithmic_acceleration = *state.acceleration;
    clear_massless_accelerations(state);
    return before;
  }

  bool ConsistentRates::prepare_mass(const Evaluation &evaluation)
  {
    solver.assemble(evaluation, results, {0., 0., 1.});
    is_singular = is_set_on_any_rank(empty_rows());
    if (is_singular)
      return false;
    // Constraints make the matrix indefinite.
    if (model.numbering.constraints().n_multipliers() == 0)
      {
        method = Method::conjugate_gradients;
        return true;
      }
    method      = Method::factorization;
    is_singular = !solver.factorize();
    return !is_singular;
  }

  void ConsistentRates::prepare_substitute_mass(const Evaluation &evaluation,
                                                const double      dt)
  {
    method = Method::factorization;
    solver.assemble(evaluation, results, {dt * dt / 4, dt / 2, 1.});
    refuse_empty_rows();
    if (!solver.factorize())
      throw InputError(
        "The mass matrix is singular, so the accelerations at t = 0 are "
        "not determined. Give every moving part a density or a mass "
        "(Sections/NAME/Density, Rigid parts/NAME/Mass, Masses).");
  }

  double ConsistentRates::find_rates(const State         &state,
                                     std::vector<double> &rates) const
  {
    const DofNumbering &numbering = model.numbering;
    rates.assign(solver.equations().unknowns().layout.n_local(), 0.);
    for (const Constraints *constraints :
         solver.equations().reporting().constraints)
      constraints->find_rates(state, rates.data());
    double mine = 0;
    for (const double rate : rates)
      mine = std::max(mine, std::abs(rate));
    return numbering.layout().largest(mine);
  }

  void ConsistentRates::refuse_strain(const State &state,
                                      const double rate) const
  {
    // Given velocities have few digits.
    if (rate <= input_precision * largest_motion(model, *state.velocity).first)
      return;
    std::ostringstream message;
    message
      << "At t = 0 the joints of a rigid part move apart"
      << (model.lattice.dimension == 3
            ? ", or a revolute hinge turns across its axis,"
            : "")
      << " with " << rate
      << " m/s, by Initial velocities. Give all joints of the part, those "
         "that supports move too, velocities of one rigid motion that "
         "its supports allow.";
    throw InputError(message.str());
  }

  void ConsistentRates::apply_impulses(const Evaluation &instant,
                                       const double      dt)
  {
    State &state = instant.to;
    support_impulses.clear();
    std::vector<double> rates;
    find_rates(instant.from, rates);
    increment.assign(solver.equations().unknowns().layout.n_local(), 0.);
    for (unsigned int i = 0; i < model.numbering.layout().n_owned(); ++i)
      increment[i] = -rates[i];
    const bool strikes =
      find_velocity_jumps(model, instant.from, state, increment.data()) > 0;
    if (!strikes && solver.equations().reporting().constraints.empty())
      return;
    solve();
    if (strikes)
      find_impulses(instant, dt);
    zero_prescribed_rows();
    for (const int multiplier : model.numbering.constraints().multipliers())
      increment[multiplier] = 0;
    NodeRotations(model.numbering).make_material(state, increment);
    add_multiple(1., increment, *state.velocity);
    solver.residual(instant, results);
  }

  void ConsistentRates::find_impulses(const Evaluation &instant,
                                      const double      dt)
  {
    // Impulses follow from the support forces of the same velocity change over
    // a step of this length, as residuals are linear in accelerations and
    // multipliers.
    State  struck = instant.to;
    Vector change = increment;
    NodeRotations(model.numbering).make_material(struck, change);
    for (const int multiplier : model.numbering.constraints().multipliers())
      {
        struck.displacement[multiplier] += change[multiplier] / dt;
        change[multiplier] = 0;
      }
    add_multiple(1 / dt, change, *struck.acceleration);
    Evaluation evaluation  = Evaluation::consistent_rates(instant.from, struck);
    evaluation.event_at_to = instant.event_at_to;
    solver.residual(evaluation, results);
    support_impulses.assign(increment.size(), 0.);
    for (const Support &support : model.supports)
      for (const Support::PrescribedUnknown &prescribed : support.unknowns)
        if (const int i = prescribed.unknown;
            model.numbering.layout().is_owned(i))
          support_impulses[i] =
            dt * (struck.residual[i] - instant.to.residual[i]);
  }

  void ConsistentRates::find_accelerations(const Evaluation &evaluation)
  {
    State &state = evaluation.to;
    increment.assign(solver.equations().unknowns().layout.n_local(), 0.);
    for (unsigned int i = 0; i < model.numbering.layout().n_owned(); ++i)
      increment[i] = -state.residual[i];
    zero_prescribed_rows();
    solve();
    NodeRotations(model.numbering).make_material(state, increment);
    add_multiple(1., increment, *state.acceleration);
    for (const int multiplier : model.numbering.constraints().multipliers())
      {
        state.displacement[multiplier] += increment[multiplier];
        (*state.acceleration)[multiplier] = 0;
      }
  }

  void ConsistentRates::zero_prescribed_rows()
  {
    for (const Support &support : model.supports)
      for (const Support::PrescribedUnknown &prescribed : support.unknowns)
        increment[prescribed.unknown] = 0;
  }

  void ConsistentRates::solve()
  {
    const std::string found =
      "The accelerations that balance the forces were not found: ";
    if (method == Method::conjugate_gradients)
      {
        if (!solver.solve_by_conjugate_gradients(increment))
          throw ComputationError(found +
                                 "the mass matrix is not positive definite.");
        return;
      }
    if (!solver.solve(increment))
      throw ComputationError(found + solver.last_failure() + '.');
  }

  std::vector<double> ConsistentRates::empty_rows()
  {
    std::vector<double> emptiness = solver.matrix().row_sizes();
    for (double &row : emptiness)
      row = row == 0 ? 1. : 0.;
    return emptiness;
  }

  bool
  ConsistentRates::is_set_on_any_rank(const std::vector<double> &flags) const
  {
    return model.numbering.layout().sum(
             std::count(flags.begin(), flags.end(), 1.)) > 0;
  }

  void ConsistentRates::refuse_empty_rows()
  {
    const std::vector<double> emptiness = empty_rows();
    if (!is_set_on_any_rank(emptiness))
      return;
    throw InputError(
      "Nothing resists the " + describe_largest(model.numbering, emptiness) +
      ": no mass, no strut and no connector. Give the joint a mass, "
      "connect it or leave it out.");
  }

  namespace
  {
    /**
     * Relative change of velocities in a step up to which the predictor is
     * extrapolated.
     * @tuned measured: with three times as much, steps of a collapse fail
     */
    constexpr double small_change = 0.1;

    bool is_short(const Evaluation &step, const LatticeModel &model)
    {
      const UnknownLayout     &layout = model.numbering.layout();
      const std::vector<bool> &is_rotation =
        model.numbering.unknowns().is_rotation;
      const Vector &v = *step.from.velocity, &a = *step.from.acceleration;
      // Norms of translations and rotations.
      std::vector<double> velocities(2, 0.), changes(2, 0.);
      for (unsigned int i = 0; i < layout.n_owned(); ++i)
        {
          velocities[is_rotation[i]] += v[i] * v[i];
          changes[is_rotation[i]] += a[i] * a[i];
        }
      velocities        = layout.sum(velocities);
      changes           = layout.sum(changes);
      const double part = small_change / step.dt;
      return changes[0] <= part * part * velocities[0] &&
        changes[1] <= part * part * velocities[1];
    }
  } // namespace

  void extrapolate_predictor(const ImplicitScheme &scheme,
                             const Evaluation     &step,
                             const LatticeModel   &model)
  {
    if (!is_short(step, model))
      return;
    Vector increment(step.from.displacement.size(), 0.);
    add_multiple(step.dt, *step.from.velocity, increment);
    add_multiple(step.dt * step.dt / 2, *step.from.acceleration, increment);
    scheme.correct(step.from, increment, step.dt, step.to);
  }

  void keep_velocities(const ImplicitScheme &scheme, const Evaluation &step)
  {
    Vector increment = step.from.displacement;
    add_multiple(step.dt, *step.from.velocity, increment);
    add_multiple(-1., step.to.displacement, increment);
    scheme.correct(step.from, increment, step.dt, step.to);
  }

  void repeat_last_increment(const ImplicitScheme &scheme,
                             const Evaluation     &step)
  {
    if (!step.from.before)
      return;
    Vector increment = step.from.displacement;
    add_multiple(-1., step.from.before->displacement, increment);
    scale(step.dt / step.from.before->dt, increment);
    scheme.correct(step.from, increment, step.dt, step.to);
  }
} // namespace auxfem
