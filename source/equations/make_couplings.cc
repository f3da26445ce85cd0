#include <auxfem/equations/effects/revolute_hinges.h>
#include <auxfem/equations/effects/rotational_springs.h>
#include <auxfem/equations/make_effects.h>

namespace auxfem
{
  namespace
  {
    /** Local numbers of the rotation about x, y, z; -1: not there. */
    std::array<int, 3> spins(const DofNumbering  &numbering,
                             const RotationOwner &rotation_owner)
    {
      std::array<int, 3> unknowns;
      for (unsigned int c = 0; c < 3; ++c)
        unknowns[c] =
          numbering.rotation_unknown(rotation_owner, first_rotation + c);
      return unknowns;
    }

    /** Calls @p add(number, stiffness, base, end) for springs kept on this rank.
     */
    template <class Add>
    void for_each_spring(const LatticeModel &model, const Add &add)
    {
      const DofNumbering &numbering = model.numbering;
      unsigned int        number    = 0;
      for (const JointRelease &release : model.releases)
        if (release.definition->type ==
            JointDefinition::Type::rotational_spring)
          for (const RotationPair &pair : release.pairs)
            {
              const std::array<int, 3> base = spins(numbering, pair.base),
                                       end  = spins(numbering, pair.end);
              if (end[2] >= 0 &&
                  (base[2] >= 0 ||
                   pair.base.what == RotationOwner::What::ground))
                add(number, release.definition->stiffness, base, end);
              ++number;
            }
    }
  } // namespace

  std::unique_ptr<Effect> make_rotational_springs(const LatticeModel &model)
  {
    const DofNumbering &numbering = model.numbering;
    // On all ranks, also those without any: the records of the state are alike.
    if (!have_rotational_springs(model.releases))
      return nullptr;
    if (model.plan.simulated.large_rotation && model.lattice.dimension == 3)
      {
        std::vector<SpaceSpring> springs;
        for_each_spring(model,
                        [&](const unsigned int number,
                            const double       stiffness,
                            const auto        &base,
                            const auto        &end) {
                          springs.push_back(
                            {base[0] < 0 ? -1
                                         : numbering.rotations().with(base[0]),
                             numbering.rotations().with(end[0]),
                             stiffness,
                             number});
                        });
        return make_space_springs(numbering, springs);
      }
    std::vector<RotationalSpring> springs;
    for_each_spring(model,
                    [&](const unsigned int /*number*/,
                        const double stiffness,
                        const auto  &base,
                        const auto  &end) {
                      for (unsigned int c = 0; c < 3; ++c)
                        if (end[c] >= 0)
                          springs.push_back({{{base[c], end[c]}}, stiffness});
                    });
    return make_rotational_springs(numbering, std::move(springs));
  }

  std::unique_ptr<Constraints> make_revolute_hinges(const LatticeModel &model)
  {
    const DofNumbering        &numbering = model.numbering;
    std::vector<RevoluteHinge> hinges;
    unsigned int               number = 0;
    for (const JointRelease &release : model.releases)
      if (release.definition->type == JointDefinition::Type::revolute)
        for (const RotationPair &pair : release.pairs)
          {
            const std::array<int, 2> multipliers = {
              {numbering.constraints().hinge_multiplier(number, 0),
               numbering.constraints().hinge_multiplier(number, 1)}};
            ++number;
            if (multipliers[0] >= 0)
              hinges.push_back({spins(numbering, pair.base),
                                spins(numbering, pair.end),
                                multipliers,
                                release.definition->axis});
          }
    return number > 0
      ? make_revolute_hinges(numbering,
                             model.plan.simulated.large_rotation,
                             model.mean_strut_length,
                             hinges)
      : nullptr;
  }
} // namespace auxfem
