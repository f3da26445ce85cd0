#ifndef auxfem_equations_effects_beam_forces_h
#define auxfem_equations_effects_beam_forces_h

#include <auxfem/elements/increment_damping.h>
#include <auxfem/equations/effects/step_starts.h>
#include <auxfem/equations/effects/struts.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  /**
   * Strain energy (J) of an element and power lost in it (W); of mean forces
   * over a step the energy lost in it and taken by the damping of high
   * frequencies (J).
   */
  struct BeamEnergy
  {
    double strain = 0, dissipation = 0, taken = 0;
  };

  /** What struts do in one evaluation. */
  struct BeamResults : public EffectResults
  {
    explicit BeamResults(const unsigned int n_elements)
      : forces(n_elements)
      , strain_energies(n_elements)
    {}

    /** Of all that are counted by this rank. */
    BeamEnergy energy;
    /**
     * Of every element, the largest force at its ends (N); moments divided by
     * the length of the strut.
     */
    std::vector<double> forces;
    /** Of every element (J). */
    std::vector<double> strain_energies;
  };

  /**
   * Internal forces of struts as beams of one kind. What depends on the
   * dimension and on the theory is in @p Beam, a class of static functions:
   * `order`, `n_components`, `is_linear`, `is_damped`; types `Frame` (a Gauss
   * point at rest), `Stiffness` and `Motion` (of an element's nodes); functions
   * `frame`, `stiffness`, `hold_shear`, `largest_stiffness` for the element at
   * rest, `motion`, `internal_force`, `tangent` for its forces,
   * `geometric_tangent`, `elastic_forces`, `viscous_forces` (of several motions
   * of the same positions) at its Gauss points, and `rotation`, `axes` for
   * output, `strain_product` for energies. With large rotations it has a type
   * `StepStart`, what the iterations of a step have in common, and `mean_force`
   * and `mean_tangent` over a step.
   */
  template <class Beam>
  class BeamForces : public StrutForces
  {
  public:
    BeamForces(const Lattice              &lattice,
               const DofNumbering         &numbering,
               const DofNumbering::Group  &group,
               const std::vector<Section> &sections,
               const StrutModel           &model)
      : lattice(lattice)
      , numbering(numbering)
      , group(group)
      , sections(sections)
      , shape(!model.shear_flexibility)
      , high_frequency_damping(model.high_frequency_damping)
    {
      const unsigned int n_elements = group.end - group.begin;
      frames.resize(std::size_t(n_elements) * order);
      of_elements.reserve(n_elements);
      for (unsigned int e = 0; e < n_elements; ++e)
        {
          const DofNumbering::Element &element =
            numbering.elements()[group.begin + e];
          const Strut   &strut   = lattice.struts[element.interval.strut];
          const Section &section = sections[strut.section];
          const double   length  = lattice.length(strut);

          Element data;
          data.length = length;
          data.jacobian =
            length * (element.interval.end - element.interval.begin) / 2;
          data.stiffness = Beam::stiffness(section);
          if (!model.shear_flexibility)
            Beam::hold_shear(data.stiffness,
                             12 /
                               (BeamShape<order>::shear_made_up_for * 4 *
                                data.jacobian * data.jacobian));
          data.owned             = element.is_owned;
          data.strain_per_energy = strain_per_energy(section);
          of_elements.push_back(data);
          set_frames(element.interval,
                     strut,
                     section,
                     data.jacobian,
                     &frames[std::size_t(e) * order]);
        }
    }

    const DofNumbering::Group &elements() const override
    {
      return group;
    }

    bool is_linear() const override
    {
      return Beam::is_linear;
    }

    void register_in(StateLayout &layout) override
    {
      strain_entry = layout.energies.enter(strain_energy_entry());
      if (high_frequency_damping > 0)
        remember_increments(layout);
      if (!Beam::is_damped)
        return;
      layout.velocity = true;
      damping_entry   = layout.energies.enter(
        {EnergyKind::dissipated,
           "strut_damping_dissipated",
           "energy lost by stiffness-proportional damping of the struts since "
             "the start"});
      numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

    std::unique_ptr<EffectResults> make_results() const override
    {
      return std::make_unique<Results>(of_elements.size());
    }

    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectResults    *results) const override
    {
      auto &of_struts = static_cast<Results &>(*results);
      if (evaluation.kind == Evaluation::Kind::between)
        {
          if constexpr (!Beam::is_linear)
            find_starts(evaluation.from, of_struts.starts);
          with_damping_of_increments(evaluation, [&](const auto &damping_of) {
            sum_forces(
              [&](const unsigned int e, double *force) {
                return mean_force(evaluation,
                                  e,
                                  of_struts,
                                  damping_of(e),
                                  force);
              },
              residual,
              of_struts);
          });
        }
      else
        sum_forces(
          [&](const unsigned int e, double *force) {
            return internal_force(e,
                                  Beam::motion(numbering,
                                               unknowns_of(e),
                                               evaluation.to),
                                  force);
          },
          residual,
          of_struts);
    }

    void add_tangent(const Evaluation                     &evaluation,
                     [[maybe_unused]] const EffectResults *results,
                     const TangentFactors                 &of_scheme,
                     TangentMatrix &matrix) const override
    {
      TangentFactors factors = of_scheme;
      if (factors.stiffness == 0 && factors.damping == 0)
        return;
      if (evaluation.kind == Evaluation::Kind::between)
        with_damping_of_increments(
          evaluation,
          [&]([[maybe_unused]] const auto &damping_of) {
            if constexpr (!Beam::is_linear)
              add_mean_tangent(evaluation,
                               static_cast<const Results &>(*results),
                               factors,
                               damping_of,
                               matrix);
            else if constexpr (decltype(damping_of(0))::is_used)
              factors.stiffness += damping_of(0).in_tangent;
          });
      if (!Beam::is_linear && evaluation.kind == Evaluation::Kind::between)
        return;
      double block[n * n];
      for (unsigned int e = 0; e < of_elements.size(); ++e)
        {
          Beam::tangent(shape,
                        &frames[std::size_t(e) * order],
                        of_elements[e].jacobian,
                        of_elements[e].stiffness,
                        numbering,
                        unknowns_of(e),
                        evaluation,
                        factors,
                        block);
          matrix.add(group.begin + e, block);
        }
    }

    void add_geometric_tangent(const ForceChange &change,
                               const unsigned int /*effect*/,
                               TangentMatrix &matrix) const override
    {
      if constexpr (!Beam::is_linear)
        {
          double        block[n * n];
          SectionForces forces[order], before[order];
          for (unsigned int e = 0; e < of_elements.size(); ++e)
            {
              const int *unknowns = unknowns_of(e);
              const auto motion   = [&](const State &state) {
                return Beam::motion(numbering, unknowns, state);
              };
              elastic_forces(e, motion(change.to), forces);
              elastic_forces(e, motion(change.from), before);
              for (int g = 0; g < order; ++g)
                for (unsigned int k = 0; k < 6; ++k)
                  forces[g][k] = change.factor * (forces[g][k] - before[g][k]);
              Beam::geometric_tangent(shape,
                                      &frames[std::size_t(e) * order],
                                      of_elements[e].jacobian,
                                      motion(change.state),
                                      forces,
                                      block);
              matrix.add(group.begin + e, block);
            }
        }
    }

    void account(const Evaluation & /*evaluation*/,
                 const EffectResults *results,
                 EnergyAccount       &account) const override
    {
      account.add(strain_entry, energy_of(results).strain);
    }

    void account_step(const Evaluation    &step,
                      const EffectResults *results,
                      EnergyAccount       &account) const override
    {
      if (high_frequency_damping > 0 && step.kind == Evaluation::Kind::between)
        account.add_in_step(numerical_entry, energy_of(results).taken);
      if constexpr (Beam::is_damped)
        {
          if (!account.takes_time())
            return;
          if (step.kind == Evaluation::Kind::between)
            {
              account.add_in_step(damping_entry,
                                  energy_of(results).dissipation);
              return;
            }
          const DampingWork damping = damping_work(step, account.motion());
          account.add_in_step(damping_entry, damping.lost);
          account.add_in_step(numerical_entry,
                              damping.of_forces - damping.lost);
        }
    }

    void account_stage(const Evaluation & /*stage*/,
                       const EffectResults *results,
                       EnergyAccount       &account) const override
    {
      if (Beam::is_damped)
        account.add_power(damping_entry, energy_of(results).dissipation);
    }

    void raise_forces(const Evaluation & /*evaluation*/,
                      const EffectResults *results,
                      double              *forces) const override
    {
      const auto &of_struts = static_cast<const BeamResults &>(*results);
      for (unsigned int e = 0; e < of_elements.size(); ++e)
        raise_nodes(e, of_struts.forces[e], forces);
    }

    void raise_uncertain_forces(const Evaluation &evaluation,
                                const EffectResults * /*results*/,
                                const double largest_displacement,
                                const double largest_rotation,
                                double      *forces) const override
    {
      // Mean forces take displacements relative to a node, which are those of
      // an element that turns at most: twice its length.
      const double most =
        !Beam::is_linear && evaluation.kind == Evaluation::Kind::between
        ? 4
        : std::numeric_limits<double>::infinity();
      for (unsigned int e = 0; e < of_elements.size(); ++e)
        raise_nodes(
          e,
          Beam::largest_stiffness(of_elements[e].stiffness) *
            (std::min(most, largest_displacement / of_elements[e].jacobian) +
             std::min(1., largest_rotation)),
          forces);
    }

    std::vector<StrutPoint> sample(const State       &state,
                                   const unsigned int of_numbering,
                                   const unsigned int n_points) const override
    {
      const unsigned int           e = of_numbering - group.begin;
      const DofNumbering::Element &element =
        numbering.elements()[group.begin + e];
      const Strut   &strut    = lattice.struts[element.interval.strut];
      const int     *unknowns = unknowns_of(e);
      const Element &data     = of_elements[e];
      const typename Beam::Motion motion =
        Beam::motion(numbering, unknowns, state);
      SectionForces elastic[order], viscous[1][order] = {};
      elastic_forces(e, motion, elastic);
      if constexpr (Beam::is_damped)
        viscous_forces(e, {motion}, viscous);

      std::vector<StrutPoint> points(n_points);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const double xi = -1 + 2. * i / (n_points - 1);
          double       N[order + 1], H[order];
          shape.values_at(xi, N);
          shape.gauss_interpolation_at(xi, H);
          StrutPoint          &point = points[i];
          dealii::Tensor<1, 3> tangent;
          lattice.axis(strut, element.interval.at(xi), point.position, tangent);
          point.displacement = interpolated(N, unknowns, state.displacement);
          if (state.velocity)
            point.velocity = interpolated(N, unknowns, *state.velocity);
          point.rotation  = Beam::rotation(N, motion);
          point.axes      = Beam::axes(tangent,
                                  sections[strut.section].reference,
                                  point.rotation);
          SectionForces E = {}, V = {};
          for (int g = 0; g < order; ++g)
            for (unsigned int k = 0; k < 6; ++k)
              {
                E[k] += H[g] * elastic[g][k];
                V[k] += H[g] * viscous[0][g][k];
              }
          for (unsigned int k = 0; k < 3; ++k)
            {
              point.force[k]  = E[k] + V[k];
              point.moment[k] = E[3 + k] + V[3 + k];
            }
          point.energy_density = Beam::strain_product(data.stiffness, E, E) / 2;
        }
      return points;
    }

    double energy_density(const unsigned int   of_numbering,
                          const SectionForces &forces) const override
    {
      return Beam::strain_product(
               of_elements[of_numbering - group.begin].stiffness,
               forces,
               forces) /
        2;
    }

    std::vector<dealii::Point<3>>
    axis(const Vector      &displacement,
         const unsigned int of_numbering,
         const unsigned int n_points) const override
    {
      const unsigned int           e = of_numbering - group.begin;
      const DofNumbering::Element &element =
        numbering.elements()[group.begin + e];
      const int                    *unknowns = unknowns_of(e);
      std::vector<dealii::Point<3>> points(n_points);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const double xi = -1 + 2. * i / (n_points - 1);
          double       N[order + 1];
          shape.values_at(xi, N);
          dealii::Tensor<1, 3> tangent;
          lattice.axis(lattice.struts[element.interval.strut],
                       element.interval.at(xi),
                       points[i],
                       tangent);
          points[i] += interpolated(N, unknowns, displacement);
        }
      return points;
    }

    ScaledMotion scaled_motion(const State       &state,
                               const unsigned int of_numbering) const override
    {
      const unsigned int e        = of_numbering - group.begin;
      const int         *unknowns = unknowns_of(e);
      SectionForces      elastic[order];
      elastic_forces(e, Beam::motion(numbering, unknowns, state), elastic);
      ScaledMotion motion;
      for (const SectionForces &forces : elastic)
        motion.strains.push_back(
          scaled_strains(of_elements[e].stiffness, forces));
      if (!state.acceleration)
        return motion;
      const double scale = std::sqrt(
        sections[lattice
                   .struts[numbering.elements()[of_numbering].interval.strut]
                   .section]
          .mass_per_length());
      const dealii::QGauss<1> gauss(order + 1);
      for (const dealii::Point<1> &point : gauss.get_points())
        {
          double N[order + 1];
          shape.values_at(2 * point[0] - 1, N);
          const dealii::Tensor<1, 3> velocity =
            scale * interpolated(N, unknowns, *state.velocity);
          motion.velocities.push_back(
            {{velocity[0], velocity[1], velocity[2]}});
        }
      return motion;
    }

    double strain_energy(const EffectResults &results,
                         const unsigned int   of_numbering) const override
    {
      return static_cast<const BeamResults &>(results)
        .strain_energies[of_numbering - group.begin];
    }

    double axial_force(const State       &state,
                       const unsigned int of_numbering) const override
    {
      const unsigned int e = of_numbering - group.begin;
      SectionForces      elastic[order];
      elastic_forces(e,
                     Beam::motion(numbering, unknowns_of(e), state),
                     elastic);
      double integral = 0;
      for (int g = 0; g < order; ++g)
        integral += shape.weight[g] * elastic[g][0];
      return integral / 2;
    }

    StrutStrain largest_strain(const State               &state,
                               const EffectResults       &results,
                               const std::vector<double> &allowed,
                               const double               least) const override
    {
      const auto &energies =
        static_cast<const BeamResults &>(results).strain_energies;
      const double weight =
        *std::min_element(std::begin(shape.weight), std::end(shape.weight));
      StrutStrain largest{least, invalid_index};
      for (unsigned int e = 0; e < of_elements.size(); ++e)
        {
          const Element     &data = of_elements[e];
          const unsigned int strut =
            numbering.elements()[group.begin + e].interval.strut;
          const unsigned int section      = lattice.struts[strut].section;
          const double       least_strain = largest.ratio * allowed[section];
          if (!data.owned ||
              2 * data.strain_per_energy * energies[e] <=
                least_strain * least_strain * weight * data.jacobian)
            continue;
          const double ratio =
            largest_strain(state, e, sections[section]) / allowed[section];
          if (ratio > largest.ratio)
            largest = {ratio, strut};
        }
      return largest;
    }

  private:
    /** Strain energy (J) and power lost by damping (W), between two states the
     * energy lost in the step (J). */
    static const BeamEnergy &energy_of(const EffectResults *results)
    {
      return static_cast<const BeamResults &>(*results).energy;
    }

    static constexpr int order        = Beam::order;
    static constexpr int n_components = Beam::n_components;
    static constexpr int n            = n_components * (order + 1);
    /** What the damping of high frequencies remembers of an element. */
    static constexpr int n_increments =
      Beam::is_linear ? n : order * n_components;
    /** Components of displacements, before those of rotations. */
    static constexpr int n_translations = n_components == 3 ? 2 : 3;

    struct Results : public BeamResults
    {
      using BeamResults::BeamResults;

      /** Of mean forces over a step. */
      StepStarts<typename Beam::StepStart> starts;
    };

    struct Element
    {
      double                   length; ///< of the strut (m)
      double                   jacobian;
      typename Beam::Stiffness stiffness;
      bool                     owned;
      /** See strain_per_energy() (1/N). */
      double strain_per_energy;
    };

    /** Local unknowns of element @p e of the group. */
    const int *unknowns_of(const unsigned int e) const
    {
      return numbering.element_unknowns(group.begin + e);
    }

    /** Of the translations among @p values of all local unknowns, at a point with
     * shape functions @p N. */
    dealii::Tensor<1, 3> interpolated(const double (&N)[order + 1],
                                      const int    *unknowns,
                                      const Vector &values) const
    {
      dealii::Tensor<1, 3> result;
      for (int a = 0; a <= order; ++a)
        for (unsigned int d = 0; d < lattice.dimension; ++d)
          result[d] += N[a] * values[unknowns[n_components * a + d]];
      return result;
    }

    /** At the Gauss points of element @p e. */
    void elastic_forces(const unsigned int           e,
                        const typename Beam::Motion &motion,
                        SectionForces (&of_points)[order]) const
    {
      Beam::elastic_forces(shape,
                           &frames[std::size_t(e) * order],
                           of_elements[e].jacobian,
                           of_elements[e].stiffness,
                           motion,
                           of_points);
    }

    /** Of damping, at the Gauss points of element @p e, by each of several
     * motions that differ in their velocities alone. */
    template <std::size_t n_motions>
    void viscous_forces(const unsigned int e,
                        const typename Beam::Motion (&motions)[n_motions],
                        SectionForces (&of_points)[n_motions][order]) const
    {
      Beam::viscous_forces(shape,
                           &frames[std::size_t(e) * order],
                           of_elements[e].jacobian,
                           of_elements[e].stiffness,
                           motions,
                           of_points);
    }

    /** As in ScaledMotion. */
    static SectionForces
    scaled_strains(const typename Beam::Stiffness &stiffness,
                   const SectionForces            &forces)
    {
      SectionForces strains = {};
      for (unsigned int k = 0; k < strains.size(); ++k)
        {
          SectionForces unit = {};
          unit[k]            = 1;
          strains[k] =
            forces[k] * std::sqrt(Beam::strain_product(stiffness, unit, unit));
        }
      return strains;
    }

    /** Section forces of damping at the Gauss points of an element at an end of
     * a step. */
    struct ViscousForces
    {
      /** @param mean_velocity of the step. */
      ViscousForces(const BeamForces  &beams,
                    const unsigned int e,
                    const State       &state,
                    const Vector      &mean_velocity)
      {
        const auto motion = [&](const Vector &velocity) {
          return Beam::motion(beams.numbering,
                              beams.unknowns_of(e),
                              state,
                              velocity.data());
        };
        beams.viscous_forces(e,
                             {motion(*state.velocity), motion(mean_velocity)},
                             of_motions);
      }

      /** At a Gauss point: by the velocities there, and by those that the
       * step's own motion has there. */
      std::pair<const SectionForces &, const SectionForces &>
      at(const int g) const
      {
        return {of_motions[0][g], of_motions[1][g]};
      }

    private:
      SectionForces of_motions[2][order];
    };

    /** What damping does in a step (J). */
    struct DampingWork
    {
      double lost      = 0; ///< by the mean strain rates of the step
      double of_forces = 0; ///< by the mean of the forces at both ends
    };

    DampingWork damping_work(const Evaluation &step,
                             const StepMotion &motion) const
    {
      // Without inertia the rates at the end are those of the first step.
      const bool ends_alike =
        step.kind == Evaluation::Kind::static_step && !step.from.before;
      DampingWork work;
      for (unsigned int e = 0; e < of_elements.size(); ++e)
        {
          const double beta = of_elements[e].stiffness.damping_time;
          if (!of_elements[e].owned || beta == 0)
            continue;
          const ViscousForces start(*this, e, step.from, motion.rate),
            end(*this, e, step.to, motion.rate);
          const auto product = [&](const SectionForces &one,
                                   const SectionForces &other) {
            return Beam::strain_product(of_elements[e].stiffness, one, other);
          };
          for (int g = 0; g < order; ++g)
            {
              const double factor =
                shape.weight[g] * of_elements[e].jacobian * step.dt / beta;
              const auto [at_start, along_start] = start.at(g);
              const auto [at_end, along_end]     = end.at(g);
              SectionForces mean                 = at_end;
              if (!ends_alike)
                for (unsigned int k = 0; k < mean.size(); ++k)
                  mean[k] = (mean[k] + at_start[k]) / 2;
              work.lost += factor * product(mean, mean);
              work.of_forces += factor / 2 *
                (product(at_start, along_start) + product(at_end, along_end));
            }
        }
      return work;
    }

    /**
     * Square of the strain of outer fibres over twice the energy per length
     * (1/N), at most: N / EA + M d / EI against N^2 / EA + M^2 / EI.
     */
    static double strain_per_energy(const Section &section)
    {
      const auto [d2, d3] = section.fibre_distances;
      return 1 / section.axial_stiffness() +
        d2 * d2 / section.bending_stiffness_2() +
        d3 * d3 / section.bending_stiffness_3();
    }

    /** Of outer fibres at the Gauss points of element @p e. */
    double largest_strain(const State       &state,
                          const unsigned int e,
                          const Section     &section) const
    {
      SectionForces elastic[order];
      elastic_forces(e,
                     Beam::motion(numbering, unknowns_of(e), state),
                     elastic);
      const auto &fibres  = section.fibre_distances;
      double      largest = 0;
      for (const SectionForces &forces : elastic)
        largest = std::max(largest,
                           std::abs(forces[0]) / section.axial_stiffness() +
                             std::abs(forces[4]) * fibres[0] /
                               section.bending_stiffness_2() +
                             std::abs(forces[5]) * fibres[1] /
                               section.bending_stiffness_3());
      return largest;
    }

    /** Adds element_force(e, force) of all elements; fills @p results. */
    template <class ElementForce>
    void sum_forces(const ElementForce &element_force,
                    double             *residual,
                    BeamResults        &results) const
    {
      BeamEnergy energy;
      double     force[n];
      for (unsigned int e = 0; e < of_elements.size(); ++e)
        {
          const int       *unknowns   = unknowns_of(e);
          const BeamEnergy of_element = element_force(e, force);
          if (of_elements[e].owned)
            {
              energy.strain += of_element.strain;
              energy.dissipation += of_element.dissipation;
              energy.taken += of_element.taken;
            }
          for (int i = 0; i < n; ++i)
            residual[unknowns[i]] += force[i];
          results.forces[e] = largest_at_ends(force, of_elements[e].length);
          results.strain_energies[e] = of_element.strain;
        }
      results.energy = energy;
    }

    static double largest_at_ends(const double *force, const double length)
    {
      double of_forces = 0, of_moments = 0;
      // The first two nodes.
      for (int a = 0; a < 2; ++a)
        for (int c = 0; c < n_components; ++c)
          {
            double &largest = c < n_translations ? of_forces : of_moments;
            largest = std::max(largest, std::abs(force[n_components * a + c]));
          }
      return std::max(of_forces, of_moments / length);
    }

    /** Raises @p forces in the rows of element @p e to @p force (N). */
    void
    raise_nodes(const unsigned int e, const double force, double *forces) const
    {
      const int   *unknowns = unknowns_of(e);
      const double moment   = force * of_elements[e].length;
      for (int a = 0; a <= order; ++a)
        for (int c = 0; c < n_components; ++c)
          {
            double &row = forces[unknowns[n_components * a + c]];
            row         = std::max(row, c < n_translations ? force : moment);
          }
    }

    BeamEnergy internal_force(const unsigned int           e,
                              const typename Beam::Motion &motion,
                              double                      *force) const
    {
      return Beam::internal_force(shape,
                                  &frames[std::size_t(e) * order],
                                  of_elements[e].jacobian,
                                  of_elements[e].stiffness,
                                  motion,
                                  force);
    }

    /** Makes room for what the damping of high frequencies remembers. */
    void remember_increments(StateLayout &layout)
    {
      const std::string name = "struts of order " + std::to_string(order);
      std::vector<unsigned int> numbers;
      numbers.reserve(of_elements.size());
      for (unsigned int e = group.begin; e < group.end; ++e)
        numbers.push_back(number_in_lattice(numbering.elements()[e].interval));
      first_increment =
        layout.history.keep(name + ": increments", numbers, n_increments);
      length_of_step  = layout.history.keep(name + ": length of the last step",
                                           {0},
                                           /*values_per_item=*/1);
      numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

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
      if (high_frequency_damping == 0)
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

    void find_starts(const State                          &from,
                     StepStarts<typename Beam::StepStart> &starts) const
    {
      starts.update(from, of_elements.size(), [&](const unsigned int e) {
        return typename Beam::StepStart(shape,
                                        &frames[std::size_t(e) * order],
                                        of_elements[e].jacobian,
                                        numbering,
                                        unknowns_of(e),
                                        from);
      });
    }

    /** Over the step between two states. */
    template <class HighFrequencyDamping>
    BeamEnergy mean_force(const Evaluation               &step,
                          const unsigned int              e,
                          [[maybe_unused]] const Results &results,
                          const HighFrequencyDamping     &damping,
                          double                         *force) const
    {
      if constexpr (Beam::is_linear)
        return linear_mean_force(step, e, damping, force);
      else
        {
          const auto energy = Beam::mean_force(shape,
                                               &frames[std::size_t(e) * order],
                                               of_elements[e].jacobian,
                                               of_elements[e].stiffness,
                                               numbering,
                                               unknowns_of(e),
                                               results.starts[e],
                                               step,
                                               damping,
                                               force);
          return {energy.strain, energy.lost, energy.taken};
        }
    }

    /** The same by the forces of mean unknowns, and of what the damping adds to
     * them: increments of unknowns stand for those of strains. */
    template <class HighFrequencyDamping>
    BeamEnergy
    linear_mean_force(const Evaluation                            &step,
                      const unsigned int                           e,
                      [[maybe_unused]] const HighFrequencyDamping &damping,
                      double                                      *force) const
    {
      using Motion          = typename Beam::Motion;
      const int   *unknowns = unknowns_of(e);
      const Motion start    = Beam::motion(numbering, unknowns, step.from),
                   end      = Beam::motion(numbering, unknowns, step.to);
      Motion       mean     = end;
      const double strain   = internal_force(e, end, force).strain;
      double       taken    = 0;
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
          internal_force(e, added, force);
          for (int i = 0; i < n; ++i)
            taken += force[i] * (end.u[i] - start.u[i]);
        }
      return {strain,
              step.dt * internal_force(e, mean, force).dissipation,
              taken};
    }

    template <class DampingOf>
    void add_mean_tangent(const Evaluation     &step,
                          const Results        &results,
                          const TangentFactors &factors,
                          const DampingOf      &damping_of,
                          TangentMatrix        &matrix) const
    {
      double block[n * n];
      for (unsigned int e = 0; e < of_elements.size(); ++e)
        {
          Beam::mean_tangent(shape,
                             &frames[std::size_t(e) * order],
                             of_elements[e].jacobian,
                             of_elements[e].stiffness,
                             numbering,
                             unknowns_of(e),
                             results.starts[e],
                             step,
                             factors,
                             damping_of(e),
                             block);
          matrix.add(group.begin + e, block);
        }
    }

    /**
     * Frames of the true axis; r0' is that of the interpolated axis, so the
     * strut is free of stress at rest.
     */
    void set_frames(const StrutMesh::Interval &interval,
                    const Strut               &strut,
                    const Section             &section,
                    const double               jacobian,
                    typename Beam::Frame      *frame) const
    {
      dealii::Point<3>     nodes[order + 1], position;
      dealii::Tensor<1, 3> tangent;
      for (int a = 0; a <= order; ++a)
        lattice.axis(strut, interval.at(shape.node[a]), nodes[a], tangent);
      for (int g = 0; g < order; ++g)
        {
          lattice.axis(strut, interval.at(shape.point[g]), position, tangent);
          dealii::Tensor<1, 3> slope;
          for (int a = 0; a <= order; ++a)
            slope += shape.derivative[g][a] / jacobian * nodes[a];
          frame[g] = Beam::frame(tangent, slope, section.reference);
        }
    }

    const Lattice                    &lattice;
    const DofNumbering               &numbering;
    const DofNumbering::Group         group;
    const std::vector<Section>       &sections;
    const BeamShape<order>            shape;
    const double                      high_frequency_damping;
    std::vector<Element>              of_elements;
    std::vector<typename Beam::Frame> frames;
    unsigned int strain_entry = 0, damping_entry = 0, numerical_entry = 0;
    /** In State::history: increments of the last step, its length. */
    std::size_t first_increment = 0, length_of_step = 0;
  };

  /** @name Struts of a polynomial order, all variants. */
  ///@{
  std::unique_ptr<StrutForces>
  make_plane_struts(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model);

  std::unique_ptr<StrutForces>
  make_space_struts(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model);
  ///@}

  /** The variant of @p Beam <order, large_rotation, damped> that @p model asks for. */
  template <template <int, bool, bool> class Beam, int order>
  std::unique_ptr<StrutForces>
  make_struts_of_order(const Lattice              &lattice,
                       const DofNumbering         &numbering,
                       const DofNumbering::Group  &group,
                       const std::vector<Section> &sections,
                       const StrutModel           &model)
  {
    const auto make = [&](auto large_rotation,
                          auto damped) -> std::unique_ptr<StrutForces> {
      return std::make_unique<BeamForces<Beam<order, large_rotation, damped>>>(
        lattice,
        numbering,
        group,
        sections,
        model);
    };
    const std::true_type  yes;
    const std::false_type no;
    if (model.large_rotation)
      return model.damping ? make(yes, yes) : make(yes, no);
    return model.damping ? make(no, yes) : make(no, no);
  }
} // namespace auxfem

#endif
