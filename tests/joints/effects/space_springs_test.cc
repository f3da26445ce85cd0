#include <auxfem/joints/effects/rotational_springs.h>

#include <equations/space_effect.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const SceneText knee =
    space_frame("0 0 0; 1 0 0; 1.5 0.9 0.2", "0 1; 1 2")
      .add("Joints/knee",
           "Joints = 1 | Type = rotational spring | Stiffness = 1.7");

  /** The spring of the knee alone, or one to the ground. */
  struct KneeSpring : SpaceEffect
  {
    explicit KneeSpring(const bool to_ground) : SpaceEffect(knee, true)
    {
      const auto &dofs = setup.dofs();
      first =
        to_ground ? -1 : dofs.rotations().with(dofs.end_rotation(0, 1, 3));
      second = dofs.rotations().with(dofs.end_rotation(1, 0, 3));
      spring =
        make_space_springs(setup.dofs(), {{first, second, 1.7, /*number=*/0}});
      make_room_for(*spring);
    }

    std::unique_ptr<Effect> spring;
    int                     first, second;
  };
} // namespace

TEST(SpaceSprings, TangentIsThatOfDifferences)
{
  for (const bool to_ground : {false, true})
    {
      KneeSpring knee(to_ground);
      knee.expect_tangent(*knee.spring, {1., 3., 5.});
    }
}

TEST(SpaceSprings, MomentsAreDerivativesOfTheEnergy)
{
  for (const bool to_ground : {false, true})
    {
      KneeSpring                knee(to_ground);
      const std::vector<double> rows   = knee.residual(*knee.spring, knee.to);
      const auto                energy = [&](State state) {
        return EvaluatedAlone(*knee.spring,
                              Evaluation::step(knee.from, state, 1.))
          .accept()
          .strain();
      };
      const double h = 1e-5;
      for (unsigned int i = 0; i < knee.n; ++i)
        {
          std::vector<double> direction(knee.n, 0.);
          direction[i] = 1;
          EXPECT_NEAR(rows[i],
                      (energy(knee.moved(direction, h)) -
                       energy(knee.moved(direction, -h))) /
                        (2 * h),
                      1e-9);
        }
    }
}

TEST(SpaceSprings, TurnsAreCountedWhileBothTumble)
{
  KneeSpring knee(false);
  State      before = knee.from;
  // The base tumbles, the strut turns against it about (1, 2, 2) / 3: three
  // whole turns and a bit.
  const unsigned int n_steps = 100;
  const double       angle   = 20;
  for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const double     part = double(step) / n_steps;
      const Quaternion base = exponential(SpaceVector({0, 0, 30 * part})) *
        exponential(SpaceVector({std::sin(17 * part), 25 * part, 0}));
      State now                 = before;
      now.rotations[knee.first] = base;
      now.rotations[knee.second] =
        base * exponential(angle * part / 3 * SpaceVector({1, 2, 2}));
      const Energies energies =
        EvaluatedAlone(*knee.spring, Evaluation::step(before, now, 1.))
          .accept();
      EXPECT_NEAR(energies.strain(),
                  1.7 / 2 * std::pow(angle * part, 2),
                  1e-10);
      before = now;
    }
}

TEST(SpaceSprings, SmallRotationsHaveASpringAboutEveryAxis)
{
  // A clamped strut, and beyond the spring a free one, loaded by a moment: the
  // spring turns by M / K'.
  SceneRun run(SceneText(knee)
                 .support("wall", "0", "clamp")
                 .add("Loads/tip",
                      "Joints = 2 | Moment x = 1e-3 | Moment y = -2e-3 | "
                      "Moment z = 3e-3")
                 .time(1, 1, "static"),
               {"Effects/Large rotation=off"});
  run.run();
  const auto  &dofs      = run.model.numbering;
  const double moments[] = {1e-3, -2e-3, 3e-3};
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(run.state.displacement[dofs.end_rotation(1, 0, 3 + c)] -
                  run.state.displacement[dofs.end_rotation(0, 1, 3 + c)],
                moments[c] / 1.7,
                1e-12);
}
