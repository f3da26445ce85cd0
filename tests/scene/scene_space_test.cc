#include <auxfem/loads/load_definitions.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include <support/messages.h>

namespace
{
  using namespace auxfem;
  using Words = std::vector<std::string>;
  using Fixed = std::array<bool, n_motion_components>;

  std::string text_with(const std::string &kind, const std::string &entries)
  {
    return "subsection Lattice\n set Cell = star\nend\nsubsection " + kind +
      "\n subsection name\n" + entries + "\n end\nend\n";
  }

  Scene plane_scene(const std::string &kind, const std::string &entries)
  {
    return read_scene_from_text(text_with(kind, entries), "scene.prm");
  }

  Scene space_scene(const std::string &kind, const std::string &entries)
  {
    return read_scene_from_text(text_with(kind, entries),
                                "scene.prm",
                                {"Dimension=3"});
  }

  std::string plane_message(const std::string &kind, const std::string &entries)
  {
    return input_error_of([&] { plane_scene(kind, entries); });
  }

  std::string space_message(const std::string &kind, const std::string &entries)
  {
    return input_error_of([&] { space_scene(kind, entries); });
  }

  SupportDefinition support(const std::string &entries)
  {
    return space_scene("Supports", "set Joints = all\n" + entries)
      .supports.at(0);
  }

  void expect_vector(const dealii::Tensor<1, 3> &found,
                     const dealii::Tensor<1, 3> &expected)
  {
    // a square root and a quotient of the components
    EXPECT_LT((found - expected).norm(), 4e-16 * expected.norm()) << found;
  }

  TEST(SceneInSpace, KnowsItsDimension)
  {
    const Scene space = space_scene("Supports", "set Joints = all");
    EXPECT_EQ(space.context.dimension, 3u);
    EXPECT_EQ(plane_scene("Supports", "set Joints = all").context.dimension,
              2u);
  }



  TEST(SceneInSpace, ComponentsAreNamedByTheirAxis)
  {
    const auto entries =
      for_components<TimeExpression>({"Force", "0", "N", "Force"},
                                     {"Moment", "0", "N m", "Moment"});
    const Words names =
      {"Force x", "Force y", "Force z", "Moment x", "Moment y", "Moment z"};
    const Fixed plane = {{true, true, false, false, false, true}};
    for (unsigned int c = 0; c < n_motion_components; ++c)
      {
        EXPECT_EQ(entries[c].name, names[c]);
        EXPECT_EQ(contains(entries[c].sentence, "Dimension = 3"), !plane[c]);
        EXPECT_EQ(is_in_plane(c), plane[c]);
      }
  }



  TEST(SceneInSpace, SupportsHoldTheComponentsOfTheirType)
  {
    EXPECT_EQ(support("set Type = clamp").fixed,
              (Fixed{{true, true, true, true, true, true}}));
    EXPECT_EQ(support("set Type = pin").fixed, (Fixed{{true, true, true}}));
    EXPECT_EQ(support("set Type = roller x").fixed,
              (Fixed{{false, true, true}}));
    EXPECT_EQ(support("set Type = roller y").fixed,
              (Fixed{{true, false, true}}));
    EXPECT_EQ(support("set Type = roller z").fixed,
              (Fixed{{true, true, false}}));
  }



  TEST(SceneInSpace, SupportsMoveAsPrescribed)
  {
    const SupportDefinition driven =
      support("set Type = prescribed\nset Displacement z = 2*t\n"
              "set Rotation x = 3*t\nset Rotation y = 0\nset Rotation z = 0");
    EXPECT_EQ(driven.fixed, (Fixed{{false, false, true, true, true, true}}));
    EXPECT_EQ(driven.motion[2].value(2), 4);
    EXPECT_EQ(driven.motion[3].value(2), 6);
    EXPECT_TRUE(driven.motion[4].is_zero());
    EXPECT_EQ(support("set Type = prescribed\nset Rotation y = 0").fixed,
              (Fixed{{false, false, false, false, true}}));
  }



