#include <auxfem/parameters/errors.h>
#include <auxfem/system/system.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
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

  const StrutForces *System::struts() const
  {
    return strut_forces;
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
    State state(*dofs, state_layout);
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

  void System::prescribe_motion(State &state, const double dt) const
  {
    for (const Support &support : support_list)
      for (const auto &prescribed : support.unknowns)
        {
          if (prescribed.motion.is_zero())
            {
              state.displacement[prescribed.unknown] = 0;
              if (state.velocity)
                (*state.velocity)[prescribed.unknown] = 0;
              if (state.acceleration)
                (*state.acceleration)[prescribed.unknown] = 0;
              continue;
            }
          const std::array<double, 3> motion =
            prescribed.motion.jet(state.time, dt);
          state.displacement[prescribed.unknown] = motion[0];
          if (state.velocity)
            (*state.velocity)[prescribed.unknown] = motion[1];
          if (state.acceleration)
            (*state.acceleration)[prescribed.unknown] = motion[2];
        }
  }

  void System::prescribed_gap(const State &state, double *gap) const
  {
    for (const Support &support : support_list)
      for (const auto &prescribed : support.unknowns)
        if (dofs->is_owned(prescribed.unknown))
          gap[prescribed.unknown] = prescribed.motion.value(state.time) -
            state.displacement[prescribed.unknown];
  }

  ResidualNorm System::residual(const Step &step)
  {
    double *residual = step.to.residual.Values();
    std::fill(residual, residual + dofs->n_local(), 0.);
    for (unsigned int i = 0; i < n_internal; ++i)
      effects[i]->add_residual(step, residual);

    // Sums of squares: internal forces and moments of all rows, then the
    // residual of free rows.
    double             mine[4] = {0, 0, 0, 0}, sums[4];
    const unsigned int n       = dofs->n_owned();
    for (unsigned int i = 0; i < n; ++i)
      mine[dofs->is_rotation(i)] += residual[i] * residual[i];
    for (unsigned int i = n_internal; i < effects.size(); ++i)
      effects[i]->add_residual(step, residual);
    for (unsigned int i = 0; i < n; ++i)
      if (dofs->kind(i) != UnknownKind::prescribed)
        mine[2 + dofs->is_rotation(i)] += residual[i] * residual[i];
    if (dofs->n_ranks() > 1)
      dofs->communicator().SumAll(mine, sums, 4);
    else
      std::copy(mine, mine + 4, sums);

    scale = std::sqrt(std::max(sums[0], sums[1] / (mean_length * mean_length)));
    return {std::sqrt(sums[2]), std::sqrt(sums[3])};
  }

  double System::force_scale() const
  {
    return scale;
  }

  double System::length_scale() const
  {
    return mean_length;
  }

  std::pair<double, double> System::largest_motion(const State &state) const
  {
    double        mine[2] = {0, 0}, all[2];
    const double *u       = state.displacement.Values();
    for (unsigned int i = 0; i < dofs->n_owned(); ++i)
      mine[dofs->is_rotation(i)] =
        std::max(mine[dofs->is_rotation(i)], std::abs(u[i]));
    dofs->communicator().MaxAll(mine, all, 2);
    return {all[0], all[1]};
  }

  double System::round_off_floor(const State &state) const
  {
    const auto [displacement, rotation] = largest_motion(state);
    double mine = 0, scale_of_row = 0;
    for (const auto &effect : effects)
      mine = std::max(mine, effect->round_off_scale(displacement, rotation));
    dofs->communicator().MaxAll(&mine, &scale_of_row, 1);
    // A row sums a few roundings of a few products each.
    const double safety = 4;
    return safety * std::numeric_limits<double>::epsilon() * scale_of_row *
      std::sqrt(double(dofs->n_unknowns()));
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
    for (const auto &effect : effects)
      effect->accept(step);
    // The trapezoidal rule, second order like the integrators.
    if (std::isfinite(step.dt))
      step.to.strut_dissipation += step.dt / 2 *
        (step.from.strut_damping_power + step.to.strut_damping_power);
    // Prescribed motion works by the mean of the support forces over the step.
    for (const Support &support : support_list)
      for (const auto &prescribed : support.unknowns)
        if (dofs->is_owned(prescribed.unknown))
          {
            const int i = prescribed.unknown;
            step.to.external_work +=
              (step.from.residual[i] + step.to.residual[i]) / 2 *
              (step.to.displacement[i] - step.from.displacement[i]);
          }
    step.to.energies = energies(step.to);
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
    double       largest = -1;
    unsigned int worst   = 0;
    for (unsigned int i = 0; i < dofs->n_owned(); ++i)
      if (dofs->kind(i) != UnknownKind::prescribed)
        {
          const double size = std::abs(state.residual[i]) /
            (dofs->is_rotation(i) ? mean_length : 1.);
          if (!(size <= largest))
            {
              largest =
                std::isfinite(size) ? size : std::numeric_limits<double>::max();
              worst = i;
            }
        }
    double of_all = 0;
    dofs->communicator().MaxAll(&largest, &of_all, 1);
    // Every rank gets the words of the lowest rank that has the largest value.
    int mine = largest == of_all ? int(dofs->rank()) : int(dofs->n_ranks()),
        who  = 0;
    dofs->communicator().MinAll(&mine, &who, 1);
    std::string words = who == int(dofs->rank()) ? dofs->describe(worst) : "";
    return dealii::Utilities::MPI::broadcast(dofs->communicator().Comm(),
                                             words,
                                             who);
  }
} // namespace auxfem
