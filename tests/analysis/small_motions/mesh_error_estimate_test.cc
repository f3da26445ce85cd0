#include <auxfem/analysis/small_motions/mode_errors.h>
#include <auxfem/analysis/small_motions/modes.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A clamped steel bar of 1 m and 10 mm under compression. */
  SceneText clamped_bar()
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("steel", "10 mm", "10 mm", {"210 GPa", 7850, 0.3})
      .support("A", "0", "clamp")
      .prescribe("B", "1", {"-0.001 * t", "0", "0"})
      .time(1, 1);
  }

  SceneText loaded_star(const unsigned int n_cells = 3)
  {
    SceneText star;
    star.cells("star", n_cells, n_cells)
      .rectangle("s", "0.4 mm", "0.4 mm", {"70 GPa", "2700 kg/m3", 0.33})
      .connector("spring",
                 "spring",
                 "Between = in-cell | Spring stiffness = 200 N/m")
      .load("pressure", "top", {"0", "-0.2", "0"})
      .support("foot", "bottom", "clamp")
      .time(1, 0.1);
    return star;
  }

  /** Modes of either kind with their errors. */
  template <class Modes, class Find>
  Modes with_errors(const SceneText &text,
                    MeshErrors      &errors,
                    const Find      &find,
                    const MPI_Comm   communicator)
  {
    const Scene scene = read_scene_from_text(text.str(), "test.prm", {});
    LatticeRun  run(plan_of_modes(scene), communicator);
    run.prepare();
    if (run.model.plan.time.static_start)
      run.start();
    Modes found = find(run);
    errors      = estimate_errors(run, found);
    return found;
  }

  NaturalModes natural(SceneText      text,
                       MeshErrors    &errors,
                       const MPI_Comm communicator = MPI_COMM_SELF)
  {
    return with_errors<NaturalModes>(
      text.set("Analysis", "modes"),
      errors,
      [](LatticeRun &run) {
        return natural_modes(run.solver(),
                             run.solution.state,
                             run.scene.modes.number);
      },
      communicator);
  }

  BucklingModes buckling(SceneText      text,
                         MeshErrors    &errors,
                         const MPI_Comm communicator = MPI_COMM_SELF)
  {
    return with_errors<BucklingModes>(
      text.set("Analysis", "buckling"),
      errors,
      [](LatticeRun &run) {
        return buckling_modes_of(run, run.scene.modes.number, "test");
      },
      communicator);
  }

  /** Expects the estimate to be @p error within a factor of three. */
  void expect_estimate(const double estimate, const double error)
  {
    constexpr double round_off = 1e-8;
    if (error < round_off)
      return;
    EXPECT_LT(estimate, 3 * error);
    EXPECT_GT(estimate, error / 3);
  }
} // namespace

TEST(MeshChoice, FrequencyErrorsMatchFinerElements)
{
  MeshErrors         errors;
  SceneText          bar   = clamped_bar().set("Modes/Number", 3);
  const NaturalModes exact = natural(bar.mesh(6, 3), errors);
  EXPECT_LT(errors.largest(), 1e-8);
  for (const auto &[order, refinements] :
       {std::pair(3, 0), std::pair(3, 1), std::pair(2, 2), std::pair(5, 0)})
    {
      SCOPED_TRACE(order);
      const NaturalModes found = natural(bar.mesh(order, refinements), errors);
      for (unsigned int i = 0; i < 2; ++i)
        {
          SCOPED_TRACE(i);
          const double error = std::abs(found.modes[i].angular_frequency() /
                                          exact.modes[i].angular_frequency() -
                                        1);
          if (error < 0.3)
            expect_estimate(found.modes[i].mesh_error, error);
          else
            EXPECT_GT(found.modes[i].mesh_error, 0.3);
        }
    }
}

TEST(MeshChoice, BucklingErrorsMatchClosedForm)
{
  // P + P^2 / kGA = 4 pi^2 EI / L^2 (Engesser 1889) by the force EA u / L.
  constexpr double E = 210e9, A = 1e-4, kGA = 5. / 6 * A * E / 2.6;
  const double     euler = 4 * M_PI * M_PI * E * A * A / 12,
               exact     = kGA / 2 * (std::sqrt(1 + 4 * euler / kGA) - 1) /
    (E * A * 1e-3);
  for (const auto &[order, refinements] :
       {std::pair(2, 1), std::pair(3, 0), std::pair(2, 2), std::pair(3, 1)})
    {
      SCOPED_TRACE(order);
      MeshErrors          errors;
      const BucklingModes found =
        buckling(clamped_bar().set("Modes/Number", 1).mesh(order, refinements),
                 errors);
      const double error = std::abs(found.modes[0].factor / exact - 1);
      if (error < 0.6)
        expect_estimate(found.modes[0].mesh_error, error);
      else
        EXPECT_GT(found.modes[0].mesh_error, 0.3);
    }
}

