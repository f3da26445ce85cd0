#include <auxfem/struts/effects/struts.h>

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
  constexpr unsigned int n_steps = 3200; ///< of the reference

  /** An element is compared with the reference at this many points plus one. */
  constexpr unsigned int n_intervals = 10;

  /** Errors of the displacement. */
  struct Error
  {
    double l2;  ///< root of the integral of its square over the strut
    double tip; ///< at the tip
  };

  /** A clamped arc of unit radius and length, bent by loads at its tip. */
  const ClampedRod clamped_arc = {{400, 150, 1}, 1, 1, 2, 2};

  SceneText arc_scene(const unsigned int order, const unsigned int refinements)
  {
    // The arc turns left, so it bulges to the right of its chord.
    SceneText scene =
      static_frame("0 0; " + text(std::sin(1)) + " " + text(1 - std::cos(1)),
                   "0 1 " + text(std::cos(0.5) - 1));
    scene.section(clamped_arc.stiffnesses)
      .support("clamp", "0", "clamp")
      .load("tip",
            "1",
            {text(clamped_arc.force_x) + " * t",
             text(clamped_arc.force_y) + " * t",
             text(clamped_arc.moment) + " * t"})
      .mesh(order, refinements)
      .time(1, 0.1);
    return scene;
  }

  double distance(const auxfem::StrutPoint &point,
                  const RodEquation::Point &exact)
  {
    return std::hypot(point.position[0] + point.displacement[0] - exact[0],
                      point.position[1] + point.displacement[1] - exact[1]);
  }

  Error error_of(const SceneRun &run, const RodEquation &exact)
  {
    Error       error{0, 0};
    const auto &elements = run.model.numbering.elements();
    for (unsigned int e = 0; e < elements.size(); ++e)
      {
        const auto  &interval = elements[e].interval;
        const double length   = interval.end - interval.begin;
        const auto   points =
          run.equations.reporting().struts.front().forces->sample(run.state,
                                                                  e,
                                                                  n_intervals +
                                                                    1);
        for (unsigned int i = 0; i <= n_intervals; ++i)
          {
            const double s = interval.begin + length * i / n_intervals;
            const double d =
              distance(points[i], exact[std::lround(s * n_steps)]);
            // Trapezoidal rule; ends are nodes, where the error is smallest
            const double weight = i == 0 || i == n_intervals ? 0.5 : 1;
            error.l2 += weight * length / n_intervals * d * d;
            if (interval.end == 1 && i == n_intervals)
              error.tip = d;
          }
      }
    error.l2 = std::sqrt(error.l2);
    return error;
  }

  /**
   * Prints errors and observed rates on four meshes; returns the rates of the
   * last two.
   */
  Error observed_rates(const unsigned int order,
                       const unsigned int coarsest,
                       const RodEquation &exact,
                       ResultTable       &table)
  {
    Error before{0, 0}, rate{0, 0};
    for (unsigned int refinements = coarsest; refinements < coarsest + 4;
         ++refinements)
      {
        SceneRun run(arc_scene(order, refinements).str());
        run.run();
        const Error error = error_of(run, exact);
        if (refinements > coarsest)
          rate = {std::log2(before.l2 / error.l2),
                  std::log2(before.tip / error.tip)};
        const auto shown = [&](const double value) {
          return refinements > coarsest ? formatted("%.2f", value) : "";
        };
        table.row({std::to_string(order),
                   std::to_string(1 << refinements),
                   formatted("%.2e", error.l2),
                   shown(rate.l2),
                   formatted("%.2e", error.tip),
                   shown(rate.tip)});
        before = error;
      }
    return rate;
  }

  // Large rotations of a curved, stretching and shearing strut, without
  // boundary layers: Reissner's equation has a smooth solution there, and none
  // of its parts is a polynomial.
  TEST(Convergence, DisplacementOfABentArc)
  {
    const RodEquation exact(clamped_arc, n_steps),
      coarse(clamped_arc, n_steps / 2);
    // The reference's own error, far below all errors compared with it
    EXPECT_NEAR(exact[n_steps][0], coarse[n_steps / 2][0], 1e-13);
    EXPECT_NEAR(exact[n_steps][1], coarse[n_steps / 2][1], 1e-13);
    EXPECT_GT(exact[n_steps][2] - clamped_arc.curvature, 1.5)
      << "not a large rotation";

    ResultTable table("Displacement error of a bent arc, Reissner's equation",
                      {"order",
                       "elements",
                       "error L2 (m)",
                       "rate",
                       "error at the tip (m)",
                       "rate"});
    for (const unsigned int order : {1, 2, 3, 4})
      {
        const unsigned int coarsest = order == 1 ? 2 : order < 4 ? 1 : 0;
        const Error        rate = observed_rates(order, coarsest, exact, table);
        // The interpolation error of order p + 1 dominates; the rate comes from
        // below and is within a tenth on these meshes.
        EXPECT_GT(rate.l2, order + 1 - 0.1) << "order " << order;
        // Nodes converge with the order of p-point Gauss quadrature; for p = 4
        // the last mesh is too near to round-off to rely on.
        if (order < 4)
          {
            EXPECT_GT(rate.tip, 2 * order - 0.2) << "order " << order;
          }
      }
  }
} // namespace
