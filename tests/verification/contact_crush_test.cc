#include <auxfem/contact/effects/contact.h>

#include <support/run_program.h>
#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// A star lattice between two plates: its force converges with the mesh and the
// steps up to where it loses its stability.

namespace
{
  /** Force (N) on the upper plate of `prm/crush.prm` with 3 x 3 cells by 2 ms
   * from 0.1 s to 0.16 s. At 0.166 s the verdict says that stability is lost.
   */
  std::vector<double> crushing_force(const double       step,
                                     const unsigned int order)
  {
    SceneRun            run(prm_text("crush.prm"),
                 {"Lattice/Cells x=3",
                             "Lattice/Cells y=3",
                             "Constants=H = 81.9615e-3, crush = 0.6, T = 1",
                             "Plates/upper plate/Position=41 mm, 68.8115 mm",
                             "Time/End time=0.16",
                             "Time/Time step=" + text(step),
                             "Discretization/Order=" + std::to_string(order)});
    std::vector<double> forces;
    run.run([&] {
      const double multiple = run.state.time / 2e-3;
      if (run.state.time > 0.099 &&
          std::abs(multiple - std::round(multiple)) < 1e-6)
        forces.push_back(
          run.equations.reporting()
            .plates
            ->reports(run.equations.plate_results(run.results), run.state)[1]
            .force[1]);
    });
    return forces;
  }

  /** Largest difference over the last force. */
  double difference(const std::vector<double> &one,
                    const std::vector<double> &other)
  {
    EXPECT_EQ(one.size(), other.size());
    double largest = 0;
    for (std::size_t i = 0; i < other.size(); ++i)
      largest = std::max(largest, std::abs(one[i] - other[i]));
    return largest / other.back();
  }
} // namespace

TEST(ContactCrush, TheForceConvergesUntilStabilityIsLost)
{
  std::vector<std::vector<double>> by_step, by_order;
  for (const double step : {2e-3, 1e-3, 0.5e-3})
    by_step.push_back(crushing_force(step, 3));
  by_order.push_back(crushing_force(1e-3, 2));
  by_order.push_back(by_step[1]);
  by_order.push_back(crushing_force(1e-3, 4));
  by_order.push_back(crushing_force(1e-3, 5));
  ASSERT_EQ(by_order.back().size(), 31u);

  ComparisonTable table("Star lattice of 3 x 3 cells crushed between plates: "
                        "change of the force by half the step, one order more");
  // The scheme is of second order.
  const double coarse = difference(by_step[0], by_step[1]),
               fine   = difference(by_step[1], by_step[2]);
  table.row("steps of 2 and 1 ms", coarse, 0, 1e-4);
  table.row("steps of 1 and 0.5 ms", fine, 0, coarse / 3);
  // Elements of order p have a bending energy to order 2 p.
  const double second = difference(by_order[0], by_order[1]),
               third  = difference(by_order[1], by_order[2]),
               fourth = difference(by_order[2], by_order[3]);
  table.row("orders 2 and 3", second, 0, 5e-3);
  table.row("orders 3 and 4", third, 0, second / 10);
  table.row("orders 4 and 5", fourth, 0, third / 10);
}
