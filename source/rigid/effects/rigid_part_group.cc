#include <auxfem/rigid/effects/rigid_part_group.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Constraints of rigid parts of all kinds. */
    class RigidPartConstraints : public RigidPartGroup
    {
    public:
      RigidPartConstraints(const RigidBodies      &bodies,
                           const RigidPartSetting &setting)
        : large_rotation(setting.large_rotation)
      {
        if (!bodies.in_plane.empty())
          groups.push_back(make_natural_parts(bodies.in_plane, setting));
        if (!bodies.bars.empty())
          groups.push_back(make_natural_parts(bodies.bars, setting));
        if (!bodies.rotating.empty())
          groups.push_back(make_rotating_parts(bodies.rotating, setting));
        for (const auto &group : groups)
          for (unsigned int i = 0; i < group->n_reported(); ++i)
            reported.emplace_back(group.get(), i);
        std::sort(reported.begin(),
                  reported.end(),
                  [](const auto &one, const auto &other) {
                    return one.first->part(one.second) <
                      other.first->part(other.second);
                  });
      }

      bool is_linear() const override
      {
        return !large_rotation;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        for (const auto &group : groups)
          group->register_blocks(pattern);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        for (const auto &group : groups)
          group->add_residual(evaluation, residual, nullptr);
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        for (const auto &group : groups)
          group->add_tangent(evaluation, nullptr, factors, matrix);
      }

      void row_force_bounds(const Evaluation &evaluation,
                            const EffectCache * /*results*/,
                            double *forces) const override
      {
        for (const auto &group : groups)
          group->row_force_bounds(evaluation, nullptr, forces);
      }

      void find_rates(const State &state, double *rates) const override
      {
        for (const auto &group : groups)
          group->find_rates(state, rates);
      }

      double length() const override
      {
        double result = 0;
        for (const auto &group : groups)
          result = std::max(result, group->length());
        return result;
      }

      unsigned int n_reported() const override
      {
        return reported.size();
      }

      unsigned int part(const unsigned int i) const override
      {
        return reported[i].first->part(reported[i].second);
      }

      SpaceVector rotation(const unsigned int i,
                           const State       &state) const override
      {
        return reported[i].first->rotation(reported[i].second, state);
      }

      PointMotion motion(const unsigned int      i,
                         const dealii::Point<3> &point,
                         const State            &state) const override
      {
        return reported[i].first->motion(reported[i].second, point, state);
      }

      RigidPartReport report(const unsigned int i,
                             const State       &state) const override
      {
        return reported[i].first->report(reported[i].second, state);
      }

    private:
      const bool                                   large_rotation;
      std::vector<std::unique_ptr<RigidPartGroup>> groups;
      /** Group and index in the group of each reported part. */
      std::vector<std::pair<const RigidPartGroup *, unsigned int>> reported;
    };
  } // namespace

  std::unique_ptr<RigidPartGroup>
  make_rigid_part_constraints(const RigidBodies      &bodies,
                              const RigidPartSetting &setting)
  {
    return std::make_unique<RigidPartConstraints>(bodies, setting);
  }
} // namespace auxfem
