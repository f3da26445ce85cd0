#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/model/unknown_records.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Equations with an irregular step to evaluate. */
  struct Trial
  {
    explicit Trial(const std::vector<std::string> &overrides = {},
                   const SceneText &text = star_with_everything(1, 1))
      : setup(text, overrides, MPI_COMM_SELF)
      , from(setup.equations.initial_state())
      , to(from)
    {
      to.time = dt;
      fill_by_position(setup.model, 0.1, from.displacement);
      fill_by_position(setup.model, 0.4, to.displacement);
      if (to.velocity)
        fill_by_position(setup.model, 0.7, *to.velocity);
      if (to.acceleration)
        fill_by_position(setup.model, 1.1, *to.acceleration);
    }

    /** Residual of the step with unknown @p i moved by @p h, as an increment moves it. */
    Vector
    moved_residual(const int i, const double h, const TangentFactors &factors)
    {
      State moved = to;
      moved.displacement[i] += factors.stiffness * h;
      if (moved.velocity)
        (*moved.velocity)[i] += factors.damping * h;
      if (moved.acceleration)
        (*moved.acceleration)[i] += factors.mass * h;
      setup.residual(setup.step(from, moved, dt));
      return moved.residual;
    }

    Evaluation step()
    {
      return setup.step(from, to, dt);
    }

    double           dt = 0.4;
    EquationsOnRanks setup;
    State            from, to;
  };

  /** Compares the tangent at a trial with differences of residuals. */
  void check_tangent_of(const SceneText                &text,
                        const std::vector<std::string> &overrides,
                        const TangentFactors           &factors)
  {
    Trial               trial(overrides, text);
    EquationsOnRanks   &setup  = trial.setup;
    const DofNumbering &dofs   = setup.dofs();
    const auto          matrix = setup.make_tangent();
    setup.residual(trial.step());
    setup.tangent(trial.step(), factors, *matrix);

    const int    n = dofs.layout().n_global();
    Vector       unit(dofs.layout().n_local()), column(unit);
    double       worst = 0, scale = 0;
    const double h = 1e-5;
    for (int j = 0; j < n; ++j)
      {
        unit.assign(unit.size(), 0);
        unit[j] = 1;
        matrix->multiply(unit.data(), column.data());
        const Vector right = trial.moved_residual(j, h, factors),
                     left  = trial.moved_residual(j, -h, factors);
        for (int i = 0; i < n; ++i)
          if (dofs.unknowns().kinds[i] == UnknownKind::prescribed)
            EXPECT_EQ(column[i], i == j ? 1. : 0.);
          else
            {
              worst =
                std::max(worst,
                         std::abs(column[i] - (right[i] - left[i]) / (2 * h)));
              scale = std::max(scale, std::abs(column[i]));
            }
      }
    // The difference is right to h^2 and 1e-16 / h, 1e-10 and 1e-11.
    EXPECT_LT(worst, 1e-8 * scale);
  }

  void check_tangent(const std::vector<std::string> &overrides,
                     const TangentFactors           &factors)
  {
    const SceneText star = star_with_everything(1, 1);
    check_tangent_of(star, overrides, factors);
    check_tangent_of(star + yielding_struts("0, 3, 4"), overrides, factors);
  }
} // namespace

TEST(Equations, TangentOfEverythingIsTheDerivativeOfTheResidual)
{
  // Newmark's factors with beta = 1/4, gamma = 1/2 and a step of 0.4.
  check_tangent({}, {1., 5., 25.});
}

TEST(Equations, EveryFactorOfTheTangentStandsForItsOwnDerivative)
{
  check_tangent({}, {1., 0., 0.});
  check_tangent({}, {0., 1., 0.});
  check_tangent({}, {0., 0., 1.});
}

TEST(Equations, TangentInStaticsIsTheDerivativeOfTheResidual)
{
  check_tangent({"Time/Scheme=static"}, {1., 2.5, 0.});
}

TEST(Equations, TangentOfSmallDisplacementsIsTheDerivativeOfTheResidual)
{
  check_tangent({"Effects/Large rotation=off"}, {1., 5., 25.});
}

