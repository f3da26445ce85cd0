#include <auxfem/output/verdict.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/text.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Part of the largest energy below which motion is negligible beside the
     * deformation, as under friction; such steps do not count.
     */
    constexpr double least_kinetic_part =
      2 * noticeable_fraction * noticeable_fraction;

    /**
     * Doubtful rotation increment of a joint in one step.
     * @tuned [rad] judgement
     */
    constexpr double doubtful_increment = 0.5;

    /**
     * Step error of the trapezoidal rule, dt^3 u''' / 12, by the third
     * difference of displacements; accelerations may ring where displacements
     * do not. Sums over all unknowns and sampled steps weigh each motion by
     * its path length. Other schemes convert the error by
     * ImplicitScheme::missed_phase().
     */
    class StepWatch : public Watch
    {
    public:
      explicit StepWatch(const WatchContext &run)
        : Watch(SamplingRate::bursts)
        , scene_step(run.plan.time.step)
        , errors_are_estimated(run.plan.time.relative_tolerance.has_value())
        , scheme(run.plan.time.implicit_scheme())
        , equations(run.equations)
        , error(run.statistics.number("steps: error (m)"))
        , path_length(run.statistics.number("steps: way (m)"))
        , unsampled_path_length(
            run.statistics.number("steps: way not judged (m)"))
        , time(run.statistics.number("steps: time (s)"))
        , largest_energy(run.statistics.number("steps: largest energy (J)"))
        , largest_increment(run.statistics.largest("steps: rotation (rad)"))
        , rows(run.equations.model().rows)
        , rates(rows.free_translations.size())
        , accelerations(rates)
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        // Rates and accelerations are discontinuous at a jump.
        if (step.event_at_from)
          forget_steps();
        add_path_length(step);
        add_increment(step);
        time = step.to.time;
      }

      void forget_steps() override
      {
        n_before = 0;
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> findings;
        if (path_length > 0)
          {
            const double missed = scheme.missed_phase(error / path_length);
            if (!(missed <= doubtful_error))
              findings.push_back(error_finding(missed));
          }
        else if (unsampled_path_length > 0 && !errors_are_estimated)
          findings.push_back(too_few_steps());
        if (largest_increment.value > doubtful_increment)
          {
            std::ostringstream text;
            text << "A joint rotates by " << largest_increment.value
                 << " rad in one step; shorten Time/Time step.";
            findings.push_back(
              {Verdict::doubtful, text.str(), largest_increment.time, ""});
          }
        return findings;
      }

    private:
      void add_path_length(const Evaluation &step)
      {
        const double  per_step = 1 / step.dt;
        const double  per_mean = n_before > 0 ? 2 / (step.dt + dt_before) : 0;
        const double *before   = step.from.displacement.data(),
                     *now      = step.to.displacement.data();
        double path_increment = 0, change = 0;
        for (std::size_t k = 0; k < rates.size(); ++k)
          {
            const int    i            = rows.free_translations[k];
            const double increment    = now[i] - before[i];
            const double rate         = increment * per_step;
            const double acceleration = (rate - rates[k]) * per_mean;
            path_increment += std::abs(increment);
            change += std::abs(acceleration - accelerations[k]);
            rates[k]         = rate;
            accelerations[k] = acceleration;
          }
        const std::vector<double> sums =
          equations.unknowns().layout.sum({path_increment, change});
        const Energies &energies = step.to.energies;
        largest_energy =
          std::max(largest_energy, energies.kinetic() + energies.stored());
        const bool is_relevant =
          std::max(step.from.energies.kinetic(), energies.kinetic()) >=
          least_kinetic_part * largest_energy;
        if (is_relevant && n_before > 1)
          {
            path_length += sums[0];
            error += sums[1] * step.dt * step.dt * step.dt / dt_before / 12;
          }
        else if (is_relevant)
          unsampled_path_length += sums[0];
        n_before  = std::min(n_before + 1, 2u);
        dt_before = step.dt;
      }

      void add_increment(const Evaluation &step)
      {
        // Step lengths hardly affect small rotations.
        if (equations.is_linear())
          return;
        double increment = 0;
        for (const int i : rows.free_rotations)
          increment = std::max(increment,
                               std::abs(step.to.displacement[i] -
                                        step.from.displacement[i]));
        largest_increment.add(equations.unknowns().layout.largest(increment),
                              step.to.time);
      }

      Finding error_finding(const double relative) const
      {
        const bool         is_unusable = !(relative <= unusable_error);
        std::ostringstream text;
        text.precision(2);
        text << "The steps are long for the motion: each misses about "
             << percentage_text(relative) << " of the way of the joints"
             << shorter_step_text(scene_step, scheme, relative);
        return {is_unusable ? Verdict::not_to_be_used : Verdict::doubtful,
                text.str(),
                time,
                ""};
      }

      Finding too_few_steps() const
      {
        std::ostringstream text;
        text << "The error of the steps is unknown: its estimate needs "
                "three consecutive steps without a jump of loads. Compare with "
                "a shorter Time/Time step than "
             << scene_step << " s.";
        return {Verdict::doubtful, text.str(), time, ""};
      }

      const double          scene_step; ///< s
      const bool            errors_are_estimated;
      const ImplicitScheme &scheme;
      const Equations      &equations;
      double               &error, &path_length; ///< m
      double               &unsampled_path_length;
      double               &time;           ///< s
      double               &largest_energy; ///< J
      LargestInTime        &largest_increment;
      const OwnedRows      &rows;
      /** @name Values of the previous steps, at free translations. */
      ///@{
      std::vector<double> rates, accelerations; ///< m/s, m/s2
      unsigned int        n_before  = 0;        ///< known steps, at most two
      double              dt_before = 0;        ///< s
      ///@}
    };
  } // namespace

  std::unique_ptr<Watch> make_step_watch(const WatchContext &run)
  {
    return std::make_unique<StepWatch>(run);
  }
} // namespace auxfem
