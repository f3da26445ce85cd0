#include <auxfem/model/build_lattice.h>
#include <auxfem/model/mass_and_size.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  MassAndSize of(const SceneText &text)
  {
    const Scene scene = read_scene_from_text(text.str(), "test.prm");
    return mass_and_size(scene, build_lattice(scene));
  }

  /** A square frame of 1 m; its struts are 10 mm wide and 20 mm high. */
  SceneText square_frame()
  {
    return frame_scene("0 0; 1 0; 1 1; 0 1", "0 1; 1 2; 2 3; 3 0")
      .rectangle("bar", "10 mm", "20 mm", {1, 1000});
  }
} // namespace

TEST(MassAndSize, CountsStrutsMassesAndSections)
{
  const MassAndSize found = of(square_frame()
                                 .rectangle("thick", "10 mm", "40 mm", {1, 500})
                                 .set("Sections/thick/Struts", "0")
                                 .mass("tip", "2", "0.25"));
  EXPECT_NEAR(*found.mass, 3 * 0.2 + 0.2 + 0.25, 1e-12);
  EXPECT_NEAR(*found.relative_density, (3 * 2e-4 + 4e-4) / 1e-2, 1e-12);
  EXPECT_EQ(found.size, dealii::Point<3>(1, 1, 0));
  const std::vector<std::pair<std::string, unsigned int>> sections =
    {{"bar", 3}, {"thick", 1}};
  EXPECT_EQ(found.struts_of_section, sections);
}

TEST(MassAndSize, GradedSectionsAreCountedAsOne)
{
  const MassAndSize found =
    of(square_frame().set("Sections/bar/Grading", "Height: 1 + strut"));
  EXPECT_NEAR(*found.mass, 0.2 * (1 + 2 + 3 + 4), 1e-12);
  ASSERT_EQ(found.struts_of_section.size(), 1u);
  EXPECT_EQ(found.struts_of_section[0].second, 4u);
}

TEST(MassAndSize, TapersAreIntegrated)
{
  const MassAndSize found =
    of(square_frame().set("Sections/bar/Taper",
                          "Height: 1 - 0.5 * s; Width: 1 - 0.5 * s"));
  // The mean of (1 - s/2)^2 is 7/12.
  EXPECT_NEAR(*found.mass, 0.8 * 7 / 12, 1e-12);
}

// A period of the square lattice has two struts of its length.
TEST(MassAndSize, FillsAPeriodOfAnInfiniteLattice)
{
  const MassAndSize found =
    of(SceneText()
         .set("Analysis", "dispersion")
         .add("Lattice", "Cell = square | Strut length = 1")
         .rectangle("wall", "10 mm", "50 mm", {1, 1000}));
  EXPECT_NEAR(*found.mass, 1, 1e-12);
  EXPECT_NEAR(*found.relative_density, 0.1, 1e-12);
}

TEST(MassAndSize, LeavesOutWhatIsUnknown)
{
  const MassAndSize flat = of(frame_scene("0 0; 1 0", "0 1")
                                .rectangle("bar", "10 mm", "20 mm", {1, 1000}));
  EXPECT_FALSE(flat.relative_density);
  EXPECT_TRUE(flat.mass);
  EXPECT_FALSE(of(square_frame()
                    .set("Time/Scheme", "static")
                    .remove("Sections/bar/Density"))
                 .mass);
}