TEST(Equations, TangentHoldsForEveryOrder)
{
  for (const char *order : {"1", "3", "4", "5", "6"})
    {
      SCOPED_TRACE(order);
      check_tangent({std::string("Discretization/Order=") + order},
                    {1., 5., 25.});
    }
}

TEST(Equations, ScenesWithoutLargeRotationAreLinear)
{
  EXPECT_FALSE(
    EquationsOnRanks(star_with_everything(1, 1)).equations.is_linear());
  EXPECT_TRUE(
    EquationsOnRanks(star_with_everything(1, 1), {"Effects/Large rotation=off"})
      .equations.is_linear());
}

TEST(Equations, ResidualNormLeavesPrescribedRowsOut)
{
  Trial                    trial;
  const DofNumbering      &dofs    = trial.setup.dofs();
  const EvaluationResults &norm    = trial.setup.residual(trial.step());
  double                   sums[2] = {0, 0};
  for (unsigned int i = 0; i < dofs.layout().n_owned(); ++i)
    if (dofs.unknowns().kinds[i] != UnknownKind::prescribed)
      sums[dofs.unknowns().is_rotation[i]] +=
        trial.to.residual[i] * trial.to.residual[i];
  EXPECT_DOUBLE_EQ(norm.force, std::sqrt(sums[0]));
  EXPECT_DOUBLE_EQ(norm.moment, std::sqrt(sums[1]));
  EXPECT_GT(norm.force_scale, 0);
}

TEST(Equations, UnknownWithTheLargestResidualIsFree)
{
  Trial       trial;
  const auto &dofs = trial.setup.dofs();
  trial.to.residual.assign(trial.to.residual.size(), 0);
  const unsigned int joint = trial.setup.lattice.joint_sets.at("tips")[1];
  trial.to.residual[dofs.joint_unknown(joint, 1)] = -2;
  trial.to
    .residual[dofs.joint_unknown(trial.setup.lattice.joint_sets.at("bottom")[0],
                                 0)] = 5;
  EXPECT_EQ(unknown_with_largest_residual(trial.setup.model, trial.to),
            describe(dofs, dofs.joint_unknown(joint, 1)));
}

TEST(Equations, LengthScaleIsTheMeanStrutLength)
{
  // All struts of the star have length 1; the sum of 12 of them is rounded.
  EXPECT_NEAR(
    EquationsOnRanks(star_with_everything(1, 1)).model.mean_strut_length,
    1.,
    1e-14);
}

TEST(Equations, PrescribedMotionAndRightSideFollowTheSupports)
{
  EquationsOnRanks    setup(star_with_everything(1, 1), {}, MPI_COMM_SELF);
  const DofNumbering &dofs = setup.dofs();
  const int           shaken =
    dofs.joint_unknown(setup.lattice.joint_sets.at("left")[0], 0);
  const State before    = setup.equations.initial_state();
  State       state     = before;
  state.time            = 0.2;
  const Evaluation step = Evaluation::step(before, state, 0.01);
  Vector           right_side(dofs.layout().n_owned());
  state.displacement[shaken] = 0.001;
  state.residual.assign(state.residual.size(), 7);
  find_right_side(setup.model, step, right_side.data());
  const double position = 0.02 * std::sin(3 * 0.2);
  EXPECT_NEAR(right_side[shaken], position - 0.001, 1e-16);
  for (unsigned int i = 0; i < dofs.layout().n_owned(); ++i)
    if (int(i) != shaken)
      {
        EXPECT_EQ(right_side[i],
                  dofs.unknowns().kinds[i] == UnknownKind::prescribed ? 0.
                                                                      : -7.);
      }

  prescribe_motion(setup.model, step);
  EXPECT_DOUBLE_EQ(state.displacement[shaken], position);
  EXPECT_NEAR((*state.velocity)[shaken], 0.06 * std::cos(0.6), 1e-13);
  EXPECT_NEAR((*state.acceleration)[shaken], -9 * position, 1e-10);
}

