#include <auxfem/analysis/infinite_lattice/effective_response.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/output/recorder.h>

#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string response_star =
                      "Cell = star | Strut length = 1 | Opening angle = 60 deg",
                    response_hexagon =
                      "Cell = pattern | Joints = 0 0; 0 1 | Struts = 0 1 | "
                      "Neighbour struts = inclined: 1 0 at 1 0; "
                      "inclined: 1 0 at 0 1 | "
                      "Vector x = 0.86602540378443865 1.5 | "
                      "Vector y = -0.86602540378443865 1.5";

  // Walls of t/L = 0.05, E = 1, nu = 0.3; one second brings the whole strain.
  SceneText response_of(const std::string &lattice,
                        const std::string &deformation,
                        const double       step)
  {
    return SceneText()
      .set("Analysis", "effective response")
      .add("Lattice", lattice)
      .rectangle("wall", 1, 0.05, {1, "", 0.3})
      .add("Mean deformation", deformation)
      .set("Effects/Shear flexibility", "on")
      .set("Effects/Contact", "off")
      .set("Time/Scheme", "static")
      .set("Time/End time", "1")
      .set("Time/Time step", text(step));
  }

  /** Columns of a response. */
  class Response
  {
  public:
    explicit Response(const SceneText &text)
      : scene(read_scene_from_text(text.str(), "response.prm"))
      , rows(scene, MPI_COMM_WORLD)
    {
      result =
        run_effective_response(scene, MPI_COMM_WORLD, rows, std::nullopt);
    }

    double last(const std::string &column) const
    {
      return rows.column(column).back();
    }

    std::vector<double> column(const std::string &name) const
    {
      return rows.column(name);
    }

    RunResult result;

  private:
    const Scene    scene;
    MemoryRecorder rows;
  };

  struct FiniteStrainReference
  {
    double strain, stress, lateral, stress_without_shear, lateral_without_shear;
  };

  void
  compare_finite_strains(const std::string                        &title,
                         const std::string                        &lattice,
                         const char                                along,
                         const std::vector<FiniteStrainReference> &references)
  {
    ComparisonTable table(
      title +
      ", lateral stress free: rods by shooting, independent "
      "code");
    const std::string axis(2, along), across(2, along == 'x' ? 'y' : 'x');
    for (const FiniteStrainReference &reference : references)
      for (const bool has_shear : {true, false})
        {
          const Response response(
            response_of(lattice,
                        "Strain xy = 0 | Strain " + axis + " = " +
                          text(reference.strain) + " * t | Stability waves = 0",
                        0.05)
              .set("Effects/Shear flexibility", has_shear ? "on" : "off")
              // Without shear elements converge more slowly.
              .mesh(6, has_shear ? 1 : 3));
          const std::string at =
            text(reference.strain) + (has_shear ? ", shear: " : ": ");
          table.relative(at + "stress",
                         response.last("stress_" + axis),
                         has_shear ? reference.stress
                                   : reference.stress_without_shear,
                         1e-6);
          table.row(at + "lateral strain",
                    response.last("strain_" + across),
                    has_shear ? reference.lateral
                              : reference.lateral_without_shear,
                    2e-7);
        }
  }

  /** Losses of stability along a path, with @p n wave vectors along each
   * reciprocal vector. */
  std::vector<StabilityLoss> losses_of(const SceneText   &text,
                                       const unsigned int n)
  {
    const Scene   scene = read_scene_from_text(text.str(), "stability.prm");
    LatticeRun    run(plan_of_response(scene), MPI_COMM_WORLD);
    Recorder      nobody;
    WaveStability stability(n, scene.context.dimension);
    const auto    record = [&]() {
      stability.record(run.solution.state.time,
                       PeriodTangent(run.equations, run.solution.state),
                       mean_strains_and_stresses(run.model, run.solution.state),
                       MPI_COMM_WORLD);
    };
    run.prepare();
    record();
    while (run.solution.state.time < scene.time.end_time)
      {
        run.advance(nobody);
        record();
      }
    return stability.losses();
  }

  struct LossReference
  {
    std::array<double, 2> wave;
    double                strain, stress, lateral;
    double                allowed = 1e-7; ///< of strains
  };

  /** The loss against a wave; a long wave if @p wave is no wave vector. */
  const StabilityLoss *find_loss(const std::vector<StabilityLoss> &losses,
                                 const StabilityLoss::Kind         kind,
                                 const std::array<double, 2>      &wave)
  {
    const auto found =
      std::find_if(losses.begin(), losses.end(), [&](const auto &loss) {
        return loss.kind == kind && std::abs(loss.wave[0] - wave[0]) < 1e-9 &&
          std::abs(loss.wave[1] - wave[1]) < 1e-9;
      });
    return found == losses.end() ? nullptr : &*found;
  }

  void compare_losses(const std::string                &title,
                      const std::vector<StabilityLoss> &losses,
                      const StabilityLoss::Kind         kind,
                      const unsigned int                axis,
                      const std::vector<LossReference> &references)
  {
    ComparisonTable table(title);
    for (const LossReference &reference : references)
      {
        const std::string at = std::string(name_of(kind)) + " (" +
          formatted("%.4g", reference.wave[0]) + ", " +
          formatted("%.4g", reference.wave[1]) + "): ";
        const StabilityLoss *loss = find_loss(losses, kind, reference.wave);
        ASSERT_NE(loss, nullptr) << at;
        const unsigned int along = 3 * axis, across = 3 - along;
        table.row(at + "strain",
                  loss->values[along],
                  reference.strain,
                  reference.allowed);
        table.relative(at + "stress",
                       loss->values[4 + along],
                       reference.stress,
                       20 * reference.allowed);
        table.row(at + "lateral strain",
                  loss->values[across],
                  reference.lateral,
                  2 * reference.allowed);
      }
  }
} // namespace

