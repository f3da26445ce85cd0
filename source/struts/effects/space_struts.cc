#include <auxfem/struts/beam_3d_discrete_gradient.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/beam_sections.h>
#include <auxfem/struts/effects/make_struts.h>
#include <auxfem/struts/effects/space_motion.h>

namespace auxfem
{
  namespace
  {
    /** Beam3D as the Beam of BeamForces. */
    template <int p, bool large_rotation, bool damped>
    struct SpaceBeam : public SpaceSections
    {
      static constexpr int  order        = p;
      static constexpr int  n_components = Beam3D::n_components;
      static constexpr int  n            = n_components * (order + 1);
      static constexpr bool is_linear    = !large_rotation;
      static constexpr bool is_damped    = damped;

      using Undamped  = SpaceBeam<order, large_rotation, false>;
      using Frame     = Beam3D::Frame;
      using Stiffness = SpaceStiffness<double>;
      template <class Number>
      using AtRestOf = BeamAtRest<order,
                                  Beam3D::FrameOf<Number>,
                                  SpaceStiffness<Number>,
                                  Number>;
      using AtRest   = AtRestOf<double>;
      template <class Number>
      using MotionOf = std::conditional_t<large_rotation,
                                          RotatingMotion<p, damped, Number>,
                                          SmallMotion<p, damped, Number>>;
      using Motion   = MotionOf<double>;
      /** Motion with the derivatives that the tangent needs. */
      struct TangentMotion
      {
        MotionOf<Lanes> motion;
        /** Derivatives of nodal angular velocities by spins. */
        TensorOf<Lanes>
          angular_velocity_by_spin[large_rotation && damped ? order + 1 : 1];
      };

      template <class Unknowns>
      static MotionOf<NumberAt<Unknowns>> motion(const DofNumbering &numbering,
                                                 const Unknowns     &unknowns,
                                                 const State        &state)
      {
        return motion(numbering,
                      unknowns,
                      state,
                      damped ? state.velocity->data() : nullptr);
      }

      /** @param v velocities to use instead of those of @p state */
      template <class Unknowns>
      static MotionOf<NumberAt<Unknowns>> motion(const DofNumbering &numbering,
                                                 const Unknowns     &unknowns,
                                                 const State        &state,
                                                 const double       *v)
      {
        MotionOf<NumberAt<Unknowns>> motion;
        motion.gather(numbering, unknowns, state, v);
        return motion;
      }

      template <class Number>
      static Beam3D::ElasticSection<Number>
      elastic_section(const AtRestOf<Number> &at_rest)
      {
        return {elastic_stiffness(at_rest)};
      }

      /** As nodal_power(). */
      static Lanes power(const DofNumbering           &numbering,
                         const LaneArray<const int *> &unknowns,
                         const State                  &state,
                         const Vector                 &rates,
                         const Lanes (&force)[n])
      {
        return nodal_power<order, large_rotation>(numbering,
                                                  unknowns,
                                                  state,
                                                  rates,
                                                  force);
      }

      template <class Number, class Section>
      AUXFEM_FLATTEN static BeamEnergyOf<Number>
      internal_force(const BeamShape<order> &shape,
                     const AtRestOf<Number> &at_rest,
                     const Section          &section,
                     const MotionOf<Number> &motion,
                     Number                 *force)
      {
        BeamEnergyOf<Number> energy;
        if constexpr (large_rotation)
          {
            const auto element = kinematics(shape, at_rest, motion);
            energy.strain      = Beam3D::internal_force(shape,
                                                   element,
                                                   at_rest.jacobian,
                                                   section,
                                                   force);
            if constexpr (damped)
              energy.dissipation =
                Beam3D::add_damping_force(shape,
                                          element,
                                          at_rest.jacobian,
                                          at_rest.stiffness.elastic,
                                          at_rest.stiffness.damping_time,
                                          motion.velocities,
                                          force);
          }
        else
          {
            energy.strain = small_displacement_force(shape,
                                                     at_rest,
                                                     section,
                                                     motion.u,
                                                     force);
            if constexpr (damped)
              {
                const Number &beta = at_rest.stiffness.damping_time;
                Number        viscous[n];
                // Twice the energy of the rates is the power of their forces.
                energy.dissipation = 2 * beta *
                  small_displacement_force(shape,
                                           at_rest,
                                           elastic_section(at_rest),
                                           motion.v,
                                           viscous);
                for (int i = 0; i < n; ++i)
                  force[i] += beta * viscous[i];
              }
          }
        return energy;
      }

      static TangentMotion
      tangent_motion(const DofNumbering           &numbering,
                     const LaneArray<const int *> &unknowns,
                     const Evaluation             &evaluation,
                     const TangentFactors         &factors)
      {
        TangentMotion result;
        result.motion = motion(numbering, unknowns, evaluation.to);
        if constexpr (large_rotation && damped)
          for (int a = 0; a <= order; ++a)
            result.angular_velocity_by_spin[a] =
              angular_velocity_by_spin(numbering,
                                       unknowns,
                                       evaluation,
                                       a,
                                       result.motion,
                                       factors);
        return result;
      }

