#include <auxfem/elements/beam_2d_between.h>
#include <auxfem/elements/beam_dispatch.h>
#include <auxfem/equations/effects/beam_forces.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Beam2D for BeamForces. */
    template <int p, bool large_rotation, bool damped>
    struct PlaneBeam
    {
      static constexpr int  order        = p;
      static constexpr int  n_components = 3;
      static constexpr int  n            = n_components * (order + 1);
      static constexpr bool is_linear    = !large_rotation;
      static constexpr bool is_damped    = damped;

      using Frame     = Beam2D::Frame;
      using Stiffness = Beam2D::Stiffness;
      struct Motion
      {
        double u[n];
        double v[damped ? n : 1];
      };

      static Motion motion(const DofNumbering &numbering,
                           const int          *unknowns,
                           const State        &state)
      {
        return motion(numbering,
                      unknowns,
                      state,
                      damped ? state.velocity->data() : nullptr);
      }

      static Motion motion(const DofNumbering & /*numbering*/,
                           const int                     *unknowns,
                           const State                   &state,
                           [[maybe_unused]] const double *v)
      {
        Motion        motion;
        const double *u = state.displacement.data();
        for (int i = 0; i < n; ++i)
          motion.u[i] = u[unknowns[i]];
        if constexpr (damped)
          for (int i = 0; i < n; ++i)
            motion.v[i] = v[unknowns[i]];
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
        const Beam2D::EnergyRate energy =
          Beam2D::internal_force<order, large_rotation, damped>(shape,
                                                                frames,
                                                                jacobian,
                                                                stiffness,
                                                                motion.u,
                                                                motion.v,
                                                                force);
        return {energy.strain, energy.dissipation};
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
        const Motion of_nodes = motion(numbering, unknowns, evaluation.to);
        Beam2D::tangent<order, large_rotation, damped>(shape,
                                                       frames,
                                                       jacobian,
                                                       stiffness,
                                                       of_nodes.u,
                                                       of_nodes.v,
                                                       factors.stiffness,
                                                       factors.damping,
                                                       block);
      }

      /** An element at the start of a step; displacements relative to the first
       * node, rotations but for full turns. */
      struct StepStart
      {
        /** Values are not set. */
        StepStart() = default;

        StepStart(const BeamShape<order> &shape,
                  const Frame            *frames,
                  const double            jacobian,
                  const DofNumbering & /*numbering*/,
                  const int   *unknowns,
                  const State &state)
          : turns(std::round(state.displacement[unknowns[2]] / turn))
        {
          double u[n];
          gather(unknowns, state, u);
          element = {shape, frames, jacobian, u};
        }

        /** Displacements of the same kind at another state. */
        void gather(const int *unknowns, const State &state, double *u) const
        {
          for (int i = 0; i < n; i += n_components)
            {
              const int *node = unknowns + i;
              for (int c = 0; c < 2; ++c)
                u[i + c] = relative_displacement(state, node[c], unknowns[c]);
              double rotation = state.displacement[node[2]];
              if (turns != 0)
                rotation =
                  std::fma(-turns, turn, rotation) - turns * rest_of_turn;
              u[i + 2] = rotation + (*state.compensation)[node[2]];
            }
        }

        Beam2D::StepStart<order> element;

      private:
        /** 2 pi, and what the number lacks. */
        static constexpr double turn         = 2 * dealii::numbers::PI,
                                rest_of_turn = 2.4492935982947064e-16;

        double turns;
      };

      template <class HighFrequencyDamping>
      static Beam2D::StepEnergy mean_force(const BeamShape<order> &shape,
                                           const Frame * /*frames*/,
                                           const double     jacobian,
                                           const Stiffness &stiffness,
                                           const DofNumbering & /*numbering*/,
                                           const int                  *unknowns,
                                           const StepStart            &start,
                                           const Evaluation           &step,
                                           const HighFrequencyDamping &damping,
                                           double                     *force)
      {
        double end[n];
        start.gather(unknowns, step.to, end);
        return Beam2D::mean_force<order, damped>(shape,
                                                 jacobian,
                                                 stiffness,
                                                 start.element,
                                                 end,
                                                 step.dt,
                                                 force,
                                                 damping);
      }

      template <class HighFrequencyDamping>
      static void mean_tangent(const BeamShape<order> &shape,
                               const Frame            *frames,
                               const double            jacobian,
                               const Stiffness        &stiffness,
                               const DofNumbering & /*numbering*/,
                               const int                  *unknowns,
                               const StepStart            &start,
                               const Evaluation           &step,
                               const TangentFactors       &factors,
                               const HighFrequencyDamping &damping,
                               double                     *block)
      {
        double end[n];
        start.gather(unknowns, step.to, end);
        Beam2D::mean_tangent<order, damped>(shape,
                                            frames,
                                            jacobian,
                                            stiffness,
                                            start.element,
                                            end,
                                            step.dt,
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

      /** @param per_bending shear stiffness by bending stiffness (1/m2). */
      static void hold_shear(Stiffness &stiffness, const double per_bending)
      {
        stiffness.shear = per_bending * stiffness.bending;
      }

      static double largest_stiffness(const Stiffness &stiffness)
      {
        return std::max(stiffness.axial, stiffness.shear);
      }

      static Frame
      frame(const dealii::Tensor<1, 3> &tangent,
            const dealii::Tensor<1, 3> &slope,
            const std::optional<dealii::Tensor<1, 3>> & /*reference*/)
      {
        return {tangent[0],
                tangent[1],
                slope[0] * tangent[0] + slope[1] * tangent[1],
                slope[1] * tangent[0] - slope[0] * tangent[1]};
      }

      static void geometric_tangent(const BeamShape<order> &shape,
                                    const Frame            *frames,
                                    const double            jacobian,
                                    const Motion           &motion,
                                    const SectionForces (&of_points)[order],
                                    double *block)
      {
        Beam2D::geometric_tangent(shape,
                                  frames,
                                  jacobian,
                                  motion.u,
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
        for (int g = 0; g < order; ++g)
          {
            const Beam2D::Kinematics k =
              kinematics(shape, g, frames, jacobian, motion);
            of_points[g] = {{stiffness.axial * k.epsilon,
                             stiffness.shear * k.gamma,
                             0,
                             0,
                             0,
                             stiffness.bending * k.kappa}};
          }
      }

      template <std::size_t n_motions>
      static void viscous_forces(const BeamShape<order> &shape,
                                 const Frame            *frames,
                                 const double            jacobian,
                                 const Stiffness        &stiffness,
                                 const Motion (&motions)[n_motions],
                                 SectionForces (&of_points)[n_motions][order])
      {
        const double beta = stiffness.damping_time;
        for (int g = 0; g < order; ++g)
          {
            const Beam2D::Kinematics k =
              kinematics(shape, g, frames, jacobian, motions[0]);
            for (std::size_t m = 0; m < n_motions; ++m)
              {
                const Beam2D::Gradient rate =
                  Beam2D::interpolate(shape, g, 1 / jacobian, motions[m].v);
                double epsilon_rate, gamma_rate;
                Beam2D::strain_rates(k, rate, epsilon_rate, gamma_rate);
                of_points[m][g] = {{beta * stiffness.axial * epsilon_rate,
                                    beta * stiffness.shear * gamma_rate,
                                    0,
                                    0,
                                    0,
                                    beta * stiffness.bending * rate.kappa}};
              }
          }
      }

      static dealii::Tensor<1, 3> rotation(const double *shape_values,
                                           const Motion &motion)
      {
        dealii::Tensor<1, 3> result;
        for (int a = 0; a <= order; ++a)
          result[2] += shape_values[a] * motion.u[n_components * a + 2];
        return result;
      }

      static dealii::Tensor<2, 3>
      axes(const dealii::Tensor<1, 3> &tangent,
           const std::optional<dealii::Tensor<1, 3>> & /*reference*/,
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

      /** Section forces times the strains of others (J/m). */
      static double strain_product(const Stiffness     &stiffness,
                                   const SectionForces &forces,
                                   const SectionForces &others)
      {
        return forces[0] * others[0] / stiffness.axial +
          forces[1] * others[1] / stiffness.shear +
          forces[5] * others[5] / stiffness.bending;
      }

    private:
      static Beam2D::Kinematics kinematics(const BeamShape<order> &shape,
                                           const int               g,
                                           const Frame            *frames,
                                           const double            jacobian,
                                           const Motion           &motion)
      {
        return Beam2D::kinematics<large_rotation>(
          frames[g],
          Beam2D::interpolate(shape, g, 1 / jacobian, motion.u));
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
