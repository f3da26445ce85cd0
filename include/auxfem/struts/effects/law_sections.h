#ifndef auxfem_struts_effects_law_sections_h
#define auxfem_struts_effects_law_sections_h

#include <auxfem/struts/beam_2d.h>
#include <auxfem/struts/beam_3d_strains.h>
#include <auxfem/struts/effects/beam_elements.h>
#include <auxfem/struts/section_law.h>

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
  namespace Beam2D
  {
    /** Section whose response comes from @p PointLaw, see PointLaw below. */
    template <class PointLaw>
    struct LawSection
    {
      const StiffnessOf<Lanes> &stiffness;
      const PointLaw            law;

      ResponseOf<Lanes> response(const int g, const StrainsOf<Lanes> &e) const
      {
        const SectionResponse r = respond(g, e);
        return {forces(r), r.stored};
      }

      using Linearized = LinearizedOf<Lanes, CoupledStiffnessOf<Lanes>>;

      Linearized linearized(const int g, const StrainsOf<Lanes> &e) const
      {
        const SectionResponse r = respond(g, e);
        Linearized            result;
        result.forces = forces(r);
        static_cast<StiffnessOf<Lanes> &>(
          result.stiffness) = {r.tangent[0], r.tangent[1], r.tangent[2], 0};
        result.stiffness.is_coupled = law.couples_strains();
        if (result.stiffness.is_coupled)
          {
            result.stiffness.axial_shear   = r.coupling[0][1];
            result.stiffness.axial_bending = r.coupling[0][2];
            result.stiffness.shear_bending = r.coupling[1][2];
          }
        return result;
      }

      ResponseOf<Lanes> mean(const int               g,
                             const StrainsOf<Lanes> &start,
                             const StrainsOf<Lanes> &increment) const
      {
        return response(g, end(start, increment));
      }

      Linearized mean_linearized(const int               g,
                                 const StrainsOf<Lanes> &start,
                                 const StrainsOf<Lanes> &increment) const
      {
        return linearized(g, end(start, increment));
      }

    private:
      static StrainsOf<Lanes> end(const StrainsOf<Lanes> &start,
                                  const StrainsOf<Lanes> &increment)
      {
        return {start.epsilon + increment.epsilon,
                start.gamma + increment.gamma,
                start.kappa + increment.kappa};
      }

      SectionResponse respond(const int g, const StrainsOf<Lanes> &e) const
      {
        const Lanes strains[] = {e.epsilon, e.gamma, e.kappa};
        return law.respond(g, strains);
      }

      static ForcesOf<Lanes> forces(const SectionResponse &r)
      {
        return {r.forces[0], r.forces[1], r.forces[2]};
      }
    };
  } // namespace Beam2D

  namespace Beam3D
  {
    /** @copydoc Beam2D::LawSection */
    template <class PointLaw>
    struct LawSection
    {
      const StiffnessOf<Lanes> &stiffness;
      const PointLaw            law;

      ResponseOf<Lanes> response(const int               g,
                                 const StrainsOf<Lanes> &strains) const
      {
        const SectionResponse r = respond(g, strains);
        return {forces(r), r.stored};
      }

      using Linearized = LinearizedOf<Lanes, CoupledStiffnessOf<Lanes>>;

      Linearized linearized(const int g, const StrainsOf<Lanes> &strains) const
      {
        const SectionResponse r = respond(g, strains);
        const Lanes          *t = r.tangent;
        Linearized            result;
        result.forces = forces(r);
        static_cast<StiffnessOf<Lanes> &>(
          result.stiffness)         = {t[0], t[1], t[2], t[3], t[4], t[5]};
        result.stiffness.is_coupled = law.couples_strains();
        if (result.stiffness.is_coupled)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              {
                const auto entry = [&](const unsigned int k,
                                       const unsigned int l) {
                  return k == l ? t[k] : r.coupling[k][l];
                };
                result.stiffness.by_gamma[i][j]       = entry(i, j);
                result.stiffness.gamma_by_kappa[i][j] = entry(i, 3 + j);
                result.stiffness.by_kappa[i][j]       = entry(3 + i, 3 + j);
              }
        return result;
      }

      ResponseOf<Lanes> mean(const int g,
                             const StrainsOf<Lanes> & /*start*/,
                             const StrainsOf<Lanes> &end,
                             const StrainsOf<Lanes> &added) const
      {
        ResponseOf<Lanes> r = response(g, end);
        add(added, r.forces);
        return r;
      }

      Linearized mean_linearized(const int g,
                                 const StrainsOf<Lanes> & /*start*/,
                                 const StrainsOf<Lanes> &end,
                                 const StrainsOf<Lanes> &added) const
      {
        Linearized r = linearized(g, end);
        add(added, r.forces);
        return r;
      }

      ForcesOf<Lanes> elastic_forces(const StrainsOf<Lanes> &strains) const
      {
        return ElasticSection<Lanes>{stiffness}.elastic_forces(strains);
      }

    private:
      void add(const StrainsOf<Lanes> &added, ForcesOf<Lanes> &forces) const
      {
        const ForcesOf<Lanes> elastic = elastic_forces(added);
        forces.force += elastic.force;
        forces.moment += elastic.moment;
      }

      SectionResponse respond(const int g, const StrainsOf<Lanes> &e) const
      {
        const Lanes strains[] = {e.gamma[0],
                                 e.gamma[1],
                                 e.gamma[2],
                                 e.kappa[0],
                                 e.kappa[1],
                                 e.kappa[2]};
        return law.respond(g, strains);
      }

      static ForcesOf<Lanes> forces(const SectionResponse &r)
      {
        const Lanes *f = r.forces;
        return {VectorOf<Lanes>({f[0], f[1], f[2]}),
                VectorOf<Lanes>({f[3], f[4], f[5]})};
      }
    };
  } // namespace Beam3D

  /** What an evaluation of sections is for. */
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
    {
      for (std::size_t k = 0; k < types.size(); ++k)
        types[k] = Beam::strain_type(k, beams.shear > 0);
      const SectionPoint point = {n_strains, types.data(), nullptr};
      n_internal               = section_law->n_internal(point);
      n_kept                   = section_law->n_kept(point);
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

    /** The sections of a batch at a Gauss point, the input of the law. */
    struct PointsOf
    {
      template <class AtRest>
      PointsOf(const LawSections &sections, const AtRest &at_rest)
        : stiffness(Beam::stiffness_by_strain(at_rest))
        , types(sections.types)
      {}

      SectionPoint point() const
      {
        return {n_strains, types.data(), stiffness.data()};
      }

      std::array<Lanes, Beam::n_strains>             stiffness;
      const std::array<StrainType, Beam::n_strains> &types;
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
               const AtRest        &at_rest)
        : sections(sections)
        , update(update)
        , evaluation(evaluation)
        , purpose(purpose)
        , batch(batch)
        , points(sections, at_rest)
      {}

      bool couples_strains() const
      {
        return sections.law().couples_strains();
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
          }
        SectionResponse response;
        if (!writes_history())
          update.evaluate(point, ends, committed, nullptr, response);
        else
          {
            const SectionHistoryOutput end =
              sections.history_output(evaluation.to.history.data(), batch, g);
            update.evaluate(point, ends, committed, &end, response);
          }
        return response;
      }

    private:
      bool writes_history() const
      {
        return purpose == SectionPurpose::history ||
          (purpose == SectionPurpose::forces &&
           !sections.finds_history_after_step());
      }

      const LawSections   &sections;
      const SectionUpdate &update;
      const Evaluation    &evaluation;
      const SectionPurpose purpose;
      const ElementBatch  &batch;
      const PointsOf       points;
    };

    /** As ElasticSections::in(). */
    auto in(const Evaluation &evaluation, const SectionPurpose purpose) const
    {
      const std::shared_ptr<const SectionUpdate> update =
        section_law->update(step(evaluation));
      return [this, &evaluation, purpose, update](const ElementBatch &batch,
                                                  const auto         &at_rest) {
        return Beam::law_section(
          at_rest,
          PointLaw(*this, *update, evaluation, purpose, batch, at_rest));
      };
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

    const BeamElements<typename Beam::Undamped> &beams;
    const std::shared_ptr<const SectionLaw>      section_law;
    std::array<StrainType, Beam::n_strains>      types;
    unsigned int                                 n_internal, n_kept;
    std::size_t first_internal = 0, first_kept = 0;
  };
} // namespace auxfem

#endif
