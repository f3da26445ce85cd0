#include <auxfem/struts/fibre_sections.h>

namespace auxfem
{
  namespace
  {
    class ElasticPlasticUpdate : public SectionUpdate
    {
    public:
      ElasticPlasticUpdate(const FibreSections &sections,
                           const SectionStep   &step)
        : sections(sections)
        , curve(sections.curve)
        , step(step)
      {}

      AUXFEM_FLATTEN void evaluate(const SectionPoint         &point,
                                   const Lanes                *strains,
                                   const SectionHistory       &committed,
                                   const SectionHistoryOutput *end,
                                   SectionResponse &response) const override
      {
        const FibrePoint fibres(point, sections.of(point));
        Lanes            start[max_section_strains];
        start_strains(point, committed, start);
        const NormalStrains before = fibres.normal(start),
                            now    = fibres.normal(strains);
        const Lanes reach          = fibres.reach(before, now),
                    slack =
                      curve.initial() - committed.kept(fibres.layout.used());
        if (is_frozen() || !any_of(reach > slack))
          stay_elastic(fibres, strains, committed, reach, end, response);
        else
          flow(fibres, strains, before, now, committed, end, response);
        if (end != nullptr)
          for (unsigned int k = 0; k < point.n_strains; ++k)
            end->set_kept(fibres.layout.strain(k), strains[k]);
        if (step.kind == SectionStep::Kind::mean)
          for (unsigned int k = 0; k < point.n_strains; ++k)
            response.forces[k] =
              (response.forces[k] +
               point.stiffness[k] *
                 (start[k] - committed.kept(fibres.layout.plastic(k)))) /
              2;
      }

      void start_strains(const SectionPoint   &point,
                         const SectionHistory &committed,
                         Lanes                *strains) const override
      {
        for (unsigned int k = 0; k < point.n_strains; ++k)
          strains[k] = committed.kept(k);
      }

    private:
      /** Whether no time passes in which a material that depends on the rate
       * could flow. */
      bool is_frozen() const
      {
        return curve.depends_on_rate() && step.dt == 0 &&
          step.kind == SectionStep::Kind::end;
      }

      /** A step in which no fibre yields, known without their history. */
      void stay_elastic(const FibrePoint           &fibres,
                        const Lanes                *strains,
                        const SectionHistory       &committed,
                        const Lanes                &reach,
                        const SectionHistoryOutput *end,
                        SectionResponse            &response) const
      {
        const FibreHistory &layout = fibres.layout;
        Lanes               plastic[max_section_strains];
        for (unsigned int k = 0; k < layout.n_strains; ++k)
          {
            plastic[k]          = committed.kept(layout.plastic(k));
            response.tangent[k] = fibres.point.stiffness[k];
            for (unsigned int l = 0; l < layout.n_strains; ++l)
              response.coupling[k][l] = 0;
          }
        fibres.set_forces(strains,
                          plastic,
                          committed.kept(layout.stored()),
                          response);
        if (end == nullptr)
          return;
        for (unsigned int i = layout.n_strains; i < layout.size(); ++i)
          end->set_kept(i, committed.kept(i));
        end->set_kept(layout.used(), committed.kept(layout.used()) + reach);
      }

