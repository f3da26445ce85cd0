#include <auxfem/struts/viscoelastic_step.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Term   = PronySeries::Term;
    using Series = PronySeries;

    /**
     * Coefficients of a term in a step. The strain of its spring changes from e
     * to decay e + by_increment dE + by_lead (v dt - dE) and has the mean
     * mean_decay e + mean_by_increment dE, with the strain increment dE and the
     * strain rate v at the end.
     */
    struct TermStep
    {
      double ratio; ///< stiffness over the instantaneous modulus
      double decay, by_increment, by_lead;
      double mean_decay = 0, mean_by_increment = 0;
    };

    TermStep term_step(const Term &term, const SectionStep &step)
    {
      const MaxwellElement element = term.element();
      switch (step.kind)
        {
          case SectionStep::Kind::relaxed:
            return {term.ratio, 0, 0, 0};
          case SectionStep::Kind::stage:
            {
              // The viscous strain a obeys a' = (E - a) / tau: the spring takes
              // up the increment and decays with it.
              const double decay = element.stage(step.dt).decay;
              return {term.ratio, decay, decay, 0};
            }
          case SectionStep::Kind::mean:
            {
              const MaxwellElement::Mean mean = element.mean(step.dt);
              return {term.ratio,
                      element.at_constant_rate(1, 0, step.dt),
                      element.at_constant_rate(0, 1, step.dt),
                      0,
                      mean.decay,
                      mean.stiffness};
            }
          default:
            {
              const MaxwellElement::Step end = element.step(step.dt);
              const double lead = step.dt > 0 ? end.damping / step.dt : 0;
              return {term.ratio, end.decay, end.stiffness + lead, lead};
            }
        }
    }

    /** Coefficients of a series in a step. */
    struct SeriesStep
    {
      double                long_time;
      std::vector<TermStep> terms;
      /** Derivative of the force by the strain at the end, over the
       * instantaneous modulus; doubled for mean forces. */
      double tangent;
    };

    /**
     * The strain rate at the end of a step exceeds its mean by half of what the
     * mean has grown by since the last step, as in the backward difference of
     * second order. Where the step length changes, this is of first order,
     * once.
     */
    constexpr double lead_of_rate = 0.5;

    /** Strain by which the rate at the end of a step exceeds the mean rate
     * times
     * @p dt (s), with the strain @p increment and the mean @p rate (1/s) of the
     * last step. */
    Lanes lead_of(const Lanes &increment, const Lanes &rate, const double dt)
    {
      return lead_of_rate * (increment - dt * rate);
    }

    SeriesStep series_step(const Series &series, const SectionStep &step)
    {
      SeriesStep result{series.long_time, {}, series.long_time};
      for (const Term &term : series.terms)
        {
          const TermStep t = term_step(term, step);
          result.terms.push_back(t);
          result.tangent += term.ratio *
            (step.kind == SectionStep::Kind::mean
               ? 2 * t.mean_by_increment
               : t.by_increment + lead_of_rate * t.by_lead);
        }
      return result;
    }

    class ViscoelasticUpdate : public SectionUpdate
    {
    public:
      ViscoelasticUpdate(const ModulusSeries &series, const SectionStep &step)
        : series(series)
        , step(step)
        , series_in_step{series_step(series.normal, step),
                         series_step(series.shear, step)}
      {}

      AUXFEM_FLATTEN void evaluate(const SectionPoint         &point,
                                   const Lanes                *strains,
                                   const SectionHistory       &committed,
                                   const SectionHistoryOutput *end,
                                   SectionResponse &response) const override
      {
        const ViscoelasticHistory layout(point, series);
        response.stored = 0;
        for (unsigned int k = 0; k < point.n_strains; ++k)
          {
            const SeriesStep &s     = series_in_step[point.types[k]];
            const Lanes       start = committed.kept(layout.strain(k)),
                        rate        = committed.kept(layout.rate(k));
            const Lanes increment   = strains[k] - start;
            const Lanes lead        = lead_of(increment, rate, step.dt);
            const bool  is_mean     = step.kind == SectionStep::Kind::mean;
            Lanes       force       = s.long_time *
              (is_mean ? Lanes((start + strains[k]) / 2) : strains[k]);
            Lanes stored = s.long_time * strains[k] * strains[k];
            for (unsigned int i = 0; i < layout.n_terms; ++i)
              {
                const TermStep    &t      = s.terms[i];
                const unsigned int at     = layout.viscous(k, i);
                const Lanes        before = start - committed.internal(at),
                            after         = t.decay * before +
                  t.by_increment * increment + t.by_lead * lead;
                if (end != nullptr)
                  end->set_internal(at, strains[k] - after);
                force += t.ratio *
                  (is_mean ? Lanes(t.mean_decay * before +
                                   t.mean_by_increment * increment)
                           : after);
                stored += t.ratio * after * after;
              }
            if (end != nullptr)
              {
                end->set_kept(layout.strain(k), strains[k]);
                end->set_kept(layout.rate(k), rate_of(increment, rate));
              }
            response.forces[k]  = point.stiffness[k] * force;
            response.tangent[k] = point.stiffness[k] * s.tangent;
            response.stored += point.stiffness[k] / 2 * stored;
          }
      }

      void start_strains(const SectionPoint   &point,
                         const SectionHistory &committed,
                         Lanes                *strains) const override
      {
        const ViscoelasticHistory layout(point, series);
        for (unsigned int k = 0; k < point.n_strains; ++k)
          strains[k] = committed.kept(layout.strain(k));
      }

    private:
      /** Mean rate of a strain to keep for the next step, after @p rate in the
       * last one. */
      Lanes rate_of(const Lanes &increment, const Lanes &rate) const
      {
        if (step.kind == SectionStep::Kind::relaxed ||
            step.kind == SectionStep::Kind::stage)
          return 0;
        return step.dt > 0 ? Lanes(increment / step.dt) : rate;
      }

      const ModulusSeries           &series;
      const SectionStep              step;
      const ByStrainType<SeriesStep> series_in_step;
    };

    /** Energy lost by a Maxwell element of unit stiffness: a quadratic form of
     * the strain e of its spring at the start, dE and v dt - dE. */
    struct LossForm
    {
      LossForm(const Term &term, const double dt)
      {
        const auto lost =
          [&](const double e, const double increment, const double lead) {
            return dt > 0
              ? term.element().dissipated_energy(e,
                                                 increment,
                                                 (increment + lead) / dt,
                                                 dt)
              : 0.;
          };
        for (int i = 0; i < 3; ++i)
          square[i] = lost(i == 0, i == 1, i == 2);
        for (int i = 0; i < 3; ++i)
          product[i] = lost(i != 0, i != 1, i != 2) - square[(i + 1) % 3] -
            square[(i + 2) % 3];
      }

      /** J per unit stiffness, >= 0. */
      Lanes operator()(const Lanes &e,
                       const Lanes &increment,
                       const Lanes &lead) const
      {
        using std::max;
        return max(Lanes(square[0] * e * e + square[1] * increment * increment +
                         square[2] * lead * lead +
                         product[0] * increment * lead + product[1] * e * lead +
                         product[2] * e * increment),
                   Lanes(0));
      }

      double square[3];
      double product[3]; ///< of the two others
    };

    class ViscoelasticLosses : public SectionLosses
    {
    public:
      ViscoelasticLosses(const ModulusSeries &series, const SectionStep &step)
        : series(series)
        , step(step)
      {
        for (const Term &term : series.normal.terms)
          forms.normal.emplace_back(term, step.dt);
        for (const Term &term : series.shear.terms)
          forms.shear.emplace_back(term, step.dt);
      }

      AUXFEM_FLATTEN Lanes lost(const SectionPoint   &point,
                                const SectionHistory &committed,
                                const SectionHistory &accepted) const override
      {
        const ViscoelasticHistory layout(point, series);
        Lanes                     sum = 0;
        for (unsigned int k = 0; k < point.n_strains; ++k)
          {
            const Series &s         = series[point.types[k]];
            const auto   &losses    = forms[point.types[k]];
            const Lanes   start     = committed.kept(layout.strain(k));
            const Lanes   increment = accepted.kept(layout.strain(k)) - start;
            // Mean forces assume a constant rate.
            const Lanes lead = step.kind == SectionStep::Kind::mean
              ? Lanes(0)
              : lead_of(increment, committed.kept(layout.rate(k)), step.dt);
            for (unsigned int i = 0; i < layout.n_terms; ++i)
              sum += point.stiffness[k] * s.terms[i].ratio *
                losses[i](start - committed.internal(layout.viscous(k, i)),
                          increment,
                          lead);
          }
        return sum;
      }

    private:
      const ModulusSeries                &series;
      const SectionStep                   step;
      ByStrainType<std::vector<LossForm>> forms;
    };
  } // namespace

  std::unique_ptr<SectionUpdate>
  make_viscoelastic_update(const ModulusSeries &series, const SectionStep &step)
  {
    return std::make_unique<ViscoelasticUpdate>(series, step);
  }

  std::unique_ptr<SectionLosses>
  make_viscoelastic_losses(const ModulusSeries &series, const SectionStep &step)
  {
    return std::make_unique<ViscoelasticLosses>(series, step);
  }
} // namespace auxfem
