#ifndef auxfem_time_dense_output_h
#define auxfem_time_dense_output_h

#include <auxfem/equations/node_rotations.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/output/recorder.h>

#include <vector>

namespace auxfem
{
  /**
   * Dense output: solutions at times within a step, for a recorder that asks
   * for them. With inertia motions are Hermite's quintic polynomials of
   * displacement, velocity and acceleration at both ends (E. Hairer, S. P.
   * Norsett & G. Wanner, Solving Ordinary Differential Equations I, section
   * II.6), rotations in space by their vector since the start of the step.
   * Internal variables, work and dissipation are cubic where the scheme has
   * stages, else linear, as all is without inertia. Forces are those at that
   * motion; where these are out of equilibrium, as those of struts that are
   * stiff for the step, forces and energies are linear between the ends of the
   * step. Else nothing is of lower order than the scheme, up to order 4.
   */
  class DenseOutput
  {
  public:
    /** @p equations must outlive the object. */
    DenseOutput(const Equations &equations, const ImplicitScheme &scheme);

    /**
     * Tells @p recorder of all solutions that it asks for in an accepted step,
     * also at its end. Collective.
     * @param from, to its ends
     * @param event_at_from, event_at_to as in its evaluation (s)
     * @param nearness of times that are the same (s)
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

    /** Only of a scheme with stages. */
    struct EndRates
    {
      Rates from, to;
    };

    /** The start of a step, evaluated at its own rates, not by the step that
     * led there: so a resumed run has the same forces. */
    Solution evaluate_start(const Solution &start, TangentSolver &solver) const;
    Rates    rates(const Solution &end, std::optional<TimeLimit> event) const;
    /** Whether forces at the motion of @p between, within the step, balance. */
    bool is_equilibrium(const Solution &from,
                        const Solution &to,
                        const Solution &between) const;
    /** Reactions and energies of @p between by those of the ends. */
    void interpolate_forces(const Solution &from,
                            const Solution &to,
                            Solution       &between) const;
    /** Displacements with their rates, and rotations, at between.time. */
    void move(const Evaluation &between, const State &end) const;
    void rotate(const Evaluation &between, const State &end) const;
    /** What follows from motions by integration over time. */
    void integrate(const State    &from,
                   const State    &to,
                   const EndRates *rates,
                   State          &between) const;

    const Equations    &equations;
    const NodeRotations rotations;
    const bool          has_stages;
  };
} // namespace auxfem

#endif
