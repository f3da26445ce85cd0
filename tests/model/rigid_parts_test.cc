#include <auxfem/model/build_lattice.h>
#include <auxfem/model/rigid_bodies.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/scene_text.h>

#include <algorithm>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Round-off of some ten operations on numbers of size ten. */
  constexpr double rigid_parts_round_off = 1e-13;

  using Indices = std::vector<unsigned int>;

  /** The lattice of a frame without sections and with rigid parts. */
  Lattice lattice_of(const std::string &joints,
                     const std::string &struts,
                     const SceneText   &rigid_parts,
                     const SceneText   &further = {})
  {
    return build_lattice(read_scene_from_text(
      SceneText().frame(joints, struts).add(rigid_parts).add(further),
      "test.prm"));
  }

  SceneText part(const std::string &name, const std::string &content)
  {
    return SceneText().add("Rigid parts/" + name, content);
  }

  /** Two legs of 3 m and 1 m, then a bar and a lone strut. */
  const std::string six_joints  = "0 0; 3 0; 3 1; 5 1; 7 0; 8 0";
  const std::string four_struts = "0 1; 1 2; 2 3; 4 5";

  SceneText sections_for(const std::string &struts)
  {
    return SceneText()
      .circle("band", "1 mm", {"70 GPa", 2700})
      .set("Sections/band/Struts", struts);
  }
} // namespace

TEST(RigidParts, StrutsThatMeetAreOnePart)
{
  const Lattice lattice =
    lattice_of(six_joints, four_struts, part("all", "Struts = all"));
  ASSERT_EQ(lattice.rigid_parts.size(), 2u);
  const RigidPart &chain = lattice.rigid_parts[0];
  EXPECT_EQ(chain.struts, (Indices{0, 1, 2}));
  EXPECT_EQ(Indices(chain.joints.begin(), chain.joints.begin() + 2),
            (Indices{0, 3}));
  EXPECT_EQ(chain.joints.size(), 4u);
  EXPECT_EQ(lattice.rigid_parts[1].joints, (Indices{4, 5}));
  for (unsigned int strut = 0; strut < 4; ++strut)
    EXPECT_EQ(lattice.struts[strut].rigid_part, strut < 3 ? 0u : 1u);
  EXPECT_EQ(lattice.n_elastic_struts(), 0u);
}

TEST(RigidParts, SingleStrutsAreBars)
{
  const Lattice lattice =
    lattice_of(six_joints,
               four_struts,
               part("bars",
                    "Struts = all | Parts = single struts | Mass = 2 kg"));
  ASSERT_EQ(lattice.rigid_parts.size(), 4u);
  for (unsigned int i = 0; i < 4; ++i)
    {
      const RigidPart &bar = lattice.rigid_parts[i];
      EXPECT_EQ(bar.struts, Indices{i});
      EXPECT_EQ(bar.joints.size(), 2u);
      EXPECT_EQ(bar.mass, 2);
    }
  EXPECT_NEAR(lattice.rigid_parts[0].rotary_inertia[2][2],
              2 * 3. * 3 / 12,
              rigid_parts_round_off);
  EXPECT_NEAR(lattice.rigid_parts[2].centre_of_mass.distance({4, 1, 0}),
              0,
              rigid_parts_round_off);
}

TEST(RigidParts, JointsWithoutStrutsShareTheMass)
{
  const Lattice lattice =
    lattice_of("0 0; 1 0; 0 2; 4 0",
               "0 3",
               part("plate", "Joints = 0, 1, 2 | Mass = 6 kg"),
               sections_for("all"));
  ASSERT_EQ(lattice.rigid_parts.size(), 1u);
  const RigidPart &plate = lattice.rigid_parts[0];
  EXPECT_TRUE(plate.struts.empty());
  EXPECT_EQ(plate.joints, (Indices{0, 2, 1}));
  EXPECT_NEAR(plate.centre_of_mass.distance({1. / 3, 2. / 3, 0}),
              0,
              rigid_parts_round_off);
  // Three masses of 2 kg: 2 (1 + 4) about joint 0, less 6 (1 + 4) / 9.
  EXPECT_NEAR(plate.rotary_inertia[2][2], 10 - 30. / 9, rigid_parts_round_off);
  EXPECT_FALSE(lattice.struts[0].is_rigid());
}

TEST(RigidParts, AnLHasItsClosedFormMassProperties)
{
  // Legs of 3 m and 1 m with 1 kg/m: centre (3 * 1.5 + 3, 0.5) / 4; inertia of
  // each leg about its own middle and by Steiner.
  const Lattice    lattice = lattice_of("0 0; 3 0; 3 1",
                                     "0 1; 1 2",
                                     part("L", "Struts = all | Mass = 4"));
  const RigidPart &L       = lattice.rigid_parts.at(0);
  const double     x = 7.5 / 4, y = 0.5 / 4;
  EXPECT_EQ(L.mass, 4);
  EXPECT_NEAR(L.centre_of_mass.distance({x, y, 0}), 0, rigid_parts_round_off);
  EXPECT_NEAR(L.rotary_inertia[2][2],
              27. / 12 + 3 * ((x - 1.5) * (x - 1.5) + y * y) + 1. / 12 +
                (3 - x) * (3 - x) + (0.5 - y) * (0.5 - y),
              rigid_parts_round_off);
}

TEST(RigidParts, AHalfCircleHasItsClosedFormMassProperties)
{
  // Radius 2 m, bulging to the left of (0, 0) -> (4, 0): centre 2 R / pi above
  // the chord, inertia m R^2 about the circle's middle.
  const Lattice lattice =
    lattice_of("0 0; 4 0", "0 1 2", part("bow", "Struts = 0 | Mass = 3"));
  const RigidPart &bow = lattice.rigid_parts.at(0);
  EXPECT_NEAR(bow.centre_of_mass.distance({2, 4 / pi, 0}),
              0,
              rigid_parts_round_off);
  EXPECT_NEAR(bow.rotary_inertia[2][2],
              12 * (1 - 4 / (pi * pi)),
              10 * rigid_parts_round_off);
}

