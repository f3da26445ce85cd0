#include <auxfem/equations/node_masses.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/text.h>
#include <auxfem/time/watch.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Part of a time step below which a step only applies a sudden load. */
    constexpr double sudden_load_part = 1e-4;

    /**
     * Warns if loads are too fast to leave out inertia, by the kinetic energy
     * that the motion would have. It needs viscosity, without which time only
     * orders the loads.
     */
    class LoadSpeedWatch : public Watch
    {
    public:
      explicit LoadSpeedWatch(const WatchContext &run)
        : layout(run.equations.unknowns().layout)
        , masses(all_masses(run.equations))
        , scene_step(run.plan.time.step)
        , kinetic(run.statistics.largest("speed of loads: kinetic energy (J)"))
        , work(run.statistics.number("speed of loads: work (J)"))
        , dissipated(run.statistics.number("speed of loads: dissipated (J)"))
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        work       = std::max(work, std::abs(step.to.energies.external()));
        dissipated = std::max(dissipated, step.to.energies.dissipated());
        if (step.dt < sudden_load_part * scene_step)
          return;
        double sum = 0;
        for (const NodeMass &node : masses)
          sum += node.mass *
            std::pow(step.to.displacement[node.unknown] -
                       step.from.displacement[node.unknown],
                     2);
        kinetic.add(layout.sum(sum) / (2 * step.dt * step.dt), step.to.time);
      }

      std::vector<Finding> findings() const override
      {
        if (kinetic.value <= noticeable_fraction * work ||
            dissipated <= noticeable_fraction * work)
          return {};
        std::ostringstream text;
        text.precision(2);
        text << "The loads are too fast to leave inertia out: at t = "
             << kinetic.time
             << " s the moving masses would have a kinetic energy of "
             << percentage_text(kinetic.value / work)
             << " of the work of the loads. Displacements and forces may err "
                "by "
             << percentage_text(2 * std::sqrt(kinetic.value / work))
             << " by vibrations. Set a Time/Scheme with inertia, e.g. newmark, "
                "or load more slowly.";
        return {{Verdict::doubtful, text.str(), kinetic.time, ""}};
      }

    private:
      const UnknownLayout        &layout;
      const std::vector<NodeMass> masses;
      const double                scene_step;        ///< s
      LargestInTime              &kinetic;           ///< J
      double                     &work, &dissipated; ///< largest so far (J)
    };
  } // namespace

  std::unique_ptr<Watch> make_load_speed_watch(const WatchContext &run)
  {
    return std::make_unique<LoadSpeedWatch>(run);
  }

  namespace
  {
    /**
     * Missed part of a load above which stages within steps miss it, too.
     * @tuned theory: loads with fewer than two steps a period miss this much
     */
    constexpr double unresolved_part = 0.75;

    /** Integrals over time of a load's absolute value and of its deviation from
     * linear change within steps (N s). */
    struct Impulse
    {
      const TimeFunction *load;
      double             &missed, &whole;
    };

    /**
     * Warns if loads change within steps, by the deviation from linear change
     * in each step (Gauss quadrature). Absolute values are integrated, because
     * the impulse of a whole period is zero. For other schemes the missed part
     * is converted to a vibration that the trapezoidal rule would resolve as
     * badly.
     */
    class LoadStepWatch : public Watch
    {
    public:
      explicit LoadStepWatch(const WatchContext &run)
        : scene_step(run.plan.time.step)
        , scheme(run.plan.time.implicit_scheme())
        , time(run.statistics.number("loads within steps: time (s)"))
      {
        for (const auto &loads : run.plan.joint_loads())
          add(loads.components, run.statistics);
        for (const auto &loads : run.plan.scene.line_loads)
          add(loads.components, run.statistics);
        for (const PressureDefinition &load : run.plan.scene.pressures)
          add(load.pressure, run.statistics);
        for (const InitialStrainDefinition &strain :
             run.plan.scene.initial_strains)
          add(strain.history, run.statistics);
        add(run.plan.scene.gravity.acceleration, run.statistics);
        add(run.plan.scene.base_motion.acceleration, run.statistics);
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
        std::vector<Finding> findings;
        for (const Impulse &impulse : impulses)
          if (impulse.whole > 0)
            {
              const double part   = impulse.missed / impulse.whole,
                           missed = part > unresolved_part
                ? part
                : scheme.missed_phase(part);
              if (!(missed <= doubtful_error))
                findings.push_back(finding(impulse.load->origin(), missed));
            }
        return findings;
      }

    private:
      /** Adds the components that are not zero. */
      template <class Components>
      void add(const Components &components, RunStatistics &statistics)
      {
        for (const TimeFunction &load : components)
          add(load, statistics);
      }

      void add(const TimeFunction &load, RunStatistics &statistics)
      {
        if (load.is_zero())
          return;
        const std::string name =
          "loads within steps: " + std::to_string(impulses.size());
        impulses.push_back({&load,
                            statistics.number(name + ", missed (N s)"),
                            statistics.number(name + ", whole (N s)")});
      }

      Finding finding(const std::string &load, const double missed) const
      {
        std::ostringstream text;
        // Avoids 1e+02 %.
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
      /** Alternating rules, so that no periodic load hides between points. */
      const std::array<dealii::QGauss<1>, 3> rules = {
        {dealii::QGauss<1>(3), dealii::QGauss<1>(4), dealii::QGauss<1>(5)}};
    };
  } // namespace

  std::unique_ptr<Watch> make_load_step_watch(const WatchContext &run)
  {
    return std::make_unique<LoadStepWatch>(run);
  }
} // namespace auxfem
