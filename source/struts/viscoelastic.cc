#include <auxfem/struts/material.h>
#include <auxfem/struts/prony_fit.h>
#include <auxfem/struts/viscoelastic_step.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Generalized Maxwell material: Prony series of both moduli. */
    class Viscoelastic : public SectionLaw
    {
    public:
      /**
       * @param starts_relaxed state in the equilibrium at the start of a run
       * @param fit from which the series was made, if it was
       */
      Viscoelastic(ModulusSeries           series,
                   const bool              starts_relaxed,
                   std::optional<PronyFit> fit)
        : series(std::move(series))
        , is_relaxed_at_start(starts_relaxed)
        , fit(std::move(fit))
      {}

      std::optional<double> youngs_modulus() const override
      {
        if (!fit)
          return std::nullopt;
        return fit->instantaneous_modulus;
      }

      bool loses_energy() const override
      {
        return !series.normal.terms.empty();
      }

      std::string note() const override
      {
        if (!fit)
          return "";
        std::ostringstream text;
        text.precision(3);
        text
          << "a series of " << fit->parts.size()
          << " terms fits the measured moduli to " << 100 * fit->largest_error
          << " % at " << fit->worst_frequency / (2 * std::acos(-1.)) << " Hz, "
          << 100 * fit->rms_error
          << " % in the root mean square. Young's modulus of a sudden strain "
             "is "
          << fit->instantaneous_modulus << " Pa";
        return text.str();
      }

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
        return make_viscoelastic_update(series, resolved(step));
      }

      std::unique_ptr<SectionLosses>
      losses(const SectionStep &step) const override
      {
        return make_viscoelastic_losses(series, resolved(step));
      }

      AUXFEM_FLATTEN void instant(const SectionPoint         &point,
                                  const Lanes                *strains,
                                  const SectionHistory       &history,
                                  const SectionHistoryOutput *rates,
                                  SectionInstant &instant) const override
      {
        const ViscoelasticHistory layout(point, series);
        instant.stored = instant.relaxing_stored = instant.lost_power = 0;
        for (unsigned int k = 0; k < point.n_strains; ++k)
          {
            const PronySeries &s     = series[point.types[k]];
            Lanes              force = 0, stored = 0, power = 0;
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
        for (const PronySeries::Term &term : series[type].terms)
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

      const ModulusSeries series;
      const bool          is_relaxed_at_start;

      const std::optional<PronyFit> fit;
    };

    const QuantityList relaxing_parts = {
      "Relaxing parts",
      "",
      "1",
      {0, 1, true, false},
      0,
      std::numeric_limits<unsigned int>::max(),
      "Parts of the instantaneous modulus that relax, one per relaxation time. "
      "Together at most 1; less than 1 where the material must carry load "
      "forever."};
    const QuantityList relaxation_times = {
      "Relaxation times",
      "",
      "s",
      Range::positive(),
      0,
      std::numeric_limits<unsigned int>::max(),
      "Time in which each part falls to 1/e under constant strain."};
    const QuantityList measured_frequencies = {
      "Measured frequencies",
      "",
      "Hz",
      Range::positive(),
      0,
      std::numeric_limits<unsigned int>::max(),
      "Frequencies of measured moduli, in place of Relaxing parts, Relaxation "
      "times and Young's modulus: a series is fitted to them, and its error "
      "printed."};
    const QuantityList storage_moduli = {
      "Storage moduli",
      "",
      "Pa",
      Range::positive(),
      0,
      std::numeric_limits<unsigned int>::max(),
      "Real part of Young's modulus at each of Measured frequencies."};
    const QuantityList loss_moduli = {
      "Loss moduli",
      "",
      "Pa",
      Range::positive(),
      0,
      std::numeric_limits<unsigned int>::max(),
      "Imaginary part of Young's modulus there."};
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

    std::string number_of_values(const ParameterValues &values,
                                 const QuantityList    &list)
    {
      return list.name + " has " + std::to_string(values[list].size()) +
        " values";
    }

    /** PronySeries from measured moduli; empty if there are none. */
    std::optional<PronyFit> read_fit(const ParameterValues &values)
    {
      const std::vector<double> frequencies = values[measured_frequencies],
                                storage     = values[storage_moduli],
                                loss        = values[loss_moduli];
      if (frequencies.size() != storage.size() ||
          frequencies.size() != loss.size())
        values.refuse(number_of_values(values, measured_frequencies) + ", " +
                      number_of_values(values, storage_moduli) + ", " +
                      number_of_values(values, loss_moduli) +
                      ". Each frequency needs both moduli: give lists of equal "
                      "length");
      if (frequencies.empty())
        return std::nullopt;
      for (const Parameter &parameter : Parameters{relaxing_parts,
                                                   relaxation_times,
                                                   youngs_modulus_parameter(),
                                                   volume_change})
        if (!values.is_default(parameter))
          values.refuse(parameter,
                        "Measured frequencies is given, from whose moduli the "
                        "program finds it. Remove one of them");
      std::vector<MeasuredModulus> measured;
      for (std::size_t i = 0; i < frequencies.size(); ++i)
        measured.push_back(
          {2 * std::acos(-1.) * frequencies[i], storage[i], loss[i]});
      return fit_prony_series(measured);
    }

    std::map<double, double> read_parts(const ParameterValues &values)
    {
      const std::vector<double> parts = values[relaxing_parts],
                                times = values[relaxation_times];
      if (parts.size() != times.size())
        values.refuse(number_of_values(values, relaxing_parts) + ", " +
                      number_of_values(values, relaxation_times) +
                      ". Each part needs one time: give lists of equal length");
      if (parts.empty())
        values.refuse("Relaxing parts must be given. Give them with Relaxation "
                      "times, or moduli with Measured frequencies");
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
      const std::optional<PronyFit> fit = read_fit(values);
      const PronySeries             shear =
        prony_series(fit ? fit->parts : read_parts(values));
      const double nu = values[poissons_ratio_parameter()];
      // An incompressible material has E = 3 G.
      const bool is_alike = values[volume_change] == "relaxing" || nu == 0.5;
      return std::make_unique<Viscoelastic>(
        ModulusSeries{is_alike ? shear : series_of_youngs_modulus(shear, nu),
                      shear},
        values[start] == "relaxed",
        fit);
    }
  } // namespace

  RegistryEntry<SectionLaw> viscoelastic_entry()
  {
    return {"viscoelastic",
            "Generalized Maxwell material (Prony series): a spring in parallel "
            "with Maxwell elements. Young's modulus is the instantaneous one.",
            {relaxing_parts,
             relaxation_times,
             measured_frequencies,
             storage_moduli,
             loss_moduli,
             volume_change,
             start},
            make_viscoelastic};
  }

  std::shared_ptr<const SectionLaw> make_elastic_section_law()
  {
    // A series without terms does not relax.
    static const auto law =
      std::make_shared<const Viscoelastic>(ModulusSeries{{1, {}}, {1, {}}},
                                           /*starts_relaxed=*/true,
                                           std::nullopt);
    return law;
  }
} // namespace auxfem
