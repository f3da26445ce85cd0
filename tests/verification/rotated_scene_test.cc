#include <auxfem/model/unknown_records.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>
#include <verification/space_text.h>

#include <iostream>
#include <set>
#include <vector>

using namespace auxfem;
using namespace auxfem::testing_support;

// No direction of space is special: a scene that is rotated with all it has, in
// its text, must give rotated results.

namespace
{
  /** Chooses which way a scene is turned, and its masses. */
  struct Turned
  {
    Quaternion rotation;
    /** About x, y, z before the turn (kg m2). */
    SpaceVector inertia_of_mass;

    SpaceVector operator()(const double x, const double y, const double z) const
    {
      return rotated(rotation, SpaceVector({x, y, z}));
    }

    /**
     * Principal values along the turned axes that are again x, y and z, or all
     * the same.
     */
    SpaceVector turned_inertia() const
    {
      const SpaceTensor R =
        rotated(rotation, SpaceTensor(dealii::unit_symmetric_tensor<3>()));
      SpaceVector values;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          values[i] += R[i][j] * R[i][j] * inertia_of_mass[j];
      return values;
    }
  };

  void add_lattice(SceneText &scene, const Turned &v)
  {
    scene.set("Dimension", "3");
    scene.set("Lattice/Cell", "frame");
    scene.set("Lattice/Joints",
              text(v(0, 0, 0)) + "; " + text(v(1, 0.2, 0.1)) + "; " +
                text(v(1.2, 1, 0.4)) + "; " + text(v(0.3, 1.1, 0.9)) + "; " +
                text(v(0.6, 0.5, 1.2)) + "; " + text(v(0.9, 0.3, 1.6)));
    // The second one is an arc, the last one a rigid part.
    scene.set("Lattice/Struts",
              "0 1; 1 2 0.2 " + text(v(0.3, -0.2, 1)) +
                "; 2 3; 2 4; 1 4; 4 5; 0 4");
    scene.set("Discretization/Order", "2");
    const std::string flat = "Sections/flat/", given = "Sections/given/";
    scene.set(flat + "Shape", "rectangle");
    scene.set(flat + "Width", "0.03");
    scene.set(flat + "Height", "0.05");
    scene.set(flat + "Reference vector", text(v(0.2, 0.5, 1)));
    scene.set(given + "Struts", "2, 3");
    scene.set(given + "Shape", "given");
    scene.set(given + "Area", "1e-3");
    scene.set(given + "Shear area", "6e-4");
    scene.set(given + "Shear area 3", "8e-4");
    scene.set(given + "Second moment of area", "3e-7");
    scene.set(given + "Second moment of area 2", "1e-7");
    scene.set(given + "Torsion constant", "2e-7");
    scene.set(given + "Rotary inertia", "3e-3 1e-3 2e-3");
    scene.set(given + "Reference vector", text(v(-1, 0.3, 0.8)));
    for (const std::string &path : {flat, given})
      {
        scene.set(path + "Young's modulus", "1e8");
        scene.set(path + "Density", "1000");
        scene.set(path + "Stiffness-proportional damping", "1e-4");
        scene.set(path + "Mass-proportional damping", "0.3");
      }
    scene.set("Rigid parts/stick/Struts", "5");
    scene.set("Rigid parts/stick/Mass", "0.5");
  }

  void add_joints_and_supports(SceneText &scene, const Turned &v)
  {
    scene.set("Joints/pivot/Joints", "3");
    scene.set("Joints/pivot/Type", "rotational spring");
    scene.set("Joints/pivot/Stiffness", "5");
    scene.set("Joints/axle/Joints", "1");
    scene.set("Joints/axle/Struts", "4");
    scene.set("Joints/axle/Type", "revolute");
    scene.set("Joints/axle/Axis", text(v(1, 2, -1)));
    scene.support("wall", "3", "pin");
    scene.support("shaker", "0", "prescribed");
    set_vector(scene,
               "Supports/shaker/Displacement",
               v(0.05, -0.02, 0.03),
               "4 * t^2");
    set_vector(scene, "Supports/shaker/Rotation", v(0.5, 0.2, -0.9), "4 * t^2");
    const std::string mass = "Masses/flywheel/";
    scene.set(mass + "Joints", "2");
    scene.set(mass + "Mass", "0.4");
    scene.set(mass + "Rotary inertia", text(v.turned_inertia()));
  }

