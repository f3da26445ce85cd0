#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>
#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

// Struts that touch each other: closed forms.

namespace
{
  constexpr double E = 1e9, width = 10e-3, height = 2e-3;
  constexpr double EI = E * width * height * height * height / 12;

  /** Bars of 10 mm x 2 mm, or square ones, hard to press into each other. */
  SceneText bars(const std::string &joints, const std::string &struts)
  {
    return SceneText()
      .frame(joints, struts)
      .rectangle("bar", "10 mm", "2 mm", {E, 1000, 0})
      .set("Effects/Contact", "on")
      .set("Contact/Stiffness", 1000)
      .mesh(4);
  }

  /** Momentum along x of each strut (N s). */
  std::vector<double> momenta_along_x(SceneRun &run)
  {
    const DofNumbering &dofs = run.model.numbering;
    Vector              momentum(dofs.layout().n_owned());
    run.mass()->multiply(run.state.velocity->data(), momentum.data());
    std::vector<std::set<int>> along_x(run.lattice.struts.size());
    for (unsigned int e = 0; e < dofs.elements().size(); ++e)
      for (unsigned int node = 0; node <= dofs.elements()[e].order; ++node)
        along_x[dofs.elements()[e].interval.strut].insert(
          dofs.element_unknowns(e)[node * dofs.n_components()]);
    std::vector<double> sums;
    for (const std::set<int> &unknowns : along_x)
      {
        sums.push_back(0);
        for (const int unknown : unknowns)
          sums.back() += momentum[unknown];
      }
    return sums;
  }
} // namespace

TEST(ContactStruts, CantileverOnCantilever)
{
  // The upper one is shorter; its tip comes down on the lower one, at the same
  // distance from the wall.
  constexpr double length = 0.08, gap = 1e-5, force = 0.01;
  SceneText        scene = bars("0 0; 0.1 0; 0 " + text(height + gap) + "; " +
                           text(length) + " " + text(height + gap),
                         "0 1; 2 3");
  scene.support("wall", "0, 2", "clamp")
    .add("Loads/tip", "Joints = 3 | Force y = -t * " + text(force))
    .set("Effects/Shear flexibility", "off")
    .mesh(4, 3)
    .time(1, 0.1, "static");
  SceneRun run(scene.str());
  run.run();
  const double    compliance = length * length * length / (3 * EI);
  const double    reaction   = (force * compliance - gap) / (2 * compliance);
  ComparisonTable table(
    "Tip of a cantilever pressed on another one (beam theory, no thickness)");
  table.relative("deflection of the upper tip (m)",
                 -run.motion(3, 1),
                 (force - reaction) * compliance,
                 2e-3);
  table.relative("deflection of the lower tip (m)",
                 -run.motion(1, 1),
                 reaction * length * length * (3 * 0.1 - length) / (6 * EI),
                 2e-3);
}

TEST(ContactStruts, CrossingCantileversInSpace)
{
  // One along x, loaded at its tip, above one along y; they cross at right
  // angles, at the distances a and b from their walls.
  constexpr double side = 2e-3, gap = 1e-5, length = 0.1, a = 0.0613,
                   b = 0.0551, force = 0.01;
  const double bending = E * side * side * side * side / 12;
  const double z       = side + gap;
  SceneText    scene =
    SceneText()
      .dimension(3)
      .frame("0 0 " + text(z) + "; " + text(length) + " 0 " + text(z) + "; " +
               text(a) + " " + text(-b) + " 0; " + text(a) + " 0.03 0",
             "0 1; 2 3")
      .rectangle("bar", "2 mm", "2 mm", {E, 1000, 0})
      .set("Effects/Contact", "on")
      .set("Effects/Shear flexibility", "off")
      .set("Contact/Stiffness", 1000)
      .support("wall", "0, 2", "clamp")
      .add("Loads/tip", "Joints = 1 | Force z = -t * " + text(force))
      .mesh(4, 3)
      .time(1, 0.1, "static");
  SceneRun run(scene.str());
  run.run();
  const double free_at_a = force * a * a * (3 * length - a) / (6 * bending);
  const double reaction =
    (free_at_a - gap) / ((a * a * a + b * b * b) / (3 * bending));
  ComparisonTable table("Crossing cantilevers in space (beam theory)");
  table.relative("deflection of the loaded tip (m)",
                 -run.motion(1, 2),
                 (force * length * length * length / 3 -
                  reaction * a * a * (3 * length - a) / 6) /
                   bending,
                 2e-3);
}

TEST(ContactStruts, EqualRodsExchangeTheirVelocities)
{
  // End on, both free: the moving one stops after the wave has gone to its end
  // and back, and the other leaves with its velocity. By Scheme =
  // energy-momentum momentum is conserved, and energy.
  constexpr double length = 0.1, speed = 1, area = width * height;
  SceneText scene = bars("0 0; 0.1 0; " + text(0.1 + height + 1e-7) + " 0; " +
                           text(0.2 + height + 1e-7) + " 0",
                         "0 1; 2 3");
  const double c  = std::sqrt(E / 1000);
  scene.add("Initial velocities/first", "Joints = 0, 1 | Velocity x = 1")
    .set("Contact/Stiffness", 1)
    .set("Newton/Tolerance", 1e-13)
    .mesh(4, 3)
    .time(5 * length / c, length / c / 100, "energy-momentum");
  SceneRun     run(scene.str());
  const double mass    = 1000 * area * length;
  double       balance = 0;
  run.run([&] { balance = std::max(balance, std::abs(run.balance())); });
  const std::vector<double> momentum = momenta_along_x(run);
  ComparisonTable table("Equal rods that collide end on, energy-momentum");
  table.row("velocity of the first rod after (m/s)",
            momentum[0] / mass,
            0,
            0.02 * speed);
  table.row("velocity of the second rod after (m/s)",
            momentum[1] / mass,
            speed,
            0.02 * speed);
  table.row("change of momentum over momentum",
            (momentum[0] + momentum[1]) / (mass * speed) - 1,
            0,
            1e-10);
  table.row("error of the balance over the energy",
            balance / (mass * speed * speed / 2),
            0,
            1e-9);
}
