#ifndef auxfem_struts_effects_beam_mean_forces_h
#define auxfem_struts_effects_beam_mean_forces_h

#include <auxfem/equations/effect.h>
#include <auxfem/equations/element_batches.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/beam_elements.h>
#include <auxfem/struts/effects/beam_samples.h>

#include <cmath>
#include <cstring>
#include <string>

namespace auxfem
{
  /**
   * What the iterations of a step find of all elements at its start, of several
   * at a time, made once in a step: kept for as long as the start is the same
   * to the last bit.
   */
  template <class OfBatch>
  class StepStarts
  {
  public:
    /**
     * @param from start of the step
     * @param make what there is of an ElementBatch, from which alone and @p from
     *   it follows
     */
    template <class Make>
    void
    update(const State &from, const unsigned int n_elements, const Make &make)
    {
      if (n_elements == this->n_elements && is_of(from))
        return;
      this->n_elements = n_elements;
      displacement     = from.displacement;
      compensation     = *from.compensation;
      rotations        = from.rotations;
      of_batches.clear();
      for_each_batch(n_elements, [&](const ElementBatch &batch) {
        of_batches.push_back(make(batch));
      });
    }

    /** Of batch @p number at the last start. */
    const OfBatch &operator[](const unsigned int number) const
    {
      return of_batches[number];
    }

  private:
    bool is_of(const State &state) const
    {
      return are_same(displacement, state.displacement) &&
        are_same(compensation, *state.compensation) &&
        are_same(rotations, state.rotations);
    }

    /** To the last bit, the sign of zero too. */
    template <class T>
    static bool are_same(const std::vector<T> &one, const std::vector<T> &other)
    {
      return one.size() == other.size() &&
        (one.empty() ||
         std::memcmp(one.data(), other.data(), one.size() * sizeof(T)) == 0);
    }

    Vector                  displacement, compensation;
    std::vector<Quaternion> rotations;
    unsigned int            n_elements = 0;
    std::vector<OfBatch>    of_batches;
  };

  /**
   * Mean forces of beams over a step between two states, of several elements at
   * a time, with the damping of high frequencies. @p Beam is as in BeamForces.
   */
  template <class Beam>
  class BeamMeanForces
  {
  public:
    using Elements = BeamElements<typename Beam::Undamped>;
    using Starts   = StepStarts<typename Beam::StepStart>;

    /** @param high_frequency_damping as in StrutModel */
    BeamMeanForces(const Elements &beams, const double high_frequency_damping)
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
     * Calls @p act with several elements at a time, their energies and their
     * forces, for all.
     * @param starts kept from one evaluation of the step to the next
     */
    template <class Action>
    void for_each_force(const Evaluation        &step,
                        [[maybe_unused]] Starts &starts,
                        const Action            &act) const
    {
      if constexpr (!Beam::is_linear)
        find_starts(step.from, starts);
      for_each_batch(step, [&](const ElementBatch &batch, const auto &damping) {
        Lanes force[n];
        if constexpr (Beam::is_linear)
          act(batch, linear_mean_force(step, batch, damping, force), force);
        else
          {
            const auto energy = Beam::mean_force(beams.shape,
                                                 beams.at_rest(batch),
                                                 starts[batch.number()],
                                                 end(batch, starts, step),
                                                 step.dt,
                                                 damping,
                                                 force);
            act(batch,
                BeamEnergyOf<Lanes>{energy.strain, energy.lost, energy.taken},
                force);
          }
      });
    }

