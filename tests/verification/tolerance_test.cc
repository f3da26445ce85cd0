#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/recorder.h>

#include <gtest/gtest.h>
#include <study/report_cells.h>
#include <support/scene_text.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "result_table.h"

using namespace auxfem;
using namespace auxfem::testing_support;

// The error of the time integration that is asked for is kept, with loads that
// have kinks and jumps, steps that begin far too long, and every kind of part.

namespace
{
  SceneText frame_in(const unsigned int dimension)
  {
    SceneText scene;
    scene.dimension(dimension).set("Lattice/Cell", "frame");
    scene.set("Lattice/Joints",
              dimension == 2 ? "0 0; 1 0; 1 1; 2 1"
                             : "0 0 0; 1 0 0; 1 1 0.3; 2 1 0.3");
    scene.set("Lattice/Struts", "0 1; 1 2; 2 3");
    scene.circle("rod", 0.02, {1e9, 1000, 0.3});
    scene.set("Sections/rod/Stiffness-proportional damping", "1 ms");
    scene.support("clamp", "0", "clamp");
    scene.set("Loads/push/Joints", "3");
    scene.set("Time/Smallest time step", "1 us");
    return scene.mesh(2).time(0.5, 0.05).probe("tip", "3");
  }

  SceneText star_lattice()
  {
    SceneText scene;
    scene.cells("star", 2, 2).set("Lattice/Strut length", "10 mm");
    scene.rectangle("strut", "0.4 mm", "0.4 mm", {"70 GPa", 2700, 0.33});
    scene.connector("damper",
                    "maxwell",
                    "Between = in-cell | Spring stiffness = 200 | Damping "
                    "coefficient = 0.05");
    scene.support("base", "bottom", "clamp");
    scene.set("Loads/push/Joints", "top");
    scene.set("Loads/push/Force y", "-min(t / 3e-3, 1)");
    scene.set("Time/Smallest time step", 1e-9);
    return scene.mesh(2).time("6 ms", "0.1 ms").probe("top", "top");
  }

  /** @p tightest is 10^-tightest. */
  void expect_tolerances_kept(const std::string &name,
                              const SceneText   &scene,
                              const std::string &probe,
                              const unsigned int tightest)
  {
    std::string tried = "1e-2";
    for (unsigned int i = 3; i <= tightest; ++i)
      tried += ", 1e-" + std::to_string(i);
    const StudyReport report = study_of(scene,
                                        {"Study/Refinements=none",
                                         "Study/Time steps=none",
                                         "Study/Relative tolerances=" + tried});
    const auto        tolerances =
      cells_where(report, "relative_tolerance", "role", "run");
    const auto  errors = cells_where(report, probe + ".error", "role", "run");
    const auto  iterations = cells_where(report, "iterations", "role", "run");
    ResultTable table("Error of the time integration, asked for and made, " +
                        name,
                      {"relative tolerance", "error", "iterations"});
    for (std::size_t i = 0; i < errors.size(); ++i)
      {
        table.row({tolerances[i],
                   formatted("%.1e", std::stod(errors[i])),
                   iterations[i]});
        EXPECT_LT(std::stod(errors[i]), 2 * std::stod(tolerances[i])) << name;
        EXPECT_GT(std::stod(errors[i]), std::stod(tolerances[i]) / 5000)
          << name;
      }
    EXPECT_EQ(errors.size(), tightest - 1);
    for (const Finding &finding : report.findings)
      ADD_FAILURE() << name << ": " << finding.text;
  }

  void expect_tolerances_kept_by_newmark(const std::string &name,
                                         const SceneText   &scene,
                                         const std::string &probe)
  {
    expect_tolerances_kept(name,
                           SceneText(scene).set("Newton/Tolerance", "1e-10"),
                           probe,
                           5);
  }

  /** Displacements (m) and rotations (rad) of all nodes at the ends of the
   * scene's steps. */
  class AllMotions : public Recorder
  {
  public:
    void begin(const Equations &equations) override
    {
      rows = equations.model().rows;
    }

    void start(const Solution &solution) override
    {
      states.push_back(solution.state);
    }

    void step(const Solution &solution, const StepReport &) override
    {
      states.push_back(solution.state);
    }

