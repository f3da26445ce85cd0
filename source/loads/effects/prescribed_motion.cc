#include <auxfem/equations/load_work.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/prescribed_motion.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Value and first two derivatives of the time histories of a support. */
    struct SupportMotion
    {
      SupportMotion(const Support &support, const Evaluation &evaluation)
      {
        const TimeLimit at = evaluation.event_at_to.value_or(
          TimeLimit{time_of_loads(evaluation.to), TimeSide::after});
        for (unsigned int c = 0; c < n_motion_components; ++c)
          if (!support.motion[c].is_zero())
            {
              jets[c] = support.motion[c].jet(at.time, at.side);
              // Same digits as in find_right_side().
              jets[c][0] = value_at_end(support.motion[c], evaluation);
            }
      }

      /** Sets the derivatives to zero; on a path they are not rates. */
      void clear_rates()
      {
        for (std::array<double, 3> &jet : jets)
          jet[1] = jet[2] = 0;
      }

      /** Derivative number @p derivative of the rotation vector. */
      SpaceVector rotation(const unsigned int derivative) const
      {
        return SpaceVector({jets[first_rotation][derivative],
                            jets[first_rotation + 1][derivative],
                            jets[first_rotation + 2][derivative]});
      }

      std::array<std::array<double, 3>, n_motion_components> jets = {};
    };

    /** The rotation vector of a support (rad). */
    SpaceVector rotation_of(const Support    &support,
                            const Evaluation &evaluation)
    {
      SpaceVector rotation;
      for (unsigned int c = 0; c < 3; ++c)
        rotation[c] =
          value_at_end(support.motion[first_rotation + c], evaluation);
      return rotation;
    }

    /** Replaces components of the vector @p material about @p fixed global axes
     * by those of @p about_axes. */
    SpaceVector replace_fixed(const SpaceVector         &material,
                              const Quaternion          &rotation,
                              const std::array<bool, 3> &fixed,
                              const SpaceVector         &about_axes)
    {
      SpaceVector spatial = rotated(rotation, material);
      for (unsigned int c = 0; c < 3; ++c)
        if (fixed[c])
          spatial[c] = about_axes[c];
      return rotated(conjugate(rotation), spatial);
    }

    /** Change of the prescribed angles (rad) from one state to the other, for a
     * support that prescribes rotations about some axes. */
    SpaceVector angle_increment(const Support    &support,
                                const Evaluation &evaluation)
    {
      SpaceVector increment;
      if (evaluation.kind != Evaluation::Kind::consistent_rates)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const TimeFunction &angle = support.motion[first_rotation + c];
            increment[c]              = value_at_end(angle, evaluation) -
              value_at_start(angle, evaluation);
          }
      return increment;
    }

    /** Sets a rotation whose three components are prescribed. */
    void prescribe(const NodeRotations &rotations,
                   const unsigned int   i,
                   const SupportMotion &support,
                   const Evaluation    &evaluation)
    {
      const Quaternion  rotation = exponential(support.rotation(0));
      const SpaceVector approximation =
        rotated(conjugate(evaluation.from.rotations[i]),
                support.rotation(0) -
                  rotations.values(evaluation.from.displacement, i));
      rotations.set_material_increment(
        evaluation,
        i,
        rotation_vector_near(conjugate(evaluation.from.rotations[i]) * rotation,
                             approximation));
      const AngularMotion motion = angular_motion(support.rotation(0),
                                                  support.rotation(1),
                                                  support.rotation(2));
      if (evaluation.to.velocity)
        rotations.set_values(motion.velocity, i, *evaluation.to.velocity);
      if (evaluation.to.acceleration)
        rotations.set_values(motion.acceleration,
                             i,
                             *evaluation.to.acceleration);
    }

    /** Sets mean accelerations of prescribed unknowns from their velocities. */
    void set_mean_accelerations(const LatticeModel &model,
                                const Evaluation   &step)
    {
      const double *before       = step.from.velocity->data();
      const double *now          = step.to.velocity->data();
      double       *acceleration = step.to.acceleration->data();
      for (const Support &support : model.supports)
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          {
            const int i     = prescribed.unknown;
            acceleration[i] = (now[i] - before[i]) / step.dt;
          }
    }

    /**
     * Missing spin (rad) of a rotation that is prescribed about some axes. At a
     * stage the angular velocity is prescribed: angles over several stages are
     * not defined, as the other axes turn with the node.
     */
    SpaceVector missing_about_axes(const Support       &support,
                                   const NodeRotations &rotations,
                                   const unsigned int   i,
                                   const Evaluation    &evaluation)
    {
      const State &state = evaluation.to;
      if (evaluation.kind == Evaluation::Kind::stage)
        return evaluation.dt *
          (SupportMotion(support, evaluation).rotation(1) -
           rotated(state.rotations[i], rotations.values(*state.velocity, i)));
      return angle_increment(support, evaluation) -
        rotations.spatial_increment(evaluation, i);
    }

    /** Sets the prescribed components of a rotation about some axes. */
    void prescribe_about_axes(const NodeRotations               &rotations,
                              const Support::PrescribedRotation &prescribed,
                              const Support                     &support,
                              const SupportMotion               &motion,
                              const Evaluation                  &evaluation)
    {
      const unsigned int i      = prescribed.rotation;
      const Quaternion  &before = evaluation.from.rotations[i];
      const SpaceVector  increment =
        replace_fixed(rotations.material_increment(evaluation, i),
                      before,
                      prescribed.fixed,
                      angle_increment(support, evaluation));
      rotations.set_material_increment(evaluation, i, increment);
      const Quaternion after = before * exponential(increment);
      const auto       set   = [&](std::optional<Vector> &rate,
                           const unsigned int     derivative) {
        if (rate)
          rotations.set_values(replace_fixed(rotations.values(*rate, i),
                                             after,
                                             prescribed.fixed,
                                             motion.rotation(derivative)),
                               i,
                               *rate);
      };
      set(evaluation.to.velocity, 1);
      set(evaluation.to.acceleration, 2);
    }
  } // namespace

  void prescribe_motion(const LatticeModel &model, const Evaluation &evaluation)
  {
    const NodeRotations rotations(model.numbering);
    State              &state = evaluation.to;
    for (const Support &support : model.supports)
      {
        SupportMotion motion(support, evaluation);
        if (state.path)
          motion.clear_rates();
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          {
            if (support.moves_as_rotation(prescribed))
              continue;
            const auto &jet = motion.jets[prescribed.component];
            state.displacement[prescribed.unknown] = jet[0];
            if (state.velocity)
              (*state.velocity)[prescribed.unknown] = jet[1];
            if (state.acceleration)
              (*state.acceleration)[prescribed.unknown] = jet[2];
          }
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          if (prescribed.is_whole())
            prescribe(rotations, prescribed.rotation, motion, evaluation);
          else if (evaluation.kind != Evaluation::Kind::stage)
            prescribe_about_axes(rotations,
                                 prescribed,
                                 support,
                                 motion,
                                 evaluation);
      }
    rotations.follow(evaluation);
    if (evaluation.kind == Evaluation::Kind::discrete_gradient)
      set_mean_accelerations(model, evaluation);
  }

  bool prescribes_all(const LatticeModel &model, const Evaluation &evaluation)
  {
    if (evaluation.kind != Evaluation::Kind::stage)
      return true;
    for (const Support &support : model.supports)
      for (const Support::PrescribedRotation &prescribed : support.rotations)
        if (!prescribed.is_whole() && support.moves(prescribed))
          return false;
    return true;
  }

  void copy_fixed_support_velocities(const LatticeModel &model,
                                     const State        &after,
                                     State              &before)
  {
    const NodeRotations rotations(model.numbering);
    for (const Support &support : model.supports)
      {
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (!support.moves_as_rotation(prescribed) &&
              !support.moves(prescribed))
            (*before.velocity)[prescribed.unknown] =
              (*after.velocity)[prescribed.unknown];
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          if (!support.moves(prescribed))
            rotations.set_values(rotations.values(*after.velocity,
                                                  prescribed.rotation),
                                 prescribed.rotation,
                                 *before.velocity);
      }
  }

  void find_motion_derivative(const LatticeModel &model,
                              const Evaluation   &evaluation,
                              double             *derivative)
  {
    const UnknownLayout &layout = model.numbering.layout();
    for (const Support &support : model.supports)
      {
        if (support.is_at_rest())
          continue;
        const SupportMotion motion(support, evaluation);
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (layout.is_owned(prescribed.unknown) &&
              !support.moves_as_rotation(prescribed))
            derivative[prescribed.unknown] =
              motion.jets[prescribed.component][1];
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const SpaceVector         spin = prescribed.is_whole()
                      ? rotated(exponential(motion.rotation(0)),
                        angular_motion(motion.rotation(0),
                                       motion.rotation(1),
                                       motion.rotation(2))
                          .velocity)
                      : motion.rotation(1);
            const std::array<int, 3> &spins =
              model.numbering.rotations()[prescribed.rotation];
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c] && layout.is_owned(spins[c]))
                derivative[spins[c]] = spin[c];
          }
      }
  }

  double find_velocity_jumps(const LatticeModel &model,
                             const State        &before,
                             const State        &after,
                             double             *jumps)
  {
    const NodeRotations  rotations(model.numbering);
    const UnknownLayout &layout  = model.numbering.layout();
    double               largest = 0;
    const auto           set     = [&](const int unknown, const double jump) {
      if (!layout.is_owned(unknown))
        return;
      jumps[unknown] = jump;
      largest        = std::max(largest, std::abs(jump));
    };
    for (const Support &support : model.supports)
      {
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (const int i = prescribed.unknown;
              !support.moves_as_rotation(prescribed))
            set(i, (*after.velocity)[i] - (*before.velocity)[i]);
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const unsigned int i = prescribed.rotation;
            const SpaceVector  jump =
              rotated(after.rotations[i],
                      rotations.values(*after.velocity, i) -
                        rotations.values(*before.velocity, i));
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c])
                set(model.numbering.rotations()[i][c], jump[c]);
          }
      }
    return layout.largest(largest);
  }

  void find_right_side(const LatticeModel &model,
                       const Evaluation   &evaluation,
                       double             *right_side)
  {
    const State        &state     = evaluation.to;
    const DofNumbering &numbering = model.numbering;
    const NodeRotations rotations(numbering);
    for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
      right_side[i] = -state.residual[i];
    for (const Support &support : model.supports)
      {
        std::array<double, n_motion_components> positions;
        for (unsigned int c = 0; c < n_motion_components; ++c)
          positions[c] = value_at_end(support.motion[c], evaluation);
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (numbering.layout().is_owned(prescribed.unknown) &&
              !support.moves_as_rotation(prescribed))
            right_side[prescribed.unknown] = positions[prescribed.component] -
              state.displacement[prescribed.unknown];
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const unsigned int        i       = prescribed.rotation;
            const SpaceVector         missing = prescribed.is_whole()
                      ? rotation_vector(exponential(rotation_of(support, evaluation)) *
                                conjugate(state.rotations[i]))
                      : missing_about_axes(support, rotations, i, evaluation);
            const std::array<int, 3> &spins   = numbering.rotations()[i];
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c] && numbering.layout().is_owned(spins[c]))
                right_side[spins[c]] = missing[c];
          }
      }
  }

  double support_work_error(const LatticeModel &model, const Evaluation &step)
  {
    Vector changes(step.to.displacement.size(), 0.);
    find_velocity_jumps(model, step.from, step.to, changes.data());
    double sum = 0;
    for (const Support &support : model.supports)
      for (const Support::PrescribedUnknown &prescribed : support.unknowns)
        if (const int i = prescribed.unknown;
            model.numbering.layout().is_owned(i))
          sum += std::abs((step.to.residual[i] - step.from.residual[i]) *
                          changes[i]);
    return step.dt / 12 * model.numbering.layout().sum(sum);
  }

  bool supports_are_at_rest(const LatticeModel &model)
  {
    return std::all_of(model.supports.begin(),
                       model.supports.end(),
                       [](const Support &support) {
                         return support.is_at_rest();
                       });
  }

  Vector load_direction(const Equations  &equations,
                        const Evaluation &evaluation)
  {
    Vector loads = equations.load_derivative(evaluation);
    scale(-1., loads);
    const Unknowns &unknowns = equations.unknowns();
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        loads[i] = 0;
    find_motion_derivative(equations.model(), evaluation, loads.data());
    return loads;
  }
} // namespace auxfem