TEST(EffectiveResponse, StarAtFiniteStrain)
{
  compare_finite_strains(
    "Star lattice at 60 degrees along x",
    response_star,
    'x',
    {{-0.20, -2.597000e-05, -0.1900962, -2.617845e-05, -0.1900563},
     {-0.05, -5.540191e-06, -0.0319436, -5.577604e-06, -0.0318467},
     {0.10, 9.188746e-06, 0.0413678, 9.246518e-06, 0.0411661},
     {0.20, 1.726195e-05, 0.0619148, 1.737273e-05, 0.0615257}});
}

TEST(EffectiveResponse, HexagonAtFiniteStrain)
{
  compare_finite_strains(
    "Hexagonal lattice along x",
    response_hexagon,
    'x',
    {{-0.20, -3.017886e-05, 0.1396674, -3.038806e-05, 0.1395891},
     {0.10, 7.076300e-05, -0.1353854, 7.176658e-05, -0.1356180}});
  compare_finite_strains(
    "Hexagonal lattice along y",
    response_hexagon,
    'y',
    {{-0.20, -4.627979e-05, 0.1189442, -4.662870e-05, 0.1187741},
     {0.20, 1.134036e-04, -0.3272904, 1.148104e-04, -0.3279862}});
}

TEST(EffectiveResponse, StarLosesStabilityByLongWaves)
{
  const SceneText star =
    response_of(response_star, "Strain xx = -0.1 * t | Strain xy = 0", 0.02)
      .mesh(5, 1);
  const std::string title =
    "Star lattice pressed along x, losses of stability: "
    "Bloch waves and acoustic tensor, independent code";
  using Kind                              = StabilityLoss::Kind;
  const std::vector<StabilityLoss> losses = losses_of(star, 12);
  EXPECT_EQ(losses.front().kind, Kind::long_wave);
  compare_losses(title + ", long wave",
                 losses,
                 Kind::long_wave,
                 0,
                 {{{{1, 0}}, -0.039085556, -4.2564721e-6, -0.024160914}});
  compare_losses(title + ", twelfths",
                 losses,
                 Kind::wave,
                 0,
                 {{{{0.25, 0}}, -0.049457538, -5.4753202e-6, -0.031545136},
                  {{{1. / 3, 0}}, -0.055449239, -6.1981782e-6, -0.036016585},
                  {{{0.5, 0}}, -0.062265146, -7.0376053e-6, -0.041293978},
                  {{{0.5, 0.5}}, -0.076183768, -8.8093055e-6, -0.052730499},
                  {{{0, 0}}, -0.096339563, -1.1509522e-5, -0.070953677, 5e-7}});
  compare_losses(title + ", tenths",
                 losses_of(star, 10),
                 Kind::wave,
                 0,
                 {{{{0.1, 0}}, -0.040935988, -4.4709667e-6, -0.025446091},
                  {{{0.2, 0}}, -0.046056850, -5.0712151e-6, -0.029075156}});
}

