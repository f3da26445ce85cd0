#include <analysis/resumed_run.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A frame that falls on a table, and a disc that falls on it. */
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

TEST(ContactResume, AnImpactGoesOnToTheLastDigit)
{
  for (const char *scheme : {"newmark", "esdirk", "energy-momentum"})
    {
      SCOPED_TRACE(scheme);
      // Before anything touches, in the impact, and after it.
      const RecordedRun run =
        expect_same_when_resumed(impact().set("Time/Scheme", scheme));
      EXPECT_EQ(run.rows.size(), 141u);
    }
}

TEST(ContactResume, PressedWithoutInertiaItGoesOnToTheLastDigit)
{
  expect_same_when_resumed(impact()
                             .remove("Initial velocities")
                             .remove("Plates/disc")
                             .remove("Contact")
                             .support("sides", "2, 3", "clamp")
                             .set("Plates/table/Displacement y", "0.9 * t")
                             .set("Time/Scheme", "static"));
}
