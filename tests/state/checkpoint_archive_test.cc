#include <auxfem/parameters/errors.h>
#include <auxfem/state/checkpoint_archive.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  /** One value of each kind. */
  struct SavedValues
  {
    double                number = 0.25;
    unsigned long         count  = 7;
    bool                  flag   = true;
    std::optional<double> known  = 3., unknown;
    LargestInTime         largest{0.5, 2};
    double                first_sum = 1, second_sum = 2;
    std::vector<double>   list{4, 5, 6}, nothing;
    std::vector<double>   by_item{10, 11, 20, 21};
    std::string           text = "strut 3";

    void serialize(CheckpointArchive &archive)
    {
      archive.values("values", number, count, flag, known, unknown);
      archive.largest("largest", largest);
      archive.sums("sums", first_sum, second_sum);
      archive.list("list", list);
      archive.list("nothing", nothing);
      archive.items("items", {3, 5}, 2, by_item);
      archive.text("text", text);
    }
  };
} // namespace

TEST(CheckpointArchive, RestoresSavedValues)
{
  const UnknownLayout layout(MPI_COMM_SELF, 1, {});
  SavedValues         saved;
  CheckpointData      records;
  CheckpointArchive   saving = CheckpointArchive::saving(records, layout);
  saved.serialize(saving);

  SavedValues restored;
  restored.number = restored.count = 0;
  restored.flag                    = false;
  restored.known.reset();
  restored.unknown   = 1.;
  restored.largest   = {};
  restored.first_sum = restored.second_sum = 0;
  restored.list                            = {};
  restored.nothing                         = {1.};
  restored.by_item                         = {0, 0, 0, 0};
  restored.text                            = "";
  CheckpointArchive restoring = CheckpointArchive::restoring(records, layout);
  restored.serialize(restoring);
  EXPECT_EQ(restored.number, 0.25);
  EXPECT_EQ(restored.count, 7u);
  EXPECT_TRUE(restored.flag);
  EXPECT_EQ(restored.known, std::optional(3.));
  EXPECT_FALSE(restored.unknown);
  EXPECT_EQ(restored.largest.value, 0.5);
  EXPECT_EQ(restored.largest.time, 2);
  EXPECT_EQ(restored.first_sum, 1);
  EXPECT_EQ(restored.second_sum, 2);
  EXPECT_EQ(restored.list, saved.list);
  EXPECT_TRUE(restored.nothing.empty());
  EXPECT_EQ(restored.by_item, saved.by_item);
  EXPECT_EQ(restored.text, "strut 3");
}

TEST(CheckpointArchive, RefusesMissingRecords)
{
  const UnknownLayout  layout(MPI_COMM_SELF, 1, {});
  const CheckpointData none;
  CheckpointArchive    archive = CheckpointArchive::restoring(none, layout);
  double               value   = 0;
  EXPECT_FALSE(archive.has("value"));
  EXPECT_THROW(archive.values("value", value), InputError);
}

TEST(CheckpointArchive, MovesSumsToTheFirstRank)
{
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const UnknownLayout layout(MPI_COMM_WORLD, 1, {});
  const double        whole = n_ranks * (n_ranks + 1) / 2.,
               mine         = layout.rank() == 0 ? whole : 0.;
  double         part       = layout.rank() + 1.;
  LargestInTime  largest{part, part};
  CheckpointData records;

  CheckpointArchive saving = CheckpointArchive::saving(records, layout);
  saving.sums("sum", part);
  saving.largest("largest", largest);
  EXPECT_EQ(part, mine);
  EXPECT_EQ(largest.value, n_ranks);

  double            restored  = 100;
  CheckpointArchive restoring = CheckpointArchive::restoring(records, layout);
  restoring.sums("sum", restored);
  EXPECT_EQ(restored, mine);
}
