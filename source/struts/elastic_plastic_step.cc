#include <auxfem/struts/fibre_sections.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Sums over the fibres of a section, by its felt strains; stresses are
     * over Young's modulus. */
    struct FibreSums
    {
      Lanes force[max_section_strains]                        = {};
      Lanes tangent[max_section_strains][max_section_strains] = {};
      Lanes stored = 0; ///< energy at zero strain
      Lanes lost   = 0; ///< energy
      Lanes used   = 0; ///< largest used part of the yield strain
    };

    /** A fibre with @p n strains at the end of a step. */
    template <unsigned int n>
    struct FibreEnd
    {
      Lanes plastic[n], stress[n];
      Lanes accumulated;
      Lanes tangent[n][n]; ///< derivatives of stresses by strains
    };

    /** Fibre in uniaxial stress: return mapping (Simo & Hughes, 1998,
     * Computational Inelasticity, ch. 1). */
    inline FibreEnd<1> return_to_yield(const YieldCurve &curve,
                                       const FibreSection & /*section*/,
                                       const Lanes (&strain)[1],
                                       const Lanes (&plastic)[1],
                                       const Lanes &accumulated,
                                       const double dt)
    {
      using std::abs, std::copysign;
      const double           back  = 1 + curve.kinematic();
      const Lanes            trial = strain[0] - back * plastic[0];
      const YieldCurve::Flow flow  = curve.flow(abs(trial), accumulated, dt);
      FibreEnd<1>            end;
      end.plastic[0]    = plastic[0] + copysign(flow.increment, trial);
      end.stress[0]     = strain[0] - end.plastic[0];
      end.accumulated   = accumulated + flow.increment;
      end.tangent[0][0] = 1;
      where(flow.increment > 0, end.tangent[0][0]) =
        flow.slope / (1 + flow.slope);
      return end;
    }

    /**
     * Fibre in tension and shear: return mapping for the equivalent stress
     * sqrt(sum e_c stress_c^2), e = 1, 3, 3. With the elastic moduli C, the
     * kinematic ones H = h / e, the direction N = e stress / equivalent stress
     * and D = 1 + m e (C + H) for the multiplier m, the tangent is
     *
     *     C H / (C + H) + C^2 / ((C + H) D) - theta y y^T,   y = C N / D,
     *     theta = (1 - m k') / (k' (1 - m q) + q),   q = N (C + H) N / D,
     *
     * with the slope k' of the yield stress.
     */
    template <unsigned int n>
    FibreEnd<n> return_to_yield(const YieldCurve   &curve,
                                const FibreSection &section,
                                const Lanes (&strain)[n],
                                const Lanes (&plastic)[n],
                                const Lanes &accumulated,
                                const double dt)
    {
      using std::abs, std::sqrt;
      double elastic[n], kinematic[n];
      Lanes  trial[n], shear_square = 0;
      for (unsigned int c = 0; c < n; ++c)
        {
          elastic[c]   = section.moduli[c];
          kinematic[c] = curve.kinematic() / section.equivalents[c];
          trial[c] =
            elastic[c] * strain[c] - (elastic[c] + kinematic[c]) * plastic[c];
          if (c > 0)
            shear_square += section.equivalents[c] * trial[c] * trial[c];
        }
      const YieldCurve::ShearFlow flow =
        curve.shear_flow(abs(trial[0]),
                         sqrt(shear_square),
                         accumulated,
                         section.equivalents[1] * elastic[1],
                         dt);
      const Lanes &m = flow.multiplier;
      FibreEnd<n>  end;
      Lanes        resistance[n], direction[n], square = 0;
      for (unsigned int c = 0; c < n; ++c)
        {
          const double e     = section.equivalents[c];
          resistance[c]      = 1 + m * e * (elastic[c] + kinematic[c]);
          const Lanes stress = trial[c] / resistance[c];
          direction[c]       = e * stress;
          square += e * stress * stress;
          end.plastic[c] = plastic[c] + m * direction[c];
          end.stress[c]  = elastic[c] * (strain[c] - end.plastic[c]);
        }
      end.accumulated = accumulated + flow.increment;

      const Lanes size = sqrt(square + std::numeric_limits<double>::min());
      Lanes       y[n], q = 0;
      for (unsigned int c = 0; c < n; ++c)
        {
          direction[c] /= size;
          y[c] = elastic[c] * direction[c] / resistance[c];
          q += direction[c] * direction[c] * (elastic[c] + kinematic[c]) /
            resistance[c];
        }
      Lanes theta = 0;
      where(flow.increment > 0, theta) =
        (1 - m * flow.slope) / (flow.slope * (1 - m * q) + q);
      for (unsigned int c = 0; c < n; ++c)
        for (unsigned int d = 0; d < n; ++d)
          {
            end.tangent[c][d] = -theta * y[c] * y[d];
            if (c == d)
              end.tangent[c][d] += elastic[c] / (elastic[c] + kinematic[c]) *
                (kinematic[c] + elastic[c] / resistance[c]);
          }
      return end;
    }

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
        const FeltStrains before = fibres.felt(start),
                          now    = fibres.felt(strains);
        const Lanes reach        = fibres.reach(before, now),
                    slack =
                      curve.initial() - committed.kept(fibres.layout.used());
        if (is_frozen() || !any_of(reach > slack))
          stay_elastic(fibres, strains, committed, reach, end, response);
        else
          switch (fibres.section.n_components)
            {
              case 1:
                flow<1>(fibres, strains, before, now, committed, end, response);
                break;
              case 2:
                flow<2>(fibres, strains, before, now, committed, end, response);
                break;
              default:
                flow<3>(fibres, strains, before, now, committed, end, response);
            }
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
          plastic[k] = committed.kept(layout.plastic(k));
        std::copy_n(fibres.point.stiffness, layout.n_strains, response.tangent);
        fibres.set_forces(strains,
                          plastic,
                          committed.kept(layout.stored()),
                          response);
        if (end == nullptr)
          return;
        end->copy_kept(committed, layout.n_strains, layout.size());
        end->set_kept(layout.used(), committed.kept(layout.used()) + reach);
      }

      /** A step in which fibres of @p n strains may yield. */
      template <unsigned int n>
      void flow(const FibrePoint           &fibres,
                const Lanes                *strains,
                const FeltStrains          &before,
                const FeltStrains          &now,
                const SectionHistory       &committed,
                const SectionHistoryOutput *end,
                SectionResponse            &response) const
      {
        const FibreHistory &layout = fibres.layout;
        FibreSums           sums;
        for (unsigned int i = 0; i < layout.n_fibres; ++i)
          {
            Lanes plastic[n], strain[n];
            for (unsigned int c = 0; c < n; ++c)
              {
                plastic[c] = committed.kept(layout.fibre_plastic(i, c));
                strain[c]  = fibres.fibre_strain(i, c, now);
              }
            const FibreEnd<n> fibre =
              return_to_yield(curve,
                              fibres.section,
                              strain,
                              plastic,
                              committed.kept(layout.accumulated(i)),
                              step.dt);
            add_forces(fibres.section, i, fibre, sums);
            if (end != nullptr)
              accept(fibres, i, before, plastic, fibre, *end, sums);
          }
        Lanes plastic[max_section_strains];
        set_response(fibres, strains, sums, plastic, response);
        if (end == nullptr)
          return;
        for (unsigned int k = 0; k < layout.n_strains; ++k)
          end->set_kept(layout.plastic(k), plastic[k]);
        end->set_kept(layout.used(), sums.used);
        end->set_kept(layout.stored(), sums.stored);
        end->set_kept(layout.lost(), committed.kept(layout.lost()) + sums.lost);
      }

      /** Adds the forces and tangents of fibre @p i. */
      template <unsigned int n>
      void add_forces(const FibreSection &section,
                      const unsigned int  i,
                      const FibreEnd<n>  &fibre,
                      FibreSums          &sums) const
      {
        const double weight = section.weights[i];
        for (unsigned int m = 0; m < section.n_felt(); ++m)
          {
            Lanes by_strain[n] = {};
            for (unsigned int c = 0; c < n; ++c)
              {
                const double strain = weight * section.strains[i][c][m];
                sums.force[m] += strain * fibre.stress[c];
                for (unsigned int d = 0; d < n; ++d)
                  by_strain[d] += strain * fibre.tangent[c][d];
              }
            for (unsigned int l = 0; l <= m; ++l)
              for (unsigned int d = 0; d < n; ++d)
                sums.tangent[m][l] += by_strain[d] * section.strains[i][d][l];
          }
        for (unsigned int c = 0; c < n; ++c)
          sums.stored += weight / 2 *
            (section.moduli[c] + curve.kinematic() / section.equivalents[c]) *
            fibre.plastic[c] * fibre.plastic[c];
      }

      /** Writes the history of fibre @p i and adds its loss: the mean stress of
       * both ends does the work, of which kinematic hardening stores a part. */
      template <unsigned int n>
      void accept(const FibrePoint  &fibres,
                  const unsigned int i,
                  const FeltStrains &before,
                  const Lanes (&plastic)[n],
                  const FibreEnd<n>          &fibre,
                  const SectionHistoryOutput &end,
                  FibreSums                  &sums) const
      {
        using std::max, std::sqrt;
        const FibreSection &section = fibres.section;
        Lanes               square  = 0;
        for (unsigned int c = 0; c < n; ++c)
          {
            const double modulus = section.moduli[c],
                         e       = section.equivalents[c],
                         back    = curve.kinematic() / e;
            const Lanes at_start = modulus *
                (fibres.fibre_strain(i, c, before) - plastic[c]) -
              back * plastic[c],
                        at_end = fibre.stress[c] - back * fibre.plastic[c];
            sums.lost += section.weights[i] / 2 *
              (fibre.plastic[c] - plastic[c]) * (at_start + at_end);
            square += e * at_end * at_end;
            end.set_kept(fibres.layout.fibre_plastic(i, c), fibre.plastic[c]);
          }
        sums.used = max(sums.used,
                        Lanes(curve.initial() -
                              curve.stress(fibre.accumulated) + sqrt(square)));
        end.set_kept(fibres.layout.accumulated(i), fibre.accumulated);
      }

      /** Sets @p response and the @p plastic strains of the section from sums
       * over the fibres. */
      static void set_response(const FibrePoint &fibres,
                               const Lanes      *strains,
                               const FibreSums  &sums,
                               Lanes            *plastic,
                               SectionResponse  &response)
      {
        response.is_coupled = true;
        for (unsigned int k = 0; k < fibres.layout.n_strains; ++k)
          {
            plastic[k]          = 0;
            response.tangent[k] = fibres.point.stiffness[k];
            std::fill_n(response.coupling[k], fibres.layout.n_strains, 0);
          }
        const auto &felt = fibres.section.felt;
        for (unsigned int m = 0; m < felt.size(); ++m)
          {
            const unsigned int k = felt[m].strain;
            plastic[k] =
              strains[k] - sums.force[m] / (felt[m].modulus * fibres.radii[m]);
            response.tangent[k] =
              fibres.point.stiffness[k] * sums.tangent[m][m] / felt[m].modulus;
            for (unsigned int l = 0; l < m; ++l)
              response.coupling[k][felt[l].strain] =
                response.coupling[felt[l].strain][k] = fibres.axial() *
                fibres.radii[m] * fibres.radii[l] * sums.tangent[m][l];
          }
        fibres.set_forces(strains, plastic, sums.stored, response);
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