    /** Root mean squares of state @p i, or of what differs in it from @p other:
     * displacements, rotations. */
    std::array<double, 2> sizes(const std::size_t       i,
                                const AllMotions *const other = nullptr) const
    {
      const State &state = states.at(i);
      const auto   mean  = [&](const std::vector<int> &row_numbers) {
        double sum = 0;
        for (const int row : row_numbers)
          {
            const double value = state.displacement[row] -
              (other != nullptr ? other->states.at(i).displacement[row] : 0.);
            sum += value * value;
          }
        return std::sqrt(sum / row_numbers.size());
      };
      if (state.rotations.empty())
        return {{mean(rows.free_translations), mean(rows.free_rotations)}};
      double sum = 0;
      for (std::size_t r = 0; r < state.rotations.size(); ++r)
        {
          const Quaternion &turned = state.rotations[r];
          sum += rotation_vector(
                   other != nullptr
                     ? conjugate(other->states.at(i).rotations[r]) * turned
                     : turned)
                   .norm_square();
        }
      return {{mean(rows.free_translations),
               std::sqrt(sum / rows.free_rotations.size())}};
    }

    /** Largest difference to @p exact over the largest motion. */
    std::array<double, 2> errors(const AllMotions &exact) const
    {
      EXPECT_EQ(states.size(), exact.states.size());
      std::array<double, 2> largest{{0, 0}}, difference{{0, 0}};
      for (std::size_t i = 0; i < states.size(); ++i)
        for (unsigned int c = 0; c < 2; ++c)
          {
            largest[c]    = std::max(largest[c], exact.sizes(i)[c]);
            difference[c] = std::max(difference[c], sizes(i, &exact)[c]);
          }
      return {{difference[0] / largest[0], difference[1] / largest[1]}};
    }

  private:
    std::vector<State> states;
    OwnedRows          rows;
  };

  AllMotions motions_of(SceneText          scene,
                        const std::string &scheme,
                        const unsigned int order,
                        const double       tolerance)
  {
    scene.set("Time/Scheme", scheme).set("Time/Relative tolerance", tolerance);
    if (scheme == "esdirk")
      scene.set("Time/Order of esdirk", order);
    const Scene read = read_scene_from_text(scene.str(), "test.prm");
    AllMotions  motions;
    LatticeRun(read, MPI_COMM_WORLD).run(motions);
    return motions;
  }

  /**
   * Expects the worse error of displacements and rotations, which the tolerance
   * is of, to be at most three times what is asked for, by Newmark's method
   * also at least a twelfth.
   * @param tightest, tightest_of_stages powers of 1/10
   */
  void expect_met_by_all_motions(const std::string &name,
                                 const SceneText   &scene,
                                 const unsigned int tightest,
                                 const unsigned int tightest_of_stages)
  {
    const AllMotions exact =
      motions_of(scene, "esdirk", 4, 0.01 * std::pow(0.1, tightest_of_stages));
    ResultTable table("Error of all motions, asked for and made, " + name,
                      {"scheme",
                       "relative tolerance",
                       "error of displacements",
                       "error of rotations"});
    for (const auto &[scheme, order] :
         {std::pair("newmark", 2), {"esdirk", 3}, {"esdirk", 4}})
      for (unsigned int i = 2;
           i <= (order == 2 ? tightest : tightest_of_stages);
           ++i)
        {
          const double tolerance = std::pow(0.1, i);
          const auto   errors =
            motions_of(scene, scheme, order, tolerance).errors(exact);
          table.row({std::string(scheme) +
                       (order == 2 ? "" : " " + std::to_string(order)),
                     formatted("%.0e", tolerance),
                     formatted("%.1e", errors[0]),
                     formatted("%.1e", errors[1])});
          const double error = std::max(errors[0], errors[1]);
          EXPECT_LT(error, 3 * tolerance) << name << ' ' << scheme << order;
          // Long steps of high order err less than anyone would ask for, and
          // damping of struts takes errors away, of which a part is not known.
          EXPECT_GT(error, tolerance / (order == 2 ? 14 : 2000))
            << name << ' ' << scheme << order;
        }
  }

  /** Checks Newmark's method to 1e-5, Runge-Kutta schemes to 10^-@p tightest. */
  void expect_tolerances_kept_by_all(const std::string &name,
                                     const SceneText   &scene,
                                     const std::string &probe,
                                     const unsigned int tightest)
  {
    expect_tolerances_kept_by_newmark(name, scene, probe);
    for (const char *order : {"3", "4"})
      expect_tolerances_kept(name + ", esdirk of order " + order,
                             SceneText(scene)
                               .set("Time/Scheme", "esdirk")
                               .set("Time/Order of esdirk", order),
                             probe,
                             tightest);
  }
} // namespace

