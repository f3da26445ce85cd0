#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "section_on_trial.h"

using namespace auxfem;

namespace
{
  using Complex = std::complex<double>;

  std::unique_ptr<SectionLaw>
  make_law(const std::map<std::string, std::string> &entries)
  {
    return auxfem::make_law(viscoelastic_entry(), entries);
  }

  const std::map<std::string, std::string> three_terms = {
    {"Relaxing parts", "0.3, 0.2, 0.1"},
    {"Relaxation times", "0.01, 0.2, 3"},
    {"Poisson's ratio", "0.35"}};

  std::map<std::string, std::string> with_elastic_volume()
  {
    auto entries             = three_terms;
    entries["Volume change"] = "elastic";
    return entries;
  }

  /** A Gauss point in the plane, with unlike stiffnesses. */
  struct Point : public SectionOnTrial<3>
  {
    explicit Point(const SectionLaw &law)
      : SectionOnTrial(
          law,
          {{StrainType::normal, StrainType::shear, StrainType::normal}},
          {{2., 3., 5.}})
    {}
  };

  double first(const Lanes &lanes)
  {
    return lane_value(lanes, 0);
  }

  constexpr SectionStep::Kind at_end = SectionStep::Kind::end,
                              mean   = SectionStep::Kind::mean;
} // namespace

TEST(Viscoelastic, RelaxesExactlyUnderConstantStrain)
{
  const auto  law = make_law(three_terms);
  Point       point(*law);
  const Lanes strains[] = {0.1, -0.2, 0.3};
  EXPECT_DOUBLE_EQ(first(point.step({at_end, 0}, strains).forces[0]), 0.2);
  double t = 0;
  for (const double dt : {1e-3, 0.02, 0.5, 7.})
    {
      t += dt;
      const double modulus = 0.4 + 0.3 * std::exp(-t / 0.01) +
        0.2 * std::exp(-t / 0.2) + 0.1 * std::exp(-t / 3);
      const SectionResponse response = point.step({at_end, dt}, strains);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(first(response.forces[k]),
                    modulus * first(point.stiffness[k] * strains[k]),
                    1e-15)
          << t;
      EXPECT_NEAR(first(point.instant(strains).forces[1]),
                  first(response.forces[1]),
                  1e-15);
    }
}

TEST(Viscoelastic, TangentIsTheDerivativeOfTheForce)
{
  const auto law = make_law(with_elastic_volume());
  for (const SectionStep::Kind kind :
       {at_end, mean, SectionStep::Kind::stage, SectionStep::Kind::relaxed})
    for (const double dt : {1e-4, 0.1, 50.})
      {
        Point       point(*law);
        const Lanes before[] = {0.1, -0.2, 0.3};
        point.step({at_end, 0.05}, before);
        Lanes                 now[]    = {0.4, 0.2, -0.1};
        const SectionResponse response = point.evaluate({kind, dt}, now);
        for (int k = 0; k < 3; ++k)
          {
            now[k] += 1;
            // Forces are linear in strains; tangents of means are doubled.
            EXPECT_NEAR(first(point.evaluate({kind, dt}, now).forces[k] -
                              response.forces[k]) *
                          (kind == mean ? 2 : 1),
                        first(response.tangent[k]),
                        1e-13);
            now[k] -= 1;
          }
      }
}

TEST(Viscoelastic, MeanForcesDoTheWorkOfStoredAndLostEnergy)
{
  const auto                             law = make_law(with_elastic_volume());
  Point                                  point(*law);
  std::mt19937                           generator;
  std::uniform_real_distribution<double> noise(-1, 1);
  Lanes                                  strains[] = {0., 0., 0.};
  double                                 stored    = 0;
  for (int i = 0; i < 300; ++i)
    {
      const double dt = std::pow(10., 3 * noise(generator));
      Lanes        now[3];
      for (Lanes &strain : now)
        strain = noise(generator);
      const SectionResponse response = point.step({mean, dt}, now);
      Lanes                 work     = 0;
      for (int k = 0; k < 3; ++k)
        work += response.forces[k] * (now[k] - strains[k]);
      EXPECT_NEAR(first(work),
                  first(response.stored) - stored + first(point.lost),
                  1e-13);
      EXPECT_GE(first(point.lost), 0);
      stored = first(response.stored);
      EXPECT_NEAR(first(point.instant(now).stored), stored, 1e-14);
      std::copy_n(now, 3, strains);
    }
}

TEST(Viscoelastic, LosesEnergyInEveryStep)
{
  const auto                             law = make_law(three_terms);
  Point                                  point(*law);
  std::mt19937                           generator;
  std::uniform_real_distribution<double> noise(-1, 1);
  for (int i = 0; i < 300; ++i)
    {
      Lanes strains[3];
      for (Lanes &strain : strains)
        strain = noise(generator);
      point.step({at_end, std::pow(10., 3 * noise(generator))}, strains);
      EXPECT_GE(first(point.lost), 0);
      EXPECT_GE(first(point.instant(strains).lost_power), 0);
    }
}

// E = 9 K G / (3 K + G) with the relaxing G and the constant K.
TEST(Viscoelastic, YoungsModulusFollowsFromAnElasticBulkModulus)
{
  const double nu  = 0.35;
  const auto   law = make_law(with_elastic_volume());
  const double g = 1 / (2 * (1 + nu)), k = 1 / (3 * (1 - 2 * nu));
  const auto   modulus = [&](const StrainType type, const Complex s) {
    Complex sum = law->long_time_ratio(type);
    for (const auto &[time, part] : law->relaxing_ratios(type))
      sum += part * s * time / (1. + s * time);
    return sum;
  };
  EXPECT_NEAR(law->long_time_ratio(StrainType::shear), 0.4, 1e-15);
  for (const Complex s :
       {Complex(0, 0), Complex(0, 1e-2), Complex(0.3, 5), Complex(0, 1e4)})
    {
      const Complex shear = g * modulus(StrainType::shear, s),
                    exact = 9. * k * shear / (3 * k + shear);
      EXPECT_NEAR(std::abs(modulus(StrainType::normal, s) - exact), 0, 1e-13)
        << s;
    }
}

TEST(Viscoelastic, OneTermHasTheClosedFormOfAnElasticBulkModulus)
{
  const double nu = 0.3, g = 1 / (2 * (1 + nu)), k = 1 / (3 * (1 - 2 * nu));
  const auto   law   = make_law({{"Relaxing parts", "0.6"},
                                 {"Relaxation times", "2"},
                                 {"Volume change", "elastic"}});
  const auto   terms = law->relaxing_ratios(StrainType::normal);
  ASSERT_EQ(terms.size(), 1u);
  EXPECT_NEAR(terms.begin()->first, 2 * (3 * k + g) / (3 * k + 0.4 * g), 1e-13);
}

TEST(Viscoelastic, RefusesWhatIsNoMaterial)
{
  const auto message = [](std::map<std::string, std::string> entries) {
    try
      {
        make_law(entries);
      }
    catch (const InputError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  EXPECT_EQ(message(
              {{"Relaxing parts", "0.5, 0.5"}, {"Relaxation times", "1, 2"}}),
            "");
  EXPECT_NE(message(
              {{"Relaxing parts", "0.5, 0.6"}, {"Relaxation times", "1, 2"}})
              .find("add up to 1.1"),
            std::string::npos);
  EXPECT_NE(message({{"Relaxing parts", "0.5"}, {"Relaxation times", "1, 2"}})
              .find("Each part needs one time"),
            std::string::npos);
}
