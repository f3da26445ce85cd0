#include <auxfem/model/constraint_unknowns.h>

#include <algorithm>

namespace auxfem
{
  ConstraintUnknowns::ConstraintUnknowns(
    const GlobalNumbers             &numbers,
    const UnknownLayout             &layout,
    const std::vector<unsigned int> &rigid_parts)
    : kept_rigid_parts(rigid_parts)
  {
    const auto all_local = [&layout](const auto &globals) {
      auto locals = globals;
      std::transform(globals.begin(),
                     globals.end(),
                     locals.begin(),
                     [&layout](const int g) { return layout.local(g); });
      return locals;
    };
    const auto keep = [this](const auto &multipliers) {
      for (const int multiplier : multipliers)
        if (multiplier >= 0)
          kept_multipliers.push_back(multiplier);
    };
    for (const GlobalNumbers::OfRigidPart &part : numbers.rigid_parts)
      of_rigid_part.push_back({all_local(part.motion),
                               part.clamped_joints,
                               all_local(part.multipliers)});
    for (const GlobalNumbers::OfHinge &hinge : numbers.hinges)
      of_hinge.push_back(all_local(hinge.multipliers));
    for (const unsigned int p : kept_rigid_parts)
      keep(of_rigid_part[p].multipliers);
    for (const std::array<int, 2> &multipliers : of_hinge)
      keep(multipliers);
  }

  unsigned int ConstraintUnknowns::n_multipliers() const
  {
    unsigned int sum = 2 * of_hinge.size();
    for (const OfRigidPart &part : of_rigid_part)
      sum += part.multipliers.size();
    return sum;
  }
} // namespace auxfem