      template <class Section>
      static void tangent(const BeamShape<order> &shape,
                          const AtRestOf<Lanes>  &at_rest,
                          const Section          &section,
                          const TangentMotion    &node_motion,
                          const TangentFactors   &factors,
                          Lanes                  *block)
      {
        const Lanes &damping_time = at_rest.stiffness.damping_time;
        if constexpr (large_rotation)
          {
            const auto element = kinematics(shape, at_rest, node_motion.motion);
            Beam3D::tangent(shape,
                            element,
                            at_rest.jacobian,
                            section,
                            Lanes(factors.stiffness),
                            block);
            if constexpr (damped)
              Beam3D::add_damping_tangent(shape,
                                          element,
                                          at_rest.jacobian,
                                          at_rest.stiffness.elastic,
                                          damping_time,
                                          node_motion.motion.velocities,
                                          factors.stiffness,
                                          factors.damping,
                                          node_motion.angular_velocity_by_spin,
                                          block);
          }
        else
          {
            Lanes factor = factors.stiffness;
            if constexpr (damped)
              factor += damping_time * factors.damping;
            Beam3D::small_displacement_tangent(shape,
                                               at_rest.frames,
                                               at_rest.jacobian,
                                               section,
                                               node_motion.motion.u,
                                               factor,
                                               block);
          }
      }

      /** Nodes of elements at the end of a step. */
      using StepEnd = std::array<Beam3D::NodeOf<Lanes>, order + 1>;

      /** Elements at the start of a step. */
      struct StepStart : public Beam3D::StepStart<order, Lanes>
      {
        StepStart(const BeamShape<order>       &shape,
                  const AtRestOf<Lanes>        &at_rest,
                  const DofNumbering           &numbering,
                  const LaneArray<const int *> &unknowns,
                  const State                  &state)
          : Beam3D::StepStart<order, Lanes>(
              shape,
              at_rest.frames,
              at_rest.jacobian,
              nodes_in_step<order>(numbering, unknowns, state).data())
        {}
      };

      static StepEnd end_of_step(const DofNumbering           &numbering,
                                 const LaneArray<const int *> &unknowns,
                                 const StepStart & /*start*/,
                                 const State &state)
      {
        return nodes_in_step<order>(numbering, unknowns, state);
      }

      template <class Section, class HighFrequencyDamping>
      static Beam3D::StepEnergyOf<Lanes>
      mean_force(const BeamShape<order>     &shape,
                 const AtRestOf<Lanes>      &at_rest,
                 const Section              &section,
                 const StepStart            &start,
                 const StepEnd              &end,
                 const double                dt,
                 const HighFrequencyDamping &damping,
                 Lanes                      *force)
      {
        return Beam3D::mean_force(shape,
                                  at_rest.frames,
                                  at_rest.jacobian,
                                  section,
                                  start,
                                  end.data(),
                                  Lanes(damping_time(at_rest) / dt),
                                  force,
                                  damping);
      }

      template <class Section, class HighFrequencyDamping>
      static void mean_tangent(const BeamShape<order>     &shape,
                               const AtRestOf<Lanes>      &at_rest,
                               const Section              &section,
                               const StepStart            &start,
                               const StepEnd              &end,
                               const double                dt,
                               const TangentFactors       &factors,
                               const HighFrequencyDamping &damping,
                               Lanes                      *block)
      {
        const Lanes beta = damping_time(at_rest);
        Beam3D::mean_tangent(shape,
                             at_rest.frames,
                             at_rest.jacobian,
                             section,
                             start,
                             end.data(),
                             Lanes(beta / dt),
                             factors.stiffness,
                             Lanes(beta * factors.damping),
                             block,
                             damping);
      }

      static Stiffness stiffness(const Section &section)
      {
        return {{section.axial_stiffness(),
                 section.shear_stiffness_2(),
                 section.shear_stiffness_3(),
                 section.torsion_stiffness(),
                 section.bending_stiffness_2(),
                 section.bending_stiffness_3()},
                section.stiffness_proportional_damping};
      }

      /** @param per_bending shear stiffness over bending stiffness (1/m2) */
      static void set_shear_stiffness(Stiffness   &stiffness,
                                      const double per_bending)
      {
        stiffness.elastic.shear_2 = per_bending * stiffness.elastic.bending_3;
        stiffness.elastic.shear_3 = per_bending * stiffness.elastic.bending_2;
      }

      static double smallest_bending_stiffness(const Stiffness &stiffness)
      {
        return std::min(stiffness.elastic.bending_2,
                        stiffness.elastic.bending_3);
      }

      static double largest_stiffness(const Stiffness &stiffness)
      {
        return std::max({stiffness.elastic.axial,
                         stiffness.elastic.shear_2,
                         stiffness.elastic.shear_3});
      }

      static Frame frame(const SpaceVector        &tangent,
                         const SpaceVector        &slope,
                         const SectionOrientation &orientation)
      {
        return {section_frame(tangent, orientation), slope};
      }

