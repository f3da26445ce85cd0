#include <auxfem/analysis/infinite_lattice/bloch_waves.h>
#include <auxfem/analysis/infinite_lattice/dispersion.h>
#include <auxfem/analysis/infinite_lattice/effective_response.h>
#include <auxfem/analysis/infinite_lattice/elastic_constants.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/mesh/periodic_array.h>

#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Walls of length 1 and t = 0.05 with shear flexibility and rotary inertia,
  // E = rho = 1, nu = 0.3.
  SceneText waves_of(const std::string &lattice,
                     const unsigned int order,
                     const unsigned int refinements = 0)
  {
    return SceneText()
      .set("Analysis", "dispersion")
      .add("Lattice", lattice)
      .rectangle("wall", 1, 0.05, {1, 1, 0.3})
      .set("Effects/Shear flexibility", "on")
      .mesh(order, refinements);
  }

  const std::string lattice_of_squares = "Cell = square | Strut length = 1",
                    lattice_of_stars =
                      "Cell = star | Strut length = 1 | Opening angle = 60 deg",
                    // The primitive cell of the regular hexagons.
    lattice_of_hexagons =
      "Cell = pattern | Joints = 0 0; 0 1 | Struts = 0 1 | "
      "Neighbour struts = inclined: 1 0 at 1 0; inclined: 1 0 at 0 1 | "
      "Vector x = 0.86602540378443865 1.5 | "
      "Vector y = -0.86602540378443865 1.5";

  /** WavesOfLattice of a scene, which lives as long. */
  class WavesOfLattice
  {
  public:
    explicit WavesOfLattice(const SceneText &text)
      : scene(read_scene_from_text(text.str(), "waves.prm"))
      , run(plan_of(scene), MPI_COMM_SELF)
      , bloch(run)
    {}

    std::vector<DampedWave> damped(const double k1, const double k2) const
    {
      return bloch.damped_waves({{2 * pi * k1, 2 * pi * k2, 0}}, 8);
    }

    std::vector<double> frequencies(const double k1, const double k2) const
    {
      std::vector<double> all;
      for (const BlochWave &wave :
           bloch.waves({{2 * pi * k1, 2 * pi * k2, 0}}, 9))
        all.push_back(wave.angular_frequency);
      return all;
    }

    /** Speed of wave @p i at the length @p k of the wave vector along x, by its
     * frequency and by its group velocity. */
    std::array<double, 2> speeds(const double k, const unsigned int i) const
    {
      const double phase = k * run.lattice.periodicity->vectors[0][0];
      const auto   wave  = bloch.waves({{phase, 0, 0}}, i + 1).back();
      return {{wave.angular_frequency / k, (*wave.group_velocity)[0]}};
    }

  private:
    static RunPlan plan_of(const Scene &scene)
    {
      RunPlan plan(scene);
      plan.effects.large_rotation = Switch::off;
      plan.effects.rotary_inertia = Switch::on;
      include_damping(plan.effects);
      return plan;
    }

    const Scene scene;
    LatticeRun  run;
    BlochWaves  bloch;
  };

  struct WaveReference
  {
    std::string         point;
    double              k1, k2;
    std::vector<double> frequencies; ///< rad/s
  };

  /** @param allowed relative difference */
  void compare_waves(const std::string                &title,
                     const SceneText                  &scene,
                     const std::vector<WaveReference> &references,
                     const double                      allowed)
  {
    const WavesOfLattice waves(scene);
    ComparisonTable      table(title + ", exact dynamic stiffness (rad/s)");
    for (const WaveReference &reference : references)
      {
        const auto found = waves.frequencies(reference.k1, reference.k2);
        for (std::size_t i = 0; i < reference.frequencies.size(); ++i)
          {
            const std::string at =
              reference.point + " " + std::to_string(i + 1);
            if (reference.frequencies[i] == 0)
              table.row(at, found[i], 0, 1e-5);
            else
              table.relative(at, found[i], reference.frequencies[i], allowed);
          }
      }
  }
} // namespace

TEST(Dispersion, Square)
{
  compare_waves(
    "Square lattice",
    waves_of(lattice_of_squares, 6, 2),
    {{"Gamma", 0, 0, {0, 0, 0.39152164, 0.39152164, 0.56046146, 0.85656006}},
     {"X",
      0.5,
      0,
      {0.081648315, 0.22034209, 0.31469620, 0.70216576, 0.93897261}},
     {"M", 0.5, 0.5, {0.14185680, 0.31747429, 0.83453562, 0.83453562}}},
    1e-6);
}

