#ifndef auxfem_struts_effects_damped_velocity_h
#define auxfem_struts_effects_damped_velocity_h

#include <auxfem/equations/evaluation.h>

#include <vector>

namespace auxfem
{
  /** Velocity that damping proportional to it acts on: the one at
   * evaluation.to, with Kind::discrete_gradient the mean of the step. */
  class DampedVelocity
  {
  public:
    /** @p evaluation must outlive the object. */
    explicit DampedVelocity(const Evaluation &evaluation)
      : evaluation(evaluation)
    {
      if (evaluation.kind != Evaluation::Kind::discrete_gradient)
        return;
      const double *before = evaluation.from.velocity->data(),
                   *now    = evaluation.to.velocity->data();
      means.resize(evaluation.to.velocity->size());
      for (std::size_t i = 0; i < means.size(); ++i)
        means[i] = (before[i] + now[i]) / 2;
    }

    /** Values of all local unknowns. */
    const double *values() const
    {
      return means.empty() ? evaluation.to.velocity->data() : means.data();
    }

  private:
    const Evaluation   &evaluation;
    std::vector<double> means; ///< empty except with Kind::discrete_gradient
  };
} // namespace auxfem

#endif
