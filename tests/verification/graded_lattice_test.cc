#include <auxfem/analysis/discretization/order_choice.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/recorder.h>

#include <support/scene_text.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "result_table.h"

using namespace auxfem;
using namespace auxfem::testing_support;

// Discretization/Order = auto on a lattice whose struts differ in length.

namespace
{
  constexpr unsigned int n_meshes = 8;
  constexpr double       ratio    = 1.4; ///< of neighbouring meshes

  std::string joint(const unsigned int i, const unsigned int j)
  {
    return std::to_string(j * (n_meshes + 1) + i);
  }

  /** Squares of 120 mm that become larger to the right and to the top, every
   * other one with a diagonal; clamped at the bottom, pushed at the top. */
  SceneText graded_lattice(const std::string &further_joints = "",
                           const std::string &further_struts = "")
  {
    std::vector<double> places(1, 0.);
    for (unsigned int i = 0; i < n_meshes; ++i)
      places.push_back(places.back() + std::pow(ratio, i));
    std::string joints, struts, bottom, top;
    const auto  add = [](std::string &list, const std::string &item) {
      list += (list.empty() ? "" : "; ") + item;
    };
    for (unsigned int j = 0; j <= n_meshes; ++j)
      for (unsigned int i = 0; i <= n_meshes; ++i)
        {
          add(joints,
              text(0.12 * places[i] / places.back()) + " " +
                text(0.12 * places[j] / places.back()));
          if (i < n_meshes)
            add(struts, joint(i, j) + " " + joint(i + 1, j));
          if (j < n_meshes)
            add(struts, joint(i, j) + " " + joint(i, j + 1));
          if (i < n_meshes && j < n_meshes && (i + j) % 2 == 0)
            add(struts, joint(i, j) + " " + joint(i + 1, j + 1));
        }
    for (unsigned int i = 0; i <= n_meshes; ++i)
      {
        bottom += (i == 0 ? "" : ", ") + joint(i, 0);
        top += (i == 0 ? "" : ", ") + joint(i, n_meshes);
      }
    return static_frame(joints + further_joints, struts + further_struts)
      .rectangle("strip", "10 mm", "1 mm", {"2 GPa", "", 0.3})
      .set("Sections/strip/Struts", "all")
      .support("foot", bottom, "clamp")
      .load("push", top, {"0.5 * t", "0", "0"})
      .probe("corner", joint(n_meshes, n_meshes))
      .probe("middle", joint(n_meshes / 2, n_meshes))
      .time(1, 0.25);
  }

  /** The same, its top corner stayed by a strut far longer and more slender
   * than any other, which hangs under a load of its own. */
  SceneText stayed_lattice()
  {
    const std::string corner = joint(n_meshes, n_meshes),
                      anchor = joint(0, n_meshes + 1), stay = "x > 0.121";
    return graded_lattice("; 0.4 0", "; " + corner + " " + anchor)
      .set("Sections/strip/Struts", "x < 0.121")
      .rectangle("wire", "10 mm", "0.5 mm", {"2 GPa", "", 0.3})
      .set("Sections/wire/Struts", stay)
      .support("anchor", anchor, "clamp")
      .set("Loads/push/Force x", "-0.5 * t")
      .set("Loads/weight/Type", "line")
      .set("Loads/weight/Struts", stay)
      .set("Loads/weight/Force per length y", "-2 * t")
      .set("Effects/Contact", "off");
  }

  Scene graded_scene(const SceneText &text)
  {
    return read_scene_from_text(text.str(), "test.prm");
  }

  /** Results of a run. */
  struct GradedOutcome
  {
    std::vector<StrutDivision> divisions;
    unsigned int               unknowns;
    double                     estimate;
    std::vector<double>        motion; ///< of the probes at all times
  };

  GradedOutcome graded_outcome(const Scene          &scene,
                               const ChosenElements &elements = {})
  {
    MemoryRecorder memory(scene, MPI_COMM_WORLD);
    RunPlan        plan(scene);
    plan.elements = elements;
    LatticeRun run(plan, MPI_COMM_WORLD);
    run.run(memory);
    GradedOutcome outcome{run.model.numbering.divisions(),
                          run.model.numbering.layout().n_global(),
                          run.mesh_error()->relative(),
                          {}};
    for (const char *column :
         {"corner.ux", "corner.uy", "middle.ux", "middle.uy"})
      for (const double value : memory.column(column))
        outcome.motion.push_back(value);
    return outcome;
  }

  /** The run with the elements chosen for a tolerance. */
  GradedOutcome chosen_outcome(SceneText text, const double tolerance)
  {
    const Scene scene =
      graded_scene(text.set("Discretization/Order", "auto")
                     .set("Discretization/Tolerance", tolerance));
    Recorder             nobody;
    const ChosenElements chosen =
      choose_elements(scene, MPI_COMM_WORLD, nobody);
    return graded_outcome(scene, chosen);
  }

