#include <auxfem/analysis/node_masses.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/parameters/rounded_text.h>
#include <auxfem/time/largest_in_time.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string load_speed_record = "watch: speed of loads";

    /**
     * Kinetic energy over work: of an oscillator whose load is raised in a time
     * t, the square of its period over 2 pi t; a hundredth with 1.6 periods.
     */
    constexpr double doubtful_kinetic_energy = 0.01;

    /** Dissipated part of the work from which on results depend on time. */
    constexpr double noticeable_dissipation = 0.01;

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
      LoadSpeedWatch(const Scene &scene, const Equations &equations)
        : layout(equations.unknowns().layout)
        , masses(all_masses(scene, equations))
        , scene_step(scene.time.step)
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
        if (kinetic.value <= doubtful_kinetic_energy * work ||
            dissipated <= noticeable_dissipation * work)
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

      void save(Records &records) const override
      {
        records.keep(load_speed_record,
                     {kinetic.value, kinetic.time, work, dissipated});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(load_speed_record, 4);
        kinetic                          = {values[0], values[1]};
        work                             = values[2];
        dissipated                       = values[3];
      }

    private:
      const UnknownLayout        &layout;
      const std::vector<NodeMass> masses;
      const double                scene_step; ///< s
      LargestInTime               kinetic;    ///< J
      /** The largest so far (J). */
      double work = 0, dissipated = 0;
    };
  } // namespace

  std::unique_ptr<Watch> make_load_speed_watch(const Scene     &scene,
                                               const Equations &equations)
  {
    return std::make_unique<LoadSpeedWatch>(scene, equations);
  }
} // namespace auxfem
