#include <auxfem/analysis/spaced_looks.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/parameters/rounded_text.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string bending_record = "watch: bending of linear elements";

    /** Part of the compliance that is missed. */
    constexpr double doubtful_lack = 0.05, ruinous_lack = 0.25;

    /** Steps between two looks with inertia. */
    constexpr unsigned int steps_between_bending_looks = 10;

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
      BendingWatch(const StrutGroup &group,
                   const Scene      &scene,
                   const Equations  &equations)
        : group(group)
        , model(equations.model())
        , looks(scene, model.simulated, steps_between_bending_looks)
      {}

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        time = step.to.time;
        if (!looks.are_due(step.to.time))
          return;
        for (unsigned int e = group.forces->elements().begin;
             e < group.forces->elements().end;
             ++e)
          if (model.numbering.elements()[e].is_owned)
            add_element(e, step.to, *results.of_effects[group.effect]);
      }

      std::vector<Finding> findings() const override
      {
        const std::vector<double> sums = sums_of_all();
        const double missed = sums[0] > 0 ? sums[0] / (sums[0] + sums[1]) : 0.;
        if (missed <= doubtful_lack)
          return {};
        std::ostringstream text;
        text.precision(2);
        text << "Elements of order 1 are too stiff where struts bend: those "
                "here miss about "
             << percentage_text(missed)
             << " of the compliance. Set Discretization/Order = 2 or more, "
                "or raise Discretization/Global refinements: each halving of "
                "the elements leaves a quarter of it.";
        return {
          {missed > ruinous_lack ? Verdict::not_to_be_used : Verdict::doubtful,
           text.str(),
           time,
           ""}};
      }

      void save(Records &records) const override
      {
        const std::vector<double> sums = sums_of_all();
        records.keep(bending_record, {sums[0], sums[1], time, looks.save()});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(bending_record, 4);
        // Sums go on on one rank.
        const bool is_first = model.numbering.layout().rank() == 0;
        missing             = is_first ? values[0] : 0;
        there               = is_first ? values[1] : 0;
        time                = values[2];
        looks.resume(values[3]);
      }

    private:
      void add_element(const unsigned int   e,
                       const State         &state,
                       const EffectResults &results)
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
        missing += squares * length * length * length / 24;
        there += group.forces->strain_energy(results, e);
      }

      std::vector<double> sums_of_all() const
      {
        return model.numbering.layout().sum({missing, there});
      }

      const StrutGroup    group;
      const LatticeModel &model;
      SpacedLooks         looks;
      double              time = 0; ///< s
      /** Energy that is missed and that is there (J), summed up over looks on
       * this rank. */
      double missing = 0, there = 0;
    };
  } // namespace

  std::unique_ptr<Watch> make_bending_watch(const StrutGroup &linear_elements,
                                            const Scene      &scene,
                                            const Equations  &equations)
  {
    return std::make_unique<BendingWatch>(linear_elements, scene, equations);
  }
} // namespace auxfem