TEST(RigidParts, ASpecifiedRotaryInertiaIsUsed)
{
  const Lattice lattice =
    lattice_of("0 0; 3 0",
               "0 1",
               part("bar", "Struts = 0 | Mass = 3 | Rotary inertia = 0.4"));
  EXPECT_EQ(lattice.rigid_parts.at(0).rotary_inertia[2][2], 0.4);
  EXPECT_FALSE(lattice.rigid_parts.at(0).clamps_struts);
}

TEST(RigidParts, SectionsDoNotMakeThemElastic)
{
  // Struts 0 and 1 are rigid and use the thickness of the section.
  const Lattice lattice =
    lattice_of(six_joints,
               four_struts,
               part("L", "Struts = 0, 1 | Elastic struts = clamped"),
               sections_for("all"));
  EXPECT_EQ(lattice.n_elastic_struts(), 2u);
  EXPECT_TRUE(lattice.struts[0].is_rigid());
  EXPECT_FALSE(lattice.struts[2].is_rigid());
  EXPECT_EQ(lattice.struts[0].section, 0u);
  EXPECT_EQ(lattice.struts[2].section, 0u);
  EXPECT_TRUE(lattice.rigid_parts.at(0).clamps_struts);
  EXPECT_EQ(rigid_parts_of(lattice, {0, 1, 2, 3}), Indices{0});
  EXPECT_TRUE(rigid_parts_of(lattice, {2, 3}).empty());

  EXPECT_EQ(input_error_of([] {
              lattice_of(six_joints,
                         four_struts,
                         part("L", "Struts = 0, 1"),
                         sections_for("2, 3"));
            }),
            "");
  EXPECT_TRUE(contains(input_error_of([] {
                         lattice_of(six_joints,
                                    four_struts,
                                    part("L", "Struts = 0, 1"),
                                    sections_for("2"));
                       }),
                       "Sections"));
}

TEST(RigidParts, AStrutOfTwoDefinitionsIsRefused)
{
  const std::string message = input_error_of([] {
    lattice_of(six_joints,
               four_struts,
               part("chain", "Struts = 0, 1") + part("tail", "Struts = 1, 2"));
  });
  for (const char *words : {"Rigid parts/tail/Struts",
                            "strut 1 belongs to Rigid parts/chain already"})
    EXPECT_TRUE(contains(message, words)) << message;
}

TEST(RigidParts, APartWithoutDirectionIsRefused)
{
  std::string message = input_error_of(
    [] { lattice_of("0 0; 1 0", "0 1", part("dot", "Joints = 1")); });
  for (const char *words :
       {"Rigid parts/dot/Joints", "at least two joints", "joint 1 is alone"})
    EXPECT_TRUE(contains(message, words)) << message;

  message = input_error_of([] {
    lattice_of("0 0; 1 0; 1 0; 2 0", "0 1; 2 3", part("dot", "Joints = 1, 2"));
  });
  for (const char *words :
       {"Rigid parts/dot", "joints 1 and 2 lie at one position"})
    EXPECT_TRUE(contains(message, words)) << message;
}

TEST(RigidParts, JointsOfPartsAreThoseFoundBySearch)
{
  const Lattice lattice =
    lattice_of(six_joints,
               four_struts,
               part("leg", "Struts = 0") + part("bar", "Joints = 4, 5"),
               sections_for("1, 2, 3"));
  const std::vector<bool> is_in_part = joints_of_rigid_parts(lattice);
  ASSERT_EQ(is_in_part.size(), lattice.joints.size());
  for (unsigned int joint = 0; joint < lattice.joints.size(); ++joint)
    {
      bool is_found = false;
      for (const RigidPart &part : lattice.rigid_parts)
        is_found = is_found ||
          std::count(part.joints.begin(), part.joints.end(), joint) > 0;
      EXPECT_EQ(is_in_part[joint], is_found) << joint;
    }
}

TEST(RigidParts, InSpaceAJointIsClampedToOnePartOnly)
{
  // Two bars that meet at joint 1, and one apart.
  const auto make = [](const std::string &first, const std::string &second) {
    return build_lattice(read_scene_from_text(
      SceneText()
        .dimension(3)
        .frame("0 0 0; 1 0 0; 1 1 1; 2 0 0; 2 1 0", "0 1; 1 2; 3 4")
        .add(part("lone", "Struts = 2 | Elastic struts = clamped"))
        .add(part("base", "Struts = 0 | Elastic struts = " + first))
        .add(part("arm", "Struts = 1 | Elastic struts = " + second)),
      "test.prm"));
  };
  EXPECT_EQ(make("clamped", "hinged").rigid_parts.size(), 3u);
  EXPECT_EQ(make("hinged", "clamped").rigid_parts.size(), 3u);
  const std::string message =
    input_error_of([&] { make("clamped", "clamped"); });
  for (const char *words : {"Rigid parts/arm/Elastic struts",
                            "joint 1 are clamped to a part of Rigid parts/base "
                            "already"})
    EXPECT_TRUE(contains(message, words)) << message;
}

TEST(RigidParts, UnknownSetsAreRefusedWithTheirPlace)
{
  EXPECT_TRUE(
    contains(input_error_of([] {
               lattice_of("0 0; 1 0", "0 1", part("bar", "Struts = bras"));
             }),
             "Rigid parts/bar/Struts"));
}
