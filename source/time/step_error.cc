#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/text.h>
#include <auxfem/time/schemes/step_control.h>
#include <auxfem/time/step_error.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  std::optional<Vector>
  BackwardDifferences::difference(const unsigned int order,
                                  const double       time,
                                  const Vector      &now,
                                  const double       dt) const
  {
    Assert(order <= largest_order, dealii::ExcInternalError());
    if (samples.size() < order)
      return {};
    std::vector<double>         times;
    std::vector<const Vector *> values;
    for (std::size_t i = samples.size() - order; i < samples.size(); ++i)
      {
        times.push_back(samples[i].time);
        values.push_back(&samples[i].value);
      }
    times.push_back(time);
    values.push_back(&now);
    // Later values may have more ghosts.
    Vector result(values.front()->size(), 0.);
    for (unsigned int i = 0; i <= order; ++i)
      {
        double weight = 1;
        for (unsigned int j = 0, n = 1; j <= order; ++j)
          if (j != i)
            weight *= n++ * dt / (times[i] - times[j]);
        add_multiple(weight, *values[i], result);
      }
    return result;
  }

  void BackwardDifferences::add(const double time, const Vector &value)
  {
    if (samples.size() == largest_order)
      samples.pop_front();
    samples.push_back({time, value});
  }

  void BackwardDifferences::serialize(const std::string    &name,
                                      const UnknownRecords &unknowns,
                                      CheckpointArchive    &archive)
  {
    std::size_t n = samples.size();
    archive.values(name + ": number", n);
    samples.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const std::string sample_name = name + " " + std::to_string(i);
        archive.values(sample_name + ": time", samples[i].time);
        unknowns.serialize(sample_name, samples[i].value, archive);
      }
  }

  void AccumulatedError::add(const LocalError &step)
  {
    sum = step.amplification * sum + step.size;
    slow += step.slow;
    if (step.oscillation)
      {
        Octave &octave = octaves[std::ilogb(step.oscillation->frequency)];
        octave.error += step.size;
        octave.largest_amplitude =
          std::max(octave.largest_amplitude, step.oscillation->amplitude);
      }
    else
      unbounded += step.size;
    largest = std::max(largest, total());
  }

  double AccumulatedError::total() const
  {
    double bounded = slow + unbounded;
    for (const auto &[exponent, octave] : octaves)
      bounded += std::min(octave.error, 2 * octave.largest_amplitude);
    return std::min(sum, bounded);
  }

  void AccumulatedError::serialize(const std::string &name,
                                   CheckpointArchive &archive)
  {
    archive.values(name, sum, slow, unbounded, largest);
    std::vector<double> values;
    for (const auto &[exponent, octave] : octaves)
      values.insert(values.end(),
                    {double(exponent), octave.error, octave.largest_amplitude});
    archive.list(name + ", octaves", values);
    octaves.clear();
    for (std::size_t i = 0; i < values.size(); i += 3)
      octaves[values[i]] = {values[i + 1], values[i + 2]};
  }

  namespace
  {
    /**
     * Default absolute tolerance over the relative one and the mean strut
     * length.
     */
    constexpr double part_of_strut = 0.02;

    /**
     * Ratio of an oscillation's error to the estimate, which considers only
     * the displacement and not the velocity.
     */
    constexpr double oscillation_factor = dealii::numbers::PI / 2;

    /**
     * Smallest part of a uniform share of the tolerance that a step may use.
     * @tuned judgement: past errors cannot be undone
     */
    constexpr double smallest_share = 0.1;

    double absolute_tolerance_of(const LatticeModel &model)
    {
      const TimeParameters &parameters = model.plan.time;
      return parameters.absolute_tolerance.value_or(
        *parameters.relative_tolerance * part_of_strut *
        model.mean_strut_length);
    }
  } // namespace

  StepError::StepError(const Equations &equations)
    : equations(equations)
    , scheme(equations.model().plan.time.implicit_scheme())
    , tolerance(*equations.model().plan.time.relative_tolerance)
    , end_time(equations.model().plan.time.end_time)
    , sampling_interval(equations.model().plan.time.step)
    , all{Motions{"displacements",
                  "Time/Absolute tolerance",
                  "m",
                  equations.model().rows.free_translations,
                  absolute_tolerance_of(equations.model())},
          Motions{"rotations",
                  "Time/Absolute tolerance of rotations",
                  "rad",
                  equations.model().rows.free_rotations,
                  equations.model().plan.time.absolute_tolerance_of_rotations}}
  {}

  double StepError::mean(const Motions &motions, const Vector &values) const
  {
    const std::vector<double> total = equations.model().numbering.layout().sum(
      {sum_of_squares(values.data(), motions.rows),
       double(motions.rows.size())});
    return total[1] > 0 ? std::sqrt(total[0] / total[1]) : 0;
  }

  double StepError::allowed(const Motions &motions,
                            const double   largest,
                            const double   largest_displacement) const
  {
    const double displacement = std::max(tolerance * largest_displacement,
                                         *all.front().absolute_tolerance);
    return std::max(tolerance * largest,
                    motions.absolute_tolerance.value_or(
                      displacement / equations.model().mean_strut_length));
  }

  void StepError::estimate(Motions          &motions,
                           const Evaluation &step,
                           const LocalError &local)
  {
    Motions::Estimate &latest = motions.latest;
    latest.largest =
      std::max(motions.largest, mean(motions, step.to.displacement));
    latest.error = motions.error;
    latest.error.add(local);
    const Motions &translations = all.front();
    const double   target       = step_safety_factor *
      allowed(motions, latest.largest, translations.latest.largest),
                 previous_target = step_safety_factor *
      allowed(motions, motions.largest, translations.largest);
    const double used = local.amplification * motions.error.total(),
                 rate = std::max((target - used) / (end_time - step.from.time),
                                 smallest_share * target / end_time);
    // A step may use its share of the remaining time, the tolerance that the
    // motion adds, or earlier errors that the scheme damps.
    const double usable =
      std::max({rate * step.dt,
                step_safety_factor * (target - previous_target),
                (1 - local.amplification) * target});
    latest.relative = std::max(0., latest.error.total() - used) / usable;
  }

  std::optional<LocalError::Oscillation>
  StepError::dominant_oscillation(const Motions    &motions,
                                  const Evaluation &step,
                                  const double      third) const
  {
    const auto size = [&](const unsigned int order) {
      const std::optional<Vector> difference =
        displacements.difference(order,
                                 step.to.time,
                                 step.to.displacement,
                                 step.dt);
      return difference ? mean(motions, *difference) : 0.;
    };
    const double second = size(2), fourth = size(4);
    if (!(fourth > 0 && second > 0))
      return {};
    // Second and fourth derivative are in phase, the third lags a quarter
    // period. No oscillation sampled in steps has a ratio above 4.
    const double ratio = std::min(4., fourth / second),
                 angle = std::sqrt(ratio);
    return LocalError::Oscillation{angle / step.dt,
                                   std::hypot(second, third / angle) / ratio};
  }

  LocalError StepError::local_error(const Motions    &motions,
                                    const Evaluation &step) const
  {
    const double factor =
      oscillation_factor * std::abs(*scheme.error_constant());
    Vector change = *step.to.acceleration;
    add_multiple(-1., *step.from.acceleration, change);
    double     difference = step.dt * step.dt * mean(motions, change);
    LocalError local;
    if (const std::optional<Vector> vector =
          displacements.difference(3,
                                   step.to.time,
                                   step.to.displacement,
                                   step.dt))
      {
        const double third = mean(motions, *vector);
        difference         = std::min(difference, third);
        local.oscillation  = dominant_oscillation(motions, step, third);
      }
    local.size = factor * difference;
    local.slow = local.size;
    if (motions.slow_third_derivative)
      local.slow = std::min(local.size,
                            factor * *motions.slow_third_derivative *
                              std::pow(step.dt, 3));
    return local;
  }

  double StepError::relative(const Evaluation &step)
  {
    if (displacements.is_empty())
      {
        displacements.add(step.from.time, step.from.displacement);
        samples.add(step.from.time, step.from.displacement);
      }
    for (Motions &motions : all)
      estimate(motions, step, local_error(motions, step));
    return largest_relative();
  }

  double StepError::relative(const Evaluation         &step,
                             const Stages::Difference &difference)
  {
    for (Motions &motions : all)
      {
        const double displacement = mean(motions, difference.displacement),
                     velocity = step.dt * mean(motions, difference.velocity);
        const double angle    = displacement > 0 ? velocity / displacement : 0;
        const double error =
          oscillation_factor * scheme.error_by_difference(angle) * displacement;
        estimate(motions,
                 step,
                 {error, error, {}, std::min(1., scheme.amplification(angle))});
      }
    return largest_relative();
  }

  double StepError::largest_relative() const
  {
    return std::max(all[0].latest.relative, all[1].latest.relative);
  }

  double StepError::accept(const Evaluation &step)
  {
    for (Motions &motions : all)
      {
        motions.error   = motions.latest.error;
        motions.largest = motions.latest.largest;
      }
    if (scheme.stages() == nullptr)
      {
        displacements.add(step.to.time, step.to.displacement);
        sample(step.to);
      }
    return largest_relative();
  }

  void StepError::sample(const State &state)
  {
    const double interval = state.time - samples.latest_time();
    if (interval < (1 - input_precision) * sampling_interval)
      return;
    if (const std::optional<Vector> third =
          samples.difference(3, state.time, state.displacement, interval))
      for (Motions &motions : all)
        motions.slow_third_derivative =
          mean(motions, *third) / std::pow(interval, 3);
    samples.add(state.time, state.displacement);
  }

  double StepError::reference(const Motions &motions) const
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
      if (const double largest = reference(motions); largest > 0)
        total = std::max(total, motions.error.largest_total() / largest);
    return total;
  }

  std::vector<Finding> StepError::findings() const
  {
    std::vector<Finding> findings;
    for (const Motions &motions : all)
      {
        const double largest = reference(motions),
                     error   = motions.error.largest_total();
        if (error <= tolerance * largest)
          continue;
        std::ostringstream text;
        text << "The error of the time integration is estimated at up to "
             << error << ' ' << motions.unit << ", "
             << percentage_text(error / largest, 3) << " of the "
             << motions.name << ", more than Time/Relative tolerance allows. ";
        if (allowed(motions, motions.largest, all.front().largest) >
            tolerance * largest)
          text << "Set " << motions.parameter << " to " << tolerance * largest
               << ' ' << motions.unit;
        else
          text << "Set it to " << tolerance * tolerance * largest / error;
        text << ", or reduce Time/Smallest time step.";
        findings.push_back({Verdict::doubtful, text.str(), 0, ""});
      }
    return findings;
  }

  void StepError::serialize(CheckpointArchive &archive)
  {
    for (Motions &motions : all)
      {
        const std::string name = std::string("error of ") + motions.name;
        archive.values(name, motions.largest, motions.slow_third_derivative);
        motions.error.serialize(name + ", accumulated", archive);
      }
    const UnknownRecords unknowns(equations.model().numbering);
    displacements.serialize("step error: displacements at steps",
                            unknowns,
                            archive);
    samples.serialize("step error: sampled displacements", unknowns, archive);
  }
} // namespace auxfem
