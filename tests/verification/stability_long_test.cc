#include <gtest/gtest.h>
#include <verification/hard_case.h>
#include <verification/tumbling_cell.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// The catalogue of hard cases: a hundred thousand undamped steps.

TEST(StabilityOfLongRuns, TumblingCell)
{
  SceneText scene = tumbling_cell();
  // Without contact all errors are those of the schemes.
  scene.set("Effects/Contact", "off").set("Newton/Tolerance", 1e-10);
  HardCase hard;
  hard.title   = "A hundred thousand steps of a tumbling cell";
  hard.prm     = scene.str();
  hard.is_free = true;
  // Ten thousand steps more are enough for any digit to tell.
  hard.part_before_checkpoint = 0.9;
  go_on_for_long(hard);
}
