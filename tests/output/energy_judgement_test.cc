#include <auxfem/output/verdict.h>

#include <gtest/gtest.h>

#include <limits>

using namespace auxfem;

namespace
{
  /** Judgement of prescribed energies at intervals of one second. */
  class GivenEnergies
  {
  public:
    explicit GivenEnergies(
      const EnergyJudgement::Kind kind = EnergyJudgement::Kind::motion)
      : judgement(kind)
    {
      kinetic   = ledger.enter(kinetic_energy_entry());
      numerical = ledger.enter(numerical_energy_entry());
      work      = ledger.enter({EnergyKind::work, "work", ""});
    }

    void begin(const double mechanical)
    {
      judgement.start(energies(mechanical, 0, 0));
    }

    void step(const double mechanical,
              const double numerical_energy,
              const double external_work)
    {
      judgement.add(energies(mechanical, numerical_energy, external_work),
                    ++time);
    }

    std::vector<Finding> findings() const
    {
      return judgement.findings();
    }

  private:
    Energies energies(const double mechanical,
                      const double numerical_energy,
                      const double external_work) const
    {
      Energies result(std::make_shared<const EnergyLedger>(ledger));
      result[kinetic]   = mechanical;
      result[numerical] = numerical_energy;
      result[work]      = external_work;
      return result;
    }

    EnergyJudgement judgement;
    EnergyLedger    ledger;
    unsigned int    kinetic, numerical, work;
    double          time = 0;
  };
} // namespace

TEST(EnergyJudgement, ChecksBothSignsAgainstEnergyInput)
{
  for (const double sign : {-1., 1.})
    {
      GivenEnergies energies;
      energies.begin(100);
      energies.step(100 + sign * 4, 0, 0);
      EXPECT_TRUE(energies.findings().empty())
        << verdict_text(energies.findings());
      energies.step(100 + sign * 24, 0, 0);
      EXPECT_EQ(verdict_of(energies.findings()), Verdict::doubtful);
      energies.step(100 + sign * 26, 0, 0);
      energies.step(100, 0, 0);
      ASSERT_EQ(energies.findings().size(), 1u);
      EXPECT_EQ(energies.findings()[0].verdict, Verdict::not_to_be_used);
      EXPECT_EQ(energies.findings()[0].time, 3.);
      EXPECT_NE(energies.findings()[0].text.find("26 %"), std::string::npos);
    }
}

TEST(EnergyJudgement, SpuriousEnergyIsNoInput)
{
  GivenEnergies energies;
  energies.begin(63);
  energies.step(215, 0, 0);
  EXPECT_EQ(verdict_of(energies.findings()), Verdict::not_to_be_used);

  GivenEnergies from_rest;
  from_rest.begin(0);
  from_rest.step(1e-3, 0, 0);
  EXPECT_EQ(verdict_of(from_rest.findings()), Verdict::not_to_be_used);
}

TEST(EnergyJudgement, WorkCountsAsInput)
{
  GivenEnergies energies;
  energies.begin(0);
  energies.step(1000, 0, 1000);
  energies.step(30, 0, 0);
  EXPECT_TRUE(energies.findings().empty()) << verdict_text(energies.findings());
}

TEST(EnergyJudgement, ReportsNumericalGainAndLoss)
{
  for (const double numerical_energy : {-10., 30.})
    {
      GivenEnergies energies;
      energies.begin(100);
      energies.step(100 - numerical_energy, numerical_energy, 0);
      ASSERT_EQ(energies.findings().size(), 1u);
      EXPECT_EQ(energies.findings()[0].verdict, Verdict::doubtful);
    }
}

TEST(EnergyJudgement, NaNIsNotToBeUsed)
{
  GivenEnergies energies;
  energies.begin(1);
  energies.step(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  energies.step(1, 0, 0);
  EXPECT_EQ(verdict_of(energies.findings()), Verdict::not_to_be_used);
}

TEST(EnergyJudgement, AdvisesEnergyMomentumSchemeForMotion)
{
  using Kind = EnergyJudgement::Kind;
  for (const Kind kind : {Kind::motion,
                          Kind::static_steps,
                          Kind::static_path,
                          Kind::reduced_cell})
    {
      GivenEnergies run(kind);
      run.begin(1);
      run.step(1.5, 0, 0);
      ASSERT_EQ(run.findings().size(), 1u);
      const std::string text = run.findings().front().text;
      EXPECT_EQ(text.find("energy-momentum") != std::string::npos,
                kind == Kind::motion)
        << text;
      EXPECT_EQ(text.find("Path/Resolution") != std::string::npos,
                kind == Kind::static_path)
        << text;
    }
}
