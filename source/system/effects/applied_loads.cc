#include <auxfem/system/effects/applied_loads.h>

namespace auxfem
{
  AppliedLoads::AppliedLoads(const DofNumbering &numbering,
                             const bool          raised_from_zero)
    : numbering(numbering)
    , rotations(numbering)
    , raised_from_zero(raised_from_zero)
  {}

  unsigned int AppliedLoads::add_load(const TimeFunction &course)
  {
    loads.push_back({course, {}});
    return loads.size() - 1;
  }

  void AppliedLoads::add_weight(const unsigned int load,
                                const int          unknown,
                                const double       weight)
  {
    loads[load].weights.push_back({unknown, weight});
  }

  bool AppliedLoads::empty() const
  {
    return loads.empty();
  }

  bool AppliedLoads::is_linear() const
  {
    return true;
  }

  void AppliedLoads::begin_step(const Step &step)
  {
    for (Load &load : loads)
      {
        load.before = raised_from_zero && step.from.time == 0
          ? 0.
          : load.course.value(step.from.time);
        load.now    = load.course.value(step.to.time);
      }
  }

  void AppliedLoads::add_residual(const Step & /*step*/, double *residual)
  {
    for (const Load &load : loads)
      for (const Weight &w : load.weights)
        residual[w.unknown] -= load.now * w.weight;
  }

  void AppliedLoads::accept(const Step &step)
  {
    // The mean force over the step times the displacement: exact for the
    // average-acceleration rule, second order otherwise.
    double work = 0;
    for (const Load &load : loads)
      {
        double along = 0;
        for (const Weight &w : load.weights)
          if (numbering.is_owned(w.unknown))
            along += w.weight * motion(step, w.unknown);
        work += (load.before + load.now) / 2 * along;
      }
    step.to.external_work += work;
  }

  double AppliedLoads::motion(const Step &step, const int unknown) const
  {
    if (const int i = numbering.spatial_rotation(unknown);
        i >= 0 && !step.to.rotations.empty())
      return rotations.spatial_turn(step, i)[numbering.spin_axis(unknown)];
    return step.to.displacement[unknown] - step.from.displacement[unknown];
  }
} // namespace auxfem