TEST(Tolerance, IsKeptByAFrameInThePlaneUnderARamp)
{
  SceneText scene = frame_in(2);
  scene.set("Loads/push/Force y", "-40 * min(t / 0.2, 1)");
  expect_tolerances_kept_by_all("frame in the plane under a ramp",
                                scene,
                                "tip",
                                7);
}

TEST(Tolerance, IsKeptByAFrameInSpaceUnderATriangularPulse)
{
  SceneText scene = frame_in(3);
  scene.set("Loads/push/Force z", "40 * max(0, 1 - abs(t - 0.1) / 0.1)");
  expect_tolerances_kept_by_all("frame in space under a triangular pulse",
                                scene,
                                "tip",
                                5);
}

TEST(Tolerance, IsKeptByRigidPartsWhoseLoadJumps)
{
  SceneText scene = frame_in(2);
  scene.rigid_part("block", "1", 0.5);
  scene.set("Loads/push/Force y", "if(t < 0.2, -10, 5)");
  // Runge-Kutta schemes have no error estimate with rigid parts.
  expect_tolerances_kept_by_newmark("frame with a rigid part, load that jumps",
                                    scene,
                                    "tip");
}

TEST(Tolerance, IsKeptByAStarLatticeWithMaxwellConnectors)
{
  expect_tolerances_kept_by_all(
    "star lattice with Maxwell connectors under a ramp",
    star_lattice(),
    "top",
    6);
}

TEST(Tolerance, IsMetByAllMotionsTogether)
{
  SceneText damped = frame_in(2);
  damped.set("Loads/push/Force y", "-40 * min(t / 0.2, 1)");
  SceneText undamped = damped;
  undamped.remove("Sections/rod/Stiffness-proportional damping");
  SceneText in_space = frame_in(3);
  in_space.set("Loads/push/Force z", "40 * max(0, 1 - abs(t - 0.1) / 0.1)");
  expect_met_by_all_motions("frame in the plane", damped, 5, 6);
  expect_met_by_all_motions("frame in the plane without damping",
                            undamped,
                            5,
                            6);
  expect_met_by_all_motions("frame in space", in_space, 5, 6);
  expect_met_by_all_motions("star lattice with Maxwell connectors",
                            star_lattice(),
                            4,
                            5);
  // Under four fifths of its buckling load, in steps that turn oscillations by
  // radians.
  SceneText larger = star_lattice();
  larger.set("Lattice/Cells x", 4)
    .set("Lattice/Cells y", 4)
    .set("Connectors/damper/Law", "kelvin-voigt")
    .set("Loads/push/Force y", "-min(t / 10e-3, 1)")
    .set("Time/Smallest time step", 1e-8)
    .time("20 ms", "2 ms");
  expect_met_by_all_motions("star lattice under a large load", larger, 3, 4);
}

TEST(Tolerance, EstimateOfAnImpactIsNotThatOfTheVibrationsOfItsContact)
{
  // A mass of 1 kg above a spring falls with a light stiff foot on a plate. The
  // closed form without the foot: 64.478 N, 7.1711 mm at 0.06 s.
  SceneText scene;
  scene.frame("0 0; 0 .02; 0 .1; 0 .12", "0 1; 2 3")
    .rectangle("s", 0.01, 0.01, {200e9, 10, ""})
    .mass("m", "3", 1)
    .connector("k", "spring", "Spring stiffness = 1e4 | Between = 1 2")
    .prescribe("guide", "all", {"0", "free", "0"})
    .set("Gravity/Acceleration y", -9.81)
    .add("Initial velocities/v", "Joints = all | Velocity y = -0.5")
    .add("Plates/p", "Shape = plane | Position = 0 -0.007 | Normal = 0 1")
    .set("Contact/Stiffness", 1)
    .time(0.06, 1e-4, "newmark")
    .set("Time/Relative tolerance", 1e-4)
    .probe("top", "3");
  const Scene    read = read_scene_from_text(scene, "test.prm");
  MemoryRecorder recorder(read, MPI_COMM_WORLD);
  const auto     result   = LatticeRun(read, MPI_COMM_WORLD).run(recorder);
  const double   position = recorder.column("top.uy").back(),
               error      = std::abs(position - 7.1711e-3) / 7.1711e-3;
  EXPECT_LT(error, 5e-3);
  ASSERT_TRUE(result.time_error.has_value());
  EXPECT_LT(*result.time_error, 5e-3);
}
