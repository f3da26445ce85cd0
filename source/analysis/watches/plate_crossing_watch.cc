#include <auxfem/analysis/occurrences.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/equations/effects/contact.h>
#include <auxfem/equations/plate_proximity.h>
#include <auxfem/time/moment_text.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string plate_crossing_record = "watch: struts in plates";

    /** Of struts that go into plates, as they may where contact is left out. */
    class PlateCrossingWatch : public Watch
    {
    public:
      PlateCrossingWatch(const Scene &scene, const Equations &equations)
        : scene(scene)
        , communicator(equations.unknowns().layout.communicator())
        , axes(make_contact_axes(equations.model(), scene.contact.stiffness))
        , curves(equations.model(), axes)
        , proximity(scene, equations.model(), curves)
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
        const auto first = in_plates.first_of_all(communicator);
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

      void save(Records &records) const override
      {
        in_plates.save(records, plate_crossing_record, communicator);
      }

      void resume(const Records &records) override
      {
        in_plates.resume(records, plate_crossing_record);
      }

    private:
      const Scene                   &scene;
      const MPI_Comm                 communicator;
      const std::vector<ContactAxis> axes;
      const StrutCurves              curves;
      const PlateProximity           proximity;
      Occurrences                    in_plates; ///< group: the plate
    };
  } // namespace

  std::unique_ptr<Watch> make_plate_crossing_watch(const Scene     &scene,
                                                   const Equations &equations)
  {
    return std::make_unique<PlateCrossingWatch>(scene, equations);
  }
} // namespace auxfem
