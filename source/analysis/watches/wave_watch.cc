#include <auxfem/analysis/watch.h>
#include <auxfem/analysis/watched_part.h>
#include <auxfem/elements/strut_order.h>
#include <auxfem/model/line_rule.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/time/largest_in_time.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

namespace auxfem
{
  namespace
  {
    const std::string wave_record       = "watch: waves in struts",
                      unresolved_record = wave_record + ", by unknown";

    constexpr unsigned int most_poles = 3;

    /** Part of the kinetic energy in waves that elements do not follow. */
    constexpr double doubtful_part = 0.02, ruinous_part = 0.2;

    /** Part of the largest energy so far: kinetic energy counts as no less,
     * since what hardly moves is decided by its strains. Vibrations with 2 % of
     * it move by 1.4 % of what the structure is deformed. */
    constexpr double least_part_of_energy = 0.01;

    /** n (n - 2) (n - 4) ... 1. */
    double double_factorial(const unsigned int n)
    {
      return n < 2 ? 1. : n * double_factorial(n - 2);
    }

    /**
     * Wave number times length of an element of order p at which the part of
     * the energy of a wave that is in its highest degree,
     * (k h)^2p / (4^p (2p + 1)!! (2p - 1)!!), is ruinous.
     */
    double ruinous_phase(const unsigned int p)
    {
      return 2 *
        std::pow(ruinous_part * double_factorial(2 * p + 1) *
                   double_factorial(2 * p - 1),
                 1. / (2 * p));
    }

    /** Poles of a high-pass filter that falls about as that part does, with
     * the power p of the frequency: k^2 of bending waves. */
    constexpr unsigned int poles_of(const unsigned int p)
    {
      return (p + 1) / 2;
    }

    /** Frequency of the filter over that of which it passes that part. */
    double filter_over_passed(const unsigned int n_poles)
    {
      return std::sqrt(std::pow(ruinous_part, -1. / n_poles) - 1);
    }

    /** Frequency (rad/s) of waves too short for an element of @p length (m). */
    double ruinous_frequency(const LatticeModel &model,
                             const Section      &section,
                             const unsigned int  order,
                             const double        length)
    {
      const double bending     = model.lattice.dimension == 2
            ? section.bending_stiffness_3()
            : std::min(section.bending_stiffness_2(),
                   section.bending_stiffness_3());
      const double wave_number = ruinous_phase(order) / length;
      return wave_number * wave_number *
        std::sqrt(bending / section.mass_per_length());
    }

    /** A translation of a node, with what elements have there. */
    struct FilteredTranslation
    {
      /** @param mass_there of an element (kg)
       * @param filter frequency of its filter (rad/s) */
      void add(const double       mass_there,
               const double       filter,
               const unsigned int n_poles_there,
               const unsigned int of_strut)
      {
        n_poles = std::min(n_poles, n_poles_there);
        mass += mass_there;
        mass_times_filter += mass_there * filter;
        strut = of_strut;
      }

      unsigned int n_poles = std::numeric_limits<unsigned int>::max();
      unsigned int strut   = 0; ///< one that has it
      double       mass = 0, mass_times_filter = 0;
    };

    /** By local unknown; no mass: there is no filter. */
    using Translations = std::vector<FilteredTranslation>;

    /** Steps for which a part of them is looked at, at least. */
    constexpr unsigned int n_steps_of_watched_part = 4;

    /** Time (s) that filters which begin anew need to follow. */
    double time_to_follow(const Translations  &translations,
                          const UnknownLayout &layout)
    {
      constexpr double turns   = 6;
      double           slowest = std::numeric_limits<double>::infinity();
      for (const FilteredTranslation &translation : translations)
        if (translation.mass > 0)
          slowest =
            std::min(slowest, translation.mass_times_filter / translation.mass);
      return layout.largest(turns / slowest);
    }

    void add_element(const LatticeModel &model,
                     const unsigned int  e,
                     const LineRule     &rule,
                     const double        time_step,
                     Translations       &translations)
    {
      const DofNumbering::Element &element = model.numbering.elements()[e];
      const Strut   &strut   = model.lattice.struts[element.interval.strut];
      const Section &section = model.sections[strut.section];
      if (!element.is_owned || section.mass_per_length() == 0)
        return;
      const double length = model.lattice.length(strut) *
        (element.interval.end - element.interval.begin);
      const double frequency =
        ruinous_frequency(model, section, element.order, length);
      // Steps longer than half a period hold no such waves.
      if (frequency * time_step >= dealii::numbers::PI)
        return;
      const unsigned int n_poles  = poles_of(element.order);
      const int         *unknowns = model.numbering.element_unknowns(e);
      for (const double integral : rule.integrals)
        {
          for (unsigned int d = 0; d < model.lattice.dimension; ++d)
            translations[unknowns[d]].add(section.mass_per_length() * integral *
                                            length / 2,
                                          frequency *
                                            filter_over_passed(n_poles),
                                          n_poles,
                                          element.interval.strut);
          unknowns += model.numbering.n_components();
        }
    }