      /** A step in which fibres may yield: return mapping in each. */
      void flow(const FibrePoint           &fibres,
                const Lanes                *strains,
                const NormalStrains        &before,
                const NormalStrains        &now,
                const SectionHistory       &committed,
                const SectionHistoryOutput *end,
                SectionResponse            &response) const
      {
        using std::abs, std::max, std::copysign;
        const FibreSection &section                   = fibres.section;
        const FibreHistory &layout                    = fibres.layout;
        const double        back                      = 1 + curve.kinematic();
        Lanes               force[max_normal_strains] = {},
              tangent[max_normal_strains][max_normal_strains] = {}, stored = 0,
              lost = 0, used = 0;
        for (unsigned int i = 0; i < section.n_fibres(); ++i)
          {
            const Lanes plastic = committed.kept(layout.fibre_plastic(i)),
                        accumulated =
                          committed.kept(layout.fibre_accumulated(i)),
                        strain = fibres.fibre_strain(i, now),
                        trial  = strain - back * plastic;
            const YieldCurve::Flow flow =
              curve.flow(abs(trial), accumulated, step.dt);
            const Lanes increment            = copysign(flow.increment, trial),
                        yielded              = plastic + increment,
                        stress               = strain - yielded;
            Lanes slope                      = 1;
            where(flow.increment > 0, slope) = flow.slope / (1 + flow.slope);
            const double weight              = section.weights[i];
            const auto  &arm                 = section.arms[i];
            for (unsigned int m = 0; m < section.n_normal(); ++m)
              {
                force[m] += weight * arm[m] * stress;
                for (unsigned int l = 0; l <= m; ++l)
                  tangent[m][l] += weight * arm[m] * arm[l] * slope;
              }
            stored += weight * back / 2 * yielded * yielded;
            if (end == nullptr)
              continue;
            // The mean stress of both ends does the work; kinematic hardening
            // stores a part of it.
            lost += weight * increment *
              (fibres.fibre_strain(i, before) + strain -
               back * (plastic + yielded)) /
              2;
            const Lanes hardened = accumulated + flow.increment;
            used                 = max(used,
                       Lanes(curve.initial() - curve.stress(hardened) +
                             abs(strain - back * yielded)));
            end->set_kept(layout.fibre_plastic(i), yielded);
            end->set_kept(layout.fibre_accumulated(i), hardened);
          }
        Lanes plastic[max_section_strains];
        set_response(fibres, strains, force, tangent, plastic, response);
        fibres.set_forces(strains, plastic, stored, response);
        if (end == nullptr)
          return;
        for (unsigned int k = 0; k < layout.n_strains; ++k)
          end->set_kept(layout.plastic(k), plastic[k]);
        end->set_kept(layout.used(), used);
        end->set_kept(layout.stored(), stored);
        end->set_kept(layout.lost(), committed.kept(layout.lost()) + lost);
      }

      /** Sets the tangents of @p response and the @p plastic strains of the
       * section from sums over the fibres. */
      static void set_response(
        const FibrePoint &fibres,
        const Lanes      *strains,
        const Lanes (&force)[max_normal_strains],
        const Lanes (&tangent)[max_normal_strains][max_normal_strains],
        Lanes           *plastic,
        SectionResponse &response)
      {
        const unsigned int n_strains = fibres.layout.n_strains;
        const Lanes       *stiffness = fibres.point.stiffness;
        for (unsigned int k = 0; k < n_strains; ++k)
          {
            plastic[k]          = 0;
            response.tangent[k] = stiffness[k];
            for (unsigned int l = 0; l < n_strains; ++l)
              response.coupling[k][l] = 0;
          }
        const auto &normal = fibres.section.normal_strains;
        for (unsigned int m = 0; m < normal.size(); ++m)
          {
            const unsigned int k = normal[m];
            plastic[k]           = strains[k] - force[m] / fibres.radii[m];
            response.tangent[k]  = stiffness[k] * tangent[m][m];
            for (unsigned int l = 0; l < m; ++l)
              response.coupling[k][normal[l]] =
                response.coupling[normal[l]][k] = fibres.axial() *
                fibres.radii[m] * fibres.radii[l] * tangent[m][l];
          }
      }

      const FibreSections &sections;
      const YieldCurve    &curve;
      const SectionStep    step;
    };

    class ElasticPlasticLosses : public SectionLosses
    {
    public:
      explicit ElasticPlasticLosses(const FibreSections &sections)
        : sections(sections)
      {}

      Lanes lost(const SectionPoint   &point,
                 const SectionHistory &committed,
                 const SectionHistory &accepted) const override
      {
        const FibrePoint   fibres(point, sections.of(point));
        const unsigned int lost = fibres.layout.lost();
        return fibres.axial() * (accepted.kept(lost) - committed.kept(lost));
      }

    private:
      const FibreSections &sections;
    };
  } // namespace

  std::unique_ptr<SectionUpdate>
  make_elastic_plastic_update(const FibreSections &sections,
                              const SectionStep   &step)
  {
    return std::make_unique<ElasticPlasticUpdate>(sections, step);
  }

  std::unique_ptr<SectionLosses>
  make_elastic_plastic_losses(const FibreSections &sections)
  {
    return std::make_unique<ElasticPlasticLosses>(sections);
  }
} // namespace auxfem