  TEST(SceneInSpace, OneRotationMayMove)
  {
    const SupportDefinition driven =
      support("set Type = prescribed\nset Rotation z = 0.1*t");
    EXPECT_EQ(driven.fixed, (Fixed{{false, false, false, false, false, true}}));
    EXPECT_EQ(driven.motion[5].value(2), 0.2);
  }



  TEST(SceneInSpace, LoadsHaveAllComponents)
  {
    const JointLoadDefinition load =
      space_scene("Loads",
                  "set Joints = all\nset Force x = 1\nset Force y = 2\n"
                  "set Force z = 3\nset Moment x = 4\nset Moment y = 5\n"
                  "set Moment z = 6")
        .joint_loads.at(0);
    for (unsigned int c = 0; c < n_motion_components; ++c)
      EXPECT_EQ(load.components[c].value(0), c + 1.);
    EXPECT_FALSE(load.follows_joint);
    const LineLoadDefinition line =
      space_scene("Loads",
                  "set Type = line\nset Struts = all\n"
                  "set Force per length x = 1\nset Force per length y = 2\n"
                  "set Force per length z = 3")
        .line_loads.at(0);
    for (unsigned int c = 0; c < 3; ++c)
      EXPECT_EQ(line.components[c].value(0), c + 1.);
  }



  TEST(SceneInSpace, LoadsMayFollowTheirJoint)
  {
    const std::string entries =
      "set Joints = all\nset Force x = 1\nset Direction = follows the joint";
    EXPECT_TRUE(space_scene("Loads", entries).joint_loads.at(0).follows_joint);
    EXPECT_TRUE(plane_scene("Loads", entries).joint_loads.at(0).follows_joint);
    expect_parts(plane_message("Loads",
                               "set Type = line\nset Struts = all\n"
                               "set Direction = fixed"),
                 {"Loads/name/Direction", "belongs to Type = joint"});
  }



  TEST(SceneInSpace, WeightAndVelocitiesHaveAllComponents)
  {
    const Scene moving =
      space_scene("Initial velocities",
                  "set Joints = all\nset Velocity x = 1\nset Velocity y = 2\n"
                  "set Velocity z = 3\nset Angular velocity x = 4\n"
                  "set Angular velocity y = 5\nset Angular velocity z = 6");
    for (unsigned int c = 0; c < n_motion_components; ++c)
      EXPECT_EQ(moving.initial_velocities.at(0).velocity[c], c + 1.);
    const Scene heavy =
      read_scene_from_text("subsection Lattice\n set Cell = star\nend\n",
                           "scene.prm",
                           {"Dimension=3",
                            "Gravity/Acceleration y=1",
                            "Gravity/Acceleration z=-9.81"});
    const double components[3] = {0, 1, -9.81};
    for (unsigned int c = 0; c < 3; ++c)
      EXPECT_EQ(heavy.gravity.acceleration[c].value(0), components[c]);
  }



  TEST(SceneInSpace, ThePlaneRefusesOutOfPlaneComponents)
  {
    struct Entry
    {
      std::string kind, entries, name, value;
    };
    const std::string driven = "set Joints = all\nset Type = prescribed\n";
    const std::string joints = "set Joints = all\n";
    const std::string line   = "set Type = line\nset Struts = all\n";
    for (const Entry &entry : std::vector<Entry>{
           {"Supports", driven, "Displacement z", "0"},
           {"Supports", driven, "Rotation x", "0"},
           {"Supports", driven, "Rotation y", "0.1*t"},
           {"Supports", joints, "Type", "roller z"},
           {"Loads", joints, "Force z", "1"},
           {"Loads", joints, "Moment x", "t"},
           {"Loads", joints, "Moment y", "1"},
           {"Loads", line, "Force per length z", "1"},
           {"Initial velocities", joints, "Velocity z", "1"},
           {"Initial velocities", joints, "Angular velocity x", "1"},
           {"Initial velocities", joints, "Angular velocity y", "1"}})
      {
        const std::string entries =
          entry.entries + "set " + entry.name + " = " + entry.value;
        expect_parts(plane_message(entry.kind, entries),
                     {"scene.prm:5: " + entry.kind + "/name/" + entry.name +
                        " = " + entry.value,
                      "in space only, but here Dimension = 2",
                      "set Dimension = 3"});
      }
    expect_parts(input_error_of([] {
                   read_scene_from_text(
                     "subsection Lattice\n set Cell = star\nend\n",
                     "scene.prm",
                     {"Gravity/Acceleration z=-9.81"});
                 }),
                 {"Gravity/Acceleration z = -9.81", "Dimension = 3"});
  }



