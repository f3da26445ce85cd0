#include <auxfem/contact/effects/contact.h>

#include <verification/result_table.h>
#include <verification/space_text.h>

#include <algorithm>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A cell that plates crush until its struts touch, with friction: turned as a
// whole it is crushed as before.

namespace
{
  /** Results of a step, in axes before the rotation of the scene. */
  struct CrushStep
  {
    double      time;
    SpaceVector force;         ///< on the plate that comes down (N)
    SpaceVector tip;           ///< displacement of the bar's end (m)
    double      contact_force; ///< magnitude of forces between struts (N)
  };

  /** An irregular cell with a bar in it, between two plates. */
  class TurnedCrush
  {
  public:
    TurnedCrush(const unsigned int dimension, const Quaternion &rotation)
      : dimension(dimension)
      , rotation(rotation)
    {}

    std::vector<CrushStep> run() const
    {
      SceneRun               run(scene().str());
      std::vector<CrushStep> steps;
      run.run([&] {
        CrushStep step{run.state.time,
                       back(
                         run.equations.reporting()
                           .plates
                           ->reports(run.equations.plate_results(run.results),
                                     run.state)[1]
                           .force),
                       {},
                       0};
        for (unsigned int c = 0; c < dimension; ++c)
          step.tip[c] = run.motion(6, c);
        step.tip = back(step.tip);
        for (const ContactReport &contact :
             run.equations.reporting().strut_contact->contacts(
               run.equations.strut_contact_results(run.results),
               run.state))
          step.contact_force += contact.force.norm();
        steps.push_back(step);
      });
      return steps;
    }

  private:
    SpaceVector back(const SpaceVector &vector) const
    {
      return rotated(conjugate(rotation), vector);
    }

    /** As it stands in a scene. */
    std::string turned(const double x, const double y, const double z) const
    {
      const SpaceVector v =
        rotated(rotation, SpaceVector({x, y, dimension == 3 ? z : 0.}));
      return text(v[0]) + " " + text(v[1]) +
        (dimension == 3 ? " " + text(v[2]) : "");
    }

    SceneText scene() const
    {
      SceneText scene;
      scene.dimension(dimension)
        .frame(turned(0, 0, 0) + "; " + turned(0.02, 0, 0.001) + "; " +
                 turned(0.031, 0.016, 0.002) + "; " + turned(0.019, 0.033, 0) +
                 "; " + turned(-0.001, 0.034, 0) + "; " +
                 turned(-0.012, 0.017, -0.001) + "; " +
                 turned(0.014, 0.0215, 0.0005),
               "0 1; 1 2; 2 3; 3 4; 4 5; 5 0; 5 6")
        .circle("bar", "0.5 mm", {1e9, 1000, 0.3})
        .support("held", "0", "clamp")
        .add("Contact", "Friction coefficient = 0.3 | Slip velocity = 1e-2")
        .set("Newton/Tolerance", 1e-11)
        .set("Newton/Factorization", "every iteration")
        .set("Effects/Shear flexibility", "off")
        .mesh(3, 2)
        .add("Time", "Spectral radius = 0.6")
        // With longer steps, round-off decides which steps are divided and
        // which struts bounce for a single step.
        .time(0.05, 0.000125, "generalized-alpha");
      // The lower one lies below the joint that is held.
      scene.add("Plates/lower",
                "Shape = plane | Normal = " + turned(0, 1, 0) +
                  " | Position = " + turned(0, -6e-4, 0));
      scene.add("Plates/upper",
                "Shape = plane | Normal = " + turned(0, -1, 0) +
                  " | Position = " + turned(0, 0.0346, 0));
      const SpaceVector down = rotated(rotation, SpaceVector({0, -0.016, 0}));
      for (unsigned int c = 0; c < dimension; ++c)
        scene.set(std::string("Plates/upper/Displacement ") + "xyz"[c],
                  text(down[c] / 0.05) + " * t");
      return scene;
    }

    const unsigned int dimension;
    const Quaternion   rotation;
  };

  void expect_same(const std::string &name,
                   const unsigned int dimension,
                   const SpaceVector &rotation_vector,
                   ComparisonTable   &table)
  {
    const std::vector<CrushStep>
      one   = TurnedCrush(dimension, Quaternion()).run(),
      other = TurnedCrush(dimension, exponential(rotation_vector)).run();
    ASSERT_EQ(one.size(), other.size());
    double force = 0, contact = 0, force_difference = 0, contact_difference = 0,
           tip_difference = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      {
        force   = std::max(force, one[i].force.norm());
        contact = std::max(contact, one[i].contact_force);
        force_difference =
          std::max(force_difference, (one[i].force - other[i].force).norm());
        contact_difference =
          std::max(contact_difference,
                   std::abs(one[i].contact_force - other[i].contact_force));
        tip_difference =
          std::max(tip_difference, (one[i].tip - other[i].tip).norm());
      }
    // The bar is touched, and gives way.
    EXPECT_GT(contact, 0.01 * force);
    // Round-off of positions times the stiffness of faces, which is some
    // hundred thousand times that of the cell.
    constexpr double allowed = 3e-9;
    table.row(name + ": force on the plate / largest",
              force_difference / force,
              0,
              allowed);
    table.row(name + ": forces between struts / largest",
              contact_difference / contact,
              0,
              allowed);
    table.row(name + ": displacement of the bar / strut length",
              tip_difference / 0.02,
              0,
              allowed);
  }
} // namespace

TEST(ContactObjectivity, TurnedCellIsCrushedAlike)
{
  ComparisonTable table("Cell crushed between plates with friction, turned "
                        "before: largest differences");
  expect_same("plane, 0.7 rad", 2, SpaceVector({0, 0, 0.7}), table);
  expect_same("space", 3, SpaceVector({0.5, -1.1, 0.8}), table);
}