namespace
{
  /** Number of values in records of @p layout whose names end with @p what. */
  unsigned int n_kept(const StateLayout &layout, const std::string &what)
  {
    unsigned int n = 0;
    for (const Record &record : layout.history.list())
      if (record.name.size() >= what.size() &&
          record.name.compare(record.name.size() - what.size(),
                              what.size(),
                              what) == 0)
        n += record.items.size() * record.values_per_item;
    return n;
  }
} // namespace

TEST(Equations, DisabledEffectsNeedNoState)
{
  const StateLayout whole =
    EquationsOnRanks(star_with_everything(2, 2), {}, MPI_COMM_SELF)
      .equations.layout();
  EXPECT_TRUE(whole.velocity);
  EXPECT_TRUE(whole.acceleration);
  EXPECT_FALSE(whole.algorithmic_acceleration);
  // Maxwell elements in 4 connectors across and 2 fixed ones, and at both
  // points of 2 relaxing struts, for each of three strains; dashpots in these
  // connectors, the 4 in the cells, and 2 anchors.
  EXPECT_EQ(n_kept(whole, ": internal variables"), 6u + 2 * 2 * 3);
  EXPECT_EQ(n_kept(whole, ": dissipated energy"), 12u);
  // A viscous strain, a strain and its rate; the energy lost by an element.
  EXPECT_EQ(whole.history.n_values(), 18u + 2 * (2 * 3 * 3 + 1));

  const StateLayout in_statics = EquationsOnRanks(star_with_everything(2, 2),
                                                  {"Time/Scheme=static"},
                                                  MPI_COMM_SELF)
                                   .equations.layout();
  EXPECT_TRUE(in_statics.velocity);
  EXPECT_FALSE(in_statics.acceleration);

  const EquationsOnRanks elastic(star_with_everything(2, 2),
                                 {"Time/Scheme=static",
                                  "Effects/Connector viscosity=off",
                                  "Effects/Strut damping=off",
                                  "Effects/Strut relaxation=off"},
                                 MPI_COMM_SELF);
  EXPECT_FALSE(elastic.equations.layout().velocity);
  EXPECT_EQ(elastic.equations.layout().history.n_values(), 0u);
  EXPECT_FALSE(elastic.equations.layout().energies.has(EnergyKind::dissipated));
  const State state = elastic.equations.initial_state();
  EXPECT_FALSE(state.velocity);
  EXPECT_FALSE(state.acceleration);
  EXPECT_FALSE(state.algorithmic_acceleration);
  EXPECT_FALSE(elastic.model.plan.simulated.inertia);
}

TEST(Equations, StatesCarryASecondAccelerationOnlyIfTheSchemeUsesIt)
{
  for (const auto &[scheme, uses_it] :
       std::map<std::string, bool>{{"newmark", false},
                                   {"generalized-alpha", true},
                                   {"static", false}})
    {
      SCOPED_TRACE(scheme);
      const EquationsOnRanks setup(star_with_everything(1, 1),
                                   {"Time/Scheme=" + scheme},
                                   MPI_COMM_SELF);
      EXPECT_EQ(setup.equations.layout().algorithmic_acceleration, uses_it);
      EXPECT_EQ(bool(setup.equations.initial_state().algorithmic_acceleration),
                uses_it);
    }
}

TEST(Equations, WithoutViscosityConnectorsAreTheirLongTimeSprings)
{
  EquationsOnRanks setup(star_with_everything(1, 1),
                         {"Effects/Connector viscosity=off"},
                         MPI_COMM_SELF);
  State            from = setup.equations.initial_state(), to = from;
  fill_by_position(setup.model, 0.2, to.displacement);
  fill_by_position(setup.model, 5., *to.velocity);
  const Evaluation step = Evaluation::step(from, to, 0.1);
  setup.residual(step);
  const double stiffness[4] = {0.6, 0, 0.2, 0.4};
  EXPECT_EQ(n_kept(setup.equations.layout(), ": dissipated energy"), 0u);
  ASSERT_EQ(setup.equations.reporting().connectors.size(), 4u);
  for (unsigned int g = 0; g < 4; ++g)
    {
      const ConnectorGroup &group = setup.equations.reporting().connectors[g];
      for (unsigned int i = 0; i < group.forces->n_reported(); ++i)
        {
          const ConnectorReport report = group.report(i, to, setup.results);
          EXPECT_NE(report.extension, 0);
          EXPECT_DOUBLE_EQ(report.force, stiffness[g] * report.extension);
        }
    }
}