  TEST(SceneInSpace, OldNamesLeadToTheNewOnes)
  {
    expect_parts(plane_message("Supports",
                               "set Joints = all\nset Type = prescribed\n"
                               "set Rotation = 0"),
                 {"Supports/name/Rotation: unknown", "\"Rotation z\""});
    expect_parts(plane_message("Loads", "set Joints = all\nset Moment = 1"),
                 {"Loads/name/Moment: unknown", "\"Moment z\""});
    expect_parts(plane_message("Initial velocities",
                               "set Joints = all\nset Angular velocity = 1"),
                 {"Angular velocity: unknown", "\"Angular velocity z\""});
  }



  TEST(SceneInSpace, ConnectorsPointAnywhere)
  {
    const std::string spring = "set Law = spring\nset Spring stiffness = 1\n"
                               "set Between = ground: all\n";
    const ConnectorDefinition connector =
      space_scene("Connectors",
                  spring +
                    "set Geometry = direction\nset Direction = 2 3 6\n"
                    "set Ground offset = 1 mm, 0, -2 mm")
        .connectors.at(0);
    expect_vector(connector.direction,
                  dealii::Tensor<1, 3>({2. / 7, 3. / 7, 6. / 7}));
    expect_vector(connector.ground_offset,
                  dealii::Tensor<1, 3>({1e-3, 0, -2e-3}));
    const std::string planar =
      spring + "set Geometry = direction\nset Direction = 3 4";
    expect_vector(space_scene("Connectors", planar).connectors.at(0).direction,
                  dealii::Tensor<1, 3>({0.6, 0.8, 0}));

    EXPECT_EQ(plane_message("Connectors", planar + " 0"), "");
    expect_parts(plane_message("Connectors", planar + " 5"),
                 {"Connectors/name/Direction = 3 4 5",
                  "Give the components x and y alone, or set Dimension = 3"});
    expect_parts(plane_message("Connectors",
                               spring + "set Ground offset = 0 1 1"),
                 {"Connectors/name/Ground offset = 0 1 1", "Dimension = 3"});
    expect_parts(space_message("Connectors", spring + "set Direction = 1"),
                 {"Direction = 1", "2 or 3 numbers"});
  }



  TEST(SceneInSpace, MassesTurnAboutThreeAxes)
  {
    using Moments             = dealii::Tensor<1, 3>;
    const std::string entries = "set Joints = all\nset Mass = 1\n"
                                "set Rotary inertia = ";
    const auto        space   = [&](const std::string &numbers) {
      return space_scene("Masses", entries + numbers)
        .masses.at(0)
        .rotary_inertia;
    };
    const auto plane = [&](const std::string &numbers) {
      return plane_scene("Masses", entries + numbers)
        .masses.at(0)
        .rotary_inertia;
    };
    EXPECT_EQ(space("5"), Moments({5, 5, 5}));
    EXPECT_EQ(space("1 2 3"), Moments({1, 2, 3}));
    EXPECT_EQ(plane("5"), Moments({0, 0, 5}));
    EXPECT_EQ(plane("1 2 3"), Moments({0, 0, 3}));
    expect_parts(space_message("Masses", entries + "1 2"),
                 {"Masses/name/Rotary inertia = 1 2",
                  "Give one",
                  "or three, about x, y and z"});
  }



