#include <auxfem/system/system.h>

namespace auxfem
{
  namespace
  {
    /** Value and first two derivatives of the courses of a support. */
    struct Course
    {
      Course(const Support &support, const double time, const double dt)
      {
        for (unsigned int c = 0; c < n_motion_components; ++c)
          if (!support.motion[c].is_zero())
            jets[c] = support.motion[c].jet(time, dt);
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
    SpaceVector rotation_of(const Support &support, const double time)
    {
      SpaceVector rotation;
      for (unsigned int c = 0; c < 3; ++c)
        rotation[c] = support.motion[first_rotation + c].value(time);
      return rotation;
    }

    /** @p material without what it has, in the global frame, about fixed axes. */
    SpaceVector without_fixed(const SpaceVector         &material,
                              const Quaternion          &rotation,
                              const std::array<bool, 3> &fixed)
    {
      SpaceVector spatial = rotated(rotation, material);
      for (unsigned int c = 0; c < 3; ++c)
        if (fixed[c])
          spatial[c] = 0;
      return rotated(conjugate(rotation), spatial);
    }

    /** Moves a rotation as a whole along @p course. */
    void prescribe(const NodeRotations &rotations,
                   const unsigned int   i,
                   const Course        &course,
                   const Step          &step)
    {
      const Quaternion  rotation = exponential(course.rotation(0));
      const SpaceVector turned =
        rotated(conjugate(step.from.rotations[i]),
                course.rotation(0) -
                  rotations.values(step.from.displacement, i));
      rotations.set_material_turn(
        step,
        i,
        rotation_vector_near(conjugate(step.from.rotations[i]) * rotation,
                             turned));
      const AngularMotion motion = angular_motion(course.rotation(0),
                                                  course.rotation(1),
                                                  course.rotation(2));
      if (step.to.velocity)
        rotations.set_values(motion.velocity, i, *step.to.velocity);
      if (step.to.acceleration)
        rotations.set_values(motion.acceleration, i, *step.to.acceleration);
    }

    /** Holds a rotation about some axes. */
    void hold(const NodeRotations       &rotations,
              const unsigned int         i,
              const std::array<bool, 3> &fixed,
              const Step                &step)
    {
      const Quaternion &before = step.from.rotations[i];
      const SpaceVector turn =
        without_fixed(rotations.material_turn(step, i), before, fixed);
      rotations.set_material_turn(step, i, turn);
      const Quaternion after = before * exponential(turn);
      for (std::optional<Vector> *rate :
           {&step.to.velocity, &step.to.acceleration})
        if (*rate)
          rotations.set_values(without_fixed(rotations.values(**rate, i),
                                             after,
                                             fixed),
                               i,
                               **rate);
    }
  } // namespace

  void System::prescribe_motion(const Step &step, const double dt) const
  {
    State &state = step.to;
    for (const Support &support : support_list)
      {
        const Course course(support, state.time, dt);
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          {
            if (support.moves_as_rotation(prescribed))
              continue;
            const auto &jet = course.jets[prescribed.component];
            state.displacement[prescribed.unknown] = jet[0];
            if (state.velocity)
              (*state.velocity)[prescribed.unknown] = jet[1];
            if (state.acceleration)
              (*state.acceleration)[prescribed.unknown] = jet[2];
          }
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          if (prescribed.is_whole())
            prescribe(*node_rotations, prescribed.rotation, course, step);
          else
            hold(*node_rotations, prescribed.rotation, prescribed.fixed, step);
      }
    node_rotations->follow(step);
  }

  void System::right_side(const Step &step, double *right_side) const
  {
    const State &state = step.to;
    for (unsigned int i = 0; i < dofs->n_owned(); ++i)
      right_side[i] = -state.residual[i];
    for (const Support &support : support_list)
      {
        std::array<double, n_motion_components> places;
        for (unsigned int c = 0; c < n_motion_components; ++c)
          places[c] = support.motion[c].value(state.time);
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (dofs->is_owned(prescribed.unknown) &&
              !support.moves_as_rotation(prescribed))
            right_side[prescribed.unknown] = places[prescribed.component] -
              state.displacement[prescribed.unknown];
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const unsigned int        i       = prescribed.rotation;
            const SpaceVector         missing = prescribed.is_whole()
                      ? rotation_vector(exponential(rotation_of(support, state.time)) *
                                conjugate(state.rotations[i]))
                      : -node_rotations->spatial_turn(step, i);
            const std::array<int, 3> &spins   = dofs->spatial_rotations()[i];
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c] && dofs->is_owned(spins[c]))
                right_side[spins[c]] = missing[c];
          }
      }
  }

  double System::support_work(const Step &step) const
  {
    // By the mean of the support forces over the step.
    const auto mean_force = [&](const int unknown) {
      return (step.from.residual[unknown] + step.to.residual[unknown]) / 2;
    };
    double work = 0;
    for (const Support &support : support_list)
      {
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (const int i = prescribed.unknown;
              dofs->is_owned(i) && !support.moves_as_rotation(prescribed))
            work += mean_force(i) *
              (step.to.displacement[i] - step.from.displacement[i]);
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const std::array<int, 3> &spins =
              dofs->spatial_rotations()[prescribed.rotation];
            const SpaceVector turn =
              node_rotations->spatial_turn(step, prescribed.rotation);
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c] && dofs->is_owned(spins[c]))
                work += mean_force(spins[c]) * turn[c];
          }
      }
    return work;
  }
} // namespace auxfem
