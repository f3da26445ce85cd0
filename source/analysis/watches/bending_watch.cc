#include <auxfem/analysis/watch.h>
#include <auxfem/output/verdict_limits.h>
#include <auxfem/parameters/rounded_text.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Bending that varies along elements of order 1, which have one curvature
     * each. In equilibrium the moment rises by the shear force Q times the
     * length h, so that an element lacks the complementary energy
     *
     *     Q^2 h^3 / (24 EI)
     *
     * (R. H. MacNeal, Comput. Struct. 8 (1978) 175-183: the residual bending
     * flexibility). Over the energy that is there and this it is the part of
     * the compliance that is missed: 1 / n^2 of the bending of a strut of n
     * elements with clamped ends that are moved across. Summed up over the run.
     */
    class BendingWatch : public Watch
    {
    public:
      BendingWatch(const StrutGroup &group, const WatchedRun &run)
        : Watch(SamplingRate::single_steps)
        , group(group)
        , model(run.equations.model())
        , missing(run.statistics.number("bending: energy missed (J)"))
        , there(run.statistics.number("bending: energy (J)"))
        , time(run.statistics.number("bending: time (s)"))
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        std::vector<double> energies = {0., 0.};
        for (unsigned int e = group.forces->elements().begin;
             e < group.forces->elements().end;
             ++e)
          if (model.numbering.elements()[e].is_owned)
            add_element(e,
                        step.to,
                        *results.of_effects[group.effect],
                        energies);
        energies = model.numbering.layout().sum(energies);
        missing += energies[0];
        there += energies[1];
        time = step.to.time;
      }

      std::vector<Finding> findings() const override
      {
        const double missed = missing > 0 ? missing / (missing + there) : 0.;
        if (missed <= doubtful_error)
          return {};
        std::ostringstream text;
        text.precision(2);
        text << "Elements of order 1 are too stiff where struts bend: those "
                "here miss about "
             << percentage_text(missed)
             << " of the compliance. Set Discretization/Order = 2 or more, "
                "or raise Discretization/Global refinements: each halving of "
                "the elements leaves a quarter of it.";
        return {{missed > unusable_error ? Verdict::not_to_be_used
                                         : Verdict::doubtful,
                 text.str(),
                 time,
                 ""}};
      }

    private:
      /** Adds to the energies that are missed and that are there (J). */
      void add_element(const unsigned int   e,
                       const State         &state,
                       const EffectResults &results,
                       std::vector<double> &energies) const
      {
        const StrutInterval &interval = model.numbering.elements()[e].interval;
        const Strut         &strut    = model.lattice.struts[interval.strut];
        const Section       &section  = model.sections[strut.section];
        const double         length =
          model.lattice.length(strut) * (interval.end - interval.begin);
        const dealii::Tensor<1, 3> force =
          group.forces->sample(state, e, 2).front().force;
        double squares = force[1] * force[1] / section.bending_stiffness_3();
        if (model.lattice.dimension == 3)
          squares += force[2] * force[2] / section.bending_stiffness_2();
        energies[0] += squares * length * length * length / 24;
        energies[1] += group.forces->strain_energy(results, e);
      }

      const StrutGroup    group;
      const LatticeModel &model;
      /** Summed up over sampled steps (J). */
      double &missing, &there;
      double &time; ///< s
    };
  } // namespace

  std::unique_ptr<Watch> make_bending_watch(const WatchedRun &run)
  {
    for (const StrutGroup &group : run.equations.reporting().struts)
      if (group.forces->elements().order == 1)
        return std::make_unique<BendingWatch>(group, run);
    return nullptr;
  }
} // namespace auxfem
