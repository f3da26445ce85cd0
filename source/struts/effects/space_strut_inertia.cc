#include <auxfem/equations/node_rotations.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/strut_inertia.h>
#include <auxfem/struts/rotary_inertia.h>

#include <deal.II/base/quadrature_lib.h>

namespace auxfem
{
  namespace
  {
    /** Nodal vectors, such as angular velocities or momenta. */
    template <int order>
    using NodeVectors = std::array<SpaceVector, order + 1>;

    /**
     * Inertia of struts in space. With material angular velocities W_a at the
     * nodes and M_ab = int N_a N_b J ds, the kinetic energy of rotation is sum
     * W_a . L_a / 2 with momenta L_a = sum M_ab W_b. Its variation by spins
     * gives Euler's equations at each node,
     *
     *     torque_a = P_a (L_a' + W_a x L_a),
     *
     * which conserves the angular momentum sum P_a L_a and reproduces the
     * planar mass matrix. Mass-proportional damping adds alpha P_a L_a. Small
     * rotations: P_a = I, no product of W and L.
     */
    template <int order, bool large_rotation, bool damped>
    class SpaceStrutInertia : public StrutInertia
    {
    public:
      SpaceStrutInertia(const Lattice              &lattice,
                        const DofNumbering         &numbering,
                        const DofNumbering::Group  &group,
                        const std::vector<Section> &sections,
                        const bool                  rotary_inertia)
        : StrutInertia(lattice, numbering, group, sections, damped)
        , node_rotations(numbering)
        , rotary(rotary_inertia)
      {
        for (unsigned int e = 0; e < elements.size() && rotary; ++e)
          add_rotary_inertia(lattice,
                             numbering.elements()[group.begin + e].interval,
                             sections,
                             elements[e]);
      }

      bool is_linear() const override
      {
        return !large_rotation || !rotary;
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        const double        *accelerations = evaluation.to.acceleration->data();
        const DampedVelocity velocities(evaluation);
        for (unsigned int e = 0; e < elements.size(); ++e)
          {
            const int   *unknowns = numbering.element_unknowns(group.begin + e);
            const auto   a        = gather(accelerations, unknowns, 0);
            const auto   v        = gather(velocities.values(), unknowns, 0);
            const double alpha    = damped ? elements[e].damping : 0.;
            for (int i = 0; i <= order; ++i)
              {
                SpaceVector sum;
                for (int j = 0; j <= order; ++j)
                  sum +=
                    shape.mass[i][j] * (damped ? a[j] + alpha * v[j] : a[j]);
                scatter(elements[e].mass * sum,
                        unknowns + n_components * i,
                        residual);
              }
            if (!rotary)
              continue;
            if constexpr (large_rotation)
              if (evaluation.kind == Evaluation::Kind::discrete_gradient)
                {
                  add_mean_torques(e, evaluation, alpha, residual);
                  continue;
                }
            const RotatingNodes rotating(*this,
                                         e,
                                         evaluation.to,
                                         velocities.values());
            for (int i = 0; i <= order; ++i)
              scatter(rotating.torque(i, alpha),
                      unknowns + n_components * i + 3,
                      residual);
          }
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        double block[n * n];
        for (unsigned int e = 0; e < elements.size(); ++e)
          {
            const double mass = factors.mass +
              (damped ? elements[e].damping * factors.damping : 0.);
            if (mass == 0 && factors.stiffness == 0)
              continue;
            std::fill(block, block + n * n, 0.);
            for (int i = 0; i <= order; ++i)
              for (int j = 0; j <= order; ++j)
                for (int c = 0; c < 3; ++c)
                  block[(n_components * i + c) * n + n_components * j + c] =
                    mass * shape.mass[i][j] * elements[e].mass;
            if (rotary)
              add_rotary_tangent(e, evaluation, factors, mass, block);
            matrix.add(group.begin + e, block);
          }
      }

    private:
      static constexpr int n_components = 6;
      static constexpr int n            = n_components * (order + 1);
      static constexpr int n_pairs      = (order + 1) * (order + 1);

      /** Rotational motion of the nodes of an element. */
      struct RotatingNodes
      {
        RotatingNodes(const SpaceStrutInertia &inertia,
                      const unsigned int       e,
                      const State             &state,
                      const double            *velocities)
        {
          const int *unknowns =
            inertia.numbering.element_unknowns(inertia.group.begin + e);
          velocity     = gather(velocities, unknowns, 3);
          acceleration = gather(state.acceleration->data(), unknowns, 3);
          momentum     = inertia.momenta(e, velocity);
          rate         = inertia.momenta(e, acceleration);
          if constexpr (large_rotation)
            for (int i = 0; i <= order; ++i)
              rotation[i] = state.rotations[inertia.numbering.rotations().with(
                unknowns[n_components * i + 3])];
        }

