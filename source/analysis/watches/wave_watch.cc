#include <auxfem/analysis/watch.h>
#include <auxfem/model/line_rule.h>
#include <auxfem/time/largest_in_time.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string wave_record = "watch: waves in struts";

    /** Part of the kinetic energy in waves that elements do not follow. */
    constexpr double doubtful_part = 0.02, ruinous_part = 0.2;

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
    unsigned int poles_of(const unsigned int p)
    {
      return (p + 1) / 2;
    }

    /** Frequency of the filter over that of which it passes that part. */
    double filter_over_passed(const unsigned int n_poles)
    {
      return std::sqrt(std::pow(ruinous_part, -1. / n_poles) - 1);
    }

    bool is_counted_with_mass(const LatticeModel &model, const unsigned int e)
    {
      const DofNumbering::Element &element = model.numbering.elements()[e];
      const Strut &strut = model.lattice.struts[element.interval.strut];
      return element.is_owned &&
        model.sections[strut.section].mass_per_length() > 0;
    }

    /** Of an element, of which the velocities of nodes are filtered. */
    struct FilteredElement
    {
      FilteredElement(const LatticeModel &model,
                      const LineRule     &rule,
                      const unsigned int  e)
        : strut(model.numbering.elements()[e].interval.strut)
        , n_poles(poles_of(model.numbering.elements()[e].order))
      {
        const DofNumbering::Element &element    = model.numbering.elements()[e];
        const Strut                 &of_lattice = model.lattice.struts[strut];
        const Section     &section   = model.sections[of_lattice.section];
        const unsigned int dimension = model.lattice.dimension;
        const double       length    = model.lattice.length(of_lattice) *
          (element.interval.end - element.interval.begin);
        const double bending     = dimension == 2
              ? section.bending_stiffness_3()
              : std::min(section.bending_stiffness_2(),
                     section.bending_stiffness_3());
        const double wave_number = ruinous_phase(element.order) / length;
        const double mass        = section.mass_per_length();
        frequency = wave_number * wave_number * std::sqrt(bending / mass);
        of_filter = frequency * filter_over_passed(n_poles);

        const int *of_element = model.numbering.element_unknowns(e);
        for (unsigned int a = 0; a <= element.order; ++a)
          for (unsigned int d = 0; d < dimension; ++d)
            {
              unknowns.push_back(
                of_element[a * model.numbering.n_components() + d]);
              masses.push_back(mass * rule.integrals[a] * length / 2);
            }
        forget();
      }

      void forget()
      {
        filtered.assign(unknowns.size() * n_poles, 0.);
      }

      /** Kinetic energy (J) of what passes the filter after a step. */
      double filter(const Evaluation &step)
      {
        const double *before  = step.from.velocity->data(),
                     *now     = step.to.velocity->data();
        const double decay    = 1 / (1 + of_filter * step.dt);
        double      *of_value = filtered.data();
        double       twice    = 0;
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          {
            double change = now[unknowns[i]] - before[unknowns[i]];
            for (unsigned int pole = 0; pole < n_poles; ++pole, ++of_value)
              {
                const double passed = decay * (*of_value + change);
                change              = passed - *of_value;
                *of_value           = passed;
              }
            twice += masses[i] * of_value[-1] * of_value[-1];
          }
        return twice / 2;
      }

      unsigned int        strut, n_poles;
      double              frequency; ///< of waves that are too short (rad/s)
      double              of_filter; ///< rad/s
      std::vector<int>    unknowns;  ///< translations, node by node
      std::vector<double> masses;    ///< kg, that of the element shared out
      std::vector<double> filtered;  ///< m/s, of each unknown after each pole
      double              unresolved = 0; ///< J s, summed up
    };

    /**
     * Kinetic energy in bending waves too short for the elements: what is left
     * of it when the velocities have passed a high-pass filter with the
     * frequency of such waves, over the time.
     */
    class WaveWatch : public Watch
    {
    public:
      WaveWatch(const double time_step, const Equations &equations)
        : layout(equations.unknowns().layout)
      {
        const LatticeModel &model = equations.model();
        for (const DofNumbering::Group &group : model.numbering.groups())
          {
            const LineRule rule(group.order);
            for (unsigned int e = group.begin; e < group.end; ++e)
              if (is_counted_with_mass(model, e))
                {
                  FilteredElement element(model, rule, e);
                  // Steps longer than half a period hold no such waves.
                  if (element.frequency * time_step < dealii::numbers::PI)
                    elements.push_back(std::move(element));
                }
          }
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        double in_step = 0;
        for (FilteredElement &element : elements)
          {
            const double energy = element.filter(step);
            element.unresolved += energy * step.dt;
            in_step += energy;
          }
        unresolved += in_step * step.dt;
        kinetic += step.to.energies.kinetic() * step.dt;
        largest.add(in_step, step.to.time);
      }

      std::vector<Finding> findings() const override
      {
        const double part = layout.sum(unresolved) / kinetic;
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
           largest.of_all_ranks(layout).time,
           location}};
      }

      void save(Records &records) const override
      {
        const LargestInTime of_steps = largest.of_all_ranks(layout);
        const WorstStrut    strut    = worst();
        records.keep(wave_record,
                     {layout.sum(unresolved),
                      kinetic,
                      of_steps.value,
                      of_steps.time,
                      strut.unresolved,
                      double(strut.strut)});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(wave_record, 6);
        // Sums go on on one rank.
        unresolved = layout.rank() == 0 ? values[0] : 0.;
        kinetic    = values[1];
        largest    = {values[2], values[3]};
        worst_before =
          WorstStrut{values[4], static_cast<unsigned int>(values[5])};
        for (FilteredElement &element : elements)
          {
            element.forget();
            element.unresolved = 0;
          }
      }

    private:
      /** With the most of that energy in one element. */
      struct WorstStrut
      {
        double       unresolved = 0; ///< J s
        unsigned int strut      = 0;
      };

      /** Of all ranks and, in a run that was resumed, of before. */
      WorstStrut worst() const
      {
        WorstStrut mine = worst_before;
        for (const FilteredElement &element : elements)
          if (element.unresolved > mine.unresolved)
            mine = {element.unresolved, element.strut};
        const double all = layout.largest(mine.unresolved);
        return {all,
                static_cast<unsigned int>(layout.largest(
                  mine.unresolved == all ? double(mine.strut) : 0.))};
      }

      const UnknownLayout         &layout;
      std::vector<FilteredElement> elements;
      double                       unresolved = 0; ///< J s, on this rank
      double                       kinetic    = 0; ///< J s, of all ranks
      LargestInTime                largest;        ///< J, on this rank
      WorstStrut                   worst_before;
    };
  } // namespace

  std::unique_ptr<Watch> make_wave_watch(const Scene     &scene,
                                         const Equations &equations)
  {
    return std::make_unique<WaveWatch>(scene.time.step, equations);
  }
} // namespace auxfem
