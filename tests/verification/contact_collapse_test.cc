#include <support/energy_amount.h>
#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/star_scene.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// Struts that touch without being asked to: a collapse on itself, rigid
// struts.

namespace
{
  /**
   * Lowest height (m) of a bar that falls flat onto a rigid one, both 2 mm
   * thick.
   */
  double lowest_height()
  {
    SceneText scene;
    scene.frame("-0.1 0; 0.1 0; -0.04 0.01; 0.04 0.01", "0 1; 2 3")
      .rectangle("bar", "10 mm", "2 mm", {1e9, 1000, 0})
      .rigid_part("floor", "0", "1 kg")
      .support("held", "0", "pin")
      .prescribe("level", "1", {"free", "0", "free"})
      .set("Contact/Stiffness", 1000)
      .add("Initial velocities/fall", "Joints = 2, 3 | Velocity y = -1")
      .mesh(3, 2)
      .time(20e-3, 50e-6, "energy-momentum");
    SceneRun run(scene.str());
    double   lowest = 1;
    run.run([&] {
      lowest =
        std::min(lowest, 0.01 + std::min(run.motion(2, 1), run.motion(3, 1)));
    });
    return lowest;
  }
} // namespace

TEST(ContactCollapse, ALatticeFallsOntoItself)
{
  // Twice the buckling load: folded struts come to lie on each other, at speed.
  SceneRun run(star_scene(),
               star_size(2, 2.6) +
                 std::vector<std::string>{"Time/End time=17 ms",
                                          "Time/Scheme=energy-momentum",
                                          "Newton/Tolerance=1e-10"});
  double   largest_energy = 0, stored_by_contact = 0;
  run.run([&] {
    const Energies &energies = run.state.energies;
    largest_energy = std::max(largest_energy, std::abs(energies.external()));
    stored_by_contact =
      std::max(stored_by_contact, energy_amount(run.state.energies, "contact"));
  });
  EXPECT_GT(stored_by_contact, 1e-3 * largest_energy);
  ComparisonTable table(
    "Star lattice of 2 x 2 cells that falls onto itself, energy-momentum");
  table.row("error of the balance / energy that came in",
            run.balance() / largest_energy,
            0,
            1e-7);
}

TEST(ContactCollapse, RigidStrutsAreAsThickAsTheirSection)
{
  EXPECT_NEAR(lowest_height(), 2e-3, 0.05e-3);
}
