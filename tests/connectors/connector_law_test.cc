#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  /** Suitable values of every registered law. Kinks lie away from the
   * extensions 0 and 0.008 to 0.02 m at which the laws are tried. */
  const std::vector<std::pair<std::string, LawParameters>> registered = {
    {"spring", {{"Spring stiffness", "1000"}}},
    {"dashpot", {{"Damping coefficient", "50"}}},
    {"kelvin-voigt",
     {{"Spring stiffness", "1000"}, {"Damping coefficient", "50"}}},
    {"maxwell", {{"Spring stiffness", "1000"}, {"Damping coefficient", "50"}}},
    {"standard-linear-solid",
     {{"Long-time stiffness", "400"},
      {"Spring stiffness", "1000"},
      {"Damping coefficient", "50"}}},
    {"generalized-maxwell",
     {{"Long-time stiffness", "400"},
      {"Stiffnesses", "1000, 200"},
      {"Relaxation times", "0.05, 0.4"}}},
    {"cubic",
     {{"Spring stiffness", "1000"},
      {"Cubic stiffness", "1e6"},
      {"Damping coefficient", "50"}}},
    {"bilinear",
     {{"Spring stiffness", "1000"},
      {"Second stiffness", "200"},
      {"Kink extension", "0.005"},
      {"Damping coefficient", "50"}}},
    {"gap",
     {{"Spring stiffness", "1000"}, {"Gap", "0.005"}, {"Stop damping", "2"}}},
    {"hook",
     {{"Spring stiffness", "1000"}, {"Slack", "0.005"}, {"Stop damping", "2"}}},
    {"tabulated",
     {{"Extensions", "-0.004, 0, 0.005, 0.007"},
      {"Forces", "-3, 0, 5, 6"},
      {"Damping coefficient", "50"}}},
    {"buckling-link", {{"Spring stiffness", "1000"}, {"Buckling load", "5"}}},
    {"power-law-dashpot", {{"Force at unit rate", "50"}, {"Exponent", "0.5"}}},
    {"friction-slider",
     {{"Spring stiffness", "1000"},
      {"Slip force", "4.5"},
      {"Hardening stiffness", "100"}}},
    {"expression", {{"Force", "1000*u + 2e5*u^3 + 20*v + 5*v^3"}}}};

  std::vector<std::unique_ptr<ConnectorLaw>> all_laws()
  {
    std::vector<std::unique_ptr<ConnectorLaw>> laws;
    for (const auto &[name, parameters] : registered)
      laws.push_back(make_law(name, parameters));
    return laws;
  }

  /** Laws whose internal variables obey differential equations. */
  std::vector<std::unique_ptr<ConnectorLaw>> laws_with_rates()
  {
    std::vector<std::unique_ptr<ConnectorLaw>> laws;
    for (auto &law : all_laws())
      if (!law->slips())
        laws.push_back(std::move(law));
    return laws;
  }

  /** Internal variables of a connector at the extension 0.008 m; the slider
   * then sticks. */
  std::vector<double> some_history(const ConnectorLaw &law)
  {
    return std::vector<double>(law.n_history(), law.slips() ? 0.004 : 3.);
  }

  /** Fourth-order difference. */
  template <class Function>
  double difference(const Function &f, const double h)
  {
    return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
  }

  ConnectorResponse response_at(const ConnectorLaw        &law,
                                const ConnectorMotion     &motion,
                                const std::vector<double> &history)
  {
    std::vector<double> trial(history.size());
    ConnectorResponse   response;
    law.evaluate(1, &motion, history.data(), trial.data(), &response);
    return response;
  }
} // namespace

TEST(ConnectorLaws, NamesOfTheRegistry)
{
  std::vector<std::string> names;
  for (const RegistryEntry<ConnectorLaw> &entry : connector_law_registry())
    {
      names.push_back(entry.name);
      EXPECT_FALSE(entry.description.empty()) << entry.name;
    }
  std::vector<std::string> tested;
  for (const auto &[name, parameters] : registered)
    tested.push_back(name);
  EXPECT_EQ(names, tested);
}

TEST(ConnectorLaws, ValuesMustBeGiven)
{
  for (const RegistryEntry<ConnectorLaw> &entry : connector_law_registry())
    EXPECT_THROW(make_law(entry.name, {}), InputError) << entry.name;
}

