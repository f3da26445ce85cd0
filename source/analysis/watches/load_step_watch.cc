#include <auxfem/analysis/watch.h>
#include <auxfem/output/verdict_limits.h>
#include <auxfem/parameters/rounded_text.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Part of a load that steps miss from which on stages within steps miss
     * it, too.
     * @tuned theory: loads with less than two steps a period show so much
     */
    constexpr double unresolved = 0.75;

    /** The time integral of one load, as steps take it and as it is. */
    struct Impulse
    {
      const TimeFunction *load;
      double             &missed, &whole; ///< sums of amounts (N s)
    };

    /**
     * Loads that change within steps: their distance from the straight line
     * between the ends of a step, by Gauss' rule. Amounts are summed, as the
     * impulse of a whole period within a step is zero. What another scheme
     * misses is that of the vibration of which the trapezoidal rule would miss
     * so much.
     */
    class LoadStepWatch : public Watch
    {
    public:
      explicit LoadStepWatch(const WatchedRun &run)
        : scene_step(run.plan.time.step)
        , scheme(run.plan.time.implicit_scheme())
        , time(run.statistics.number("loads within steps: time (s)"))
      {
        for (const auto &loads : run.plan.joint_loads())
          add(loads.components, run.statistics);
        for (const auto &loads : run.plan.scene.line_loads)
          add(loads.components, run.statistics);
        add(run.plan.scene.gravity.acceleration, run.statistics);
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        const double             begin = step.from.time, end = step.to.time;
        const dealii::QGauss<1> &points = rules[step.from.step % rules.size()];
        for (Impulse &impulse : impulses)
          {
            const TimeFunction &load  = *impulse.load;
            const double        first = load.value_after(begin),
                         last         = load.value_before(end);
            for (unsigned int q = 0; q < points.size(); ++q)
              {
                const double part  = points.point(q)[0],
                             dt    = (end - begin) * points.weight(q),
                             value = load.value(begin + (end - begin) * part);
                impulse.missed +=
                  dt * std::abs(value - first - part * (last - first));
                impulse.whole += dt * std::abs(value);
              }
          }
        time = end;
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> found;
        for (const Impulse &impulse : impulses)
          if (impulse.whole > 0)
            {
              const double part = impulse.missed / impulse.whole,
                           missed =
                             part > unresolved ? part : scheme.missed_way(part);
              if (!(missed <= doubtful_error))
                found.push_back(finding(impulse.load->origin(), missed));
            }
        return found;
      }

    private:
      /** Of those that are there. */
      template <class Components>
      void add(const Components &components, RunStatistics &statistics)
      {
        for (const TimeFunction &load : components)
          if (!load.is_zero())
            {
              const std::string name =
                "loads within steps: " + std::to_string(impulses.size());
              impulses.push_back({&load,
                                  statistics.number(name + ", missed (N s)"),
                                  statistics.number(name + ", whole (N s)")});
            }
      }

      Finding finding(const std::string &load, const double missed) const
      {
        std::ostringstream text;
        // Never 1e+02 %.
        text.precision(missed < 0.995 ? 2 : 3);
        text << load << " changes within steps, which miss "
             << percentage_text(missed) << " of its impulse"
             << shorter_step_text(scene_step, scheme, missed);
        return {Verdict::doubtful, text.str(), time, ""};
      }

      const double          scene_step; ///< s
      const ImplicitScheme &scheme;
      std::vector<Impulse>  impulses;
      double               &time; ///< s
      /** In turn, so that no periodic load hides between their points. */
      const std::array<dealii::QGauss<1>, 3> rules = {
        {dealii::QGauss<1>(3), dealii::QGauss<1>(4), dealii::QGauss<1>(5)}};
    };
  } // namespace

  std::unique_ptr<Watch> make_load_step_watch(const WatchedRun &run)
  {
    return std::make_unique<LoadStepWatch>(run);
  }
} // namespace auxfem
