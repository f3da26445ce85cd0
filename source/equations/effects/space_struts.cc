#include <auxfem/elements/beam_3d_between.h>
#include <auxfem/elements/beam_dispatch.h>
#include <auxfem/equations/effects/beam_forces.h>
#include <auxfem/equations/node_rotations.h>

namespace auxfem
{
  namespace
  {
    /** Beam3D with large rotations for BeamForces. */
    template <int p, bool damped>
    struct RotatingMotion
    {
      static constexpr int order = p;
      Beam3D::Node         nodes[order + 1];
      Beam3D::NodeVelocity velocities[damped ? order + 1 : 1];
      /** Rotation vectors added up over the steps. */
      SpaceVector rotations[order + 1];
    };

    /** Unknowns and velocities of the small-displacement form. */
    template <int p, bool damped>
    struct SmallMotion
    {
      static constexpr int n = Beam3D::n_components * (p + 1);
      double               u[n];
      double               v[damped ? n : 1];
    };

    /** Beam3D for BeamForces. */
    template <int p, bool large_rotation, bool damped>
    struct SpaceBeam
    {
      static constexpr int  order        = p;
      static constexpr int  n_components = Beam3D::n_components;
      static constexpr int  n            = n_components * (order + 1);
      static constexpr bool is_linear    = !large_rotation;
      static constexpr bool is_damped    = damped;

      using Frame = Beam3D::Frame;
      struct Stiffness
      {
        Beam3D::Stiffness elastic;
        double            damping_time; ///< s
      };
      using Motion = std::conditional_t<large_rotation,
                                        RotatingMotion<p, damped>,
                                        SmallMotion<p, damped>>;

      static Motion motion(const DofNumbering &numbering,
                           const int          *unknowns,
                           const State        &state)
      {
        return motion(numbering,
                      unknowns,
                      state,
                      damped ? state.velocity->data() : nullptr);
      }

      static Motion motion(const DofNumbering            &numbering,
                           const int                     *unknowns,
                           const State                   &state,
                           [[maybe_unused]] const double *v)
      {
        Motion        motion;
        const double *u = state.displacement.data();
        if constexpr (large_rotation)
          for (int a = 0; a <= order; ++a)
            {
              const int        *node = unknowns + n_components * a;
              const Quaternion &rotation =
                state.rotations[numbering.rotations().with(node[3])];
              motion.nodes[a]     = {vector_at(u, node), rotation};
              motion.rotations[a] = vector_at(u, node + 3);
              if constexpr (damped)
                motion.velocities[a] = {vector_at(v, node),
                                        rotated(rotation,
                                                vector_at(v, node + 3))};
            }
        else
          for (int i = 0; i < n; ++i)
            {
              motion.u[i] = u[unknowns[i]];
              if constexpr (damped)
                motion.v[i] = v[unknowns[i]];
            }
        return motion;
      }

      [[gnu::flatten]] static BeamEnergy
      internal_force(const BeamShape<order> &shape,
                     const Frame            *frames,
                     const double            jacobian,
                     const Stiffness        &stiffness,
                     const Motion           &motion,
                     double                 *force)
      {
        BeamEnergy energy;
        if constexpr (large_rotation)
          {
            const Beam3D::ElementKinematics<order> element(shape,
                                                           frames,
                                                           jacobian,
                                                           motion.nodes);
            energy.strain = Beam3D::internal_force(shape,
                                                   element,
                                                   jacobian,
                                                   stiffness.elastic,
                                                   force);
            if constexpr (damped)
              energy.dissipation =
                Beam3D::add_damping_force(shape,
                                          element,
                                          jacobian,
                                          stiffness.elastic,
                                          stiffness.damping_time,
                                          motion.velocities,
                                          force);
          }
        else
          {
            energy.strain = Beam3D::small_displacement_force(shape,
                                                             frames,
                                                             jacobian,
                                                             stiffness.elastic,
                                                             motion.u,
                                                             force);
            if constexpr (damped)
              {
                double viscous[n];
                // Twice the energy of rates is the power of their forces.
                energy.dissipation = 2 * stiffness.damping_time *
                  Beam3D::small_displacement_force(shape,
                                                   frames,
                                                   jacobian,
                                                   stiffness.elastic,
                                                   motion.v,
                                                   viscous);
                for (int i = 0; i < n; ++i)
                  force[i] += stiffness.damping_time * viscous[i];
              }
          }
        return energy;
      }

