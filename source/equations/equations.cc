#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/equations/equations.h>
#include <auxfem/model/unknown_records.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace auxfem
{
  namespace
  {
    /** Sums of squares of a residual, in all rows and in free ones. */
    struct RowSums
    {
      double forces = 0, moments = 0, free_forces = 0, free_moments = 0;
    };

    RowSums sum_rows(const double *residual, const OwnedRows &rows)
    {
      RowSums sums;
      sums.free_forces  = sum_of_squares(residual, rows.free_translations);
      sums.free_moments = sum_of_squares(residual, rows.free_rotations);
      sums.forces       = sums.free_forces +
        sum_of_squares(residual, rows.prescribed_translations);
      sums.moments =
        sums.free_moments + sum_of_squares(residual, rows.prescribed_rotations);
      return sums;
    }

    bool are_finite(const double *values, const std::size_t n)
    {
      // Without an early exit the loop is vectorised.
      bool all = true;
      for (std::size_t i = 0; i < n; ++i)
        all &= std::isfinite(values[i]);
      return all;
    }

    /** Text of the lowest rank with a nonempty one, on every rank. */
    std::string text_of_lowest_rank(const UnknownLayout &layout,
                                    const std::string   &mine)
    {
      namespace MPI = dealii::Utilities::MPI;
      const unsigned int lowest =
        MPI::min(mine.empty() ? layout.n_ranks() : layout.rank(),
                 layout.communicator());
      return lowest < layout.n_ranks()
        ? broadcast_text(lowest, mine, layout.communicator())
        : "";
    }
  } // namespace

  bool Equations::is_linear() const
  {
    // The Cayley measure of rotations is nonlinear.
    return state_layout.plane_rotations.empty() &&
      state_layout.space_rotations.empty() &&
      std::all_of(effects.begin(), effects.end(), [](const auto &effect) {
             return effect->is_linear();
           });
  }

  State Equations::initial_state() const
  {
    State state(unknowns().layout.n_local(), state_layout);
    for (const auto &[unknown, velocity] : initial_velocities)
      (*state.velocity)[unknown] = velocity;
    return state;
  }

  EvaluationResults Equations::make_results() const
  {
    EvaluationResults results;
    results.effect_caches.reserve(effects.size());
    for (const auto &effect : effects)
      results.effect_caches.push_back(effect->make_results());
    return results;
  }

  void Equations::residual(const Evaluation  &evaluation,
                           EvaluationResults &results) const
  {
    update_ghosts(evaluation.to);
    double *residual = evaluation.to.residual.data();
    std::fill(residual, residual + evaluation.to.residual.size(), 0.);
    const auto add = [&](const unsigned int begin, const unsigned int end) {
      for (unsigned int i = begin; i < end; ++i)
        effects[i]->add_residual(evaluation,
                                 residual,
                                 results.effect_caches[i].get());
      return begin < end;
    };
    const OwnedRows &rows = structure.rows;
    RowSums          sums;
    if (add(0, n_internal))
      sums = sum_rows(residual, rows);
    const RowSums internal_sums = sums;
    if (add(n_internal, n_balanced))
      sums = sum_rows(residual, rows);
    const RowSums balanced_sums = sums;
    if (add(n_balanced, effects.size()))
      sums = sum_rows(residual, rows);
    const std::vector<double> all = structure.numbering.layout().sum(
      {internal_sums.forces,
       internal_sums.moments,
       balanced_sums.forces,
       balanced_sums.moments,
       sums.free_forces,
       sums.free_moments,
       sum_of_squares(residual, rows.multipliers),
       sums.forces,
       sums.moments});

    results.force        = std::sqrt(all[4]);
    results.moment       = std::sqrt(all[5]);
    results.constraint   = std::sqrt(all[6]);
    const double length  = structure.mean_strut_length,
                 forces  = std::max(all[0], all[2]),
                 moments = std::max(all[1], all[3]);
    results.force_scale =
      std::sqrt(std::max(forces, moments / (length * length)));
    // std::max drops a NaN in its second argument.
    if (!are_finite(all.data(), all.size()))
      results.force_scale = std::numeric_limits<double>::quiet_NaN();
  }

  void Equations::update_ghosts(State &state) const
  {
    // Supports prescribe only unknowns known from the start, so additional
    // ghosts need an update.
    if (!with_ghosts)
      return;
    unknowns().layout.update_ghosts(state.displacement.data());
    if (state.velocity)
      unknowns().layout.update_ghosts(state.velocity->data());
  }

  void Equations::tangent(const Evaluation        &evaluation,
                          const EvaluationResults &results,
                          const TangentFactors    &factors,
                          TangentMatrix           &matrix) const
  {
    matrix.reset();
    for (unsigned int i = 0; i < effects.size(); ++i)
      effects[i]->add_tangent(evaluation,
                              results.effect_caches[i].get(),
                              factors,
                              matrix);
  }

  void Equations::add_geometric_tangent(const ForceChange &change,
                                        TangentMatrix     &matrix) const
  {
    for (const auto &[effect, terms] : small_motion_terms)
      terms->add_geometric_tangent(change, effect, matrix);
  }

  void Equations::dynamic_stiffness(const Evaluation          &evaluation,
                                    const EvaluationResults   &results,
                                    const std::complex<double> s,
                                    TangentMatrix             &real,
                                    TangentMatrix             &imaginary) const
  {
    const std::complex<double> square = s * s;
    tangent(evaluation, results, {1., s.real(), square.real()}, real);
    tangent(evaluation, results, {0., s.imag(), square.imag()}, imaginary);
    for (const auto &[effect, terms] : small_motion_terms)
      terms->add_viscous_stiffness(evaluation,
                                   results.effect_caches[effect].get(),
                                   s,
                                   real,
                                   imaginary);
  }

  std::set<double> Equations::relaxation_times() const
  {
    std::vector<double> mine;
    for (const auto &[effect, terms] : small_motion_terms)
      terms->add_relaxation_times(unknowns(), mine);
    const std::vector<double> all =
      gather_over_ranks(mine, unknowns().layout.communicator());
    return {all.begin(), all.end()};
  }

  void Equations::relaxing_stiffness(const Evaluation        &evaluation,
                                     const EvaluationResults &results,
                                     const double             time,
                                     TangentMatrix           &matrix) const
  {
    matrix.reset();
    for (const auto &[effect, terms] : small_motion_terms)
      terms->add_relaxing_stiffness(evaluation,
                                    results.effect_caches[effect].get(),
                                    time,
                                    matrix);
  }

  Vector Equations::load_derivative(const Evaluation &evaluation) const
  {
    Vector derivative(unknowns().layout.n_local(), 0.);
    for (const auto &effect : effects)
      effect->add_load_derivative(evaluation, derivative.data());
    return derivative;
  }

  bool Equations::stages_need_no_residual() const
  {
    return std::none_of(stage_terms.begin(),
                        stage_terms.end(),
                        [](const auto &implementation) {
                          return implementation.terms->stage_needs() ==
                            StageTerms::StageNeeds::residual;
                        });
  }

  void Equations::find_stage_results(const Evaluation  &stage,
                                     EvaluationResults &results) const
  {
    update_ghosts(stage.to);
    for (const auto &[effect, terms] : stage_terms)
      if (terms->stage_needs() != StageTerms::StageNeeds::state)
        effects[effect]->add_residual(stage,
                                      stage.to.residual.data(),
                                      results.effect_caches[effect].get());
  }

  std::vector<double>
  Equations::find_internal_rates(const State             &state,
                                 const EvaluationResults &results) const
  {
    std::vector<double> rates(state.history.size(), 0.);
    for (const auto &[effect, terms] : stage_terms)
      terms->find_internal_rates(state,
                                 results.effect_caches[effect].get(),
                                 rates.data());
    return rates;
  }

  bool Equations::update_couplings(State &accepted)
  {
    return update_pattern(&ChangingCouplings::update_couplings, accepted);
  }

  bool Equations::restart_couplings(State &accepted)
  {
    return update_pattern(&ChangingCouplings::restart_couplings, accepted);
  }

  bool Equations::update_pattern(const CouplingUpdate update, State &accepted)
  {
    bool             changed = false;
    std::vector<int> required_unknowns;
    for (const auto &[effect, couplings] : changing_couplings)
      changed = (couplings->*update)(accepted, required_unknowns) || changed;
    if (unknowns().layout.largest(changed || !required_unknowns.empty()) == 0)
      return false;
    auto       more = std::make_unique<Unknowns>(unknowns());
    const bool grow = more->add_ghosts(required_unknowns);
    if (grow)
      {
        with_ghosts = std::move(more);
        accepted.extend_ghosts(unknowns().layout);
      }
    tangent_pattern.reset(unknowns());
    register_blocks();
    return grow;
  }

  void Equations::row_force_bounds(const Evaluation        &evaluation,
                                   const EvaluationResults &results,
                                   double                  *forces) const
  {
    // Loads are bounded by their sum; inertia balances the other forces.
    Vector loads(unknowns().layout.n_local(), 0.);
    for (unsigned int i = n_balanced; i < effects.size(); ++i)
      effects[i]->add_residual(evaluation,
                               loads.data(),
                               results.effect_caches[i].get());
    for (std::size_t i = 0; i < loads.size(); ++i)
      forces[i] = std::max(forces[i], std::abs(loads[i]));
    for (unsigned int i = 0; i < n_balanced; ++i)
      effects[i]->row_force_bounds(evaluation,
                                   results.effect_caches[i].get(),
                                   forces);
  }

  Vector Equations::round_off(const Evaluation        &evaluation,
                              const EvaluationResults &results) const
  {
    LargestMotion largest;
    std::tie(largest.displacement, largest.rotation) =
      largest_motion(structure, evaluation.to.displacement);
    if (evaluation.to.velocity)
      std::tie(largest.velocity, largest.spin) =
        largest_motion(structure, *evaluation.to.velocity);
    const UnknownLayout &layout = structure.numbering.layout();
    Vector               sizes(unknowns().layout.n_local(), 0.);
    for (unsigned int i = 0; i < effects.size(); ++i)
      effects[i]->roundoff_force_bounds(evaluation,
                                        results.effect_caches[i].get(),
                                        largest,
                                        sizes.data());
    // A row sums a few products with a few roundings each.
    const double safety = 4;
    for (double &size : sizes)
      size *= safety * std::numeric_limits<double>::epsilon() *
        std::sqrt(double(layout.n_global()));
    return sizes;
  }

  double Equations::round_off_floor(const Evaluation        &evaluation,
                                    const EvaluationResults &results) const
  {
    const Vector     sizes = round_off(evaluation, results);
    const OwnedRows &rows  = structure.rows;
    return structure.numbering.layout().largest(
      std::max({largest_size(sizes.data(), rows.free_translations),
                largest_size(sizes.data(), rows.prescribed_translations),
                largest_size(sizes.data(), rows.free_rotations) /
                  structure.mean_strut_length,
                largest_size(sizes.data(), rows.prescribed_rotations) /
                  structure.mean_strut_length}));
  }

  bool Equations::has_contact_candidates() const
  {
    return std::any_of(changing_couplings.begin(),
                       changing_couplings.end(),
                       [](const auto &implementation) {
                         return implementation.terms->has_contact_candidates();
                       });
  }

  std::string Equations::rejection_reason(const Evaluation &step) const
  {
    std::string mine;
    for (const auto &[effect, couplings] : changing_couplings)
      if (const std::string why = couplings->rejection_reason(step);
          mine.empty())
        mine = why;
    return text_of_lowest_rank(structure.numbering.layout(), mine);
  }

  std::string
  Equations::nonfinite_reason(const Evaluation        &evaluation,
                              const EvaluationResults &results) const
  {
    std::string mine;
    for (unsigned int i = 0; i < effects.size() && mine.empty(); ++i)
      mine = effects[i]->nonfinite_reason(evaluation,
                                          results.effect_caches[i].get());
    return text_of_lowest_rank(structure.numbering.layout(), mine);
  }

  std::pair<double, double> largest_motion(const LatticeModel &model,
                                           const Vector       &motion)
  {
    const OwnedRows &rows    = model.rows;
    const double    *values  = motion.data();
    double           mine[2] = {
                std::max(largest_size(values, rows.free_translations),
               largest_size(values, rows.prescribed_translations)),
                std::max(largest_size(values, rows.free_rotations),
               largest_size(values, rows.prescribed_rotations))};
    const UnknownLayout &layout = model.numbering.layout();
    if (layout.n_ranks() == 1)
      return {mine[0], mine[1]};
    double all[2];
    dealii::Utilities::MPI::max(mine, layout.communicator(), all);
    return {all[0], all[1]};
  }

  double constraint_tolerance(const Equations &equations, const State &state)
  {
    const std::vector<const Constraints *> &constraints =
      equations.reporting().constraints;
    if (constraints.empty())
      return 0;
    const LatticeModel &model  = equations.model();
    double              length = model.mean_strut_length;
    for (const Constraints *constraint : constraints)
      length = std::max(length, constraint->length());
    // Only some ranks have constraints, but all must decide alike.
    const double longest = model.numbering.layout().largest(length);
    // A constraint sums a few products of displacements and lengths.
    const double safety = 16;
    return safety * std::numeric_limits<double>::epsilon() *
      (longest + largest_motion(model, state.displacement).first) *
      std::sqrt(double(model.numbering.constraints().n_multipliers()));
  }

  std::string nonfinite_quantity(const LatticeModel &model, const State &state)
  {
    const UnknownLayout &layout = model.numbering.layout();
    std::vector<std::pair<const char *, const Vector *>> motions = {
      {"", &state.displacement}};
    if (state.velocity)
      motions.emplace_back("velocity of the ", &*state.velocity);
    if (state.acceleration)
      motions.emplace_back("acceleration of the ", &*state.acceleration);
    if (state.algorithmic_acceleration)
      motions.emplace_back("auxiliary acceleration of the ",
                           &*state.algorithmic_acceleration);
    bool is_finite = are_finite(state.history.data(), state.history.size()) &&
      are_finite(state.energies.amounts().data(),
                 state.energies.amounts().size());
    for (const auto &[name, motion] : motions)
      is_finite = is_finite && are_finite(motion->data(), layout.n_owned());
    if (layout.largest(is_finite ? 0. : 1.) == 0)
      return "";

    std::string mine;
    for (const auto &[name, motion] : motions)
      for (unsigned int i = 0; i < layout.n_owned() && mine.empty(); ++i)
        if (!std::isfinite((*motion)[i]))
          mine = name + describe(model.numbering, i);
    if (mine.empty() && !are_finite(state.history.data(), state.history.size()))
      mine = "an internal variable of a connector or spring";
    const std::vector<EnergyEntry> &entries = state.energies.ledger().entries();
    for (unsigned int i = 0; i < entries.size() && mine.empty(); ++i)
      if (!std::isfinite(state.energies[i]))
        mine = "the energy " + entries[i].name;
    return text_of_lowest_rank(layout, mine);
  }

  std::string unknown_with_largest_residual(const LatticeModel &model,
                                            const State        &state)
  {
    std::vector<double> sizes(model.numbering.layout().n_owned(), 0.);
    const auto measure = [&](const std::vector<int> &rows, const double unit) {
      for (const int row : rows)
        {
          const double size = std::abs(state.residual[row]) / unit;
          sizes[row] =
            std::isfinite(size) ? size : std::numeric_limits<double>::max();
        }
    };
    measure(model.rows.free_translations, 1.);
    measure(model.rows.free_rotations, model.mean_strut_length);
    return describe_largest(model.numbering, sizes);
  }
} // namespace auxfem
