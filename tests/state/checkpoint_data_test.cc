#include <auxfem/state/checkpoint_archive.h>

#include <gtest/gtest.h>

#include <support/messages.h>

using namespace auxfem;

TEST(CheckpointData, LayoutAppendsRecords)
{
  RecordLayout layout;
  EXPECT_EQ(layout.n_values(), 0u);
  EXPECT_EQ(layout.keep("pairs", {4, 7, 9}, 2), 0u);
  EXPECT_EQ(layout.keep("nothing", {}, 3), 6u);
  EXPECT_EQ(layout.keep("one", {2}, 1), 6u);
  EXPECT_EQ(layout.n_values(), 7u);
  ASSERT_EQ(layout.list().size(), 3u);
  EXPECT_EQ(layout.list()[0].items, (std::vector<unsigned int>{4, 7, 9}));
  EXPECT_EQ(layout.list()[2].first, 6u);
}

TEST(CheckpointData, ReturnsValuesByNameAndItem)
{
  CheckpointData records;
  records.keep("time", {0.25});
  records.keep("pairs", {4, 7, 9}, 2, {40, 41, 70, 71, 90, 91});
  records.keep("none", {}, 2, {});
  EXPECT_EQ(records.values("time", 1), (std::vector<double>{0.25}));
  EXPECT_EQ(records.items("pairs"), (std::vector<unsigned int>{4, 7, 9}));
  // Another rank may request another order.
  EXPECT_EQ(records.values("pairs", {9, 4}, 2),
            (std::vector<double>{90, 91, 40, 41}));
  EXPECT_TRUE(records.items("none").empty());
  EXPECT_TRUE(records.values("none", {}, 2).empty());
}

TEST(CheckpointData, NamesMissingRecords)
{
  CheckpointData records;
  records.keep("pairs", {4, 7}, 2, {40, 41, 70, 71});
  expect_parts(input_error_of([&] { records.values("time", 1); }),
               {"\"time\"", "another scene"});
  expect_parts(input_error_of([&] { records.items("time"); }), {"\"time\""});
  expect_parts(input_error_of([&] {
                 records.values("pairs", {4, 5}, 2);
               }),
               {"\"pairs\" of item 5"});
  expect_parts(input_error_of([&] { records.values("pairs", {4}, 3); }),
               {"\"pairs\" with 3 values"});
}

TEST(CheckpointData, AddsRecordsOfOtherRanks)
{
  CheckpointData first, second;
  first.keep("time", {0.25});
  first.keep("pairs", {4, 7}, 2, {40, 41, 70, 71});
  second.keep("time", {0.25});
  second.keep("pairs", {7, 9}, 2, {70, 71, 90, 91});
  second.keep("singles", {1}, 1, {10});
  first.add(second);
  EXPECT_EQ(first.values("time", 1), (std::vector<double>{0.25}));
  EXPECT_EQ(first.items("pairs"), (std::vector<unsigned int>{4, 7, 9}));
  EXPECT_EQ(first.values("pairs", {9, 4}, 2),
            (std::vector<double>{90, 91, 40, 41}));
  EXPECT_EQ(first.values("singles", {1}, 1), (std::vector<double>{10}));
  EXPECT_TRUE(first.has("singles"));
  EXPECT_FALSE(second.has("doubles"));
}

TEST(CheckpointData, StoresTexts)
{
  CheckpointData records;
  records.keep_text("location", "joint 3 at (0, 1)");
  records.keep_text("nowhere", "");
  EXPECT_EQ(records.text("location"), "joint 3 at (0, 1)");
  EXPECT_EQ(records.text("nowhere"), "");
}