  void add_connectors(SceneText &scene, const Turned &v)
  {
    const std::string line = "Connectors/line/", along = "Connectors/along/",
                      ground = "Connectors/ground/";
    scene.set(line + "Law", "kelvin-voigt");
    scene.set(line + "Between", "0 5; 1 3; 1 5; 3 5");
    scene.set(along + "Law", "maxwell");
    scene.set(along + "Between", "2 5");
    scene.set(along + "Geometry", "direction");
    scene.set(along + "Direction", text(v(1, 1, -2)));
    scene.set(ground + "Law", "kelvin-voigt");
    scene.set(ground + "Between", "ground: 4");
    scene.set(ground + "Ground offset", text(v(-0.4, 0.6, 0.2)));
    for (const std::string &path : {line, along, ground})
      {
        scene.set(path + "Spring stiffness", "300");
        scene.set(path + "Damping coefficient", "20");
      }
  }

  void add_loads(SceneText &scene, const Turned &v)
  {
    scene.set("Loads/dead/Joints", "4");
    set_vector(scene, "Loads/dead/Force", v(30, -60, 20), "2 * t");
    scene.set("Loads/moments/Joints", "2");
    set_vector(scene, "Loads/moments/Moment", v(15, 9, -6), "2 * t");
    scene.set("Loads/following/Joints", "2");
    scene.set("Loads/following/Direction", "follows the joint");
    set_vector(scene, "Loads/following/Force", v(-20, 10, 50), "2 * t");
    set_vector(scene, "Loads/following/Moment", v(-3, 8, 5), "2 * t");
    scene.set("Loads/wind/Type", "line");
    scene.set("Loads/wind/Struts", "1, 2");
    set_vector(scene, "Loads/wind/Force per length", v(4, 5, -9), "2 * t");
    set_vector(scene, "Gravity/Acceleration", v(2, -9, 3));
  }

  void add_initial_velocity(SceneText &scene, const Turned &v)
  {
    scene.set("Initial velocities/kick/Joints", "2");
    set_vector(scene, "Initial velocities/kick/Velocity", v(0.5, -0.3, 1));
    set_vector(scene, "Initial velocities/kick/Angular velocity", v(2, 1, -3));
  }

  std::string frame(const Turned &turned, const bool is_dynamic)
  {
    SceneText scene = static_scene();
    add_lattice(scene, turned);
    add_joints_and_supports(scene, turned);
    add_connectors(scene, turned);
    add_loads(scene, turned);
    if (is_dynamic)
      add_initial_velocity(scene, turned);
    return scene.time(0.5, is_dynamic ? 0.005 : 0.05).str();
  }

  /** Spatial vectors among the unknowns, by their first one. */
  std::vector<int> first_of_vectors(const SceneRun &run)
  {
    const DofNumbering &dofs = run.model.numbering;
    std::set<int>       firsts;
    for (unsigned int e = 0; e < dofs.elements().size(); ++e)
      for (unsigned int i = 0; i < dofs.n_element_unknowns(e); i += 3)
        firsts.insert(dofs.element_unknowns(e)[i]);
    for (unsigned int joint = 0; joint < run.lattice.joints.size(); ++joint)
      for (const unsigned int first : {0u, first_rotation})
        if (dofs.joint_has(joint, first))
          firsts.insert(dofs.joint_unknown(joint, first));
    return {firsts.begin(), firsts.end()};
  }

  void expect_turned(const SceneRun   &run,
                     const Vector     &turned,
                     const Vector     &reference,
                     const Quaternion &rotation,
                     const double      tolerance)
  {
    for (const int first : first_of_vectors(run))
      {
        const auto at = [first](const Vector &v) {
          return SpaceVector({v[first], v[first + 1], v[first + 2]});
        };
        EXPECT_LT((at(turned) - rotated(rotation, at(reference))).norm(),
                  tolerance)
          << describe(run.model.numbering, first);
      }
  }

