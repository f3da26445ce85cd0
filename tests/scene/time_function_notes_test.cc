#include <auxfem/scene/step_ends.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <fstream>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  std::vector<std::string> notes_of(const std::string &force)
  {
    return time_function_notes(read_scene_from_text(
      SceneText()
        .frame("0 0; 1 0", "0 1")
        .circle("s", 0.01, {1e9, 1000})
        .add("Loads/blast", "Joints = 1 | Force y = " + force)
        .time(1, 0.01),
      "scene.prm"));
  }
} // namespace

TEST(TimeFunctionNotes, ResolvedFunctionsHaveNoNotes)
{
  for (const char *force : {"5",
                            "sin(10 * t)",
                            "if(t < 0.505, 0, 3)",
                            "if(t < 0.505, 0, if(t < 0.506, 3, 0))",
                            "500 * max(0, 1 - abs(t - 0.5137) / 0.001)"})
    EXPECT_TRUE(notes_of(force).empty()) << notes_of(force).front();
}

TEST(TimeFunctionNotes, SmoothPulsesShorterThanAStepAreNamed)
{
  const std::vector<std::string> notes =
    notes_of("7 * exp(-((t - 0.5137) / 1e-3)^2)");
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0],
               {"Loads/blast/Force y",
                "between t = 0.51 s and 0.52 s",
                "most at t = 0.513",
                "Reduce Time/Time step"});
}

TEST(TimeFunctionNotes, FastRecordsAreNamed)
{
  // 200 half waves of 5 ms, more than eight kinks in a row.
  const std::vector<std::string> notes = notes_of("abs(sin(200 * pi * t))");
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0], {"Loads/blast/Force y", "Reduce Time/Time step"});
}

TEST(TimeFunctionNotes, TablesThatEndBeforeTheRunAreNamed)
{
  const std::string name = testing::TempDir() + "short_table.csv";
  std::ofstream(name) << "0, 0\n0.25, 3\n0.75, 2\n";
  const std::vector<std::string> notes = notes_of("table: " + name);
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0],
               {"Loads/blast/Force y",
                "short_table.csv",
                "ends at t = 0.75 s",
                "its last value, 2, is held"});
  std::ofstream(name) << "0, 0\n0.25, 3\n1, 2\n";
  EXPECT_TRUE(notes_of("table: " + name).empty());
}

namespace
{
  /** The notes on a bar whose one end moves by a table with the text @p rows. */
  std::vector<std::string> notes_of_motion(const std::string &rows,
                                           const std::string &word)
  {
    const std::string name = testing::TempDir() + "motion.csv";
    std::ofstream(name) << rows;
    return time_function_notes(read_scene_from_text(
      SceneText()
        .frame("0 0; 1 0", "0 1")
        .circle("s", 0.01, {1e9, 1000})
        .add("Supports/foot",
             "Joints = 0 | Type = prescribed | Displacement x = 0 | "
             "Rotation z = 0 | Displacement y = " +
               word + name)
        .time(1, 0.01),
      "scene.prm"));
  }
} // namespace

TEST(TimeFunctionNotes, SmoothTablesThatOvershootAreNamed)
{
  const std::string rows = "0 0\n0.5 0.01\n0.6 0.01\n1 0.01\n";
  EXPECT_TRUE(notes_of_motion(rows, "table: ").empty());
  const std::vector<std::string> notes =
    notes_of_motion(rows, "smooth table: ");
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0],
               {"Supports/foot/Displacement y", "overshoots", "table: FILE"});
}

TEST(TimeFunctionNotes, MotionsWithManyVelocityJumpsAreNamed)
{
  std::string rows;
  for (unsigned int i = 0; i <= 10; ++i)
    rows += std::to_string(i / 10.) + " " + std::to_string(i * i * 1e-4) + "\n";
  EXPECT_TRUE(notes_of_motion(rows, "smooth table: ").empty());
  const std::vector<std::string> notes = notes_of_motion(rows, "table: ");
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0],
               {"Supports/foot/Displacement y",
                "corner at 9 rows",
                "smooth table: FILE"});
}
