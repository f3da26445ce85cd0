#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "section_on_trial.h"

using namespace auxfem;

namespace
{
  using Entries = std::map<std::string, std::string>;

  std::unique_ptr<SectionLaw> make_law(const Entries &entries)
  {
    return auxfem::make_law(elastic_plastic_entry(), entries);
  }

  /** A section in the plane with EA = 2 and EI = 0.005: a radius of gyration of
   * 0.05. */
  struct PlanePoint : public SectionOnTrial<3>
  {
    explicit PlanePoint(const SectionLaw &law)
      : SectionOnTrial(
          law,
          {{StrainType::normal, StrainType::shear, StrainType::normal}},
          {{2., 0.7, 0.005}})
    {}
  };

  /** A section in space with radii of gyration of 0.05 and 0.03. */
  struct SpacePoint : public SectionOnTrial<6>
  {
    explicit SpacePoint(const SectionLaw &law)
      : SectionOnTrial(law,
                       {{StrainType::normal,
                         StrainType::shear,
                         StrainType::shear,
                         StrainType::shear,
                         StrainType::normal,
                         StrainType::normal}},
                       {{2., 0.7, 0.6, 0.003, 0.005, 0.0018}})
    {}
  };

  double first(const Lanes &lanes)
  {
    return lane_value(lanes, 0);
  }

  constexpr SectionStep::Kind at_end = SectionStep::Kind::end,
                              mean   = SectionStep::Kind::mean;

  const Entries unit_material = {{"Young's modulus", "1"},
                                 {"Yield stress", "1e-3"}};

  Entries with(Entries entries, const Entries &more)
  {
    for (const auto &[name, value] : more)
      entries[name] = value;
    return entries;
  }

  const Entries hardening = with(unit_material,
                                 {{"Plastic strains", "0.001, 0.01"},
                                  {"Flow stresses", "0.0013, 0.002"},
                                  {"Kinematic hardening modulus", "0.03"}});

  /** Random walk of strains; @p size of its steps relative to the yield
   * strain. */
  template <unsigned int n>
  struct Walk
  {
    void next(const double size)
    {
      for (unsigned int k = 0; k < n; ++k)
        strains[k] += 1e-3 * size * noise(generator) *
          (k == 0 || k == 1 || (n == 6 && k == 2) ? 1 : 20);
    }

    std::mt19937                           generator;
    std::uniform_real_distribution<double> noise{-1, 1};
    Lanes                                  strains[n] = {};
  };
} // namespace

// Interaction of force and moment of a rectangle, fully plastic: m = 1 - n^2.
TEST(ElasticPlastic, PlasticRectanglesHaveTheirInteraction)
{
  const auto   law = make_law(unit_material);
  const double h = 0.05 * std::sqrt(12.), force = 2e-3, moment = force * h / 4;
  for (const double ratio : {0., 0.1, 0.3, 0.5, 0.8})
    {
      PlanePoint   point(*law);
      const Lanes  far[]  = {ratio * h / 2, 0., 1.};
      const auto   r      = point.step({at_end, 0}, far);
      const double normal = first(r.forces[0]) / force;
      EXPECT_NEAR(first(r.forces[2]) / moment, 1 - normal * normal, 5e-3)
        << ratio;
    }
}

TEST(ElasticPlastic, SpacesAndPlanesBendAlike)
{
  // Rectangles divided alike across the height.
  const auto law = make_law(with(hardening, {{"Layers", "8"}, {"Grid", "8"}}));
  PlanePoint plane(*law);
  SpacePoint space(*law);
  for (const double curvature : {0.01, 0.1, 0.3, -0.2, 0.})
    {
      const Lanes in_plane[] = {1e-4, 0., curvature},
                  in_space[] = {1e-4, 0., 0., 0., curvature, 0.};
      const auto one         = plane.step({at_end, 0}, in_plane),
                 other       = space.step({at_end, 0}, in_space);
      EXPECT_NEAR(first(one.forces[2]), first(other.forces[4]), 1e-15);
      EXPECT_NEAR(first(one.forces[0]), first(other.forces[0]), 1e-15);
    }
}