  TEST(SceneInSpace, RigidPartsTurnAboutThreeAxes)
  {
    using Moments             = dealii::Tensor<1, 3>;
    const std::string entries = "set Joints = all\nset Mass = 1\n"
                                "set Rotary inertia = ";
    const auto        space   = [&](const std::string &numbers) {
      return *space_scene("Rigid parts", entries + numbers)
                .rigid_parts.at(0)
                .rotary_inertia;
    };
    EXPECT_EQ(space("5"), Moments({5, 5, 5}));
    EXPECT_EQ(space("1 2 3"), Moments({1, 2, 3}));
    EXPECT_EQ(*plane_scene("Rigid parts", entries + "1 2 9")
                 .rigid_parts.at(0)
                 .rotary_inertia,
              Moments({0, 0, 9}));
    EXPECT_FALSE(space_scene("Rigid parts", entries + "auto")
                   .rigid_parts[0]
                   .rotary_inertia);
    expect_parts(space_message("Rigid parts", entries + "1 2 3.1"),
                 {"Rigid parts/name/Rotary inertia = 1 2 3.1",
                  "no body has such moments"});
    expect_parts(space_message("Rigid parts", entries + "0 0 0"),
                 {"Rotary inertia = 0 0 0", "must not be zero"});
  }



  TEST(SceneInSpace, RevoluteJointsHaveAnAxis)
  {
    const std::string     revolute = "set Joints = all\nset Type = revolute\n";
    const JointDefinition joint =
      space_scene("Joints", revolute + "set Axis = 0 -3 4").joints.at(0);
    EXPECT_EQ(joint.type, JointDefinition::Type::revolute);
    expect_vector(joint.axis, dealii::Tensor<1, 3>({0, -0.6, 0.8}));

    expect_parts(space_message("Joints", revolute),
                 {"Joints/name/Axis must be given", "3 numbers"});
    expect_parts(space_message("Joints", revolute + "set Axis = 0 0 0"),
                 {"Joints/name/Axis = 0 0 0", "zero vector"});
    expect_parts(plane_message("Joints", revolute + "set Axis = 0 0 1"),
                 {"Joints/name/Type = revolute",
                  "In the plane that is Type = hinge"});
  }



  TEST(SceneInSpace, TheReducedCellIsPlanar)
  {
    expect_parts(
      input_error_of([] {
        read_scene_from_text(
          "set Model = reduced cell\nset Dimension = 3\n"
          "subsection Reduced cell\n set Bar mass = 1\n set Load = t\nend\n",
          "cell.prm");
      }),
      {"Dimension = 3", "Model = reduced cell", "Set Dimension = 2"});
  }



  TEST(SceneInSpace, StrutsHaveOrdersUpToFour)
  {
    const std::string frame =
      "subsection Lattice\n set Cell = frame\n set Joints = 0 0; 1 0\n"
      " set Struts = 0 1\nend\n"
      "subsection Sections\n subsection all\n  set Shape = circle\n"
      "  set Radius = 1\n  set Young's modulus = 1\n  set Density = 1\n"
      " end\nend\n"
      "subsection Discretization\n set Order = 5\nend\n";
    EXPECT_EQ(read_scene_from_text(frame, "bar.prm").discretization.order, 5);
    expect_parts(
      input_error_of([&] {
        read_scene_from_text("set Dimension = 3\n" + frame, "bar.prm");
      }),
      {"Discretization/Order = 5", "at most 4", "Global refinements"});
  }



  TEST(SceneInSpace, AWrongDimensionIsTheOnlyMistake)
  {
    const std::string message = input_error_of([] {
      read_scene_from_text(text_with("Loads",
                                     "set Joints = all\nset Force z = 1"),
                           "scene.prm",
                           {"Dimension=4"});
    });
    expect_parts(message, {"Dimension = 4", "one of 2, 3"});
    EXPECT_FALSE(contains(message, "Force z")) << message;
  }



  TEST(SceneInSpace, AllParametersReadBack)
  {
    const Scene first =
      space_scene("Supports", "set Joints = all\nset Type = roller z");
    const Scene again = read_scene_from_text(first.all_parameters, "again.prm");
    EXPECT_EQ(again.context.dimension, 3u);
    EXPECT_EQ(again.all_parameters, first.all_parameters);
    EXPECT_EQ(again.supports[0].fixed, first.supports[0].fixed);
  }
} // namespace
