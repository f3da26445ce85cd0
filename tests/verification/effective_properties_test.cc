#include <auxfem/analysis/infinite_lattice/effective_properties.h>

#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>
#include <string>
#include <vector>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Stiffness of a cell of the library: references have about ten digits and
   * come from an independent code for periodic frames. */
  struct PlaneReference
  {
    std::string cell, sizes;
    bool        has_shear;
    double      density, C11, C22, C12, C66;
    double      allowed = 5e-8; ///< relative to C11; eight printed digits
  };

  // E = 1, nu = 0.3, walls of t = 0.05, unit depth.
  const double curved = 1e-6;

  const std::vector<PlaneReference> plane_references = {
    {"square", "Strut length = 1", false, 0.1, 0.05, 0.05, 0, 6.25e-05},
    {"square", "Strut length = 1", true, 0.1, 0.05, 0.05, 0, 6.2016273e-05},
    {"triangular",
     "Strut length = 1",
     false,
     0.173205081,
     0.065006032,
     0.065006032,
     0.021596509,
     0.021704762},
    {"triangular",
     "Strut length = 1",
     true,
     0.173205081,
     0.065005613,
     0.065005613,
     0.021596927,
     0.021704343},
    {"kagome",
     "Strut length = 1",
     false,
     0.0866025404,
     0.032489484,
     0.032489484,
     0.010811786,
     0.010838849},
    {"kagome",
     "Strut length = 1",
     true,
     0.0866025404,
     0.032489432,
     0.032489432,
     0.010811838,
     0.010838797},
    {"hexagonal",
     "Vertical length = 1 | Inclined length = 1",
     false,
     0.0577350269,
     0.014505746,
     0.014505746,
     0.014361768,
     7.1988812e-05},
    {"hexagonal",
     "Vertical length = 1 | Inclined length = 1",
     true,
     0.0577350269,
     0.01450519,
     0.01450519,
     0.014362324,
     7.1433024e-05},
    {"re-entrant",
     "Vertical length = 2 | Inclined length = 1",
     false,
     0.0769800359,
     0.01093766,
     0.010865761,
     -0.010757912,
     1.0825318e-05},
    {"re-entrant",
     "Vertical length = 2 | Inclined length = 1",
     true,
     0.0769800359,
     0.010936794,
     0.010865449,
     -0.010758432,
     1.0791648e-05},
    {"double arrowhead",
     "Half width = 1",
     false,
     0.13660254,
     0.008080805,
     0.0079534932,
     -0.0078678301,
     0.0060607216},
    {"double arrowhead",
     "Half width = 1",
     true,
     0.13660254,
     0.0080799964,
     0.0079533283,
     -0.0078681752,
     0.0060606928},
    {"tetrachiral",
     "Ligament length = 1 | Ring radius = 0.2",
     false,
     0.140372287,
     0.0068019901,
     0.0068019901,
     -0.0060401574,
     0.0012803166,
     curved},
    {"tetrachiral",
     "Ligament length = 1 | Ring radius = 0.2",
     true,
     0.140372287,
     0.0064568377,
     0.0064568377,
     -0.0057080833,
     0.0012129849,
     curved},
    {"anti-tetrachiral",
     "Ring distance = 1 | Ring radius = 0.2",
     false,
     0.162831853,
     0.0069345652,
     0.0069345652,
     -0.0066894868,
     4.1700588e-05,
     curved},
    {"anti-tetrachiral",
     "Ring distance = 1 | Ring radius = 0.2",
     true,
     0.162831853,
     0.006618825,
     0.006618825,
     -0.0063747064,
     4.142955e-05,
     curved},
    {"hexachiral",
     "Ligament length = 1 | Ring radius = 0.2",
     false,
     0.21185953,
     0.0083756731,
     0.0083756731,
     -0.0069818644,
     0.0076787688,
     curved},
    {"hexachiral",
     "Ligament length = 1 | Ring radius = 0.2",
     true,
     0.21185953,
     0.0079947262,
     0.0079947262,
     -0.0066332406,
     0.0073139834,
     curved}};

  struct CubicReference
  {
    std::string cell, sizes;
    bool        has_shear;
    double      density, C11, C12, C44;
  };

  // Round struts of d = 0.1, shear area 0.9 A.
  const std::vector<CubicReference> cubic_references = {
    {"cubic",
     "Strut length = 1",
     false,
     0.0235619449,
     0.0078539816,
     0,
     2.9452431e-05},
    {"cubic",
     "Strut length = 1",
     true,
     0.0235619449,
     0.0078539816,
     0,
     2.8827828e-05},
    {"body-centred cubic",
     "Strut length = 1",
     false,
     0.0408104857,
     0.0046025159,
     0.0045004897,
     0.0045515028},
    {"body-centred cubic",
     "Strut length = 1",
     true,
     0.0408104857,
     0.0046010734,
     0.0045012109,
     0.0045511422},
    {"face-centred cubic",
     "Strut length = 1",
     false,
     0.033321622,
     0.0055952557,
     0.0027559758,
     0.0027845276},
    {"face-centred cubic",
     "Strut length = 1",
     true,
     0.033321622,
     0.0055943724,
     0.0027564175,
     0.002784466},
    {"octet",
     "Strut length = 1",
     false,
     0.0666432441,
     0.011190511,
     0.0055119516,
     0.0055952557},
    {"octet",
     "Strut length = 1",
     true,
     0.0666432441,
     0.011188745,
     0.005512835,
     0.0055943724},
    {"Kelvin",
     "Strut length = 1",
     false,
     0.00833040551,
     0.00094406646,
     0.00091636769,
     1.3634052e-05},
    {"Kelvin",
     "Strut length = 1",
     true,
     0.00833040551,
     0.00094367581,
     0.00091656301,
     1.3443366e-05},
    {"diamond",
     "Strut length = 1",
     false,
     0.0102026214,
     0.001150629,
     0.0011251224,
     3.7694414e-05},
    {"diamond",
     "Strut length = 1",
     true,
     0.0102026214,
     0.0011502684,
     0.0011253027,
     3.6906589e-05},
    {"space star",
     "Strut length = 1 | Opening angle = 60 deg",
     false,
     0.0213978675,
     0.00032900028,
     -0.0001470519,
     1.3036644e-06},
    {"space star",
     "Strut length = 1 | Opening angle = 60 deg",
     true,
     0.0213978675,
     0.00032777429,
     -0.00014680174,
     1.2941884e-06}};

  SceneText infinite_lattice(const std::string &cell, const std::string &sizes)
  {
    return SceneText()
      .set("Analysis", "effective properties")
      .set("Lattice/Cell", cell)
      .add("Lattice", sizes);
  }

  EffectiveProperties properties_of(const SceneText &scene)
  {
    return effective_properties(read_scene_from_text(scene.str(), "cell.prm"),
                                MPI_COMM_WORLD);
  }

  SceneText plane_lattice(const std::string &cell, const std::string &sizes)
  {
    return infinite_lattice(cell, sizes)
      .rectangle("wall", 1, 0.05, {1, "", 0.3});
  }

  std::string title_of(const std::string &cell, const bool has_shear)
  {
    return cell + (has_shear ? ", shear: " : ": ");
  }
} // namespace

