#include <auxfem/equations/make_effects.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/joints/effects/relation_forces.h>

#include <cmath>
#include <utility>

namespace auxfem
{
  namespace
  {
    class RelationForces : public Constraints
    {
    public:
      RelationForces(std::vector<LocalRelation> relations,
                     const DofNumbering        &numbering)
        : relations(std::move(relations))
        , numbering(numbering)
        , rotations(numbering)
      {}

      bool is_linear() const override
      {
        return true;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block =
          pattern.register_blocks(relations, &LocalRelation::unknowns);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        const Vector &motion = evaluation.has_constraint_accelerations()
          ? *evaluation.to.acceleration
          : evaluation.to.displacement;
        for (const LocalRelation &relation : relations)
          {
            const int    row   = relation.unknowns.back();
            const double force = evaluation.to.displacement[row];
            for (std::size_t i = 0; i < relation.coefficients.size(); ++i)
              residual[relation.unknowns[i]] +=
                relation.coefficients[i] * force;
            residual[row] +=
              relation.equal_rotations && !evaluation.to.rotations.empty()
              ? turned(relation, evaluation.to.rotations, motion)
              : sum(relation, motion);
          }
      }

      void add_tangent(const Evaluation & /*evaluation*/,
                       const EffectCache * /*results*/,
                       const TangentFactors & /*factors*/,
                       TangentMatrix &matrix) const override
      {
        std::vector<double> block;
        for (std::size_t r = 0; r < relations.size(); ++r)
          {
            const std::vector<double> &c = relations[r].coefficients;
            const std::size_t          n = c.size() + 1;
            block.assign(n * n, 0.);
            for (std::size_t i = 0; i + 1 < n; ++i)
              block[n * i + n - 1] = block[n * (n - 1) + i] = c[i];
            matrix.add(first_block + r, block.data());
          }
      }

      void row_force_bounds(const Evaluation &evaluation,
                            const EffectCache * /*results*/,
                            double *forces) const override
      {
        for (const LocalRelation &relation : relations)
          for (std::size_t i = 0; i < relation.coefficients.size(); ++i)
            raise_bound(
              forces,
              relation.unknowns[i],
              std::abs(relation.coefficients[i] *
                       evaluation.to.displacement[relation.unknowns.back()]));
      }

      void find_rates(const State &state, double *rates) const override
      {
        for (const LocalRelation &relation : relations)
          rates[relation.unknowns.back()] = sum(relation, *state.velocity);
      }

    private:
      static double sum(const LocalRelation &relation, const Vector &motion)
      {
        double result = 0;
        for (std::size_t i = 0; i < relation.coefficients.size(); ++i)
          result += relation.coefficients[i] * motion[relation.unknowns[i]];
        return result;
      }

      /** The sum for two rotations, turned with the second one. */
      double turned(const LocalRelation           &relation,
                    const std::vector<Quaternion> &now,
                    const Vector                  &motion) const
      {
        const auto [one, other] = *relation.equal_rotations;
        const SpaceVector difference =
          rotations.values(motion, one) - rotations.values(motion, other);
        return relation.coefficients.front() *
          rotated(now[other], difference)[numbering.rotations().axis(
            relation.unknowns.front())];
      }

      const std::vector<LocalRelation> relations;
      const DofNumbering              &numbering;
      const NodeRotations              rotations;
      std::size_t                      first_block = 0;
    };
  } // namespace

  std::unique_ptr<Constraints>
  make_relation_forces(std::vector<LocalRelation> relations,
                       const DofNumbering        &numbering)
  {
    return std::make_unique<RelationForces>(std::move(relations), numbering);
  }

  std::unique_ptr<Constraints> make_relation_forces(const LatticeModel &model)
  {
    if (model.relations.empty())
      return nullptr;
    const DofNumbering        &numbering = model.numbering;
    std::vector<LocalRelation> local;
    for (unsigned int r = 0; r < model.relations.size(); ++r)
      {
        const int multiplier = numbering.constraints().relation_multiplier(r);
        if (multiplier < 0)
          continue;
        local.emplace_back();
        for (const LinearRelation::Term &term : model.relations[r].terms)
          {
            local.back().unknowns.push_back(
              numbering.joint_unknown(term.motion.joint,
                                      term.motion.component));
            local.back().coefficients.push_back(term.coefficient);
          }
        if (model.relations[r].is_of_equal_rotations)
          local.back().equal_rotations = {
            {static_cast<unsigned int>(
               numbering.rotations().with(local.back().unknowns[0])),
             static_cast<unsigned int>(
               numbering.rotations().with(local.back().unknowns[1]))}};
        local.back().unknowns.push_back(multiplier);
      }
    return make_relation_forces(std::move(local), numbering);
  }
} // namespace auxfem
