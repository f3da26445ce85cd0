#ifndef auxfem_struts_effects_law_sections_h
#define auxfem_struts_effects_law_sections_h

#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/effects/beam_elements.h>
#include <auxfem/struts/effects/law_section.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

/**
 * @file
 * Sources of the section forces of BeamForces: ElasticSections compute them
 * from the stiffness alone, LawSections from a SectionLaw with history. Both
 * give the kernels an object per batch of elements, see ElasticSection of
 * Beam2D.
 */
namespace auxfem
{
  /** Purpose of an evaluation of sections. */
  enum class SectionPurpose
  {
    tangent, ///< linearization at the strains of the end
    /** Section forces. The internal variables and the kept values of laws that
     * have internal variables enter the trial state: a stage of a Runge-Kutta
     * step needs them before the step is accepted. */
    forces,
    /** History at the strains of the end, of a solved step. */
    history
  };

  /** Linear elastic sections. */
  template <class Beam>
  class ElasticSections
  {
  public:
    static constexpr bool is_elastic = true;

    ElasticSections(const BeamElements<typename Beam::Undamped> & /*beams*/,
                    const StrutModel & /*model*/)
    {}

    bool is_linear() const
    {
      return true;
    }

    /** Returns a function of a batch and its elements at rest: the section. */
    auto in(const Evaluation & /*evaluation*/,
            const SectionPurpose /*purpose*/) const
    {
      return [](const ElementBatch & /*batch*/, const auto &at_rest) {
        return Beam::elastic_section(at_rest);
      };
    }
  };

  /**
   * Sections with a SectionLaw. State::history has, element by element and
   * Gauss point by Gauss point, the internal variables in one record and the
   * kept values in another.
   */
  template <class Beam>
  class LawSections
  {
  public:
    static constexpr bool is_elastic = false;

    LawSections(const BeamElements<typename Beam::Undamped> &beams,
                const StrutModel                            &model)
      : beams(beams)
      , section_law(model.law)
      , time_of_failure(section_law->failure_time())
      , initial(*model.initial_strains, struts_of(beams), n_strains)
      , has_inertia(model.has_inertia)
    {
      for (std::size_t k = 0; k < types.size(); ++k)
        types[k] = Beam::strain_type(k, beams.shear > 0);
      const SectionPoint point = {n_strains, types.data(), nullptr, nullptr};
      n_internal               = section_law->n_internal(point);
      n_kept                   = section_law->n_kept(point);
    }

    /** Strains without which sections would be free of forces. */
    const GroupInitialStrains &initial_strains() const
    {
      return initial;
    }

    const SectionLaw &law() const
    {
      return *section_law;
    }

    bool is_linear() const
    {
      return section_law->is_linear();
    }

    void register_in(StateLayout &layout)
    {
      const std::string name    = beams.record_name();
      const auto        numbers = beams.numbers_in_lattice();
      if (n_internal > 0)
        {
          first_internal = layout.history.keep(name + ": internal variables",
                                               numbers,
                                               Beam::order * n_internal);
          layout.integrated.emplace_back(first_internal,
                                         layout.history.n_values());
        }
      if (n_kept > 0)
        first_kept = layout.history.keep(name + ": strains",
                                         numbers,
                                         Beam::order * n_kept);
      if (may_fail())
        first_lost_part = layout.history.keep(name + ": lost part",
                                              numbers,
                                              /*values_per_item=*/1);
    }

    /** Whether struts may break. */
    bool may_fail() const
    {
      return time_of_failure.has_value();
    }

    /** Whether all nodes of element @p e move by inertia. */
    bool moves_by_inertia(const unsigned int e) const
    {
      const Section &section = beams.section(e);
      const auto     rotary  = section.rotary_inertia_per_length();
      return has_inertia && section.density > 0 &&
        (n_strains == 3 ? rotary[2]
                        : *std::min_element(rotary.begin(), rotary.end())) > 0;
    }

    /** Time in which a broken strut loses its forces (s), if it may break. */
    const std::optional<double> &failure_time() const
    {
      return time_of_failure;
    }

    /** Position in State::history of the part of their forces that broken
     * elements have lost, above 0 from the moment of failure on; it may pass
     * 1. */
    std::size_t lost_parts() const
    {
      return first_lost_part;
    }

    /** Part of the forces lost after another @p dt (s), from @p before. */
    double lost_part_after(const double before, const double dt) const
    {
      return before > 0 ? before + dt / *time_of_failure : 0;
    }

    /** Factor of the forces of a batch @p dt (s) after the state with @p
     * history. */
    Lanes intactness(const std::vector<double> &history,
                     const ElementBatch        &batch,
                     const double               dt) const
    {
      return batch.numbers([&](const unsigned int e) {
        return std::max(remaining_part(e),
                        1 - lost_part_after(history[first_lost_part + e], dt));
      });
    }