        /** Torque on node @p i in the global frame (N m), with damping @p
         * alpha. */
        SpaceVector torque(const int i, const double alpha) const
        {
          SpaceVector material = rate[i];
          if (damped)
            material += alpha * momentum[i];
          if constexpr (!large_rotation)
            return material;
          return rotated(rotation[i],
                         material +
                           dealii::cross_product_3d(velocity[i], momentum[i]));
        }

        NodeVectors<order> velocity, acceleration, momentum, rate;
        Quaternion         rotation[order + 1];
      };

      static NodeVectors<order>
      gather(const double *values, const int *unknowns, const int first)
      {
        NodeVectors<order> result;
        for (int i = 0; i <= order; ++i)
          for (int c = 0; c < 3; ++c)
            result[i][c] = values[unknowns[n_components * i + first + c]];
        return result;
      }

      static void
      scatter(const SpaceVector &values, const int *unknowns, double *residual)
      {
        for (int c = 0; c < 3; ++c)
          residual[unknowns[c]] += values[c];
      }

      /** Appends M_ab of one element, in the global frame at rest. */
      void add_rotary_inertia(const Lattice              &lattice,
                              const StrutInterval        &interval,
                              const std::vector<Section> &sections,
                              const Element              &element)
      {
        // One point more than a straight strut needs, since the axes rotate
        // along an arc.
        static const dealii::QGauss<1> rule(order + 2);
        const Strut                   &strut = lattice.struts[interval.strut];
        const std::size_t              first = pair_inertias.size();
        pair_inertias.resize(first + n_pairs);
        const std::array<double, 3> &values = element.rotary_inertia;
        const SectionOrientation     orientation =
          sections[strut.section].orientation();
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            dealii::Point<3> position;
            SpaceVector      tangent;
            const double     xi = 2 * rule.point(q)[0] - 1;
            lattice.axis(strut, interval.at(xi), position, tangent);
            const SpaceTensor inertia =
              with_principal_values(section_frame(tangent, orientation),
                                    SpaceVector(
                                      {values[0], values[1], values[2]}));
            double N[order + 1];
            shape.values_at(xi, N);
            for (int a = 0; a <= order; ++a)
              for (int b = 0; b <= order; ++b)
                pair_inertias[first + a * (order + 1) + b] += 2 *
                  element.half_length * rule.weight(q) * N[a] * N[b] * inertia;
          }
      }

      const SpaceTensor &
      pair_inertia(const unsigned int e, const int a, const int b) const
      {
        return pair_inertias[std::size_t(e) * n_pairs + a * (order + 1) + b];
      }

      NodeVectors<order> momenta(const unsigned int        e,
                                 const NodeVectors<order> &W) const
      {
        NodeVectors<order> L;
        for (int a = 0; a <= order; ++a)
          for (int b = 0; b <= order; ++b)
            L[a] += pair_inertia(e, a, b) * W[b];
        return L;
      }

      /** Adds the mean torques, which are the change of the angular momenta P_a
       * L_a in the step. */
      void add_mean_torques(const unsigned int e,
                            const Evaluation  &step,
                            const double       alpha,
                            double            *residual) const
      {
        const int *unknowns = numbering.element_unknowns(group.begin + e);
        const auto before   = gather(step.from.velocity->data(), unknowns, 3),
                   now      = gather(step.to.velocity->data(), unknowns, 3);
        NodeVectors<order> mean;
        for (int i = 0; i <= order; ++i)
          mean[i] = (before[i] + now[i]) / 2;
        const NodeVectors<order> momentum = momenta(e, mean),
                                 rate =
                                   momenta(e,
                                           gather(step.to.acceleration->data(),
                                                  unknowns,
                                                  3));
        for (int i = 0; i <= order; ++i)
          {
            const int *spin     = unknowns + n_components * i + 3;
            const int  rotation = numbering.rotations().with(*spin);
            scatter(RotaryInertia::mean_torque(step.from.rotations[rotation],
                                               step.to.rotations[rotation],
                                               momentum[i],
                                               rate[i],
                                               step.dt,
                                               alpha),
                    spin,
                    residual);
          }
      }

