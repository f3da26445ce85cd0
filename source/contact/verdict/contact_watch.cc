#include <auxfem/contact/effects/contact.h>
#include <auxfem/contact/effects/plate_proximity.h>
#include <auxfem/parameters/text.h>
#include <auxfem/state/step_report.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Penetration over the strut's thickness above which contact is doubtful.
     * @tuned theory: the strain of the face is then 0.2 */
    constexpr double doubtful_penetration = 0.1;

    /** Detects penetrations so deep that the penalty law affects the
     * results. */
    class ContactWatch : public Watch
    {
    public:
      explicit ContactWatch(const WatchContext &run)
        : equations(run.equations)
        , into_plates(run.statistics.occurrences("penetration into plates"))
        , into_struts(run.statistics.occurrences("penetration into struts"))
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        const ReportingEffects &effects = equations.reporting();
        if (effects.plates != nullptr)
          record(effects.plates->deepest(equations.plate_results(results)),
                 step.to.time,
                 into_plates);
        if (effects.strut_contact != nullptr)
          record(effects.strut_contact->deepest(
                   equations.strut_contact_results(results)),
                 step.to.time,
                 into_struts);
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> all;
        if (const auto largest = into_plates.largest(); is_doubtful(largest))
          all.push_back(finding(
            *largest,
            touched_plate(equations.reporting().plates->name(largest->group))));
        if (const auto largest = into_struts.largest(); is_doubtful(largest))
          all.push_back(
            finding(*largest, touched_strut(largest->number, largest->group)));
        return all;
      }

      std::optional<double> largest_penetration() const override
      {
        double largest = 0;
        for (const EventExtremes *occurrences : {&into_plates, &into_struts})
          if (const auto found = occurrences->largest())
            largest = std::max(largest, found->size);
        return largest;
      }

    private:
      static void record(const std::optional<Penetration> &deepest,
                         const double                      time,
                         EventExtremes                    &occurrences)
      {
        if (deepest && deepest->fraction > 0)
          occurrences.add(
            {deepest->fraction, time, deepest->strut, deepest->other});
      }

      static bool is_doubtful(const std::optional<LocatedEvent> &largest)
      {
        return largest && largest->size > doubtful_penetration;
      }

      /** @param other description of the penetrated body */
      static Finding finding(const LocatedEvent &largest,
                             const std::string  &other)
      {
        const std::string  location = "strut " + std::to_string(largest.number);
        std::ostringstream text;
        text.precision(3);
        text << "At t = " << largest.time << " s " << location << " goes "
             << percentage_text(largest.size, 3) << " of its thickness into "
             << other << ". Beyond " << percentage_text(doubtful_penetration, 3)
             << " results depend on the contact stiffness: raise "
                "Contact/Stiffness, or reduce velocities.";
        return {Verdict::doubtful, text.str(), largest.time, location};
      }

      const Equations &equations;
      EventExtremes   &into_plates, &into_struts; ///< group: penetrated body
    };
  } // namespace

  std::unique_ptr<Watch> make_contact_watch(const WatchContext &run)
  {
    return std::make_unique<ContactWatch>(run);
  }

  namespace
  {
    /** Detects struts that enter plates while contact is disabled. */
    class PlateCrossingWatch : public Watch
    {
    public:
      explicit PlateCrossingWatch(const WatchContext &run)
        : scene(run.plan.scene)
        , axes(make_contact_axes(run.equations.model(),
                                 run.plan.scene.contact.stiffness))
        , curves(run.equations.model(), axes)
        , proximity(run.equations.model(), curves)
        , in_plates(run.statistics.occurrences("struts in plates"))
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        if (const auto found = proximity.first_excessive_penetration(step))
          in_plates.add(
            {found->depth, step.to.time, found->strut, found->plate});
      }

      std::vector<Finding> findings() const override
      {
        const auto first = in_plates.first();
        if (!first)
          return {};
        const std::string  location = "strut " + std::to_string(first->number);
        std::ostringstream text;
        text << "At about " << moment_text(/*on_path=*/false, first->time, 4)
             << ' ' << location << " goes into "
             << touched_plate(scene.plates[first->group].name)
             << ": contact is disabled, so struts pass through plates. Set "
                "Effects/Contact = auto.";
        return {{Verdict::doubtful, text.str(), first->time, location}};
      }

    private:
      const Scene                   &scene;
      const std::vector<ContactAxis> axes;
      const StrutCurves              curves;
      const PlateProximity           proximity;
      EventExtremes                 &in_plates; ///< group: the plate
    };
  } // namespace

  std::unique_ptr<Watch> make_plate_crossing_watch(const WatchContext &run)
  {
    return std::make_unique<PlateCrossingWatch>(run);
  }
} // namespace auxfem