      static void geometric_tangent(const BeamShape<order>        &shape,
                                    const AtRest                  &at_rest,
                                    [[maybe_unused]] const Motion &motion,
                                    const SectionForces (&point_forces)[order],
                                    double *block)
      {
        if constexpr (large_rotation)
          Beam3D::geometric_tangent(shape,
                                    kinematics(shape, at_rest, motion),
                                    at_rest.jacobian,
                                    point_forces,
                                    block);
      }

      static void elastic_forces(const BeamShape<order> &shape,
                                 const AtRest           &at_rest,
                                 const Motion           &motion,
                                 SectionForces (&point_forces)[order])
      {
        if constexpr (large_rotation)
          {
            const auto element = kinematics(shape, at_rest, motion);
            for (int g = 0; g < order; ++g)
              point_forces[g] =
                forces(at_rest.stiffness, element.points[g].strains);
          }
        else
          for (int g = 0; g < order; ++g)
            point_forces[g] =
              forces(at_rest.stiffness,
                     small_displacement_strains(shape, g, at_rest, motion.u));
      }

      template <class Number, std::size_t n_motions>
      AUXFEM_FLATTEN static void
      viscous_forces(const BeamShape<order> &shape,
                     const AtRestOf<Number> &at_rest,
                     const MotionOf<Number> (&motions)[n_motions],
                     SectionForcesOf<Number> (&point_forces)[n_motions][order])
      {
        const Number &beta    = at_rest.stiffness.damping_time;
        const auto    viscous = [&](const VectorOf<Number> &gamma_rate,
                                 const VectorOf<Number> &kappa_rate) {
          return forces(at_rest.stiffness,
                        Beam3D::StrainsOf<Number>{beta * gamma_rate,
                                                  beta * kappa_rate});
        };
        if constexpr (large_rotation)
          {
            const auto element = kinematics(shape, at_rest, motions[0]);
            for (std::size_t m = 0; m < n_motions; ++m)
              for (int g = 0; g < order; ++g)
                {
                  const Beam3D::KinematicsOf<Number> &point = element.points[g];
                  const Beam3D::RatesOf<Number>       rates =
                    Beam3D::rates(shape,
                                  g,
                                  Number(1 / at_rest.jacobian),
                                  point,
                                  motions[m].velocities);
                  point_forces[m][g] =
                    viscous(rates.gamma * point.axes, rates.kappa * point.axes);
                }
          }
        else
          for (std::size_t m = 0; m < n_motions; ++m)
            for (int g = 0; g < order; ++g)
              {
                const Beam3D::StrainsOf<Number> rates =
                  small_displacement_strains(shape, g, at_rest, motions[m].v);
                point_forces[m][g] = viscous(rates.gamma, rates.kappa);
              }
      }

      static SpaceVector rotation(const double                  *shape_values,
                                  [[maybe_unused]] const Motion &motion,
                                  const int                     *unknowns,
                                  const State                   &state)
      {
        SpaceVector sum;
        for (int a = 0; a <= order; ++a)
          sum += shape_values[a] *
            vector_at(state.displacement.data(),
                      unknowns,
                      n_components * a + 3);
        if constexpr (large_rotation)
          return rotation_vector_near(
            Beam3D::RelativeRotations<order>(motion.nodes).at(shape_values),
            sum);
        return sum;
      }

      static SpaceTensor axes(const SpaceVector        &tangent,
                              const SectionOrientation &orientation,
                              const SpaceVector        &rotation)
      {
        const SpaceTensor at_rest = section_frame(tangent, orientation);
        return large_rotation ? rotated(exponential(rotation), at_rest)
                              : at_rest;
      }

    private:
      /** Damping time (s), zero without damping. */
      static Lanes damping_time(const AtRestOf<Lanes> &at_rest)
      {
        return damped ? at_rest.stiffness.damping_time : Lanes(0);
      }

      template <class Number>
      static Beam3D::ElementKinematics<order, Number>
      kinematics(const BeamShape<order> &shape,
                 const AtRestOf<Number> &at_rest,
                 const MotionOf<Number> &motion)
      {
        return {shape, at_rest.frames, at_rest.jacobian, motion.nodes};
      }

      template <class Number, class Section>
      static Number small_displacement_force(const BeamShape<order> &shape,
                                             const AtRestOf<Number> &at_rest,
                                             const Section          &section,
                                             const Number           *u,
                                             Number                 *force)
      {
        return Beam3D::small_displacement_force(shape,
                                                at_rest.frames,
                                                at_rest.jacobian,
                                                section,
                                                u,
                                                force);
      }

      template <class Number>
      static Beam3D::StrainsOf<Number>
      small_displacement_strains(const BeamShape<order> &shape,
                                 const int               g,
                                 const AtRestOf<Number> &at_rest,
                                 const Number           *u)
      {
        return Beam3D::small_displacement_strains(shape,
                                                  g,
                                                  at_rest.frames,
                                                  at_rest.jacobian,
                                                  u);
      }
    };
  } // namespace

  std::unique_ptr<StrutForces>
  make_space_struts(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model)
  {
    return dispatch_order<largest_space_order>(group.order, [&](auto order) {
      return make_struts_of_order<SpaceBeam, order>(lattice,
                                                    numbering,
                                                    group,
                                                    sections,
                                                    model);
    });
  }
} // namespace auxfem