    /** Of the elements that this rank counts. */
    Translations filtered_translations(const LatticeModel &model,
                                       const double        time_step)
    {
      Translations translations(model.numbering.layout().n_local());
      for (const DofNumbering::Group &group : model.numbering.groups())
        {
          const LineRule rule(group.order);
          for (unsigned int e = group.begin; e < group.end; ++e)
            add_element(model, e, rule, time_step, translations);
        }
      return translations;
    }

    /** What filters remember, by local unknown. */
    struct FilterMemory
    {
      explicit FilterMemory(const unsigned int n_local)
        : unresolved(n_local, 0.)
      {
        filtered.fill(Vector(n_local, 0.));
      }

      FilterMemory(const UnknownRecords &unknowns, const Records &records)
        : unresolved(unknowns.values(unresolved_record, records))
      {
        for (unsigned int k = 0; k < filtered.size(); ++k)
          filtered[k] = unknowns.values(filter_record(k), records);
      }

      void save(const UnknownRecords &unknowns, Records &records) const
      {
        unknowns.keep(unresolved_record, unresolved, records);
        for (unsigned int k = 0; k < filtered.size(); ++k)
          unknowns.keep(filter_record(k), filtered[k], records);
      }

      static std::string filter_record(const unsigned int k)
      {
        return wave_record + ", velocity after pole " + std::to_string(k);
      }

      std::array<Vector, most_poles> filtered;   ///< m/s
      Vector                         unresolved; ///< J s
    };

    /** Velocities behind filters with the same number of poles. */
    template <unsigned int n_poles>
    class FilteredVelocities
    {
    public:
      /** Takes in a translation if it has so many poles. */
      void add(const unsigned int         unknown,
               const FilteredTranslation &translation)
      {
        if (translation.n_poles != n_poles)
          return;
        unknowns.push_back(unknown);
        struts.push_back(translation.strut);
        masses.push_back(translation.mass);
        filters.push_back(translation.mass_times_filter / translation.mass);
        filtered.push_back({});
        unresolved.push_back(0.);
      }

      /** As if all had been at rest. */
      void forget_steps()
      {
        std::fill(filtered.begin(),
                  filtered.end(),
                  std::array<double, n_poles>{});
      }

      void tell(FilterMemory &memory) const
      {
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          {
            for (unsigned int k = 0; k < n_poles; ++k)
              memory.filtered[k][unknowns[i]] = filtered[i][k];
            memory.unresolved[unknowns[i]] = unresolved[i];
          }
      }

      void take(const FilterMemory &memory)
      {
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          {
            for (unsigned int k = 0; k < n_poles; ++k)
              filtered[i][k] = memory.filtered[k][unknowns[i]];
            unresolved[i] = memory.unresolved[unknowns[i]];
          }
      }

      /** Kinetic energy (J) of what passes the filters after a step. */
      double filter(const Evaluation &step)
      {
        const double *before = step.from.velocity->data(),
                     *now    = step.to.velocity->data();
        double sum           = 0;
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          {
            const double decay  = 1 / (1 + filters[i] * step.dt);
            double       change = now[unknowns[i]] - before[unknowns[i]];
            for (double &value : filtered[i])
              {
                const double passed = decay * (value + change);
                change              = passed - value;
                value               = passed;
              }
            const double energy =
              masses[i] / 2 * filtered[i].back() * filtered[i].back();
            unresolved[i] += energy * step.dt;
            sum += energy;
          }
        return sum;
      }

      /** Adds what has been summed up over time (J s) to the struts. */
      void add_unresolved(std::map<unsigned int, double> &by_strut) const
      {
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          by_strut[struts[i]] += unresolved[i];
      }

    private:
      std::vector<int>          unknowns;
      std::vector<unsigned int> struts;
      std::vector<double>       masses;  ///< kg
      std::vector<double>       filters; ///< rad/s
      /** M/s, after each pole. */
      std::vector<std::array<double, n_poles>> filtered;
      std::vector<double>                      unresolved; ///< J s
    };

    /** By their number of poles. */
    class AllFilteredVelocities
    {
    public:
      void add(const unsigned int         unknown,
               const FilteredTranslation &translation)
      {
        for_each([&](auto &of_poles) { of_poles.add(unknown, translation); });
      }

      /** Calls @p act with each. */
      ///@{
      template <class Act>
      void for_each(const Act &act)
      {
        std::apply([&](auto &...of_poles) { (act(of_poles), ...); }, by_poles);
      }

      template <class Act>
      void for_each(const Act &act) const
      {
        std::apply([&](const auto &...of_poles) { (act(of_poles), ...); },
                   by_poles);
      }
      ///@}

