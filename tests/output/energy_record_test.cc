#include <auxfem/output/csv_table.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Words = std::vector<std::string>;

  /** Entries for kinetic, strain, stored energy, a loss and a work. */
  std::shared_ptr<const EnergyLedger> full_ledger()
  {
    auto ledger = std::make_shared<EnergyLedger>();
    ledger->enter(kinetic_energy_entry());
    ledger->enter(strain_energy_entry());
    ledger->enter(stored_energy_entry());
    ledger->enter({EnergyKind::dissipated, "damper.dissipated", "lost there"});
    ledger->enter({EnergyKind::work, "push.load_work", "work of push"});
    return ledger;
  }

  Energies amounts(const std::shared_ptr<const EnergyLedger> &ledger,
                   const std::vector<double>                 &values)
  {
    Energies energies(ledger);
    energies.amounts() = values;
    return energies;
  }

  Words names_of(const std::vector<Column> &columns)
  {
    Words names;
    for (const Column &column : columns)
      names.push_back(column.name);
    return names;
  }

  /** The energy columns of a scene. */
  Words columns_of(const std::string              &text,
                   const std::vector<std::string> &overrides = {})
  {
    const EquationsOnRanks scene_equations(text, overrides, MPI_COMM_SELF);
    return names_of(
      energy_columns(scene_equations.equations.layout().energies));
  }
} // namespace

TEST(EnergyRecord, BalanceStartsAtZeroAndKeepsItsExtremes)
{
  EnergyRecord record;
  EXPECT_EQ(record.relative(1), 0);

  // Numbers with few binary digits, so that sums are exact.
  const auto ledger = full_ledger();
  record.add(amounts(ledger, {2, 1, 0.5, 0, 0.25}));
  EXPECT_EQ(record.balance, 0);
  record.add(amounts(ledger, {1, 1, 0.5, 1, 1}));
  EXPECT_EQ(record.balance, -0.75);
  record.add(amounts(ledger, {0, 0, 0, 8, 4.75}));
  EXPECT_EQ(record.balance, 0);
  EXPECT_EQ(record.largest_balance, 0.75);
  EXPECT_EQ(record.largest_energy, 8);
  EXPECT_EQ(record.relative(2), 0.25);
  EXPECT_EQ(record.latest.dissipated(), 8);
}

TEST(EnergyRecord, NaNBalanceStaysVisible)
{
  EnergyRecord record;
  const auto   ledger = full_ledger();
  record.add(amounts(ledger, {1, 0, 0, 0, 0}));
  record.add(
    amounts(ledger, {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0}));
  EXPECT_TRUE(std::isnan(record.balance));
  EXPECT_TRUE(std::isnan(record.relative(record.balance)));
}

TEST(EnergyRecord, ColumnsAreSumsOfKindsThenCausesThenTheBalance)
{
  EnergyLedger ledger;
  ledger.enter({EnergyKind::work, "push.load_work", "work of push"});
  ledger.enter({EnergyKind::dissipated, "damper.dissipated", "lost there"});
  ledger.enter(kinetic_energy_entry());
  ledger.enter({EnergyKind::dissipated, "brake.dissipated", "lost there"});
  const std::vector<Column> columns = energy_columns(ledger);
  EXPECT_EQ(names_of(columns),
            (Words{"kinetic",
                   "dissipated",
                   "external",
                   "push.load_work",
                   "damper.dissipated",
                   "brake.dissipated",
                   "balance"}));
  for (const Column &column : columns)
    {
      EXPECT_EQ(column.unit, "J") << column.name;
      EXPECT_FALSE(column.meaning.empty()) << column.name;
    }
  EXPECT_EQ(columns[4].meaning, "lost there");
  // The meaning of the balance lists the existing kinds.
  EXPECT_EQ(columns.back().meaning.find("kinetic + dissipated - external "), 0u)
    << columns.back().meaning;

  EXPECT_EQ(names_of(energy_columns(EnergyLedger())), (Words{"balance"}));
}

TEST(EnergyRecord, ValuesStandInTheirColumns)
{
  auto ledger = std::make_shared<EnergyLedger>();
  ledger->enter({EnergyKind::work, "push.load_work", "work of push"});
  ledger->enter({EnergyKind::dissipated, "damper.dissipated", "lost there"});
  ledger->enter(kinetic_energy_entry());
  ledger->enter({EnergyKind::dissipated, "brake.dissipated", "lost there"});
  EnergyRecord record;
  record.add(Energies(ledger));
  record.add(amounts(ledger, {32, 4, 8, 16}));
  // 8 + 20 - 32.
  EXPECT_EQ(energy_values(record),
            (std::vector<double>{8, 20, 32, 32, 4, 16, -4}));
}

TEST(EnergyRecord, ColumnsFollowPhysicsOfScene)
{
  const std::string dynamics = "Scheme = newmark", statics = "Scheme = static";
  // A fixed clamp does no work; the load has its own cause.
  EXPECT_EQ(columns_of(cantilever("1", dynamics)),
            (Words{"kinetic",
                   "strain",
                   "external",
                   "numerical",
                   "tip.load_work",
                   "balance"}));
  EXPECT_EQ(columns_of(cantilever("1", statics)),
            (Words{"strain", "external", "tip.load_work", "balance"}));
  EXPECT_EQ(columns_of(cantilever("1", dynamics),
                       {"Sections/band/Stiffness-proportional damping=0.1"}),
            (Words{"kinetic",
                   "strain",
                   "dissipated",
                   "external",
                   "numerical",
                   "strut_damping_dissipated",
                   "tip.load_work",
                   "balance"}));
}

TEST(EnergyRecord, EveryCauseInAFullSceneHasItsColumn)
{
  Words columns = columns_of(star_with_everything(1, 1));
  std::sort(columns.begin(), columns.end());
  for (const char *name : {"kinetic",
                           "strain",
                           "stored",
                           "dissipated",
                           "external",
                           "numerical",
                           "damper.dissipated",
                           "relaxing.dissipated",
                           "fixed direction.dissipated",
                           "anchors.dissipated",
                           "strut_damping_dissipated",
                           "strut_relaxation_dissipated",
                           "mass_damping_dissipated",
                           "push.load_work",
                           "wind.load_work",
                           "gravity_work",
                           "shaker.support_work",
                           "balance"})
    EXPECT_EQ(std::count(columns.begin(), columns.end(), name), 1) << name;
  // The scene is at rest.
  EXPECT_EQ(std::count(columns.begin(),
                       columns.end(),
                       "foundation.support_work"),
            0);
  EXPECT_EQ(columns.size(), 18u);
}
