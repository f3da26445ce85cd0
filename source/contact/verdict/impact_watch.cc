#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/contact/effects/contact.h>
#include <auxfem/equations/node_masses.h>
#include <auxfem/parameters/text.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Largest unresolved impulse of contact over the largest momentum.
     * @tuned judgement: struts that brush each other transfer less */
    constexpr double doubtful_momentum = 2e-4;

    /** Largest unresolved impulse over the impulse of all contact.
     * @tuned judgement: long contact determines the later motion */
    constexpr double doubtful_share = 0.1;

    /** Largest unresolved impulse over the sum of momentum and all impulses.
     * @tuned judgement */
    constexpr double doubtful_anyway = 0.02;

    /** Ratio of the three-step mean to the peak force below which a peak is
     * unresolved; a half sine over six steps has 0.91. */
    constexpr double resolved_peak = 0.9;

    /** Strut, touched body, and whether that is a plate. */
    using TouchingPair = std::array<unsigned int, 3>;

    /** An uninterrupted contact of a pair. */
    struct Impact
    {
      double       impulse = 0; ///< N s
      unsigned int n_steps = 0;
      double       begin   = 0; ///< end of its first step (s)

      /** Part of the impulse that depends on the step length (N s): all of it
       * for a single step, of second order for longer contact. */
      double unresolved() const
      {
        return impulse / (double(n_steps) * n_steps);
      }
    };

    /** Largest force on a plate in one step and averaged over three steps. */
    class ForcePeak
    {
    public:
      ForcePeak(const std::string &name, RunStatistics &statistics)
        : largest(statistics.largest(name + ", largest force (N)"))
        , largest_mean(statistics.number(name + ", mean of three steps (N)"))
        , before(statistics.list(name + ", forces (N) and steps (s) before"))
      {
        before.assign(4, 0.);
      }

      void add(const double force, const double dt, const double time)
      {
        double impulse = force * dt, length = dt;
        for (unsigned int i = 0; i < before.size(); i += 2)
          {
            impulse += before[i] * before[i + 1];
            // Before the first step there is no force.
            length += before[i + 1] > 0 ? before[i + 1] : dt;
          }
        largest.add(force, time);
        largest_mean = std::max(largest_mean, impulse / length);
        before       = {before[2], before[3], force, dt};
      }

      bool is_resolved() const
      {
        return largest_mean >= resolved_peak * largest.value;
      }

      LargestInTime &largest;
      double        &largest_mean; ///< N

    private:
      /** Force (N) and length (s) of the last two steps. */
      std::vector<double> &before;
    };

    /** Detects contact shorter than a few steps, whose impulse depends on the
     * step length. Also notes force peaks that the steps do not resolve. */
    class ImpactWatch : public Watch
    {
    public:
      explicit ImpactWatch(const WatchContext &run)
        : time(run.plan.time)
        , equations(run.equations)
        , mass(total_mass(run.equations))
        , kinetic(run.statistics.number("impacts: largest kinetic energy (J)"))
        , unresolved(
            run.statistics.number("impacts: impulse not resolved (N s)"))
        , impulse(run.statistics.number("impacts: impulse (N s)"))
        , n_steps_of_largest(
            run.statistics.number("impacts: steps of the worst"))
        , plate_impacts(run.statistics.occurrences("impacts on plates"))
        , strut_impacts(run.statistics.occurrences("impacts on struts"))
        , ongoing(run.statistics.list("impacts: contacts that last"))
      {
        const unsigned int n_plates =
          run.equations.reporting().plates != nullptr
          ? run.equations.reporting().plates->n_plates()
          : 0;
        for (unsigned int i = 0; i < n_plates; ++i)
          peaks.emplace_back("impacts: plate " + std::to_string(i),
                             run.statistics);
      }

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        kinetic = std::max(kinetic, step.to.energies.kinetic());
        std::map<TouchingPair, Impact>    now;
        std::vector<dealii::Tensor<1, 3>> plate_forces(peaks.size());
        for (const ContactForce &force : all_forces(step.to, results))
          {
            const dealii::Tensor<1, 3> vector(force.components);
            if (force.pair[2] != 0)
              plate_forces[force.pair[1]] += vector;
            Impact &impact = now.try_emplace(force.pair).first->second;
            impact.impulse += vector.norm() * step.dt;
            impact.n_steps = 1;
            impact.begin   = step.to.time;
          }
        for (auto i = ongoing.begin(); i < ongoing.end(); i += n_values)
          {
            const TouchingPair pair = {
              {number(i[0]), number(i[1]), number(i[2])}};
            const Impact before = {i[3], number(i[4]), i[5]};
            if (const auto same = now.find(pair); same != now.end())
              same->second = {before.impulse + same->second.impulse,
                              before.n_steps + 1,
                              before.begin};
            else
              finish(pair, before);
          }
        ongoing.clear();
        for (const auto &[pair, impact] : now)
          {
            ongoing.insert(ongoing.end(), pair.begin(), pair.end());
            ongoing.insert(ongoing.end(),
                           {impact.impulse,
                            double(impact.n_steps),
                            impact.begin});
          }
        for (unsigned int i = 0; i < peaks.size(); ++i)
          peaks[i].add(plate_forces[i].norm(), step.dt, step.to.time);
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> all = findings_on_impulse();
        for (unsigned int i = 0; i < peaks.size(); ++i)
          if (!peaks[i].is_resolved())
            all.push_back(note_on_peak(i));
        return all;
      }

    private:
      std::vector<Finding> findings_on_impulse() const
      {
        // Momentum of the total mass at the largest kinetic energy.
        const double largest = std::sqrt(2 * mass * kinetic);
        const bool   counts  = unresolved > doubtful_momentum * largest &&
          unresolved > doubtful_share * impulse;
        if (!counts && unresolved <= doubtful_anyway * (largest + impulse))
          return {};
        const auto plate    = plate_impacts.largest(),
                   strut    = strut_impacts.largest();
        const bool is_plate = plate && (!strut || plate->size >= strut->size);
        const LocatedEvent &largest_impact = is_plate ? *plate : *strut;
        const std::string   location =
          "strut " + std::to_string(largest_impact.number);
        std::ostringstream text;
        text.precision(3);
        text << "At t = " << largest_impact.time << " s " << location
             << " hits "
             << (is_plate
                   ? touched_plate(
                       equations.reporting().plates->name(largest_impact.group))
                   : touched_strut(largest_impact.number, largest_impact.group))
             << " for " << n_steps_of_largest
             << (n_steps_of_largest == 1 ? " step" : " steps")
             << " only: the impulse and the later motion depend on the step "
                "length. Such short contact leaves ";
        text.precision(2);
        text << percentage_text(unresolved / largest)
             << " of the largest momentum uncertain; results may err by ten "
                "times as much. "
             << advice();
        return {{Verdict::doubtful, text.str(), largest_impact.time, location}};
      }

      Finding note_on_peak(const unsigned int plate) const
      {
        const ForcePeak   &peak = peaks[plate];
        std::ostringstream text;
        text.precision(3);
        text
          << "The largest force on "
          << touched_plate(equations.reporting().plates->name(plate)) << ", "
          << peak.largest.value << " N at t = " << peak.largest.time
          << " s, is not resolved by the steps: the mean over three steps is at "
             "most "
          << peak.largest_mean
          << " N. Shorter steps may give a higher peak: compare impulses, or "
             "forces averaged over several steps.";
        return {Verdict::sound, text.str(), peak.largest.time, ""};
      }

      struct ContactForce
      {
        TouchingPair pair;
        double       components[3]; ///< on the strut (N)
      };

      static void add(const std::vector<ContactReport> &points,
                      const bool                        is_plate,
                      std::vector<ContactForce>        &forces)
      {
        for (const ContactReport &point : points)
          forces.push_back({{{point.strut, point.other, is_plate}},
                            {point.force[0], point.force[1], point.force[2]}});
      }

      /** Contact forces of all ranks. Collective. */
      std::vector<ContactForce>
      all_forces(const State &state, const EvaluationResults &results) const
      {
        const ReportingEffects   &effects = equations.reporting();
        std::vector<ContactForce> mine;
        if (effects.plates != nullptr)
          add(effects.plates->contacts(equations.plate_results(results), state),
              true,
              mine);
        if (effects.strut_contact != nullptr)
          add(effects.strut_contact->contacts(equations.strut_contact_results(
                                                results),
                                              state),
              false,
              mine);
        return gather_over_ranks(mine,
                                 equations.unknowns().layout.communicator());
      }

      void finish(const TouchingPair &pair, const Impact &impact)
      {
        unresolved += impact.unresolved();
        impulse += impact.impulse;
        const auto size = [](const EventExtremes &occurrences) {
          const auto &largest = occurrences.largest_here();
          return largest ? largest->size : 0.;
        };
        if (impact.unresolved() >
            std::max(size(plate_impacts), size(strut_impacts)))
          n_steps_of_largest = impact.n_steps;
        (pair[2] != 0 ? plate_impacts : strut_impacts)
          .add({impact.unresolved(), impact.begin, pair[0], pair[1]});
      }

      std::string advice() const
      {
        std::ostringstream text;
        if (time.relative_tolerance)
          text << "Reduce Time/Relative tolerance.";
        else if (time.implicit_scheme().estimates_errors())
          text
            << "Set Time/Relative tolerance = 5e-3, which shortens steps only "
               "during contact.";
        else
          text << "Shorten Time/Time step = " << time.step << " s.";
        return text.str();
      }

      /** Number of values per contact in `ongoing`. */
      static constexpr unsigned int n_values = 6;

      static unsigned int number(const double value)
      {
        return static_cast<unsigned int>(value);
      }

      const TimeParameters  &time;
      const Equations       &equations;
      const double           mass;    ///< kg
      std::vector<ForcePeak> peaks;   ///< by plate
      double                &kinetic; ///< J
      /** Sums over finished contacts (N s). */
      double &unresolved, &impulse;
      double &n_steps_of_largest;
      /** Sized by Impact::unresolved(); equal on all ranks. */
      EventExtremes &plate_impacts, &strut_impacts;
      /** Pair and Impact of each ongoing contact. */
      std::vector<double> &ongoing;
    };
  } // namespace

  std::unique_ptr<Watch> make_impact_watch(const WatchContext &run)
  {
    return std::make_unique<ImpactWatch>(run);
  }
} // namespace auxfem
