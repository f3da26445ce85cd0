#include <auxfem/algebra/shared_work.h>
#include <auxfem/analysis/node_masses.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/equations/effects/contact.h>
#include <auxfem/parameters/rounded_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string impact_record = "watch: impacts";

    /**
     * What contact of few steps may pass on of the largest momentum, and of the
     * impulse of all contact: both, as little is passed on by struts that brush
     * each other, and contact that lasts says what comes after it.
     */
    constexpr double doubtful_momentum = 2e-4, doubtful_share = 0.1;

    /** Of momentum and all impulses, whatever else lasts. */
    constexpr double doubtful_anyway = 0.02;

    /** The mean of three steps over the largest force of one, below which steps
     * do not resolve its peak: six steps of half a sine have 0.91. */
    constexpr double resolved_peak = 0.9;

    /** A strut, what it touches, and whether that is a plate. */
    using TouchingPair = std::array<unsigned int, 3>;

    /** Contact of a pair, as long as it lasts. */
    struct Impact
    {
      double       impulse = 0; ///< N s
      unsigned int n_steps = 0;
      double       begin   = 0; ///< end of its first step (s)

      /** What the steps leave open of the impulse: contact that is there in a
       * single one gets a force for as long as that is, others are found to
       * second order. */
      double unresolved() const
      {
        return impulse / (double(n_steps) * n_steps);
      }
    };

    /** The largest force on a plate in a step, and in the mean of three. */
    class ForcePeak
    {
    public:
      static constexpr unsigned int n_values = 7;

      void add(const double force, const double dt, const double time)
      {
        const std::array<double, 2> now     = {{force, dt}};
        double                      impulse = force * dt, length = dt;
        for (const auto &[of_step, of_length] : before)
          {
            impulse += of_step * of_length;
            // There was no force before the first step.
            length += of_length > 0 ? of_length : dt;
          }
        if (force > largest)
          {
            largest = force;
            at      = time;
          }
        largest_mean = std::max(largest_mean, impulse / length);
        before       = {{before[1], now}};
      }

      bool is_resolved() const
      {
        return largest_mean >= resolved_peak * largest;
      }

      std::vector<double> values() const
      {
        return {largest,
                at,
                largest_mean,
                before[0][0],
                before[0][1],
                before[1][0],
                before[1][1]};
      }

      void restore(const double *const values)
      {
        largest      = values[0];
        at           = values[1];
        largest_mean = values[2];
        before       = {{{{values[3], values[4]}}, {{values[5], values[6]}}}};
      }

      double largest = 0, at = 0, largest_mean = 0; ///< N, s, N

    private:
      /** Force (N) and length (s) of the last two steps. */
      std::array<std::array<double, 2>, 2> before{};
    };

    /**
     * Of contact that begins and ends within few steps. Its impulse, and so the
     * motion after it, depends on the length of these. A peak of the force
     * may depend on it where the impulse does not.
     */
    class ImpactWatch : public Watch
    {
    public:
      ImpactWatch(const Scene &scene, const Equations &equations)
        : time(scene.time)
        , equations(equations)
        , mass(total_mass(scene, equations))
        , peaks(equations.reporting().plates != nullptr
                  ? equations.reporting().plates->n_plates()
                  : 0)
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        kinetic = std::max(kinetic, step.to.energies.kinetic());
        std::map<TouchingPair, Impact>    now;
        std::vector<dealii::Tensor<1, 3>> on_plates(peaks.size());
        for (const ContactForce &force : forces_of_all(step.to, results))
          {
            const dealii::Tensor<1, 3> vector(force.components);
            if (force.pair[2] != 0)
              on_plates[force.pair[1]] += vector;
            Impact &impact = now.try_emplace(force.pair).first->second;
            impact.impulse += vector.norm() * step.dt;
            impact.n_steps = 1;
            impact.begin   = step.to.time;
          }
        for (const auto &[pair, before] : going_on)
          if (const auto same = now.find(pair); same != now.end())
            same->second = {before.impulse + same->second.impulse,
                            before.n_steps + 1,
                            before.begin};
          else
            end(pair, before);
        going_on.swap(now);
        for (unsigned int i = 0; i < peaks.size(); ++i)
          peaks[i].add(on_plates[i].norm(), step.dt, step.to.time);
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> all = findings_on_impulse();
        for (unsigned int i = 0; i < peaks.size(); ++i)
          if (!peaks[i].is_resolved())
            all.push_back(note_on_peak(i));
        return all;
      }

      void save(Records &records) const override
      {
        std::vector<double> values = {unresolved, impulse, kinetic};
        for (const ForcePeak &peak : peaks)
          {
            const std::vector<double> of_peak = peak.values();
            values.insert(values.end(), of_peak.begin(), of_peak.end());
          }
        add_values(worst_pair, worst, values);
        for (const auto &[pair, impact] : going_on)
          add_values(pair, impact, values);
        records.keep(impact_record, values);
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values =
          records.values(impact_record, records.values_per_item(impact_record));
        unresolved    = values[0];
        impulse       = values[1];
        kinetic       = values[2];
        std::size_t i = 3;
        for (ForcePeak &peak : peaks)
          {
            peak.restore(values.data() + i);
            i += ForcePeak::n_values;
          }
        going_on.clear();
        for (const std::size_t first = i; i < values.size(); i += 6)
          {
            const TouchingPair pair = {
              {static_cast<unsigned int>(values[i]),
               static_cast<unsigned int>(values[i + 1]),
               static_cast<unsigned int>(values[i + 2])}};
            const Impact impact = {values[i + 3],
                                   static_cast<unsigned int>(values[i + 4]),
                                   values[i + 5]};
            if (i == first)
              {
                worst_pair = pair;
                worst      = impact;
              }
            else
              going_on.emplace(pair, impact);
          }
      }

    private:
      std::vector<Finding> findings_on_impulse() const
      {
        // The momentum of a body as heavy as all, with the largest kinetic
        // energy.
        const double largest = std::sqrt(2 * mass * kinetic);
        const bool   counts  = unresolved > doubtful_momentum * largest &&
          unresolved > doubtful_share * impulse;
        if (!counts && unresolved <= doubtful_anyway * (largest + impulse))
          return {};
        std::ostringstream text;
        text.precision(3);
        text
          << "At t = " << worst.begin << " s strut " << worst_pair[0]
          << " hits " << name_of_other() << " for " << worst.n_steps
          << (worst.n_steps == 1 ? " step" : " steps")
          << " only: the impulse, and what comes after it, depend on how long "
             "steps are. Contact as short as that leaves open ";
        text.precision(2);
        text << percentage_text(unresolved / largest)
             << " of the largest momentum; answers may err by ten times as "
                "much. "
             << advice();
        return {{Verdict::doubtful,
                 text.str(),
                 worst.begin,
                 "strut " + std::to_string(worst_pair[0])}};
      }

      Finding note_on_peak(const unsigned int plate) const
      {
        const ForcePeak   &peak = peaks[plate];
        std::ostringstream text;
        text.precision(3);
        text << "The largest force on "
             << touched_plate(equations.reporting().plates->name(plate)) << ", "
             << peak.largest << " N at t = " << peak.at
             << " s, lasts for few steps: in the mean of three it is at most "
             << peak.largest_mean
             << " N. Shorter steps may find a higher peak: compare impulses, "
                "or forces filtered over a time of several steps.";
        return {Verdict::sound, text.str(), peak.at, ""};
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

      /** At all points that touch. Collective. */
      std::vector<ContactForce>
      forces_of_all(const State &state, const EvaluationResults &results) const
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
        return of_all_ranks(mine, equations.unknowns().layout.communicator());
      }

      void end(const TouchingPair &pair, const Impact &impact)
      {
        unresolved += impact.unresolved();
        impulse += impact.impulse;
        if (worst.n_steps == 0 || impact.unresolved() > worst.unresolved())
          {
            worst_pair = pair;
            worst      = impact;
          }
      }

      static void add_values(const TouchingPair  &pair,
                             const Impact        &impact,
                             std::vector<double> &values)
      {
        values.insert(values.end(), pair.begin(), pair.end());
        values.insert(values.end(),
                      {impact.impulse, double(impact.n_steps), impact.begin});
      }

      std::string name_of_other() const
      {
        return worst_pair[2] != 0
          ? touched_plate(equations.reporting().plates->name(worst_pair[1]))
          : touched_strut(worst_pair[0], worst_pair[1]);
      }

      std::string advice() const
      {
        std::ostringstream text;
        if (time.relative_tolerance)
          text << "Reduce Time/Relative tolerance.";
        else if (time.implicit_scheme().estimates_errors())
          text
            << "Set Time/Relative tolerance = 5e-3: steps become as short as "
               "the contact asks for, there alone.";
        else
          text << "Shorten Time/Time step = " << time.step << " s.";
        return text.str();
      }

      const TimeParameters          &time;
      const Equations               &equations;
      const double                   mass;        ///< kg
      std::vector<ForcePeak>         peaks;       ///< by plate
      double                         kinetic = 0; ///< the largest (J)
      std::map<TouchingPair, Impact> going_on;    ///< the same on all ranks
      /** Of contact that has ended (N s). */
      double unresolved = 0, impulse = 0;
      /** That which leaves most open. */
      TouchingPair worst_pair{};
      Impact       worst;
    };
  } // namespace

  std::unique_ptr<Watch> make_impact_watch(const Scene     &scene,
                                           const Equations &equations)
  {
    return std::make_unique<ImpactWatch>(scene, equations);
  }
} // namespace auxfem
