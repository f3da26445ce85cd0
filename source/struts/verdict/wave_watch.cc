#include <auxfem/model/load_history.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/text.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Fraction of the kinetic energy in the highest degree of bending above
     * which results are doubtful.
     * @tuned measured: the tip of a shaken cantilever errs by 9 %
     * (tests/struts/verdict/wave_watch_test.cc)
     */
    constexpr double doubtful_fraction = 1e-3;

    /**
     * Fraction of the kinetic energy in the highest degree of bending above
     * which results are unusable.
     * @tuned measured: the tip errs by more than 20 %
     */
    constexpr double unusable_fraction = 0.01;

    /** Nodal weights of the highest Legendre coefficient of a polynomial that
     * is given by its values at the nodes. */
    std::vector<double> highest_coefficients(const unsigned int order)
    {
      const std::vector<double> nodes = LineRule(order).nodes;
      // The leading coefficient of the Legendre polynomial is (2p - 1)!! / p!.
      double inverse_of_leading = 1;
      for (unsigned int i = 1; i <= order; ++i)
        inverse_of_leading *= i / (2. * i - 1);
      std::vector<double> coefficients(nodes.size(), inverse_of_leading);
      for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t b = 0; b < nodes.size(); ++b)
          if (a != b)
            coefficients[a] /= nodes[a] - nodes[b];
      return coefficients;
    }

    /** Element with mass. */
    struct MovingElement
    {
      const int   *rotations; ///< unknowns of the first node
      unsigned int strut;
      /** Kinetic energy (J) of a rotation rate of 1 rad/s in the highest
       * degree: half its mass times (h / (4p + 2))^2 / (2p + 3). */
      double energy;
    };

    /** Elements with mass of one order. */
    struct MovingElements
    {
      std::vector<double>        coefficients; ///< highest_coefficients()
      std::vector<MovingElement> list;
    };

    /** Elements with mass that this rank owns. */
    MovingElements moving_elements(const LatticeModel        &model,
                                   const DofNumbering::Group &group)
    {
      MovingElements     elements{highest_coefficients(group.order), {}};
      const unsigned int p = group.order;
      for (unsigned int e = group.begin; e < group.end; ++e)
        {
          const DofNumbering::Element &element = model.numbering.elements()[e];
          const Strut   &strut   = model.lattice.struts[element.interval.strut];
          const Section &section = model.sections[strut.section];
          const double   mass_per_length = section.mass_per_length();
          if (!element.is_owned || mass_per_length == 0)
            continue;
          const double length = model.lattice.length(strut) *
            (element.interval.end - element.interval.begin);
          const double amplitude = length / (4 * p + 2);
          elements.list.push_back(
            {model.numbering.element_unknowns(e) + model.lattice.dimension,
             element.interval.strut,
             mass_per_length * length / 2 * amplitude * amplitude /
               (2 * p + 3)});
        }
      return elements;
    }

    /**
     * Checks for bending waves that are too short for the elements. The
     * rotations of an element of order p define its bending up to degree p + 1.
     * In a plane wave the energy fraction in that degree grows as (kh)^(2p+2);
     * rigid rotation has none. The sum over sampled steps is compared with the
     * total kinetic energy.
     */
    class WaveWatch : public Watch
    {
    public:
      explicit WaveWatch(const WatchContext &run)
        : Watch(SamplingRate::bursts)
        , equations(run.equations)
        , n_components(run.equations.model().numbering.n_components())
        , n_rotations(n_components - run.equations.model().lattice.dimension)
        , unresolved(run.statistics.number("waves: energy not resolved (J s)"))
        , kinetic(run.statistics.number("waves: kinetic energy (J s)"))
        , largest_energy(run.statistics.number("waves: largest energy (J)"))
        , strut_energies(run.statistics.occurrences("waves"))
      {
        for (const auto &group : run.equations.model().numbering.groups())
          elements.push_back(moving_elements(run.equations.model(), group));
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        LocatedEvent largest{0., step.to.time, invalid_index};
        double       step_energy = 0;
        for (const MovingElements &group : elements)
          for (const MovingElement &element : group.list)
            {
              const double energy =
                energy_of(element, group.coefficients, *step.to.velocity);
              step_energy += energy;
              if (energy > largest.size)
                {
                  largest.size   = energy;
                  largest.number = element.strut;
                }
            }
        if (largest.size > 0)
          strut_energies.add(largest);
        unresolved += equations.unknowns().layout.sum(step_energy) * step.dt;
        const Energies &energies = step.to.energies;
        largest_energy =
          std::max(largest_energy, energies.kinetic() + energies.stored());
        kinetic +=
          std::max(energies.kinetic(), noticeable_fraction * largest_energy) *
          step.dt;
      }

      std::vector<Finding> findings() const override
      {
        const auto   largest  = strut_energies.largest();
        const double fraction = unresolved / kinetic;
        if (!(fraction > doubtful_fraction))
          return {};
        const std::string location = "strut " + std::to_string(largest->number);
        std::ostringstream text;
        text
          << "Struts vibrate in waves that are too short for their elements, "
             "mainly in "
          << location << ": " << percentage_text(std::min(1., fraction))
          << " of the kinetic energy is in the highest degree of their "
             "bending, more than "
          << percentage_text(doubtful_fraction)
          << ". The frequencies of these vibrations are inaccurate. Raise "
             "Discretization/Order or Discretization/Global refinements, "
             "and compare.";
        return {{fraction > unusable_fraction ? Verdict::not_to_be_used
                                              : Verdict::doubtful,
                 text.str(),
                 largest->time,
                 location}};
      }

    private:
      /** Kinetic energy of an element in the highest degree (J). */
      double energy_of(const MovingElement       &element,
                       const std::vector<double> &coefficients,
                       const Vector              &velocity) const
      {
        std::array<double, 3> rate{};
        const int            *unknowns = element.rotations;
        for (const double coefficient : coefficients)
          {
            for (unsigned int c = 0; c < n_rotations; ++c)
              rate[c] += coefficient * velocity[unknowns[c]];
            unknowns += n_components;
          }
        return element.energy *
          (rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2]);
      }

      const Equations            &equations;
      const unsigned int          n_components, n_rotations;
      std::vector<MovingElements> elements;
      double                     &unresolved, &kinetic; ///< J s
      double                     &largest_energy;       ///< J
      EventExtremes              &strut_energies;       ///< J
    };
  } // namespace

  std::unique_ptr<Watch> make_wave_watch(const WatchContext &run)
  {
    return std::make_unique<WaveWatch>(run);
  }
} // namespace auxfem