TEST(ConnectorLaws, NoForceAtRest)
{
  for (const auto &law : all_laws())
    for (const double dt : {0., 1e-3, infinity})
      {
        const std::vector<double> history(law->n_history(), 0.);
        const ConnectorMotion     motion = {0., 0., 0., dt};
        EXPECT_EQ(response_at(*law, motion, history).force, 0.);
        const ConnectorEnergy energy =
          law->energy(motion, history.data(), history.data());
        EXPECT_EQ(energy.stored, 0.);
        EXPECT_EQ(energy.dissipated, 0.);
      }
}

TEST(ConnectorLaws, RelaxedResponseIsTheLimitOfALongHold)
{
  for (const auto &law : laws_with_rates())
    {
      // Held at 0.01 m for 1e9 s, far beyond all relaxation times.
      const std::vector<double> history = some_history(*law);
      const ConnectorMotion     held_motion{0.01, 0., 0.01, 1e9};
      const ConnectorResponse   held = response_at(*law, held_motion, history);
      EXPECT_NEAR(law->relaxed(0.01).force, held.force, 1e-6 * held.force);
      EXPECT_EQ(law->relaxed(0.01).damping, 0.);
      if (law->is_linear())
        {
          EXPECT_EQ(law->relaxed(0.01).stiffness, law->relaxed(0).stiffness);
        }
      std::vector<double> trial(history);
      ConnectorResponse   equilibrium;
      law->evaluate_relaxed(1,
                            &held_motion,
                            history.data(),
                            trial.data(),
                            &equilibrium);
      EXPECT_EQ(equilibrium.force, law->relaxed(0.01).force);
    }
}

TEST(ConnectorLaws, StiffnessOfSlowMotionsIsThatOfTheRelaxedLaw)
{
  for (const auto &law : laws_with_rates())
    for (const double u : {0., 0.01})
      {
        const double stiffness = law->relaxed(u).stiffness;
        EXPECT_EQ(law->dynamic_stiffness(0., u), stiffness);
        const auto elastic =
          law->is_viscous() ? law->without_viscosity() : nullptr;
        if (elastic)
          {
            EXPECT_FALSE(elastic->is_viscous());
            EXPECT_EQ(elastic->relaxed(u).stiffness, stiffness);
            EXPECT_EQ(elastic->relaxed(u).force, law->relaxed(u).force);
          }
      }
}

// Differences have round-off, 1e-16 of the force over the increment, and those
// of roots their next term.
TEST(ConnectorLaws, TangentsAgainstDifferences)
{
  for (const auto &law : all_laws())
    for (const double dt : {1e-8, 1e-3, 0.05, 1e4})
      {
        const std::vector<double> history  = some_history(*law);
        const ConnectorMotion     motion   = {0.01, 0.3, 0.008, dt};
        const ConnectorResponse   response = response_at(*law, motion, history);
        EXPECT_NEAR(difference(
                      [&](const double h) {
                        ConnectorMotion moved = motion;
                        moved.extension += h;
                        return response_at(*law, moved, history).force;
                      },
                      1e-4),
                    response.stiffness,
                    1e-10 * (1 + response.stiffness));
        EXPECT_NEAR(difference(
                      [&](const double h) {
                        ConnectorMotion moved = motion;
                        moved.rate += h;
                        return response_at(*law, moved, history).force;
                      },
                      1e-3),
                    response.damping,
                    1e-10 * (1 + response.damping));
      }
}

// Both sides are some ten products of numbers up to 1e3 * 0.01^2, with dt =
// 1e-8 s up to 1e4 times that.
TEST(ConnectorLaws, WorkOfTheMeanForceIsStoredOrLost)
{
  for (const auto &law : all_laws())
    for (const double dt : {1e-8, 1e-3, 0.024, 0.026, 0.05, 1., 1e4})
      {
        const std::vector<double> history = some_history(*law);
        const ConnectorMotion     motion  = {0.01, 0.002 / dt, 0.008, dt};
        std::vector<double>       trial(history.size());
        const auto                mean = [&](const double h) {
          ConnectorMotion moved = motion;
          moved.extension += h;
          ConnectorResponse response;
          law->evaluate_mean(1,
                             &moved,
                             history.data(),
                             trial.data(),
                             &response);
          return response;
        };
        const ConnectorResponse response = mean(0);
        const ConnectorEnergy   after =
          law->energy(motion, history.data(), trial.data());
        const ConnectorEnergy before =
          law->energy({0.008, 0., 0.008, 0.}, history.data(), history.data());
        EXPECT_NEAR(response.force * 0.002,
                    after.stored - before.stored + after.dissipated,
                    2e-15 * (1 + 1e3 * after.dissipated))
          << dt;
        // The internal variables are those of evaluate().
        std::vector<double> other(history.size());
        ConnectorResponse   at_end;
        law->evaluate(1, &motion, history.data(), other.data(), &at_end);
        for (unsigned int j = 0; j < trial.size(); ++j)
          EXPECT_NEAR(trial[j], other[j], 1e-14 * (3 + std::abs(trial[j])));

        EXPECT_NEAR(difference([&](const double h) { return mean(h).force; },
                               2e-6),
                    response.stiffness,
                    1e-9 * (1 + response.stiffness));
      }
}

