#include <auxfem/analysis/consistent_rates.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  ConsistentRates::ConsistentRates(System        &system,
                                   TangentMatrix &matrix,
                                   LinearSolver  &solver)
    : system(system)
    , matrix(matrix)
    , solver(solver)
    , increment(system.numbering().local_map())
  {}

  void ConsistentRates::start(State &state, const double dt)
  {
    const State before = state;
    const Step  step{before, state, /*dt=*/0.};
    state.acceleration->PutScalar(0.);
    system.begin_step(step);
    system.prescribe_motion(step, dt);
    system.residual(step);

    if (!factorize_mass(step))
      {
        system.tangent(step, {dt * dt / 4, dt / 2, 1.}, matrix);
        refuse_empty_rows();
        if (!solver.factorize())
          throw InputError(
            "The mass matrix is singular, so the accelerations at t = 0 are "
            "not determined. Give every moving part a density or a mass "
            "(Sections/NAME/Density, Rigid parts/NAME/Mass, Masses).");
      }
    if (system.has_conditions())
      {
        std::vector<double> rates;
        refuse_strain(state, find_rates(state, rates), dt);
        project_velocities(state, rates);
        system.residual(step);
      }
    find_accelerations(step);
    if (state.algorithmic_acceleration)
      *state.algorithmic_acceleration = *state.acceleration;
    system.residual(step);
  }

  void ConsistentRates::restore(State &state)
  {
    if (is_singular)
      return;
    const State before = state;
    const Step  step{before, state, /*dt=*/0.};
    system.begin_step(step);
    system.residual(step);
    if (!factorize_mass(step))
      return;
    std::vector<double> rates;
    find_rates(state, rates);
    project_velocities(state, rates);
    system.residual(step);
    find_accelerations(step);
  }

  bool ConsistentRates::factorize_mass(const Step &step)
  {
    system.tangent(step, {0., 0., 1.}, matrix);
    is_singular = has_empty_row() || !solver.factorize();
    return !is_singular;
  }

  double ConsistentRates::find_rates(const State         &state,
                                     std::vector<double> &rates) const
  {
    const DofNumbering &numbering = system.numbering();
    rates.assign(numbering.n_local(), 0.);
    system.find_rates(state, rates.data());
    double mine = 0, largest = 0;
    for (const double rate : rates)
      mine = std::max(mine, std::abs(rate));
    numbering.communicator().MaxAll(&mine, &largest, 1);
    return largest;
  }

  void ConsistentRates::refuse_strain(const State &state,
                                      const double rate,
                                      const double dt) const
  {
    // Prescribed velocities are differences, given ones have few digits.
    constexpr double digits_of_velocities = 1e-6, part_of_first_step = 1e-3,
                     round_off_of_differences = 1e-12;
    const double speed = system.largest_motion(*state.velocity).first,
                 acceleration =
                   system.largest_motion(*state.acceleration).first;
    if (rate <= digits_of_velocities * speed +
          part_of_first_step * acceleration * dt +
          round_off_of_differences * system.length_scale() / dt)
      return;
    std::ostringstream message;
    message << "At t = 0 the joints of a rigid part move apart"
            << (system.lattice().dimension == 3
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
    const DofNumbering &numbering = system.numbering();
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      solver.right_side()[i] = -rates[i];
    solve();
    for (const int multiplier : numbering.multipliers())
      increment[multiplier] = 0;
    system.rotations().make_material(state, increment);
    state.velocity->Update(1., increment, 1.);
  }

  void ConsistentRates::find_accelerations(const Step &step)
  {
    State &state = step.to;
    system.right_side(step, solver.right_side().Values());
    solve();
    system.rotations().make_material(state, increment);
    state.acceleration->Update(1., increment, 1.);
    for (const int multiplier : system.numbering().multipliers())
      {
        state.displacement[multiplier] += increment[multiplier];
        (*state.acceleration)[multiplier] = 0;
      }
  }

  void ConsistentRates::solve()
  {
    solver.solve(increment);
    if (!solver.failure().empty())
      throw ComputationError("The accelerations that balance the forces were "
                             "not found: " +
                             solver.failure());
  }

  bool ConsistentRates::has_empty_row() const
  {
    const std::vector<double> sizes = matrix.row_sizes();
    int                       mine = std::count(sizes.begin(), sizes.end(), 0.);
    int                       all  = 0;
    system.numbering().communicator().SumAll(&mine, &all, 1);
    return all > 0;
  }

  void ConsistentRates::refuse_empty_rows() const
  {
    if (!has_empty_row())
      return;
    std::vector<double> emptiness;
    for (const double size : matrix.row_sizes())
      emptiness.push_back(size == 0 ? 1. : 0.);
    throw InputError(
      "Nothing resists the " + system.numbering().describe_largest(emptiness) +
      ": no mass, no strut and no connector. Give the joint a mass, "
      "connect it or leave it out.");
  }
} // namespace auxfem