namespace
{
  /** A trial state and the results of its evaluation. */
  struct EvaluatedTrial
  {
    /** Irregular motion proportional to @p size. */
    EvaluatedTrial(const EquationsOnRanks &setup, const double size)
      : setup(setup)
      , from(setup.equations.initial_state())
      , to(from)
      , results(setup.equations.make_results())
    {
      const LatticeModel &model = setup.model;
      from.time                 = 0.1;
      to.time                   = from.time + dt;
      fill_by_position(model, 0.1, from.displacement);
      fill_by_position(model, size, to.displacement);
      fill_by_position(model, 2 * size, *to.velocity);
      fill_by_position(model, 3 * size, *to.acceleration);
      for (unsigned int i = 0; i < from.history.size(); ++i)
        from.history[i] = 0.1 * std::sin(1. + i);
      NodeRotations(model.numbering).follow(evaluation());
    }

    Evaluation evaluation()
    {
      return setup.step(from, to, dt);
    }

    /** Evaluates; returns the residual and the norms. */
    std::vector<double> residual()
    {
      setup.equations.residual(evaluation(), results);
      std::vector<double> answer(to.residual.data(),
                                 to.residual.data() + to.residual.size());
      answer.insert(answer.end(), to.history.begin(), to.history.end());
      answer.insert(answer.end(),
                    {results.force,
                     results.moment,
                     results.constraint,
                     results.force_scale});
      return answer;
    }

    /** Entries of the tangent at the last residual. */
    std::vector<double> tangent()
    {
      TangentMatrix matrix(setup.equations.pattern());
      setup.equations.tangent(evaluation(), results, {1., 5., 25.}, matrix);
      const std::size_t   last = matrix.pattern().n_blocks() - 1;
      const double *const end  = matrix.values(last) +
        matrix.pattern().size(last) * matrix.pattern().size(last);
      return {matrix.values(0), end};
    }

    /** Energies by entry, and the history, as accept() leaves them. */
    std::vector<double> accepted()
    {
      setup.equations.accept(evaluation(), results);
      std::vector<double> answer = to.energies.amounts();
      answer.insert(answer.end(), to.history.begin(), to.history.end());
      return answer;
    }

    const EquationsOnRanks &setup;
    double                  dt = 0.3;
    State                   from, to;
    EvaluationResults       results;
  };
} // namespace

TEST(Equations, EvaluationsDoNotInfluenceEachOther)
{
  for (const std::string text :
       {star_with_everything(1, 1), space_star_with_everything()})
    {
      // Results of each trial alone.
      const EquationsOnRanks fresh(text, {}, MPI_COMM_SELF),
        other(text, {}, MPI_COMM_SELF), asked(text, {}, MPI_COMM_SELF);
      EvaluatedTrial first(fresh, 0.4), second(other, 0.25);
      const auto     residual       = first.residual(),
                 second_residual    = second.residual();
      const auto tangent            = first.tangent(),
                 tangent_of_second  = second.tangent();
      const auto accepted           = first.accepted(),
                 accepted_of_second = second.accepted();
      EXPECT_NE(residual, second_residual);
      EXPECT_NE(tangent, tangent_of_second);
      EXPECT_NE(accepted, accepted_of_second);

      // The same trials, interleaved.
      EvaluatedTrial a(asked, 0.4), b(asked, 0.25);
      EXPECT_EQ(a.residual(), residual);
      EXPECT_EQ(b.residual(), second_residual);
      EXPECT_EQ(a.tangent(), tangent);
      EXPECT_EQ(b.tangent(), tangent_of_second);
      EXPECT_EQ(a.accepted(), accepted);
      EXPECT_EQ(b.accepted(), accepted_of_second);
    }
}

