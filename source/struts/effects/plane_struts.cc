#include <auxfem/struts/beam_2d_discrete_gradient.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/beam_sections.h>
#include <auxfem/struts/effects/make_struts.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Beam2D as the Beam of BeamForces. */
    template <int p, bool large_rotation, bool damped>
    struct PlaneBeam : public PlaneSections
    {
      static constexpr int  order        = p;
      static constexpr int  n_components = 3;
      static constexpr int  n            = n_components * (order + 1);
      static constexpr bool is_linear    = !large_rotation;
      static constexpr bool is_damped    = damped;

      using Undamped  = PlaneBeam<order, large_rotation, false>;
      using Frame     = Beam2D::Frame;
      using Stiffness = Beam2D::Stiffness;
      template <class Number>
      using AtRestOf = BeamAtRest<order,
                                  Beam2D::FrameOf<Number>,
                                  Beam2D::StiffnessOf<Number>,
                                  Number>;
      using AtRest   = AtRestOf<double>;
      template <class Number>
      struct MotionOf
      {
        Number u[n];
        Number v[damped ? n : 1] = {};
      };
      using Motion = MotionOf<double>;

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
      static MotionOf<NumberAt<Unknowns>>
      motion(const DofNumbering & /*numbering*/,
             const Unknowns                &unknowns,
             const State                   &state,
             [[maybe_unused]] const double *v)
      {
        MotionOf<NumberAt<Unknowns>> motion;
        const double                *u = state.displacement.data();
        for (int i = 0; i < n; ++i)
          motion.u[i] = value_at(u, unknowns, i);
        if constexpr (damped)
          for (int i = 0; i < n; ++i)
            motion.v[i] = value_at(v, unknowns, i);
        return motion;
      }

      template <class Number>
      static Beam2D::ElasticSection<Number>
      elastic_section(const AtRestOf<Number> &at_rest)
      {
        return {at_rest.stiffness};
      }

      /** Power of nodal forces at nodal @p rates, by local unknown. */
      static Lanes power(const DofNumbering & /*numbering*/,
                         const LaneArray<const int *> &unknowns,
                         const State & /*state*/,
                         const Vector &rates,
                         const Lanes (&force)[n])
      {
        Lanes sum = 0;
        for (int i = 0; i < n; ++i)
          sum += force[i] * value_at(rates.data(), unknowns, i);
        return sum;
      }

      template <class Number, class Section>
      AUXFEM_FLATTEN static BeamEnergyOf<Number>
      internal_force(const BeamShape<order> &shape,
                     const AtRestOf<Number> &at_rest,
                     const Section          &section,
                     const MotionOf<Number> &motion,
                     Number                 *force)
      {
        const Beam2D::EnergyRateOf<Number> energy =
          Beam2D::internal_force<order, large_rotation, damped>(
            shape,
            at_rest.frames,
            at_rest.jacobian,
            section,
            motion.u,
            motion.v,
            force);
        return {energy.strain, energy.dissipation};
      }

      static MotionOf<Lanes>
      tangent_motion(const DofNumbering           &numbering,
                     const LaneArray<const int *> &unknowns,
                     const Evaluation             &evaluation,
                     const TangentFactors & /*factors*/)
      {
        return motion(numbering, unknowns, evaluation.to);
      }

      template <class Section>
      AUXFEM_FLATTEN static void tangent(const BeamShape<order> &shape,
                                         const AtRestOf<Lanes>  &at_rest,
                                         const Section          &section,
                                         const MotionOf<Lanes>  &motion,
                                         const TangentFactors   &factors,
                                         Lanes                  *block)
      {
        Beam2D::tangent<order, large_rotation, damped>(shape,
                                                       at_rest.frames,
                                                       at_rest.jacobian,
                                                       section,
                                                       motion.u,
                                                       motion.v,
                                                       factors.stiffness,
                                                       factors.damping,
                                                       block);
      }

      /** Displacements of elements at the end of a step. */
      using StepEnd = std::array<Lanes, n>;

      /** Elements at the start of a step; displacements are relative to the
       * first node, rotations are reduced by full turns. */
      struct StepStart
      {
        StepStart(const BeamShape<order> &shape,
                  const AtRestOf<Lanes>  &at_rest,
                  const DofNumbering & /*numbering*/,
                  const LaneArray<const int *> &unknowns,
                  const State                  &state)
          : turns(round(
              Lanes(value_at(state.displacement.data(), unknowns, 2) / turn)))
        {
          const StepEnd u = displacements(unknowns, state);
          element         = {shape, at_rest.frames, at_rest.jacobian, u.data()};
        }

        /** Reduced displacements at another state. */
        StepEnd displacements(const LaneArray<const int *> &unknowns,
                              const State                  &state) const
        {
          StepEnd u;
          for (int i = 0; i < n; i += n_components)
            {
              for (int c = 0; c < 2; ++c)
                u[i + c] = relative_displacement(state, unknowns, i + c, c);
              const Lanes rotation =
                value_at(state.displacement.data(), unknowns, i + 2);
              u[i + 2] = fma(-turns, Lanes(turn), rotation) -
                turns * turn_rounding_error +
                value_at(state.compensation->data(), unknowns, i + 2);
            }
          return u;
        }

        Beam2D::StepStart<order, Lanes> element;

      private:
        /** 2 pi and its rounding error. */
        static constexpr double turn                = 2 * dealii::numbers::PI,
                                turn_rounding_error = 2.4492935982947064e-16;

        Lanes turns;
      };

      static StepEnd end_of_step(const DofNumbering & /*numbering*/,
                                 const LaneArray<const int *> &unknowns,
                                 const StepStart              &start,
                                 const State                  &state)
      {
        return start.displacements(unknowns, state);
      }

      template <class Section, class HighFrequencyDamping>
      AUXFEM_FLATTEN static Beam2D::StepEnergyOf<Lanes>
      mean_force(const BeamShape<order>     &shape,
                 const AtRestOf<Lanes>      &at_rest,
                 const Section              &section,
                 const StepStart            &start,
                 const StepEnd              &end,
                 const double                dt,
                 const HighFrequencyDamping &damping,
                 Lanes                      *force)
      {
        return Beam2D::mean_force<order, damped>(shape,
                                                 at_rest.jacobian,
                                                 section,
                                                 start.element,
                                                 end.data(),
                                                 dt,
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
        Beam2D::mean_tangent<order, damped>(shape,
                                            at_rest.frames,
                                            at_rest.jacobian,
                                            section,
                                            start.element,
                                            end.data(),
                                            dt,
                                            factors.stiffness,
                                            factors.damping,
                                            block,
                                            damping);
      }

      static Stiffness stiffness(const Section &section)
      {
        return {section.axial_stiffness(),
                section.shear_stiffness_2(),
                section.bending_stiffness_3(),
                section.stiffness_proportional_damping};
      }

      /** @param per_bending shear stiffness over bending stiffness (1/m2) */
      static void set_shear_stiffness(Stiffness   &stiffness,
                                      const double per_bending)
      {
        stiffness.shear = per_bending * stiffness.bending;
      }

      static double smallest_bending_stiffness(const Stiffness &stiffness)
      {
        return stiffness.bending;
      }

      static double largest_stiffness(const Stiffness &stiffness)
      {
        return std::max(stiffness.axial, stiffness.shear);
      }

      static Frame frame(const dealii::Tensor<1, 3> &tangent,
                         const dealii::Tensor<1, 3> &slope,
                         const SectionOrientation & /*orientation*/)
      {
        return {tangent[0],
                tangent[1],
                slope[0] * tangent[0] + slope[1] * tangent[1],
                slope[1] * tangent[0] - slope[0] * tangent[1]};
      }

      static void geometric_tangent(const BeamShape<order> &shape,
                                    const AtRest           &at_rest,
                                    const Motion           &motion,
                                    const SectionForces (&point_forces)[order],
                                    double *block)
      {
        Beam2D::geometric_tangent(shape,
                                  at_rest.frames,
                                  at_rest.jacobian,
                                  motion.u,
                                  point_forces,
                                  block);
      }

      static void elastic_forces(const BeamShape<order> &shape,
                                 const AtRest           &at_rest,
                                 const Motion           &motion,
                                 SectionForces (&point_forces)[order])
      {
        const Stiffness &stiffness = at_rest.stiffness;
        for (int g = 0; g < order; ++g)
          {
            const Beam2D::Kinematics k = kinematics(shape, g, at_rest, motion);
            point_forces[g]            = {{stiffness.axial * k.epsilon,
                                           stiffness.shear * k.gamma,
                                           0,
                                           0,
                                           0,
                                           stiffness.bending * k.kappa}};
          }
      }

      template <class Number, std::size_t n_motions>
      AUXFEM_FLATTEN static void
      viscous_forces(const BeamShape<order> &shape,
                     const AtRestOf<Number> &at_rest,
                     const MotionOf<Number> (&motions)[n_motions],
                     SectionForcesOf<Number> (&point_forces)[n_motions][order])
      {
        const Beam2D::StiffnessOf<Number> &stiffness = at_rest.stiffness;
        const Number                       beta      = stiffness.damping_time;
        for (int g = 0; g < order; ++g)
          {
            const Beam2D::KinematicsOf<Number> k =
              kinematics(shape, g, at_rest, motions[0]);
            for (std::size_t m = 0; m < n_motions; ++m)
              {
                const Beam2D::GradientOf<Number> rate =
                  Beam2D::interpolate(shape,
                                      g,
                                      Number(1 / at_rest.jacobian),
                                      motions[m].v);
                Number epsilon_rate, gamma_rate;
                Beam2D::strain_rates(k, rate, epsilon_rate, gamma_rate);
                point_forces[m][g] = {{beta * stiffness.axial * epsilon_rate,
                                       beta * stiffness.shear * gamma_rate,
                                       0,
                                       0,
                                       0,
                                       beta * stiffness.bending * rate.kappa}};
              }
          }
      }

      static dealii::Tensor<1, 3> rotation(const double *shape_values,
                                           const Motion & /*motion*/,
                                           const int   *unknowns,
                                           const State &state)
      {
        dealii::Tensor<1, 3> result;
        for (int a = 0; a <= order; ++a)
          result[2] += shape_values[a] *
            state.displacement[unknowns[n_components * a + 2]];
        return result;
      }

      static dealii::Tensor<2, 3>
      axes(const dealii::Tensor<1, 3> &tangent,
           const SectionOrientation & /*orientation*/,
           const dealii::Tensor<1, 3> &rotation)
      {
        const double         angle = large_rotation ? rotation[2] : 0.;
        const double         c = std::cos(angle), s = std::sin(angle);
        const double         normal[2] = {-tangent[1], tangent[0]};
        dealii::Tensor<2, 3> axes;
        for (unsigned int d = 0; d < 2; ++d)
          {
            axes[d][0] = c * tangent[d] + s * normal[d];
            axes[d][1] = c * normal[d] - s * tangent[d];
          }
        axes[2][2] = 1;
        return axes;
      }

      /** Product of section @p forces and the strains of @p others (J/m). */
      template <class Number>
      static Number strain_product(const Beam2D::StiffnessOf<Number> &stiffness,
                                   const SectionForcesOf<Number>     &forces,
                                   const SectionForcesOf<Number>     &others)
      {
        return forces[0] * others[0] / stiffness.axial +
          forces[1] * others[1] / stiffness.shear +
          forces[5] * others[5] / stiffness.bending;
      }

    private:
      template <class Number>
      static Beam2D::KinematicsOf<Number>
      kinematics(const BeamShape<order> &shape,
                 const int               g,
                 const AtRestOf<Number> &at_rest,
                 const MotionOf<Number> &motion)
      {
        return Beam2D::kinematics<large_rotation>(
          at_rest.frames[g],
          Beam2D::interpolate(shape,
                              g,
                              Number(1 / at_rest.jacobian),
                              motion.u));
      }
    };
  } // namespace

  std::unique_ptr<StrutForces>
  make_plane_struts(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model)
  {
    return dispatch_order(group.order, [&](auto order) {
      return make_struts_of_order<PlaneBeam, order>(lattice,
                                                    numbering,
                                                    group,
                                                    sections,
                                                    model);
    });
  }
} // namespace auxfem
