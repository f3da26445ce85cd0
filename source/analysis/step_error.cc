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
      "step error: of all steps, largest displacements";

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
    , tolerance(*parameters.relative_tolerance)
    , end_time(parameters.end_time)
    , constant(*parameters.implicit_scheme().error_constant())
    , absolute_tolerance(absolute_tolerance_of(parameters, equations.model()))
  {}

  double StepError::relative(const Evaluation &step,
                             const Vector     &acceleration_change)
  {
    const LatticeModel &model  = equations.model();
    const Vector       &motion = step.to.displacement;
    // of changes, of displacements, and how many
    std::vector<double> squares(3, 0.);
    for (const unsigned int i : model.rows.free_translations)
      {
        squares[0] += acceleration_change[i] * acceleration_change[i];
        squares[1] += motion[i] * motion[i];
        squares[2] += 1;
      }
    squares      = model.numbering.layout().sum(squares);
    latest.error = of_oscillation * std::abs(constant) * step.dt * step.dt *
      std::sqrt(squares[0] / squares[2]);
    latest.motion =
      std::max(largest_motion_so_far, std::sqrt(squares[1] / squares[2]));
    const double allowed =
      std::max(tolerance * latest.motion, absolute_tolerance);
    latest.relative = latest.error / (allowed * step.dt / end_time);
    return latest.relative;
  }

  double StepError::total() const
  {
    return largest_motion_so_far > 0 ? total_error / largest_motion_so_far : 0;
  }

  double StepError::accept()
  {
    total_error += latest.error;
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
    records.keep(step_error_record, {total_error, largest_motion_so_far});
  }

  void StepError::resume(const Records &records)
  {
    const std::vector<double> values = records.values(step_error_record, 2);
    total_error                      = values[0];
    largest_motion_so_far            = values[1];
  }
} // namespace auxfem