TEST(ConnectorLaws, ManyConnectorsAtOnceEqualOneAfterTheOther)
{
  // Different step lengths within one call are allowed too.
  const std::vector<ConnectorMotion> motions = {{0.01, 1., 0.009, 1e-3},
                                                {-0.02, 0., 0.03, 1e-3},
                                                {0.5, -2., 0.4, 0.7},
                                                {0., 0., 0.1, infinity}};
  for (const auto &law : all_laws())
    {
      const unsigned int  m = law->n_history();
      std::vector<double> committed(motions.size() * m), trial(committed);
      std::vector<ConnectorResponse> responses(motions.size());
      for (unsigned int i = 0; i < committed.size(); ++i)
        committed[i] = 1. + i;
      law->evaluate(motions.size(),
                    motions.data(),
                    committed.data(),
                    trial.data(),
                    responses.data());
      for (unsigned int i = 0; i < motions.size(); ++i)
        {
          std::vector<double> one(m);
          ConnectorResponse   response;
          law->evaluate(1,
                        &motions[i],
                        committed.data() + i * m,
                        one.data(),
                        &response);
          EXPECT_DOUBLE_EQ(responses[i].force, response.force);
          EXPECT_DOUBLE_EQ(responses[i].stiffness, response.stiffness);
          EXPECT_DOUBLE_EQ(responses[i].damping, response.damping);
          for (unsigned int j = 0; j < m; ++j)
            EXPECT_DOUBLE_EQ(trial[i * m + j], one[j]);
        }
    }
}

namespace
{
  /** Force and energies at the end of a motion that begins at rest. */
  struct Outcome
  {
    double force, stored, dissipated;
  };

  double extension_at(const double t)
  {
    return 0.01 * std::sin(40 * t) * t;
  }

  double rate_at(const double t)
  {
    return 0.01 * (40 * t * std::cos(40 * t) + std::sin(40 * t));
  }

  constexpr double end = 0.1;

  Outcome by_steps(std::unique_ptr<ConnectorLaw> law, const unsigned int n)
  {
    LawOnTrial        connector(std::move(law));
    const double      dt = end / n;
    ConnectorResponse last{};
    for (unsigned int i = 1; i <= n; ++i)
      last = connector.step(extension_at(dt * i), rate_at(dt * i), dt);
    return {last.force, connector.stored, connector.dissipated};
  }

  /** The continuous form by the classical Runge-Kutta method. */
  Outcome continuous(const ConnectorLaw &law, const unsigned int n)
  {
    const unsigned int  m = law.n_history();
    std::vector<double> y(m), stage(m), sum(m), k(m);
    const double        dt   = end / n;
    double              lost = 0;
    const auto          ask  = [&](const double t, const double *internal) {
      return law.continuous(extension_at(t), rate_at(t), internal, k.data());
    };
    for (unsigned int i = 0; i < n; ++i)
      {
        const double weights[]  = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
        const double advances[] = {0, 0.5, 0.5, 1};
        sum                     = y;
        for (unsigned int s = 0; s < 4; ++s)
          {
            for (unsigned int j = 0; j < m; ++j)
              stage[j] = y[j] + advances[s] * dt * k[j];
            lost += weights[s] * dt *
              ask(dt * (i + advances[s]), stage.data()).lost_power;
            for (unsigned int j = 0; j < m; ++j)
              sum[j] += weights[s] * dt * k[j];
          }
        y = sum;
      }
    const ContinuousResponse last = ask(end, y.data());
    return {last.force, last.stored, lost};
  }
} // namespace

