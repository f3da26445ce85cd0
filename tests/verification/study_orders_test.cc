#include <gtest/gtest.h>
#include <study/report_cells.h>
#include <support/scene_text.h>

#include "result_table.h"

using namespace auxfem;
using namespace auxfem::testing_support;

// The orders that a study observes are those of theory: joints converge with
// order 2p in the mesh, strains with order p in the energy norm, second-order
// schemes with order 2 in the step.

namespace
{
  /** A clamped angle of two slender struts, bent by loads that grow smoothly.
   */
  SceneText angle(const unsigned int dimension)
  {
    SceneText scene;
    scene.dimension(dimension).set("Lattice/Cell", "frame");
    scene.set("Lattice/Joints",
              dimension == 2 ? "0 0; 2 0; 2 2" : "0 0 0; 2 0 0; 2 2 0.6");
    scene.set("Lattice/Struts", "0 1; 1 2");
    scene.circle("rod", 0.02, {1e9, 1000, 0.3});
    scene.support("clamp", "0", "clamp");
    scene.set("Loads/push/Joints", "2");
    scene.set("Loads/push/Force x", "-160 * t^3");
    scene.set("Loads/push/Force y", "-120 * t^3");
    if (dimension == 3)
      scene.set("Loads/push/Force z", "80 * t^3");
    scene.probe("tip", "2").set("Newton/Tolerance", "1e-12");
    return scene;
  }

  double observed(const StudyReport &report,
                  const std::string &of,
                  const std::string &cell)
  {
    return last_number_where(report, "tip.observed_order", of, cell);
  }

  void mesh_orders(const std::string &name,
                   const SceneText   &scene,
                   const unsigned int highest)
  {
    ResultTable table("Orders in the mesh observed by a study, " + name,
                      {"order of the elements", "observed", "theory"});
    for (unsigned int p = 1; p <= highest; ++p)
      {
        const std::string order = std::to_string(p);
        // Each on meshes where it is neither coarse nor at round-off.
        const std::string meshes = p < 3 ? "2, 3, 4"
          : p == 3                       ? "1, 2, 3"
                                         : "0, 1, 2";
        const double      rate   = observed(study_of(scene,
                                              {"Study/Time steps=none",
                                                      "Study/Orders=" + order,
                                                      "Study/Refinements=" + meshes}),
                                     "order",
                                     order);
        table.row({order, formatted("%.2f", rate), std::to_string(2 * p)});
        if (p < 4)
          {
            EXPECT_NEAR(rate, 2 * p, 0.1) << name << ", order " << p;
          }
        else
          {
            // Its errors fall from 1e-6 to round-off on these meshes, too soon
            // for the asymptotic range.
            EXPECT_GT(rate, 7) << name << ", order " << p;
          }
      }
  }

  /** Of the strain energy of the error, and in dynamics with its kinetic
   * energy, after which @p norm is named. */
  void field_orders(const std::string &name,
                    const SceneText   &scene,
                    const std::string &norm)
  {
    ResultTable table("Orders in the mesh of the " + norm + ", " + name,
                      {"order of the elements", "observed", "theory"});
    for (unsigned int p = 1; p <= 3; ++p)
      {
        const std::string order = std::to_string(p);
        const double      rate =
          last_number_where(study_of(scene,
                                     {"Study/Time steps=none",
                                      "Study/Orders=" + order,
                                      "Study/Refinements=2, 3, 4",
                                      "Quantities/field=" + norm + " at end"}),
                            "field.observed_order",
                            "order",
                            order);
        table.row({order, formatted("%.2f", rate), order});
        EXPECT_NEAR(rate, p, 0.1) << name << ", order " << p;
      }
  }

  void step_orders(const std::string              &name,
                   const SceneText                &scene,
                   const std::vector<std::string> &schemes)
  {
    ResultTable table("Orders in the step observed by a study, " + name,
                      {"scheme", "observed", "theory"});
    for (const std::string &scheme : schemes)
      {
        const double rate =
          observed(study_of(scene,
                            {"Study/Refinements=none",
                             "Study/Reference=extrapolation",
                             "Study/Schemes=" + scheme,
                             "Study/Time steps=4 ms, 2 ms, 1 ms"}),
                   "scheme",
                   scheme);
        table.row({scheme, formatted("%.2f", rate), "2"});
        EXPECT_NEAR(rate, 2, 0.1) << name << ", " << scheme;
      }
  }
} // namespace

TEST(StudyOrders, MeshInStaticsInThePlane)
{
  mesh_orders("statics in the plane", angle(2).time(0.6, 0.1, "static"), 4);
}

TEST(StudyOrders, MeshInStaticsInSpace)
{
  mesh_orders("statics in space", angle(3).time(0.6, 0.1, "static"), 4);
}

TEST(StudyOrders, MeshInDynamicsInThePlane)
{
  mesh_orders("dynamics in the plane", angle(2).time(0.5, 0.01), 4);
}

TEST(StudyOrders, MeshInDynamicsInSpace)
{
  mesh_orders("dynamics in space", angle(3).time(0.5, 0.01), 4);
}

TEST(StudyOrders, EnergyNormInStaticsInThePlane)
{
  field_orders("statics in the plane",
               angle(2).time(0.6, 0.1, "static"),
               "energy norm");
}

TEST(StudyOrders, EnergyNormInStaticsInSpace)
{
  field_orders("statics in space",
               angle(3).time(0.6, 0.1, "static"),
               "energy norm");
}

TEST(StudyOrders, EnergyNormInDynamicsInThePlane)
{
  field_orders("dynamics in the plane",
               angle(2).time(0.5, 0.01),
               "total energy norm");
}

TEST(StudyOrders, EnergyNormInDynamicsInSpace)
{
  field_orders("dynamics in space",
               angle(3).time(0.5, 0.01),
               "total energy norm");
}

TEST(StudyOrders, StepInThePlane)
{
  step_orders("in the plane",
              angle(2).mesh(2).time(0.5, 0.004),
              {"newmark", "hht", "generalized-alpha", "energy-momentum"});
}

TEST(StudyOrders, StepInSpace)
{
  step_orders("in space",
              angle(3).mesh(2).time(0.5, 0.004),
              {"newmark", "hht", "generalized-alpha"});
}
