#ifndef auxfem_struts_effects_beam_forces_h
#define auxfem_struts_effects_beam_forces_h

#include <auxfem/struts/effects/beam_elements.h>
#include <auxfem/struts/effects/beam_mean_forces.h>
#include <auxfem/struts/effects/beam_samples.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  /**
   * Internal forces of struts as beams of one kind, computed for several
   * elements at a time. @p Beam holds what depends on dimension and theory, as
   * static members:
   * - constants: `order`, `n_components`, `is_linear`, `is_damped`;
   * - types: `Undamped` (the same without damping), `AtRest`, `Motion` of an
   * element's nodes, and `AtRestOf<Lanes>`, `MotionOf<Lanes>` for several
   * elements;
   * - element at rest: `frame`, `stiffness`, `set_shear_stiffness`,
   * `smallest_bending_stiffness`, `largest_stiffness`;
   * - forces: `motion`, `internal_force`, `tangent_motion`, `tangent`, and at
   * Gauss points `geometric_tangent`, `elastic_forces`, `viscous_forces`;
   * - output and energies: `rotation`, `axes`, `strain_product`;
   * - steps with large rotations: `StepStart`, data of the step start that all
   * iterations share, `end_of_step`, `mean_force`, `mean_tangent`.
   *
   * @p Sections is ElasticSections or LawSections.
   */
  template <class Beam, class Sections = ElasticSections<Beam>>
  class BeamForces : public BeamSamples<typename Beam::Undamped>
  {
    using Samples = BeamSamples<typename Beam::Undamped>;

  public:
    BeamForces(const Lattice              &lattice,
               const DofNumbering         &numbering,
               const DofNumbering::Group  &group,
               const std::vector<Section> &sections,
               const StrutModel           &model)
      : Samples({lattice, numbering, group, sections, model.shear_flexibility})
      , responses(beams, model)
      , mean_forces(beams, responses, model.high_frequency_damping)
    {}

    bool is_linear() const override
    {
      return Beam::is_linear && responses.is_linear();
    }

    void register_in(StateLayout &layout) override
    {
      strain_entry = layout.energies.enter(strain_energy_entry());
      mean_forces.register_in(layout);
      if (mean_forces.damps_high_frequencies())
        numerical_entry = layout.energies.enter(numerical_energy_entry());
      if (!Beam::is_damped)
        return;
      layout.velocity = true;
      damping_entry   = layout.energies.enter(
        {EnergyKind::dissipated,
           "strut_damping_dissipated",
           "energy lost by stiffness-proportional damping of the struts since "
             "the start"});
      numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

    std::unique_ptr<EffectCache> make_results() const override
    {
      return std::make_unique<Results>(beams.size());
    }

    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectCache      *results) const override
    {
      auto &beam_results  = static_cast<Results &>(*results);
      beam_results.energy = {};
      if (evaluation.kind == Evaluation::Kind::discrete_gradient)
        mean_forces.for_each_force(
          evaluation,
          beam_results.starts,
          [&](const ElementBatch        &batch,
              const BeamEnergyOf<Lanes> &energy,
              const Lanes(&force)[n]) {
            add_forces(batch, energy, force, residual, beam_results);
          });
      else
        {
          const auto section = responses.in(evaluation, SectionPurpose::forces);
          beams.for_each_batch([&](const ElementBatch &batch) {
            Lanes       force[n];
            const auto &at_rest = beams.at_rest(batch);
            const auto  energy =
              Beam::internal_force(beams.shape,
                                   at_rest,
                                   section(batch, at_rest),
                                   Beam::motion(beams.numbering,
                                                beams.unknowns(batch),
                                                evaluation.to),
                                   force);
            add_forces(batch, energy, force, residual, beam_results);
          });
        }
    }

    void add_tangent(const Evaluation                   &evaluation,
                     [[maybe_unused]] const EffectCache *results,
                     const TangentFactors               &factors,
                     TangentMatrix                      &matrix) const override
    {
      if (factors.stiffness == 0 && factors.damping == 0)
        return;
      if constexpr (!Beam::is_linear)
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          return mean_forces.add_tangent(
            evaluation,
            static_cast<const Results &>(*results).starts,
            factors,
            matrix);
      add_tangent_at_end(evaluation,
                         factors,
                         responses.in(evaluation, SectionPurpose::tangent),
                         matrix);
      if (evaluation.kind == Evaluation::Kind::discrete_gradient &&
          mean_forces.damps_high_frequencies())
        add_tangent_at_end(
          evaluation,
          {mean_forces.stiffness_of_damping(evaluation), 0, 0},
          [](const ElementBatch & /*batch*/, const auto &at_rest) {
            return Beam::elastic_section(at_rest);
          },
          matrix);
    }

    void add_geometric_tangent(const ForceChange &change,
                               const unsigned int /*effect*/,
                               TangentMatrix &matrix) const override
    {
      if constexpr (!Beam::is_linear)
        {
          double        block[n * n];
          SectionForces forces[order], before[order];
          for (unsigned int e = 0; e < beams.size(); ++e)
            {
              this->section_forces(e, change.to, forces);
              this->section_forces(e, change.from, before);
              for (int g = 0; g < order; ++g)
                for (unsigned int k = 0; k < 6; ++k)
                  forces[g][k] = change.factor * (forces[g][k] - before[g][k]);
              Beam::Undamped::geometric_tangent(beams.shape,
                                                beams.at_rest(e),
                                                beams.motion(e, change.state),
                                                forces,
                                                block);
              matrix.add(beams.group.begin + e, block);
            }
        }
    }

    void account(const Evaluation & /*evaluation*/,
                 const EffectCache *results,
                 EnergyAccount     &account) const override
    {
      account.add(strain_entry, energy_of(results).strain);
    }

    void account_step(const Evaluation  &step,
                      const EffectCache *results,
                      EnergyAccount     &account) const override
    {
      if (mean_forces.damps_high_frequencies() &&
          step.kind == Evaluation::Kind::discrete_gradient)
        account.add_in_step(numerical_entry,
                            energy_of(results).numerical_dissipation);
      if constexpr (Beam::is_damped)
        {
          if (!account.has_duration())
            return;
          if (step.kind == Evaluation::Kind::discrete_gradient)
            {
              account.add_in_step(damping_entry,
                                  energy_of(results).dissipation);
              return;
            }
          const DampingWork damping =
            damping_work<Beam>(beams, step, account.motion());
          account.add_in_step(damping_entry, damping.dissipated);
          account.add_in_step(numerical_entry,
                              damping.force_work - damping.dissipated);
        }
    }

    void account_stage(const Evaluation & /*stage*/,
                       const EffectCache *results,
                       EnergyAccount     &account) const override
    {
      if (Beam::is_damped)
        account.add_power(damping_entry, energy_of(results).dissipation);
    }

    StageTerms::StageNeeds stage_needs() const override
    {
      return Beam::is_damped ? StageTerms::StageNeeds::results
                             : StageTerms::StageNeeds::state;
    }

    void row_force_bounds(const Evaluation & /*evaluation*/,
                          const EffectCache *results,
                          double            *forces) const override
    {
      const auto &beam_results = static_cast<const BeamResults &>(*results);
      for (unsigned int e = 0; e < beams.size(); ++e)
        raise_node_bounds(e, beam_results.forces[e], forces);
    }

    void roundoff_force_bounds(const Evaluation &evaluation,
                               const EffectCache * /*results*/,
                               const LargestMotion &largest,
                               double              *forces) const override
    {
      // Mean forces use displacements relative to a node; a rotating element
      // has at most twice its length.
      const double max_strain = !Beam::is_linear &&
          evaluation.kind == Evaluation::Kind::discrete_gradient
        ? 4
        : std::numeric_limits<double>::infinity();
      for (unsigned int e = 0; e < beams.size(); ++e)
        {
          const typename Beam::AtRest at_rest = beams.at_rest(e);
          const double                strain =
            std::min(max_strain, largest.displacement / at_rest.jacobian) +
            std::min(1., largest.rotation);
          double strain_with_rate = strain;
          if constexpr (Beam::is_damped)
            strain_with_rate += at_rest.stiffness.damping_time *
              (evaluation.rates_are_differences()
                 ? strain / evaluation.dt
                 : largest.velocity / at_rest.jacobian + largest.spin);
          raise_node_bounds(e,
                            Beam::largest_stiffness(at_rest.stiffness) *
                              strain_with_rate,
                            forces);
        }
    }

  protected:
    using Samples::beams;
    static constexpr int order        = Beam::order;
    static constexpr int n_components = Beam::n_components;
    static constexpr int n = BeamElements<typename Beam::Undamped>::n;
    Sections             responses; ///< of the sections

    /**
     * Adds the tangent of the internal forces at the end of the step.
     * @param section as LawSections::in()
     */
    template <class SectionOfBatch>
    void add_tangent_at_end(const Evaluation     &evaluation,
                            const TangentFactors &factors,
                            const SectionOfBatch &section,
                            TangentMatrix        &matrix) const
    {
      beams.for_each_batch([&](const ElementBatch &batch) {
        Lanes       block[n * n];
        const auto &at_rest = beams.at_rest(batch);
        Beam::tangent(beams.shape,
                      at_rest,
                      section(batch, at_rest),
                      Beam::tangent_motion(beams.numbering,
                                           beams.unknowns(batch),
                                           evaluation,
                                           factors),
                      factors,
                      block);
        beams.add_blocks(batch, block, matrix);
      });
    }

  private:
    /** Displacement components, which precede the rotations. */
    static constexpr int n_translations = n_components == 3 ? 2 : 3;

    struct Results : public BeamResults
    {
      using BeamResults::BeamResults;

      typename BeamMeanForces<Beam, Sections>::Starts starts;
    };

    /** Strain energy (J) and power lost by damping (W); with
     * Kind::discrete_gradient the energy lost in the step (J). */
    static const BeamEnergy &energy_of(const EffectCache *results)
    {
      return static_cast<const BeamResults &>(*results).energy;
    }

    void viscous_forces(
      [[maybe_unused]] const unsigned int e,
      [[maybe_unused]] const State       &state,
      [[maybe_unused]] SectionForces (&point_forces)[order]) const override
    {
      if constexpr (Beam::is_damped)
        {
          const typename Beam::Motion motions[] = {
            Beam::motion(beams.numbering, beams.unknowns(e), state)};
          SectionForces motion_forces[1][order];
          Beam::viscous_forces(beams.shape,
                               beams.at_rest(e),
                               motions,
                               motion_forces);
          std::copy_n(motion_forces[0], order, point_forces);
        }
    }

    /** Adds the @p force of a batch and records its energies and largest
     * forces. */
    void add_forces(const ElementBatch        &batch,
                    const BeamEnergyOf<Lanes> &energy,
                    const Lanes (&force)[n],
                    double      *residual,
                    BeamResults &results) const
    {
      const Lanes largest =
        largest_end_force(force, batch.numbers([&](const unsigned int e) {
          return beams[e].length;
        }));
      for (unsigned int lane = 0; lane < batch.size; ++lane)
        {
          const unsigned int e = batch.elements[lane];
          add_lane(force, lane, beams.unknowns(e), residual);
          if (beams[e].owned)
            {
              results.energy.strain += lane_value(energy.strain, lane);
              results.energy.dissipation +=
                lane_value(energy.dissipation, lane);
              results.energy.numerical_dissipation +=
                lane_value(energy.numerical_dissipation, lane);
            }
          results.forces[e]          = lane_value(largest, lane);
          results.strain_energies[e] = lane_value(energy.strain, lane);
        }
    }

    /** Largest force of BeamResults at the first two nodes, the ends of the
     * element. */
    static Lanes largest_end_force(const Lanes (&force)[n], const Lanes &length)
    {
      using std::abs, std::max;
      Lanes largest_force = 0, largest_moment = 0;
      for (int a = 0; a < 2; ++a)
        for (int c = 0; c < n_components; ++c)
          {
            Lanes &largest =
              c < n_translations ? largest_force : largest_moment;
            largest = max(largest, abs(force[n_components * a + c]));
          }
      return max(largest_force, Lanes(largest_moment / length));
    }

    /** Raises the bounds @p forces in the rows of element @p e to at least @p
     * force (N). */
    void raise_node_bounds(const unsigned int e,
                           const double       force,
                           double            *forces) const
    {
      const int   *unknowns = beams.unknowns(e);
      const double moment   = force * beams[e].length;
      for (int a = 0; a <= order; ++a)
        for (int c = 0; c < n_components; ++c)
          {
            double &row = forces[unknowns[n_components * a + c]];
            row         = std::max(row, c < n_translations ? force : moment);
          }
    }

    BeamMeanForces<Beam, Sections> mean_forces;
    unsigned int strain_entry = 0, damping_entry = 0, numerical_entry = 0;
  };

  /** @name Struts of one polynomial order, all variants. */
  ///@{
  std::unique_ptr<StrutForces>
  make_plane_struts(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model);

  std::unique_ptr<StrutForces>
  make_space_struts(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model);
  ///@}
} // namespace auxfem

#endif