      /** @param mass factor of the mass matrix, damping included. */
      void add_rotary_tangent(const unsigned int    e,
                              const Evaluation     &evaluation,
                              const TangentFactors &factors,
                              const double          mass,
                              double               *block) const
      {
        const auto add =
          [block](const int i, const int j, const SpaceTensor &values) {
            for (int r = 0; r < 3; ++r)
              for (int c = 0; c < 3; ++c)
                block[(n_components * i + 3 + r) * n + n_components * j + 3 +
                      c] += values[r][c];
          };
        if constexpr (!large_rotation)
          {
            for (int i = 0; i <= order; ++i)
              for (int j = 0; j <= order; ++j)
                add(i, j, mass * pair_inertia(e, i, j));
            return;
          }
        const int *unknowns = numbering.element_unknowns(group.begin + e);
        const RotatingNodes rotating(*this,
                                     e,
                                     evaluation.to,
                                     evaluation.to.velocity->data());
        SpaceTensor         by_spin[order + 1];
        for (int i = 0; i <= order; ++i)
          by_spin[i] =
            node_rotations.increment_by_spin(evaluation,
                                             numbering.rotations().with(
                                               unknowns[n_components * i + 3]));
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          {
            // Derivatives by the motion at the end, see
            // RotaryInertia::mean_torque().
            const double turning = factors.stiffness *
              (2 / evaluation.dt + (damped ? elements[e].damping : 0.));
            for (int i = 0; i <= order; ++i)
              {
                for (int j = 0; j <= order; ++j)
                  add(i,
                      j,
                      mass *
                        rotated(rotating.rotation[i],
                                pair_inertia(e, i, j) * by_spin[j]));
                add(i,
                    i,
                    -turning *
                      cross_product_tensor(
                        rotated(rotating.rotation[i], rotating.momentum[i])));
              }
            return;
          }
        for (int i = 0; i <= order; ++i)
          {
            const SpaceTensor rotational =
              factors.damping * cross_product_tensor(rotating.velocity[i]);
            for (int j = 0; j <= order; ++j)
              {
                const SpaceTensor &M      = pair_inertia(e, i, j);
                SpaceTensor        values = mass * M + rotational * M;
                if (i == j)
                  values -= factors.damping *
                    cross_product_tensor(rotating.momentum[i]);
                add(i, j, rotated(rotating.rotation[i], values * by_spin[j]));
              }
            add(i,
                i,
                -factors.stiffness *
                  cross_product_tensor(
                    rotating.torque(i, damped ? elements[e].damping : 0.)));
          }
      }

      double product(const Vector &x,
                     const Vector &y,
                     const Weight  weight) const override
      {
        double sum = 0;
        for (unsigned int e = 0; e < elements.size(); ++e)
          if (elements[e].owned)
            {
              const int *unknowns = numbering.element_unknowns(group.begin + e);
              const auto v        = gather(x.data(), unknowns, 0);
              const auto w        = gather(y.data(), unknowns, 0);
              double     element_product = 0;
              for (int i = 0; i <= order; ++i)
                for (int j = 0; j <= order; ++j)
                  element_product +=
                    elements[e].mass * shape.mass[i][j] * (v[i] * w[j]);
              if (rotary)
                {
                  const auto W = gather(x.data(), unknowns, 3);
                  const auto L = momenta(e, gather(y.data(), unknowns, 3));
                  for (int i = 0; i <= order; ++i)
                    element_product += W[i] * L[i];
                }
              sum += weight(elements[e]) * element_product;
            }
        return sum;
      }

      const NodeRotations    node_rotations;
      const bool             rotary;
      const BeamShape<order> shape;
      /** M_ab (kg m2), n_pairs per element; empty without rotary inertia. */
      std::vector<SpaceTensor> pair_inertias;
    };
  } // namespace

  std::unique_ptr<Effect>
  make_space_strut_inertia(const Lattice              &lattice,
                           const DofNumbering         &numbering,
                           const DofNumbering::Group  &group,
                           const std::vector<Section> &sections,
                           const InertiaModel         &model)
  {
    const auto make = [&](auto order,
                          auto large_rotation,
                          auto damped) -> std::unique_ptr<Effect> {
      return std::make_unique<SpaceStrutInertia<order, large_rotation, damped>>(
        lattice,
        numbering,
        group,
        sections,
        model.rotary_inertia);
    };
    const std::true_type  yes;
    const std::false_type no;
    return dispatch_order<largest_space_order>(group.order, [&](auto order) {
      if (model.large_rotation)
        return model.damping ? make(order, yes, yes) : make(order, yes, no);
      return model.damping ? make(order, no, yes) : make(order, no, no);
    });
  }
} // namespace auxfem