    private:
      static_assert(poles_of(largest_plane_order) <= most_poles);
      std::tuple<FilteredVelocities<1>,
                 FilteredVelocities<2>,
                 FilteredVelocities<3>>
        by_poles;
    };

    /**
     * Kinetic energy in bending waves too short for the elements: what is left
     * of it when the velocities have passed a high-pass filter with the
     * frequency of such waves, over the time; in large linear scenes of parts
     * of them (WatchedPart).
     */
    class WaveWatch : public Watch
    {
    public:
      WaveWatch(const Scene &scene, const Equations &equations)
        : WaveWatch(scene,
                    equations,
                    filtered_translations(equations.model(), scene.time.step))
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        if (part.passes_on(step.dt))
          forget_steps(velocities[part.now()]);
        double in_step = 0;
        velocities[part.now()].for_each(
          [&](auto &of_poles) { in_step += of_poles.filter(step); });
        in_step = part.n_parts() * layout.sum(in_step);
        unresolved += in_step * step.dt;
        const Energies &energies = step.to.energies;
        largest_energy =
          std::max(largest_energy, energies.kinetic() + energies.stored());
        kinetic +=
          std::max(energies.kinetic(), least_part_of_energy * largest_energy) *
          step.dt;
        largest.add(in_step, step.to.time);
      }

      std::vector<Finding> findings() const override
      {
        const double part = unresolved / kinetic;
        if (!(part > doubtful_part))
          return {};
        const std::string  location = "strut " + std::to_string(worst().strut);
        std::ostringstream text;
        text << std::fixed << std::setprecision(0)
             << "Vibrations of struts that are too fast for their elements "
                "carry "
             << 100 * std::min(1., part) << " % of the kinetic energy, most in "
             << location
             << ": their frequencies are wrong. Raise Discretization/Order or "
                "Discretization/Global refinements, and compare.";
        return {
          {part > ruinous_part ? Verdict::not_to_be_used : Verdict::doubtful,
           text.str(),
           largest.time,
           location}};
      }

      void save(Records &records) const override
      {
        records.keep(
          wave_record,
          {unresolved, kinetic, largest.value, largest.time, largest_energy});
        part.save(wave_record, records);
        FilterMemory memory(numbering.layout().n_local());
        for (const AllFilteredVelocities &of_part : velocities)
          of_part.for_each(
            [&](const auto &of_poles) { of_poles.tell(memory); });
        memory.save(UnknownRecords(numbering), records);
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(wave_record, 5);
        unresolved                       = values[0];
        kinetic                          = values[1];
        largest                          = {values[2], values[3]};
        largest_energy                   = values[4];
        const FilterMemory memory(UnknownRecords(numbering), records);
        for (AllFilteredVelocities &of_part : velocities)
          of_part.for_each([&](auto &of_poles) { of_poles.take(memory); });
        if (!part.resume(wave_record, records))
          forget_steps(velocities[part.now()]);
      }

    private:
      WaveWatch(const Scene        &scene,
                const Equations    &equations,
                const Translations &translations)
        : layout(equations.unknowns().layout)
        , numbering(equations.model().numbering)
        , part(scene,
               equations,
               n_steps_of_watched_part,
               time_to_follow(translations, layout))
        , velocities(part.n_parts())
      {
        for (unsigned int i = 0; i < translations.size(); ++i)
          if (translations[i].mass > 0)
            velocities[part.part_of(i)].add(i, translations[i]);
      }

      static void forget_steps(AllFilteredVelocities &velocities)
      {
        velocities.for_each([](auto &of_poles) { of_poles.forget_steps(); });
      }

      /** With the most of that energy. */
      struct WorstStrut
      {
        double       unresolved = 0; ///< J s
        unsigned int strut      = 0;
      };

      /** Of all ranks. */
      WorstStrut worst() const
      {
        WorstStrut                     mine;
        std::map<unsigned int, double> by_strut;
        for (const AllFilteredVelocities &of_part : velocities)
          of_part.for_each(
            [&](const auto &of_poles) { of_poles.add_unresolved(by_strut); });
        for (const auto &[strut, value] : by_strut)
          if (value > mine.unresolved)
            mine = {value, strut};
        const double all = layout.largest(mine.unresolved);
        return {all,
                static_cast<unsigned int>(layout.largest(
                  mine.unresolved == all ? double(mine.strut) : 0.))};
      }

      const UnknownLayout &layout;
      const DofNumbering  &numbering;
      WatchedPart          part;
      /** By part. */
      std::vector<AllFilteredVelocities> velocities;
      double                             unresolved     = 0; ///< J s
      double                             kinetic        = 0; ///< J s
      double                             largest_energy = 0; ///< J
      LargestInTime                      largest;            ///< J
    };
  } // namespace

  std::unique_ptr<Watch> make_wave_watch(const Scene     &scene,
                                         const Equations &equations)
  {
    return std::make_unique<WaveWatch>(scene, equations);
  }
} // namespace auxfem
