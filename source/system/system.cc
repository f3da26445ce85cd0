#include <auxfem/system/system.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Sum of squares in some rows; four sums, as one would wait for itself. */
    double sum_of_squares(const double *values, const std::vector<int> &rows)
    {
      double            sums[4]   = {0, 0, 0, 0};
      const std::size_t n         = rows.size();
      const std::size_t n_in_four = n - n % 4;
      for (std::size_t i = 0; i < n_in_four; i += 4)
        for (unsigned int k = 0; k < 4; ++k)
          sums[k] += values[rows[i + k]] * values[rows[i + k]];
      for (std::size_t i = n_in_four; i < n; ++i)
        sums[0] += values[rows[i]] * values[rows[i]];
      return sums[0] + sums[1] + sums[2] + sums[3];
    }

    double largest(const double *values, const std::vector<int> &rows)
    {
      double result = 0;
      for (const int row : rows)
        result = std::max(result, std::abs(values[row]));
      return result;
    }
  } // namespace

  const Lattice &System::lattice() const
  {
    return graph;
  }

  const DofNumbering &System::numbering() const
  {
    return *dofs;
  }

  const StateLayout &System::layout() const
  {
    return state_layout;
  }

  const NodeRotations &System::rotations() const
  {
    return *node_rotations;
  }

  const StrutForces *System::struts() const
  {
    return strut_forces;
  }

  const RigidPartConditions *System::rigid_parts() const
  {
    return parts;
  }

  bool System::has_conditions() const
  {
    return !conditions.empty();
  }

  void System::find_rates(const State &state, double *rates) const
  {
    for (const Conditions *of_kind : conditions)
      of_kind->find_rates(state, rates);
  }

  const std::vector<const ConnectorForces *> &System::connectors() const
  {
    return connector_groups;
  }

  const std::vector<Support> &System::supports() const
  {
    return support_list;
  }

  const std::vector<EffectDecision> &System::decisions() const
  {
    return simulated.decisions;
  }

  const std::vector<Section> &System::sections() const
  {
    return section_list;
  }

  bool System::is_dynamic() const
  {
    return simulated.inertia;
  }

  bool System::is_linear() const
  {
    return std::all_of(effects.begin(), effects.end(), [](const auto &effect) {
      return effect->is_linear();
    });
  }

  void System::use_algorithmic_acceleration()
  {
    state_layout.algorithmic_acceleration = true;
  }

  State System::initial_state() const
  {
    State state(dofs->local_map(), state_layout);
    for (const auto &[unknown, velocity] : initial_velocities)
      (*state.velocity)[unknown] = velocity;
    return state;
  }

  std::unique_ptr<TangentMatrix> System::make_tangent()
  {
    auto matrix = std::make_unique<TangentMatrix>(*dofs);
    for (const auto &effect : effects)
      effect->register_blocks(*matrix);
    matrix->finalize();
    return matrix;
  }

  void System::begin_step(const Step &step)
  {
    for (const auto &effect : effects)
      effect->begin_step(step);
  }

  ResidualNorm System::residual(const Step &step)
  {
    double *residual = step.to.residual.Values();
    std::fill(residual, residual + dofs->n_local(), 0.);
    // Sums of squares of forces and moments: of internal forces, of internal
    // and inertia forces, and of the residual in free rows; then of conditions.
    double     mine[7] = {0, 0, 0, 0, 0, 0, 0}, sums[7];
    const auto add     = [&](const unsigned int begin, const unsigned int end) {
      for (unsigned int i = begin; i < end; ++i)
        effects[i]->add_residual(step, residual);
    };
    const auto sum_all_rows = [&](double *sum) {
      sum[0] = sum_of_squares(residual, rows.free_translations) +
        sum_of_squares(residual, rows.prescribed_translations);
      sum[1] = sum_of_squares(residual, rows.free_rotations) +
        sum_of_squares(residual, rows.prescribed_rotations);
    };
    add(0, n_internal);
    sum_all_rows(mine);
    if (n_balanced > n_internal)
      {
        add(n_internal, n_balanced);
        sum_all_rows(mine + 2);
      }
    add(n_balanced, effects.size());
    mine[4] = sum_of_squares(residual, rows.free_translations);
    mine[5] = sum_of_squares(residual, rows.free_rotations);
    mine[6] = sum_of_squares(residual, rows.multipliers);
    if (dofs->n_ranks() > 1)
      dofs->communicator().SumAll(mine, sums, 7);
    else
      std::copy(mine, mine + 7, sums);

    const double forces  = std::max(sums[0], sums[2]),
                 moments = std::max(sums[1], sums[3]);
    scale = std::sqrt(std::max(forces, moments / (mean_length * mean_length)));
    return {std::sqrt(sums[4]), std::sqrt(sums[5]), std::sqrt(sums[6])};
  }

  double System::force_scale() const
  {
    return scale;
  }

  double System::length_scale() const
  {
    return mean_length;
  }

  std::pair<double, double> System::largest_motion(const Vector &motion) const
  {
    const double *values  = motion.Values();
    double        mine[2] = {std::max(largest(values, rows.free_translations),
                               largest(values, rows.prescribed_translations)),
                             std::max(largest(values, rows.free_rotations),
                               largest(values, rows.prescribed_rotations))};
    if (dofs->n_ranks() == 1)
      return {mine[0], mine[1]};
    double all[2];
    dofs->communicator().MaxAll(mine, all, 2);
    return {all[0], all[1]};
  }

  double System::round_off_floor(const State &state) const
  {
    const auto [displacement, rotation] = largest_motion(state.displacement);
    double mine = 0, scale_of_row = 0;
    for (const auto &effect : effects)
      mine = std::max(mine, effect->round_off_scale(displacement, rotation));
    dofs->communicator().MaxAll(&mine, &scale_of_row, 1);
    // A row sums a few roundings of a few products each.
    const double safety = 4;
    return safety * std::numeric_limits<double>::epsilon() * scale_of_row *
      std::sqrt(double(dofs->n_unknowns()));
  }

  double System::condition_tolerance(const State &state) const
  {
    if (conditions.empty())
      return 0;
    double length = mean_length;
    for (const Conditions *of_kind : conditions)
      length = std::max(length, of_kind->length());
    // A condition sums a few products of displacements and lengths.
    const double safety = 16;
    return safety * std::numeric_limits<double>::epsilon() *
      (length + largest_motion(state.displacement).first) *
      std::sqrt(double(dofs->n_multipliers()));
  }

  void System::tangent(const Step           &step,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const
  {
    matrix.reset();
    for (const auto &effect : effects)
      effect->add_tangent(step, factors, matrix);
  }

  void System::accept(const Step &step)
  {
    step.to.external_work       = step.from.external_work;
    step.to.strut_dissipation   = step.from.strut_dissipation;
    step.to.strut_damping_power = 0;
    hold_multipliers(step.to);
    for (const auto &effect : effects)
      effect->accept(step);
    // The trapezoidal rule, second order like the integrators.
    if (std::isfinite(step.dt))
      step.to.strut_dissipation += step.dt / 2 *
        (step.from.strut_damping_power + step.to.strut_damping_power);
    step.to.external_work += support_work(step);
    step.to.energies = energies(step.to);
  }

  void System::hold_multipliers(State &state) const
  {
    for (const int multiplier : dofs->multipliers())
      {
        if (state.velocity)
          (*state.velocity)[multiplier] = 0;
        if (state.acceleration)
          (*state.acceleration)[multiplier] = 0;
        if (state.algorithmic_acceleration)
          (*state.algorithmic_acceleration)[multiplier] = 0;
      }
  }

  Energies System::energies(const State &state) const
  {
    Energies mine;
    for (const auto &effect : effects)
      effect->add_energies(state, mine);
    mine.dissipated += state.strut_dissipation;
    mine.external = state.external_work;
    if (dofs->n_ranks() == 1)
      return mine;
    double values[5] = {mine.kinetic,
                        mine.strain,
                        mine.stored,
                        mine.dissipated,
                        mine.external};
    double sums[5];
    dofs->communicator().SumAll(values, sums, 5);
    return {sums[0], sums[1], sums[2], sums[3], sums[4]};
  }

  std::string System::worst_unknown(const State &state) const
  {
    std::vector<double> sizes(dofs->n_owned(), 0.);
    const auto measure = [&](const std::vector<int> &of, const double unit) {
      for (const int row : of)
        {
          const double size = std::abs(state.residual[row]) / unit;
          sizes[row] =
            std::isfinite(size) ? size : std::numeric_limits<double>::max();
        }
    };
    measure(rows.free_translations, 1.);
    measure(rows.free_rotations, mean_length);
    return dofs->describe_largest(sizes);
  }
} // namespace auxfem
