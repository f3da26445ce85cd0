#include <auxfem/model/numbering.h>

// What of the numbering belongs to rigid parts, hinges and springs.

namespace auxfem
{
  namespace
  {
    /** Local number of @p global, which may be -1: not there. */
    int local_number(const Epetra_Map &local, const int global)
    {
      return global < 0 ? -1 : local.LID(global);
    }
  } // namespace

  std::vector<int>
  DofNumbering::rigid_part_numbers(const unsigned int rigid_part) const
  {
    const RigidPartUnknowns &unknowns = of_rigid_part[rigid_part];
    std::vector<int>         numbers  = unknowns.multipliers;
    numbers.insert(numbers.end(),
                   unknowns.motion.begin(),
                   unknowns.motion.end());
    for (const unsigned int joint : lattice.rigid_parts[rigid_part].joints)
      for (unsigned int component = 0; component < lattice.dimension;
           ++component)
        numbers.push_back(joint_numbers[joint][component]);
    for (const unsigned int joint : unknowns.clamped_joints)
      numbers.push_back(joint_numbers[joint][rotation_z]);
    return numbers;
  }

  DofNumbering::MotionNumbers
  DofNumbering::rotation_numbers(const Turning &turning) const
  {
    MotionNumbers numbers = {{-1, -1, -1, -1, -1, -1}};
    const auto    take    = [&numbers](const MotionNumbers &from) {
      for (unsigned int c = first_rotation; c < n_motion_components; ++c)
        numbers[c] = from[c];
    };
    switch (turning.what)
      {
        case Turning::What::ground:
          break;
        case Turning::What::joint:
          take(joint_numbers[turning.index]);
          break;
        case Turning::What::strut_end:
          take(released_end_numbers.at({turning.index, turning.end}));
          break;
        case Turning::What::rigid_part:
          take(of_rigid_part[turning.index].motion);
          break;
      }
    return numbers;
  }

  std::vector<std::vector<int>>
  DofNumbering::coupled_numbers(const Ties &ties) const
  {
    std::vector<std::vector<int>> coupled;
    const auto                    add = [&](const TurningPair &pair) {
      coupled.emplace_back();
      for (const Turning &turning : {pair.base, pair.end})
        for (const int number : rotation_numbers(turning))
          if (number >= 0)
            coupled.back().push_back(number);
    };
    for (const TurningPair &pair : ties.sprung)
      add(pair);
    for (unsigned int h = 0; h < ties.hinged.size(); ++h)
      {
        add(ties.hinged[h]);
        coupled.back().insert(coupled.back().end(),
                              of_hinge[h].multipliers.begin(),
                              of_hinge[h].multipliers.end());
      }
    return coupled;
  }

  void DofNumbering::index_multipliers()
  {
    const auto keep = [this](const int global) {
      const int l = local->LID(global);
      if (l < 0)
        return;
      kept_multipliers.push_back(l);
      kinds[l] = UnknownKind::multiplier;
    };
    for (const unsigned int p : kept_rigid_parts)
      for (const int global : of_rigid_part[p].multipliers)
        keep(global);
    for (const HingeUnknowns &hinge : of_hinge)
      for (const int global : hinge.multipliers)
        keep(global);
  }

  void DofNumbering::mark_rotations()
  {
    const auto mark = [this](const int l) {
      if (l < 0)
        return;
      kinds[l]     = UnknownKind::rotation;
      rotations[l] = true;
    };
    const auto mark_all = [&](const MotionNumbers &numbers) {
      for (unsigned int c = first_rotation; c < n_motion_components; ++c)
        mark(local_number(*local, numbers[c]));
    };
    for (std::size_t i = 0; i < element_numbers.size(); ++i)
      if (node_components[i % n_components()] >= first_rotation)
        mark(element_numbers[i]);
    for (const MotionNumbers &joint : joint_numbers)
      mark_all(joint);
    for (const auto &end : released_end_numbers)
      mark_all(end.second);
    for (const RigidPartUnknowns &part : of_rigid_part)
      mark_all(part.motion);
  }

  void DofNumbering::mark_prescribed(const std::vector<JointMotion> &motions)
  {
    for (const JointMotion &motion : motions)
      if (const int l = joint_unknown(motion.joint, motion.component); l >= 0)
        kinds[l] = UnknownKind::prescribed;
  }

  void DofNumbering::index_rotations()
  {
    rotation_of_unknown.assign(n_local(), -1);
    const auto add = [this](const std::array<int, 3> &spins) {
      if (spins[0] < 0 || rotation_of_unknown[spins[0]] >= 0)
        return;
      for (const int spin : spins)
        rotation_of_unknown[spin] = rotations_in_space.size();
      rotations_in_space.push_back(spins);
    };
    const auto add_global = [&](const MotionNumbers &numbers) {
      add({{local_number(*local, numbers[3]),
            local_number(*local, numbers[4]),
            local_number(*local, numbers[5])}});
    };
    for (std::size_t i = 0; i < element_numbers.size(); i += n_components())
      add({{element_numbers[i + 3],
            element_numbers[i + 4],
            element_numbers[i + 5]}});
    for (const MotionNumbers &joint : joint_numbers)
      add_global(joint);
    for (const auto &end : released_end_numbers)
      add_global(end.second);
    for (const RigidPartUnknowns &part : of_rigid_part)
      add_global(part.motion);
  }

  int DofNumbering::rotation_unknown(const Turning     &turning,
                                     const unsigned int component) const
  {
    return local_number(*local, rotation_numbers(turning)[component]);
  }

  int DofNumbering::rigid_part_unknown(const unsigned int rigid_part,
                                       const unsigned int component) const
  {
    return local_number(*local, of_rigid_part[rigid_part].motion[component]);
  }

  int DofNumbering::multiplier(const unsigned int rigid_part,
                               const unsigned int number) const
  {
    return local->LID(of_rigid_part[rigid_part].multipliers[number]);
  }

  unsigned int DofNumbering::n_multipliers(const unsigned int rigid_part) const
  {
    return of_rigid_part[rigid_part].multipliers.size();
  }

  int DofNumbering::hinge_multiplier(const unsigned int hinge,
                                     const unsigned int number) const
  {
    return local->LID(of_hinge[hinge].multipliers[number]);
  }

  const std::vector<unsigned int> &
  DofNumbering::clamped_joints(const unsigned int rigid_part) const
  {
    return of_rigid_part[rigid_part].clamped_joints;
  }

  const std::vector<unsigned int> &DofNumbering::rigid_parts() const
  {
    return kept_rigid_parts;
  }

  const std::vector<int> &DofNumbering::multipliers() const
  {
    return kept_multipliers;
  }

  unsigned int DofNumbering::n_multipliers() const
  {
    unsigned int sum = 0;
    for (const RigidPartUnknowns &part : of_rigid_part)
      sum += part.multipliers.size();
    for (const HingeUnknowns &hinge : of_hinge)
      sum += hinge.multipliers.size();
    return sum;
  }
} // namespace auxfem
