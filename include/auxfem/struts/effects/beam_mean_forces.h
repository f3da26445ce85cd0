#ifndef auxfem_struts_effects_beam_mean_forces_h
#define auxfem_struts_effects_beam_mean_forces_h

#include <auxfem/equations/effect.h>
#include <auxfem/equations/element_batches.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/beam_elements.h>
#include <auxfem/struts/effects/beam_samples.h>
#include <auxfem/struts/effects/law_sections.h>

#include <cmath>
#include <cstring>
#include <string>

namespace auxfem
{
  /**
   * Data of all elements at the start of a step, one BatchData per batch.
   * BeamMeanForces computes it once a step: it stays valid while the start is
   * bitwise the same.
   */
  template <class BatchData>
  class StepStarts
  {
  public:
    /**
     * @param from start of the step
     * @param make computes the data of an ElementBatch from @p from alone
     */
    template <class Make>
    void
    update(const State &from, const unsigned int n_elements, const Make &make)
    {
      if (n_elements == this->n_elements && matches(from))
        return;
      this->n_elements = n_elements;
      displacement     = from.displacement;
      compensation     = *from.compensation;
      rotations        = from.rotations;
      batch_data.clear();
      for_each_batch(n_elements, [&](const ElementBatch &batch) {
        batch_data.push_back(make(batch));
      });
    }

    /** Data of batch @p number at the last start. */
    const BatchData &operator[](const unsigned int number) const
    {
      return batch_data[number];
    }

  private:
    bool matches(const State &state) const
    {
      return bitwise_equal(displacement, state.displacement) &&
        bitwise_equal(compensation, *state.compensation) &&
        bitwise_equal(rotations, state.rotations);
    }

    /** Bitwise comparison: distinguishes the sign of zero. */
    template <class T>
    static bool bitwise_equal(const std::vector<T> &one,
                              const std::vector<T> &other)
    {
      return one.size() == other.size() &&
        (one.empty() ||
         std::memcmp(one.data(), other.data(), one.size() * sizeof(T)) == 0);
    }

    Vector                  displacement, compensation;
    std::vector<Quaternion> rotations;
    unsigned int            n_elements = 0;
    std::vector<BatchData>  batch_data;
  };

  /**
   * Mean forces of beams over a step by the discrete gradient, with the damping
   * of high frequencies, for several elements at a time. @p Beam and @p
   * Sections are as in BeamForces.
   */
  template <class Beam, class Sections>
  class BeamMeanForces
  {
  public:
    using Elements = BeamElements<typename Beam::Undamped>;
    using Starts   = StepStarts<typename Beam::StepStart>;

    /** @param high_frequency_damping as in StrutModel */
    BeamMeanForces(const Elements &beams,
                   const Sections &sections,
                   const double    high_frequency_damping)
      : beams(beams)
      , sections(sections)
      , high_frequency_damping(high_frequency_damping)
    {}

    bool damps_high_frequencies() const
    {
      return high_frequency_damping > 0;
    }

    /** Registers the increments that the damping of high frequencies stores in
     * State::history. */
    void register_in(StateLayout &layout)
    {
      if (!damps_high_frequencies())
        return;
      const std::string name = beams.record_name();
      first_increment        = layout.history.keep(name + ": increments",
                                            beams.numbers_in_lattice(),
                                            n_increments);
      length_of_step = layout.history.keep(name + ": length of the last step",
                                           {0},
                                           /*values_per_item=*/1);
    }

    /**
     * Calls @p act with batches of elements, their energies and their forces.
     * @param starts cache that persists over the evaluations of a step
     */
    template <class Action>
    void for_each_force(const Evaluation        &step,
                        [[maybe_unused]] Starts &starts,
                        const Action            &act) const
    {
      if constexpr (!Beam::is_linear)
        find_starts(step.from, starts);
      const auto sections_in_step = sections.in(step, SectionPurpose::forces);
      for_each_batch(step, [&](const ElementBatch &batch, const auto &damping) {
        Lanes       force[n];
        const auto &at_rest = beams.at_rest(batch);
        const auto  section = sections_in_step(batch, at_rest);
        if constexpr (Beam::is_linear)
          act(batch,
              linear_mean_force(step, batch, section, damping, force),
              force);
        else
          {
            const auto energy = Beam::mean_force(beams.shape,
                                                 at_rest,
                                                 section,
                                                 starts[batch.number()],
                                                 end(batch, starts, step),
                                                 step.dt,
                                                 damping,
                                                 force);
            act(batch,
                BeamEnergyOf<Lanes>{energy.strain,
                                    energy.dissipation,
                                    energy.numerical_dissipation},
                force);
          }
      });
    }

