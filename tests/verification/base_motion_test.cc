#include <support/scene_run.h>
#include <support/scene_text.h>
#include <support/text_file.h>
#include <verification/result_table.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace auxfem;
using namespace auxfem::testing_support;

// Masses on a base that accelerates, against exact integration.

namespace
{
  constexpr double stiffness = 400, mass = 4, omega = 10; // N/m, kg, 1/s

  /** Times (s) and accelerations (m/s2) of a record. */
  const std::vector<std::array<double, 2>> record =
    {{{0, 0}}, {{0.2, 3}}, {{0.5, -4}}, {{0.6, 1}}, {{0.9, 2}}, {{1, 0}}};

  /**
   * Displacement at the end of the record relative to the base: between its
   * rows x'' + omega^2 x = -(a + s t) has the solution
   * A cos(omega t) + B sin(omega t) - (a + s t) / omega^2.
   */
  double exact_displacement()
  {
    double x = 0, v = 0;
    for (std::size_t i = 1; i < record.size(); ++i)
      {
        const double a = record[i - 1][1], dt = record[i][0] - record[i - 1][0],
                     s = (record[i][1] - a) / dt, square = omega * omega,
                     A = x + a / square, B = (v + s / square) / omega;
        x = A * std::cos(omega * dt) + B * std::sin(omega * dt) -
          (a + s * dt) / square;
        v = omega * (B * std::cos(omega * dt) - A * std::sin(omega * dt)) -
          s / square;
      }
    return x;
  }

  std::string record_text()
  {
    std::string rows;
    for (const auto &[time, acceleration] : record)
      rows += text(time) + ", " + text(acceleration) + "\n";
    return rows;
  }

  /** A mass on a rod along x. */
  SceneText mass_on_rod()
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .section({stiffness, stiffness, 1})
      .set("Sections/section 0/Density", 0)
      .support("wall", "0", "clamp")
      .add("Supports/guide",
           "Joints = 1 | Type = prescribed | Displacement y = 0 | "
           "Rotation z = 0")
      .mass("body", "1", mass)
      .set("Effects/Large rotation", "off")
      .mesh(1);
  }
} // namespace

TEST(BaseMotion, ShakesAMassByARecord)
{
  const std::filesystem::path file =
    std::filesystem::temp_directory_path() / "auxfem-base-motion.csv";
  write_text(file, record_text());
  const double    exact = exact_displacement();
  ComparisonTable table("Mass on a shaken base");
  for (const char *scheme : {"newmark", "generalized-alpha", "energy-momentum"})
    {
      const auto error = [&](const double dt) {
        SceneRun run(
          mass_on_rod()
            .set("Base motion/Acceleration x", "table: " + file.string())
            .time(1, dt, scheme));
        run.run();
        EXPECT_LT(std::abs(run.balance()), 1e-10 * run.state.largest_energy);
        return std::abs(run.motion(1, 0) - exact);
      };
      table.row(scheme, std::log2(error(0.01) / error(0.005)), 2, 0.1);
    }
}

// Seen from the base, masses move as under a support that moves, less its way.
TEST(BaseMotion, EqualsMovingSupports)
{
  SceneRun relative(mass_on_rod()
                      .set("Base motion/Acceleration x", "6 * t")
                      .time(1, 0.01, "newmark"));
  relative.run();
  SceneRun absolute(mass_on_rod()
                      .remove("Supports/wall")
                      .prescribe("wall", "0", {"t^3", "0", "0"})
                      .time(1, 0.01, "newmark"));
  absolute.run();
  EXPECT_NEAR(relative.motion(1, 0), absolute.motion(1, 0) - 1, 1e-4);
  EXPECT_NEAR(relative.reaction("wall", 0), absolute.reaction("wall", 0), 0.05);
}