    /** Adds their tangent. */
    void add_tangent(const Evaluation     &step,
                     const Starts         &starts,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const
    {
      for_each_batch(step, [&](const ElementBatch &batch, const auto &damping) {
        Lanes block[n * n];
        Beam::mean_tangent(beams.shape,
                           beams.at_rest(batch),
                           starts[batch.number()],
                           end(batch, starts, step),
                           step.dt,
                           factors,
                           damping,
                           block);
        beams.add_blocks(batch, block, matrix);
      });
    }

    /** What the damping of high frequencies adds to the stiffness factor of a
     * linear tangent. */
    double stiffness_of_damping(const Evaluation &step) const
    {
      return damps_high_frequencies() ? increment_damping(step).in_tangent : 0;
    }

  private:
    static constexpr int order = Beam::order;
    static constexpr int n     = Elements::n;
    /** What the damping of high frequencies remembers of an element. */
    static constexpr int n_increments =
      Beam::is_linear ? n : order * Beam::n_components;

    /** The same on any number of ranks. */
    static unsigned int number_in_lattice(const StrutInterval &interval)
    {
      const auto of_strut = std::lround(1 / (interval.end - interval.begin));
      return interval.strut * of_strut + interval.number();
    }

    /** Of the @p step, without increments. */
    IncrementDampingOf<Lanes> increment_damping(const Evaluation &step) const
    {
      return {high_frequency_damping,
              step.dt,
              step.from.history[length_of_step]};
    }

    /**
     * Calls @p act with batches of all elements and what damps their increments
     * in the @p step between two states.
     */
    template <class Action>
    void for_each_batch(const Evaluation &step, const Action &act) const
    {
      if (!damps_high_frequencies())
        {
          beams.for_each_batch([&](const ElementBatch &batch) {
            act(batch, NoIncrementDamping());
          });
          return;
        }
      IncrementDampingOf<Lanes> damping = increment_damping(step);
      Lanes                     last[n_increments], now[n_increments];
      damping.last                    = last;
      damping.now                     = now;
      step.to.history[length_of_step] = step.dt;
      const auto increments = [&](auto &history, const unsigned int e) {
        return history.data() + first_increment + std::size_t(e) * n_increments;
      };
      beams.for_each_batch([&](const ElementBatch &batch) {
        const auto remembered = batch.each([&](const unsigned int e) {
          return increments(step.from.history, e);
        });
        for (int i = 0; i < n_increments; ++i)
          last[i] =
            each_lane([&](const auto lane) { return remembered[lane][i]; });
        act(batch, damping);
        for (unsigned int lane = 0; lane < batch.size; ++lane)
          take_lane(now,
                    lane,
                    increments(step.to.history, batch.elements[lane]));
      });
    }

    /** Of several elements. */
    auto end(const ElementBatch &batch,
             const Starts       &starts,
             const Evaluation   &step) const
    {
      return Beam::end_of_step(beams.numbering,
                               beams.unknowns(batch),
                               starts[batch.number()],
                               step.to);
    }

    void find_starts(const State &from, Starts &starts) const
    {
      starts.update(from, beams.size(), [&](const ElementBatch &batch) {
        return typename Beam::StepStart(beams.shape,
                                        beams.at_rest(batch),
                                        beams.numbering,
                                        beams.unknowns(batch),
                                        from);
      });
    }

    /** By the forces of mean unknowns, and of what the damping adds to
     * them: increments of unknowns stand for those of strains. */
    template <class HighFrequencyDamping>
    BeamEnergyOf<Lanes>
    linear_mean_force(const Evaluation                            &step,
                      const ElementBatch                          &batch,
                      [[maybe_unused]] const HighFrequencyDamping &damping,
                      Lanes                                       *force) const
    {
      using Motion      = typename Beam::template MotionOf<Lanes>;
      const auto motion = [&](const State &state) {
        return Beam::motion(beams.numbering, beams.unknowns(batch), state);
      };
      const Motion start = motion(step.from), end = motion(step.to);
      Motion       mean           = end;
      const auto   at_rest        = beams.at_rest(batch);
      const auto   internal_force = [&](const Motion &motion, Lanes *force) {
        return Beam::internal_force(beams.shape, at_rest, motion, force);
      };
      const Lanes strain = internal_force(end, force).strain;
      Lanes       taken  = 0;
      for (int i = 0; i < n; ++i)
        {
          mean.u[i] = 0.5 * (start.u[i] + end.u[i]);
          if (Beam::is_damped)
            mean.v[i] = (end.u[i] - start.u[i]) / step.dt;
        }
      if constexpr (HighFrequencyDamping::is_used)
        {
          Motion added{};
          for (int i = 0; i < n; ++i)
            {
              added.u[i] = damping(i, Lanes(end.u[i] - start.u[i]));
              mean.u[i] += added.u[i];
            }
          internal_force(added, force);
          for (int i = 0; i < n; ++i)
            taken += force[i] * (end.u[i] - start.u[i]);
        }
      return {strain, step.dt * internal_force(mean, force).dissipation, taken};
    }

    const Elements &beams;
    const double    high_frequency_damping;
    /** In State::history: increments of the last step, its length. */
    std::size_t first_increment = 0, length_of_step = 0;
  };
} // namespace auxfem

#endif
