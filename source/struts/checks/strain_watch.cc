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
     * Strain of outer fibres from which on forces are doubtful; at 1 a fibre
     * in compression has no length.
     * @tuned theory: definitions of strain then change the force by as much
     */
    constexpr double doubtful_strain = 0.5;
    constexpr double ruinous_strain  = 1;

    /** Strains beyond what is allowed. */
    struct Excess
    {
      Occurrence first, largest;
      double     strain;  ///< the largest
      bool       on_path; ///< of equilibria, in place of time
    };

    Finding doubtful_strain_finding(const Excess &excess)
    {
      const std::string location =
        "strut " + std::to_string(excess.largest.number);
      std::ostringstream text;
      text.precision(3);
      text << "The strain reaches " << percentage_text(excess.strain, 3)
           << " in an outer "
           << "fibre of " << location
           << ". Stress in proportion to strain and sections that keep their "
              "shape, which beams here are made of, do not hold beyond some "
           << percentage_text(doubtful_strain, 3)
           << " for any material: check loads, sections and units.";
      return {excess.strain > ruinous_strain ? Verdict::not_to_be_used
                                             : Verdict::doubtful,
              text.str(),
              excess.largest.time,
              location};
    }

    Finding yield_finding(const Excess &excess)
    {
      const std::string location =
        "strut " + std::to_string(excess.first.number);
      std::ostringstream text;
      text.precision(3);
      text << "The material yields from about "
           << moment_text(excess.on_path, excess.first.time, 3)
           << " on, first in " << location << "; strut "
           << excess.largest.number << " reaches a strain of "
           << percentage_text(excess.strain, 3) << " in an outer fibre at "
           << moment_text(excess.on_path, excess.largest.time, 3)
           << ", its Yield strain is "
           << percentage_text(excess.strain / excess.largest.size, 3)
           << ". Struts here stay elastic; real ones are softer from there "
              "on and keep a part of the deformation. Reduce the load, or use "
              "the results until then.";
      return {Verdict::doubtful, text.str(), excess.first.time, location};
    }

    /** Of strains beyond what the section of a strut may have. */
    class StrainWatch : public Watch
    {
    public:
      /** @param limits by section */
      StrainWatch(const Equations               &equations,
                  const std::vector<StrainLimit> limits,
                  Occurrences                   &beyond,
                  Finding (*finding)(const Excess &))
        : Watch(SamplingRate::bursts)
        , limits(limits)
        , equations(equations)
        , finding(finding)
        , beyond(beyond)
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        for (const StrutGroup &group : equations.reporting().struts)
          {
            const auto       &known = beyond.largest_here();
            const StrutStrain found =
              group.forces->largest_strain(step.to,
                                           *results.effect_caches[group.effect],
                                           limits,
                                           known ? known->size : 1.);
            if (found.strut != invalid_index)
              beyond.add({found.ratio, step.to.time, found.strut});
          }
      }

      std::vector<Finding> findings() const override
      {
        const auto first = beyond.first(), largest = beyond.largest();
        if (!first)
          return {};
        const double allowed_there =
          limits[equations.model().lattice.struts[largest->number].section]
            .strain;
        return {finding({*first,
                         *largest,
                         largest->size * allowed_there,
                         equations.layout().path})};
      }

    private:
      const std::vector<StrainLimit> limits;
      const Equations               &equations;
      Finding (*const finding)(const Excess &);
      Occurrences &beyond; ///< strains over what is allowed
    };

    std::vector<StrainLimit>
    doubtful_strains(const std::vector<Section> &sections)
    {
      std::vector<StrainLimit> limits;
      for (const Section &section : sections)
        limits.push_back({doubtful_strain, section.fibre_distances});
      return limits;
    }

    /** Sections whose outer fibres are not known, with the nearest that
     * these can be. */
    std::vector<StrainLimit> yield_strains(const std::vector<Section> &sections)
    {
      std::vector<StrainLimit> limits;
      for (const Section &section : sections)
        limits.push_back({section.yield_strain.value_or(
                            std::numeric_limits<double>::infinity()),
                          section.fibre_distances[1] > 0
                            ? section.fibre_distances
                            : section.radii_of_gyration()});
      return limits;
    }
  } // namespace

  std::unique_ptr<Watch> make_strain_watch(const WatchedRun &run)
  {
    return std::make_unique<StrainWatch>(run.equations,
                                         doubtful_strains(
                                           run.equations.model().sections),
                                         run.statistics.occurrences("strain"),
                                         doubtful_strain_finding);
  }

  std::unique_ptr<Watch> make_yield_watch(const WatchedRun &run)
  {
    return std::make_unique<StrainWatch>(
      run.equations,
      yield_strains(run.equations.model().sections),
      run.statistics.occurrences("yield strain"),
      yield_finding);
  }
} // namespace auxfem
