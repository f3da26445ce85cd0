#include <auxfem/analysis/watch.h>
#include <auxfem/equations/effects/contact.h>
#include <auxfem/equations/plate_proximity.h>
#include <auxfem/time/moment_text.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Of struts that go into plates, as they may where contact is left out. */
    class PlateCrossingWatch : public Watch
    {
    public:
      explicit PlateCrossingWatch(const WatchedRun &run)
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
        if (const auto found = proximity.first_too_deep(step))
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
             << ": contact is left out, and struts and plates pass through "
                "each other. Leave Effects/Contact at auto.";
        return {{Verdict::doubtful, text.str(), first->time, location}};
      }

    private:
      const Scene                   &scene;
      const std::vector<ContactAxis> axes;
      const StrutCurves              curves;
      const PlateProximity           proximity;
      Occurrences                   &in_plates; ///< group: the plate
    };
  } // namespace

  std::unique_ptr<Watch> make_plate_crossing_watch(const WatchedRun &run)
  {
    return std::make_unique<PlateCrossingWatch>(run);
  }
} // namespace auxfem
