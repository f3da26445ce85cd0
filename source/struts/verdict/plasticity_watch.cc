#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/text.h>
#include <auxfem/state/step_report.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/time/watch.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Plastic strain over the yield strain from which a section counts as a
     * hinge: the moment 1.5 - 1 / (2 m^2) of a rectangle at m times the yield
     * strain, over that of first yield, is then within a noticeable fraction of
     * the fully plastic one.
     */
    const double hinge_strain = std::sqrt(1 / (3 * noticeable_fraction)) - 1;

    /**
     * Largest overestimate of a perfectly plastic collapse load: hinges form at
     * the Gauss points next to the ends of a strut, at the distance s from
     * them, in place of the joints, which shortens the arm of end moments to l
     * - 2 s.
     */
    double hinge_error(const StrutDivision &division)
    {
      const double first = dealii::QGauss<1>(division.order).point(0)[0];
      const double part  = 2 * first / division.n_elements;
      return part / (1 - part);
    }

    /** Checks plastic strains against the data of the material, and elements
     * with hinges against two of order 4, whose loads are right to 1 % with
     * some hardening (doc/theory/struts.md, Materials). */
    class PlasticityWatch : public Watch
    {
    public:
      explicit PlasticityWatch(const WatchContext &run)
        : Watch(SamplingRate::single_steps)
        , equations(run.equations)
        , beyond_data(run.statistics.occurrences("plasticity: beyond data"))
        , hinges(run.statistics.occurrences("plasticity: hinges"))
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        const LatticeModel &model = equations.model();
        for (const StrutGroup &group : equations.reporting().struts)
          {
            const auto &law = model.laws[group.forces->elements().law];
            if (!law || !law->yields())
              continue;
            const StrutStrain largest =
              group.forces->largest_plastic_strain(step.to, 0);
            if (largest.strut == invalid_index)
              continue;
            const auto add = [&](const double limit, EventExtremes &events) {
              if (largest.ratio > limit)
                events.add(
                  {largest.ratio / limit, step.to.time, largest.strut});
            };
            if (const auto end = law->largest_plastic_strain())
              add(*end, beyond_data);
            if (hinge_error(model.numbering.divisions()[largest.strut]) >
                hinge_error({4, 2}) + round_off)
              add(hinge_strain * *law->yield_strain(), hinges);
          }
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> all;
        if (const auto largest = beyond_data.largest())
          all.push_back(beyond_data_finding(*beyond_data.first(), *largest));
        if (const auto first = hinges.first())
          all.push_back(hinge_finding(*first));
        return all;
      }

    private:
      static Finding beyond_data_finding(const LocatedEvent &first,
                                         const LocatedEvent &largest)
      {
        const std::string  strut = "strut " + std::to_string(first.number);
        std::ostringstream text;
        text.precision(3);
        text << "Plastic strains leave the table of the material at t = "
             << first.time << " s, first in " << strut << ", and reach "
             << largest.size << " times its last strain in strut "
             << largest.number
             << ". The yield stress stays constant there. Extend Plastic "
                "strains and Flow stresses, or use the results up to that "
                "time.";
        return {Verdict::doubtful, text.str(), first.time, strut};
      }

      Finding hinge_finding(const LocatedEvent &first) const
      {
        const std::string    strut = "strut " + std::to_string(first.number);
        const StrutDivision &division =
          equations.model().numbering.divisions()[first.number];
        std::ostringstream text;
        text.precision(3);
        text
          << "Plastic hinges form from t = " << first.time << " s on, first "
          << "in " << strut << ", at the Gauss points next to its ends: with "
          << division.n_elements << " elements of order " << division.order
          << " a strut this raises the load at which it collapses by up to "
          << percentage_text(hinge_error(division))
          << ", less with hardening. Set Discretization/Order = 4 and Global "
             "refinements = 1 or more: each refinement halves it.";
        return {Verdict::doubtful, text.str(), first.time, strut};
      }

      const Equations &equations;
      /** Plastic strains over the last one of the table. */
      EventExtremes &beyond_data;
      /** Plastic strains over that of a hinge, where elements are coarse. */
      EventExtremes &hinges;
    };
  } // namespace

  std::unique_ptr<Watch> make_plasticity_watch(const WatchContext &run)
  {
    return std::make_unique<PlasticityWatch>(run);
  }
} // namespace auxfem
