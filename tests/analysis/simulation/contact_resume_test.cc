#include <analysis/simulation/resumed_run.h>
#include <support/run_program.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A frame that falls on a table, and a disc that falls on the frame. */
  SceneText impact()
  {
    return SceneText()
      .frame("0 0; 1 0; 1 1; 0 1", "0 1; 1 2; 2 3; 3 0")
      .rectangle("bar", 0.05, 0.05, {1e7, 1000})
      .mesh(3)
      .add("Initial velocities/fall", "Joints = all | Velocity y = -2")
      .add("Plates/table", "Shape = plane | Position = 0 -0.03 | Normal = 0 1")
      .add("Plates/disc",
           "Shape = sphere | Radius = 0.2 | Position = 0.6 1.23 | "
           "Displacement x = free | Displacement y = free | Mass = 2 | "
           "Initial velocity y = -3")
      .set("Contact/Friction coefficient", 0.2)
      .set("Contact/Slip velocity", 0.05)
      .time(0.014, 1e-4);
  }
} // namespace

// Also on several ranks, where contact candidates belong to other ranks and
// become ghosts.

TEST(ContactResume, ResumesAnImpactExactly)
{
  for (const char *scheme : {"newmark", "esdirk", "energy-momentum"})
    {
      SCOPED_TRACE(scheme);
      // Before contact, in the impact, and after it.
      const RecordedRun run =
        expect_same_when_resumed(impact().set("Time/Scheme", scheme).str(),
                                 {},
                                 MPI_COMM_WORLD);
      EXPECT_EQ(run.rows.size(), 141u);
    }
}

TEST(ContactResume, ResumesCollidingStrutsExactly)
{
  // Each strut hits only one other, and later the next one.
  std::string joints, struts;
  for (unsigned int i = 0; i < 4; ++i)
    {
      const std::string y = text(0.03 * i * (1 + 0.1 * i));
      joints += (i > 0 ? "; " : "") + text(0.1 * i) + " " + y + "; " +
        text(1 + 0.1 * i) + " " + y;
      struts += (i > 0 ? "; " : "") + text(2 * i) + " " + text(2 * i + 1);
    }
  const RecordedRun run =
    expect_same_when_resumed(SceneText()
                               .frame(joints, struts)
                               .rectangle("bar", 0.02, 0.02, {1e7, 1000})
                               .mesh(3, 1)
                               .support("held", "0, 1", "clamp")
                               .set("Gravity/Acceleration y", -100)
                               .set("Contact/Friction coefficient", 0.2)
                               .time(0.06, 5e-4)
                               .str(),
                             {},
                             MPI_COMM_WORLD);
  EXPECT_EQ(run.rows.size(), 121u);
}

TEST(ContactResume, ResumesAFoldingLatticeExactly)
{
  expect_same_when_resumed(prm_text("crush.prm"),
                           {"Lattice/Cells x=2",
                            "Lattice/Cells y=2",
                            "Constants=H = 54.641e-3, crush = 0.6, T = 0.5",
                            "Plates/upper plate/Position=41 mm, 41.491 mm",
                            "Time/End time=0.2",
                            "Time/Time step=4 ms"},
                           MPI_COMM_WORLD);
}

TEST(ContactResume, ResumesStaticContactExactly)
{
  expect_same_when_resumed(impact()
                             .remove("Initial velocities")
                             .remove("Plates/disc")
                             .remove("Contact")
                             .support("sides", "2, 3", "clamp")
                             .set("Plates/table/Displacement y", "0.9 * t")
                             .set("Time/Scheme", "static")
                             .str(),
                           {},
                           MPI_COMM_WORLD);
}
