#ifndef auxfem_struts_effects_beam_elements_h
#define auxfem_struts_effects_beam_elements_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/equations/effect.h>
#include <auxfem/equations/element_batches.h>
#include <auxfem/model/numbering.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/struts/section.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /**
   * The elements of one strut group as beams, accessible one by one or in
   * batches of lanes. BeamForces and BeamMeanForces use them. @p Beam is as in
   * BeamForces, without damping.
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
      double length; ///< strut length (m)
      bool   owned;
    };

    /** @param group elements of @p numbering */
    BeamElements(const Lattice              &lattice,
                 const DofNumbering         &numbering,
                 const DofNumbering::Group  &group,
                 const std::vector<Section> &sections,
                 const bool                  shear_flexibility)
      : lattice(lattice)
      , numbering(numbering)
      , group(group)
      , sections(sections)
      , shear(shear_flexibility ? 0. : compensated_shear())
      , shape(shear)
    {
      const unsigned int n_elements = group.end - group.begin;
      elements.reserve(n_elements);
      find_tapered_sections();
      for (unsigned int e = 0; e < n_elements; ++e)
        elements.push_back({lattice.length(strut(e)),
                            numbering.elements()[group.begin + e].is_owned});
      batches_at_rest.reserve((n_elements + n_lanes - 1) / n_lanes);
      for_each_batch([&](const ElementBatch &batch) {
        batches_at_rest.push_back(pack_lanes<AtRestInLanes>(
          batch.each([&](const unsigned int e) { return make_at_rest(e); })));
      });
    }

    unsigned int size() const
    {
      return elements.size();
    }

    const Element &operator[](const unsigned int e) const
    {
      return elements[e];
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
      const auto tapered = tapered_sections.find(e);
      return tapered == tapered_sections.end() ? sections[strut(e).section]
                                               : tapered->second;
    }

    /** Numbers of all elements in the lattice, independent of the ranks. */
    std::vector<unsigned int> numbers_in_lattice() const
    {
      std::vector<unsigned int> numbers(size());
      for (unsigned int e = 0; e < size(); ++e)
        numbers[e] = numbering.number_in_lattice(group.begin + e);
      return numbers;
    }

    /** Name of the group in records. */
    std::string record_name() const
    {
      std::string name = "struts of order " + std::to_string(order);
      if (group.law > 0)
        name += ", law " + std::to_string(group.law);
      return name;
    }

    /** Motion of the nodes of element @p e. */
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
      return unpack_lane<AtRest>(batches_at_rest[e / n_lanes], e % n_lanes);
    }

    const AtRestInLanes &at_rest(const ElementBatch &batch) const
    {
      return batches_at_rest[batch.number()];
    }

    /** Element @p e at rest in every lane. */
    AtRestInLanes at_rest_in_all_lanes(const unsigned int e) const
    {
      LaneArray<AtRest> copies;
      copies.fill(at_rest(e));
      return pack_lanes<AtRestInLanes>(copies);
    }

    LaneArray<const int *> unknowns(const ElementBatch &batch) const
    {
      return batch.each([&](const unsigned int e) { return unknowns(e); });
    }

    /** Adds the element tangents of @p batch. */
    void add_blocks(const ElementBatch &batch,
                    const Lanes (&blocks)[n * n],
                    TangentMatrix &matrix) const
    {
      for (unsigned int lane = 0; lane < batch.size; ++lane)
        {
          double block[n * n];
          copy_lane(blocks, lane, block);
          matrix.add(group.begin + batch.elements[lane], block);
        }
    }

    const Lattice              &lattice;
    const DofNumbering         &numbering;
    const DofNumbering::Group   group;
    const std::vector<Section> &sections;
    /** Shear parameter 12 EI / (kGA L^2) of elements without shear flexibility;
     * 0 if struts shear. */
    const double           shear;
    const BeamShape<order> shape;

  private:
    /**
     * Largest shear parameter that BeamShape allows and that keeps struts
     * stable in tension: a shearing section turns over where the axial force
     * exceeds its shear stiffness. Linear elements always use the largest one.
     */
    double compensated_shear() const
    {
      double limit = BeamShape<order>::max_compensated_shear;
      if (order == 1)
        return limit;
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        {
          const auto [strut_order, n_elements] = numbering.divisions()[s];
          const Strut &strut                   = lattice.struts[s];
          if (strut.is_rigid() || strut_order != order)
            continue;
          const double   length = lattice.length(strut) / n_elements;
          const Section &whole  = sections[strut.section];
          for (unsigned int e = 0; e < (whole.taper ? n_elements : 1); ++e)
            {
              const Section section = whole.at((e + 0.5) / n_elements);
              limit                 = std::min(limit,
                               12 *
                                 Beam::smallest_bending_stiffness(
                                   Beam::stiffness(section)) /
                                 (small_rotation * section.axial_stiffness() *
                                  length * length));
            }
        }
      return limit;
    }

    /** Frames follow the exact axis, but r0' is the slope of the interpolated
     * axis, so that the strut is free of stress at rest. */
    AtRest make_at_rest(const unsigned int e) const
    {
      const StrutInterval &part = interval(e);
      AtRest               at_rest;
      at_rest.jacobian  = elements[e].length * (part.end - part.begin) / 2;
      at_rest.stiffness = Beam::stiffness(section(e));
      if (shear > 0)
        Beam::set_shear_stiffness(
          at_rest.stiffness,
          12 / (shear * 4 * at_rest.jacobian * at_rest.jacobian));
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
          at_rest.frames[g] =
            Beam::frame(tangent, slope, section(e).orientation());
        }
      return at_rest;
    }

    void find_tapered_sections()
    {
      for (unsigned int e = 0; e < group.end - group.begin; ++e)
        if (const Section &whole = sections[strut(e).section]; whole.taper)
          tapered_sections.emplace(e, whole.at(interval(e).at(0)));
    }

    /** By element of a tapered strut. */
    std::map<unsigned int, Section> tapered_sections;
    std::vector<Element>            elements;
    std::vector<AtRestInLanes>      batches_at_rest;
  };

  /** Damping section forces at the Gauss points of a batch, at one end of a
   * step. */
  template <class Beam>
  struct ViscousForces
  {
    /** @param mean_velocity mean velocity of the step */
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
      Beam::viscous_forces(beams.shape, at_rest, motions, forces);
    }

    /** Forces at Gauss point @p g from the velocities of the state and from the
     * mean velocity of the step. */
    std::pair<const SectionForcesOf<Lanes> &, const SectionForcesOf<Lanes> &>
    at(const int g) const
    {
      return {forces[0][g], forces[1][g]};
    }

  private:
    SectionForcesOf<Lanes> forces[2][Beam::order];
  };

  /** Work of damping in a step (J). */
  struct DampingWork
  {
    double dissipated = 0; ///< work of the mean strain rates
    double force_work = 0; ///< work of the mean of the forces at both ends
  };

  /** Damping work of all beams owned by this rank, each a @p Beam. */
  template <class Beam>
  DampingWork damping_work(const BeamElements<typename Beam::Undamped> &beams,
                           const Evaluation                            &step,
                           const StepMotion                            &motion)
  {
    // The first step without inertia has one rate for both ends.
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
      Lanes dissipated = 0, force_work = 0;
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
          dissipated += factor * product(mean, mean);
          force_work += factor / 2 *
            (product(at_start, along_start) + product(at_end, along_end));
        }
      for (unsigned int lane = 0; lane < batch.size; ++lane)
        if (beams[batch.elements[lane]].owned && lane_value(beta, lane) != 0)
          {
            work.dissipated += lane_value(dissipated, lane);
            work.force_work += lane_value(force_work, lane);
          }
    });
    return work;
  }
} // namespace auxfem

#endif
