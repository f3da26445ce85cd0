#include <auxfem/output/recorder.h>
#include <auxfem/simulation.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/linear_ode.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>
#include <verification/space_text.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Implicit Runge-Kutta schemes keep their order for everything that moves, and
// for the internal variables, dissipation and work that go with it, as long as
// steps resolve it.

namespace
{
  SceneText with_esdirk(SceneText scene, const unsigned int order)
  {
    return scene.set("Time/Scheme", "esdirk")
      .set("Time/Order of esdirk", order);
  }

  /** Columns of a run at equal times, by name. */
  using Quantities = std::map<std::string, std::vector<double>>;

  /** @p columns of the history of a run, at multiples of @p interval (s). */
  Quantities quantities(SceneText                       scene,
                        const std::vector<std::string> &columns,
                        const double                    interval)
  {
    const Scene read = read_scene_from_text(
      scene.set("Output/Time between rows", interval).str(),
      "test.prm");
    MemoryRecorder history(read, MPI_COMM_WORLD);
    run(read, MPI_COMM_WORLD, history);
    Quantities result;
    for (const std::string &column : columns)
      result[column] = history.column(column);
    return result;
  }

  double largest_difference(const std::vector<double> &one,
                            const std::vector<double> &other)
  {
    double largest = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      largest = std::max(largest, std::abs(one[i] - other.at(i)));
    return largest;
  }

  /** Orders observed with steps of @p dt (s) and its half, at their ends and
   * between. */
  std::map<std::string, double>
  observed_orders(const SceneText                &scene,
                  const unsigned int              order,
                  const double                    dt,
                  const std::vector<std::string> &columns)
  {
    const auto with = [&](const unsigned int p, const double step) {
      return quantities(with_esdirk(scene, p).set("Time/Time step", step),
                        columns,
                        0.3 * dt);
    };
    Quantities reference = with(5, dt / 10), coarse = with(order, dt),
               fine = with(order, dt / 2);
    std::map<std::string, double> orders;
    for (const auto &[name, values] : reference)
      orders[name] = std::log2(largest_difference(values, coarse[name]) /
                               largest_difference(values, fine[name]));
    return orders;
  }

  double allowed_deviation(const unsigned int order,
                           const std::string &quantity)
  {
    // Order 5 soon meets round-off; what is dissipated errs with a higher order
    // yet.
    return order == 5 ? 0.45 : quantity == "dissipated" ? 0.7 : 0.3;
  }

  void expect_orders(const std::string       &name,
                     SceneText                scene,
                     std::vector<std::string> columns)
  {
    scene.probe("tip", "2");
    for (const char *column :
         {"tip.uy", "tip.vy", "damper.force", "external", "dissipated"})
      columns.push_back(column);
    ComparisonTable table("Orders of Runge-Kutta schemes, " + name);
    const std::map<unsigned int, double> steps = {{3, 0.0005},
                                                  {4, 0.001},
                                                  {5, 0.003}};
    for (const auto &[order, dt] : steps)
      for (const auto &[quantity, observed] :
           observed_orders(scene, order, dt, columns))
        table.row("order " + std::to_string(order) + ", " + quantity,
                  observed,
                  // Between steps what follows from motions is cubic.
                  quantity.find("tip.") == 0 ? order : std::min(order, 4u),
                  allowed_deviation(order, quantity));
  }

