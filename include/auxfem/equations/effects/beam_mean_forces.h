#ifndef auxfem_equations_effects_beam_mean_forces_h
#define auxfem_equations_effects_beam_mean_forces_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/elements/increment_damping.h>
#include <auxfem/equations/effect.h>
#include <auxfem/equations/effects/beam_elements.h>
#include <auxfem/equations/effects/beam_samples.h>
#include <auxfem/equations/effects/step_starts.h>

#include <cmath>
#include <string>

namespace auxfem
{
  /**
   * Mean forces of beams over a step between two states, with the damping of
   * high frequencies. @p Beam is as in BeamForces.
   */
  template <class Beam>
  class BeamMeanForces
  {
  public:
    using Starts = StepStarts<typename Beam::StepStart>;

    /** @param high_frequency_damping as in StrutModel */
    BeamMeanForces(const BeamElements<Beam> &beams,
                   const double              high_frequency_damping)
      : beams(beams)
      , high_frequency_damping(high_frequency_damping)
    {}

    bool damps_high_frequencies() const
    {
      return high_frequency_damping > 0;
    }

    /** Makes room for what the damping of high frequencies remembers. */
    void register_in(StateLayout &layout)
    {
      if (!damps_high_frequencies())
        return;
      const std::string name = "struts of order " + std::to_string(order);
      std::vector<unsigned int> numbers;
      numbers.reserve(beams.size());
      for (unsigned int e = 0; e < beams.size(); ++e)
        numbers.push_back(number_in_lattice(beams.interval(e)));
      first_increment =
        layout.history.keep(name + ": increments", numbers, n_increments);
      length_of_step = layout.history.keep(name + ": length of the last step",
                                           {0},
                                           /*values_per_item=*/1);
    }

    /**
     * Calls @p act with every element, its energies and its force.
     * @param starts kept from one evaluation of the step to the next
     */
    template <class Action>
    void for_each_force(const Evaluation        &step,
                        [[maybe_unused]] Starts &starts,
                        const Action            &act) const
    {
      if constexpr (!Beam::is_linear)
        find_starts(step.from, starts);
      with_damping_of_increments(step, [&](const auto &damping_of) {
        for (unsigned int e = 0; e < beams.size(); ++e)
          {
            double force[n];
            if constexpr (Beam::is_linear)
              {
                const BeamEnergy energy =
                  linear_mean_force(step, e, damping_of(e), force);
                act(e, energy, force);
              }
            else
              {
                const auto energy = Beam::mean_force(beams.shape,
                                                     beams[e].at_rest,
                                                     beams.numbering,
                                                     beams.unknowns(e),
                                                     starts[e],
                                                     step,
                                                     damping_of(e),
                                                     force);
                act(e,
                    BeamEnergy{energy.strain, energy.lost, energy.taken},
                    force);
              }
          }
      });
    }

    /** Adds their tangent. */
    void add_tangent(const Evaluation     &step,
                     const Starts         &starts,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const
    {
      with_damping_of_increments(step, [&](const auto &damping_of) {
        double block[n * n];
        for (unsigned int e = 0; e < beams.size(); ++e)
          {
            Beam::mean_tangent(beams.shape,
                               beams[e].at_rest,
                               beams.numbering,
                               beams.unknowns(e),
                               starts[e],
                               step,
                               factors,
                               damping_of(e),
                               block);
            matrix.add(beams.group.begin + e, block);
          }
      });
    }

    /** What the damping of high frequencies adds to the stiffness factor of a
     * linear tangent. */
    double stiffness_of_damping(const Evaluation &step) const
    {
      double of_damping = 0;
      with_damping_of_increments(step, [&](const auto &damping_of) {
        if constexpr (decltype(damping_of(0))::is_used)
          of_damping = damping_of(0).in_tangent;
      });
      return of_damping;
    }

  private:
    static constexpr int order = Beam::order;
    static constexpr int n     = BeamElements<Beam>::n;
    /** What the damping of high frequencies remembers of an element. */
    static constexpr int n_increments =
      Beam::is_linear ? n : order * Beam::n_components;

    /** The same on any number of ranks. */
    static unsigned int number_in_lattice(const StrutMesh::Interval &interval)
    {
      const auto of_strut = std::lround(1 / (interval.end - interval.begin));
      return interval.strut * of_strut + interval.number();
    }

    /**
     * Calls @p act with a function of an element that says how the increments in
     * the @p step between two states are damped.
     */
    template <class Action>
    void with_damping_of_increments(const Evaluation &step,
                                    const Action     &act) const
    {
      if (!damps_high_frequencies())
        {
          act([](unsigned int) { return NoIncrementDamping(); });
          return;
        }
      IncrementDamping damping(high_frequency_damping,
                               step.dt,
                               step.from.history[length_of_step]);
      step.to.history[length_of_step] = step.dt;
      act([&](const unsigned int e) {
        const std::size_t at = first_increment + std::size_t(e) * n_increments;
        damping.last         = step.from.history.data() + at;
        damping.now          = step.to.history.data() + at;
        return damping;
      });
    }

    void find_starts(const State &from, Starts &starts) const
    {
      starts.update(from, beams.size(), [&](const unsigned int e) {
        return typename Beam::StepStart(beams.shape,
                                        beams[e].at_rest,
                                        beams.numbering,
                                        beams.unknowns(e),
                                        from);
      });
    }

    /** By the forces of mean unknowns, and of what the damping adds to
     * them: increments of unknowns stand for those of strains. */
    template <class HighFrequencyDamping>
    BeamEnergy
    linear_mean_force(const Evaluation                            &step,
                      const unsigned int                           e,
                      [[maybe_unused]] const HighFrequencyDamping &damping,
                      double                                      *force) const
    {
      using Motion              = typename Beam::Motion;
      const Motion start        = beams.motion(e, step.from),
                   end          = beams.motion(e, step.to);
      Motion     mean           = end;
      const auto internal_force = [&](const Motion &motion, double *force) {
        return Beam::internal_force(beams.shape,
                                    beams[e].at_rest,
                                    motion,
                                    force);
      };
      const double strain = internal_force(end, force).strain;
      double       taken  = 0;
      for (int i = 0; i < n; ++i)
        {
          mean.u[i] = (start.u[i] + end.u[i]) / 2;
          if (Beam::is_damped)
            mean.v[i] = (end.u[i] - start.u[i]) / step.dt;
        }
      if constexpr (HighFrequencyDamping::is_used)
        {
          Motion added{};
          for (int i = 0; i < n; ++i)
            {
              added.u[i] = damping(i, end.u[i] - start.u[i]);
              mean.u[i] += added.u[i];
            }
          internal_force(added, force);
          for (int i = 0; i < n; ++i)
            taken += force[i] * (end.u[i] - start.u[i]);
        }
      return {strain, step.dt * internal_force(mean, force).dissipation, taken};
    }

    const BeamElements<Beam> &beams;
    const double              high_frequency_damping;
    /** In State::history: increments of the last step, its length. */
    std::size_t first_increment = 0, length_of_step = 0;
  };
} // namespace auxfem

#endif