      static void tangent(const BeamShape<order> &shape,
                          const Frame            *frames,
                          const double            jacobian,
                          const Stiffness        &stiffness,
                          const DofNumbering     &numbering,
                          const int              *unknowns,
                          const Evaluation       &evaluation,
                          const TangentFactors   &factors,
                          double                 *block)
      {
        if constexpr (large_rotation)
          {
            const Motion of_nodes = motion(numbering, unknowns, evaluation.to);
            const Beam3D::ElementKinematics<order> element(shape,
                                                           frames,
                                                           jacobian,
                                                           of_nodes.nodes);
            Beam3D::tangent(shape,
                            element,
                            jacobian,
                            stiffness.elastic,
                            factors.stiffness,
                            block);
            if constexpr (damped)
              Beam3D::add_damping_tangent(shape,
                                          element,
                                          jacobian,
                                          stiffness.elastic,
                                          stiffness.damping_time,
                                          of_nodes.velocities,
                                          factors.stiffness,
                                          factors.damping,
                                          angular_velocity_by_spin(numbering,
                                                                   unknowns,
                                                                   evaluation,
                                                                   of_nodes,
                                                                   factors)
                                            .data(),
                                          block);
          }
        else
          Beam3D::small_displacement_tangent(
            shape,
            frames,
            jacobian,
            stiffness.elastic,
            factors.stiffness +
              (damped ? stiffness.damping_time * factors.damping : 0.),
            block);
      }

      /** Nodes at one end of a step, displacements relative to the first. */
      static std::array<Beam3D::Node, order + 1>
      nodes_in_step(const DofNumbering &numbering,
                    const int          *unknowns,
                    const State        &state)
      {
        std::array<Beam3D::Node, order + 1> nodes;
        for (int a = 0; a <= order; ++a)
          {
            const int *node = unknowns + n_components * a;
            for (int c = 0; c < 3; ++c)
              nodes[a].displacement[c] =
                relative_displacement(state, node[c], unknowns[c]);
            nodes[a].rotation =
              state.rotations[numbering.rotations().with(node[3])];
          }
        return nodes;
      }

      /** An element at the start of a step. */
      struct StepStart
      {
        /** Values are not set. */
        StepStart() = default;

        StepStart(const BeamShape<order> & /*shape*/,
                  const Frame * /*frames*/,
                  const double /*jacobian*/,
                  const DofNumbering &numbering,
                  const int          *unknowns,
                  const State        &state)
          : nodes(nodes_in_step(numbering, unknowns, state))
        {}

        std::array<Beam3D::Node, order + 1> nodes;
      };

      template <class HighFrequencyDamping>
      static Beam3D::StepEnergy mean_force(const BeamShape<order> &shape,
                                           const Frame            *frames,
                                           const double            jacobian,
                                           const Stiffness        &stiffness,
                                           const DofNumbering     &numbering,
                                           const int              *unknowns,
                                           const StepStart        &start,
                                           const Evaluation       &step,
                                           const HighFrequencyDamping &damping,
                                           double                     *force)
      {
        return Beam3D::mean_force(
          shape,
          frames,
          jacobian,
          stiffness.elastic,
          start.nodes.data(),
          nodes_in_step(numbering, unknowns, step.to).data(),
          damped ? stiffness.damping_time / step.dt : 0.,
          force,
          damping);
      }