    /** Whether residuals leave the history to be found after a step. */
    bool finds_history_after_step() const
    {
      return n_internal == 0;
    }

    /** History at a Gauss point of a batch in @p values, of the size of
     * State::history. */
    SectionHistory history(const std::vector<double> &values,
                           const ElementBatch        &batch,
                           const int                  g) const
    {
      const auto first = [&](const std::size_t at, const unsigned int n) {
        return batch.each([&](const unsigned int e) {
          return values.data() + at + (std::size_t(e) * Beam::order + g) * n;
        });
      };
      return {first(first_internal, n_internal), first(first_kept, n_kept)};
    }

    /** As history(), to be written. */
    SectionHistoryOutput
    history_output(double *values, const ElementBatch &batch, const int g) const
    {
      const auto first = [&](const std::size_t at, const unsigned int n) {
        return batch.each([&](const unsigned int e) {
          return values + at + (std::size_t(e) * Beam::order + g) * n;
        });
      };
      return {first(first_internal, n_internal), first(first_kept, n_kept)};
    }

    /** The strains of a batch without which its sections would be free of
     * forces at an instant. */
    std::array<Lanes, Beam::n_strains>
    initial_strains_at(const State &state, const ElementBatch &batch) const
    {
      std::array<Lanes, Beam::n_strains> strains;
      strains.fill(0);
      if (initial.exist())
        initial.add(1, initial.at(state), batch, strains.data());
      return strains;
    }

    /** The sections of a batch at a Gauss point, the input of the law. */
    struct PointsOf
    {
      template <class AtRest>
      PointsOf(const LawSections &sections, const AtRest &at_rest)
        : stiffness(Beam::stiffness_by_strain(at_rest))
        , types(sections.types)
      {
        using std::sqrt;
        for (unsigned int k = 0; k < n_strains; ++k)
          radii[k] = sqrt(Lanes(stiffness[k] / stiffness[0]));
      }

      SectionPoint point() const
      {
        return {n_strains, types.data(), stiffness.data(), radii.data()};
      }

      std::array<Lanes, Beam::n_strains>             stiffness, radii;
      const std::array<StrainType, Beam::n_strains> &types;
    };

    /** Loads of initial strains at both ends of an evaluation. */
    struct InitialLoads
    {
      InitialStrainLoads start, end;
    };

    /** The law at the Gauss points of a batch in an evaluation. */
    class PointLaw
    {
    public:
      template <class AtRest>
      PointLaw(const LawSections   &sections,
               const SectionUpdate &update,
               const Evaluation    &evaluation,
               const SectionPurpose purpose,
               const ElementBatch  &batch,
               const AtRest        &at_rest,
               const InitialLoads  &initial)
        : sections(sections)
        , update(update)
        , evaluation(evaluation)
        , purpose(purpose)
        , batch(batch)
        , points(sections, at_rest)
        , initial(initial)
      {
        if (!sections.may_fail())
          return;
        const std::vector<double> &history = evaluation.from.history;
        intact_at_end = sections.intactness(history, batch, evaluation.dt);
        intact        = intact_at_end;
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          intact = (intact + sections.intactness(history, batch, 0)) / 2;
      }

      /** Factor of the forces. */
      const Lanes &intactness() const
      {
        return intact;
      }

      /** Response at Gauss point @p g to @p strains at the end of the step; the
       * linear kernel computes forces of mean strains. */
      SectionResponse respond(const int g,
                              const Lanes (&strains)[Beam::n_strains]) const
      {
        const SectionHistory committed =
          sections.history(evaluation.from.history, batch, g);
        const SectionPoint point = points.point();
        Lanes              ends[Beam::n_strains];
        std::copy_n(strains, n_strains, ends);
        if (Beam::is_linear && purpose == SectionPurpose::forces &&
            evaluation.kind == Evaluation::Kind::discrete_gradient)
          {
            Lanes starts[Beam::n_strains];
            update.start_strains(point, committed, starts);
            for (unsigned int k = 0; k < n_strains; ++k)
              ends[k] = 2 * strains[k] - starts[k];
            if (sections.initial.exist())
              {
                sections.initial.add(-1, initial.start, batch, ends);
                sections.initial.add(-1, initial.end, batch, ends);
              }
          }
        else if (sections.initial.exist())
          sections.initial.add(-1, initial.end, batch, ends);
        SectionResponse response;
        if (!writes_history())
          update.evaluate(point, ends, committed, nullptr, response);
        else
          {
            const SectionHistoryOutput end =
              sections.history_output(evaluation.to.history.data(), batch, g);
            update.evaluate(point, ends, committed, &end, response);
          }
        if (sections.may_fail())
          weaken(response);
        return response;
      }

