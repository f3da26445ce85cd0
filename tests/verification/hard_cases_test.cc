#include <auxfem/parameters/errors.h>

#include <support/scene_run.h>
#include <verification/comparison_table.h>
#include <verification/label.h>
#include <verification/star_scene.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// What breaks finite-element programs: a lattice that collapses, long steps,
// extreme connectors, tolerances below round-off. Here a run goes on or ends
// with a clear error, and never with a state that is not finite.

namespace
{
  using Overrides = std::vector<std::string>;

  bool is_finite(const SceneRun &run)
  {
    const State &state = run.state;
    for (int i = 0; i < state.displacement.MyLength(); ++i)
      if (!std::isfinite(state.displacement[i]) ||
          !std::isfinite((*state.velocity)[i]) ||
          !std::isfinite((*state.acceleration)[i]) ||
          !std::isfinite(state.residual[i]))
        return false;
    return std::isfinite(run.balance());
  }

  Overrides scene(const unsigned int n, const double load, const double end)
  {
    return star_size(n, load) + Overrides{"Time/End time=" + text(end)};
  }

  /** Displacement of the middle top stub end. */
  double top(const SceneRun &run)
  {
    const auto &joints = run.lattice.joint_sets.at("top");
    return run.motion(joints[joints.size() / 2], 1);
  }

  double end_of_run(const Overrides &overrides)
  {
    SceneRun run(star_scene(), overrides);
    run.run();
    EXPECT_TRUE(is_finite(run));
    return top(run);
  }
} // namespace

TEST(HardCases, ExploreCollapse)
{
  for (const double load : {2.0, 10.0})
  {
  SceneRun run(star_scene(), scene(4, load, 20e-3));
  unsigned retries = 0;
  try
    {
      run.run([&] {
        ASSERT_TRUE(is_finite(run)) << run.state.time;
      });
    }
  catch (const ComputationError &error)
    {
      std::cout << error.what() << std::endl;
    }
  std::cout << "load " << load << " t " << run.state.time << " top " << top(run) << " it " << run.iterations << " bal " << run.balance()
            << " ext " << run.state.energies.external << " tot "<<run.state.energies.total() << " diss " << run.state.energies.dissipated << " " << retries << std::endl;
  }
}
TEST(HardCases, ExploreOthers)
{
  const auto show = [](const std::string &name, const Overrides &o){
    try {
    SceneRun run(star_scene(), o); 
    run.run();
    std::cout << name << ": top " << std::setprecision(12) << top(run) << " it " << run.iterations << " fact " << run.factorizations << " steps " << run.state.step << " bal " << run.balance() << " ext " << run.state.energies.external << " finite " << is_finite(run) << std::endl;
    } catch (const std::exception &e) { std::cout << name << ": " << e.what() << std::endl; }
  };
  const Overrides base = scene(4, 1.0, 20e-3);
  show("base", base);
  show("dt*20", base + Overrides{"Time/Time step=0.4e-3"});
  show("full", base + Overrides{"Newton/Factorization=every iteration"});
  show("tol 1e-12", base + Overrides{"Newton/Tolerance=1e-12"});
  show("tol 1e-12 full", base + Overrides{"Newton/Tolerance=1e-12", "Newton/Factorization=every iteration"});
  show("tiny load tol 1e-12", scene(4, 1e-9, 5e-3) + Overrides{"Newton/Tolerance=1e-12"});
  show("tiny load tol 1e-15", scene(4, 1e-9, 5e-3) + Overrides{"Newton/Tolerance=1e-15"});
  show("zero load tol 1e-15", scene(4, 0, 5e-3) + Overrides{"Newton/Tolerance=1e-15"});
  show("K*1e6", base + Overrides{"Connectors/damper/Spring stiffness=2e8"});
  show("K*1e7", base + Overrides{"Connectors/damper/Spring stiffness=2e9"});
  show("C*1e6", base + Overrides{"Connectors/damper/Damping coefficient=5e4"});
  show("C*1e7", base + Overrides{"Connectors/damper/Damping coefficient=5e5"});
  show("C*1e6 2N", scene(4,2.1,20e-3) + Overrides{"Connectors/damper/Damping coefficient=5e4"});
  show("C=0", base + Overrides{"Connectors/damper/Damping coefficient=0"});
  show("spring", base + Overrides{"Connectors/damper/Law=spring"});
  for (double x : {1e-6, 1e-4, 1e-2, 1., 1e2, 1e4, 1e6})
    show(label("maxwell dt/tau", x), base + Overrides{"Connectors/damper/Law=maxwell", "Connectors/damper/Damping coefficient=" + text(200*20e-6/x)});
  show("maxwell C=0", base + Overrides{"Connectors/damper/Law=maxwell", "Connectors/damper/Damping coefficient=0"});
  show("KV K=0 C=0", base + Overrides{"Connectors/damper/Spring stiffness=0", "Connectors/damper/Damping coefficient=0"});
  show("linear", base + Overrides{"Effects/Large rotation=off"});
  show("linear half", base + Overrides{"Effects/Large rotation=off", "Time/Time step=13us"});
  show("dt/2", base + Overrides{"Time/Time step=10e-6"});
  show("dt*2", base + Overrides{"Time/Time step=40e-6"});
}
