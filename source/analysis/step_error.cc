#include <auxfem/analysis/step_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string step_error_record =
      "step error: left of it, of all steps, largest displacements";

    /** Displacements of lattices are larger than this part of a strut, or no
     * error is of interest that is a part of it. */
    constexpr double part_of_strut = 0.02;

    /** In an oscillation displacement and velocity err in turn. What is
     * estimated is the first; its mean is so much less than the amplitude. */
    constexpr double of_oscillation = dealii::numbers::PI / 2;

    double absolute_tolerance_of(const TimeParameters &parameters,
                                 const LatticeModel   &model)
    {
      return parameters.absolute_tolerance.value_or(
        *parameters.relative_tolerance * part_of_strut *
        model.mean_strut_length);
    }
  } // namespace

  StepError::StepError(const Equations      &equations,
                       const TimeParameters &parameters)
    : equations(equations)
    , scheme(parameters.implicit_scheme())
    , tolerance(*parameters.relative_tolerance)
    , end_time(parameters.end_time)
    , constant(*scheme.error_constant())
    , absolute_tolerance(absolute_tolerance_of(parameters, equations.model()))
  {}

  double StepError::mean(const Vector &motion) const
  {
    const LatticeModel &model = equations.model();
    double              sum   = 0;
    for (const unsigned int i : model.rows.free_translations)
      sum += motion[i] * motion[i];
    const std::vector<double> all = model.numbering.layout().sum(
      {sum, double(model.rows.free_translations.size())});
    return std::sqrt(all[0] / all[1]);
  }

  double StepError::relative(const Evaluation &step)
  {
    Vector change = *step.to.acceleration;
    add_multiple(-1., *step.from.acceleration, change);
    return relative(step, step.dt * step.dt * mean(change), /*damping=*/0);
  }

  double StepError::relative(const Evaluation         &step,
                             const Stages::Difference &difference)
  {
    const double of_displacement = mean(difference.displacement),
                 of_velocity     = step.dt * mean(difference.velocity);
    const double angle =
      of_displacement > 0 ? of_velocity / of_displacement : 0;
    return relative(step,
                    std::min(of_displacement, of_velocity),
                    1 - std::min(1., scheme.amplification(angle)));
  }

  double StepError::relative(const Evaluation &step,
                             const double      difference,
                             const double      damping)
  {
    latest.error   = of_oscillation * std::abs(constant) * difference;
    latest.damping = damping;
    latest.motion = std::max(largest_motion_so_far, mean(step.to.displacement));
    const double allowed =
      std::max(tolerance * latest.motion, absolute_tolerance);
    latest.relative =
      latest.error / (allowed * std::max(step.dt / end_time, damping));
    return latest.relative;
  }

  double StepError::total() const
  {
    return largest_motion_so_far > 0 ? total_error / largest_motion_so_far : 0;
  }

  double StepError::accept()
  {
    left_error            = (1 - latest.damping) * left_error + latest.error;
    total_error           = std::max(total_error, left_error);
    largest_motion_so_far = latest.motion;
    return latest.relative;
  }

  std::vector<Finding> StepError::findings() const
  {
    const double allowed = tolerance * largest_motion_so_far;
    if (total_error <= allowed)
      return {};
    std::ostringstream text;
    text << "The error of the time integration is estimated at up to "
         << total_error << " m, " << 100 * total()
         << " % of the displacements, more than Time/Relative tolerance "
            "allows. Set Time/Absolute tolerance to "
         << allowed << " m, or reduce Time/Smallest time step.";
    return {{Verdict::doubtful, text.str(), 0, ""}};
  }

  void StepError::save(Records &records) const
  {
    records.keep(step_error_record,
                 {left_error, total_error, largest_motion_so_far});
  }

  void StepError::resume(const Records &records)
  {
    const std::vector<double> values = records.values(step_error_record, 3);
    left_error                       = values[0];
    total_error                      = values[1];
    largest_motion_so_far            = values[2];
  }
} // namespace auxfem
