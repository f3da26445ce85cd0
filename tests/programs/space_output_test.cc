#include <auxfem/mathematics/rotation.h>

#include <programs/single_precision.h>
#include <support/graphics_series.h>

namespace
{
  using namespace auxfem;
  using namespace auxfem::testing_support;

  /** Files of scenes in space, read back as ParaView does. */
  class SpaceOutputProgram : public ProgramTest
  {
  protected:
    void run(const std::string &scene, const Words &overrides = {}) const
    {
      write("scene.prm", scene);
      Words arguments = {"scene.prm", "--output", "out"};
      arguments.insert(arguments.end(), overrides.begin(), overrides.end());
      const ProgramRun run = run_auxfem(arguments);
      if (run.exit_code != 0)
        throw std::runtime_error(run.errors);
    }

    GraphicsSeries series(const std::string &name) const
    {
      return {path("out/" + name + ".pvd"), path("vtk_" + name)};
    }

    static SpaceVector vector(const Table       &points,
                              const std::string &field,
                              const unsigned int row)
    {
      SpaceVector result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] = points[field + "." + std::to_string(c)][row];
      return result;
    }

    /** Section axes as columns. */
    static SpaceTensor axes(const Table &points, const unsigned int row)
    {
      SpaceTensor rows;
      for (unsigned int i = 0; i < 3; ++i)
        rows[i] = vector(points, "d" + std::to_string(i + 1), row);
      return transpose(rows);
    }

    static void expect_equal(const SpaceTensor &a,
                             const SpaceTensor &b,
                             const double       tolerance)
    {
      EXPECT_LT((a - b).norm(), tolerance) << a << " and\n" << b;
    }
  };

  /** A section whose stiffnesses are round: EA 1e5, GA 4e4, in N m2 below. */
  const std::string given_section       = R"(
subsection Sections
  subsection bar
    set Shape                   = given
    set Young's modulus         = 1 GPa
    set Poisson's ratio         = 0.25
    set Density                 = 1000 kg/m3
    set Area                    = 1e-4 m2
    set Shear area              = 1e-4 m2
    set Second moment of area   = 2e-9 m4
    set Second moment of area 2 = 5e-9 m4
    set Torsion constant        = 1e-9 m4
    set Reference vector        = 1 2 3
  end
end
)";
  const double      bending_stiffness_2 = 5, bending_stiffness_3 = 2,
               torsion_stiffness = 0.4;

  /** A strut of 0.3 m from the origin, with an oblique section. */
  const std::string slanted_strut = "set Dimension = 3\n" + given_section + R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0 0; 0.1 0.2 0.2
  set Struts = 0 1
end
subsection Supports
  subsection wall
    set Joints = 0
  end
end
subsection Probes
  set tip = 1
