#ifndef auxfem_equations_energy_account_h
#define auxfem_equations_energy_account_h

#include <auxfem/equations/evaluation.h>

#include <optional>

namespace auxfem
{
  /**
   * Motion of a step on which the mean of the end forces does work, for all
   * local unknowns. The excess is round-off for undamped schemes, unless
   * supports move or rates are corrected.
   */
  struct StepMotion
  {
    /** @param step with a length above 0 */
    explicit StepMotion(const Evaluation &step);

    double dt; ///< s
    /** Displacement increment over dt. Large rotations in space are material;
     * discrete gradients use the Cayley measure. */
    Vector rate;

    /** @name Empty without velocities. */
    ///@{
    Vector velocity;    ///< mean of both ends
    Vector excess_rate; ///< rate minus velocity
    ///@}

    /** @name Empty without accelerations. */
    ///@{
    /** Velocity increment over dt. */
    Vector acceleration;
    /** Mean acceleration of the force balance minus `acceleration`. */
    Vector excess_acceleration;
    ///@}

    /** Work of the mean inertia force minus the growth of kinetic energy (J),
     * for a constant mass matrix with @p product(x, y) = x.M y. */
    template <class Product>
    double kinetic_energy_defect(const Product &product) const
    {
      return dt *
        (product(rate, excess_acceleration) +
         product(excess_rate, acceleration));
    }
  };

  /**
   * Whether the excess of StepMotion can exceed round-off. One cheap pass that
   * avoids the full computation.
   */
  bool may_have_excess(const Evaluation &step);

  /** Accumulates the energies of an evaluation, for the share of this rank. */
  class EnergyAccount
  {
  public:
    /** The sums of step.to start from those of step.from. */
    explicit EnergyAccount(const Evaluation &step);

    /** Adds a stored energy (J). */
    void add(const unsigned int entry, const double energy)
    {
      amounts[entry] += energy;
    }

    /** Adds dissipation or work of the step (J). */
    void add_in_step(const unsigned int entry, const double energy)
    {
      sums[entry] += energy;
    }

    /** Adds the contribution of a power (W) at a stage. */
    void add_power(const unsigned int entry, const double power)
    {
      sums[entry] += step.weight * power;
    }

    /** Whether the evaluation is a step with a motion. */
    bool has_duration() const
    {
      return step.dt > 0 && step.kind != Evaluation::Kind::stage;
    }

    /** Motion of the step; requires has_duration(). */
    const StepMotion &motion();

    /** Adds the kinetic energy v.M v / 2 of a constant mass matrix and its
     * numerical loss in the step.
     * @param product as for StepMotion::kinetic_energy_defect() */
    template <class Product>
    void add_inertia(const unsigned int kinetic_entry,
                     const unsigned int numerical_entry,
                     const Product     &product)
    {
      add(kinetic_entry, product(*step.to.velocity, *step.to.velocity) / 2);
      if (has_duration() && has_excess())
        add_in_step(numerical_entry, motion().kinetic_energy_defect(product));
      if (step.kinetic_defect_terms != nullptr)
        for (const Evaluation::Pair &pair : *step.kinetic_defect_terms)
          add_in_step(numerical_entry, product(pair.first, pair.second));
    }

    /** Writes the sums to the state and returns the energies of this rank. */
    std::vector<double> close();

  private:
    bool has_excess();

    const Evaluation         &step;
    std::vector<double>       amounts, sums;
    std::optional<StepMotion> motion_of_step;
    std::optional<bool>       step_has_excess;
  };
} // namespace auxfem

#endif