TEST(Dispersion, Hexagon)
{
  compare_waves(
    "Hexagonal lattice",
    waves_of(lattice_of_hexagons, 6, 1),
    {{"Gamma", 0, 0, {0, 0, 0.14185680, 0.39152164, 0.39152164, 0.56046146}},
     {"M",
      0.5,
      0,
      {0.037007306, 0.22287852, 0.24710626, 0.31326688, 0.65279076}},
     {"K", 1. / 3, 2. / 3, {0.081648315, 0.21892307, 0.21892307, 0.31469620}}},
    1e-6);
}

TEST(Dispersion, Star)
{
  compare_waves("Star lattice at 60 degrees",
                waves_of(lattice_of_stars, 6),
                {{"Gamma",
                  0,
                  0,
                  {0,
                   0,
                   0.018654428,
                   0.024553243,
                   0.046615645,
                   0.046615645,
                   0.076353765,
                   0.076353765,
                   0.18348102}},
                 {"X",
                  0.5,
                  0,
                  {0.0087925148,
                   0.016897275,
                   0.020823709,
                   0.029103671,
                   0.048281142,
                   0.050627696,
                   0.074726652,
                   0.075929108,
                   0.18659975}},
                 {"M",
                  0.5,
                  0.5,
                  {0.010199921,
                   0.020512955,
                   0.035279327,
                   0.035345100,
                   0.035345100,
                   0.055827606,
                   0.071547638,
                   0.077573023,
                   0.18695494}}},
                1e-5);
}

// Long waves have the speeds of the continuum; the frequency is off by the
// square of the wave vector.
TEST(Dispersion, LongWavesAreThoseOfTheContinuum)
{
  ComparisonTable      table("Long waves of the star lattice along x, roots of "
                             "n.C.n over the density (m/s)");
  const WavesOfLattice waves(waves_of(lattice_of_stars, 4));
  const std::array<double, 2> speeds = {{0.0083684868, 0.0428333889}};
  for (const unsigned int i : {0, 1})
    {
      const double k = 0.05, by_k = waves.speeds(k, i)[0],
                   by_half = waves.speeds(k / 2, i)[0];
      table.relative(i == 0 ? "slow" : "fast",
                     (4 * by_half - by_k) / 3,
                     speeds[i],
                     1e-6);
      EXPECT_NEAR((by_k - speeds[i]) / (by_half - speeds[i]), 4, 0.05);
    }
}

TEST(Dispersion, GroupVelocitiesAreDerivatives)
{
  const WavesOfLattice waves(waves_of(lattice_of_stars, 4));
  const double         k = 0.4, step = 1e-4;
  for (const unsigned int i : {0, 1, 2})
    {
      const double above = waves.speeds(k + step, i)[0] * (k + step),
                   below = waves.speeds(k - step, i)[0] * (k - step);
      EXPECT_NEAR(waves.speeds(k, i)[1], (above - below) / (2 * step), 1e-6);
    }
}