end
)";
  const double      slanted_length = 0.3;
  const SpaceVector slanted_tangent({1. / 3, 2. / 3, 2. / 3});
  const SpaceTensor slanted_axes =
    section_frame(slanted_tangent, SpaceVector({1., 2., 3.}));

  TEST_F(SpaceOutputProgram, ACantileverBendsAboutBothAxesAndTwists)
  {
    run(slanted_strut + R"(
subsection Loads
  subsection pull
    set Joints   = 1
    set Force x  = 3 * t
    set Force y  = -2 * t
    set Force z  = 5 * t
    set Moment x = 0.3 * t
    set Moment y = 0.7 * t
    set Moment z = -0.2 * t
  end
end
subsection Effects
  set Large rotation = off
end
subsection Time
  set Scheme    = static
  set End time  = 1
  set Time step = 1
end
)");
    const SpaceVector F({3, -2, 5}), M({0.3, 0.7, -0.2});
    // The part beyond a section acts on the part before it.
    const auto moment = [&](const double s) {
      return M +
        (slanted_length - s) * dealii::cross_product_3d(slanted_tangent, F);
    };
    const auto in_axes = [&](const SpaceVector &v) {
      return transpose(slanted_axes) * v;
    };
    const SpaceVector stiffness(
      {torsion_stiffness, bending_stiffness_2, bending_stiffness_3});

    const GraphicsSeries solution = series("solution");
    ASSERT_EQ(solution.points.size(), 2u);
    const Table &points = solution.points.back();
    for (unsigned int i = 0; i < points.n_rows; ++i)
      {
        const double s =
          std::hypot(points["x"][i], points["y"][i], points["z"][i]);
        const SpaceVector force = in_axes(F), bending = in_axes(moment(s)),
                          mean = in_axes(moment(s / 2));
        // Lines and parabolas, which the element has; Newton's tolerance is
        // below single precision.
        const double tolerance = 20 * single_precision;
        EXPECT_NEAR(points["axial_force"][i], force[0], tolerance);
        EXPECT_NEAR(points["shear_force_2"][i], force[1], tolerance);
        EXPECT_NEAR(points["shear_force_3"][i], force[2], tolerance);
        EXPECT_NEAR(points["torque"][i], bending[0], tolerance);
        EXPECT_NEAR(points["bending_moment_2"][i], bending[1], tolerance);
        EXPECT_NEAR(points["bending_moment_3"][i], bending[2], tolerance);
        SpaceVector rotation;
        for (unsigned int k = 0; k < 3; ++k)
          rotation[k] = mean[k] * s / stiffness[k];
        EXPECT_LT(
          (vector(points, "rotation", i) - slanted_axes * rotation).norm(),
          tolerance);
        EXPECT_NEAR(points["strain_energy_density"][i],
                    (force[0] * force[0] / 1e5 +
                     (force[1] * force[1] + force[2] * force[2]) / 4e4 +
                     bending[0] * bending[0] / torsion_stiffness +
                     bending[1] * bending[1] / bending_stiffness_2 +
                     bending[2] * bending[2] / bending_stiffness_3) /
                      2,
                    tolerance);
        expect_equal(axes(solution.points[0], i),
                     slanted_axes,
                     5 * single_precision);
      }

    const Table table = history();
    SpaceVector rotation;
    for (unsigned int k = 0; k < 3; ++k)
      rotation[k] =
        in_axes(moment(slanted_length / 2))[k] * slanted_length / stiffness[k];
    const SpaceVector at_wall = moment(0);
    for (unsigned int c = 0; c < 3; ++c)
      {
        const std::string axis(1, "xyz"[c]);
        // Newton's tolerance is 1e-8 of the forces.
        EXPECT_NEAR(table["wall.r" + axis].back(), -F[c], 1e-6);
        EXPECT_NEAR(table["wall.m" + axis].back(), -at_wall[c], 1e-6);
        EXPECT_NEAR(table["tip.phi_" + axis].back(),
                    (slanted_axes * rotation)[c],
                    1e-6);
      }
  }



  TEST_F(SpaceOutputProgram, ABarTwistsByMoreThanAWholeTurn)
  {
    run(slanted_strut + R"(
subsection Supports
  subsection grip
    set Joints         = 1
    set Type           = prescribed
    set Displacement x = 0
    set Displacement y = 0
    set Displacement z = 0
    set Rotation x     = 10 * t / 3
    set Rotation y     = 20 * t / 3
    set Rotation z     = 20 * t / 3
  end
end
subsection Discretization
  set Global refinements = 4
end
subsection Time
  set Scheme    = static
  set End time  = 1
  set Time step = 0.1
end
)");
    const double angle  = 10,
                 torque = torsion_stiffness * angle / slanted_length;
    // Angles of up to 10 rad in single precision.
    const double         tolerance = 20 * single_precision;
    const GraphicsSeries solution  = series("solution");
    const Table         &points    = solution.points.back();
    for (unsigned int i = 0; i < points.n_rows; ++i)
      {
        const double s =
          std::hypot(points["x"][i], points["y"][i], points["z"][i]);
        const SpaceVector rotation =
          angle * s / slanted_length * slanted_tangent;
        // The twist is even, and so is what the element interpolates.
        EXPECT_LT((vector(points, "rotation", i) - rotation).norm(), tolerance);
        expect_equal(axes(points, i),
                     rotated(exponential(rotation), slanted_axes),
                     tolerance);
        EXPECT_NEAR(points["torque"][i], torque, tolerance * torque);
        EXPECT_NEAR(points["bending_moment_2"][i], 0, tolerance * torque);
        EXPECT_NEAR(points["bending_moment_3"][i], 0, tolerance * torque);
      }

    const Table table = history();
    for (unsigned int c = 0; c < 3; ++c)
      {
        const std::string axis(1, "xyz"[c]);
        for (unsigned int i = 0; i < table.n_rows; ++i)
          EXPECT_NEAR(table["tip.phi_" + axis][i],
                      angle * slanted_tangent[c] * table["time"][i],
                      1e-12);
        EXPECT_NEAR(table["grip.m" + axis].back(),
                    torque * slanted_tangent[c],
                    1e-8 * torque);
      }
    EXPECT_NEAR(std::stod(summary("largest_rotation_radian")), angle, 1e-12);
  }

  /** A bent frame that is hit out of its plane and tumbles. */
  const std::string tumbling_frame = "set Dimension = 3\n" + given_section + R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0 0; 0.3 0.1 0.2; 0.5 -0.2 0; 0.9 0.1 -0.1
  set Struts = 0 1; 1 2; 2 3
end
subsection Connectors
  subsection tie
    set Law              = spring
    set Spring stiffness = 20 N/m
    set Between          = 0 3
  end
end
subsection Supports
  subsection pivot
    set Joints = 0
    set Type   = pin
  end
end
subsection Loads
  subsection hit
    set Joints   = 3
    set Force x  = 0.5
    set Force z  = 1
    set Moment x = 0.05
  end
end
subsection Time
  set Scheme    = generalized-alpha
  set End time  = 0.3
  set Time step = 1 ms
end
subsection Probes
  set knee = 2
  set tip  = 3
end
subsection Output
  set Graphics interval = 0.1
