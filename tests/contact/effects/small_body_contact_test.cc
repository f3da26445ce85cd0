#include <contact/effects/pressed_step.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Bodies much smaller than the elements of 0.5 m. */
  const std::vector<ContactCase> small_bodies = {
    {"small disc",
     2,
     "Shape = sphere | Position = 0.13 -0.106 | Radius = 5e-3"},
    {"point", 2, "Shape = sphere | Position = 0.71 -0.1011 | Radius = 1e-4"},
    {"small sphere",
     3,
     "Shape = sphere | Position = 0.13 -0.078 0 | Radius = 0.01"},
    {"thin cylinder",
     3,
     "Shape = cylinder | Position = 0.8 -0.085 0 | Axis = 0.3 0 1 | Radius = "
     "4e-3"}};
} // namespace

TEST(SmallBodyContact, HasThePotentialAndWorkOfLargeBodies)
{
  for (const ContactCase &contact_case : small_bodies)
    for (const Evaluation::Kind kind :
         {Evaluation::Kind::equilibrium, Evaluation::Kind::discrete_gradient})
      {
        SCOPED_TRACE(contact_case.name);
        PressedStep step(above_plate(contact_case, 0),
                         kind == Evaluation::Kind::discrete_gradient);
        EXPECT_LT(error_of_tangent(step, kind), 1e-6);
        State        at_start = step.from;
        const double before =
          EvaluatedAlone(step.contact,
                         Evaluation::consistent_rates(step.from, at_start))
            .accept()
            .stored();
        const EvaluatedAlone evaluated(step.contact, step.evaluation(kind));
        const double         after = evaluated.accept().stored();
        EXPECT_GT(after, 1e-4);
        if (kind != Evaluation::Kind::discrete_gradient)
          continue;
        double work = 0;
        for (unsigned int i = 0; i < step.n; ++i)
          work += evaluated.residual[i] *
            (step.to.displacement[i] - step.from.displacement[i]);
        // Quadrature error for penetrations of a third of half the thickness.
        EXPECT_NEAR(work, after - before, 1e-9 * after);
      }
}
