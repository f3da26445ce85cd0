#include <auxfem/equations/make_effects.h>
#include <auxfem/joints/effects/relation_forces.h>
#include <auxfem/model/unknown_records.h>

#include <equations/space_effect.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string constrained =
    space_frame("0 0 0; 1 0 0; 1.5 0.9 0.2",
                "0 1; 1 2",
                SceneText()
                  .add("Constraints/alike", "Joints = all | Components = y, z")
                  .add("Constraints/slide",
                       "Type = line | Joints = 2 | Direction = 1 2 -2")
                  .add("Constraints/lever",
                       "Type = linear relation | "
                       "Relation = 4 x of 0; -2 y of 1; z of all"));

  /** The relations without the other effects. */
  struct Relations : SpaceEffect
  {
    Relations() : SpaceEffect(constrained, true)
    {
      constraints = make_relation_forces(setup.model);
    }

    std::unique_ptr<Constraints> constraints;
  };

  std::string model_error(const std::string &entries,
                          const SceneText   &further = {})
  {
    return input_error_of([&] {
      EquationsOnRanks(
        space_frame("0 0 0; 1 0 0; 1.5 0.9 0.2",
                    "0 1; 1 2",
                    SceneText().add("Constraints/tie", entries).add(further)),
        {},
        MPI_COMM_SELF);
    });
  }
} // namespace

TEST(RelationForces, EveryRelationHasAMultiplier)
{
  Relations   relations;
  const auto &dofs = relations.setup.dofs();
  // Two components of three joints, two across the line, one lever.
  EXPECT_EQ(dofs.constraints().n_multipliers(), 7u);
  EXPECT_EQ(describe(dofs, dofs.constraints().relation_multiplier(4)),
            "relation of Constraints/slide at joint 2");
  EXPECT_TRUE(relations.constraints->is_linear());
  // The largest coefficient of displacements is 1, z of all a mean.
  const auto &terms = relations.setup.model.relations[6].terms;
  ASSERT_EQ(terms.size(), 5u);
  EXPECT_EQ(terms[0].coefficient, 1);
  EXPECT_NEAR(terms[4].coefficient, 1 / 12., 1e-15);
}

TEST(RelationForces, TangentIsThatOfDifferences)
{
  Relations relations;
  relations.expect_tangent(*relations.constraints, {1., 3., 5.});
}

TEST(RelationForces, ForcesAreDerivativesOfTheRelations)
{
  Relations relations;
  relations.expect_forces_by_constraints(*relations.constraints);
}

TEST(RelationForces, RatesAreThoseOfTheRelations)
{
  Relations relations;
  relations.expect_time_derivatives(*relations.constraints);
}

TEST(RelationForces, RefusesMotionsThatDoNotAddUp)
{
  const std::string turn = "Joints = 0, 1 | Components = rotation x";
  expect_parts(model_error(turn), {"Constraints/tie", "large rotations"});
  EXPECT_EQ(model_error(turn, SceneText().set("Effects/Large rotation", "off")),
            "");
}

TEST(RelationForces, RefusesRelationsWithoutMeaning)
{
  expect_parts(model_error("Joints = 1 | Components = x"),
               {"Constraints/tie/Joints", "one joint alone"});
  expect_parts(model_error("Type = linear relation | "
                           "Relation = x of 0; -x of 0"),
               {"Constraints/tie/Relation", "cancel"});
  expect_parts(model_error("Joints = 0, 7 | Components = x"),
               {"Constraints/tie/Joints", "no joint 7"});
  expect_parts(
    model_error(
      "Joints = 0, 1 | Components = rotation x",
      SceneText().set("Effects/Large rotation", "off").hinge("ball", "0", "0")),
    {"Constraints/tie", "joint 0 has no rotation of its own"});
}
