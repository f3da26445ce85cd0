#include <auxfem/model/joint_releases.h>

#include <equations/space_effect.h>
#include <mesh/cell_from_text.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using OwnerKind = RotationOwner::Kind;

  SceneText definition(const std::string &name,
                       const std::string &joint,
                       const std::string &struts,
                       const std::string &type)
  {
    return SceneText().add("Joints/" + name,
                           "Joints = " + joint + " | Struts = " + struts +
                             " | Type = " + type);
  }

  const std::string revolute = "revolute | Axis = 0 0 1",
                    spring   = "rotational spring | Stiffness = 2";

  SceneText rigid(const std::string &name, const std::string &struts)
  {
    return SceneText().rigid_part(name, struts, 1);
  }

  /**
   * Three struts from joint 0, the last two bent so that they can be rotating
   * bodies; two struts that meet at joint 6.
   */
  SceneText tripod(const SceneText &further)
  {
    return space_frame("0 0 0; 1 0 0; 0 1 0; 0 0 1; 1 1 0; 0 1 1; -1 0 0",
                       "0 1; 0 2; 0 3; 2 4; 3 5; 0 6",
                       further);
  }

  /** Text of base and end of each pair. */
  std::vector<std::string> pairs(const SceneText &further)
  {
    const Scene   scene   = read_scene_from_text(tripod(further), "test.prm");
    const Lattice lattice = build_lattice(scene);
    const auto words = [](const RotationOwner &rotation_owner) -> std::string {
      const std::string number = std::to_string(rotation_owner.index);
      switch (rotation_owner.kind)
        {
          case OwnerKind::joint:
            return "joint " + number;
          case OwnerKind::strut_end:
            return "strut " + number;
          case OwnerKind::rigid_part:
            return "part " + number;
          default:
            return "ground";
        }
    };
    std::vector<std::string> result;
    for (const JointRelease &release : joint_releases(scene, lattice))
      for (const RotationPair &pair : release.pairs)
        result.push_back(words(pair.base) + " - " + words(pair.end));
    return result;
  }

  using Words = std::vector<std::string>;
} // namespace

TEST(JointReleases, AHingeInSpaceReleasesAllThreeRotations)
{
  const EquationsOnRanks setup(tripod(definition("hinge", "0", "1", "hinge")),
                               {},
                               MPI_COMM_SELF);
  const auto            &dofs = setup.dofs();
  for (unsigned int c = 3; c < 6; ++c)
    {
      EXPECT_NE(dofs.end_rotation(1, 0, c), dofs.joint_unknown(0, c));
      EXPECT_EQ(dofs.end_rotation(2, 0, c), dofs.joint_unknown(0, c));
      EXPECT_EQ(dofs.unknowns().kinds[dofs.end_rotation(1, 0, c)],
                UnknownKind::rotation);
    }
  EXPECT_NE(dofs.rotations().with(dofs.end_rotation(1, 0, 3)),
            dofs.rotations().with(dofs.joint_unknown(0, 3)));
  EXPECT_EQ(dofs.constraints().n_multipliers(), 0u);
}

TEST(JointReleases, EndsTurnAgainstTheJoint)
{
  EXPECT_EQ(pairs(definition("hinge", "0", "1, 2", revolute)),
            (Words{"joint 0 - strut 1", "joint 0 - strut 2"}));
}

TEST(JointReleases, AllEndsTurnAgainstTheFirst)
{
  EXPECT_EQ(
    pairs(definition("spring", "0", "all", spring)),
    (Words{"strut 0 - strut 1", "strut 0 - strut 2", "strut 0 - strut 5"}));
}

TEST(JointReleases, ALoneEndTurnsAgainstTheGround)
{
  EXPECT_EQ(pairs(definition("hinge", "1", "0", revolute)),
            (Words{"ground - strut 0"}));
}

TEST(JointReleases, ABodyTurnsAgainstTheGroundABodyOrTheStrutsThere)
{
  const SceneText one = rigid("one", "1, 3"), other = rigid("other", "2, 4");
  // Alone at its joint.
  EXPECT_EQ(pairs(one + definition("hinge", "4", "3", revolute)),
            (Words{"ground - part 0"}));
  // Elastic struts 0 and 5 are rigidly connected at joint 0.
  EXPECT_EQ(pairs(one + definition("hinge", "0", "1", revolute)),
            (Words{"joint 0 - part 0"}));
  // All elastic struts are released; the joint rotates with the only body.
  EXPECT_EQ(
    pairs(one + definition("hinge", "0", "0, 2, 5", revolute)),
    (Words{"part 0 - strut 0", "part 0 - strut 2", "part 0 - strut 5"}));
  // Two bodies.
  EXPECT_EQ(pairs(one + other + definition("hinge", "0", "1, 2", revolute)),
            (Words{"joint 0 - part 0", "joint 0 - part 1"}));
  EXPECT_EQ(pairs(one + other + definition("free", "0", "0, 5", "hinge") +
                  definition("hinge", "0", "1, 2", revolute)),
            (Words{"part 0 - part 1"}));
}

TEST(JointReleases, ASpringThatOnlyABarCouldHoldIsRefused)
{
  const std::string message = input_error_of(
    [] { pairs(rigid("bar", "3") + definition("spring", "2", "1", spring)); });
  EXPECT_TRUE(contains(message, "Joints/spring/Joints")) << message;
  EXPECT_TRUE(contains(message, "lies on one line")) << message;
}
