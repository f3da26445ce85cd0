#include <support/run_program.h>

#include <set>

namespace
{
  using namespace auxfem::testing_support;

  /** Scenes in the plane run as they are and with `Dimension = 3`. */
  class PlanarInSpace : public ProgramTest
  {
  protected:
    static std::string scene_file(const std::string &name)
    {
      return std::string(AUXFEM_PRM_DIRECTORY) + "/" + name + ".prm";
    }

    Table run(const std::string &file,
              const std::string &dimension,
              const Words       &overrides) const
    {
      Words arguments = {file,
                         "--output",
                         dimension,
                         "--set",
                         "Output/Graphics=false",
                         "--set",
                         "Dimension=" + dimension};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      const ProgramRun run = run_auxfem(arguments);
      EXPECT_EQ(run.exit_code, 0) << run.errors;
      return history(dimension);
    }

    /** Where the column @p name of a planar history stands in one of space. */
    static std::string name_in_space(const std::string &name)
    {
      if (name.size() > 4 && name.substr(name.size() - 4) == ".phi")
        return name + "_z";
      if (name.size() > 2 && name.substr(name.size() - 2) == ".m")
        return name + "z";
      return name;
    }

    /** Number of the kind of a column in `kinds`; apart from all: its own. */
    static unsigned int kind(const std::string &name)
    {
      static const std::vector<std::string> kinds = {
        R"(.*\.u[xyz])",
        R"(.*\.phi(_[xyz])?)",
        R"(.*\.v[xyz])",
        R"(.*\.(r[xyz]|m[xyz]?))",
        "kinetic|strain|stored|dissipated|external|balance"};
      for (unsigned int k = 0; k < kinds.size(); ++k)
        if (std::regex_match(name, std::regex(kinds[k])))
          return k;
      return kinds.size();
    }

    /**
     * Expects all columns of the plane again in space, and there nothing out of
     * the plane, to 1e-9 of the largest value of the same kind, forces and
     * moments being one kind (lengths are of about 1 to 0.01 m); returns the
     * largest rotation (rad).
     */
    double compare(const std::string &file, const Words &overrides = {}) const
    {
      const Table plane = run(file, "2", overrides),
                  space = run(file, "3", overrides);
      std::vector<double>   scales(6, 0.);
      std::set<std::string> in_plane;
      for (const std::string &name : plane.names)
        scales[kind(name)] = std::max(scales[kind(name)], plane.largest(name));
      EXPECT_EQ(plane.n_rows, space.n_rows);
      for (const std::string &name : plane.names)
        {
          const std::string twin = name_in_space(name);
          in_plane.insert(twin);
          for (unsigned int i = 0; i < plane.n_rows; ++i)
            EXPECT_NEAR(space[twin][i],
                        plane[name][i],
                        1e-9 * scales[kind(name)])
              << name << " in row " << i;
        }
      for (const std::string &name : space.names)
        if (in_plane.count(name) == 0)
          {
            EXPECT_LE(space.largest(name), 1e-9 * scales[kind(name)]) << name;
          }
      return scales[1];
    }
  };

  /** A hard hit on prm/lattice.prm, which turns its joints far within 15 ms. */
  // Struts touch at other points of a section in space than in the plane, and
  // how steps are divided depends on all rotations.
  const Words impact = {
    "Effects/Contact=off",
    "Constants=t0 = 10 ms, t1 = 11 ms, peak = 8",
    "Lattice/Cells x=2",
    "Lattice/Cells y=2",
    "Loads/impact/Force x=if(t <= t0, peak / 3 * t / t0, 0)",
    "Time/Time step=0.25 ms",
    "Time/Relative tolerance=none",
    "Time/End time=15 ms"};

  Words with(Words words, const Words &more)
  {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  TEST_F(PlanarInSpace, ImpactOnAStarLatticeByAllSchemes)
  {
    for (const std::string scheme : {"newmark", "hht", "generalized-alpha"})
      {
        SCOPED_TRACE(scheme);
        EXPECT_GT(compare(scene_file("lattice"),
                          with(impact, {"Time/Scheme=" + scheme})),
                  0.5);
      }
  }



  TEST_F(PlanarInSpace, ImpactThatFollowsHingesSpringsMassesWeight)
  {
    const std::string file =
      write("scene.prm", read_text(scene_file("lattice")) + R"(
subsection Joints
  subsection hinges
    set Joints = tips
  end
  subsection springs
    set Joints    = left
    set Type      = rotational spring
    set Stiffness = 0.1 N m/rad
  end
end
subsection Masses
  subsection weights
    set Joints         = top
    set Mass           = 10 g
    set Rotary inertia = 1e-6
  end
end
)");
    EXPECT_GT(compare(file,
                      with(impact,
                           {"Loads/impact/Direction=follows the joint",
                            "Loads/impact/Moment z=1e-2 * t / t0",
                            "Gravity/Acceleration y=-9.81",
                            "Sections/nylon strip/Mass-proportional damping=5",
                            "Connectors/damper/Geometry=direction",
                            "Connectors/damper/Direction=1 2"})),
              0.1);
  }



  TEST_F(PlanarInSpace, SmallDisplacements)
  {
    compare(scene_file("lattice"),
            with(impact,
                 {"Effects/Large rotation=off",
                  "Output/Exit code by verdict=false"}));
  }



  TEST_F(PlanarInSpace, MaxwellConnectors)
  {
    compare(scene_file("star-10x10-maxwell"),
            {"Lattice/Cells x=4",
             "Lattice/Cells y=4",
             "Probes/left=left",
             "Time/End time=2 ms"});
  }



  TEST_F(PlanarInSpace, StarsSqueezedBetweenPlates)
  {
    // Ten times as fast: otherwise rotations would take too many steps.
    EXPECT_GT(compare(scene_file("squeeze"),
                      {"Constants=H = 136.6025e-3, squeeze = 0.1, T = 0.1",
                       "Time/End time=0.1"}),
              0.05);
  }



  TEST_F(PlanarInSpace, StaticsOfACantileverAndAPortal)
  {
    EXPECT_GT(compare(scene_file("cantilever")), 6);
    // The mesh file is named relative to the scene.
    compare(scene_file("portal"));
    compare(scene_file("portal"), {"Effects/Large rotation=off"});
  }
} // namespace
