#include <auxfem/analysis/occurrences.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/equations/effects/plate_contact.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string contact_record = "watch: penetration";

    /** Of the thickness of a strut. Its face is then strained by a fifth. */
    constexpr double doubtful_penetration = 0.1;

    /** Of struts that go so deep into plates that the law of contact shows. */
    class ContactWatch : public Watch
    {
    public:
      explicit ContactWatch(const Equations &equations)
        : equations(equations)
        , communicator(equations.unknowns().layout.communicator())
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        const auto deepest = equations.reporting().plates->deepest(
          equations.plate_results(results));
        if (deepest && deepest->part > doubtful_penetration)
          beyond.add(
            {deepest->part, step.to.time, deepest->strut, deepest->plate});
      }

      std::vector<Finding> findings() const override
      {
        const auto largest = beyond.largest_of_all(communicator);
        if (!largest)
          return {};
        const std::string location = "strut " + std::to_string(largest->number);
        std::ostringstream text;
        text.precision(3);
        text << "At t = " << largest->time << " s " << location << " goes "
             << 100 * largest->size << " % of its thickness into the plate \""
             << equations.reporting().plates->name(largest->group)
             << "\". Beyond " << 100 * doubtful_penetration
             << " % results depend on how stiff its face is taken to be: raise "
                "Contact/Stiffness, or let things move more slowly.";
        return {{Verdict::doubtful, text.str(), largest->time, location}};
      }

      void save(Records &records) const override
      {
        beyond.save(records, contact_record, communicator);
      }

      void resume(const Records &records) override
      {
        beyond.resume(records, contact_record);
      }

    private:
      const Equations &equations;
      const MPI_Comm   communicator;
      Occurrences      beyond;
    };
  } // namespace

  std::unique_ptr<Watch> make_contact_watch(const Equations &equations)
  {
    return std::make_unique<ContactWatch>(equations);
  }
} // namespace auxfem