namespace
{
  /** Fibres by textbook return mapping, without the elastic check. */
  struct PlainFibres
  {
    explicit PlainFibres(const std::vector<Fibre> &fibres)
      : fibres(fibres)
      , plastic(fibres.size(), 0.)
      , accumulated(plastic)
    {}

    /** Yield stress of the material `hardening` and its slope. */
    static std::pair<double, double> yield(const double a)
    {
      if (a >= .01)
        return {2e-3, 0};
      if (a >= .001)
        return {1.3e-3 + .7e-3 / .009 * (a - .001), .7e-3 / .009};
      return {1e-3 + .3 * a, .3};
    }

    /** Force and moment of EA = 2 and the radius of gyration 0.05. */
    std::pair<double, double> step(const double epsilon, const double kappa)
    {
      const double h = .03;
      double       N = 0, M = 0;
      for (std::size_t i = 0; i < fibres.size(); ++i)
        {
          const double strain = epsilon + .05 * fibres[i].arm_3 * kappa;
          const double xi     = strain - (1 + h) * plastic[i];
          if (std::abs(xi) > yield(accumulated[i]).first)
            {
              double low = 0, high = std::abs(xi);
              for (int k = 0; k < 200; ++k)
                {
                  const double d = (low + high) / 2;
                  (std::abs(xi) - (1 + h) * d > yield(accumulated[i] + d).first
                     ? low
                     : high)     = d;
                }
              plastic[i] += std::copysign(low, xi);
              accumulated[i] += low;
            }
          const double stress = strain - plastic[i];
          N += 2 * fibres[i].weight * stress;
          M += 2 * .05 * fibres[i].arm_3 * fibres[i].weight * stress;
        }
      return {N, M};
    }

    const std::vector<Fibre> fibres;
    std::vector<double>      plastic, accumulated;
  };
} // namespace

TEST(ElasticPlastic, ElasticCheckChangesNothing)
{
  const auto  law = make_law(hardening);
  PlanePoint  point(*law);
  PlainFibres plain(
    plane_fibres({SectionShape::Kind::rectangle, 0}, {16, 4, 16, 8}));
  Walk<3> walk;
  for (int i = 0; i < 2000; ++i)
    {
      // Long elastic stretches between plastic ones.
      walk.next(i / 100 % 2 == 0 ? 0.02 : 0.7);
      const auto response = point.step({at_end, 0}, walk.strains);
      const auto [N, M] =
        plain.step(first(walk.strains[0]), first(walk.strains[2]));
      ASSERT_NEAR(first(response.forces[0]), N, 1e-15) << i;
      ASSERT_NEAR(first(response.forces[2]), M, 1e-16) << i;
      ASSERT_NEAR(first(point.instant(walk.strains).forces[2]), M, 1e-16) << i;
    }
}

namespace
{
  template <class Point, unsigned int n>
  void check_tangent(const SectionLaw &law, const SectionStep &step)
  {
    Point   point(law);
    Walk<n> walk;
    for (int i = 0; i < 100; ++i)
      {
        walk.next(0.8);
        const SectionResponse response = point.evaluate(step, walk.strains);
        for (unsigned int l = 0; l < n; ++l)
          {
            const double h = 1e-9;
            Lanes        moved[n];
            std::copy_n(walk.strains, n, moved);
            moved[l] += h;
            const SectionResponse right = point.evaluate(step, moved);
            moved[l] -= 2 * h;
            const SectionResponse left = point.evaluate(step, moved);
            for (unsigned int k = 0; k < n; ++k)
              {
                const double difference =
                  first(right.forces[k] - left.forces[k]) / (2 * h) *
                  (step.kind == mean ? 2 : 1);
                const double size =
                  std::sqrt(first(point.stiffness[k] * point.stiffness[l]));
                // A fibre may begin to yield between both sides.
                EXPECT_NEAR(first(k == l ? response.tangent[k]
                                    : response.is_coupled
                                    ? response.coupling[k][l]
                                    : Lanes(0)),
                            difference,
                            1e-6 * size)
                  << i << ": " << k << ", " << l;
              }
          }
        point.step(step, walk.strains);
      }
  }
} // namespace

