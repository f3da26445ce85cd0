#include <auxfem/output/verdict.h>
#include <auxfem/parameters/text.h>
#include <auxfem/state/step_report.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/time/watch.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Checks bending that varies along elements of order 1, which have one
     * curvature each. In equilibrium the moment changes by the shear force Q
     * times the length h, so an element misses the complementary energy
     *
     *     Q^2 h^3 / (24 EI)
     *
     * (R. H. MacNeal, Comput. Struct. 8 (1978) 175-183: residual bending
     * flexibility). Its ratio to the total energy, summed over the run, is the
     * missing fraction of the compliance.
     */
    class BendingWatch : public Watch
    {
    public:
      /** @param groups elements of order 1 */
      BendingWatch(std::vector<StrutGroup> groups, const WatchContext &run)
        : Watch(SamplingRate::single_steps)
        , groups(std::move(groups))
        , model(run.equations.model())
        , missing_energy(run.statistics.number("bending: energy missed (J)"))
        , strain_energy_sum(run.statistics.number("bending: energy (J)"))
        , time(run.statistics.number("bending: time (s)"))
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        std::vector<double> energies = {0., 0.};
        for (const StrutGroup &group : groups)
          for (unsigned int e = group.forces->elements().begin;
               e < group.forces->elements().end;
               ++e)
            if (model.numbering.elements()[e].is_owned)
              add_element(*group.forces,
                          e,
                          step.to,
                          *results.effect_caches[group.effect],
                          energies);
        energies = model.numbering.layout().sum(energies);
        missing_energy += energies[0];
        strain_energy_sum += energies[1];
        time = step.to.time;
      }

      std::vector<Finding> findings() const override
      {
        const double missing_fraction = missing_energy > 0
          ? missing_energy / (missing_energy + strain_energy_sum)
          : 0.;
        if (missing_fraction <= doubtful_error)
          return {};
        std::ostringstream text;
        text.precision(2);
        text << "Elements of order 1 are too stiff where struts bend: those "
                "here miss about "
             << percentage_text(missing_fraction)
             << " of the compliance. Set Discretization/Order = 2 or more, "
                "or raise Discretization/Global refinements: each refinement "
                "reduces this error to a quarter.";
        return {{missing_fraction > unusable_error ? Verdict::not_to_be_used
                                                   : Verdict::doubtful,
                 text.str(),
                 time,
                 ""}};
      }

    private:
      /** Adds the missing energy and the strain energy of an element (J). */
      void add_element(const StrutForces   &forces,
                       const unsigned int   e,
                       const State         &state,
                       const EffectCache   &results,
                       std::vector<double> &energies) const
      {
        const StrutInterval &interval = model.numbering.elements()[e].interval;
        const Strut         &strut    = model.lattice.struts[interval.strut];
        const Section       &section  = model.sections[strut.section];
        const double         length =
          model.lattice.length(strut) * (interval.end - interval.begin);
        const dealii::Tensor<1, 3> force =
          forces.sample(state, e, 2).front().force;
        double squares = force[1] * force[1] / section.bending_stiffness_3();
        if (model.lattice.dimension == 3)
          squares += force[2] * force[2] / section.bending_stiffness_2();
        energies[0] += squares * length * length * length / 24;
        energies[1] += forces.strain_energy(results, e);
      }

      const std::vector<StrutGroup> groups;
      const LatticeModel           &model;
      /** Sums over sampled steps (J). */
      double &missing_energy, &strain_energy_sum;
      double &time; ///< s
    };
  } // namespace

  std::unique_ptr<Watch> make_bending_watch(const WatchContext &run)
  {
    std::vector<StrutGroup> groups;
    for (const StrutGroup &group : run.equations.reporting().struts)
      if (group.forces->elements().order == 1)
        groups.push_back(group);
    if (groups.empty())
      return nullptr;
    return std::make_unique<BendingWatch>(std::move(groups), run);
  }

  namespace
  {
    /**
     * Smallest axial force, over EI / L^2, at which one element per strut
     * misplaces the buckling load between joints by more than a tenth. Order 2:
     * hinged ends; order 3: one end clamped, one hinged. Nothing from order 4
     * on.
     */
    std::optional<double> doubtful_load(const unsigned int order)
    {
      using dealii::numbers::PI;
      if (order <= 2)
        return PI * PI;
      // (tan x = x)^2
      if (order == 3)
        return 20.19;
      return std::nullopt;
    }

    /** Checks struts of one element, whose local buckling the mesh cannot
     * represent. */
    class LocalBucklingWatch : public Watch
    {
    public:
      explicit LocalBucklingWatch(const WatchContext &run)
        : Watch(SamplingRate::single_steps)
        , equations(run.equations)
        , model(run.equations.model())
        , compressions(run.statistics.occurrences("local buckling"))
      {
        for (const StrutGroup &group : run.equations.reporting().struts)
          if (const auto load = doubtful_load(group.forces->elements().order))
            add_struts(group, *load);
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        for (const WatchedStrut &strut : struts)
          {
            const double compression =
              -strut.group.forces->axial_force(step.to, strut.element);
            if (compression > strut.load)
              compressions.add(
                {compression / strut.load, step.to.time, strut.number});
          }
      }

      std::vector<Finding> findings() const override
      {
        const auto first   = compressions.first(),
                   largest = compressions.largest();
        if (!first)
          return {};
        const unsigned int order =
          model.numbering.divisions()[first->number].order;
        const std::string  location = "strut " + std::to_string(first->number);
        std::ostringstream text;
        text.precision(3);
        text
          << "Struts may buckle between their joints, which the mesh does not "
             "represent: one element of order "
          << order << " is too stiff in local buckling"
          << (order <= 2 ? "" : " with clamped ends") << ". From about "
          << moment_text(equations.layout().path, first->time, 3) << " on, "
          << location << " carries more compression than "
          << (order <= 2 ? "its buckling load with hinged ends"
                         : "its buckling load with one end clamped, one "
                           "hinged")
          << "; strut " << largest->number << " reaches " << largest->size
          << " times that load at "
          << moment_text(equations.layout().path, largest->time, 3)
          << ". Set Discretization/Order = 4 or Global refinements = 1.";
        return {{Verdict::doubtful, text.str(), first->time, location}};
      }

    private:
      struct WatchedStrut
      {
        StrutGroup   group;
        unsigned int element; ///< element of the numbering
        unsigned int number;  ///< strut number
        double       load;    ///< N
      };

      void add_struts(const StrutGroup &group, const double load)
      {
        for (unsigned int e = group.forces->elements().begin;
             e < group.forces->elements().end;
             ++e)
          {
            const DofNumbering::Element &element =
              model.numbering.elements()[e];
            const StrutInterval &interval = element.interval;
            if (!element.is_owned || interval.begin != 0. || interval.end != 1.)
              continue;
            const Strut   &strut   = model.lattice.struts[interval.strut];
            const Section &section = model.sections[strut.section];
            const double   length  = model.lattice.length(strut);
            const double   bending = model.lattice.dimension == 2
                ? section.bending_stiffness_3()
                : std::min(section.bending_stiffness_2(),
                         section.bending_stiffness_3());
            struts.push_back(
              {group, e, interval.strut, load * bending / (length * length)});
          }
      }

      const Equations          &equations;
      const LatticeModel       &model;
      std::vector<WatchedStrut> struts;
      EventExtremes &compressions; ///< compression over WatchedStrut::load
    };
  } // namespace

  std::unique_ptr<Watch> make_local_buckling_watch(const WatchContext &run)
  {
    return std::make_unique<LocalBucklingWatch>(run);
  }
} // namespace auxfem
