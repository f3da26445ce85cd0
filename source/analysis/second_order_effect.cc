#include <auxfem/analysis/second_order_effect.h>
#include <auxfem/equations/displaced_state.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace auxfem
{
  namespace
  {
    /** Largest rotation (rad), or displacement over the mean length of struts,
     * of the states whose forces are compared: so small that only the linear
     * part of the forces counts. */
    constexpr double size_of_difference = 1e-3;

    Scene with_large_rotation(const Scene &scene)
    {
      Scene exact                  = scene;
      exact.effects.large_rotation = Switch::on;
      // Struts that touch are no part of the stiffness at rest.
      exact.lattice.struts_may_cross = true;
      return exact;
    }
  } // namespace

  struct SecondOrderEffect::Exact
  {
    Exact(const Scene &small_scene, const LatticeModel &small_model, Work &work)
      : scene(with_large_rotation(small_scene))
      , model(scene, small_model)
      , equations(scene, model)
      , solver(equations, scene.solver, work)
    {}

    /** K + K_g under the forces of @p motion; false if it has no factors. */
    bool factorize(const Vector &motion)
    {
      State rest = equations.initial_state();
      for (std::optional<Vector> *rates : {&rest.velocity, &rest.acceleration})
        if (*rates)
          (*rates)->assign((*rates)->size(), 0.);
      // Constraints add what is linear in their forces.
      for (const int i : model.numbering.constraints().multipliers())
        rest.displacement[i] = motion[i];
      const EvaluationResults at_rest = results_at(rest);
      solver.assemble(Evaluation::equilibrium(rest, rest), at_rest, {1, 0, 0});
      const auto [displacement, rotation] = largest_motion(model, motion);
      const double size =
        std::max(rotation, displacement / model.mean_strut_length);
      if (size > 0)
        {
          const double part   = size_of_difference / size;
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

    const Scene        scene;
    const LatticeModel model;
    Equations          equations;
    TangentSolver      solver;

  private:
    EvaluationResults results_at(State &at)
    {
      EvaluationResults results = equations.make_results();
      const State       before  = at;
      solver.residual(Evaluation::equilibrium(before, at), results);
      return results;
    }
  };

  SecondOrderEffect::SecondOrderEffect(const Scene     &scene,
                                       const Equations &equations)
    : scene(scene)
    , equations(equations)
  {}

  SecondOrderEffect::~SecondOrderEffect() = default;

  Work SecondOrderEffect::take_effort()
  {
    return std::exchange(effort, Work());
  }

  std::optional<double> SecondOrderEffect::at(const State  &state,
                                              const Vector &forces_by_turning)
  {
    const LatticeModel &model = equations.model();
    const double largest      = largest_motion(model, state.displacement).first,
                 elastic = state.energies.strain() + state.energies.stored();
    if (is_impossible || largest == 0 || !(elastic > 0))
      return {};
    try
      {
        if (!exact)
          exact = std::make_unique<Exact>(scene, model, effort);
        if (!exact->factorize(state.displacement))
          return {};
      }
    catch (const std::runtime_error &)
      {
        // Supports that large rotations do not allow, loads that are no number
        // at rest.
        is_impossible = true;
        return {};
      }
    const auto negative = exact->solver.new_negative_modes();
    if (!negative || negative->n > 0)
      return {};
    const UnknownLayout &layout = equations.unknowns().layout;
    Vector               change(forces_by_turning.size(), 0.);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (equations.unknowns().kinds[i] != UnknownKind::prescribed)
        change[i] = -forces_by_turning[i];
    if (!exact->solver.solve(change))
      return {};
    double twice_energy = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      twice_energy -= forces_by_turning[i] * change[i];
    twice_energy = std::max(0., layout.sum(twice_energy));
    return std::max(largest_motion(model, change).first / largest,
                    std::sqrt(twice_energy / (2 * elastic)));
  }
} // namespace auxfem
