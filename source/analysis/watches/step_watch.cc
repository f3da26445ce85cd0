#include <auxfem/analysis/watch.h>
#include <auxfem/analysis/watched_part.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/rounded_text.h>
#include <auxfem/time/largest_in_time.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string step_record         = "watch: error of steps",
                      rate_record         = step_record + ", rates",
                      acceleration_record = step_record + ", accelerations";

    /**
     * Error of the displacements in a step over their increments: by the
     * trapezoidal rule of a vibration with n steps a period (2 pi / n)^2 / 12,
     * 5 % with 8 steps, 25 % with 3.6.
     */
    constexpr double doubtful_error = 0.05, ruinous_error = 0.25;

    /** Steps with less of the largest energy in motion do not count: it moves
     * by 1.4 % of what the structure is deformed, as where friction holds it.
     */
    constexpr double least_kinetic_part = 2e-4;

    /** Turn of a joint in one step (rad). */
    constexpr double doubtful_increment = 0.5;

    /** For which a part of the unknowns is looked at; the third tells first. */
    constexpr unsigned int n_steps_of_part = 6;

    /**
     * Error of the trapezoidal rule in a step, dt^3 u''' / 12, by the third
     * difference of displacements at the ends of steps: accelerations may ring
     * where displacements do not. Sums over all unknowns and steps weigh each
     * motion by the way it goes; in large linear scenes over parts of them
     * (WatchedPart). What another scheme misses is that of the vibration of
     * which the rule would miss so much.
     */
    class StepWatch : public Watch
    {
    public:
      StepWatch(const Scene &scene, const Equations &equations)
        : scene_step(scene.time.step)
        , errors_are_estimated(scene.time.relative_tolerance.has_value())
        , scheme(scene.time.implicit_scheme())
        , equations(equations)
        , part(scene, equations, n_steps_of_part)
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        // Rates and accelerations of the steps before mean nothing after a
        // jump, and other unknowns may have come.
        const unsigned int n = equations.unknowns().layout.n_owned();
        if (n != n_unknowns)
          sort_unknowns(n);
        if (part.passes_on(step.dt))
          forget_steps();
        if (step.event_at_from)
          n_before = 0;
        add_way(step);
        add_increment(step);
        time = step.to.time;
      }

      std::vector<Finding> findings() const override
      {
        const UnknownLayout      &layout = equations.unknowns().layout;
        const std::vector<double> sums = layout.sum({error, way, unjudged_way});
        const LargestInTime  increment = largest_increment.of_all_ranks(layout);
        std::vector<Finding> found;
        if (sums[1] > 0)
          {
            const double missed = scheme.missed_way(sums[0] / sums[1]);
            if (!(missed <= doubtful_error))
              found.push_back(error_finding(missed));
          }
        else if (sums[2] > 0 && !errors_are_estimated)
          found.push_back(too_few_steps());
        if (increment.value > doubtful_increment)
          {
            std::ostringstream text;
            text << "A joint turns by " << increment.value
                 << " rad in one step; shorten the step.";
            found.push_back(
              {Verdict::doubtful, text.str(), increment.time, ""});
          }
        return found;
      }

      void save(Records &records) const override
      {
        const UnknownLayout      &layout = equations.unknowns().layout;
        const std::vector<double> sums = layout.sum({error, way, unjudged_way});
        const LargestInTime increment  = largest_increment.of_all_ranks(layout);
        records.keep(step_record,
                     {sums[0],
                      sums[1],
                      sums[2],
                      time,
                      increment.value,
                      increment.time,
                      double(n_before),
                      dt_before,
                      largest_energy});
        part.save(step_record, records);
        save_translations(rate_record, rates, records);
        save_translations(acceleration_record, accelerations, records);
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(step_record, 9);
        // Sums go on on one rank.
        const bool is_first = equations.unknowns().layout.rank() == 0;
        error               = is_first ? values[0] : 0;
        way                 = is_first ? values[1] : 0;
        unjudged_way        = is_first ? values[2] : 0;
        time                = values[3];
        largest_increment   = {values[4], values[5]};
        largest_energy      = values[8];
        sort_unknowns(equations.unknowns().layout.n_owned());
        if (!part.resume(step_record, records))
          {
            forget_steps();
            return;
          }
        n_before      = values[6];
        dt_before     = values[7];
        rates         = saved_translations(rate_record, records);
        accelerations = saved_translations(acceleration_record, records);
      }

    private:
      void save_translations(const std::string         &name,
                             const std::vector<double> &of_translations,
                             Records                   &records) const
      {
        Vector values(equations.model().numbering.layout().n_local(), 0.);
        for (std::size_t k = 0; k < of_translations.size(); ++k)
          values[translations[part.now()][k]] = of_translations[k];
        UnknownRecords(equations.model().numbering).keep(name, values, records);
      }

      std::vector<double> saved_translations(const std::string &name,
                                             const Records     &records) const
      {
        const Vector values =
          UnknownRecords(equations.model().numbering).values(name, records);
        std::vector<double> of_translations;
        for (const int i : translations[part.now()])
          of_translations.push_back(values[i]);
        return of_translations;
      }

      void sort_unknowns(const unsigned int n)
      {
        const auto &kinds = equations.unknowns().kinds;
        translations.assign(part.n_parts(), {});
        rotations.clear();
        for (unsigned int i = 0; i < n; ++i)
          if (kinds[i] == UnknownKind::translation)
            translations[part.part_of(i)].push_back(i);
          // Where they are small steps hardly matter.
          else if (kinds[i] == UnknownKind::rotation && !equations.is_linear())
            rotations.push_back(i);
        n_unknowns = n;
        forget_steps();
      }

      void forget_steps()
      {
        const std::size_t n = translations[part.now()].size();
        rates.assign(n, 0.);
        accelerations.assign(n, 0.);
        n_before = 0;
      }

      void add_way(const Evaluation &step)
      {
        const double  per_step = 1 / step.dt;
        const double  per_mean = n_before > 0 ? 2 / (step.dt + dt_before) : 0;
        const double *before   = step.from.displacement.data(),
                     *now      = step.to.displacement.data();
        const std::vector<int> &watched = translations[part.now()];
        double                  way_now = 0, change = 0;
        for (std::size_t k = 0; k < watched.size(); ++k)
          {
            const int    i            = watched[k];
            const double increment    = now[i] - before[i];
            const double rate         = increment * per_step;
            const double acceleration = (rate - rates[k]) * per_mean;
            way_now += std::abs(increment);
            change += std::abs(acceleration - accelerations[k]);
            rates[k]         = rate;
            accelerations[k] = acceleration;
          }
        const Energies &energies = step.to.energies;
        largest_energy =
          std::max(largest_energy, energies.kinetic() + energies.stored());
        const bool counts =
          std::max(step.from.energies.kinetic(), energies.kinetic()) >=
          least_kinetic_part * largest_energy;
        if (counts && n_before > 1)
          {
            way += way_now;
            error += change * step.dt * step.dt * step.dt / dt_before / 12;
          }
        else if (counts)
          unjudged_way += way_now;
        n_before  = std::min(n_before + 1, 2u);
        dt_before = step.dt;
      }

      void add_increment(const Evaluation &step)
      {
        double increment = 0;
        for (const int i : rotations)
          increment = std::max(increment,
                               std::abs(step.to.displacement[i] -
                                        step.from.displacement[i]));
        largest_increment.add(increment, step.to.time);
      }

      Finding error_finding(const double relative) const
      {
        const bool         is_ruinous = !(relative <= ruinous_error);
        std::ostringstream text;
        text.precision(2);
        text << "The steps are long for the motion: each misses about "
             << percentage_text(relative) << " of the way of the joints"
             << shorter_step_text(scene_step, scheme, relative);
        return {is_ruinous ? Verdict::not_to_be_used : Verdict::doubtful,
                text.str(),
                time,
                ""};
      }

      Finding too_few_steps() const
      {
        std::ostringstream text;
        text << "Whether the steps are short enough for the motion is not "
                "known: three in a row tell, without a jump of loads between "
                "them. Compare with a shorter Time/Time step than "
             << scene_step << " s.";
        return {Verdict::doubtful, text.str(), time, ""};
      }

      const double          scene_step; ///< s
      const bool            errors_are_estimated;
      const ImplicitScheme &scheme;
      const Equations      &equations;
      /** @name Summed up on this rank (m); way of steps that have too few
       * before them apart. */
      ///@{
      double error = 0, way = 0, unjudged_way = 0;
      ///@}
      double        time           = 0; ///< s
      double        largest_energy = 0; ///< J
      LargestInTime largest_increment;  ///< rad

      WatchedPart part;
      /** Owned and free ones of n_unknowns owned in all: by part, and all large
       * ones. */
      ///@{
      std::vector<std::vector<int>> translations;
      std::vector<int>              rotations;
      std::optional<unsigned int>   n_unknowns; ///< none sorted yet
      ///@}

      /** @name Of the steps just before. */
      ///@{
      /** M/s, m/s2; of the translations of the part. */
      std::vector<double> rates, accelerations;
      unsigned int        n_before  = 0; ///< steps known, at most two
      double              dt_before = 0; ///< s
      ///@}
    };
  } // namespace

  std::unique_ptr<Watch> make_step_watch(const Scene     &scene,
                                         const Equations &equations)
  {
    return std::make_unique<StepWatch>(scene, equations);
  }
} // namespace auxfem
