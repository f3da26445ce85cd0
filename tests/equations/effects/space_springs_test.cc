#include <auxfem/equations/effects/space_springs.h>

#include <equations/effects/space_effect.h>
#include <support/scene_run.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string knee = space_frame("0 0 0; 1 0 0; 1.5 0.9 0.2",
                                       "0 1; 1 2",
                                       "subsection Joints\n  subsection knee\n"
                                       "    set Joints = 1\n"
                                       "    set Type = rotational spring\n"
                                       "    set Stiffness = 1.7\n  end\nend\n");

  /** The spring of the knee alone, or one to the ground. */
  struct KneeSpring : SpaceEffect
  {
    explicit KneeSpring(const bool to_ground)
      : SpaceEffect(knee, true)
      , spring(of_scene.dofs())
    {
      const auto &dofs = of_scene.dofs();
      first =
        to_ground ? -1 : dofs.rotations().with(dofs.end_rotation(0, 1, 3));
      second = dofs.rotations().with(dofs.end_rotation(1, 0, 3));
      spring.add(first, second, 1.7, /*number=*/0);
      make_room_for(spring);
    }

    SpaceSprings spring;
    int          first, second;
  };
} // namespace

TEST(SpaceSprings, TangentIsThatOfDifferences)
{
  for (const bool to_ground : {false, true})
    {
      KneeSpring knee(to_ground);
      knee.expect_tangent(knee.spring, {1., 3., 5.});
    }
}

TEST(SpaceSprings, MomentsAreDerivativesOfTheEnergy)
{
  for (const bool to_ground : {false, true})
    {
      KneeSpring                knee(to_ground);
      const std::vector<double> rows   = knee.residual(knee.spring, knee.to);
      const auto                energy = [&](State state) {
        return EvaluatedAlone(knee.spring,
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
        EvaluatedAlone(knee.spring, Evaluation::step(before, now, 1.)).accept();
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
  SceneRun run(knee +
                 "subsection Supports\n  subsection wall\n    set Joints = 0\n"
                 "    set Type = clamp\n  end\nend\n"
                 "subsection Loads\n  subsection tip\n    set Joints = 2\n"
                 "    set Moment x = 1e-3\n    set Moment y = -2e-3\n"
                 "    set Moment z = 3e-3\n  end\nend\n"
                 "subsection Time\n  set Scheme = static\n  set End time = 1\n"
                 "  set Time step = 1\nend\n",
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
