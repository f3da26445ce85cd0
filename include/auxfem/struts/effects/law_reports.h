#ifndef auxfem_struts_effects_law_reports_h
#define auxfem_struts_effects_law_reports_h

#include <auxfem/struts/effects/beam_forces.h>
#include <auxfem/struts/effects/law_instants.h>

#include <algorithm>
#include <array>

namespace auxfem
{
  /**
   * Reports of struts with a SectionLaw on a state: section forces, stored
   * energy, yielding, and integrals of these over the elements. @p Beam is
   * undamped.
   */
  template <class Beam>
  class LawReports : public BeamForces<Beam, LawSections<Beam>>
  {
    using Base = BeamForces<Beam, LawSections<Beam>>;

  public:
    using Base::Base;

    StrutStrain largest_plastic_strain(const State &state,
                                       const double least) const override
    {
      StrutStrain largest{least, invalid_index};
      if (!responses.law().yields())
        return largest;
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned && this->carries_load(e, state))
          for (const SectionYielding &point : yielding_in(e, state))
            if (const double strain = lane_value(point.plastic_strain, 0);
                strain > largest.ratio)
              largest = {strain, beams.interval(e).strut};
      return largest;
    }

  protected:
    using Base::beams;
    using Base::n;
    using Base::order;
    using Base::responses;

    void section_forces(const unsigned int e,
                        const State       &state,
                        SectionForces (&point_forces)[order]) const override
    {
      for_each_point(e, state, [&](const int g, const SectionInstant &now) {
        point_forces[g] = Beam::section_forces(now.forces);
      });
    }

    double stored_density(const unsigned int e,
                          const State       &state,
                          const double (&H)[order],
                          const SectionForces & /*forces*/) const override
    {
      double density = 0;
      for_each_point(e, state, [&](const int g, const SectionInstant &now) {
        density += H[g] * lane_value(now.stored, 0);
      });
      return std::max(0., density);
    }

    void subtract_initial_strains(const unsigned int e,
                                  const State       &state,
                                  SectionForces (&forces)[order]) const override
    {
      if (!responses.initial_strains().exist())
        return;
      const ElementBatch batch = batch_of(e);
      const auto         stiffness =
        Beam::stiffness_by_strain(beams.at_rest_in_all_lanes(e));
      std::array<Lanes, Beam::n_strains> strains =
        responses.initial_strains_at(state, batch);
      for (unsigned int k = 0; k < Beam::n_strains; ++k)
        strains[k] *= stiffness[k];
      const SectionForces added = Beam::section_forces(strains.data());
      for (SectionForces &at_point : forces)
        for (unsigned int k = 0; k < at_point.size(); ++k)
          at_point[k] -= added[k];
    }

    bool has_smooth_strains() const override
    {
      return !responses.law().yields();
    }

    double least_stored_fraction() const override
    {
      // Plastic strains store nothing.
      if (responses.law().yields())
        return 0;
      return std::min(responses.law().long_time_ratio(StrainType::normal),
                      responses.law().long_time_ratio(StrainType::shear));
    }

    /** Sum of @p value_of, a function of a batch and its elements at rest, over
     * the elements owned by this rank. */
    template <class ValueOfBatch>
    double sum_over_owned(const ValueOfBatch &value_of) const
    {
      double sum = 0;
      beams.for_each_batch([&](const ElementBatch &batch) {
        const Lanes values = value_of(batch, beams.at_rest(batch));
        for (unsigned int lane = 0; lane < batch.size; ++lane)
          if (beams[batch.elements[lane]].owned)
            sum += lane_value(values, lane);
      });
      return sum;
    }

    /** How far element @p e has yielded at its Gauss points. */
    std::array<SectionYielding, order> yielding_in(const unsigned int e,
                                                   const State &state) const
    {
      const ElementBatch batch   = batch_of(e);
      const auto         at_rest = beams.at_rest_in_all_lanes(e);
      std::array<SectionYielding, order> reports;
      Lanes                              force[n];
      Beam::internal_force(
        beams.shape,
        at_rest,
        Beam::law_section(at_rest,
                          YieldingLaw<Beam>{responses,
                                            state,
                                            batch,
                                            {responses, at_rest},
                                            reports}),
        Beam::motion(beams.numbering, beams.unknowns(batch), state),
        force);
      return reports;
    }

    /** Element @p e alone, in all lanes; see also
     * BeamElements::at_rest_in_all_lanes(). */
    static ElementBatch batch_of(const unsigned int e)
    {
      ElementBatch batch;
      batch.elements.fill(e);
      batch.size = 1;
      return batch;
    }

    /**
     * Integral over each element of a batch of the `stored` that @p
     * make_response sets, at the instant @p state; @p force receives the nodal
     * forces of its section forces.
     */
    template <class AtRest, class Respond>
    Lanes integrate(const ElementBatch &batch,
                    const AtRest       &at_rest,
                    const State        &state,
                    const Respond      &make_response,
                    Lanes (&force)[n],
                    double *rates = nullptr) const
    {
      return Beam::internal_force(
               beams.shape,
               at_rest,
               Beam::law_section(at_rest,
                                 InstantLaw<Beam, Respond>(responses,
                                                           state,
                                                           batch,
                                                           at_rest,
                                                           make_response,
                                                           rates)),
               Beam::motion(beams.numbering, beams.unknowns(batch), state),
               force)
        .strain;
    }

  private:
    /** Calls @p action with the Gauss points of element @p e at an instant. */
    template <class Action>
    void for_each_point(const unsigned int e,
                        const State       &state,
                        const Action      &action) const
    {
      const ElementBatch batch = batch_of(e);
      int                g     = 0;
      Lanes              force[n];
      integrate(
        batch,
        beams.at_rest_in_all_lanes(e),
        state,
        [&](const SectionInstant &now, SectionResponse &) { action(g++, now); },
        force);
    }
  };
} // namespace auxfem

#endif