TEST(MeshChoice, LoadedLatticeErrorsMatchFinerElements)
{
  MeshErrors errors;
  SceneText  star = loaded_star()
                     .set("Modes/Number", 12)
                     .set("Modes/About", "static equilibrium");
  const NaturalModes exact = natural(star.mesh(6, 2), errors);
  const NaturalModes found = natural(star.mesh(2, 0), errors);
  ASSERT_EQ(found.modes.size(), exact.modes.size());
  for (unsigned int i = 0; i < found.modes.size(); ++i)
    {
      SCOPED_TRACE(i);
      expect_estimate(found.modes[i].mesh_error,
                      std::abs(found.modes[i].angular_frequency() /
                                 exact.modes[i].angular_frequency() -
                               1));
    }
}

TEST(MeshChoiceOnRanks, ErrorsAreTheSame)
{
  constexpr double round_off = 1e-9;
  for (const unsigned int order : {1, 2, 3})
    {
      SCOPED_TRACE(order);
      SceneText  star = loaded_star().set("Modes/Number", 3).mesh(order);
      MeshErrors on_ranks, on_one;
      natural(star, on_ranks, MPI_COMM_WORLD);
      natural(star, on_one);
      for (unsigned int i = 0; i < 3; ++i)
        EXPECT_NEAR(on_ranks.relative[i],
                    on_one.relative[i],
                    (order == 1 ? 0.1 : 1e-3) * on_one.relative[i] + round_off);
      SceneText rigid = loaded_star(1)
                          .rigid_part("edge", "edges", "0.1 g")
                          .set("Rigid parts/edge/Parts", "single struts")
                          .set("Modes/Number", 12)
                          .mesh(order);
      natural(rigid, on_ranks, MPI_COMM_WORLD);
      natural(rigid, on_one);
      for (unsigned int i = 0; i < 12 && order > 1; ++i)
        EXPECT_NEAR(on_ranks.relative[i],
                    on_one.relative[i],
                    1e-3 * on_one.relative[i] + 1e-6);
      buckling(star, on_ranks, MPI_COMM_WORLD);
      buckling(star, on_one);
      for (unsigned int i = 0; i < 3; ++i)
        EXPECT_NEAR(on_ranks.relative[i],
                    on_one.relative[i],
                    (order == 1 ? 0.1 : 1e-3) * on_one.relative[i] + round_off);
    }
}

TEST(MeshChoice, DetectsMissingModes)
{
  // One slender strut beside a stiff one: its modes need more elements.
  SceneText frame;
  frame.frame("0 0; 1 0; 0 1; 0.1 1", "0 1; 2 3")
    .set("Sections/slender/Struts", "0")
    .rectangle("slender", "10 mm", "10 mm", {"210 GPa", 7850, 0.3})
    .set("Sections/stiff/Struts", "1")
    .rectangle("stiff", "10 mm", "30 mm", {"210 GPa", 7850, 0.3})
    .support("A", "0, 2", "clamp")
    .set("Modes/Number", 4)
    .mesh(2)
    .time(1, 1);
  MeshErrors errors;
  natural(frame, errors);
  EXPECT_GT(errors.n_missing + (errors.largest() > 0.1 ? 1 : 0), 0u);
}

TEST(MeshChoice, ElementsFollowTheDispersion)
{
  Scene scene;
  scene.context.dimension = 2;
  // (3! / 6!)^2 / 7 = 9.9e-6, (2! / 4!)^2 / 5 = 1.4e-3
  scene.discretization.tolerance = 1e-4;
  RunPlan plan(scene);
  choose_elements(/*phase=*/1, 1.1e-5, plan);
  EXPECT_EQ(plan.division, (StrutDivision{3, 1}));
  choose_elements(/*phase=*/1, 2e-3, plan);
  EXPECT_EQ(plan.division, (StrutDivision{2, 1}));
  const RunPlan first = plan;
  MeshErrors    errors;
  errors.relative = {1e-2, 1e-3};
  EXPECT_FALSE(elements_accepted(scene, errors));
  ASSERT_TRUE(refine_elements(first, errors, plan));
  EXPECT_GT(plan.division.n_inner_nodes(), 1u);
  errors.relative = {1e-5};
  EXPECT_TRUE(elements_accepted(scene, errors));
  errors.n_missing = 1;
  EXPECT_FALSE(elements_accepted(scene, errors));
}

TEST(MeshChoice, PrescribedElementsAreJudged)
{
  Scene      scene;
  MeshErrors errors;
  errors.relative = {1e-3};
  EXPECT_TRUE(mesh_findings(scene, errors, "frequencies").empty());
  errors.relative = {2e-2};
  EXPECT_EQ(verdict_of(mesh_findings(scene, errors, "frequencies")),
            Verdict::doubtful);
  errors.relative = {0.5};
  EXPECT_EQ(verdict_of(mesh_findings(scene, errors, "frequencies")),
            Verdict::not_to_be_used);
  errors.relative  = {1e-3};
  errors.n_missing = 2;
  EXPECT_EQ(verdict_of(mesh_findings(scene, errors, "frequencies")),
            Verdict::not_to_be_used);
}