    /** Adds the tangent of the mean forces. */
    void add_tangent(const Evaluation     &step,
                     const Starts         &starts,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const
    {
      const auto sections_in_step = sections.in(step, SectionPurpose::tangent);
      for_each_batch(step, [&](const ElementBatch &batch, const auto &damping) {
        Lanes       block[n * n];
        const auto &at_rest = beams.at_rest(batch);
        Beam::mean_tangent(beams.shape,
                           at_rest,
                           sections_in_step(batch, at_rest),
                           starts[batch.number()],
                           end(batch, starts, step),
                           step.dt,
                           factors,
                           damping,
                           block);
        beams.add_blocks(batch, block, matrix);
      });
    }

    /** Contribution of the damping of high frequencies to the stiffness factor
     * of a linear tangent. */
    double stiffness_of_damping(const Evaluation &step) const
    {
      return damps_high_frequencies() ? increment_damping(step).tangent_factor
                                      : 0;
    }

  private:
    static constexpr int order = Beam::order;
    static constexpr int n     = Elements::n;
    /** Number of increments that the damping of high frequencies stores per
     * element. */
    static constexpr int n_increments =
      Beam::is_linear ? n : order * Beam::n_components;

    /** Damping of the @p step; its increments are not set. */
    IncrementDampingOf<Lanes> increment_damping(const Evaluation &step) const
    {
      return {high_frequency_damping,
              step.dt,
              step.from.history[length_of_step]};
    }

    /**
     * Calls @p act with all batches and the damping of their increments in the
     * @p step.
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
      damping.previous_increments     = last;
      damping.current_increments      = now;
      step.to.history[length_of_step] = step.dt;
      const auto increments = [&](auto &history, const unsigned int e) {
        return history.data() + first_increment + std::size_t(e) * n_increments;
      };
      beams.for_each_batch([&](const ElementBatch &batch) {
        const auto previous = batch.each([&](const unsigned int e) {
          return increments(step.from.history, e);
        });
        for (int i = 0; i < n_increments; ++i)
          last[i] =
            make_lanes([&](const auto lane) { return previous[lane][i]; });
        act(batch, damping);
        for (unsigned int lane = 0; lane < batch.size; ++lane)
          copy_lane(now,
                    lane,
                    increments(step.to.history, batch.elements[lane]));
      });
    }

    /** Displacements of @p batch at the end of the @p step. */
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

    /** Linear mean force: the internal force of the mean unknowns. The damping
     * of high frequencies uses increments of unknowns instead of strains. */
    template <class Section, class HighFrequencyDamping>
    BeamEnergyOf<Lanes>
    linear_mean_force(const Evaluation                            &step,
                      const ElementBatch                          &batch,
                      const Section                               &section,
                      [[maybe_unused]] const HighFrequencyDamping &damping,
                      Lanes                                       *force) const
    {
      using Motion      = typename Beam::template MotionOf<Lanes>;
      const auto motion = [&](const State &state) {
        return Beam::motion(beams.numbering, beams.unknowns(batch), state);
      };
      const Motion start = motion(step.from), end = motion(step.to);
      Motion       mean          = end;
      const auto   at_rest       = beams.at_rest(batch);
      const auto   elastic_force = [&](const Motion &motion, Lanes *force) {
        return Beam::internal_force(beams.shape,
                                    at_rest,
                                    Beam::elastic_section(at_rest),
                                    motion,
                                    force);
      };
      Lanes numerical_dissipation = 0;
      for (int i = 0; i < n; ++i)
        {
          mean.u[i] = 0.5 * (start.u[i] + end.u[i]);
          if (Beam::is_damped)
            mean.v[i] = (end.u[i] - start.u[i]) / step.dt;
        }
      [[maybe_unused]] Lanes added_force[n];
      if constexpr (HighFrequencyDamping::is_used)
        {
          Motion added{};
          for (int i = 0; i < n; ++i)
            added.u[i] = damping(i, Lanes(end.u[i] - start.u[i]));
          elastic_force(added, added_force);
          for (int i = 0; i < n; ++i)
            numerical_dissipation += added_force[i] * (end.u[i] - start.u[i]);
        }
      BeamEnergyOf<Lanes> energy =
        Beam::internal_force(beams.shape, at_rest, section, mean, force);
      if constexpr (Sections::is_elastic)
        {
          Lanes end_force[n];
          energy.strain = elastic_force(end, end_force).strain;
        }
      for (int i = 0; i < n && HighFrequencyDamping::is_used; ++i)
        force[i] += added_force[i];
      return {energy.strain,
              step.dt * energy.dissipation,
              numerical_dissipation};
    }

    const Elements &beams;
    const Sections &sections;
    const double    high_frequency_damping;
    /** Positions in State::history: increments and length of the last step. */
    std::size_t first_increment = 0, length_of_step = 0;
  };
} // namespace auxfem

#endif
