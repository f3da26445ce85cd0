#include <auxfem/equations/load_work.h>
#include <auxfem/struts/effects/group_initial_strains.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Position of a strain among the @p n_strains of a section. */
    unsigned int index_of(const InitialStrain::Kind kind,
                          const unsigned int        n_strains)
    {
      switch (kind)
        {
          case InitialStrain::Kind::axial:
            return 0;
          case InitialStrain::Kind::curvature_2:
            return 4;
          default:
            return n_strains - 1;
        }
    }
  } // namespace

  GroupInitialStrains::GroupInitialStrains(
    const InitialStrains            &all,
    const std::vector<unsigned int> &struts,
    const unsigned int               n_strains)
    : raised_from_zero(all.raised_from_zero)
  {
    for (const InitialStrain &strain : all.strains)
      {
        GroupStrain group{&strain, index_of(strain.kind, n_strains), {}};
        for (const unsigned int strut : struts)
          group.factors.push_back(strain.factors[strut]);
        if (std::any_of(group.factors.begin(),
                        group.factors.end(),
                        [](const double factor) { return factor != 0; }))
          groups.push_back(std::move(group));
      }
  }

  template <class Evaluate>
  InitialStrainLoads GroupInitialStrains::values(const State    &state,
                                                 const Evaluate &evaluate) const
  {
    InitialStrainLoads values(groups.size(), 0.);
    if (!raised_from_zero || state.time > 0)
      for (unsigned int i = 0; i < groups.size(); ++i)
        values[i] = evaluate(groups[i].strain->history);
    return values;
  }

  InitialStrainLoads GroupInitialStrains::at(const State &state) const
  {
    return values(state, [&](const TimeFunction &history) {
      return history.value(time_of_loads(state));
    });
  }

  InitialStrainLoads
  GroupInitialStrains::at_end(const Evaluation &evaluation) const
  {
    return values(evaluation.to, [&](const TimeFunction &history) {
      return value_at_end(history, evaluation);
    });
  }

  InitialStrainLoads GroupInitialStrains::at_start(const Evaluation &step) const
  {
    // A jump at the start strains struts within the step.
    return values(step.from, [&](const TimeFunction &history) {
      return step.event_at_from ? history.value_before(*step.event_at_from)
                                : history.value(time_of_loads(step.from));
    });
  }

  InitialStrainLoads
  GroupInitialStrains::rates(const Evaluation &evaluation) const
  {
    InitialStrainLoads rates;
    for (const GroupStrain &group : groups)
      rates.push_back(
        group.strain->history.jet(time_of_loads(evaluation.to))[1]);
    return rates;
  }
} // namespace auxfem
