#include <auxfem/analysis/consistent_rates.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/equations/prescribed_motion.h>
#include <auxfem/model/unknown_words.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/massless.h>

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
    , increment(model.numbering.layout().n_local())
  {}

  void ConsistentRates::start(State &state, const double dt)
  {
    const State before     = state;
    Evaluation  evaluation = Evaluation::rates(before, state);
    // A load that is switched on at t = 0 acts from there on.
    evaluation.jumps_at_to = true;
    state.acceleration->assign(state.acceleration->size(), 0.);
    prescribe_motion(model, evaluation, dt);
    solver.residual(evaluation, results);

    if (!prepare_mass(evaluation))
      prepare_stand_in(evaluation, dt);
    if (!solver.equations().reporting().conditions.empty())
      {
        std::vector<double> rates;
        refuse_strain(state, find_rates(state, rates), dt);
        project_velocities(state, rates);
        solver.residual(evaluation, results);
      }
    find_accelerations(evaluation);
    if (state.algorithmic_acceleration)
      *state.algorithmic_acceleration = *state.acceleration;
    solver.residual(evaluation, results);
  }

  void ConsistentRates::keep_massless(State &state)
  {
    if (!is_singular)
      return;
    const State      before = state;
    const Evaluation now    = Evaluation::rates(before, state);
    solver.residual(now, results);
    solver.assemble(now, results, {0., 0., 1.});
    std::vector<double> kinds = empty_rows();
    if (!is_anywhere(kinds))
      return;
    mark_damped(kinds, now);
    state.is_massless.emplace(state.displacement.size(), 0.);
    std::copy(kinds.begin(), kinds.end(), state.is_massless->begin());
    model.numbering.layout().update_ghosts(state.is_massless->data());
    for (std::optional<Vector> *accelerations :
         {&state.acceleration, &state.algorithmic_acceleration})
      if (*accelerations)
        for (unsigned int i = 0; i < state.is_massless->size(); ++i)
          if ((*state.is_massless)[i] != 0)
            (**accelerations)[i] = 0;
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
    if (is_anywhere(refused))
      throw InputError(
        "The " + describe_largest(model.numbering, refused) +
        " has no inertia, but a dashpot or damping acts on it: its velocity "
        "is not determined by a scheme without numerical damping. Give the "
        "joint a mass (Masses) or its struts a Density; put a spring and a "
        "dashpot in series into one connector (Law = maxwell); or use Scheme = "
        "generalized-alpha.");
  }

  void ConsistentRates::restore(State &state)
  {
    const State before = state;
    restore(Evaluation::rates(before, state));
  }

  void ConsistentRates::renew(State &state)
  {
    const State before     = state;
    Evaluation  evaluation = Evaluation::rates(before, state);
    evaluation.jumps_at_to = true;
    if (restore(evaluation) && state.algorithmic_acceleration)
      *state.algorithmic_acceleration = *state.acceleration;
  }

  bool ConsistentRates::restore(const Evaluation &evaluation)
  {
    if (is_singular)
      return false;
    State &state = evaluation.to;
    solver.residual(evaluation, results);
    if (!prepare_mass(evaluation))
      return false;
    std::vector<double> rates;
    find_rates(state, rates);
    project_velocities(state, rates);
    solver.residual(evaluation, results);
    find_accelerations(evaluation);
    return true;
  }

  bool ConsistentRates::prepare_mass(const Evaluation &evaluation)
  {
    solver.assemble(evaluation, results, {0., 0., 1.});
    is_singular = is_anywhere(empty_rows());
    if (is_singular)
      return false;
    // Conditions make the matrix indefinite.
    if (model.numbering.constraints().n_multipliers() == 0)
      {
        method = Method::conjugate_gradients;
        return true;
      }
    method      = Method::factorization;
    is_singular = !solver.factorize();
    return !is_singular;
  }

  void ConsistentRates::prepare_stand_in(const Evaluation &evaluation,
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
    rates.assign(numbering.layout().n_local(), 0.);
    for (const Conditions *of_kind : solver.equations().reporting().conditions)
      of_kind->find_rates(state, rates.data());
    double mine = 0;
    for (const double rate : rates)
      mine = std::max(mine, std::abs(rate));
    return numbering.layout().largest(mine);
  }

  void ConsistentRates::refuse_strain(const State &state,
                                      const double rate,
                                      const double dt) const
  {
    // Prescribed velocities are differences, given ones have few digits.
    constexpr double digits_of_velocities = 1e-6, part_of_first_step = 1e-3,
                     round_off_of_differences = 1e-12;
    const double speed = largest_motion(model, *state.velocity).first,
                 acceleration =
                   largest_motion(model, *state.acceleration).first;
    if (rate <= digits_of_velocities * speed +
          part_of_first_step * acceleration * dt +
          round_off_of_differences * model.mean_strut_length / dt)
      return;
    std::ostringstream message;
    message << "At t = 0 the joints of a rigid part move apart"
            << (model.lattice.dimension == 3
                  ? ", or a revolute hinge turns across its axis,"
                  : "")
            << " with " << rate
            << " m/s, by Initial velocities or by Supports that start with a "
               "speed. Give all joints of the part velocities of one rigid "
               "motion that its supports allow, or let supports start from "
               "rest.";
    throw InputError(message.str());
  }

  void ConsistentRates::project_velocities(State                     &state,
                                           const std::vector<double> &rates)
  {
    const DofNumbering &numbering = model.numbering;
    for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
      increment[i] = -rates[i];
    solve();
    for (const int multiplier : numbering.constraints().multipliers())
      increment[multiplier] = 0;
    NodeRotations(model.numbering).make_material(state, increment);
    add_multiple(1., increment, *state.velocity);
  }

  void ConsistentRates::find_accelerations(const Evaluation &evaluation)
  {
    State &state = evaluation.to;
    find_right_side(model, evaluation, increment.data());
    solve();
    NodeRotations(model.numbering).make_material(state, increment);
    add_multiple(1., increment, *state.acceleration);
    for (const int multiplier : model.numbering.constraints().multipliers())
      {
        state.displacement[multiplier] += increment[multiplier];
        (*state.acceleration)[multiplier] = 0;
      }
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
      throw ComputationError(found + solver.why() + '.');
  }

  std::vector<double> ConsistentRates::empty_rows()
  {
    std::vector<double> emptiness = solver.matrix().row_sizes();
    for (double &row : emptiness)
      row = row == 0 ? 1. : 0.;
    return emptiness;
  }

  bool ConsistentRates::is_anywhere(const std::vector<double> &flags) const
  {
    return model.numbering.layout().sum(
             std::count(flags.begin(), flags.end(), 1.)) > 0;
  }

  void ConsistentRates::refuse_empty_rows()
  {
    const std::vector<double> emptiness = empty_rows();
    if (!is_anywhere(emptiness))
      return;
    throw InputError(
      "Nothing resists the " + describe_largest(model.numbering, emptiness) +
      ": no mass, no strut and no connector. Give the joint a mass, "
      "connect it or leave it out.");
  }
} // namespace auxfem
