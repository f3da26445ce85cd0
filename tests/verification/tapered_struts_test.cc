#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>
#include <string>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Cantilevers whose height or diameter falls to a half at their tips, against
// closed forms of Timoshenko's beam and published frequencies.

namespace
{
  constexpr double taper_length = 2, taper_size = 0.1, taper_modulus = 2e9,
                   taper_density = 1000;

  SceneText tapered_cantilever(const unsigned int dimension)
  {
    return SceneText()
      .dimension(dimension)
      .frame(dimension == 2 ? "0 0; 2 0" : "0 0 0; 2 0 0", "0 1")
      .support("wall", "0", "clamp")
      .set("Effects/Large rotation", "off");
  }

  /** A strip 0.1 m wide, whose height falls from 0.1 m. */
  SceneText tapered_strip()
  {
    return tapered_cantilever(2)
      .rectangle("strip",
                 taper_size,
                 taper_size,
                 {taper_modulus, taper_density, 0})
      .set("Sections/strip/Taper", "Height: 1 - s / 2");
  }

  /** A rod in space, whose radius falls from 0.1 m. */
  SceneText tapered_cone()
  {
    return tapered_cantilever(3)
      .circle("cone", taper_size, {taper_modulus, taper_density, 0})
      .set("Sections/cone/Taper", "Radius: 1 - s / 2");
  }

  double taper_tip_deflection(SceneText          scene,
                              const unsigned int refinements,
                              const std::string &force)
  {
    SceneRun run(scene.add("Loads/tip", "Joints = 1 | " + force + " = 1")
                   .mesh(3, refinements)
                   .time(1, 1, "static"));
    run.run();
    return run.motion(1, 1);
  }
} // namespace

TEST(TaperedStruts, TipsDeflectByTheIntegralOfTheirCompliance)
{
  // The integral of (1 - s)^2 / (1 - s/2)^3 is 8 log 2 - 5, that of
  // (1 - s)^2 / (1 - s/2)^4 is 2/3; those of shear 1 / (1 - s/2) and its
  // square.
  const double strip_exact = std::pow(taper_length, 3) * (8 * std::log(2) - 5) /
      (taper_modulus * std::pow(taper_size, 4) / 12) +
    taper_length * 2 * std::log(2) /
      (taper_modulus / 2 * 5 / 6 * taper_size * taper_size);
  const double shear_area = 6. / 7 * pi * taper_size * taper_size,
               cone_exact = std::pow(taper_length, 3) * 2 / 3 /
      (taper_modulus * pi / 4 * std::pow(taper_size, 4)) +
    taper_length * 2 / (taper_modulus / 2 * shear_area);
  ComparisonTable table("Tapered cantilevers with a tip force");
  for (const auto &[name, scene, exact] :
       {std::tuple("strip", tapered_strip(), strip_exact),
        std::tuple("cone", tapered_cone(), cone_exact)})
    {
      const double coarse =
                     taper_tip_deflection(scene, 2, "Force y") / exact - 1,
                   fine = taper_tip_deflection(scene, 3, "Force y") / exact - 1;
      table.row(std::string(name) + ", error with 8 elements", fine, 0, 1e-2);
      table.row(std::string(name) + ", order in their length",
                std::log2(coarse / fine),
                2,
                0.1);
    }
}

TEST(TaperedStruts, FrequenciesAreThePublishedOnes)
{
  // Downs, J. Appl. Mech. 44 (1977): wedge without shear and rotary inertia,
  // over sqrt(E I / rho A) / L^2 of the root.
  const Scene scene =
    read_scene_from_text(tapered_strip()
                           .set("Analysis", "modes")
                           .set("Effects/Shear flexibility", "off")
                           .set("Effects/Rotary inertia", "off")
                           .mesh(4, 6)
                           .str(),
                         "test.prm");
  LatticeRun run(plan_of_modes(scene), MPI_COMM_SELF);
  run.prepare();
  run.start();
  const NaturalModes found = natural_modes(run.solver(), run.solution.state, 4);
  const double       unit  = std::sqrt(taper_modulus / taper_density / 12) *
    taper_size / (taper_length * taper_length);
  ComparisonTable table("Frequencies of a tapered cantilever");
  unsigned int    i = 0;
  for (const double published : {3.82379, 18.3173, 47.2649})
    {
      table.relative("frequency " + std::to_string(i + 1),
                     found.modes[i].angular_frequency() / unit,
                     published,
                     5e-4);
      ++i;
    }
}

TEST(TaperedStruts, WeighWhatTheirVolumeDoes)
{
  // Frustum: pi L r^2 (1 + 1/2 + 1/4) / 3.
  SceneRun run(tapered_cone()
                 .set("Gravity/Acceleration z", -10)
                 .mesh(2, 3)
                 .time(1, 1, "static"));
  run.run();
  const double weight =
    10 * taper_density * pi * taper_length * taper_size * taper_size * 7 / 12;
  ComparisonTable table("Weight of a cone");
  table.relative("support", run.reaction("wall", 2), weight, 1e-3);
}