TEST(EffectiveProperties, PlaneCells)
{
  ComparisonTable table(
    "Infinite lattices in the plane, t/L = 0.05: independent "
    "code for periodic frames");
  for (const PlaneReference &reference : plane_references)
    {
      SceneText scene = plane_lattice(reference.cell, reference.sizes);
      scene.set("Effects/Shear flexibility",
                reference.has_shear ? "on" : "off");
      if (reference.allowed == curved)
        scene.mesh(5, 3);
      const EffectiveProperties found = properties_of(scene);
      const auto               &C     = found.elastic.stiffness();
      const std::string at = title_of(reference.cell, reference.has_shear);
      table.relative(at + "density",
                     *found.relative_density,
                     reference.density,
                     1e-8);
      const double allowed = reference.allowed * reference.C11;
      table.row(at + "C11", C(0, 0), reference.C11, allowed);
      table.row(at + "C22", C(1, 1), reference.C22, allowed);
      table.row(at + "C12", C(0, 1), reference.C12, allowed);
      table.row(at + "C66", C(2, 2), reference.C66, allowed);
      EXPECT_LT(found.elastic.asymmetry(), 1e-9) << at;
    }
}

TEST(EffectiveProperties, CubicCells)
{
  ComparisonTable table(
    "Infinite lattices in space, d/L = 0.1: independent code "
    "for periodic frames");
  for (const CubicReference &reference : cubic_references)
    {
      const EffectiveProperties found =
        properties_of(infinite_lattice(reference.cell, reference.sizes)
                        .dimension(3)
                        .circle("strut", 0.05, {1, "", 0.3})
                        .set("Effects/Shear flexibility",
                             reference.has_shear ? "on" : "off"));
      const auto       &C  = found.elastic.stiffness();
      const std::string at = title_of(reference.cell, reference.has_shear);
      table.relative(at + "density",
                     *found.relative_density,
                     reference.density,
                     1e-8);
      const double allowed = 5e-8 * reference.C11;
      for (unsigned int i = 0; i < 3; ++i)
        {
          EXPECT_NEAR(C(i, i), C(0, 0), allowed) << at;
          EXPECT_NEAR(C(3 + i, 3 + i), C(3, 3), allowed) << at;
          EXPECT_NEAR(C(i, (i + 1) % 3), C(0, 1), allowed) << at;
        }
      table.row(at + "C11", C(0, 0), reference.C11, allowed);
      table.row(at + "C12", C(0, 1), reference.C12, allowed);
      table.row(at + "C44", C(3, 3), reference.C44, allowed);
    }
}

