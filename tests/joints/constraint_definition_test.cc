#include <auxfem/scene/scene.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  Scene with_constraint(const std::string &entries,
                        const unsigned int dimension = 2)
  {
    return read_scene_from_text(frame_scene("0 0; 1 0", "0 1")
                                  .section({1, 1, 1})
                                  .set("Sections/section 0/Density", 1)
                                  .dimension(dimension)
                                  .add("Constraints/tie", entries)
                                  .str(),
                                "test.prm");
  }

  Scene with_relation(const std::string &relation)
  {
    return with_constraint("Type = linear relation | Relation = " + relation);
  }

  std::string message(const std::string &entries)
  {
    return input_error_of([&] { with_constraint(entries); });
  }

  std::string relation_message(const std::string &relation)
  {
    return input_error_of([&] { with_relation(relation); });
  }
} // namespace

TEST(ConstraintDefinition, ReadsComponents)
{
  const auto constraint =
    with_constraint("Joints = all | Components = y, rotation z")
      .constraints.at(0);
  EXPECT_EQ(constraint.name, "tie");
  EXPECT_EQ(constraint.type, ConstraintDefinition::Type::equal_motion);
  for (unsigned int c = 0; c < n_motion_components; ++c)
    EXPECT_EQ(constraint.components[c], c == 1 || c == rotation_z) << c;
}

TEST(ConstraintDefinition, ReadsTheTermsOfARelation)
{
  const auto terms =
    with_relation("x of 0; - y of left; -2.5 rotation z of nearest: 1, 0; "
                  "40 mm rotation z of all; -x of 1; 3 y of 1")
      .constraints.at(0)
      .terms;
  ASSERT_EQ(terms.size(), 6u);
  const std::vector<double>       coefficients = {1, -1, -2.5, 0.04, -1, 3};
  const std::vector<unsigned int> components   = {0, 1, 5, 5, 0, 1};
  for (unsigned int i = 0; i < 6; ++i)
    {
      EXPECT_EQ(terms[i].coefficient, coefficients[i]) << i;
      EXPECT_EQ(terms[i].component, components[i]) << i;
    }
  EXPECT_EQ(terms[1].joints, "left");
  EXPECT_EQ(terms[2].joints, "nearest: 1, 0");
}

TEST(ConstraintDefinition, RefusesWhatIsNoComponent)
{
  expect_parts(message("Joints = all | Components = y, w"),
               {"Constraints/tie/Components", "\"w\"", "x, y, rotation z"});
  expect_parts(message("Joints = all | Components = z"),
               {"\"z\" is no component of motion in the plane"});
  expect_parts(message("Joints = all"), {"Components"});
}

TEST(ConstraintDefinition, RefusesTermsThatItCannotRead)
{
  expect_parts(relation_message("x of 0; y 1"),
               {"Constraints/tie/Relation", "\"y 1\"", "-2 y of 5"});
  expect_parts(relation_message("x of 0; 2 mm y of 1"),
               {"the coefficient \"2 mm\""});
  expect_parts(relation_message("x of 0; 2 N rotation z of 1"),
               {"the coefficient \"2 N\""});
  expect_parts(relation_message("rotation z of 0; 2 m rotation z of 1"),
               {"the coefficient \"2 m\""});
  expect_parts(relation_message("x of 0; 0 y of 1"),
               {"coefficient 0", "Remove"});
  expect_parts(relation_message("x of 0; 2 -y of 1"), {"\"-y\""});
}

TEST(ConstraintDefinition, RefusesLinesThatLeaveThePlane)
{
  expect_parts(message("Type = line | Joints = 1 | Direction = 1 0 1"),
               {"Constraints/tie/Direction", "leaves the plane"});
  expect_parts(message("Type = line | Joints = 1 | Direction = 0 0"),
               {"Constraints/tie/Direction"});
  EXPECT_NEAR(with_constraint("Type = line | Joints = 1 | Direction = 3 0 4", 3)
                .constraints.at(0)
                .direction[2],
              0.8,
              1e-15);
}
