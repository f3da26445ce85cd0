#ifndef auxfem_equations_sliding_h
#define auxfem_equations_sliding_h

#include <auxfem/contact/coulomb_friction.h>
#include <auxfem/equations/energy_account.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/time/static.h>

#include <vector>

namespace auxfem
{
  /**
   * The velocity (m/s) of something that moves by @p motion(displacements), a
   * linear function: that of the time scheme, in a step between two states its
   * mean, without inertia the BackwardDifference.
   */
  template <class Motion>
  dealii::Tensor<1, 3> sliding_velocity(const Evaluation &evaluation,
                                        const Motion     &motion)
  {
    const State &from = evaluation.from, &to = evaluation.to;
    const auto   way = [&motion](const Vector &begin, const Vector &end) {
      return motion(end) - motion(begin);
    };
    if (evaluation.kind == Evaluation::Kind::between)
      return way(from.displacement, to.displacement) / evaluation.dt;
    if (evaluation.kind != Evaluation::Kind::static_step)
      return motion(*to.velocity);
    const BackwardDifference rule(from, evaluation.dt);
    dealii::Tensor<1, 3>     velocity =
      rule.now * way(from.displacement, to.displacement);
    if (from.before)
      velocity -=
        rule.before * way(from.before->displacement, from.displacement);
    return velocity;
  }

  /** Friction at a point, and how far this has moved in a step. */
  struct Sliding
  {
    FrictionForce        friction;
    dealii::Tensor<1, 3> way; ///< m
  };

  /** What friction takes from the energy. */
  class FrictionAccount
  {
  public:
    /** Enters `friction` among the energies. */
    void register_in(StateLayout &layout);

    /** Adds the loss in a step: with inertia the mean of the powers at both
     * ends, else the work.
     * @param at_start none but in steps with inertia */
    void add_step(const Evaluation           &step,
                  const std::vector<Sliding> &at_end,
                  const std::vector<Sliding> &at_start,
                  EnergyAccount              &account) const;

    /** Adds the power lost at an instant (W). */
    void add_power(const FrictionForce &friction, EnergyAccount &account) const;

  private:
    unsigned int friction_entry = 0, numerical_entry = 0;
  };
} // namespace auxfem

#endif
