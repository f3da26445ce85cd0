#ifndef auxfem_equations_effects_beam_damping_work_h
#define auxfem_equations_effects_beam_damping_work_h

#include <auxfem/equations/effect.h>
#include <auxfem/equations/effects/beam_elements.h>
#include <auxfem/equations/effects/struts.h>

#include <utility>

namespace auxfem
{
  /** Section forces of damping at the Gauss points of elements at an end of a
   * step. */
  template <class Beam>
  struct ViscousForces
  {
    /** @param mean_velocity of the step. */
    ViscousForces(const BeamElements<typename Beam::Undamped>   &beams,
                  const ElementBatch                            &batch,
                  const typename Beam::template AtRestOf<Lanes> &at_rest,
                  const State                                   &state,
                  const Vector                                  &mean_velocity)
    {
      using Motion      = typename Beam::template MotionOf<Lanes>;
      const auto motion = [&](const Vector &velocity) {
        return Beam::motion(beams.numbering,
                            beams.unknowns(batch),
                            state,
                            velocity.data());
      };
      const Motion motions[] = {motion(*state.velocity), motion(mean_velocity)};
      Beam::viscous_forces(beams.shape, at_rest, motions, of_motions);
    }

    /** At a Gauss point: by the velocities there, and by those that the
     * step's own motion has there. */
    std::pair<const SectionForcesOf<Lanes> &, const SectionForcesOf<Lanes> &>
    at(const int g) const
    {
      return {of_motions[0][g], of_motions[1][g]};
    }

  private:
    SectionForcesOf<Lanes> of_motions[2][Beam::order];
  };

  /** What damping does in a step (J). */
  struct DampingWork
  {
    double lost      = 0; ///< by the mean strain rates of the step
    double of_forces = 0; ///< by the mean of the forces at both ends
  };

  /** That of all beams counted by this rank, each a @p Beam. */
  template <class Beam>
  DampingWork damping_work(const BeamElements<typename Beam::Undamped> &beams,
                           const Evaluation                            &step,
                           const StepMotion                            &motion)
  {
    // Without inertia the rates at the end are those of the first step.
    const bool ends_alike =
      step.kind == Evaluation::Kind::static_step && !step.from.before;
    DampingWork work;
    beams.for_each_batch([&](const ElementBatch &batch) {
      const auto                at_rest = beams.at_rest(batch);
      const auto               &beta    = at_rest.stiffness.damping_time;
      const ViscousForces<Beam> start(beams,
                                      batch,
                                      at_rest,
                                      step.from,
                                      motion.rate),
        end(beams, batch, at_rest, step.to, motion.rate);
      const auto product = [&](const SectionForcesOf<Lanes> &one,
                               const SectionForcesOf<Lanes> &other) {
        return Beam::strain_product(at_rest.stiffness, one, other);
      };
      Lanes lost = 0, of_forces = 0;
      for (int g = 0; g < Beam::order; ++g)
        {
          const Lanes factor =
            beams.shape.weight[g] * at_rest.jacobian * step.dt / beta;
          const auto [at_start, along_start] = start.at(g);
          const auto [at_end, along_end]     = end.at(g);
          SectionForcesOf<Lanes> mean        = at_end;
          if (!ends_alike)
            for (unsigned int k = 0; k < mean.size(); ++k)
              mean[k] = (mean[k] + at_start[k]) / 2;
          lost += factor * product(mean, mean);
          of_forces += factor / 2 *
            (product(at_start, along_start) + product(at_end, along_end));
        }
      for (unsigned int lane = 0; lane < batch.size; ++lane)
        if (beams[batch.elements[lane]].owned && number_in(beta, lane) != 0)
          {
            work.lost += number_in(lost, lane);
            work.of_forces += number_in(of_forces, lane);
          }
    });
    return work;
  }
} // namespace auxfem

#endif
