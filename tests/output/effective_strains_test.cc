#include <auxfem/equations/equations.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/output/effective_strains.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  /** A frame of four joints; tests set the third coordinates. */
  Scene scene_in(const unsigned int dimension)
  {
    return read_scene_from_text(
      SceneText()
        .dimension(dimension)
        .frame("0 0; 4 0; 4 2; 0 2", "0 1; 1 2; 2 3; 3 0")
        .circle("band", "5 mm", {"70 GPa", "2700 kg/m3"}),
      "test.prm");
  }

  void displace(State              &state,
                const LatticeModel &model,
                const unsigned int  joint,
                const unsigned int  component,
                const double        value)
  {
    state.displacement[model.numbering.joint_unknown(joint, component)] = value;
  }

  using Words = std::vector<std::string>;

  Words names_of(const EffectiveStrains &strains)
  {
    Words names;
    for (const Column &column : strains.columns())
      names.push_back(column.name);
    return names;
  }
} // namespace

TEST(EffectiveStrains, AreDifferencesOfMeansOverTheDistance)
{
  const Scene            scene   = scene_in(2);
  const Lattice          lattice = build_lattice(scene);
  const LatticeModel     model(scene, lattice, MPI_COMM_WORLD);
  const EffectiveStrains strains(model);
  EXPECT_EQ(names_of(strains), (Words{"strain.x", "strain.y"}));

  // Numbers of few binary digits: all is exact.
  State state = Equations(model).initial_state();
  displace(state, model, 1, 0, 0.25);
  displace(state, model, 2, 0, 0.75);
  displace(state, model, 0, 0, -0.5);
  displace(state, model, 2, 1, -0.25);
  displace(state, model, 3, 1, -0.5);
  EXPECT_EQ(strains.values(state),
            (std::vector<double>{(0.5 - -0.25) / 4, -0.375 / 2}));
}

TEST(EffectiveStrains, MeasureUnevenFacesByTheirMeanPlaces)
{
  const Scene scene   = scene_in(3);
  Lattice     lattice = build_lattice(scene);
  // The front is tilted: joints 2 and 3 at z = 1 and 3, two from the back.
  lattice.joints[2][2]        = 1;
  lattice.joints[3][2]        = 3;
  lattice.joint_sets["back"]  = {0, 1};
  lattice.joint_sets["front"] = {2, 3};
  const LatticeModel     model(scene, lattice, MPI_COMM_WORLD);
  const EffectiveStrains strains(model);
  EXPECT_EQ(strains.axes(), (std::vector<unsigned int>{0, 1, 2}));
  State state = Equations(model).initial_state();
  displace(state, model, 3, 2, 1);
  EXPECT_EQ(strains.values(state), (std::vector<double>{0, 0, 0.25}));
}

TEST(EffectiveStrains, OmitAxesWithoutDistantSides)
{
  const Scene scene         = scene_in(3);
  Lattice     lattice       = build_lattice(scene);
  lattice.joint_sets["top"] = lattice.joint_sets["bottom"];
  const LatticeModel     model(scene, lattice, MPI_COMM_WORLD);
  const EffectiveStrains strains(model);
  EXPECT_EQ(names_of(strains), (Words{"strain.x"}))
    << "there is neither back nor front, and top is where bottom is";

  lattice.joint_sets.erase("left");
  expect_parts(input_error_of([&]() { EffectiveStrains::check(lattice); }),
               {"Output/Effective strains = true",
                "left and right, bottom and top",
                "back and front",
                "set Effective strains = false"});
}

TEST(LoadedAxis, IsTheOnlyOneAlongWhichSidesAreLoaded)
{
  const auto axis_of = [](const std::string &subsection,
                          const std::string &entries) {
    const Scene scene = read_scene_from_text(
      SceneText()
        .dimension(3)
        .frame("0 0 0; 4 0 0; 4 2 0; 0 2 0; 0 0 3; 4 0 3; 4 2 3; 0 2 3",
               "0 1; 1 2; 2 3; 3 0; 4 5; 5 6; 6 7; 7 4; 0 4; 1 5; 2 6; 3 7")
        .circle("band", "5 mm", {"70 GPa", "2700 kg/m3"})
        .add(subsection, entries),
      "test.prm");
    return loaded_axis(scene, build_lattice(scene));
  };
  EXPECT_EQ(axis_of("Loads/push", "Joints = front | Force z = t"), 2u);
  EXPECT_EQ(axis_of("Loads/push", "Joints = 1, 5 | Force x = t"), 0u);
  EXPECT_EQ(axis_of("Supports/lid",
                    "Joints = front | Type = prescribed | Displacement z = t"),
            2u);
  EXPECT_EQ(axis_of("Initial velocities/hit", "Joints = top | Velocity y = -1"),
            1u);
  EXPECT_EQ(axis_of("Gravity", "Acceleration z = -9.81"), 2u);
  // Loads along two axes, and shear.
  EXPECT_EQ(axis_of("Loads/push", "Joints = 6 | Force x = t | Force z = t"),
            1u);
  EXPECT_EQ(axis_of("Loads/push", "Joints = top | Force x = t"), 1u);
}

TEST(LargestStrain, HasRatiosForTheLoadedAxis)
{
  LargestStrain largest(2);
  const double  strains[] = {1, 2, -4};
  largest.add(1, {0, 1, 2}, strains);
  EXPECT_EQ(*largest.poissons_ratio(0), 0.25);
  EXPECT_EQ(*largest.poissons_ratio(1), 0.5);
  EXPECT_FALSE(largest.poissons_ratio(2));
}

TEST(LargestStrain, IsThatOfTheLargestStrainAlongY)
{
  LargestStrain                   largest;
  const std::vector<unsigned int> axes = {0, 1, 2};
  const double strains[][3]            = {{0, 0, 0}, {1, -4, 2}, {9, 3, 9}};
  largest.add(0, axes, strains[0]);
  EXPECT_FALSE(largest.poissons_ratio(0)) << "nothing has moved";
  for (unsigned int i = 1; i < 3; ++i)
    largest.add(i, axes, strains[i]);
  EXPECT_EQ(largest.time(), 1);
  EXPECT_EQ(*largest.along(1), -4);
  EXPECT_EQ(*largest.poissons_ratio(0), 0.25);
  EXPECT_EQ(*largest.poissons_ratio(2), 0.5);
}

TEST(LargestStrain, HasNoRatioOfAnAxisWithoutStrain)
{
  LargestStrain largest;
  const double  strains[] = {1, 2};
  largest.add(1, {1, 2}, strains);
  EXPECT_FALSE(largest.poissons_ratio(0));
  EXPECT_EQ(*largest.poissons_ratio(2), -2);

  LargestStrain without_y;
  without_y.add(1, {0, 2}, strains);
  EXPECT_FALSE(without_y.poissons_ratio(0));
  EXPECT_FALSE(without_y.poissons_ratio(2));
}
