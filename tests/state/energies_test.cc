#include <auxfem/state/energies.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  /**
   * A ledger with one entry per kind, and two for kinds with several causes.
   */
  std::shared_ptr<const EnergyLedger> ledger_of_all_kinds()
  {
    auto ledger = std::make_shared<EnergyLedger>();
    ledger->enter(kinetic_energy_entry());
    ledger->enter({EnergyKind::dissipated, "damper.dissipated", "lost there"});
    ledger->enter(strain_energy_entry());
    ledger->enter({EnergyKind::work, "push.load_work", "work of push"});
    ledger->enter(stored_energy_entry());
    ledger->enter({EnergyKind::dissipated, "brake.dissipated", "lost there"});
    ledger->enter({EnergyKind::work, "shaker.support_work", "work of shaker"});
    ledger->enter(numerical_energy_entry());
    return ledger;
  }

  /** Powers of two in order, so that sums identify their terms. */
  Energies powers_of_two()
  {
    Energies energies(ledger_of_all_kinds());
    for (unsigned int i = 0; i < 8; ++i)
      energies[i] = 1u << i;
    return energies;
  }
} // namespace

TEST(EnergyLedger, EntriesAreSharedByName)
{
  EnergyLedger       ledger;
  const unsigned int kinetic = ledger.enter(kinetic_energy_entry()),
                     first   = ledger.enter(
                       {EnergyKind::dissipated, "damper.dissipated", "first"}),
                     second = ledger.enter(
                       {EnergyKind::dissipated, "brake.dissipated", "second"});
  EXPECT_EQ(kinetic, 0u);
  EXPECT_EQ(first, 1u);
  EXPECT_EQ(second, 2u);
  EXPECT_EQ(ledger.enter(
              {EnergyKind::dissipated, "damper.dissipated", "again"}),
            first);
  EXPECT_EQ(ledger.enter(kinetic_energy_entry()), kinetic);
  ASSERT_EQ(ledger.entries().size(), 3u);
  EXPECT_EQ(ledger.entries()[first].name, "damper.dissipated");
  EXPECT_EQ(ledger.entries()[first].meaning, "first") << "who enters it, says";
}

TEST(EnergyLedger, KnowsItsKinds)
{
  EnergyLedger ledger;
  for (const EnergyKind kind : {EnergyKind::kinetic,
                                EnergyKind::strain,
                                EnergyKind::stored,
                                EnergyKind::dissipated,
                                EnergyKind::numerical,
                                EnergyKind::work})
    {
      EXPECT_FALSE(ledger.has(kind));
      EXPECT_TRUE(ledger_of_all_kinds()->has(kind));
    }
  ledger.enter(strain_energy_entry());
  EXPECT_TRUE(ledger.has(EnergyKind::strain));
  EXPECT_FALSE(ledger.has(EnergyKind::stored));
}

TEST(EnergyLedger, SharedEntriesHaveTheKindOfTheirName)
{
  EXPECT_EQ(kinetic_energy_entry().kind, EnergyKind::kinetic);
  EXPECT_EQ(strain_energy_entry().kind, EnergyKind::strain);
  EXPECT_EQ(stored_energy_entry().kind, EnergyKind::stored);
  EXPECT_EQ(numerical_energy_entry().kind, EnergyKind::numerical);
}

TEST(Energies, SumsAreByKind)
{
  const Energies energies = powers_of_two();
  EXPECT_EQ(energies.kinetic(), 1);
  EXPECT_EQ(energies.strain(), 4);
  EXPECT_EQ(energies.stored(), 16);
  EXPECT_EQ(energies.dissipated(), 2 + 32);
  EXPECT_EQ(energies.external(), 8 + 64);
  EXPECT_EQ(energies.numerical(), 128);
  EXPECT_EQ(energies.total(), 1 + 4 + 16);
}

TEST(Energies, BalanceIsEnergyBeyondWorkAndLosses)
{
  Energies energies = powers_of_two();
  EXPECT_EQ(energies.balance(0), (1 + 4 + 16) + (2 + 32) + 128 - (8 + 64));
  energies[7] = 0;
  EXPECT_EQ(energies.balance(-17), 0);
  // Kinetic energy lost to the damper.
  energies[0] -= 1;
  energies[1] += 1;
  EXPECT_EQ(energies.balance(-17), 0);
  // Work without an energy.
  energies[6] += 3;
  EXPECT_EQ(energies.balance(-17), -3);
}

TEST(Energies, StartAtZeroInEveryEntry)
{
  const Energies energies(ledger_of_all_kinds());
  EXPECT_EQ(energies.amounts(), std::vector<double>(8, 0.));
  EXPECT_EQ(energies.balance(0), 0);
  EXPECT_TRUE(Energies().amounts().empty());
  EXPECT_TRUE(Energies().ledger().entries().empty());
}
