#include <auxfem/parameters/text.h>
#include <auxfem/state/step_report.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/time/watch.h>

#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Outer-fibre strain above which forces are doubtful; at 1 a fibre in
     * compression has no length.
     * @tuned theory: definitions of strain then change the force by as much
     */
    constexpr double doubtful_strain = 0.5;
    constexpr double unusable_strain = 1;

    /** Strains above the allowed strain, for the text of a finding. */
    struct StrainExcess
    {
      LocatedEvent first, largest;
      double       strain;  ///< largest strain
      bool         on_path; ///< equilibrium path: no time
    };

    Finding doubtful_strain_finding(const StrainExcess &exceedance)
    {
      const std::string location =
        "strut " + std::to_string(exceedance.largest.number);
      std::ostringstream text;
      text.precision(3);
      text << "The strain reaches " << percentage_text(exceedance.strain, 3)
           << " in an outer "
           << "fibre of " << location
           << ". Undeformed sections and laws of small strains, which beams "
              "assume, are not valid beyond some "
           << percentage_text(doubtful_strain, 3)
           << " for any material: check loads, sections and units.";
      return {exceedance.strain > unusable_strain ? Verdict::not_to_be_used
                                                  : Verdict::doubtful,
              text.str(),
              exceedance.largest.time,
              location};
    }

    Finding yield_finding(const StrainExcess &exceedance)
    {
      const std::string location =
        "strut " + std::to_string(exceedance.first.number);
      std::ostringstream text;
      text.precision(3);
      text << "The material yields from about "
           << moment_text(exceedance.on_path, exceedance.first.time, 3)
           << " on, first in " << location << "; strut "
           << exceedance.largest.number << " reaches a strain of "
           << percentage_text(exceedance.strain, 3) << " in an outer fibre at "
           << moment_text(exceedance.on_path, exceedance.largest.time, 3)
           << ", its Yield strain is "
           << percentage_text(exceedance.strain / exceedance.largest.size, 3)
           << ". The model stays elastic; real struts soften and deform "
              "permanently. Reduce the load, or use the results up to that "
              "point.";
      return {Verdict::doubtful, text.str(), exceedance.first.time, location};
    }

    /** Checks outer-fibre strains against the limit of their section. */
    class StrainWatch : public Watch
    {
    public:
      /** @param limits by section */
      StrainWatch(const Equations               &equations,
                  const std::vector<StrainLimit> limits,
                  EventExtremes                 &exceedances,
                  Finding (*finding)(const StrainExcess &))
        : Watch(SamplingRate::bursts)
        , limits(limits)
        , equations(equations)
        , finding(finding)
        , exceedances(exceedances)
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        for (const StrutGroup &group : equations.reporting().struts)
          {
            const auto       &largest_so_far = exceedances.largest_here();
            const StrutStrain strain =
              group.forces->largest_strain(step.to,
                                           *results.effect_caches[group.effect],
                                           limits,
                                           largest_so_far ? largest_so_far->size
                                                          : 1.);
            if (strain.strut != invalid_index)
              exceedances.add({strain.ratio, step.to.time, strain.strut});
          }
      }

      std::vector<Finding> findings() const override
      {
        const auto first = exceedances.first(), largest = exceedances.largest();
        if (!first)
          return {};
        const double allowed_strain =
          limits[equations.model().lattice.struts[largest->number].section]
            .strain;
        return {finding({*first,
                         *largest,
                         largest->size * allowed_strain,
                         equations.layout().path})};
      }

    private:
      const std::vector<StrainLimit> limits;
      const Equations               &equations;
      Finding (*const finding)(const StrainExcess &);
      EventExtremes &exceedances; ///< strains over the allowed strain
    };

    std::vector<StrainLimit>
    doubtful_strains(const std::vector<Section> &sections)
    {
      std::vector<StrainLimit> limits;
      for (const Section &section : sections)
        limits.push_back({doubtful_strain, section.outer_fibres});
      return limits;
    }

    /** Yield strains; sections with unknown fibres use a lower
     * bound, the radius of gyration. */
    std::vector<StrainLimit> yield_strains(const std::vector<Section> &sections)
    {
      std::vector<StrainLimit> limits;
      for (const Section &section : sections)
        limits.push_back({section.yield_strain.value_or(
                            std::numeric_limits<double>::infinity()),
                          section.outer_fibres.empty()
                            ? fibres_at(section.radii_of_gyration())
                            : section.outer_fibres});
      return limits;
    }
  } // namespace

  std::unique_ptr<Watch> make_strain_watch(const WatchContext &run)
  {
    return std::make_unique<StrainWatch>(run.equations,
                                         doubtful_strains(
                                           run.equations.model().sections),
                                         run.statistics.occurrences("strain"),
                                         doubtful_strain_finding);
  }

  std::unique_ptr<Watch> make_yield_watch(const WatchContext &run)
  {
    return std::make_unique<StrainWatch>(
      run.equations,
      yield_strains(run.equations.model().sections),
      run.statistics.occurrences("yield strain"),
      yield_finding);
  }
} // namespace auxfem
