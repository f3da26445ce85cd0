#include <auxfem/loads/effects/follower_loads.h>

#include <equations/space_effect.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Force (3, -2, 1.5) and moment (0.7, 5, -4) that turn with joint 1. */
  std::array<TimeFunction, n_motion_components>
  components(const SceneContext &context)
  {
    std::array<TimeFunction, n_motion_components> result;
    const char *texts[] = {"3", "-2", "1.5", "0.7", "5", "-4"};
    for (unsigned int c = 0; c < n_motion_components; ++c)
      result[c] = TimeFunction(texts[c], "load", context);
    return result;
  }

  const EnergyEntry work{EnergyKind::work, "load_work", "work of loads"};

  struct LoadInSpace : SpaceEffect
  {
    LoadInSpace()
      : SpaceEffect(space_frame("0 0 0; 1 0 0.3; 1.5 0.9 0.2", "0 1; 1 2"),
                    true)
      , loads(
          make_follower_loads(setup.lattice,
                              setup.dofs(),
                              false,
                              {{components(setup.scene.context), work, {1}}}))
    {
      make_room_for(*loads);
    }

    std::unique_ptr<Effect> loads;
  };
} // namespace

TEST(FollowerLoads, TurnWithTheJointInSpace)
{
  LoadInSpace               one;
  const auto               &dofs = one.setup.dofs();
  const std::vector<double> rows = one.residual(*one.loads, one.to);
  const Quaternion         &P =
    one.to.rotations[dofs.rotations().with(dofs.joint_unknown(1, rotation_z))];
  const SpaceVector force  = rotated(P, SpaceVector({3, -2, 1.5})),
                    moment = rotated(P, SpaceVector({0.7, 5, -4}));
  double others            = 0;
  for (const double row : rows)
    others += row * row;
  for (unsigned int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(rows[dofs.joint_unknown(1, c)], -force[c], 1e-14);
      EXPECT_NEAR(rows[dofs.joint_unknown(1, 3 + c)], -moment[c], 1e-14);
    }
  EXPECT_NEAR(others, force.norm_square() + moment.norm_square(), 1e-12);
}

TEST(FollowerLoads, TurnWithTheJointInThePlane)
{
  const EquationsOnRanks        setup(frame_scene("0 0; 1 0", "0 1"),
                               {},
                               MPI_COMM_SELF);
  const auto                   &dofs = setup.dofs();
  const std::unique_ptr<Effect> loads =
    make_follower_loads(setup.lattice,
                        dofs,
                        false,
                        {{components(setup.scene.context), work, {1}}});
  State        from = setup.equations.initial_state(), to = from;
  const double angle                                 = 0.7;
  to.displacement[dofs.joint_unknown(1, rotation_z)] = angle;
  const std::vector<double> rows =
    EvaluatedAlone(*loads, Evaluation::step(from, to, 1.)).residual;
  EXPECT_NEAR(-rows[dofs.joint_unknown(1, 0)],
              3 * std::cos(angle) + 2 * std::sin(angle),
              1e-14);
  EXPECT_NEAR(-rows[dofs.joint_unknown(1, 1)],
              3 * std::sin(angle) - 2 * std::cos(angle),
              1e-14);
  EXPECT_NEAR(-rows[dofs.joint_unknown(1, rotation_z)], -4, 1e-14);
}

TEST(FollowerLoads, TangentIsThatOfDifferences)
{
  LoadInSpace one;
  one.expect_tangent(*one.loads, {1., 3., 5.});
}

TEST(FollowerLoads, FollowTheLoadFactorOnAPath)
{
  LoadInSpace                                   one;
  std::array<TimeFunction, n_motion_components> lines;
  for (unsigned int c = 0; c < n_motion_components; ++c)
    lines[c] = TimeFunction::line(0.5, 2. - c, "load");
  const std::unique_ptr<Effect> loads =
    make_follower_loads(one.setup.lattice,
                        one.setup.dofs(),
                        false,
                        {{lines, work, {1}}});
  one.to.path.emplace();
  const auto residual = [&](const double load_factor) {
    one.to.path->load_factor = load_factor;
    return EvaluatedAlone(*loads, Evaluation::step(one.from, one.to, 1.))
      .residual;
  };
  const std::vector<double> less = residual(-2), more = residual(-1);
  std::vector<double>       derivative(one.n, 0.);
  loads->add_load_derivative(Evaluation::step(one.from, one.to, 1.),
                             derivative.data());
  double size = 0;
  for (unsigned int i = 0; i < one.n; ++i)
    {
      EXPECT_NEAR(derivative[i], more[i] - less[i], 1e-13);
      size = std::max(size, std::abs(derivative[i]));
    }
  EXPECT_GT(size, 1);
}

TEST(FollowerLoads, WorkOfASmallStepIsThatOfTheLoadAlongIt)
{
  LoadInSpace one;
  const auto &dofs = one.setup.dofs();
  one.from         = one.to;
  one.to           = one.moved(one.irregular(2.2), 1e-4);
  // `moved` counts turns from the state before.
  const Evaluation step = Evaluation::step(one.from, one.to, 1.);
  one.rotations.follow(step);
  const EvaluatedAlone      evaluated(*one.loads, step);
  const std::vector<double> rows = evaluated.residual;
  double                    work = 0;
  for (unsigned int c = 0; c < n_motion_components; ++c)
    {
      const int i = dofs.joint_unknown(1, c);
      if (c < 3)
        work -= rows[i] * (one.to.displacement[i] - one.from.displacement[i]);
    }
  const SpaceVector turn =
    one.rotations.spatial_increment(step,
                                    dofs.rotations().with(
                                      dofs.joint_unknown(1, rotation_z)));
  for (unsigned int c = 0; c < 3; ++c)
    work -= rows[dofs.joint_unknown(1, 3 + c)] * turn[c];
  // Mean and end values of the step differ by its square.
  EXPECT_NEAR(evaluated.accept().external(), work, 1e-6);
  EXPECT_GT(std::abs(work), 1e-5);
}
