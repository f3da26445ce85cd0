#include <auxfem/analysis/guess_ahead.h>

namespace auxfem
{
  namespace
  {
    /**
     * Change of velocities in a short step, over themselves, up to which the
     * next motion is extrapolated.
     * @tuned measured: with three times as much, steps of a collapse fail
     */
    constexpr double small_change = 0.1;

    bool is_short(const Evaluation &step, const LatticeModel &model)
    {
      const UnknownLayout     &layout = model.numbering.layout();
      const std::vector<bool> &is_rotation =
        model.numbering.unknowns().is_rotation;
      const Vector &v = *step.from.velocity, &a = *step.from.acceleration;
      // Of translations, of rotations.
      std::vector<double> velocities(2, 0.), changes(2, 0.);
      for (unsigned int i = 0; i < layout.n_owned(); ++i)
        {
          velocities[is_rotation[i]] += v[i] * v[i];
          changes[is_rotation[i]] += a[i] * a[i];
        }
      velocities        = layout.sum(velocities);
      changes           = layout.sum(changes);
      const double part = small_change / step.dt;
      return changes[0] <= part * part * velocities[0] &&
        changes[1] <= part * part * velocities[1];
    }
  } // namespace

  void guess_ahead(const ImplicitScheme &scheme,
                   const Evaluation     &step,
                   const LatticeModel   &model)
  {
    if (!is_short(step, model))
      return;
    Vector increment(step.from.displacement.size(), 0.);
    add_multiple(step.dt, *step.from.velocity, increment);
    add_multiple(step.dt * step.dt / 2, *step.from.acceleration, increment);
    scheme.correct(step.from, increment, step.dt, step.to);
  }

  void go_on_as_before(const ImplicitScheme &scheme, const Evaluation &step)
  {
    if (!step.from.before)
      return;
    Vector increment = step.from.displacement;
    add_multiple(-1., step.from.before->displacement, increment);
    scale(step.dt / step.from.before->dt, increment);
    scheme.correct(step.from, increment, step.dt, step.to);
  }
} // namespace auxfem