TEST(Equations, RepeatedEvaluationsAgree)
{
  for (const std::string text :
       {star_with_everything(1, 1), space_star_with_everything()})
    {
      const EquationsOnRanks setup(text, {}, MPI_COMM_SELF);
      EvaluatedTrial         trial(setup, 0.4);
      const auto             residual = trial.residual();
      EXPECT_EQ(trial.residual(), residual);
      const auto tangent  = trial.tangent();
      const auto accepted = trial.accepted();
      EXPECT_EQ(trial.tangent(), tangent);
      EXPECT_EQ(trial.accepted(), accepted);
      EvaluatedTrial again(setup, 0.4);
      EXPECT_EQ(again.residual(), residual);
      EXPECT_EQ(again.tangent(), tangent);
      EXPECT_EQ(again.accepted(), accepted);
    }
}

TEST(Equations, LoadDerivativeIsTheDifferenceOfResiduals)
{
  // Dead loads alone in the plane, loads that follow their joints in space.
  for (const std::string text :
       {star_with_everything(1, 1), space_star_with_everything()})
    {
      const EquationsOnRanks setup(text, {}, MPI_COMM_SELF);
      EvaluatedTrial         trial(setup, 0.4);
      const Evaluation       evaluation = trial.evaluation();
      evaluation.to.path.emplace();
      const auto residual = [&](const double load_factor) {
        evaluation.to.path->load_factor = load_factor;
        setup.equations.residual(evaluation, trial.results);
        return trial.to.residual;
      };
      const double at = 0.3, step = 1e-4;
      const Vector more = residual(at + step), less = residual(at - step);
      evaluation.to.path->load_factor = at;
      const Vector derivative = setup.equations.load_derivative(evaluation);
      const double size       = largest_size(derivative);
      EXPECT_GT(size, 0.1);
      for (unsigned int i = 0; i < derivative.size(); ++i)
        EXPECT_NEAR(derivative[i],
                    (more[i] - less[i]) / (2 * step),
                    1e-7 * size + 1e-12 * largest_size(more) / step);
    }
}

namespace
{
  /** Joint 1, 2 m from a wall, pulled along a strut and a Maxwell connector. */
  const SceneText relaxing =
    frame_scene("0 0; 2 0", "0 1")
      .support("wall", "0", "clamp")
      .connector("one",
                 "maxwell",
                 "Spring stiffness = 2 | "
                 "Damping coefficient = 3 | Between = 0 1")
      .add("Loads/pull", "Joints = 1 | Force x = 7 * t");
} // namespace

TEST(Equations, AStageInsideAStepHasTheForcesOfItsOwnTime)
{
  const EquationsOnRanks setup(relaxing, {}, MPI_COMM_SELF),
    without(relaxing,
            {"Effects/Connector viscosity=off", "Loads/pull/Force x=0"},
            MPI_COMM_SELF);
  const int    tip  = setup.dofs().joint_unknown(1, 0);
  const State  from = setup.equations.initial_state();
  const double rate = 0.5, relaxation_time = 3. / 2;
  // One trial state serves all stages, as in a time stepper.
  State      to    = from;
  const auto force = [&](const double time) {
    // Stretched at a constant rate since the start of the step.
    to.time                   = time;
    to.displacement[tip]      = rate * time;
    (*to.velocity)[tip]       = rate;
    EvaluationResults results = setup.equations.make_results();
    setup.equations.residual(Evaluation::step(from, to, time), results);

    State       plain               = without.equations.initial_state();
    const State start               = plain;
    plain.displacement[tip]         = rate * time;
    (*plain.velocity)[tip]          = rate;
    EvaluationResults plain_results = without.equations.make_results();
    without.equations.residual(Evaluation::step(start, plain, time),
                               plain_results);
    // Connector force and load, without the strut.
    return to.residual[tip] - plain.residual[tip];
  };
  const auto expected = [&](const double time) {
    return 3 * rate * (1 - std::exp(-time / relaxation_time)) - 7 * time;
  };
  const double whole = force(0.8);
  for (const double time : {0.2, 0.4, 0.6})
    EXPECT_NEAR(force(time), expected(time), 1e-14);
  // The stages have no side effects.
  EXPECT_EQ(force(0.8), whole);
  EXPECT_NEAR(whole, expected(0.8), 1e-14);
}
