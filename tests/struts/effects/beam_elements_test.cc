#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>



using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // A strip of 2 m, 20 mm and 0.5 mm under a tension of 2 kN.
  constexpr double E = 70e9, A = 0.02 * 0.0005,
                   EI = E * A * 0.0005 * 0.0005 / 12, T = 2000, L = 2;

  SceneText pulled_strip(const unsigned int dimension)
  {
    SceneText scene =
      static_scene().dimension(dimension).frame(dimension == 2 ? "0 0; 2 0"
                                                               : "0 0 0; 2 0 0",
                                                "0 1");
    scene.rectangle("strip", 0.02, 0.0005, {E, 2700, 0.3})
      .set("Effects/Shear flexibility", "off")
      .set("Loads/q/Type", "line")
      .set("Loads/q/Struts", "all")
      .set("Loads/q/Force per length y", "-t")
      .mesh(dimension == 2 ? 5 : 4, dimension + 1)
      .time(1, 0.1);
    if (dimension == 2)
      return scene.support("a", "0", "pin")
        .support("b", "1", "roller x")
        .load("pull", "1", {"2000 * t", "0", "0"});
    return scene.prescribe("a", "0", {"0", "0", "0"}, {"0", "0", "free"})
      .prescribe("b", "1", {"free", "0", "0"}, {"0", "0", "free"})
      .load("pull", "1", {"2000 * t", "0", "0"}, {"0", "0", "0"});
  }
} // namespace

TEST(BeamElements, StayStableInTensionWithoutShearFlexibility)
{
  // The slope at the ends of a tie beam is q / T (L / 2 - 1 / k), k^2 = T / EI.
  const double slope = (L / 2 - std::sqrt(EI / T)) / T;
  for (const unsigned int dimension : {2, 3})
    {
      SCOPED_TRACE(dimension);
      SceneRun run(pulled_strip(dimension));
      run.run();
      EXPECT_NEAR(std::abs(run.motion(0, rotation_z)), slope, 1e-4 * slope);
      const auto findings = findings_of(pulled_strip(dimension), {});
      EXPECT_TRUE(findings.empty()) << verdict_text(findings);
    }
}
