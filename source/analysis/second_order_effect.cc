#include <auxfem/analysis/second_order_effect.h>
#include <auxfem/equations/displaced_state.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace auxfem
{
  namespace
  {
    SimulatedEffects with_large_rotation(SimulatedEffects simulated)
    {
      simulated.large_rotation = true;
      return simulated;
    }
  } // namespace

  struct SecondOrderEffect::Exact
  {
    Exact(const LatticeModel &small_model, Work &work)
      : model(small_model, with_large_rotation(small_model.plan.simulated))
      , equations(model)
      , solver(equations, model.plan.solver, work)
    {}

    /** K + K_g under the forces of @p motion; false if it has no factors. */
    bool factorize_under(const Vector &motion)
    {
      State rest = state_at_rest();
      // Constraints add what is linear in their forces.
      for (const int i : model.numbering.constraints().multipliers())
        rest.displacement[i] = motion[i];
      const EvaluationResults at_rest     = assemble(rest);
      const auto [displacement, rotation] = largest_motion(model, motion);
      const double size =
        std::max(rotation, displacement / model.mean_strut_length);
      if (size > 0)
        {
          const double part   = finite_difference_step / size;
          State        before = displaced(rest, model.numbering, motion, -part),
                after         = displaced(rest, model.numbering, motion, part);
          const EvaluationResults at_before = results_at(before),
                                  at_after  = results_at(after);
          equations.add_geometric_tangent(
            {rest, before, after, at_rest, at_before, at_after, 1 / (2 * part)},
            solver.matrix());
        }
      // The symmetric part has an inertia; the rest are moments that balance.
      return solver.factorize(Exactness::approximate);
    }

    /** K; false if it has no factors. */
    bool factorize_at_rest()
    {
      State rest = state_at_rest();
      assemble(rest);
      return solver.factorize(Exactness::approximate);
    }

    const LatticeModel model;
    Equations          equations;
    TangentSolver      solver;

  private:
    State state_at_rest() const
    {
      State rest = equations.initial_state();
      for (std::optional<Vector> *rates : {&rest.velocity, &rest.acceleration})
        if (*rates)
          (*rates)->assign((*rates)->size(), 0.);
      return rest;
    }

    /** The stiffness without that by forces. */
    EvaluationResults assemble(State &rest)
    {
      EvaluationResults results = results_at(rest);
      solver.assemble(Evaluation::equilibrium(rest, rest), results, {1, 0, 0});
      return results;
    }

    EvaluationResults results_at(State &at)
    {
      EvaluationResults results = equations.make_results();
      const State       before  = at;
      solver.residual(Evaluation::equilibrium(before, at), results);
      return results;
    }
  };

  SecondOrderEffect::SecondOrderEffect(const Equations &equations)
    : equations(equations)
  {}

  SecondOrderEffect::~SecondOrderEffect() = default;

  Work SecondOrderEffect::take_effort()
  {
    return std::exchange(effort, Work());
  }

  const Equations *SecondOrderEffect::exact_equations()
  {
    if (is_impossible)
      return nullptr;
    try
      {
        if (!exact)
          exact = std::make_unique<Exact>(equations.model(), effort);
      }
    catch (const std::runtime_error &)
      {
        // Supports that large rotations do not allow.
        is_impossible = true;
        return nullptr;
      }
    return &exact->equations;
  }

  std::optional<SecondOrderChange>
  SecondOrderEffect::at(const State &state, const Vector &forces_by_turning)
  {
    if (exact_equations() == nullptr)
      return {};
    SecondOrderChange result;
    try
      {
        if (exact->factorize_under(state.displacement))
          if (const auto negative = exact->solver.new_negative_modes())
            result.is_unstable = negative->n > 0;
        if (result.is_unstable.value_or(true) && !exact->factorize_at_rest())
          return {};
      }
    catch (const std::runtime_error &)
      {
        // Loads that are no number at rest.
        is_impossible = true;
        return {};
      }
    const std::optional<double> relative =
      relative_change(state, forces_by_turning);
    if (!relative)
      return {};
    result.relative = *relative;
    return result;
  }

  std::optional<double> SecondOrderEffect::relative_change(const State  &state,
                                                           const Vector &forces)
  {
    const double largest =
                   largest_motion(equations.model(), state.displacement).first,
                 elastic = state.energies.strain() + state.energies.stored();
    if (largest == 0 || !(elastic > 0))
      return {};
    const Unknowns &unknowns = equations.unknowns();
    Vector          change(forces.size(), 0.);
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      if (unknowns.kinds[i] != UnknownKind::prescribed)
        change[i] = -forces[i];
    if (!exact->solver.solve(change))
      return {};
    double twice_energy = 0;
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      twice_energy -= forces[i] * change[i];
    twice_energy = std::max(0., unknowns.layout.sum(twice_energy));
    return std::max(largest_motion(equations.model(), change).first / largest,
                    std::sqrt(twice_energy / (2 * elastic)));
  }
} // namespace auxfem