namespace
{
  const Entries with_shear =
    with(hardening, {{"Shear and torsion", "yield"}, {"Grid", "4"}});

  /** Checks a material and the same one with rates. */
  void check_tangents(const Entries &entries)
  {
    const auto law     = make_law(entries);
    const auto viscous = make_law(
      with(entries, {{"Reference strain rate", "2"}, {"Rate exponent", "3"}}));
    for (const SectionStep::Kind kind : {at_end, mean})
      for (const SectionLaw *any : {law.get(), viscous.get()})
        {
          check_tangent<PlanePoint, 3>(*any, {kind, 1e-3});
          check_tangent<SpacePoint, 6>(*any, {kind, 1e-3});
        }
  }
} // namespace

TEST(ElasticPlastic, TangentsAreDerivativesOfForces)
{
  check_tangents(hardening);
}

TEST(ElasticPlastic, TangentsInShearAreDerivativesOfForces)
{
  check_tangents(with_shear);
}

namespace
{
  /** A round section with EA = 1 and the outer radius 1, of nu = 0.3. */
  SectionOnTrial<6> round_section(const SectionLaw &law, const double bore)
  {
    const double g = 1 / 2.6, gyration = (1 + bore * bore) / 4;
    return {law,
            {{StrainType::normal,
              StrainType::shear,
              StrainType::shear,
              StrainType::shear,
              StrainType::normal,
              StrainType::normal}},
            {{1., 0.9 * g, 0.9 * g, 2 * g * gyration, gyration, gyration}}};
  }
} // namespace

// T / T_Y = 4/3 (1 - (phi_Y / phi)^3 / 4) of a perfectly plastic circle.
TEST(ElasticPlastic, CirclesYieldInTorsion)
{
  const auto material = make_law(
    with(unit_material,
         {{"Shear and torsion", "yield"}, {"Rings", "24"}, {"Angles", "8"}}));
  const auto   law    = material->in_shape({SectionShape::Kind::circle, 0});
  auto         point  = round_section(*law, 0);
  const double limit  = 1e-3 / std::sqrt(3.) * 2.6;
  const double torque = limit * first(point.stiffness[3]);
  for (const double ratio : {0.9, 1.5, 2., 5.})
    {
      const Lanes strains[] = {0., 0., 0., ratio * limit, 0., 0.};
      EXPECT_NEAR(first(point.step({at_end, 0}, strains).forces[3]) / torque,
                  ratio < 1 ? ratio : 4. / 3 * (1 - std::pow(ratio, -3.) / 4),
                  4e-4)
        << ratio;
    }
}

// A thin tube twisted to yield and then stretched to 2 Y / E: its axial stress
// s Y satisfies E eps / Y = (1 - E/3G) s + E/3G artanh(s).
TEST(ElasticPlastic, StretchedTubesGiveUpTheirTorque)
{
  const auto material = make_law(
    with(unit_material, {{"Shear and torsion", "yield"}, {"Rings", "1"}}));
  const auto law   = material->in_shape({SectionShape::Kind::tube, 0.9999});
  const auto after = [&](const int n) {
    auto            point = round_section(*law, 0.9999);
    const double    twist = 1e-3 / std::sqrt(3.) * 2.6;
    SectionResponse response;
    for (int i = 0; i <= n; ++i)
      {
        const Lanes strains[] = {2e-3 * i / n, 0., 0., twist, 0., 0.};
        response              = point.step({at_end, 0}, strains);
      }
    const double s = first(response.forces[0]) / 1e-3,
                 t = first(response.forces[3]) /
      first(point.stiffness[3] * Lanes(twist));
    EXPECT_NEAR(s * s + t * t, 1, 2e-4);
    return s;
  };
  const double exact = 0.97364041;
  EXPECT_NEAR(after(1000), exact, 1e-4);
  EXPECT_NEAR((after(500) - exact) / (after(1000) - exact), 2, 0.1);
}

