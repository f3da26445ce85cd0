#include <auxfem/struts/material.h>
#include <auxfem/struts/prony_series.h>
#include <auxfem/struts/section_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace auxfem
{
  namespace
  {
    using Term   = PronySeries::Term;
    using Series = PronySeries;

    /** One object for each type of strain. */
    template <class T>
    struct ByType
    {
      T normal, shear;

      const T &operator[](const StrainType type) const
      {
        return type == StrainType::normal ? normal : shear;
      }
    };

    /** Both series of a material, with equally many terms. */
    using SeriesPair = ByType<Series>;

    /**
     * History at a point. Internal variables: by strain the viscous strains of
     * the terms. Kept: the strains and their mean rates (1/s) in the last step.
     */
    struct Layout
    {
      Layout(const SectionPoint &point, const SeriesPair &series)
        : n_strains(point.n_strains)
        , n_terms(series.normal.terms.size())
      {}

      unsigned int viscous(const unsigned int strain,
                           const unsigned int term) const
      {
        return strain * n_terms + term;
      }

      unsigned int strain(const unsigned int k) const
      {
        return k;
      }

      unsigned int rate(const unsigned int k) const
      {
        return n_strains + k;
      }

      const unsigned int n_strains, n_terms;
    };

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
      ViscoelasticUpdate(const SeriesPair &series, const SectionStep &step)
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
        const Layout layout(point, series);
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
        const Layout layout(point, series);
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

      const SeriesPair        &series;
      const SectionStep        step;
      const ByType<SeriesStep> series_in_step;
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
      ViscoelasticLosses(const SeriesPair &series, const SectionStep &step)
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
        const Layout layout(point, series);
        Lanes        sum = 0;
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
      const SeriesPair             &series;
      const SectionStep             step;
      ByType<std::vector<LossForm>> forms;
    };

    /** Generalized Maxwell material: Prony series of both moduli. */
    class Viscoelastic : public SectionLaw
    {
    public:
      /** @param starts_relaxed state in the equilibrium at the start of a run */
      Viscoelastic(SeriesPair series, const bool starts_relaxed)
        : series(std::move(series))
        , is_relaxed_at_start(starts_relaxed)
      {}

      bool starts_relaxed() const override
      {
        return is_relaxed_at_start;
      }

      bool is_linear() const override
      {
        return true;
      }

      unsigned int n_internal(const SectionPoint &point) const override
      {
        return point.n_strains * series.normal.terms.size();
      }

      unsigned int n_kept(const SectionPoint &point) const override
      {
        return 2 * point.n_strains;
      }

      std::unique_ptr<SectionUpdate>
      update(const SectionStep &step) const override
      {
        return std::make_unique<ViscoelasticUpdate>(series, resolved(step));
      }

      std::unique_ptr<SectionLosses>
      losses(const SectionStep &step) const override
      {
        return std::make_unique<ViscoelasticLosses>(series, resolved(step));
      }

      AUXFEM_FLATTEN void instant(const SectionPoint         &point,
                                  const Lanes                *strains,
                                  const SectionHistory       &history,
                                  const SectionHistoryOutput *rates,
                                  SectionInstant &instant) const override
      {
        const Layout layout(point, series);
        instant.stored = instant.relaxing_stored = instant.lost_power = 0;
        for (unsigned int k = 0; k < point.n_strains; ++k)
          {
            const Series &s     = series[point.types[k]];
            Lanes         force = 0, stored = 0, power = 0;
            for (unsigned int i = 0; i < layout.n_terms; ++i)
              {
                const unsigned int at     = layout.viscous(k, i);
                const Lanes        spring = strains[k] - history.internal(at);
                const auto [ratio, time]  = s.terms[i];
                if (rates != nullptr)
                  rates->set_internal(at, spring / time);
                force += ratio * spring;
                stored += ratio * spring * spring;
                power += ratio * spring * spring / time;
              }
            const Lanes &stiffness = point.stiffness[k];
            instant.relaxing[k]    = stiffness * force;
            instant.forces[k] =
              instant.relaxing[k] + stiffness * s.long_time * strains[k];
            instant.relaxing_stored += stiffness / 2 * stored;
            instant.stored +=
              stiffness / 2 * s.long_time * strains[k] * strains[k];
            instant.lost_power += stiffness * power;
          }
        instant.stored += instant.relaxing_stored;
      }

      double long_time_ratio(const StrainType type) const override
      {
        return series[type].long_time;
      }

      std::map<double, double>
      relaxing_ratios(const StrainType type) const override
      {
        std::map<double, double> ratios;
        for (const Term &term : series[type].terms)
          ratios[term.time] += term.ratio;
        return ratios;
      }

    private:
      /** Replaces Kind::start by the state of the material at the start of a
       * run. */
      SectionStep resolved(SectionStep step) const
      {
        if (step.kind == SectionStep::Kind::start)
          step.kind = is_relaxed_at_start ? SectionStep::Kind::relaxed
                                          : SectionStep::Kind::end;
        return step;
      }

      const SeriesPair series;
      const bool       is_relaxed_at_start;
    };

    const QuantityList relaxing_parts = {
      "Relaxing parts",
      "",
      "1",
      {0, 1, true, false},
      1,
      std::numeric_limits<unsigned int>::max(),
      "Parts of the instantaneous modulus that relax, one per relaxation time. "
      "Together at most 1; less than 1 where the material must carry load "
      "forever."};
    const QuantityList relaxation_times = {
      "Relaxation times",
      "",
      "s",
      Range::positive(),
      1,
      std::numeric_limits<unsigned int>::max(),
      "Time in which each part falls to 1/e under constant strain."};
    const Choice volume_change = {
      "Volume change",
      "relaxing",
      {"relaxing", "elastic"},
      "relaxing: Poisson's ratio is constant and all moduli relax alike; "
      "elastic: the bulk modulus does not relax, the parts are those of the "
      "shear modulus."};

    const Choice start = {
      "State at start",
      "relaxed",
      {"relaxed", "instantaneous"},
      "State in the equilibrium of Time/Static start: relaxed, as under loads "
      "that have been there for long; instantaneous: loaded just now."};

    std::map<double, double> read_parts(const ParameterValues &values)
    {
      const std::vector<double> parts = values[relaxing_parts],
                                times = values[relaxation_times];
      if (parts.size() != times.size())
        values.refuse("Relaxing parts has " + std::to_string(parts.size()) +
                      " values, Relaxation times has " +
                      std::to_string(times.size()) +
                      ". Each part needs one time: give lists of equal length");
      std::map<double, double> by_time;
      for (std::size_t i = 0; i < parts.size(); ++i)
        by_time[times[i]] += parts[i];
      const double sum = std::accumulate(parts.begin(), parts.end(), 0.);
      if (sum > 1 + parts.size() * std::numeric_limits<double>::epsilon())
        values.refuse(relaxing_parts,
                      "the parts add up to " + std::to_string(sum) +
                        ". More than the whole modulus cannot relax: reduce "
                        "them to at most 1 together");
      return by_time;
    }

    std::unique_ptr<SectionLaw> make_viscoelastic(ParameterValues &values)
    {
      const std::map<double, double> parts = read_parts(values);
      const Series                   shear = prony_series(parts);
      const double                   nu    = values[poissons_ratio_parameter()];
      // An incompressible material has E = 3 G.
      const bool is_alike = values[volume_change] == "relaxing" || nu == 0.5;
      return std::make_unique<Viscoelastic>(
        SeriesPair{is_alike ? shear : series_of_youngs_modulus(shear, nu),
                   shear},
        values[start] == "relaxed");
    }
  } // namespace

  RegistryEntry<SectionLaw> viscoelastic_entry()
  {
    return {"viscoelastic",
            "Generalized Maxwell material (Prony series): a spring in parallel "
            "with Maxwell elements. Young's modulus is the instantaneous one.",
            {relaxing_parts, relaxation_times, volume_change, start},
            make_viscoelastic};
  }
} // namespace auxfem