      template <class HighFrequencyDamping>
      static void mean_tangent(const BeamShape<order>     &shape,
                               const Frame                *frames,
                               const double                jacobian,
                               const Stiffness            &stiffness,
                               const DofNumbering         &numbering,
                               const int                  *unknowns,
                               const StepStart            &start,
                               const Evaluation           &step,
                               const TangentFactors       &factors,
                               const HighFrequencyDamping &damping,
                               double                     *block)
      {
        Beam3D::mean_tangent(shape,
                             frames,
                             jacobian,
                             stiffness.elastic,
                             start.nodes.data(),
                             nodes_in_step(numbering, unknowns, step.to).data(),
                             damped ? stiffness.damping_time / step.dt : 0.,
                             factors.stiffness,
                             factors.stiffness +
                               (damped
                                  ? stiffness.damping_time * factors.damping
                                  : 0.),
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

      /** @param per_bending shear stiffness by bending stiffness (1/m2). */
      static void hold_shear(Stiffness &stiffness, const double per_bending)
      {
        stiffness.elastic.shear_2 = per_bending * stiffness.elastic.bending_3;
        stiffness.elastic.shear_3 = per_bending * stiffness.elastic.bending_2;
      }

      static double largest_stiffness(const Stiffness &stiffness)
      {
        return std::max({stiffness.elastic.axial,
                         stiffness.elastic.shear_2,
                         stiffness.elastic.shear_3});
      }

      static Frame frame(const SpaceVector                &tangent,
                         const SpaceVector                &slope,
                         const std::optional<SpaceVector> &reference)
      {
        return {section_frame(tangent, reference), slope};
      }

      static void geometric_tangent(const BeamShape<order>        &shape,
                                    [[maybe_unused]] const Frame  *frames,
                                    const double                   jacobian,
                                    [[maybe_unused]] const Motion &motion,
                                    const SectionForces (&of_points)[order],
                                    double *block)
      {
        if constexpr (large_rotation)
          Beam3D::geometric_tangent(
            shape,
            Beam3D::ElementKinematics<order>(shape,
                                             frames,
                                             jacobian,
                                             motion.nodes),
            jacobian,
            of_points,
            block);
      }

      static void elastic_forces(const BeamShape<order> &shape,
                                 const Frame            *frames,
                                 const double            jacobian,
                                 const Stiffness        &stiffness,
                                 const Motion           &motion,
                                 SectionForces (&of_points)[order])
      {
        if constexpr (large_rotation)
          {
            const Beam3D::ElementKinematics<order> element(shape,
                                                           frames,
                                                           jacobian,
                                                           motion.nodes);
            for (int g = 0; g < order; ++g)
              of_points[g] = forces(stiffness, element.points[g].strains);
          }
        else
          for (int g = 0; g < order; ++g)
            of_points[g] = forces(stiffness,
                                  Beam3D::small_displacement_strains(shape,
                                                                     g,
                                                                     frames,
                                                                     jacobian,
                                                                     motion.u));
      }

      template <std::size_t n_motions>
      [[gnu::flatten]] static void
      viscous_forces(const BeamShape<order> &shape,
                     const Frame            *frames,
                     const double            jacobian,
                     const Stiffness        &stiffness,
                     const Motion (&motions)[n_motions],
                     SectionForces (&of_points)[n_motions][order])
      {
        const auto viscous = [&stiffness](const SpaceVector &gamma_rate,
                                          const SpaceVector &kappa_rate) {
          return forces(stiffness,
                        {stiffness.damping_time * gamma_rate,
                         stiffness.damping_time * kappa_rate});
        };
        if constexpr (large_rotation)
          {
            const Beam3D::ElementKinematics<order> element(shape,
                                                           frames,
                                                           jacobian,
                                                           motions[0].nodes);
            for (std::size_t m = 0; m < n_motions; ++m)
              for (int g = 0; g < order; ++g)
                {
                  const Beam3D::Kinematics &point = element.points[g];
                  const Beam3D::Rates       rates =
                    Beam3D::rates(shape,
                                  g,
                                  1 / jacobian,
                                  point,
                                  motions[m].velocities);
                  of_points[m][g] =
                    viscous(rates.gamma * point.axes, rates.kappa * point.axes);
                }
          }
        else
          for (std::size_t m = 0; m < n_motions; ++m)
            for (int g = 0; g < order; ++g)
              {
                const Beam3D::Strains rates =
                  Beam3D::small_displacement_strains(shape,
                                                     g,
                                                     frames,
                                                     jacobian,
                                                     motions[m].v);
                of_points[m][g] = viscous(rates.gamma, rates.kappa);
              }
      }

      static SpaceVector rotation(const double *shape_values,
                                  const Motion &motion)
      {
        SpaceVector sum;
        if constexpr (large_rotation)
          {
            for (int a = 0; a <= order; ++a)
              sum += shape_values[a] * motion.rotations[a];
            return rotation_vector_near(
              Beam3D::RelativeRotations<order>(motion.nodes).at(shape_values),
              sum);
          }
        else
          for (int a = 0; a <= order; ++a)
            for (int c = 0; c < 3; ++c)
              sum[c] += shape_values[a] * motion.u[n_components * a + 3 + c];
        return sum;
      }

      static SpaceTensor axes(const SpaceVector                &tangent,
                              const std::optional<SpaceVector> &reference,
                              const SpaceVector                &rotation)
      {
        const SpaceTensor at_rest = section_frame(tangent, reference);
        return large_rotation ? rotated(exponential(rotation), at_rest)
                              : at_rest;
      }

      /** Section forces times the strains of others (J/m). */
      static double strain_product(const Stiffness     &stiffness,
                                   const SectionForces &forces,
                                   const SectionForces &others)
      {
        const Beam3D::Stiffness &s = stiffness.elastic;
        const double             k[] =
          {s.axial, s.shear_2, s.shear_3, s.torsion, s.bending_2, s.bending_3};
        double sum = 0;
        for (unsigned int i = 0; i < forces.size(); ++i)
          sum += forces[i] * others[i] / k[i];
        return sum;
      }

    private:
      static SectionForces forces(const Stiffness       &stiffness,
                                  const Beam3D::Strains &strains)
      {
        const SpaceVector force  = Beam3D::section_force(stiffness.elastic,
                                                        strains.gamma),
                          moment = Beam3D::section_moment(stiffness.elastic,
                                                          strains.kappa);
        return {
          {force[0], force[1], force[2], moment[0], moment[1], moment[2]}};
      }

      /** omega = P W: it turns with the section, and W follows the step. */
      static std::array<SpaceTensor, order + 1>
      angular_velocity_by_spin(const DofNumbering   &numbering,
                               const int            *unknowns,
                               const Evaluation     &evaluation,
                               const Motion         &motion,
                               const TangentFactors &factors)
      {
        const NodeRotations                rotations(numbering);
        std::array<SpaceTensor, order + 1> by_spin;
        for (int a = 0; a <= order; ++a)
          {
            const int i =
              numbering.rotations().with(unknowns[n_components * a + 3]);
            by_spin[a] = -factors.stiffness *
                cross_product_tensor(motion.velocities[a].angular) +
              factors.damping *
                rotated(evaluation.to.rotations[i],
                        rotations.increment_by_spin(evaluation, i));
          }
        return by_spin;
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
