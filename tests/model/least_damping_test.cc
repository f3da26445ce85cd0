#include <auxfem/model/build_lattice.h>
#include <auxfem/model/least_damping.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two struts in line, of two sections. */
  SceneText two_struts(const std::string &first, const std::string &second)
  {
    SceneText scene;
    scene.frame("0 0; 1 0; 2 0", "0 1; 1 2")
      .circle("one", 0.02, {1e9, 1000, 0.3})
      .circle("other", 0.01, {1e9, 1000, 0.3})
      .set("Sections/one/Struts", "0")
      .set("Sections/other/Struts", "1")
      .set("Sections/one/Stiffness-proportional damping", first)
      .set("Sections/other/Stiffness-proportional damping", second)
      .support("clamp", "0", "clamp")
      .time(1, 0.01, "esdirk");
    return scene;
  }

  double rate_in(const SceneText &text, const double omega)
  {
    const Scene        scene = read_scene_from_text(text, "test.prm");
    const Lattice      lattice(build_lattice(scene));
    const LatticeModel model(scene, lattice, MPI_COMM_SELF);
    return LeastDamping(scene, model).rate(omega);
  }

  /** Real part of the slower root of s^2 + b omega^2 s + omega^2 = 0. */
  double decay(const double b, const double omega)
  {
    const double half = b * omega * omega / 2,
                 rest = half * half - omega * omega;
    return rest < 0 ? half : half - std::sqrt(rest);
  }

  SceneText with_connector(SceneText scene, const std::string &law)
  {
    return scene.add("Connectors/link", "Between = 0 2 | " + law);
  }
} // namespace

TEST(LeastDamping, IsThatOfTheStrutsThatAreDampedLeast)
{
  for (const double omega : {1., 100., 1900., 2100., 1e5})
    EXPECT_NEAR(rate_in(two_struts("2 ms", "1 ms"), omega) / decay(1e-3, omega),
                1,
                1e-9)
      << omega;
  EXPECT_EQ(rate_in(two_struts("2 ms", "0"), 100), 0);
  EXPECT_EQ(
    rate_in(two_struts("2 ms", "1 ms").set("Effects/Strut damping", "off"),
            100),
    0);
}

TEST(LeastDamping, IsNoneWhereASpringIsNotDamped)
{
  SceneText scene = two_struts("1 ms", "1 ms");
  scene.add("Joints/middle",
            "Type = rotational spring | Joints = 1 | Struts = 1 | "
            "Stiffness = 1");
  EXPECT_EQ(rate_in(scene, 100), 0);
}

TEST(LeastDamping, IsThatOfConnectorsWhereTheseAreDampedLess)
{
  const SceneText scene = two_struts("1 ms", "1 ms");
  const double    omega = 100;
  const auto      rate  = [&](const std::string &law) {
    return rate_in(with_connector(scene, law), omega);
  };
  EXPECT_EQ(rate("Law = spring | Spring stiffness = 10"), 0);
  EXPECT_NEAR(rate("Law = dashpot | Damping coefficient = 1"),
              decay(1e-3, omega),
              1e-9);
  EXPECT_NEAR(rate("Law = kelvin-voigt | Spring stiffness = 1000 | "
                   "Damping coefficient = 0.2"),
              decay(2e-4, omega),
              1e-9);
  EXPECT_NEAR(rate("Law = kelvin-voigt | Spring stiffness = 1000 | "
                   "Damping coefficient = 5"),
              decay(1e-3, omega),
              1e-9);
  // Of a Maxwell element: 1 / (omega^2 tau).
  EXPECT_NEAR(rate("Law = maxwell | Spring stiffness = 1 | "
                   "Damping coefficient = 2"),
              decay(1 / (omega * omega * 2), omega),
              1e-9);
  EXPECT_EQ(rate_in(with_connector(scene,
                                   "Law = kelvin-voigt | Spring stiffness = "
                                   "1000 | Damping coefficient = 5")
                      .set("Effects/Connector viscosity", "off"),
                    omega),
            0);
}