TEST(Dispersion, BandGapsOfTheStar)
{
  const double                     first = 0.142455469; // pinned-pinned strut
  const WavesOfLattice             waves(waves_of(lattice_of_stars, 6));
  std::vector<std::vector<double>> bands;
  for (unsigned int i = 0; i <= 6; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      bands.push_back(waves.frequencies(i / 12., j / 12.));
  const auto gaps = band_gaps(frequency_bands(bands));
  ASSERT_EQ(gaps.size(), 2u);
  ComparisonTable table("Band gaps of the star lattice over the frequency of a "
                        "pinned strut, exact dynamic stiffness");
  EXPECT_EQ(gaps[0].below, 6u);
  EXPECT_EQ(gaps[1].below, 8u);
  table.relative("6-7, begin", gaps[0].lowest / first, 0.39189514, 1e-5);
  table.relative("6-7, end", gaps[0].highest / first, 0.50224564, 1e-5);
  table.relative("8-9, begin", gaps[1].lowest / first, 0.54454226, 1e-5);
  table.relative("8-9, end", gaps[1].highest / first, 1.2879886, 1e-5);
}

namespace
{
  SceneText damped_stars(const unsigned int order)
  {
    return waves_of(lattice_of_stars, order)
      .connector("damper",
                 "kelvin-voigt",
                 "Between = in-cell | Spring stiffness = 1e-4 | "
                 "Damping coefficient = 2e-3");
  }

  struct DampedReference
  {
    double k1, k2;
    /** Decay (1/s) and angular frequency (rad/s). */
    std::vector<std::array<double, 2>> waves;
  };
} // namespace

TEST(Dispersion, DampedStar)
{
  const WavesOfLattice lattice(damped_stars(6));
  ComparisonTable      table("Star lattice with a damper in each cell, complex "
                             "waves, independent code (rad/s)");
  const std::vector<DampedReference> references = {
    {0,
     0.5,
     {{{0, 0.0087925148}},
      {{0, 0.016897275}},
      {{0, 0.020823709}},
      {{0, 0.029103671}},
      {{0, 0.050627696}},
      {{0.015536687, 0.060460821}}}},
    {0.5,
     0.5,
     {{{0, 0.010199921}},
      {{0, 0.020512955}},
      {{0, 0.035345100}},
      {{0, 0.035345100}},
      {{0.0029488243, 0.044621691}},
      {{0.013004472, 0.060377944}}}},
    {0.3,
     0.2,
     {{{5.8925379e-5, 0.016374031}},
      {{1.3490292e-5, 0.019646818}},
      {{0.0011664921, 0.021575059}},
      {{2.7935528e-4, 0.028407787}},
      {{7.6880425e-4, 0.046451062}},
      {{0.0034095062, 0.053907675}},
      {{2.1401308e-5, 0.074056917}},
      {{1.2647386e-5, 0.076797652}}}}};
  for (const DampedReference &reference : references)
    {
      const auto found = lattice.damped(reference.k1, reference.k2);
      ASSERT_GE(found.size(), reference.waves.size());
      for (std::size_t i = 0; i < reference.waves.size(); ++i)
        {
          const auto [decay, frequency] = reference.waves[i];
          const std::string at = "(" + formatted("%g", reference.k1) + ", " +
            formatted("%g", reference.k2) + ") " + std::to_string(i + 1);
          table.relative(at + ", frequency",
                         found[i].angular_frequency,
                         frequency,
                         1e-5);
          table.row(at + ", decay", found[i].decay, decay, 1e-5 * frequency);
        }
    }
}

// Undamped waves are those of the damped problem without dampers.
TEST(Dispersion, DampedWavesWithoutDampersAreWaves)
{
  const WavesOfLattice lattice(waves_of(lattice_of_stars, 3));
  for (const double k : {0., 0.2})
    {
      const auto undamped = lattice.frequencies(k, 0.1);
      const auto damped   = lattice.damped(k, 0.1);
      ASSERT_EQ(damped.size(), 8u);
      for (unsigned int i = 0; i < 8; ++i)
        {
          EXPECT_NEAR(damped[i].angular_frequency, undamped[i], 1e-8);
          EXPECT_NEAR(damped[i].decay, 0, 1e-8);
        }
    }
}

// Long waves about a pressed state have the speeds of its tangent moduli.
TEST(Dispersion, LongWavesAboutAPressedState)
{
  const std::string folder = testing::TempDir() + "waves_of_pressed_stars";
  const double      k      = 1e-3;
  const SceneText   stars =
    waves_of(lattice_of_stars, 5)
      .add("Mean deformation", "Strain xx = -0.03 * t | Strain xy = 0")
      .set("Time/End time", "1")
      .set("Time/Time step", "0.1")
      .set("Dispersion/Path", "0 0; 0.001 0")
      .set("Dispersion/Points", "1")
      .set("Dispersion/Zone points", "2")
      .set("Output/Directory", folder);
  run_dispersion(read_scene_from_text(stars, "pressed.prm"), MPI_COMM_SELF, {});
  std::ifstream       stream(folder + "/dispersion.csv");
  std::string         line, cell;
  std::vector<double> last;
  while (std::getline(stream, line))
    {
      std::istringstream cells(line);
      if (line.front() == 'p')
        continue;
      last.clear();
      while (std::getline(cells, cell, ','))
        last.push_back(std::stod(cell));
    }
  // Columns: path, two parts, two components, frequency of the first band.
  const double period = 2 * (std::sqrt(3.) / 2 + 0.5),
               speed  = last.at(5) / (k / period);

  SceneText pressed = stars;
  pressed.set("Analysis", "effective response").set("Time/Scheme", "static");
  const Scene scene = read_scene_from_text(pressed, "pressed.prm");
  LatticeRun  run(plan_of_response(scene), MPI_COMM_SELF);
  Recorder    nobody;
  run.run(nobody);
  const PeriodTangent tangent(run.equations, run.solution.state);
  const double        density     = 0.0803847577;
  const auto [modulus, direction] = least_acoustic_modulus(*tangent.moduli());
  EXPECT_NEAR(direction[0], 1, 1e-12);
  ComparisonTable table(
    "Star lattice pressed by 3 percent: speed of long waves "
    "along x, root of the acoustic tensor over the density "
    "(m/s)");
  table.relative("slow", speed, std::sqrt(modulus / density), 1e-4);
}
