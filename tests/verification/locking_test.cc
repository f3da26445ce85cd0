#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/rod_equation.h>

#include <cmath>
#include <iomanip>
#include <iostream>

#include "result_table.h"

using namespace auxfem::testing_support;

namespace
{
  /** A cantilever L = EI = 1 of a square section, L / height = @p slenderness. */
  ClampedRod slender_rod(const double slenderness, const double curvature)
  {
    const double EA = 12 * slenderness * slenderness;
    return {{EA, 5. / 6 / 2.6 * EA, 1}, curvature, -1, 4, 0};
  }

  /** Distance of the computed tip from the exact one, over its deflection. */
  double error_of_tip(const ClampedRod  &rod,
                      const unsigned int order,
                      const unsigned int refinements)
  {
    const double curvature = rod.curvature;
    const double x = curvature > 0 ? std::sin(curvature) / curvature : 1;
    const double y = curvature > 0 ? (1 - std::cos(curvature)) / curvature : 0;
    const double rise =
      curvature > 0 ? (std::cos(curvature / 2) - 1) / curvature : 0;
    SceneText scene =
      static_frame("0 0; " + text(x) + " " + text(y), "0 1 " + text(rise));
    SceneRun run(
      scene.section(rod.stiffnesses)
        .support("clamp", "0", "clamp")
        .load("tip",
              "1",
              {text(rod.force_x) + " * t", text(rod.force_y) + " * t", "0"})
        .mesh(order, refinements)
        .time(1, 0.25)
        .str());
    run.run();
    const unsigned int n_steps = 400; // 1e-11 accurate, errors are above 1e-6
    const auto         exact   = RodEquation(rod, n_steps)[n_steps];
    return std::hypot(x + run.motion(1, 0) - exact[0],
                      y + run.motion(1, 1) - exact[1]) /
      std::hypot(x - exact[0], y - exact[1]);
  }

  // A formulation that locks in shear (or, curved, in membrane) loses its
  // accuracy with growing slenderness on a given mesh. Here the relative error
  // must be that of the slenderness 100, whatever the order.
  void expect_no_locking(const std::string &name, const double curvature)
  {
    ResultTable table("Error of the tip, " + name + ", by slenderness",
                      {"order", "elements", "10", "100", "1000", "10000"});
    for (const unsigned int order : {1, 2, 3, 4})
      {
        const unsigned int  refinements = order == 1 ? 3 : order == 2 ? 1 : 0;
        std::vector<double> errors;
        for (const double slenderness : {1e1, 1e2, 1e3, 1e4})
          errors.push_back(error_of_tip(slender_rod(slenderness, curvature),
                                        order,
                                        refinements));
        ResultTable::Cells cells = {std::to_string(order),
                                    std::to_string(1 << refinements)};
        for (const double error : errors)
          cells.push_back(formatted("%.3e", error));
        table.row(cells);
        // Stretch and shear are 1e-4 of the bending flexibility at 100, and
        // 1e-2 at 10, where they change solution and error by some percent.
        EXPECT_NEAR(errors[0], errors[1], 0.1 * errors[1]) << "order " << order;
        // Beyond, it is 1e-4 of the error, and round-off: EA L^2/EI is 1.2e9 at
        // 10000, times 1e-16 in the residual.
        EXPECT_NEAR(errors[2], errors[1], 1e-3 * errors[1] + 1e-6);
        EXPECT_NEAR(errors[3], errors[1], 1e-3 * errors[1] + 1e-6);
      }
  }

  TEST(Locking, StraightCantilever)
  {
    expect_no_locking("straight cantilever", 0);
  }

  TEST(Locking, ArcOfACircle)
  {
    expect_no_locking("arc of 57 deg", 1);
  }
} // namespace