end
)";

  TEST_F(SpaceOutputProgram, MovingFramesHaveAllColumnsAndFields)
  {
    run(tumbling_frame);
    const Table table = history();
    Words       names = {"time"};
    for (const char *probe : {"knee.", "tip."})
      for (const char *name : {"ux",
                               "uy",
                               "uz",
                               "phi_x",
                               "phi_y",
                               "phi_z",
                               "vx",
                               "vy",
                               "vz",
                               "ax",
                               "ay",
                               "az"})
        names.push_back(std::string(probe) + name);
    for (const char *name : {"rx", "ry", "rz", "mx", "my", "mz"})
      names.push_back(std::string("pivot.") + name);
    for (const char *name : {"tie.force",
                             "tie.extension",
                             "kinetic",
                             "strain",
                             "stored",
                             "external",
                             "numerical",
                             "hit.load_work",
                             "balance"})
      names.push_back(name);
    EXPECT_EQ(table.names, names);
    const std::string units = read_text(path("out/history.units.csv"));
    for (const std::string &name : names)
      expect_contains(units, {"\n" + name + ","});

    Words fields = {"x", "y", "z"};
    for (const char *name :
         {"displacement", "velocity", "rotation", "d1", "d2", "d3"})
      for (unsigned int c = 0; c < 3; ++c)
        fields.push_back(name + ("." + std::to_string(c)));
    for (const char *name : {"axial_force",
                             "shear_force_2",
                             "shear_force_3",
                             "torque",
                             "bending_moment_2",
                             "bending_moment_3",
                             "strain_energy_density",
                             "radius",
                             "strut",
                             "cell",
                             "section",
                             "mpi_rank"})
      fields.push_back(name);
    const GraphicsSeries solution = series("solution");
    ASSERT_EQ(solution.points.size(), 4u);
    EXPECT_EQ(solution.points[0].names, fields);
  }



  TEST_F(SpaceOutputProgram, JointsMoveInPicturesAsInTheHistory)
  {
    run(tumbling_frame);
    const Table          table    = history();
    const GraphicsSeries solution = series("solution");
    for (unsigned int i = 0; i < solution.datasets.n_rows; ++i)
      {
        const Table       &points = solution.points[i];
        const unsigned int row =
          row_at_time(table, solution.datasets["time"][i]);
        for (const auto &[probe, rows] :
             {std::pair("knee.", rows_at(points, 0.5, -0.2)),
              std::pair("tip.", rows_at(points, 0.9, 0.1))})
          {
            ASSERT_FALSE(rows.empty());
            for (const unsigned int point : rows)
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const std::string axis(1, "xyz"[c]);
                  for (const auto &[field, column] :
                       {std::pair("displacement", "u"),
                        std::pair("rotation", "phi_"),
                        std::pair("velocity", "v")})
                    {
                      const double value = table[probe + (column + axis)][row];
                      EXPECT_NEAR(vector(points, field, point)[c],
                                  value,
                                  single_precision * (1 + std::abs(value)))
                        << probe << column << axis;
                    }
                }
          }
      }
    EXPECT_GT(table.largest("tip.phi_x"), 0.5) << "hardly anything has moved";
    EXPECT_GT(table.largest("tip.uz"), 0.1);
  }



  TEST_F(SpaceOutputProgram, SectionAxesAreThoseAtRestRotated)
  {
    run(tumbling_frame);
    const GraphicsSeries solution = series("solution");
    const Table         &at_rest  = solution.points.front();
    SpaceTensor          one;
    for (unsigned int i = 0; i < 3; ++i)
      one[i][i] = 1;
    for (const Table &points : solution.points)
      {
        ASSERT_EQ(points.n_rows, at_rest.n_rows);
        for (unsigned int i = 0; i < points.n_rows; ++i)
          {
            const SpaceTensor now = axes(points, i);
            // Sums of three products of rounded numbers.
            expect_equal(transpose(now) * now, one, 10 * single_precision);
            expect_equal(now,
                         rotated(exponential(vector(points, "rotation", i)),
                                 axes(at_rest, i)),
                         20 * single_precision);
          }
      }
  }



  TEST_F(SpaceOutputProgram, TwoRanksWriteWhatOneDoes)
  {
    run(tumbling_frame);
    const ProgramRun two = run_auxfem_on(2, {"scene.prm", "--output", "two"});
    ASSERT_EQ(two.exit_code, 0) << two.errors;
    const Table one = history(), other = history("two");
    ASSERT_EQ(one.n_rows, other.n_rows);
    for (const std::string &name : one.names)
      for (unsigned int i = 0; i < one.n_rows; ++i)
        // Newton's iterations end at 1e-8, at other roundings on two ranks.
        EXPECT_NEAR(one[name][i],
                    other[name][i],
                    1e-6 *
                      (name == "balance" ? one.largest("external")
                                         : one.largest(name)))
          << name << " in row " << i;

    const GraphicsSeries solution(path("two/solution.pvd"), path("vtk_two"));
    EXPECT_EQ(solution.points.back().n_rows,
              series("solution").points.back().n_rows);
  }



  TEST_F(SpaceOutputProgram, TheScreenSaysThatStrutsAreInSpace)
  {
    write("scene.prm", tumbling_frame);
    const ProgramRun run = run_auxfem({"--check", "scene.prm"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output, {"Simulated\n  struts in space"});
  }
} // namespace
