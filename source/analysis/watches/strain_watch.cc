#include <auxfem/analysis/watch.h>
#include <auxfem/time/largest_in_time.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string strain_record = "watch: strain";

    /**
     * Of outer fibres. At 50 % what is called strain makes as large a
     * difference to the force; at 100 % a fibre in compression is gone.
     */
    constexpr double doubtful_strain = 0.5, ruinous_strain = 1;

    class StrainWatch : public Watch
    {
    public:
      explicit StrainWatch(const Equations &equations) : equations(equations)
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        for (const StrutGroup &group : equations.reporting().struts)
          {
            const StrutStrain found =
              group.forces->largest_strain(step.to,
                                           *results.of_effects[group.effect],
                                           std::max(largest.value,
                                                    doubtful_strain));
            if (found.strut == invalid_index)
              continue;
            largest.add(found.value, step.to.time);
            strut = found.strut;
          }
      }

      std::vector<Finding> findings() const override
      {
        const LargestInTime all      = of_all_ranks();
        const std::string   location = "strut " + std::to_string(strut_of(all));
        if (all.value <= doubtful_strain)
          return {};
        std::ostringstream text;
        text.precision(3);
        text << "The strain reaches " << 100 * all.value << " % in an outer "
             << "fibre of " << location
             << ". Stress in proportion to strain and sections that keep their "
                "shape, which beams here are made of, do not hold beyond some "
             << 100 * doubtful_strain
             << " % for any material: check loads, sections and units.";
        return {{all.value > ruinous_strain ? Verdict::not_to_be_used
                                            : Verdict::doubtful,
                 text.str(),
                 all.time,
                 location}};
      }

      void save(Records &records) const override
      {
        const LargestInTime all = of_all_ranks();
        records.keep(strain_record,
                     {all.value, all.time, double(strut_of(all))});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(strain_record, 3);
        largest                          = {values[0], values[1]};
        strut                            = values[2];
      }

    private:
      LargestInTime of_all_ranks() const
      {
        return largest.of_all_ranks(equations.unknowns().layout);
      }

      /** The one with the largest strain, @p all, of all ranks. */
      unsigned int strut_of(const LargestInTime &all) const
      {
        return equations.unknowns().layout.largest(
          all.value == largest.value ? double(strut) : 0.);
      }

      const Equations &equations;
      LargestInTime    largest;
      unsigned int     strut = 0;
    };
  } // namespace

  std::unique_ptr<Watch> make_strain_watch(const Equations &equations)
  {
    return std::make_unique<StrainWatch>(equations);
  }
} // namespace auxfem