    private:
      bool writes_history() const
      {
        return purpose == SectionPurpose::history ||
          (purpose == SectionPurpose::forces &&
           !sections.finds_history_after_step());
      }

      /** Takes away what broken struts have lost. */
      void weaken(SectionResponse &response) const
      {
        response.stored *= intact_at_end;
        for (unsigned int k = 0; k < n_strains; ++k)
          {
            response.forces[k] *= intact;
            response.tangent[k] *= intact;
            if (response.is_coupled)
              for (unsigned int l = 0; l < n_strains; ++l)
                response.coupling[k][l] *= intact;
          }
      }

      const LawSections   &sections;
      const SectionUpdate &update;
      const Evaluation    &evaluation;
      const SectionPurpose purpose;
      const ElementBatch  &batch;
      const PointsOf       points;
      const InitialLoads  &initial;
      /** Factors of forces and of the energy at the end. */
      Lanes intact = 1, intact_at_end = 1;
    };

    /** As ElasticSections::in(). */
    auto in(const Evaluation &evaluation, const SectionPurpose purpose) const
    {
      const std::shared_ptr<const SectionUpdate> update =
        section_law->update(step(evaluation));
      const auto loads = initial_loads(evaluation);
      return
        [this, &evaluation, purpose, update, loads](const ElementBatch &batch,
                                                    const auto &at_rest) {
          auto section = Beam::law_section(at_rest,
                                           PointLaw(*this,
                                                    *update,
                                                    evaluation,
                                                    purpose,
                                                    batch,
                                                    at_rest,
                                                    *loads));
          if (may_fail())
            section.stiffness =
              Beam::scaled_stiffness(at_rest, [&](const unsigned int) {
                return section.law.intactness();
              });
          return section;
        };
    }

    /** The loads in @p evaluation; the start counts in steps of mean forces. */
    std::shared_ptr<const InitialLoads>
    initial_loads(const Evaluation &evaluation) const
    {
      const bool has_start =
        evaluation.kind == Evaluation::Kind::discrete_gradient;
      return std::make_shared<const InitialLoads>(
        InitialLoads{has_start ? initial.at_start(evaluation)
                               : InitialStrainLoads(),
                     initial.at_end(evaluation)});
    }

    /** Energy lost in an accepted step by a batch (J). */
    template <class AtRest>
    Lanes lost(const SectionLosses &losses,
               const Evaluation    &evaluation,
               const ElementBatch  &batch,
               const AtRest        &at_rest) const
    {
      const PointsOf points(*this, at_rest);
      Lanes          sum = 0;
      for (int g = 0; g < Beam::order; ++g)
        sum += beams.shape.weight[g] * at_rest.jacobian *
          losses.lost(points.point(),
                      history(evaluation.from.history, batch, g),
                      history(evaluation.to.history, batch, g));
      if (may_fail())
        sum *= (intactness(evaluation.from.history, batch, 0) +
                intactness(evaluation.from.history, batch, evaluation.dt)) /
          2;
      return sum;
    }

    static SectionStep step(const Evaluation &evaluation)
    {
      using Kind = Evaluation::Kind;
      switch (evaluation.kind)
        {
          case Kind::equilibrium:
            return {evaluation.starts_run ? SectionStep::Kind::start
                                          : SectionStep::Kind::relaxed,
                    0};
          case Kind::stage:
            return {SectionStep::Kind::stage, evaluation.dt};
          case Kind::discrete_gradient:
            return {SectionStep::Kind::mean, evaluation.dt};
          default:
            return {SectionStep::Kind::end, evaluation.dt};
        }
    }

  private:
    static constexpr unsigned int n_strains = Beam::n_strains;

    static std::vector<unsigned int>
    struts_of(const BeamElements<typename Beam::Undamped> &beams)
    {
      std::vector<unsigned int> struts;
      for (unsigned int e = 0; e < beams.size(); ++e)
        struts.push_back(beams.interval(e).strut);
      return struts;
    }

    /** Part of its stiffness that a broken element keeps. Without inertia its
     * nodes would have no place; with inertia that part only makes sure that
     * energies can be compared with those of an intact element. */
    double remaining_part(const unsigned int e) const
    {
      return moves_by_inertia(e) ? 1e-12 : input_precision;
    }

    const BeamElements<typename Beam::Undamped> &beams;
    const std::shared_ptr<const SectionLaw>      section_law;
    const std::optional<double>                  time_of_failure; ///< s
    const GroupInitialStrains                    initial;
    const bool                                   has_inertia;
    std::array<StrainType, Beam::n_strains>      types;
    unsigned int                                 n_internal, n_kept;
    std::size_t first_internal = 0, first_kept = 0, first_lost_part = 0;
  };
} // namespace auxfem

#endif
