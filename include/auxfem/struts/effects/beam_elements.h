#ifndef auxfem_struts_effects_beam_elements_h
#define auxfem_struts_effects_beam_elements_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/equations/effect.h>
#include <auxfem/equations/element_batches.h>
#include <auxfem/model/numbering.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/struts/section.h>

#include <utility>

namespace auxfem
{
  /**
   * Elements of struts as beams of one kind, each by itself and several of them
   * at a time. @p Beam is as in BeamForces, without damping.
   */
  template <class Beam>
  class BeamElements
  {
  public:
    static constexpr int order        = Beam::order;
    static constexpr int n_components = Beam::n_components;
    static constexpr int n            = n_components * (order + 1);

    using AtRest        = typename Beam::AtRest;
    using AtRestInLanes = typename Beam::template AtRestOf<Lanes>;

    struct Element
    {
      double length; ///< of the strut (m)
      bool   owned;
    };

    /** @param group of the elements of @p numbering. */
    BeamElements(const Lattice              &lattice,
                 const DofNumbering         &numbering,
                 const DofNumbering::Group  &group,
                 const std::vector<Section> &sections,
                 const bool                  shear_flexibility)
      : lattice(lattice)
      , numbering(numbering)
      , group(group)
      , sections(sections)
      , shear(shear_flexibility ? 0. : shear_to_make_up_for())
      , shape(shear)
    {
      const unsigned int n_elements = group.end - group.begin;
      of_elements.reserve(n_elements);
      for (unsigned int e = 0; e < n_elements; ++e)
        of_elements.push_back({lattice.length(strut(e)),
                               numbering.elements()[group.begin + e].is_owned});
      batches_at_rest.reserve((n_elements + n_lanes - 1) / n_lanes);
      for_each_batch([&](const ElementBatch &batch) {
        batches_at_rest.push_back(in_lanes<AtRestInLanes>(
          batch.each([&](const unsigned int e) { return make_at_rest(e); })));
      });
    }

    unsigned int size() const
    {
      return of_elements.size();
    }

    const Element &operator[](const unsigned int e) const
    {
      return of_elements[e];
    }

    /** Local unknowns of element @p e of the group. */
    const int *unknowns(const unsigned int e) const
    {
      return numbering.element_unknowns(group.begin + e);
    }

    const StrutInterval &interval(const unsigned int e) const
    {
      return numbering.elements()[group.begin + e].interval;
    }

    const Strut &strut(const unsigned int e) const
    {
      return lattice.struts[interval(e).strut];
    }

    const Section &section(const unsigned int e) const
    {
      return sections[strut(e).section];
    }

    /** Of the nodes of element @p e. */
    typename Beam::Motion motion(const unsigned int e, const State &state) const
    {
      return Beam::motion(numbering, unknowns(e), state);
    }

    /** Calls @p action with batches of all elements in their order. */
    template <class Action>
    void for_each_batch(const Action &action) const
    {
      auxfem::for_each_batch(size(), action);
    }

    AtRest at_rest(const unsigned int e) const
    {
      return in_lane<AtRest>(batches_at_rest[e / n_lanes], e % n_lanes);
    }

    const AtRestInLanes &at_rest(const ElementBatch &batch) const
    {
      return batches_at_rest[batch.number()];
    }

    EachLane<const int *> unknowns(const ElementBatch &batch) const
    {
      return batch.each([&](const unsigned int e) { return unknowns(e); });
    }

    /** Adds tangents of the elements of @p batch. */
    void add_blocks(const ElementBatch &batch,
                    const Lanes (&blocks)[n * n],
                    TangentMatrix &matrix) const
    {
      for (unsigned int lane = 0; lane < batch.size; ++lane)
        {
          double block[n * n];
          take_lane(blocks, lane, block);
          matrix.add(group.begin + batch.elements[lane], block);
        }
    }

    const Lattice              &lattice;
    const DofNumbering         &numbering;
    const DofNumbering::Group   group;
    const std::vector<Section> &sections;
    /** 12 EI / (kGA L^2) that elements of struts without shear flexibility
     * keep; 0: struts shear. */
    const double           shear;
    const BeamShape<order> shape;

  private:
    /**
     * As much as BeamShape allows, and so little that all struts of this order
     * stay stable in tension: sections of a beam that shears turn over where
     * the axial force exceeds the shear stiffness. Linear elements have no
     * choice.
     */
    double shear_to_make_up_for() const
    {
      double most = BeamShape<order>::most_shear;
      if (order == 1)
        return most;
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        {
          const auto [strut_order, n_elements] = numbering.divisions()[s];
          const Strut &strut                   = lattice.struts[s];
          if (strut.is_rigid() || strut_order != order)
            continue;
          const double   length  = lattice.length(strut) / n_elements;
          const Section &section = sections[strut.section];
          most                   = std::min(most,
                          12 * Beam::least_bending(Beam::stiffness(section)) /
                            (small_rotation * section.axial_stiffness() *
                             length * length));
        }
      return most;
    }

    /**
     * Frames of the true axis; r0' is that of the interpolated axis, so the
     * strut is free of stress at rest.
     */
    AtRest make_at_rest(const unsigned int e) const
    {
      const StrutInterval &part = interval(e);
      AtRest               at_rest;
      at_rest.jacobian  = of_elements[e].length * (part.end - part.begin) / 2;
      at_rest.stiffness = Beam::stiffness(section(e));
      if (shear > 0)
        Beam::hold_shear(at_rest.stiffness,
                         12 /
                           (shear * 4 * at_rest.jacobian * at_rest.jacobian));
      dealii::Point<3>     nodes[order + 1], position;
      dealii::Tensor<1, 3> tangent;
      for (int a = 0; a <= order; ++a)
        lattice.axis(strut(e), part.at(shape.node[a]), nodes[a], tangent);
      for (int g = 0; g < order; ++g)
        {
          lattice.axis(strut(e), part.at(shape.point[g]), position, tangent);
          dealii::Tensor<1, 3> slope;
          for (int a = 0; a <= order; ++a)
            slope += shape.derivative[g][a] / at_rest.jacobian * nodes[a];
          at_rest.frames[g] = Beam::frame(tangent, slope, section(e).reference);
        }
      return at_rest;
    }

    std::vector<Element>       of_elements;
    std::vector<AtRestInLanes> batches_at_rest;
  };

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
