#include <auxfem/algebra/row_sums.h>
#include <auxfem/analysis/step_error.h>
#include <auxfem/parameters/rounded_text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string displacement_record = "step error: displacements";

    const std::string step_error_record =
      "step error: of displacements, rotations: left of it, slow and fast, of "
      "all steps, largest motions";

    constexpr unsigned int n_values_of_motions = 4;

    /** Displacements of lattices are larger than this part of a strut, or no
     * error is of interest that is a part of it. */
    constexpr double part_of_strut = 0.02;

    /** In an oscillation displacement and velocity err in turn. What is
     * estimated is the first; its mean is so much less than the amplitude. */
    constexpr double of_oscillation = dealii::numbers::PI / 2;

    /** Of schemes with stages: where slow and fast oscillations err together,
     * those in between are taken for less than they are (measured on lattices).
     */
    constexpr double of_several_oscillations = 1.6;

    /** Of what a step errs as much at least is in oscillations that are too
     * slow for physical damping to count on it (measured on lattices). */
    constexpr double part_of_slow = 0.25;

    /** What is left of the tolerance is never taken for less than this part of
     * all, so that steps do not become short for nothing. */
    constexpr double least_left = 0.1;

    /** Of what a step might err if all steps erred alike. Steps that use up
     * what others have left become long, and errors dear. */
    constexpr double largest_share = 1.25;

    /** Of the tolerance, for what steps err more than is wanted of them. */
    constexpr double part_of_tolerance = 0.8;

    /** By so much of what the tolerance grows in a step may the step err. */
    constexpr double part_of_growth = 0.8;

    /** Of the motions so far no errors are allowed beyond this part because of
     * motions to come: where steps hardly follow, no estimate is sure. */
    constexpr double part_of_motions = 1e-3;

    double absolute_tolerance_of(const TimeParameters &parameters,
                                 const LatticeModel   &model)
    {
      return parameters.absolute_tolerance.value_or(
        *parameters.relative_tolerance * part_of_strut *
        model.mean_strut_length);
    }
  } // namespace

  StepError::StepError(const Equations &equations, const Scene &scene)
    : equations(equations)
    , scheme(scene.time.implicit_scheme())
    , tolerance(*scene.time.relative_tolerance)
    , end_time(scene.time.end_time)
    , damping(scene, equations.model())
    , all{Motions{"displacements",
                  "Time/Absolute tolerance",
                  "m",
                  equations.model().rows.free_translations,
                  absolute_tolerance_of(scene.time, equations.model())},
          Motions{"rotations",
                  "Time/Absolute tolerance of rotations",
                  "rad",
                  equations.model().rows.free_rotations,
                  scene.time.absolute_tolerance_of_rotations}}
  {
    if (scheme.stages() != nullptr)
      loads.emplace(scene);
  }

  double StepError::mean(const Motions &motions, const Vector &values) const
  {
    const std::vector<double> total = equations.model().numbering.layout().sum(
      {sum_of_squares(values.data(), motions.rows),
       double(motions.rows.size())});
    return total[1] > 0 ? std::sqrt(total[0] / total[1]) : 0;
  }

  double StepError::allowed(const Motions &motions,
                            const double   largest,
                            const double   time,
                            const double   of_displacements) const
  {
    const double growth = loads ? loads->growth(time) : 1;
    return std::max(std::max(tolerance,
                             std::min(tolerance * growth, part_of_motions)) *
                      largest,
                    motions.absolute_tolerance.value_or(
                      of_displacements / equations.model().mean_strut_length));
  }

  double StepError::allowed_until(const Motions &motions,
                                  const double   time) const
  {
    const Motions &displacements = all.front();
    return allowed(motions,
                   motions.largest,
                   time,
                   allowed(displacements, displacements.largest, time, 0));
  }

  void StepError::estimate(Motions                    &motions,
                           const Evaluation           &step,
                           const double                error,
                           const std::optional<double> angle)
  {
    Motions::Estimate &latest = motions.latest;
    latest.error              = of_oscillation * error;
    latest.largest =
      std::max(motions.largest, mean(motions, step.to.displacement));
    latest.allowed = allowed(motions,
                             latest.largest,
                             step.to.time,
                             all.front().latest.allowed);
    latest.of_slow = angle ? std::min(1., scheme.amplification(*angle)) : 1;
    latest.of_fast = latest.of_slow *
      (angle ? std::exp(-step.dt * damping.rate(*angle / step.dt)) : 1);

    const double wanted = part_of_tolerance * latest.allowed,
                 left =
                   std::max(wanted - motions.left_error(), least_left * wanted),
                 rate  = std::min(left / (end_time - step.from.time),
                                 largest_share * wanted / end_time),
                 grown = wanted -
      part_of_tolerance * allowed_until(motions, step.from.time);
    const auto may_be = [&](const double leaves) {
      return std::max(
        {step.dt * rate, part_of_growth * grown, (1 - leaves) * wanted});
    };
    latest.relative = latest.error *
      (part_of_slow / may_be(latest.of_slow) +
       (1 - part_of_slow) / may_be(latest.of_fast));
  }

  double StepError::relative(const Evaluation &step)
  {
    if (!displacements.has_begun())
      displacements.add(step.from.time, step.from.displacement);
    Vector change = *step.to.acceleration;
    add_multiple(-1., *step.from.acceleration, change);
    const std::optional<Vector> third =
      displacements.with(step.to.time, step.to.displacement, step.dt);
    for (Motions &motions : all)
      {
        double difference = step.dt * step.dt * mean(motions, change);
        if (third)
          difference = std::min(difference, mean(motions, *third));
        estimate(motions,
                 step,
                 std::abs(*scheme.error_constant()) * difference);
      }
    return worst();
  }

  double StepError::relative(const Evaluation         &step,
                             const Stages::Difference &difference)
  {
    for (Motions &motions : all)
      {
        const double of_motion   = mean(motions, difference.displacement),
                     of_velocity = step.dt * mean(motions, difference.velocity);
        const double angle       = of_motion > 0 ? of_velocity / of_motion : 0;
        estimate(motions,
                 step,
                 of_several_oscillations * scheme.error_by_difference(angle) *
                   of_motion,
                 angle);
      }
    return worst();
  }

  double StepError::worst() const
  {
    return std::max(all[0].latest.relative, all[1].latest.relative);
  }

  double StepError::accept(const Evaluation &step)
  {
    for (Motions &motions : all)
      {
        const Motions::Estimate &latest = motions.latest;
        motions.slow_error =
          latest.of_slow * motions.slow_error + part_of_slow * latest.error;
        motions.fast_error = latest.of_fast * motions.fast_error +
          (1 - part_of_slow) * latest.error;
        motions.total_error =
          std::max(motions.total_error, motions.left_error());
        motions.largest = latest.largest;
      }
    if (scheme.stages() == nullptr)
      displacements.add(step.to.time, step.to.displacement);
    return worst();
  }

  double StepError::largest_of_all(const Motions &motions) const
  {
    return motions.absolute_tolerance
      ? motions.largest
      : std::max(motions.largest,
                 all.front().largest / equations.model().mean_strut_length);
  }

  double StepError::total() const
  {
    double total = 0;
    for (const Motions &motions : all)
      if (const double largest = largest_of_all(motions); largest > 0)
        total = std::max(total, motions.total_error / largest);
    return total;
  }

  std::vector<Finding> StepError::findings() const
  {
    std::vector<Finding> findings;
    for (const Motions &motions : all)
      {
        const double largest = largest_of_all(motions);
        if (motions.total_error <= tolerance * largest)
          continue;
        std::ostringstream text;
        text << "The error of the time integration is estimated at up to "
             << motions.total_error << ' ' << motions.unit << ", "
             << percentage_text(motions.total_error / largest, 3) << " of the "
             << motions.name << ", more than Time/Relative tolerance allows. ";
        if (allowed_until(motions, end_time) > tolerance * largest)
          text << "Set " << motions.parameter << " to " << tolerance * largest
               << ' ' << motions.unit;
        else
          text << "Set it to "
               << tolerance * tolerance * largest / motions.total_error;
        text << ", or reduce Time/Smallest time step.";
        findings.push_back({Verdict::doubtful, text.str(), 0, ""});
      }
    return findings;
  }

  void StepError::save(Records &records) const
  {
    std::vector<double> values;
    for (const Motions &motions : all)
      values.insert(values.end(),
                    {motions.slow_error,
                     motions.fast_error,
                     motions.total_error,
                     motions.largest});
    records.keep(step_error_record, values);
    displacements.save(displacement_record,
                       UnknownRecords(equations.model().numbering),
                       records);
  }

  void StepError::resume(const Records &records)
  {
    const std::vector<double> values =
      records.values(step_error_record, all.size() * n_values_of_motions);
    auto value = values.begin();
    for (Motions &motions : all)
      {
        motions.slow_error  = *value++;
        motions.fast_error  = *value++;
        motions.total_error = *value++;
        motions.largest     = *value++;
      }
    displacements.resume(displacement_record,
                         UnknownRecords(equations.model().numbering,
                                        equations.unknowns().layout),
                         records);
  }
} // namespace auxfem