  /** A clamped angle of two soft, stocky struts: steps of milliseconds resolve
   * all that it does. */
  SceneText soft_angle(const unsigned int dimension)
  {
    SceneText scene;
    scene.dimension(dimension).set("Lattice/Cell", "frame");
    scene.set("Lattice/Joints",
              dimension == 2 ? "0 0; 2 0; 2 2" : "0 0 0; 2 0 0; 2 2 0.6");
    scene.set("Lattice/Struts", "0 1; 1 2");
    scene.circle("rod", 0.08, {4e6, 1000, 0.3});
    scene.set("Sections/rod/Mass-proportional damping", "0.5 1/s");
    scene.set("Sections/rod/Stiffness-proportional damping", "0.02 ms");
    scene.support("clamp", "0", "clamp");
    scene.set("Loads/push/Joints", "2");
    scene.set("Loads/push/Force x", "-800 * t^3");
    scene.set("Loads/push/Force y", "-600 * t^3");
    if (dimension == 3)
      scene.set("Loads/push/Force z", "400 * t^3");
    scene.set("Loads/turn/Joints", "2")
      .set("Loads/turn/Direction", "follows the joint");
    scene.set("Loads/turn/Moment z", "200 * t^3");
    scene.connector("damper",
                    "standard-linear-solid",
                    std::string("Between = ground: 2 | Ground offset = ") +
                      (dimension == 2 ? "0.3 0.5" : "0.3 0.5 0.2") +
                      " | Long-time stiffness = 10 | Spring stiffness = 40 | "
                      "Damping coefficient = 2");
    return scene.mesh(1).time(0.48, 0.004).set("Newton/Tolerance", "1e-13");
  }
} // namespace

TEST(RungeKuttaOrder, InThePlane)
{
  expect_orders("plane", soft_angle(2), {"tip.phi"});
}

TEST(RungeKuttaOrder, InSpace)
{
  expect_orders("space", soft_angle(3), {"tip.phi_z"});
}

TEST(RungeKuttaOrder, OfOneMassOnAMaxwellElementAgainstItsClosedForm)
{
  const double    end = 0.32, stiffness = 400, spring = 300, tau = 0.02;
  const OneMass   exact{1, stiffness, 0, {{spring, tau}}};
  ComparisonTable table(
    "Orders of Runge-Kutta schemes, mass on a standard linear solid");
  const auto error = [&](const unsigned int order, const double dt) {
    SceneRun run(
      with_esdirk(
        one_mass_scene("Law = standard-linear-solid | Long-time stiffness = " +
                         text(stiffness) +
                         " | Spring stiffness = " + text(spring) +
                         " | Damping coefficient = " + text(spring * tau),
                       "Time step = " + text(dt) + " | End time = " + text(end),
                       mass_and_velocity(1, 1)),
        order)
        .str());
    run.run();
    return std::abs(run.motion(0, 0) - exact.at(end, 0, 1)(0));
  };
  for (const unsigned int order : {3, 4, 5})
    table.row("order " + std::to_string(order),
              std::log2(error(order, 0.008) / error(order, 0.004)),
              order,
              0.15);
}

// Positions of rigid parts are constraints, of which a scheme with stages
// keeps less than its order.
TEST(RungeKuttaOrder, OfRigidParts)
{
  const SceneText bars =
    SceneText()
      .frame("0 0; 1 0; 1.5 0", "0 1; 1 2")
      .add("Rigid parts/bars",
           "Struts = all | Parts = single struts | Mass = 0.5")
      .support("pivot", "0", "pin")
      .add("Gravity", "Acceleration y = -9.81")
      .time(0.8, 0.01)
      .set("Newton/Tolerance", "1e-11");
  const auto at_end = [&](const SceneText &scene, const double dt) {
    SceneRun run(SceneText(scene).set("Time/Time step", dt).str());
    run.run();
    return run.motion(2, 0);
  };
  const double reference = at_end(with_esdirk(bars, 4), 0.0005);
  ResultTable  table("Double pendulum of rigid bars for 0.8 s",
                    {"scheme",
                      "stages of 4 ms, error (m)",
                      "stages of 2 ms, error (m)",
                      "order"});
  const auto   observe = [&](const std::string &name,
                           const SceneText   &scene,
                           const unsigned int n_stages) {
    const auto error = [&](const double dt) {
      return std::abs(at_end(scene, n_stages * dt) - reference);
    };
    const double coarse = error(0.004), fine = error(0.002),
                 order = std::log2(coarse / fine);
    table.row({name,
               formatted("%.1e", coarse),
               formatted("%.1e", fine),
               formatted("%.2f", order)});
    EXPECT_GT(order, 1.7) << name;
    EXPECT_LT(fine, 1e-3) << name;
  };
  observe("newmark", bars, 1);
  for (const unsigned int order : {3, 4, 5})
    observe("esdirk of order " + std::to_string(order),
            with_esdirk(bars, order),
            order + 1);
}
