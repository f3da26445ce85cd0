#include <auxfem/system/effects/following_loads.h>

namespace auxfem
{
  FollowingLoads::FollowingLoads(const Lattice      &lattice,
                                 const DofNumbering &numbering,
                                 const bool          raised_from_zero)
    : is_planar(lattice.dimension == 2)
    , numbering(numbering)
    , rotations(numbering)
    , raised_from_zero(raised_from_zero)
  {}

  void FollowingLoads::add(
    const std::array<TimeFunction, n_motion_components> &components,
    const unsigned int                                   joint)
  {
    Load load;
    load.components = components;
    for (unsigned int c = 0; c < n_motion_components; ++c)
      load.unknowns[c] = numbering.joint_unknown(joint, c);
    loads.push_back(load);
  }

  bool FollowingLoads::empty() const
  {
    return loads.empty();
  }

  bool FollowingLoads::is_linear() const
  {
    return false;
  }

  void FollowingLoads::register_blocks(TangentMatrix &matrix)
  {
    for (unsigned int i = 0; i < loads.size(); ++i)
      {
        const std::size_t block =
          matrix.register_block(loads[i].unknowns.data(), n_motion_components);
        if (i == 0)
          first_block = block;
      }
  }

  FollowingLoads::Values FollowingLoads::values(const Load  &load,
                                                const double time)
  {
    Values values;
    for (unsigned int c = 0; c < n_motion_components; ++c)
      if (!load.components[c].is_zero())
        (c < 3 ? values.force : values.moment)[c % 3] =
          load.components[c].value(time);
    return values;
  }

  void FollowingLoads::begin_step(const Step &step)
  {
    for (Load &load : loads)
      {
        load.before = raised_from_zero && step.from.time == 0
          ? Values()
          : values(load, step.from.time);
        load.now    = values(load, step.to.time);
      }
  }

  Quaternion FollowingLoads::rotation(const Load  &load,
                                      const State &state) const
  {
    const int turn_about_z = load.unknowns[rotation_z];
    return is_planar
      ? exponential(SpaceVector({0, 0, state.displacement[turn_about_z]}))
      : state.rotations[numbering.spatial_rotation(turn_about_z)];
  }

  void FollowingLoads::add_residual(const Step &step, double *residual)
  {
    for (const Load &load : loads)
      {
        const Quaternion  P      = rotation(load, step.to);
        const SpaceVector force  = rotated(P, load.now.force),
                          moment = rotated(P, load.now.moment);
        for (unsigned int c = 0; c < n_motion_components; ++c)
          if (load.unknowns[c] >= 0)
            residual[load.unknowns[c]] -= (c < 3 ? force : moment)[c % 3];
      }
  }

  void FollowingLoads::add_tangent(const Step           &step,
                                   const TangentFactors &factors,
                                   TangentMatrix        &matrix) const
  {
    for (unsigned int i = 0; i < loads.size(); ++i)
      {
        const Quaternion  P          = rotation(loads[i], step.to);
        const SpaceTensor by_spin[2] = {
          factors.stiffness *
            cross_product_tensor(rotated(P, loads[i].now.force)),
          factors.stiffness *
            cross_product_tensor(rotated(P, loads[i].now.moment))};
        double block[n_motion_components * n_motion_components] = {};
        for (unsigned int r = 0; r < n_motion_components; ++r)
          for (unsigned int c = 0; c < 3; ++c)
            block[r * n_motion_components + first_rotation + c] =
              by_spin[r / 3][r % 3][c];
        matrix.add(first_block + i, block);
      }
  }

  void FollowingLoads::accept(const Step &step)
  {
    // As for dead loads, by the mean of the forces over the step. The moment is
    // constant in axes that turn with the joint, as is the turn itself.
    for (const Load &load : loads)
      {
        if (!numbering.is_owned(load.unknowns[0]))
          continue;
        const SpaceVector force =
          (rotated(rotation(load, step.from), load.before.force) +
           rotated(rotation(load, step.to), load.now.force)) /
          2;
        const SpaceVector moment = (load.before.moment + load.now.moment) / 2;
        for (unsigned int c = 0; c < n_motion_components; ++c)
          if (const int unknown = load.unknowns[c]; unknown >= 0)
            step.to.external_work += (c < 3 ? force : moment)[c % 3] *
              (step.to.displacement[unknown] - step.from.displacement[unknown]);
      }
  }
} // namespace auxfem
