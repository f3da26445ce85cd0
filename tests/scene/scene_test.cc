#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene.h>
#include <auxfem/time/schemes/alpha_family.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <scene/expect_close.h>

#include <cmath>

namespace
{
  using namespace auxfem;
  using namespace auxfem::testing_support;
  using dealii::numbers::PI;

  /** The coefficients of the scheme of @p scene, one of the alpha family. */
  const AlphaFamily::Coefficients &alpha_family(const Scene &scene)
  {
    return dynamic_cast<const AlphaFamily &>(*scene.time.scheme).coefficients();
  }

  /** A scene with something in every subsection. */
  const std::string full = R"(
set Title = Impact on a star array
set Constants = F1 = 5, F0 = min(F1, 7)/2, t0 = 10 ms
subsection Lattice
  set Cell = star
  set Cells x = 5
  set Cells y = 4
  set Strut length = 20 mm
end
subsection Sets
  set impacted = joints: y > ymax - 1e-6
end
subsection Sections
  subsection bars
    set Shape = rectangle
    set Width = 10 mm
    set Height = 2 mm
    set Young's modulus = 70 GPa
    set Poisson's ratio = 0.25
    set Density = 2.7 g/cm3
    set Stiffness-proportional damping = 1 ms
    set Mass-proportional damping = 3 1/s
  end
  subsection rods
    set Struts = stubs
    set Shape = tube
    set Outer radius = 2 mm
    set Wall thickness = 1 mm
    set Shear correction = 0.6
    set Young's modulus = 200 GPa
    set Density = 7850
  end
end
subsection Joints
  subsection soft
    set Joints = left
    set Type = rotational spring
    set Stiffness = 5 N m/rad
  end
end
subsection Connectors
  subsection damper
    set Law = kelvin-voigt
    set Spring stiffness = 20 kN/m
    set Damping coefficient = 50 N s/m
  end
  subsection bumper
    set Law = spring
    set Spring stiffness = 1 N/mm
    set Between = ground: right
    set Geometry = direction
    set Direction = 3 4
    set Ground offset = 1 mm 2 mm
  end
end
subsection Supports
  subsection foundation
    set Joints = bottom
  end
  subsection guide
    set Joints = left
    set Type = roller x
  end
  subsection pull
    set Joints = right
    set Type = prescribed
    set Displacement x = 10 mm
    set Rotation z = F0*t
  end
end
subsection Masses
  subsection impactor
    set Joints = impacted
    set Mass = 300 g
  end
end
subsection Loads
  subsection impact
    set Joints = top
    set Force y = -F0*min(t/t0, 1)
    set Moment z = 2 kN mm
  end
  subsection wind
    set Type = line
    set Struts = all
    set Force per length x = 3 N/mm
  end
end
subsection Gravity
  set Acceleration y = -9.81
end
subsection Initial velocities
  subsection impactor
    set Joints = impacted
    set Velocity y = -36 km/h
    set Angular velocity z = 180 deg/s
  end
end
subsection Discretization
  set Order = 2
  set Global refinements = 1
end
subsection Effects
  set Rotary inertia = off
  set Gravity = on
end
subsection Time
  set Scheme = hht
  set HHT alpha = -0.1
  set End time = 50 ms
  set Time step = 50 us
  set Start from = static equilibrium
end
subsection Newton
  set Tolerance = 1e-9
  set Maximum iterations = 12
  set Factorization = every iteration
end
subsection Solver
  set Type = gmres
  set Preconditioner = ilu
  set Tolerance = 1e-6
  set Maximum iterations = 70
end
subsection Output
  set Directory = somewhere
  set Graphics = false
  set Graphics interval = 1 ms
  set History interval = 10
  set Segments per element = 3
end
subsection Probes
  set top = top
  set middle = nearest: 0, 0
end
)";

  TEST(Scene, DescribesTheStructure)
  {
    const Scene scene = read_scene_from_text(full, "folder/full.prm");
    EXPECT_EQ(scene.title, "Impact on a star array");
    EXPECT_EQ(scene.file, "folder/full.prm");
    EXPECT_EQ(scene.context.directory, "folder");
    ASSERT_EQ(scene.context.constants.size(), 3u);
    EXPECT_EQ(scene.context.constants[2].first, "t0");
    expect_close(scene.context.constants[2].second, 0.01);
    EXPECT_EQ(scene.lattice.n_cells, (std::array<unsigned int, 3>{{5, 4, 1}}));
    EXPECT_NE(scene.lattice.cell, nullptr);
    ASSERT_EQ(scene.sets.size(), 1u);
    EXPECT_EQ(scene.sets[0].name, "impacted");
    EXPECT_EQ(scene.sets[0].selection, "joints: y > ymax - 1e-6");
    EXPECT_EQ(scene.sets[0].path, "Sets/impacted");
    ASSERT_EQ(scene.joints.size(), 1u);
    EXPECT_EQ(scene.joints[0].type, JointDefinition::Type::rotational_spring);
    EXPECT_EQ(scene.joints[0].struts, "all");
    expect_close(scene.joints[0].stiffness, 5);
  }



  TEST(Scene, ReducesSections)
  {
    const Scene scene = read_scene_from_text(full, "full.prm");
    ASSERT_EQ(scene.sections.size(), 2u);
    EXPECT_EQ(scene.sections[0].struts, "all");
    const Section &bar = scene.sections[0].section;
    expect_close(bar.area, 2e-5);
    expect_close(bar.shear_area_2, 2e-5 * 5 / 6);
    expect_close(bar.second_moment_3, 1e-2 * 8e-9 / 12);
    expect_close(bar.radius, 1e-3);
    expect_close(bar.youngs_modulus, 70e9);
    expect_close(bar.shear_modulus, 28e9);
    expect_close(bar.density, 2700);
    expect_close(bar.stiffness_proportional_damping, 1e-3);
    expect_close(bar.mass_proportional_damping, 3);

    EXPECT_EQ(scene.sections[1].struts, "stubs");
    const Section &rod = scene.sections[1].section;
    expect_close(rod.area, PI * 3e-6);
    expect_close(rod.shear_area_2, 0.6 * PI * 3e-6);
    expect_close(rod.second_moment_3, PI / 4 * 15e-12);
    expect_close(rod.radius, 2e-3);
  }



  TEST(Scene, ReducesTheOtherShapes)
  {
    const std::string lattice = "subsection Lattice\nset Cell = star\nend\n";
    const std::string start   = "subsection Sections\nsubsection s\n";
    const std::string material =
      "set Young's modulus = 1\nset Density = 1\nend\nend\n";
    const Section circle =
      read_scene_from_text(lattice + start +
                             "set Shape = circle\nset Radius = 2\n" + material,
                           "x.prm")
        .sections.at(0)
        .section;
    expect_close(circle.area, 4 * PI);
    expect_close(circle.shear_area_2, 3.6 * PI);
    expect_close(circle.second_moment_3, 4 * PI);

    // the numbers of a rectangle of width 2 and height 6
    const Section given =
      read_scene_from_text(lattice + start +
                             "set Shape = given\nset Area = 12\n"
                             "set Shear area = 10\n"
                             "set Second moment of area = 36\n" +
                             material,
                           "x.prm")
        .sections.at(0)
        .section;
    expect_close(given.area, 12);
    expect_close(given.shear_area_2, 10);
    expect_close(given.second_moment_3, 36);
    expect_close(given.radius, 3);
  }



  TEST(Scene, DescribesConnectors)
  {
    const Scene scene = read_scene_from_text(full, "full.prm");
    ASSERT_EQ(scene.connectors.size(), 2u);
    const ConnectorDefinition &damper = scene.connectors[0];
    EXPECT_EQ(damper.between, "in-cell");
    EXPECT_EQ(damper.geometry, ConnectorDefinition::Geometry::line);
    ASSERT_NE(damper.law, nullptr);
    EXPECT_TRUE(damper.law->is_viscous());
    expect_close(damper.law->relaxed(0).stiffness, 20e3);
    const ConnectorDefinition &bumper = scene.connectors[1];
    EXPECT_EQ(bumper.geometry, ConnectorDefinition::Geometry::direction);
    expect_close(bumper.direction[0], 0.6);
    expect_close(bumper.direction[1], 0.8);
    expect_close(bumper.ground_offset[1], 2e-3);
    EXPECT_FALSE(bumper.law->is_viscous());
  }



  TEST(Scene, DescribesSupportsAndLoads)
  {
    using Fixed       = std::array<bool, n_motion_components>;
    const Scene scene = read_scene_from_text(full, "full.prm");
    ASSERT_EQ(scene.supports.size(), 3u);
    EXPECT_EQ(scene.supports[0].fixed,
              (Fixed{{true, true, false, false, false, true}}));
    EXPECT_EQ(scene.supports[1].fixed, (Fixed{{false, true}}));
    EXPECT_EQ(scene.supports[2].fixed,
              (Fixed{{true, false, false, false, false, true}}));
    expect_close(scene.supports[2].motion[0].value(0.3), 0.01);
    expect_close(scene.supports[2].motion[rotation_z].value(0.4), 1);

    ASSERT_EQ(scene.masses.size(), 1u);
    expect_close(scene.masses[0].mass, 0.3);
    ASSERT_EQ(scene.joint_loads.size(), 1u);
    EXPECT_TRUE(scene.joint_loads[0].components[0].is_zero());
    expect_close(scene.joint_loads[0].components[1].value(0.004), -1);
    expect_close(scene.joint_loads[0].components[rotation_z].value(0), 2);
    ASSERT_EQ(scene.line_loads.size(), 1u);
    expect_close(scene.line_loads[0].components[0].value(0), 3000);
    expect_close(scene.gravity.acceleration[1].value(0), -9.81);
    ASSERT_EQ(scene.initial_velocities.size(), 1u);
    expect_close(scene.initial_velocities[0].velocity[1], -10);
    expect_close(scene.initial_velocities[0].velocity[rotation_z], PI);
  }



  TEST(Scene, HoldsTheSettingsOfTheComputation)
  {
    const Scene scene = read_scene_from_text(full, "full.prm");
    EXPECT_EQ(scene.discretization.order, 2u);
    EXPECT_EQ(scene.discretization.refinements, 1u);
    EXPECT_EQ(scene.effects.rotary_inertia, Switch::off);
    EXPECT_EQ(scene.effects.gravity, Switch::on);
    EXPECT_EQ(scene.effects.inertia, Switch::automatic);
    EXPECT_EQ(scene.time.scheme->name(), "hht");
    expect_close(alpha_family(scene).alpha_f, 0.1);
    expect_close(scene.time.end_time, 0.05);
    expect_close(scene.time.step, 5e-5);
    EXPECT_EQ(scene.time.smallest_step, 0);
    EXPECT_TRUE(scene.time.static_start);
    expect_close(scene.newton.tolerance, 1e-9);
    EXPECT_EQ(scene.newton.maximum_iterations, 12u);
    EXPECT_FALSE(scene.newton.keep_factorization);
    EXPECT_EQ(scene.solver.type, "gmres");
    EXPECT_EQ(scene.solver.preconditioner, "ilu");
    expect_close(scene.solver.tolerance, 1e-6);
    EXPECT_EQ(scene.solver.maximum_iterations, 70u);
    EXPECT_EQ(scene.output.directory, "somewhere");
    EXPECT_FALSE(scene.output.graphics);
    expect_close(*scene.output.graphics_interval, 1e-3);
    EXPECT_EQ(scene.output.history_interval, 10u);
    EXPECT_EQ(scene.output.segments, 3u);
    ASSERT_EQ(scene.output.probes.size(), 2u);
    EXPECT_EQ(scene.output.probes[1].selection, "nearest: 0, 0");
  }



  TEST(Scene, DefaultsAreThoseOfTheStructs)
  {
    const Scene scene =
      read_scene_from_text("subsection Lattice\nset Cell = star\nend\n",
                           "small.prm");
    const Scene plain;
    EXPECT_EQ(scene.time.scheme->name(), plain.time.scheme->name());
    expect_close(alpha_family(scene).beta, alpha_family(plain).beta);
    expect_close(alpha_family(scene).gamma, alpha_family(plain).gamma);
    expect_close(scene.time.end_time, plain.time.end_time);
    expect_close(scene.time.step, plain.time.step);
    EXPECT_EQ(scene.time.static_start, plain.time.static_start);
    expect_close(scene.newton.tolerance, plain.newton.tolerance);
    EXPECT_EQ(scene.newton.maximum_iterations, plain.newton.maximum_iterations);
    EXPECT_EQ(scene.newton.keep_factorization, plain.newton.keep_factorization);
    expect_close(scene.newton.jacobian_reuse_threshold,
                 plain.newton.jacobian_reuse_threshold);
    EXPECT_EQ(scene.discretization.order, plain.discretization.order);
    EXPECT_EQ(scene.solver.type, plain.solver.type);
    EXPECT_EQ(scene.solver.preconditioner, plain.solver.preconditioner);
    expect_close(scene.solver.tolerance, plain.solver.tolerance);
    EXPECT_EQ(scene.solver.maximum_iterations, plain.solver.maximum_iterations);
    EXPECT_EQ(scene.output.directory, plain.output.directory);
    EXPECT_EQ(scene.output.graphics, plain.output.graphics);
    EXPECT_EQ(scene.output.history_interval, plain.output.history_interval);
    EXPECT_EQ(scene.output.segments, plain.output.segments);
    EXPECT_EQ(scene.lattice.n_cells, plain.lattice.n_cells);
  }



  TEST(Scene, AllParametersReadBackAsTheSameScene)
  {
    const Scene first = read_scene_from_text(full, "full.prm");
    const Scene again = read_scene_from_text(first.all_parameters, "again.prm");
    EXPECT_EQ(again.all_parameters, first.all_parameters);
    EXPECT_EQ(again.title, first.title);
    EXPECT_EQ(again.sections.size(), first.sections.size());
    EXPECT_EQ(again.sections[1].section.shear_area_2,
              first.sections[1].section.shear_area_2);
    EXPECT_EQ(again.connectors[1].direction, first.connectors[1].direction);
    EXPECT_EQ(again.joint_loads[0].components[1].value(0.004),
              first.joint_loads[0].components[1].value(0.004));
    EXPECT_EQ(again.time.step, first.time.step);
    EXPECT_EQ(again.output.probes[1].name, first.output.probes[1].name);
  }



  TEST(Scene, OverridesCount)
  {
    const Scene scene = read_scene_from_text(full,
                                             "full.prm",
                                             {"Time/Time step=1 ms",
                                              "Probes/corner=nearest: 0, 0",
                                              "Sections/bars/Height=3 mm"});
    expect_close(scene.time.step, 1e-3);
    EXPECT_EQ(scene.output.probes.size(), 3u);
    expect_close(scene.sections[0].section.radius, 1.5e-3);
    EXPECT_NE(scene.all_parameters.find("1 ms"), std::string::npos);
  }



  TEST(Scene, ReferenceNamesEveryChoice)
  {
    for (const std::string &reference :
         {describe_parameters(scene_schemas()),
          describe_parameters_markdown(scene_schemas())})
      {
        for (const auto &law : connector_law_registry())
          EXPECT_NE(reference.find("Law = " + law.name), std::string::npos);
        for (const auto &cell : cell_registry())
          EXPECT_NE(reference.find("Cell = " + cell.name), std::string::npos);
        for (const char *part : {"Initial velocities",
                                 "Smallest time step",
                                 "Young's modulus",
                                 "10 ms",
                                 "> 0",
                                 "kg/m3",
                                 "roller x"})
          EXPECT_NE(reference.find(part), std::string::npos) << part;
      }
  }
} // namespace
