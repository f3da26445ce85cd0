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
     * Length of a connector, over that at rest, below which it is doubtful.
     * @tuned judgement: no spring or damper has so much stroke
     */
    constexpr double doubtful_length = 0.05;

    /** Of connectors along their line, near the point where it has none. */
    class ConnectorWatch : public Watch
    {
    public:
      explicit ConnectorWatch(const WatchedRun &run)
        : equations(run.equations)
        , shortenings(run.statistics.occurrences("short connectors"))
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        const auto &groups = equations.reporting().connectors;
        const auto &known  = shortenings.largest_here();
        for (unsigned int g = 0; g < groups.size(); ++g)
          {
            const VanishingConnector found = groups[g].forces->shortest(
              step,
              *results.effect_caches[groups[g].effect],
              known ? 1 - known->size : doubtful_length);
            if (found.joint != invalid_index)
              shortenings.add({1 - found.part, step.to.time, found.joint, g});
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
             << percentage_text(doubtful_length, 3)
             << " of its length at rest from about "
             << moment_text(equations.layout().path, first->time, 3) << " on";
        if (largest->size == 1)
          text << ", and one is pushed through itself at "
               << moment_text(equations.layout().path, largest->time, 3);
        text << ": no real spring or damper has such a stroke, and the line "
                "along which its force acts turns at any touch. Reduce the "
                "load, or set Geometry = direction, where the extension goes "
                "on through zero.";
        return {{Verdict::doubtful, text.str(), first->time, location}};
      }

    private:
      const Equations &equations;
      /** Parts of the length at rest that are gone. */
      Occurrences &shortenings;
    };
  } // namespace

  std::unique_ptr<Watch> make_connector_watch(const WatchedRun &run)
  {
    return std::make_unique<ConnectorWatch>(run);
  }
} // namespace auxfem
