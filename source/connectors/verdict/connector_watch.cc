#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/parameters/text.h>
#include <auxfem/state/step_report.h>
#include <auxfem/time/watch.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Length over length at rest below which a connector is doubtful.
     * @tuned judgement: no spring or damper has so much stroke
     */
    constexpr double doubtful_length_ratio = 0.05;

    /** Checks connectors along their line for vanishing length, where the
     * direction is undefined. */
    class ConnectorWatch : public Watch
    {
    public:
      explicit ConnectorWatch(const WatchContext &run)
        : equations(run.equations)
        , shortenings(run.statistics.occurrences("short connectors"))
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        const auto &groups         = equations.reporting().connectors;
        const auto &largest_so_far = shortenings.largest_here();
        for (unsigned int g = 0; g < groups.size(); ++g)
          {
            const ShortestConnector shortest = groups[g].forces->shortest(
              step,
              *results.effect_caches[groups[g].effect],
              largest_so_far ? 1 - largest_so_far->size
                             : doubtful_length_ratio);
            if (shortest.joint != invalid_index)
              shortenings.add(
                {1 - shortest.length_ratio, step.to.time, shortest.joint, g});
          }
      }

      std::vector<Finding> findings() const override
      {
        const auto first = shortenings.first(), largest = shortenings.largest();
        if (!first)
          return {};
        const std::string location = "connector " +
          equations.reporting().connectors[first->group].forces->name() +
          " of joint " + std::to_string(first->number);
        std::ostringstream text;
        text.precision(3);
        text << "The " << location << " has less than "
             << percentage_text(doubtful_length_ratio, 3)
             << " of its length at rest from about "
             << moment_text(equations.layout().path, first->time, 3) << " on";
        if (largest->size == 1)
          text << ", and one connector inverts at "
               << moment_text(equations.layout().path, largest->time, 3);
        text << ": no real spring or damper has such a stroke, and the "
                "direction of its force is ill-defined. Reduce the load, or "
                "set Geometry = direction, where the length may pass "
                "through zero.";
        return {{Verdict::doubtful, text.str(), first->time, location}};
      }

    private:
      const Equations &equations;
      /** Relative shortening of connectors. */
      EventExtremes &shortenings;
    };
  } // namespace

  std::unique_ptr<Watch> make_connector_watch(const WatchContext &run)
  {
    return std::make_unique<ConnectorWatch>(run);
  }
} // namespace auxfem
