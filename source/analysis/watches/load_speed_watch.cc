#include <auxfem/analysis/node_masses.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/rounded_text.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** A shorter part of a time step is one in which loads are there at once.
     */
    constexpr double sudden_part = 1e-4;

    /**
     * Of loads too fast for an analysis without inertia in which time is more
     * than a parameter, since something is viscous: by the kinetic energy that
     * its motion has with the masses that are left out.
     */
    class LoadSpeedWatch : public Watch
    {
    public:
      explicit LoadSpeedWatch(const WatchedRun &run)
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
        if (step.dt < sudden_part * scene_step)
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
        if (kinetic.value <= noticeable_part * work ||
            dissipated <= noticeable_part * work)
          return {};
        std::ostringstream text;
        text.precision(2);
        text << "The loads are too fast to leave inertia out: at t = "
             << kinetic.time
             << " s the masses that move would have a kinetic energy of "
             << percentage_text(kinetic.value / work)
             << " of the work of the loads. Displacements and forces may err "
                "by "
             << percentage_text(2 * std::sqrt(kinetic.value / work))
             << " by vibrations. Set a Time/Scheme with inertia, newmark say, "
                "or load more slowly.";
        return {{Verdict::doubtful, text.str(), kinetic.time, ""}};
      }

    private:
      const UnknownLayout        &layout;
      const std::vector<NodeMass> masses;
      const double                scene_step;        ///< s
      LargestInTime              &kinetic;           ///< J
      double                     &work, &dissipated; ///< the largest so far (J)
    };
  } // namespace

  std::unique_ptr<Watch> make_load_speed_watch(const WatchedRun &run)
  {
    return std::make_unique<LoadSpeedWatch>(run);
  }
} // namespace auxfem