  double graded_error(const GradedOutcome &outcome, const GradedOutcome &exact)
  {
    double largest = 0, difference = 0;
    for (unsigned int i = 0; i < exact.motion.size(); ++i)
      {
        largest = std::max(largest, std::abs(exact.motion[i]));
        difference =
          std::max(difference, std::abs(outcome.motion[i] - exact.motion[i]));
      }
    return difference / largest;
  }

  /** Orders with numbers of elements, as in `2 + 5 x 12`. */
  std::string elements_text(const std::vector<StrutDivision> &divisions)
  {
    const std::set<StrutDivision> different(divisions.begin(), divisions.end());
    std::string                   text;
    for (const StrutDivision &division : different)
      text += (text.empty() ? "" : " + ") + std::to_string(division.order) +
        (division.n_elements > 1 ? " x " + std::to_string(division.n_elements)
                                 : "");
    return text;
  }

  ResultTable::Cells graded_cells(const std::string   &order,
                                  const GradedOutcome &outcome,
                                  const double         error)
  {
    return {order,
            elements_text(outcome.divisions),
            std::to_string(outcome.unknowns),
            formatted("%.1e", outcome.estimate),
            formatted("%.1e", error)};
  }
} // namespace

TEST(GradedLattice, OrdersThatDifferMeetATolerance)
{
  const GradedOutcome exact =
    graded_outcome(graded_scene(graded_lattice().mesh(6, 1)));
  ResultTable                table("Graded lattice: error of displacements",
                    {"order", "elements", "unknowns", "estimated", "error"});
  std::vector<GradedOutcome> uniform;
  for (unsigned int order = 2; order <= 5; ++order)
    {
      uniform.push_back(
        graded_outcome(graded_scene(graded_lattice().mesh(order))));
      const double error = graded_error(uniform.back(), exact);
      table.row(graded_cells(std::to_string(order), uniform.back(), error));
      // The estimate is an upper bound; that of a graded lattice is a rough
      // one.
      EXPECT_LT(error, uniform.back().estimate);
    }
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7})
    {
      const Scene scene =
        graded_scene(graded_lattice()
                       .set("Discretization/Order", "auto")
                       .set("Discretization/Tolerance", tolerance));
      Recorder             nobody;
      const ChosenElements chosen =
        choose_elements(scene, MPI_COMM_WORLD, nobody);
      const GradedOutcome outcome = graded_outcome(scene, chosen);
      const double        error   = graded_error(outcome, exact);
      table.row(graded_cells("auto to " + formatted("%.0e", tolerance),
                             outcome,
                             error));
      EXPECT_LT(outcome.estimate, tolerance);
      EXPECT_LT(error, tolerance);
      const auto as_good =
        std::find_if(uniform.begin(),
                     uniform.end(),
                     [&](const GradedOutcome &candidate) {
                       return candidate.estimate <= tolerance;
                     });
      ASSERT_TRUE(as_good != uniform.end());
      EXPECT_LT(outcome.unknowns, 0.85 * as_good->unknowns);
    }
}

TEST(GradedLattice, AStayGetsElementsOfItsOwn)
{
  const GradedOutcome exact =
    graded_outcome(graded_scene(stayed_lattice().mesh(6, 5)));
  ResultTable table("Graded lattice with a stay: error of displacements",
                    {"order", "elements", "unknowns", "estimated", "error"});
  std::vector<std::pair<double, unsigned int>> uniform;
  for (const unsigned int order : {3, 4, 6})
    for (unsigned int refinements = 0; refinements <= 3; ++refinements)
      {
        const GradedOutcome outcome = graded_outcome(
          graded_scene(stayed_lattice().mesh(order, refinements)));
        const double error = graded_error(outcome, exact);
        uniform.emplace_back(error, outcome.unknowns);
        table.row(graded_cells(std::to_string(order), outcome, error));
      }
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    {
      const GradedOutcome outcome = chosen_outcome(stayed_lattice(), tolerance);
      const double        error   = graded_error(outcome, exact);
      table.row(graded_cells("auto to " + formatted("%.0e", tolerance),
                             outcome,
                             error));
      EXPECT_LT(outcome.estimate, tolerance);
      EXPECT_LT(error, tolerance);
      // The stay alone is divided.
      for (unsigned int s = 0; s + 1 < outcome.divisions.size(); ++s)
        EXPECT_EQ(outcome.divisions[s].n_elements, 1u) << s;
      EXPECT_GT(outcome.divisions.back().n_elements, 1u);
      // Against equal elements that are as exact, if any are.
      unsigned int least = 0;
      for (const auto &[uniform_error, unknowns] : uniform)
        if (uniform_error <= error && (least == 0 || unknowns < least))
          least = unknowns;
      if (least > 0)
        {
          EXPECT_LT(outcome.unknowns, 0.25 * least) << tolerance;
        }
    }
}
