#include <auxfem/analysis/simulation/nearby_run.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/parameters/errors.h>

#include <utility>

namespace auxfem
{
  namespace
  {
    /**
     * Corrections of an equilibrium. The first one has the first order; of the
     * second order it leaves axial forces, with which slender struts would bend
     * much.
     * @tuned observed: a fourth one changes no digit
     */
    constexpr unsigned int n_corrections = 3;
  } // namespace

  bool has_independent_equilibria(const Equations &equations)
  {
    return !equations.model().plan.simulated.inertia &&
      !equations.layout().velocity &&
      equations.layout().history.n_values() == 0 &&
      equations.reporting().plates == nullptr &&
      !equations.has_contact_candidates();
  }

  EquilibriumTangent::EquilibriumTangent(LatticeRun &run)
    : run(run)
    , tangent(run.equations, run.model.plan.solver, run.work())
    , results(run.equations.make_results())
  {}

  void EquilibriumTangent::update()
  {
    if (is_constant)
      return;
    State            state = run.solution.state;
    const Evaluation equilibrium =
      Evaluation::equilibrium(run.solution.state, state);
    tangent.residual(equilibrium, results);
    tangent.assemble(equilibrium, results, {1., 0., 0.});
    if (!tangent.factorize())
      throw ComputationError("The tangent at an equilibrium is singular: " +
                             tangent.last_failure());
    is_constant = run.equations.is_linear();
  }

  void expect_equal_unknowns(const LatticeRun &run, const LatticeRun &other)
  {
    if (run.solution.state.displacement.size() !=
        other.solution.state.displacement.size())
      throw InputError("The scene has other unknowns with changed parameters.");
  }

  NearbyRun::NearbyRun(const RunPlan    &plan,
                       const LatticeRun &followed,
                       const MPI_Comm    communicator)
    : run(plan, communicator)
    , trial(run.solution.state)
    , results(run.equations.make_results())
    , rotations(run.model.numbering)
    , base_before(followed.solution.state.displacement)
  {
    expect_equal_unknowns(run, followed);
    run.start();
  }

  void NearbyRun::follow(const Solution &base, TangentSolver &tangent)
  {
    State           &from = run.solution.state;
    const double     dt   = base.state.time - from.time;
    const Evaluation step = Evaluation::static_step(from, trial, dt);
    trial.time            = base.state.time;
    trial.step            = base.state.step;
    scheme.predict(from, dt, trial);
    // The same increment as that of the run.
    Vector increment(base_before.size());
    for (std::size_t i = 0; i < increment.size(); ++i)
      increment[i] = base.state.displacement[i] - base_before[i] -
        (trial.displacement[i] - from.displacement[i]);
    scheme.correct(from, increment, dt, trial);
    rotations.follow(step);

    run.equations.residual(step, results);
    for (unsigned int i = 0; i < n_corrections; ++i)
      {
        find_right_side(run.model, step, increment.data());
        if (!tangent.solve(increment))
          throw ComputationError(
            "The equations of derivatives cannot be solved: " +
            tangent.last_failure());
        rotations.rotate(step, increment);
        scheme.correct(from, increment, dt, trial);
        run.equations.residual(step, results);
      }
    run.equations.accept(step, results);
    std::swap(run.solution.state, trial);
    std::swap(run.solution.results, results);
    base_before = base.state.displacement;
  }
} // namespace auxfem