TEST(EffectiveResponse, HexagonLosesStabilityByShortWaves)
{
  const SceneText hexagon =
    response_of(response_hexagon, "Strain yy = -0.19 * t | Strain xy = 0", 0.02)
      .mesh(5, 1);
  const std::vector<StabilityLoss> losses = losses_of(hexagon, 12);
  const std::string                title = "Hexagonal lattice pressed along y, "
                                           "losses of stability: Bloch waves and "
                                           "acoustic tensor, independent code";
  using Kind                             = StabilityLoss::Kind;
  compare_losses(
    title,
    losses,
    Kind::wave,
    1,
    {{{{0.5, 0.5}}, -0.108006351, -2.6623230e-5, 0.082360648},
     {{{1. / 3, 1. / 3}}, -0.122573846, -2.9819978e-5, 0.090061673},
     {{{0.25, 0.25}}, -0.139426889, -3.3460149e-5, 0.098050161}});
  const StabilityLoss *wave = find_loss(losses, Kind::long_wave, {{0, 1}});
  ASSERT_NE(wave, nullptr);
  ComparisonTable table(title + ", long wave");
  table.row("strain", wave->values[3], -0.1842282, 1e-6);
  table.relative("stress", wave->values[7], -4.295818e-5, 1e-5);
  table.row("lateral strain", wave->values[0], 0.1146534, 1e-6);
}

// The tangent is the derivative of the response: by central differences.
TEST(EffectiveResponse, TangentsAreDerivatives)
{
  const double    step = 0.01, rate = -0.1;
  const SceneText star =
    response_of(response_star, "Strain xx = -0.1 * t", step).mesh(4);
  const Scene scene = read_scene_from_text(star.str(), "tangent.prm");
  LatticeRun  run(plan_of_response(scene), MPI_COMM_WORLD);
  Recorder    nobody;
  const auto  mean = [&run]() {
    return mean_strains_and_stresses(run.model, run.solution.state);
  };
  run.prepare();
  for (unsigned int i = 0; i < 20; ++i)
    run.advance(nobody);
  const std::vector<double> before = mean();
  run.advance(nobody);
  const PeriodTangent tangent(run.equations, run.solution.state);
  run.advance(nobody);
  const std::vector<double> after = mean();
  ASSERT_TRUE(tangent.moduli().has_value());
  // Lower shear is held.
  const auto along =
    uniaxial_tangent(*tangent.moduli(), {false, false, true, false}, 0);
  ASSERT_TRUE(along.has_value());
  const double change = 2 * step * rate;
  EXPECT_NEAR(along->modulus,
              (after[4] - before[4]) / change,
              1e-5 * along->modulus);
  EXPECT_NEAR(along->poissons_ratios[1],
              -(after[3] - before[3]) / change,
              1e-5);
  // Nominal moduli have the major symmetry of an energy.
  const auto &L = *tangent.moduli();
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < i; ++j)
      EXPECT_NEAR(L(i, j), L(j, i), 1e-10 * L.linfty_norm());
}

