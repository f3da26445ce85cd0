#include <gtest/gtest.h>
#include <support/scene_text.h>
#include <verification/round_beam.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

#include "result_table.h"

using namespace auxfem;
using namespace auxfem::testing_support;

// Order of the schemes in dt in space: a free angle of two beams that bends,
// twists and turns over under smooth loads, dead and following.

namespace
{
  constexpr unsigned int n_quantities = 6;

  /** Motion of the free end of the second beam. */
  using EndMotion = std::array<SpaceVector, n_quantities>;

  const char *const names[n_quantities] = {"displacement (m)",
                                           "rotation (rad)",
                                           "velocity (m/s)",
                                           "angular velocity (rad/s)",
                                           "acceleration (m/s2)",
                                           "angular acceleration (rad/s2)"};

  std::string angle_of_beams(const double dt)
  {
    SceneText scene = round_beam(4e3, 800);
    scene.set("Lattice/Joints", "0 0 0; 4 0 0; 4 4 1");
    scene.set("Lattice/Struts", "0 1; 1 2");
    scene.set("Loads/dead/Joints", "0");
    set_vector(scene, "Loads/dead/Force", SpaceVector({10., -15., 30.}), "t^3");
    set_vector(scene,
               "Loads/dead/Moment",
               SpaceVector({150., -60., 120.}),
               "t^3");
    scene.set("Loads/following/Joints", "2");
    scene.set("Loads/following/Direction", "follows the joint");
    set_vector(scene,
               "Loads/following/Moment",
               SpaceVector({-50., 90., 70.}),
               "t^3");
    return scene.mesh(2, 0).time(2, dt).str();
  }

  /** @param turn largest rotation vector, printed. */
  EndMotion
  motion_with(std::vector<std::string> scheme, const double dt, double &turn)
  {
    // Inertia forces of the shortest steps have round-off of 1e-11.
    scheme.push_back("Newton/Tolerance=1e-9");
    SceneRun run(angle_of_beams(dt), scheme);
    run.run();
    const auto at_end = [&run](const Vector &vector, const unsigned int first) {
      return at_joint(run, vector, 2, first);
    };
    const State      &state    = run.state;
    const SpaceVector rotation = rotation_vector(rotation_of_joint(run, 2));
    turn                       = rotation.norm();
    return {{at_end(state.displacement, 0),
             rotation,
             at_end(*state.velocity, 0),
             at_end(*state.velocity, first_rotation),
             at_end(*state.acceleration, 0),
             at_end(*state.acceleration, first_rotation)}};
  }

  void observe_order(const std::string              &name,
                     const std::vector<std::string> &scheme)
  {
    ResultTable::Cells columns = {"step (s)"};
    for (const char *quantity : names)
      columns.insert(columns.end(), {quantity, "rate"});
    ResultTable table("Changes with halved steps in space, " + name, columns);
    double      turn = 0;
    EndMotion   before{};
    std::array<double, n_quantities> changes{}, rates{};
    double                           dt = 0.02;
    for (unsigned int halving = 0; halving < 5; ++halving, dt /= 2)
      {
        const EndMotion now = motion_with(scheme, dt, turn);
        if (halving > 0)
          {
            ResultTable::Cells cells = {text(dt)};
            for (unsigned int k = 0; k < n_quantities; ++k)
              {
                const double change = (now[k] - before[k]).norm();
                rates[k]            = std::log2(changes[k] / change);
                changes[k]          = change;
                cells.push_back(formatted("%.2e", change));
                cells.push_back(halving > 1 ? formatted("%.2f", rates[k]) : "");
              }
            table.row(cells);
          }
        before = now;
      }
    std::cout << "Largest turn " << turn << " rad" << std::endl;
    for (unsigned int k = 0; k < n_quantities; ++k)
      EXPECT_NEAR(rates[k], 2, 0.1) << name << ", " << names[k];
    EXPECT_GT(turn, 1.5) << "not a large rotation";
  }
} // namespace

TEST(OrdersInSpace, NewmarkIsOfSecondOrder)
{
  observe_order("Newmark", {"Time/Scheme=newmark"});
}

TEST(OrdersInSpace, HhtIsOfSecondOrder)
{
  observe_order("HHT -0.1", {"Time/Scheme=hht", "Time/HHT alpha=-0.1"});
}

TEST(OrdersInSpace, GeneralizedAlphaIsOfSecondOrder)
{
  observe_order("generalized-alpha 0.8",
                {"Time/Scheme=generalized-alpha", "Time/Spectral radius=0.8"});
}
