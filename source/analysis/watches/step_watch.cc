#include <auxfem/analysis/watch.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string record_name = "watch: error of steps";

    /**
     * Error of the displacements in a step over their increments: of a
     * vibration with n steps a period (2 pi / n)^2 / 12, 5 % with 8 steps, 25 %
     * with 3.6.
     */
    constexpr double doubtful_error = 0.05, ruinous_error = 0.25;

    /** Turn of a joint in one step (rad). */
    constexpr double doubtful_turn = 0.5;

    /**
     * Error of the trapezoidal rule in a step, dt^3 u''' / 12, by the third
     * difference of displacements at the ends of steps: accelerations may ring
     * where displacements do not. Sums over all unknowns and steps weigh each
     * motion by the way it goes.
     */
    class StepWatch : public Watch
    {
    public:
      StepWatch(const double step, const Equations &equations)
        : scene_step(step)
        , equations(equations)
      {}

      void step(const Evaluation &step, TangentSolver & /*solver*/) override
      {
        const Unknowns    &unknowns = equations.unknowns();
        const unsigned int n        = unknowns.layout.n_owned();
        // Rates and accelerations of the steps before mean nothing after a
        // jump, and other unknowns may have come.
        if (step.event_at_from || rates.size() != n)
          n_before = 0;
        rates.resize(n);
        accelerations.resize(n);
        double turn = 0;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double increment =
              step.to.displacement[i] - step.from.displacement[i];
            if (unknowns.kinds[i] == UnknownKind::rotation)
              turn = std::max(turn, std::abs(increment));
            else if (unknowns.kinds[i] == UnknownKind::translation)
              add(i, increment, step.dt);
          }
        n_before  = std::min(n_before + 1, 2u);
        dt_before = step.dt;
        if (turn > largest_turn)
          {
            largest_turn = turn;
            turn_time    = step.to.time;
          }
        time = step.to.time;
      }

      std::vector<Finding> findings() const override
      {
        const UnknownLayout      &layout = equations.unknowns().layout;
        const std::vector<double> sums   = layout.sum({error, way});
        const double              turn   = layout.largest(largest_turn);
        std::vector<Finding>      found;
        if (!(sums[0] <= doubtful_error * sums[1]))
          found.push_back(error_finding(sums[0] / sums[1]));
        if (turn > doubtful_turn)
          {
            std::ostringstream text;
            text << "A joint turns by " << turn
                 << " rad in one step; shorten the step.";
            found.push_back(
              {Verdict::doubtful,
               text.str(),
               layout.largest(turn == largest_turn ? turn_time : 0.),
               ""});
          }
        return found;
      }

      void save(Records &records) const override
      {
        const UnknownLayout      &layout = equations.unknowns().layout;
        const std::vector<double> sums   = layout.sum({error, way});
        const double              turn   = layout.largest(largest_turn);
        records.keep(record_name,
                     {sums[0],
                      sums[1],
                      time,
                      turn,
                      layout.largest(turn == largest_turn ? turn_time : 0.)});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(record_name, 5);
        // Sums go on on one rank.
        const bool is_first = equations.unknowns().layout.rank() == 0;
        error               = is_first ? values[0] : 0;
        way                 = is_first ? values[1] : 0;
        time                = values[2];
        largest_turn        = values[3];
        turn_time           = values[4];
      }

    private:
      void add(const unsigned int i, const double increment, const double dt)
      {
        const double rate = increment / dt;
        const double acceleration =
          n_before > 0 ? (rate - rates[i]) / ((dt + dt_before) / 2) : 0;
        if (n_before > 1)
          {
            way += std::abs(increment);
            error += std::abs(acceleration - accelerations[i]) * dt * dt * dt /
              dt_before / 12;
          }
        rates[i]         = rate;
        accelerations[i] = acceleration;
      }

      Finding error_finding(const double relative) const
      {
        const bool         is_ruinous = !(relative <= ruinous_error);
        std::ostringstream text;
        text.precision(2);
        text << "The steps are long for the motion: each misses about "
             << 100 * relative
             << " % of the way of the joints (Time/Time step = " << scene_step
             << " s). A step of " << scene_step * std::sqrt(0.01 / relative)
             << " s would miss 1 %.";
        return {is_ruinous ? Verdict::not_to_be_used : Verdict::doubtful,
                text.str(),
                time,
                ""};
      }

      const double     scene_step; ///< s
      const Equations &equations;
      double           error = 0, way = 0; ///< m, summed up on this rank
      double           time         = 0;   ///< s
      double           largest_turn = 0;   ///< rad
      double           turn_time    = 0;   ///< s

      /** @name Of the steps just before, by owned unknown. */
      ///@{
      std::vector<double> rates, accelerations; ///< m/s, m/s2
      unsigned int        n_before  = 0;        ///< steps known, at most two
      double              dt_before = 0;        ///< s
      ///@}
    };
  } // namespace

  std::unique_ptr<Watch> make_step_watch(const Scene     &scene,
                                         const Equations &equations)
  {
    return std::make_unique<StepWatch>(scene.time.step, equations);
  }
} // namespace auxfem
