#ifndef auxfem_equations_energy_account_h
#define auxfem_equations_energy_account_h

#include <auxfem/equations/evaluation.h>

#include <optional>

namespace auxfem
{
  /**
   * The motion in a step as the mean of the forces at its ends does work on it,
   * of all local unknowns. What is in excess is round-off for schemes that damp
   * nothing, where neither motions of supports nor rates put right interfere.
   */
  struct StepMotion
  {
    /** Of a step that takes time. */
    explicit StepMotion(const Evaluation &step);

    double dt; ///< s
    /**
     * Increment of the displacement over dt, of large rotations in space
     * material; in a step between two states Cayley's measure of increments.
     */
    Vector rate;

    /** @name Empty without velocities. */
    ///@{
    Vector velocity;    ///< mean of those at both ends
    Vector excess_rate; ///< rate less that
    ///@}

    /** @name Empty without accelerations. */
    ///@{
    /** Increment of the velocity over dt. */
    Vector acceleration;
    /** Mean of the accelerations that forces are balanced with, less that. */
    Vector excess_acceleration;
    ///@}

    /**
     * What the mean inertia force does in the step less the growth of kinetic
     * energy (J), for the constant mass matrix M of which @p product(x, y) is
     * x.M y.
     */
    template <class Product>
    double kinetic_energy_defect(const Product &product) const
    {
      return dt *
        (product(rate, excess_acceleration) +
         product(excess_rate, acceleration));
    }
  };

  /**
   * Whether what StepMotion has in excess in a step with inertia can be more
   * than round-off. Tells in one pass what takes several to compute.
   */
  bool may_have_excess(const Evaluation &step);

  /** Takes down the energies of an evaluation, this rank's share. */
  class EnergyAccount
  {
  public:
    /** Sums of step.to go on from those of step.from. */
    explicit EnergyAccount(const Evaluation &step);

    /** Adds an amount there is now (J). */
    void add(const unsigned int entry, const double energy)
    {
      amounts[entry] += energy;
    }

    /** Adds what was dissipated, taken, or done as work in the step (J). */
    void add_in_step(const unsigned int entry, const double energy)
    {
      sums[entry] += energy;
    }

    /** Adds what a power (W) at a stage contributes to that. */
    void add_power(const unsigned int entry, const double power)
    {
      sums[entry] += step.weight * power;
    }

    /** Whether the evaluation is a step, so that it has a motion. */
    bool takes_time() const
    {
      return step.dt > 0 && step.kind != Evaluation::Kind::stage;
    }

    /** Of the step, which takes time. */
    const StepMotion &motion();

    /**
     * Adds what a constant mass matrix has now, x.M x / 2 of the velocities,
     * and what the scheme takes from it in the step.
     * @param product as for StepMotion::kinetic_energy_defect()
     */
    template <class Product>
    void add_inertia(const unsigned int kinetic_entry,
                     const unsigned int numerical_entry,
                     const Product     &product)
    {
      add(kinetic_entry, product(*step.to.velocity, *step.to.velocity) / 2);
      if (takes_time() && has_excess())
        add_in_step(numerical_entry, motion().kinetic_energy_defect(product));
      if (step.taken_from_kinetic != nullptr)
        for (const Evaluation::Pair &pair : *step.taken_from_kinetic)
          add_in_step(numerical_entry, product(pair.first, pair.second));
    }

    /** Writes the sums to the state, and returns this rank's energies. */
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
