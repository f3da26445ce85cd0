#ifndef auxfem_struts_effects_law_instants_h
#define auxfem_struts_effects_law_instants_h

#include <auxfem/struts/effects/law_sections.h>

#include <array>

namespace auxfem
{
  /**
   * Sections at an instant whose response @p Respond makes from the
   * SectionInstant; the law writes the rates of the internal variables to @p
   * rates if not nullptr.
   */
  template <class Beam, class Respond>
  class InstantLaw
  {
  public:
    template <class AtRest>
    InstantLaw(const LawSections<Beam> &sections,
               const State             &state,
               const ElementBatch      &batch,
               const AtRest            &at_rest,
               const Respond           &make_response,
               double                  *rates)
      : sections(sections)
      , state(state)
      , batch(batch)
      , points(sections, at_rest)
      , initial(sections.initial_strains_at(state, batch))
      , make_response(make_response)
      , rates(rates)
    {}

    SectionResponse respond(const int g,
                            const Lanes (&total)[Beam::n_strains]) const
    {
      const SectionHistory history = sections.history(state.history, batch, g);
      SectionInstant       now;
      Lanes                strains[Beam::n_strains];
      for (unsigned int k = 0; k < Beam::n_strains; ++k)
        strains[k] = total[k] - initial[k];
      if (rates == nullptr)
        sections.law().instant(points.point(), strains, history, nullptr, now);
      else
        {
          const SectionHistoryOutput output =
            sections.history_output(rates, batch, g);
          sections.law().instant(points.point(),
                                 strains,
                                 history,
                                 &output,
                                 now);
        }
      if (sections.may_fail())
        weaken(now);
      SectionResponse response = {};
      make_response(now, response);
      return response;
    }

  private:
    /** Takes away what broken struts have lost. */
    void weaken(SectionInstant &now) const
    {
      const Lanes intact = sections.intactness(state.history, batch, 0);
      for (unsigned int k = 0; k < Beam::n_strains; ++k)
        now.forces[k] *= intact;
      now.stored *= intact;
    }

    const LawSections<Beam>                   &sections;
    const State                               &state;
    const ElementBatch                        &batch;
    const typename LawSections<Beam>::PointsOf points;
    const std::array<Lanes, Beam::n_strains>   initial;
    const Respond                             &make_response;
    double                                    *rates;
  };

  /** Sections that report how far they have yielded, by Gauss point. */
  template <class Beam>
  struct YieldingLaw
  {
    SectionResponse respond(const int g,
                            const Lanes (&total)[Beam::n_strains]) const
    {
      Lanes strains[Beam::n_strains];
      for (unsigned int k = 0; k < Beam::n_strains; ++k)
        strains[k] = total[k] - initial[k];
      reports[g] =
        sections.law().yielding(points.point(),
                                strains,
                                sections.history(state.history, batch, g));
      return {};
    }

    const LawSections<Beam>                   &sections;
    const State                               &state;
    const ElementBatch                        &batch;
    const typename LawSections<Beam>::PointsOf points;
    std::array<SectionYielding, Beam::order>  &reports;
    const std::array<Lanes, Beam::n_strains>   initial =
      sections.initial_strains_at(state, batch);
  };
} // namespace auxfem

#endif
