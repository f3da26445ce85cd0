#include <auxfem/equations/node_rotations.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /**
     * Constraints of rigid parts in space with rotation unknowns: g = u - u_c -
     * (P - I) X = 0 for each joint at X from the centre of mass at rest. The
     * multiplier lambda is the force of the joint on the part.
     */
    class RotatingParts : public RigidPartGroup
    {
    public:
      RotatingParts(const std::vector<RotatingBody> &bodies,
                    const RigidPartSetting          &setting)
        : bodies(bodies)
        , lattice(setting.lattice)
        , numbering(setting.numbering)
        , large_rotation(setting.large_rotation)
      {
        for (unsigned int b = 0; b < bodies.size(); ++b)
          {
            const RotatingBody &body = bodies[b];
            const RigidPart    &part = lattice.rigid_parts[body.part];
            joint_begin.push_back(joints.size());
            for (unsigned int k = 0; k < part.joints.size(); ++k)
              {
                Joint joint;
                joint.arm =
                  lattice.joints[part.joints[k]] - part.centre_of_mass;
                joint.body = b;
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    joint.unknowns[c] =
                      numbering.joint_unknown(part.joints[k], c);
                    joint.unknowns[3 + c] = body.centre[c];
                    joint.unknowns[6 + c] = body.rotation[c];
                    joint.unknowns[9 + c] =
                      numbering.constraints().multiplier(body.part, 3 * k + c);
                  }
                longest_arm = std::max(longest_arm, joint.arm.norm());
                joints.push_back(joint);
              }
            if (body.owned)
              reported.push_back(b);
          }
        joint_begin.push_back(joints.size());
      }

      bool is_linear() const override
      {
        return !large_rotation;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block = pattern.register_blocks(joints, &Joint::unknowns);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        const Vector &u = evaluation.to.displacement;
        for (const Joint &joint : joints)
          {
            const SpaceVector lambda = values(u, joint, 9),
                              moment =
                                dealii::cross_product_3d(lambda,
                                                         lever(joint,
                                                               evaluation)),
                              row = evaluation.has_constraint_accelerations()
              ? second_derivative(joint, evaluation.to)
              : constraint(joint, evaluation.to);
            for (unsigned int c = 0; c < 3; ++c)
              {
                residual[joint.unknowns[c]] += lambda[c];
                residual[joint.unknowns[3 + c]] -= lambda[c];
                residual[joint.unknowns[6 + c]] += moment[c];
                residual[joint.unknowns[9 + c]] += row[c];
              }
          }
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        for (unsigned int i = 0; i < joints.size(); ++i)
          {
            const Joint      &joint = joints[i];
            const SpaceTensor X =
                                cross_product_tensor(arm(joint, evaluation.to)),
                              L =
                                cross_product_tensor(lever(joint, evaluation));
            double block[144] = {};
            for (unsigned int r = 0; r < 3; ++r)
              {
                block[12 * r + 9 + r] = block[12 * (9 + r) + r] = 1;
                block[12 * (3 + r) + 9 + r] = block[12 * (9 + r) + 3 + r] = -1;
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    block[12 * (9 + r) + 6 + c] = X[r][c];
                    block[12 * (6 + c) + 9 + r] = L[r][c];
                  }
              }
            if (large_rotation)
              {
                const SpaceTensor geometric = -factors.stiffness *
                  (cross_product_tensor(
                     values(evaluation.to.displacement, joint, 9)) *
                   X);
                for (unsigned int r = 0; r < 3; ++r)
                  for (unsigned int c = 0; c < 3; ++c)
                    block[12 * (6 + r) + 6 + c] = geometric[r][c];
              }
            matrix.add(first_block + i, block);
          }
      }

      void row_force_bounds(const Evaluation &evaluation,
                            const EffectCache * /*results*/,
                            double *forces) const override
      {
        const Vector &u = evaluation.to.displacement;
        for (const Joint &joint : joints)
          {
            const double lambda = values(u, joint, 9).norm();
            for (unsigned int c = 0; c < 3; ++c)
              {
                raise_bound(forces, joint.unknowns[c], lambda);
                raise_bound(forces, joint.unknowns[3 + c], lambda);
                raise_bound(forces,
                            joint.unknowns[6 + c],
                            lambda * joint.arm.norm());
              }
          }
      }

      void find_rates(const State &state, double *rates) const override
      {
        for (const Joint &joint : joints)
          {
            const SpaceVector rate = relative(*state.velocity, joint) -
              dealii::cross_product_3d(spatial(*state.velocity, joint, state),
                                       arm(joint, state));
            for (unsigned int c = 0; c < 3; ++c)
              rates[joint.unknowns[9 + c]] = rate[c];
          }
      }

      double length() const override
      {
        return longest_arm;
      }

      unsigned int n_reported() const override
      {
        return reported.size();
      }

      unsigned int part(const unsigned int i) const override
      {
        return bodies[reported[i]].part;
      }

      SpaceVector rotation(const unsigned int i,
                           const State       &state) const override
      {
        const std::array<int, 3> &spins = bodies[reported[i]].rotation;
        return large_rotation
          ? rotation_vector(quaternion(bodies[reported[i]], state))
          : vector_at(state.displacement.data(), spins.data());
      }

      PointMotion motion(const unsigned int      i,
                         const dealii::Point<3> &point,
                         const State            &state) const override
      {
        const unsigned int b = reported[i];
        // Every joint of the body holds its unknowns.
        Joint body_point = joints[joint_begin[b]];
        body_point.arm   = point - lattice.rigid_parts[part(i)].centre_of_mass;
        PointMotion result;
        result.displacement =
          values(state.displacement, body_point, 3) + turn(body_point, state);
        if (state.velocity)
          result.velocity = values(*state.velocity, body_point, 3) +
            dealii::cross_product_3d(spatial(*state.velocity,
                                             body_point,
                                             state),
                                     arm(body_point, state));
        return result;
      }

      RigidPartReport report(const unsigned int i,
                             const State       &state) const override
      {
        const unsigned int b = reported[i];
        RigidPartReport    report{bodies[b].part, {}};
        for (unsigned int k = joint_begin[b]; k < joint_begin[b + 1]; ++k)
          report.forces.push_back(values(state.displacement, joints[k], 9));
        return report;
      }

    private:
      struct Joint
      {
        /** Unknowns of the joint, centre, rotation, multipliers; three each. */
        std::array<int, 12> unknowns;
        SpaceVector         arm;  ///< X (m)
        unsigned int        body; ///< index into bodies
      };

      /** Values of @p vector at three unknowns of a joint, starting at @p
       * first. */
      static SpaceVector
      values(const Vector &vector, const Joint &joint, const unsigned int first)
      {
        return vector_at(vector.data(), &joint.unknowns[first]);
      }

      /** Values at the joint minus values at the centre. */
      static SpaceVector relative(const Vector &vector, const Joint &joint)
      {
        return values(vector, joint, 0) - values(vector, joint, 3);
      }

      /** P; the identity if rotations are small. */
      Quaternion quaternion(const RotatingBody &body, const State &state) const
      {
        return large_rotation
          ? state.rotations[numbering.rotations().with(body.rotation[0])]
          : Quaternion();
      }

      /** P X. */
      SpaceVector arm(const Joint &joint, const State &state) const
      {
        return rotated(quaternion(bodies[joint.body], state), joint.arm);
      }

      /**
       * Lever arm of the joint force. With Kind::discrete_gradient it is the
       * mean of P X: its product with Cayley's measure of the rotation is the
       * change of P X, so the force does no work.
       */
      SpaceVector lever(const Joint &joint, const Evaluation &evaluation) const
      {
        const SpaceVector end = arm(joint, evaluation.to);
        return evaluation.kind == Evaluation::Kind::discrete_gradient
          ? (arm(joint, evaluation.from) + end) / 2
          : end;
      }

      /** (P - I) X. */
      SpaceVector turn(const Joint &joint, const State &state) const
      {
        return large_rotation
          ? rotation_change(quaternion(bodies[joint.body], state), joint.arm)
          : dealii::cross_product_3d(values(state.displacement, joint, 6),
                                     joint.arm);
      }

      /** Angular velocity or acceleration in @p vector, in the global frame. */
      SpaceVector spatial(const Vector &vector,
                          const Joint  &joint,
                          const State  &state) const
      {
        return rotated(quaternion(bodies[joint.body], state),
                       values(vector, joint, 6));
      }

      SpaceVector constraint(const Joint &joint, const State &state) const
      {
        return relative(state.displacement, joint) - turn(joint, state);
      }

      SpaceVector second_derivative(const Joint &joint,
                                    const State &state) const
      {
        const SpaceVector x      = arm(joint, state);
        SpaceVector       result = relative(*state.acceleration, joint) -
          dealii::cross_product_3d(spatial(*state.acceleration, joint, state),
                                   x);
        if (large_rotation)
          {
            const SpaceVector rate = spatial(*state.velocity, joint, state);
            result -=
              dealii::cross_product_3d(rate, dealii::cross_product_3d(rate, x));
          }
        return result;
      }

      const std::vector<RotatingBody> bodies;
      const Lattice                  &lattice;
      const DofNumbering             &numbering;
      const bool                      large_rotation;
      std::vector<Joint>              joints;
      /** Range of body b: [b] to [b + 1]. */
      std::vector<unsigned int> joint_begin;
      std::vector<unsigned int> reported; ///< bodies
      std::size_t               first_block = 0;
      double                    longest_arm = 0;
    };
  } // namespace

  std::unique_ptr<RigidPartGroup>
  make_rotating_parts(const std::vector<RotatingBody> &bodies,
                      const RigidPartSetting          &setting)
  {
    return std::make_unique<RotatingParts>(bodies, setting);
  }
} // namespace auxfem