namespace
{
  /** The hexagons in space: joints in the plane, posts across it between the
   * periods, which the in-plane strain does not load. */
  SceneText hexagons_in_space(const double strain, const double step)
  {
    return SceneText()
      .dimension(3)
      .set("Analysis", "effective response")
      .add("Lattice",
           "Cell = pattern | Joints = 0 0 0; 0 1 0 | Struts = 0 1 | "
           "Neighbour struts = inclined: 1 0 at 1 0 0; inclined: 1 0 at 0 1 0; "
           "posts: 0 0 at 0 0 1; posts: 1 1 at 0 0 1 | "
           "Vector x = 0.86602540378443865 1.5 0 | "
           "Vector y = -0.86602540378443865 1.5 0 | Vector z = 0 0 1")
      .rectangle("wall", 1, 0.05, {1, "", 0.3})
      .set("Sections/wall/Reference vector", "0 0 1")
      .set("Sections/wall/Struts", "z < 0.25")
      .rectangle("post", 0.05, 0.05, {1, "", 0.3})
      .set("Sections/post/Struts", "posts")
      .add("Mean deformation",
           "Strain xy = 0 | Strain xz = 0 | Strain yz = 0 | Strain xx = " +
             text(strain) + " * t | Stability waves = 0")
      .set("Effects/Shear flexibility", "on")
      .set("Effects/Contact", "off")
      .set("Time/Scheme", "static")
      .set("Time/End time", "1")
      .set("Time/Time step", text(step));
  }
} // namespace

TEST(EffectiveResponse, PlanarCellsInSpace)
{
  ComparisonTable table(
    "Hexagonal lattice in space along x, lateral stress "
    "free: rods by shooting in the plane, independent code");
  const Response response(hexagons_in_space(-0.2, 0.05).mesh(4, 2));
  table.relative("stress", response.last("stress_xx"), -3.017886e-05, 2e-6);
  table.row("lateral strain", response.last("strain_yy"), 0.1396674, 2e-7);
}

// The work of the mean stress is the energy of the struts, with joints of the
// period that turn by large angles.
TEST(EffectiveResponse, StressDoesTheWorkInSpace)
{
  const double    step = 0.02;
  const SceneText star =
    SceneText()
      .dimension(3)
      .set("Analysis", "effective response")
      .add("Lattice", "Cell = space star | Strut length = 1")
      .circle("strut", 0.05, {1, "", 0.3})
      .add("Mean deformation",
           "Strain xx = 0.1 * t | Strain xy = 0.4 * t | Stability waves = 0")
      .set("Effects/Contact", "off")
      .set("Time/Scheme", "static")
      .set("Time/End time", "1")
      .set("Time/Time step", text(step));
  const Response            response(star);
  const std::vector<double> normal = response.column("stress_xx"),
                            shear  = response.column("stress_xy"),
                            energy = response.column("strain");
  // Simpson's rule over pairs of steps.
  double work = 0;
  for (std::size_t i = 2; i < energy.size(); i += 2)
    for (const auto &[stress, rate] :
         {std::pair(normal, 0.1), std::pair(shear, 0.4)})
      work += rate * step / 3 * (stress[i - 2] + 4 * stress[i - 1] + stress[i]);
  const Scene  scene  = read_scene_from_text(star.str(), "volume.prm");
  const double volume = LatticeRun(plan_of_response(scene), MPI_COMM_WORLD)
                          .lattice.periodicity->volume();
  ComparisonTable table("Space star sheared by 0.4 and stretched by 0.1: work "
                        "of the mean stress over the energy of the struts");
  table.row("work / energy", volume * work / energy.back(), 1, 1e-6);
}