TEST(ElasticPlastic, ShearAndTorsionHaveTheirElasticStiffness)
{
  using Kind = SectionShape::Kind;
  const auto material =
    make_law(with(unit_material, {{"Shear and torsion", "yield"}}));
  for (const SectionShape &shape : {SectionShape{Kind::rectangle, 3},
                                    SectionShape{Kind::circle, 0},
                                    SectionShape{Kind::tube, 0.7}})
    {
      const auto law = material->in_shape(shape);
      SpacePoint at_yield(*law);
      // One fibre beyond yield lets all be summed.
      const Lanes far[] = {1e-3 * (1 + 1e-12), 0., 0., 0., 0., 0.};
      at_yield.step({at_end, 0}, far);
      const Lanes back[] = {-0.5e-3, 1e-7, -2e-7, 1e-6, 1e-6, 2e-6};
      const auto  r      = at_yield.evaluate({at_end, 0}, back);
      for (int k = 1; k < 6; ++k)
        EXPECT_NEAR(first(r.forces[k] / (at_yield.stiffness[k] * back[k])),
                    1,
                    1e-8)
          << k;
    }
}

// Fully plastic torque of a rectangle against the sand hill's. The directions
// of stress stay those of Saint-Venant's solution, which makes it an upper
// bound.
TEST(ElasticPlastic, RectanglesYieldInTorsion)
{
  const auto material =
    make_law(with(unit_material, {{"Shear and torsion", "yield"}}));
  const double b = 2, g = 1 / 2.6;
  const auto   law = material->in_shape({SectionShape::Kind::rectangle, b});
  // J of a 1 x 2 rectangle (Timoshenko & Goodier) over its area.
  const double      torsion = 0.2287 * b / b;
  SectionOnTrial<6> point(*law,
                          {{StrainType::normal,
                            StrainType::shear,
                            StrainType::shear,
                            StrainType::shear,
                            StrainType::normal,
                            StrainType::normal}},
                          {{1., g, g, g * torsion, b * b / 12, 1. / 12}});
  const Lanes       far[] = {0., 0., 0., 1., 0., 0.};
  // Sand hill: tau (h^2 (3 b - h) / 6) over the area.
  const double sand_hill = 1e-3 / std::sqrt(3.) * (3 * b - 1) / 6 / b;
  EXPECT_NEAR(first(point.step({at_end, 0}, far).forces[3]) / sand_hill,
              1,
              0.05);
}

TEST(ElasticPlastic, MeanForcesDoTheWorkOfStoredAndLostEnergy)
{
  for (const Entries &entries : {hardening, with_shear})
    {
      const auto law = make_law(entries);
      SpacePoint point(*law);
      Walk<6>    walk;
      double     stored = 0;
      for (int i = 0; i < 2000; ++i)
        {
          Lanes before[6];
          std::copy_n(walk.strains, 6, before);
          walk.next(i / 50 % 3);
          const SectionResponse response = point.step({mean, 1}, walk.strains);
          Lanes                 work     = 0;
          for (int k = 0; k < 6; ++k)
            work += response.forces[k] * (walk.strains[k] - before[k]);
          ASSERT_NEAR(first(work),
                      first(response.stored) - stored + first(point.lost),
                      1e-17)
            << i;
          ASSERT_GE(first(point.lost), 0) << i;
          stored = first(response.stored);
          ASSERT_NEAR(first(point.instant(walk.strains).stored), stored, 1e-17);
        }
    }
}

TEST(ElasticPlastic, RefusesWhatIsNoMaterial)
{
  const auto message = [](const Entries &entries) {
    try
      {
        make_law(with(unit_material, entries));
      }
    catch (const InputError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  EXPECT_EQ(message({}), "");
  EXPECT_NE(message({{"Plastic strains", "0.1"}, {"Flow stresses", "0.9e-3"}})
              .find("must not fall"),
            std::string::npos);
  EXPECT_NE(message({{"Plastic strains", "0.2, 0.1"},
                     {"Flow stresses", "2e-3, 3e-3"}})
              .find("must rise"),
            std::string::npos);
  EXPECT_NE(message({{"Plastic strains", "0.2"}}).find("equal length"),
            std::string::npos);
}