  void
  expect_turned(const SceneRun &turned, const SceneRun &run, const Turned &by)
  {
    const State &to = turned.state, &from = run.state;
    const auto   compare =
      [&](const Vector &a, const Vector &b, const double tolerance = 1e-9) {
        expect_turned(run, a, b, by.rotation, tolerance * largest_size(b));
      };
    compare(to.displacement, from.displacement);
    compare(to.residual, from.residual);
    if (from.acceleration)
      {
        compare(*to.velocity, *from.velocity);
        // The tolerance is Newton's residual over the small rotary inertia.
        compare(*to.acceleration, *from.acceleration, 1e-8);
      }
    ASSERT_EQ(to.rotations.size(), from.rotations.size());
    for (unsigned int i = 0; i < from.rotations.size(); ++i)
      {
        const Quaternion wanted =
          by.rotation * from.rotations[i] * conjugate(by.rotation);
        EXPECT_NEAR(dot(to.rotations[i], wanted), 1, 1e-15);
        EXPECT_LT((to.rotations[i].vector - wanted.vector).norm(), 1e-9);
      }
    const Energies &a = to.energies, &b = from.energies;
    const double    tolerance = 1e-9 * b.external();
    EXPECT_NEAR(a.kinetic(), b.kinetic(), tolerance);
    EXPECT_NEAR(a.strain(), b.strain(), tolerance);
    EXPECT_NEAR(a.stored(), b.stored(), tolerance);
    EXPECT_NEAR(a.dissipated(), b.dissipated(), tolerance);
    EXPECT_NEAR(a.external(), b.external(), tolerance);
  }

  /** Largest angle by which something turned since rest. */
  double largest_increment(const State &state)
  {
    double angle = 0;
    for (const Quaternion &rotation : state.rotations)
      angle = std::max(angle, rotation_vector(rotation).norm());
    return angle;
  }

  void compare(const Turned            &turned,
               const std::string       &scheme,
               std::vector<std::string> overrides = {})
  {
    SCOPED_TRACE(scheme);
    const bool is_large = overrides.empty(), is_dynamic = scheme != "static";
    overrides.push_back("Time/Scheme=" + scheme);
    SceneRun run(frame({{}, turned.inertia_of_mass}, is_dynamic), overrides),
      other(frame(turned, is_dynamic), overrides);
    run.run();
    other.run();
    std::cout << scheme << ": largest turn " << largest_increment(run.state)
              << " rad, " << run.work().iterations << " and "
              << other.work().iterations << " iterations" << std::endl;
    if (is_large)
      {
        EXPECT_GT(largest_increment(run.state), 0.8) << "not a large rotation";
      }
    expect_turned(other, run, turned);
  }

  /** A rotation without any symmetry: the mass must be that of a ball. */
  const Turned generic = {normalized(
                            Quaternion{0.3, SpaceVector({0.5, -0.7, 0.4})}),
                          SpaceVector({0.02, 0.02, 0.02})};

  /** x to y to z to x. */
  const Turned cyclic = {{0.5, SpaceVector({0.5, 0.5, 0.5})},
                         SpaceVector({0.01, 0.03, 0.02})};
} // namespace

TEST(RotatedScene, MovesAlikeByAnyScheme)
{
  for (const std::string scheme : {"newmark", "hht", "generalized-alpha"})
    compare(generic, scheme);
}

TEST(RotatedScene, HasRotatedEquilibria)
{
  compare(generic, "static");
}

TEST(RotatedScene, MayHavePrincipalAxesOfInertia)
{
  compare(cyclic, "generalized-alpha");
}

TEST(RotatedScene, MovesAlikeInSmallDisplacements)
{
  compare(generic, "newmark", {"Effects/Large rotation=off"});
  compare(generic, "static", {"Effects/Large rotation=off"});
}
