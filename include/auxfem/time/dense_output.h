#ifndef auxfem_time_dense_output_h
#define auxfem_time_dense_output_h

#include <auxfem/equations/node_rotations.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/output/recorder.h>

#include <vector>

namespace auxfem
{
  /**
   * Dense output: solutions within a step, at times that a recorder requests.
   * With inertia, motions are quintic Hermite polynomials of displacement,
   * velocity and acceleration (E. Hairer, S. P. Norsett & G. Wanner, Solving
   * Ordinary Differential Equations I, section II.6); rotations in space use
   * their vector since the start of the step. Internal variables, work and
   * dissipation are cubic for schemes with stages. Everything else is linear,
   * as are forces and energies where the interpolated motion is out of
   * equilibrium.
   */
  class DenseOutput
  {
  public:
    /** @p equations must outlive the object. */
    DenseOutput(const Equations &equations, const ImplicitScheme &scheme);

    /**
     * Passes to @p recorder all solutions that it requests in an accepted
     * step, its end included. Collective.
     * @param from, to ends of the step
     * @param event_at_from, event_at_to as in its evaluation (s)
     * @param nearness below which times are equal (s)
     */
    void record(const Solution          &from,
                const Solution          &to,
                std::optional<double>    event_at_from,
                std::optional<TimeLimit> event_at_to,
                double                   nearness,
                TangentSolver           &solver,
                Recorder                &recorder) const;

  private:
    /** Rates at one end of a step. */
    struct Rates
    {
      std::vector<double> history, energy_sums;
    };

    /** Rates at both ends, for schemes with stages. */
    struct EndRates
    {
      Rates from, to;
    };

    /**
     * The start of a step, evaluated at its own rates instead of those of the
     * former step, so that resumed runs have the same forces.
     */
    Solution evaluate_start(const Solution &start, TangentSolver &solver) const;
    Rates    rates(const Solution &end, std::optional<TimeLimit> event) const;
    /** Whether forces at the motion @p between, within the step, balance. */
    bool is_equilibrium(const Solution &from,
                        const Solution &to,
                        const Solution &between) const;
    /** Interpolates reactions and energies of @p between linearly. */
    void interpolate_forces(const Solution &from,
                            const Solution &to,
                            Solution       &between) const;
    /** Displacements and their rates, and rotations, at between.time. */
    void interpolate_motion(const Evaluation &between, const State &end) const;
    void interpolate_rotations(const Evaluation &between,
                               const State      &end) const;
    /** Quantities that are integrals over time. */
    void interpolate_integrals(const State    &from,
                               const State    &to,
                               const EndRates *rates,
                               State          &between) const;

    const Equations    &equations;
    const NodeRotations rotations;
    const bool          has_stages;
  };
} // namespace auxfem

#endif