// Maxwell elements assume a linear rate that ends with the true one: third
// order. The dissipation of Kelvin-Voigt is of second order. The Runge-Kutta
// reference has an error below 1e-10.
TEST(ConnectorLaws, SmallStepsTendToTheContinuousForm)
{
  const auto laws = laws_with_rates();
  for (unsigned int i = 0; i < laws.size(); ++i)
    {
      const Outcome exact = continuous(*laws[i], 4000);
      double        error[2];
      for (const unsigned int level : {0, 1})
        {
          const Outcome found =
            by_steps(std::move(laws_with_rates()[i]), 500u << level);
          EXPECT_NEAR(found.force, exact.force, 1e-3);
          EXPECT_NEAR(found.stored, exact.stored, 1e-5);
          EXPECT_NEAR(found.dissipated, exact.dissipated, 1e-5);
          error[level] = std::abs(found.force - exact.force) +
            std::abs(found.dissipated - exact.dissipated);
        }
      if (laws[i]->is_linear() && error[0] > 1e-10)
        {
          const unsigned int order = laws[i]->n_history() > 0 ? 3 : 2;
          EXPECT_NEAR(std::log2(error[0] / error[1]), order, 0.05) << i;
        }
    }
}

// At a stage the internal variables follow Euler's backward rule.
TEST(ConnectorLaws, StagesFollowTheContinuousForm)
{
  const double dt = 3e-3;
  for (const auto &law : laws_with_rates())
    {
      const unsigned int        m = law->n_history();
      const std::vector<double> base(m, 3.);
      std::vector<double>       stage(m), rates(m);
      const auto at = [&](const double extension, const double rate) {
        const ConnectorMotion motion = {extension, rate, 0., dt};
        ConnectorResponse     response;
        law->evaluate_stage(1, &motion, base.data(), stage.data(), &response);
        return response;
      };
      const ConnectorResponse  response = at(0.01, 0.3);
      const ContinuousResponse exact =
        law->continuous(0.01, 0.3, stage.data(), rates.data());
      EXPECT_NEAR(response.force, exact.force, 1e-12);
      for (unsigned int i = 0; i < m; ++i)
        EXPECT_NEAR(stage[i], base[i] + dt * rates[i], 1e-12);
      if (!law->is_linear())
        continue;
      EXPECT_NEAR(at(0.02, 0.3).force - response.force,
                  0.01 * response.stiffness,
                  1e-11);
      EXPECT_NEAR(at(0.01, 0.4).force - response.force,
                  0.1 * response.damping,
                  1e-11);
    }
}

TEST(ConnectorLaws, ContinuousPowerBalance)
{
  const double h = 1e-6, u = 0.01, rate = 0.3;
  for (const auto &law : laws_with_rates())
    {
      const unsigned int       m = law->n_history();
      std::vector<double>      y(m, 3.), k(m), ignored(m), before(m), after(m);
      const ContinuousResponse now =
        law->continuous(u, rate, y.data(), k.data());
      for (unsigned int j = 0; j < m; ++j)
        {
          before[j] = y[j] - h * k[j];
          after[j]  = y[j] + h * k[j];
        }
      const double stored_rate =
        (law->continuous(u + h * rate, rate, after.data(), ignored.data())
           .stored -
         law->continuous(u - h * rate, rate, before.data(), ignored.data())
           .stored) /
        (2 * h);
      // The difference has hardly more than round-off.
      EXPECT_NEAR(now.force * rate, stored_rate + now.lost_power, 1e-8);
      EXPECT_GE(now.lost_power, 0);
    }
}

TEST(ConnectorLaws, ContinuousFormWithoutResistanceOfTheDashpot)
{
  double                   force = 0, force_rate = 1;
  const auto               law = make_law("standard-linear-solid",
                            {{"Long-time stiffness", "400"},
                                           {"Spring stiffness", "1000"},
                                           {"Damping coefficient", "0"}});
  const ContinuousResponse now = law->continuous(0.1, 2., &force, &force_rate);
  EXPECT_DOUBLE_EQ(now.force, 40);
  EXPECT_DOUBLE_EQ(now.stored, 2);
  EXPECT_EQ(now.lost_power, 0);
  EXPECT_EQ(force_rate, 0);
}

TEST(ConnectorLaws, DissipationIsNeverNegative)
{
  for (const auto &law : all_laws())
    for (const double dt : {1e-9, 1e-4, 0.03, 0.1, 50.})
      for (const double force : {-5., -1., 0., 1., 5.})
        {
          const std::vector<double> history(law->n_history(), force);
          const ConnectorMotion     motion = {0.01, 0., 0.008, dt};
          EXPECT_GE(
            law->energy(motion, history.data(), history.data()).dissipated,
            0.);
        }
}

TEST(ConnectorLaws, NoConnectorsAtAll)
{
  for (const auto &law : all_laws())
    EXPECT_NO_THROW(law->evaluate(0, nullptr, nullptr, nullptr, nullptr));
}
