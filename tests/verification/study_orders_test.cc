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
  /** A clamped angle of two round struts, bent by loads that grow smoothly.
   * @param radius of the struts (m)
   * @param push factor of the loads */
  SceneText angle(const unsigned int dimension,
                  const double       radius = 0.02,
                  const double       push   = 1)
  {
    const auto load = [push](const double force) {
      return text(push * force) + " * t^3";
    };
    SceneText scene;
    scene.dimension(dimension).set("Lattice/Cell", "frame");
    scene.set("Lattice/Joints",
              dimension == 2 ? "0 0; 2 0; 2 2" : "0 0 0; 2 0 0; 2 2 0.6");
    scene.set("Lattice/Struts", "0 1; 1 2");
    scene.circle("rod", radius, {1e9, 1000, 0.3});
    scene.support("clamp", "0", "clamp");
    scene.set("Loads/push/Joints", "2");
    scene.set("Loads/push/Force x", load(-160));
    scene.set("Loads/push/Force y", load(-120));
    if (dimension == 3)
      scene.set("Loads/push/Force z", load(80));
    scene.probe("tip", "2").set("Newton/Tolerance", "1e-12");
    return scene;
  }

  double observed(const StudyReport &report,
                  const std::string &of,
                  const std::string &cell)
  {
    return last_number_where(report, "tip.observed_order", of, cell);
  }

  /** A scene and the meshes, by refinements, on which its error is neither of
   * a coarse mesh nor round-off. */
  struct Resolved
  {
    SceneText   scene;
    std::string refinements;
  };

  /** With struts that are thick, whose round-off is small, and bent more: the
   * error of elements of order 4 must fall by 2^8 without coming near it. */
  Resolved for_order_4(const SceneText &scene, const std::string &refinements)
  {
    return {SceneText(scene).set("Newton/Tolerance", "1e-14"), refinements};
  }

  void mesh_orders(const std::string &name,
                   const SceneText   &scene,
                   const Resolved    &of_order_4)
  {
    ResultTable table("Orders in the mesh observed by a study, " + name,
                      {"order of the elements", "observed", "theory"});
    for (unsigned int p = 1; p <= 4; ++p)
      {
        const std::string order = std::to_string(p);
        const Resolved    mesh_study =
          p == 4 ? of_order_4 : Resolved{scene, p == 3 ? "1, 2, 3" : "2, 3, 4"};
        const double rate =
          observed(study_of(mesh_study.scene,
                            {"Study/Time steps=none",
                             "Study/Orders=" + order,
                             "Study/Refinements=" + mesh_study.refinements}),
                   "order",
                   order);
        table.row({order, formatted("%.2f", rate), std::to_string(2 * p)});
        EXPECT_NEAR(rate, 2 * p, 0.1) << name << ", order " << p;
      }
  }

  /** Orders of the strain energy of the error, and in dynamics with its
   * kinetic energy; @p norm names it. */
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
  mesh_orders("statics in the plane",
              angle(2).time(0.6, 0.1, "static"),
              for_order_4(angle(2, 0.2, 2e4).time(0.6, 0.1, "static"),
                          "1, 2, 3"));
}

TEST(StudyOrders, MeshInStaticsInSpace)
{
  mesh_orders("statics in space",
              angle(3).time(0.6, 0.1, "static"),
              for_order_4(angle(3, 0.2, 4e4).time(0.6, 0.1, "static"),
                          "1, 2, 3"));
}

TEST(StudyOrders, MeshInDynamicsInThePlane)
{
  mesh_orders("dynamics in the plane",
              angle(2).time(0.5, 0.01),
              for_order_4(angle(2, 0.1, 750).time(0.6, 0.01), "0, 1, 2"));
}

TEST(StudyOrders, MeshInDynamicsInSpace)
{
  mesh_orders("dynamics in space",
              angle(3).time(0.5, 0.01),
              for_order_4(angle(3, 0.1, 750).time(0.6, 0.01), "0, 1, 2"));
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
