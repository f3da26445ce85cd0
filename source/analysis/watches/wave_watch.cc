#include <auxfem/analysis/node_masses.h>
#include <auxfem/analysis/occurrences.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/time/largest_in_time.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string wave_record = "watch: short waves";

    /** Part of the kinetic energy in bending waves shorter than elements
     * resolve. */
    constexpr double doubtful_wave_energy = 0.05;

    /** Filters need every look, their energies do not. */
    constexpr unsigned int looks_between_energies = 4;

    /**
     * Wave number times length of an element of @p order up to which the
     * frequency of bending waves is met to about a twentieth, also at clamped
     * ends (doc/theory.md).
     */
    double resolved_phase(const unsigned int order)
    {
      return order == 1 ? 0.6 : 2. * (order - 1);
    }

    /**
     * Of struts whose ends move at frequencies at which the bending waves in
     * them are shorter than their elements resolve. Velocities pass twice
     * through a filter that keeps what is faster than that.
     */
    class WaveWatch : public Watch
    {
    public:
      WaveWatch(const Scene &scene, const Equations &equations)
        : model(equations.model())
        , layout(equations.unknowns().layout)
        , filter_of(layout.n_local(), -1)
        , velocities(layout.n_local(), 0.)
        , fast(layout.n_local(), 0.)
      {
        for (unsigned int e = 0; e < model.numbering.elements().size(); ++e)
          if (model.numbering.elements()[e].is_owned)
            add_element(e);
        double largest = 0;
        for (const Filter &filter : filters)
          largest = std::max(largest, filter.limit);
        largest = layout.largest(largest);
        if (largest > 0)
          steps_between_looks = std::max(1., 1 / (largest * scene.time.step));
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        if (last_displacement.size() != step.to.displacement.size())
          remember(step.from);
        if (++n_steps < steps_between_looks)
          return;
        const double dt = step.to.time - last_time;
        filter(last_displacement, step.to.displacement, dt);
        if (++n_looks % looks_between_energies == 0)
          add_energies(step.to, dt);
        remember(step.to);
      }

      std::vector<Finding> findings() const override
      {
        Occurrences worst;
        double      of_fast = 0;
        for (const Element &element : elements)
          {
            of_fast += element.fast;
            worst.add({element.fast, 0., strut_of(element)});
          }
        const std::vector<double> sums =
          layout.sum(std::vector<double>{of_fast, all});
        const auto worst_of_all = worst.largest_of_all(layout.communicator());
        if (!worst_of_all || sums[0] <= doubtful_wave_energy * sums[1])
          return {};
        const std::string location =
          "strut " + std::to_string(worst_of_all->number);
        std::ostringstream text;
        text.precision(2);
        text << "The elements are long for the motion: "
             << 100 * sums[0] / sums[1]
             << " % of the kinetic energy move so fast that the bending waves "
                "of struts are shorter than their elements resolve, most in "
             << location
             << ". Raise Discretization/Order, or set one more of Global "
                "refinements, and compare.";
        return {{Verdict::doubtful,
                 text.str(),
                 fastest.of_all_ranks(layout).time,
                 location}};
      }

      void save(Records &records) const override
      {
        std::vector<unsigned int> items;
        std::vector<double>       energies;
        for (const Element &element : elements)
          {
            items.push_back(item_of(element));
            energies.push_back(element.fast);
          }
        const LargestInTime largest = fastest.of_all_ranks(layout);
        records.keep(wave_record + ": elements", items, 1, energies);
        records.keep(wave_record,
                     {layout.sum(all), largest.value, largest.time});
      }

      void resume(const Records &records) override
      {
        std::vector<unsigned int> items;
        for (const Element &element : elements)
          items.push_back(item_of(element));
        const std::vector<double> energies =
          records.values(wave_record + ": elements", items, 1);
        for (std::size_t i = 0; i < elements.size(); ++i)
          elements[i].fast = energies[i];
        const std::vector<double> values = records.values(wave_record, 3);
        // Sums go on on one rank.
        all     = layout.rank() == 0 ? values[0] : 0;
        fastest = {values[1], values[2]};
      }

    private:
      /** An element that this rank counts. */
      struct Element
      {
        unsigned int        number; ///< of the numbering
        SpaceVector         span;   ///< of its ends at rest (m)
        std::vector<double> masses; ///< kg, of its nodes
        double fast = 0; ///< of MotionEnergies, summed up over time (J s)
      };

      /** Of the velocity (m/s) of a local unknown. */
      struct Filter
      {
        int    unknown;
        double limit; ///< rad/s, up to which waves are resolved
        double slow      = 0,
               slow_rest = 0; ///< what the first, the second keep back
      };

      /** Kinetic energies of an element, times two (J). */
      struct MotionEnergies
      {
        double fast; ///< of motion across it, beyond the limit
        double all;
      };

      void add_element(const unsigned int e)
      {
        const DofNumbering::Element &element = model.numbering.elements()[e];
        const Strut     &strut   = model.lattice.struts[element.interval.strut];
        const Section   &section = model.sections[strut.section];
        dealii::Point<3> ends[2];
        for (unsigned int end = 0; end < 2; ++end)
          {
            SpaceVector tangent;
            model.lattice.axis(strut,
                               element.interval.at(end == 0 ? -1 : 1),
                               ends[end],
                               tangent);
          }
        elements.push_back({e, ends[1] - ends[0], node_masses(model, e)});
        const double length = model.lattice.length(strut) *
          (element.interval.end - element.interval.begin),
                     bending = model.lattice.dimension == 2
          ? section.bending_stiffness_3()
          : std::min(section.bending_stiffness_2(),
                     section.bending_stiffness_3());
        // Bending waves: omega = k^2 sqrt(EI / rho A).
        const double limit =
          std::pow(resolved_phase(element.order) / length, 2) *
          std::sqrt(bending / section.mass_per_length());
        for (unsigned int a = 0; a <= element.order; ++a)
          for (unsigned int c = 0; c < model.lattice.dimension; ++c)
            add_filter(model.numbering.element_unknowns(
                         e)[model.numbering.n_components() * a + c],
                       limit);
      }

      void add_filter(const int unknown, const double limit)
      {
        if (filter_of[unknown] < 0)
          {
            filter_of[unknown] = filters.size();
            filters.push_back({unknown, limit});
          }
        Filter &filter = filters[filter_of[unknown]];
        filter.limit   = std::min(filter.limit, limit);
      }

      /** The state of a look. */
      void remember(const State &state)
      {
        last_displacement = state.displacement;
        last_time         = state.time;
        n_steps           = 0;
      }

      void add_energies(const State &state, const double dt)
      {
        double sum = 0;
        for (Element &element : elements)
          {
            const MotionEnergies energies = energies_of(element, state);
            element.fast += energies.fast * dt;
            all += energies.all * dt;
            sum += energies.fast;
          }
        fastest.add(sum, state.time);
      }

      /** @param dt between both displacements (s) */
      void filter(const Vector &from, const Vector &to, const double dt)
      {
        for (Filter &filter : filters)
          {
            const int    i        = filter.unknown;
            const double velocity = (to[i] - from[i]) / dt,
                         part     = 1 / (1 + 1 / (filter.limit * dt));
            if (!is_started)
              filter.slow = velocity;
            filter.slow += part * (velocity - filter.slow);
            const double rest = velocity - filter.slow;
            filter.slow_rest += part * (rest - filter.slow_rest);
            velocities[i] = velocity;
            fast[i]       = rest - filter.slow_rest;
          }
        is_started = true;
      }

      MotionEnergies energies_of(const Element &element,
                                 const State   &state) const
      {
        const DofNumbering &numbering = model.numbering;
        const unsigned int  dimension = model.lattice.dimension,
                           stride     = numbering.n_components();
        const int *const unknowns = numbering.element_unknowns(element.number);
        SpaceVector      chord    = element.span;
        for (unsigned int c = 0; c < dimension; ++c)
          chord[c] += state.displacement[unknowns[stride + c]] -
            state.displacement[unknowns[c]];
        const double   square = chord.norm_square();
        MotionEnergies energies{0, 0};
        for (unsigned int a = 0; a < element.masses.size(); ++a)
          {
            double along = 0, fast_square = 0, velocity_square = 0;
            for (unsigned int c = 0; c < dimension; ++c)
              {
                const int i = unknowns[stride * a + c];
                along += fast[i] * chord[c];
                fast_square += fast[i] * fast[i];
                velocity_square += velocities[i] * velocities[i];
              }
            energies.fast +=
              element.masses[a] * (fast_square - along * along / square);
            energies.all += element.masses[a] * velocity_square;
          }
        return energies;
      }

      unsigned int strut_of(const Element &element) const
      {
        return model.numbering.elements()[element.number].interval.strut;
      }

      /** A number of its own among all ranks. */
      unsigned int item_of(const Element &element) const
      {
        const StrutMesh::Interval &interval =
          model.numbering.elements()[element.number].interval;
        return interval.strut *
          std::lround(1 / (interval.end - interval.begin)) +
          interval.number();
      }

      const LatticeModel  &model;
      const UnknownLayout &layout;
      std::vector<Element> elements;
      std::vector<Filter>  filters;
      /** As many as let waves at the limit go on by about a radian. */
      unsigned int  steps_between_looks = 1;
      unsigned int  n_steps = 0, n_looks = 0;
      bool          is_started = false; ///< the filters
      Vector        last_displacement;  ///< m, at the last look
      double        last_time = 0;      ///< s
      double        all       = 0;      ///< of MotionEnergies, over time (J s)
      LargestInTime fastest; ///< of MotionEnergies, of all elements (J)
      /** @name By local unknown. */
      ///@{
      std::vector<int>    filter_of;
      std::vector<double> velocities, fast; ///< m/s
      ///@}
    };
  } // namespace

  std::unique_ptr<Watch> make_wave_watch(const Scene     &scene,
                                         const Equations &equations)
  {
    return std::make_unique<WaveWatch>(scene, equations);
  }
} // namespace auxfem