// C16 = -C26: the cell couples stretch and shear, E is not C11 - C12^2/C11.
TEST(EffectiveProperties, ChiralCellsCoupleStretchAndShear)
{
  const EffectiveProperties found = properties_of(
    plane_lattice("tetrachiral", "Ligament length = 1 | Ring radius = 0.2")
      .set("Effects/Shear flexibility", "on")
      .mesh(5, 3));
  const auto            &C = found.elastic.stiffness();
  const dealii::Point<3> x(1, 0, 0), y(0, 1, 0);
  ComparisonTable        table("Tetrachiral lattice with shear flexibility, "
                               "independent code for periodic frames");
  table.row("|C16|", std::abs(C(0, 2)), 0.0026604044, 1e-8);
  table.row("C16 + C26", C(0, 2) + C(1, 2), 0, 1e-10);
  table.relative("E1", found.elastic.youngs_modulus(x), 0.00059595185, 1e-5);
  table.relative("nu12", found.elastic.poissons_ratio(x, y), 0.20407561, 1e-5);
}

// Hinges of thickness 0.01, squares with spokes of 0.05.
TEST(EffectiveProperties, RotatingSquares)
{
  ComparisonTable table(
    "Rotating squares, independent code for periodic frames");
  const EffectiveProperties found = properties_of(
    plane_lattice("rotating squares",
                  "Square side = 1 | Turn angle = 20 deg | Hinge length = 0.1")
      .rectangle("hinge", 1, 0.01, {1, "", 0.3})
      .set("Sections/hinge/Struts", "hinges")
      .set("Effects/Shear flexibility", "on"));
  const auto &C = found.elastic.stiffness();
  table.relative("density", *found.relative_density, 0.168192952, 1e-8);
  table.row("C11", C(0, 0), 0.013439522, 2e-9);
  table.row("C12", C(0, 1), -0.013425418, 2e-9);
  table.relative("C66", C(2, 2), 0.00045267199, 1e-7);
}

TEST(EffectiveProperties, MoreCellsHaveTheSameProperties)
{
  for (const std::string cell : {"re-entrant", "kagome", "star"})
    {
      const auto one = properties_of(plane_lattice(cell, "")),
                 six = properties_of(
                   plane_lattice(cell, "Cells x = 3 | Cells y = 2"));
      EXPECT_NEAR(*one.relative_density, *six.relative_density, 1e-12);
      const auto &C = one.elastic.stiffness(), &D = six.elastic.stiffness();
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          EXPECT_NEAR(C(i, j), D(i, j), 1e-9 * C(0, 0)) << cell;
    }
}

// Static: a connector is parallel to the star's body, both in series with the
// stubs, 1/E2 = 2 L/EA + 1/(1/f + K), f = 1/E(0) - 2 L/EA.
TEST(EffectiveProperties, ConnectorsAddTheirStiffness)
{
  const auto with = [](const double stiffness) {
    return properties_of(
             plane_lattice("star", "Strut length = 1 | Opening angle = 60 deg")
               .set("Effects/Shear flexibility", "on")
               .connector("spring",
                          "spring",
                          "Between = in-cell | Spring stiffness = " +
                            text(stiffness)))
      .elastic.youngs_modulus(dealii::Point<3>(0, 1, 0));
  };
  const double    K = 1e-4, stubs = 2 / 0.05, f = 9690.0951550;
  ComparisonTable table("Star with a spring of 1e-4, closed form");
  table.relative("E2", with(K), 1 / (stubs + 1 / (1 / f + K)), 1e-8);
}

// Sheared squares of pinned struts do not resist; their sides keep EA/L.
TEST(EffectiveProperties, MechanismsOfTheWholeLatticeHaveNoCompliance)
{
  const EffectiveProperties found = properties_of(
    plane_lattice("square", "Strut length = 1").hinge("pins", "all"));
  const auto &C = found.elastic.stiffness();
  EXPECT_NEAR(C(0, 0), 0.05, 1e-12);
  EXPECT_NEAR(C(2, 2), 0, 1e-15);
  EXPECT_FALSE(found.elastic.compliance());
}

// Steady strains: dashpots carry no force, Maxwell elements have relaxed.
TEST(EffectiveProperties, DampersDoNotStiffenSteadyStrains)
{
  const auto with = [](const std::string &law, const std::string &entries) {
    SceneText scene =
      plane_lattice("star", "Strut length = 1 | Opening angle = 60 deg");
    if (!law.empty())
      scene.connector("damper", law, "Between = in-cell | " + entries);
    return properties_of(scene).elastic.stiffness();
  };
  const auto none    = with("", ""),
             dashpot = with("dashpot", "Damping coefficient = 1"),
             maxwell = with("maxwell",
                            "Spring stiffness = 1 | Damping coefficient = 1");
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      {
        EXPECT_NEAR(dashpot(i, j), none(i, j), 1e-12 * none(0, 0));
        EXPECT_NEAR(maxwell(i, j), none(i, j), 1e-12 * none(0, 0));
      }
}
